"""A saved 4-8 mesh, read from its file, and the forest of splits that its arrays encode, rebuilt without Oversketch: in numpy,
one generation at a time."""
from typing import List, NamedTuple

import numpy as np

from saved import Saved, by_content


class Rebuilt(NamedTuple):
    base: np.ndarray  # (roots, 3): the base's triangles, by root
    parents: np.ndarray  # per point the ends of the edge that it halved, -1 for one of the base
    wrong: List[str]  # what is no sound 4-8 mesh


@by_content
def undirected(triangles):
    """(ends of each edge, faces on it, per face corner k the edge from k to k + 1)."""
    pairs = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    low, high = pairs.min(1), pairs.max(1)
    key = low * (int(triangles.max()) + 1) + high
    _, first, inverse, count = np.unique(key, return_index=True, return_inverse=True, return_counts=True)
    return np.c_[low[first], high[first]], count, inverse.reshape(-1, 3)


@by_content
def topology(triangles):
    """(Euler characteristic, border loops, edges that are not those of an oriented manifold)."""
    pairs = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    size = int(triangles.max()) + 1
    directed = pairs[:, 0] * size + pairs[:, 1]
    twice = len(directed) - len(np.unique(directed))
    edges, count, _ = undirected(triangles)
    border = directed[~np.isin(directed, pairs[:, 1] * size + pairs[:, 0])]
    following = dict(zip((border // size).tolist(), (border % size).tolist()))
    loops = 0
    while following:
        loops += 1
        at = following.pop(next(iter(following)))
        while at in following:
            at = following.pop(at)
    return len(np.unique(triangles)) - len(edges) + len(triangles), loops, int(twice + (count > 2).sum())


def rebuild(mesh: Saved) -> Rebuilt:
    """Joins siblings, the deepest first, until only roots remain."""
    return joined(mesh.triangles, mesh.cell["StellarRoot"].astype(np.int64), mesh.cell["StellarPath"].astype(np.uint64),
                  mesh.cell["StellarGen"].astype(int), len(mesh.points))


@by_content
def joined(triangles, root, path, gen, count) -> Rebuilt:
    wrong: List[str] = []
    corners, generation = triangles, gen
    parents, level = np.full((count, 2), -1), np.zeros(count, int)
    depth = np.frexp(path.astype(float))[1] - 1
    for d in range(int(depth.max(initial=0)), 0, -1):
        here = np.flatnonzero(depth == d)
        here = here[np.lexsort((path[here], root[here]))]
        first, second = here[0::2], here[1::2]
        if len(here) % 2 or (path[first] % 2 != 0).any() or (path[second] != path[first] + np.uint64(1)).any() \
                or (root[first] != root[second]).any():
            return Rebuilt(np.empty((0, 3), int), parents, ["a piece has no sibling"])
        m, p, a = corners[first].T
        n, c, q = corners[second].T
        if (m != n).any() or (p != q).any() or (gen[first] != gen[second]).any():
            wrong.append("two siblings do not join")
        ends = np.sort(np.c_[a, c], axis=1)
        known = parents[m, 0] >= 0
        if (parents[m][known] != ends[known]).any() or (level[m][known] != gen[first][known]).any():
            wrong.append("a point halves two edges")
        parents[m], level[m] = ends, gen[first]
        if (parents[m] != ends).any() or (level[m] != gen[first]).any():
            wrong.append("a point halves two edges")
        stay = depth != d
        corners = np.vstack([corners[stay], np.c_[p, a, c]])
        root, path = np.r_[root[stay], root[first]], np.r_[path[stay], path[first] >> np.uint64(1)]
        gen, depth = np.r_[gen[stay], gen[first] - 1], np.r_[depth[stay], np.full(len(first), d - 1)]
    order = np.argsort(root, kind="stable")
    if (root[order] != np.arange(len(root))).any() or (gen > 1).any() or (gen < 0).any():
        wrong.append("the roots are not those of a base")
    level[corners[gen == 1, 0]] = 1  # centres of triangles that stayed alone
    wrong += generations(triangles, generation, level)
    return Rebuilt(corners[order], parents, wrong)


def generations(triangles, gen, level) -> List[str]:
    """Each face has one newest vertex, the first, of its own generation; neighbours differ by one at most."""
    wrong = []
    levels = level[triangles]
    newest = (levels[:, 0] == gen) & (levels[:, 1:].max(1) < gen)
    if not newest[gen > 0].all() or (levels[gen == 0] != 0).any():
        wrong.append("a face's first vertex is not its newest")
    _, count, edge = undirected(triangles)
    order = np.argsort(edge.ravel(), kind="stable")
    start = (np.cumsum(count) - count)[count == 2]
    if (np.abs(gen[order[start] // 3] - gen[order[start + 1] // 3]) > 1).any():
        wrong.append("neighbours are over a generation apart")
    return wrong
