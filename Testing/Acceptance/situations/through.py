"""How many edges of a triangle mesh pass through its faces."""
import numpy as np

MOST = 4_000_000  # pairs that are tested at once


def crossing_edges(points, triangles, changed):
    """The edges that pass through a face they share no corner with, one of both changed; each counts once."""
    used = np.unique(triangles[changed])
    if not len(used):
        return 0
    low, high = points[used].min(0), points[used].max(0)
    corner = points[triangles]
    near = ((corner.max(1) >= low) & (corner.min(1) <= high)).all(1)
    faces, fresh = triangles[near], changed[near]
    ends = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    ends.sort(axis=1)
    edges, first = np.unique(ends, axis=0, return_inverse=True)
    fresh_edge = np.zeros(len(edges), bool)
    np.logical_or.at(fresh_edge, first.ravel(), np.repeat(fresh, 3))
    hit = np.zeros(len(edges), bool)
    for e, f in pairs_of(points[edges].min(1), points[edges].max(1), points[faces].min(1), points[faces].max(1)):
        keep = (fresh_edge[e] | fresh[f]) & (edges[e][:, :, None] != faces[f][:, None, :]).all((1, 2))
        e, f = e[keep], f[keep]
        hit[e[passes(points[edges[e, 0]], points[edges[e, 1]], points[faces[f]])]] = True
    return int(hit.sum())


def pairs_of(low, high, other_low, other_high):
    """Pairs of boxes that overlap, in parts, by a grid as wide as most of the boxes."""
    cell = max(float(np.percentile(np.maximum((high - low).max(1).mean(), (other_high - other_low).max(1)), 90)), 1e-12)
    origin = np.minimum(low.min(0), other_low.min(0))
    keys = [cells_of(a, b, origin, cell) for a, b in ((low, high), (other_low, other_high))]
    (key, item), (other_key, other) = keys
    order, other_order = np.argsort(key, kind="stable"), np.argsort(other_key, kind="stable")
    key, item, other_key, other = key[order], item[order], other_key[other_order], other[other_order]
    begin, end = np.searchsorted(other_key, key, "left"), np.searchsorted(other_key, key, "right")
    count = end - begin
    start = 0
    total = np.cumsum(count)
    while start < len(key):
        stop = max(start + 1, int(np.searchsorted(total, (total[start - 1] if start else 0) + MOST)))
        n = count[start:stop]
        one = np.repeat(item[start:stop], n)
        two = other[np.repeat(begin[start:stop] - np.cumsum(n) + n, n) + np.arange(n.sum())]
        meet = (low[one] <= other_high[two]).all(1) & (other_low[two] <= high[one]).all(1)
        yield one[meet], two[meet]
        start = stop


def cells_of(low, high, origin, cell):
    """The grid cells that boxes reach into: a key and the box's number, for each."""
    a, b = (np.floor((x - origin) / cell).astype(np.int64) for x in (low, high))
    size = b - a + 1
    count = size.prod(1)
    item = np.repeat(np.arange(len(a)), count)
    k = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    s = size[item]
    place = a[item] + np.c_[k % s[:, 0], k // s[:, 0] % s[:, 1], k // (s[:, 0] * s[:, 1])]
    return (place[:, 0] * 1_000_003 + place[:, 1]) * 1_000_003 + place[:, 2], item


def passes(p, q, triangle):
    """Whether segments pass through triangles."""
    a, b, c = triangle[:, 0], triangle[:, 1], triangle[:, 2]
    volume = lambda x, y, z, w: np.einsum("ij,ij->i", np.cross(y - x, z - x), w - x)
    above, below = volume(a, b, c, p), volume(a, b, c, q)
    sides = [volume(p, q, *pair) for pair in ((a, b), (b, c), (c, a))]
    return (above * below < 0) & ((np.sign(sides[0]) == np.sign(sides[1])) & (np.sign(sides[1]) == np.sign(sides[2]))) & (sides[0] != 0)
