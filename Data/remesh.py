"""Even triangulation of a closed surface: splits, collapses, flips and relaxation, each on a set of places that do not
touch one another, so that all of them run as array operations.

Written here because VTK has no isotropic remesher. Meshes are closed and manifold; points n x 3, triangles m x 3.
"""
import numpy as np


class Edges:
    """Unique edges of a closed mesh: `ends` (a, b), `tips` (c, d) and `faces`, for the triangles (a, b, c), (b, a, d)."""

    def __init__(self, triangles, count):
        half = np.vstack([triangles[:, [0, 1, 2]], triangles[:, [1, 2, 0]], triangles[:, [2, 0, 1]]])
        face = np.tile(np.arange(len(triangles)), 3)
        self.count = count
        key = half[:, :2].min(axis=1) * count + half[:, :2].max(axis=1)
        order = np.argsort(key, kind="stable")
        self.keys = key[order][::2]
        if len(order) % 2 or not np.array_equal(self.keys, key[order][1::2]) or np.any(np.diff(self.keys) == 0):
            raise ValueError("the surface is not a closed manifold")
        first, second = order[::2], order[1::2]
        self.ends = half[first, :2]
        self.tips = np.column_stack([half[first, 2], half[second, 2]])
        self.faces = np.column_stack([face[first], face[second]])

    def valences(self):
        return np.bincount(self.ends.ravel(), minlength=self.count)

    def has(self, a, b):
        key = np.minimum(a, b) * self.count + np.maximum(a, b)
        place = np.minimum(np.searchsorted(self.keys, key), len(self.keys) - 1)
        return self.keys[place] == key


def normals_of(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return np.cross(b - a, c - a)


def unit(v):
    return v / np.maximum(np.linalg.norm(v, axis=-1, keepdims=True), 1e-30)


def minimum_angles(points, triangles):
    """The least angle of each triangle, in degrees."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    cosines = [np.einsum("ij,ij->i", unit(q - p), unit(r - p)) for p, q, r in ((a, b, c), (b, c, a), (c, a, b))]
    return np.degrees(np.arccos(np.clip(np.max(cosines, axis=0), -1.0, 1.0)))


def ranks(quality):
    """0 for the least, each value once."""
    rank = np.empty(len(quality), np.int64)
    rank[np.argsort(quality, kind="stable")] = np.arange(len(quality))
    return rank


def split_long(points, triangles, target, longest=4.0 / 3.0):
    while True:
        edges = Edges(triangles, len(points))
        a, b = edges.ends.T
        ratio = np.linalg.norm(points[a] - points[b], axis=1) / target(0.5 * (points[a] + points[b]))
        rank = np.where(ratio > longest, ranks(ratio), -1)
        best = np.full(len(triangles), -1)
        for side in (0, 1):
            np.maximum.at(best, edges.faces[:, side], rank)
        chosen = np.flatnonzero((rank >= 0) & (best[edges.faces[:, 0]] == rank) & (best[edges.faces[:, 1]] == rank))
        if not len(chosen):
            return points, triangles
        a, b = edges.ends[chosen].T
        c, d = edges.tips[chosen].T
        middle = len(points) + np.arange(len(chosen))
        points = np.vstack([points, 0.5 * (points[a] + points[b])])
        kept = np.ones(len(triangles), bool)
        kept[edges.faces[chosen].ravel()] = False
        triangles = np.vstack([triangles[kept]] + [np.column_stack(t) for t in (
            (a, middle, c), (middle, b, c), (b, middle, d), (middle, a, d))])


def collapse_short(points, triangles, target, shortest=0.8, longest=4.0 / 3.0):
    refused = set()
    for _ in range(200):
        edges = Edges(triangles, len(points))
        a, b = edges.ends.T
        ratio = np.linalg.norm(points[a] - points[b], axis=1) / target(0.5 * (points[a] + points[b]))
        candidate = ratio < shortest
        if refused:
            candidate &= ~np.isin(edges.keys, np.fromiter(refused, np.int64))
        if not candidate.any():
            break
        none = len(a)
        rank = np.where(candidate, ranks(ratio), none)
        ring = np.full(len(points), none)
        np.minimum.at(ring, a, rank)
        np.minimum.at(ring, b, rank)
        wide = ring.copy()
        np.minimum.at(wide, a, ring[b])
        np.minimum.at(wide, b, ring[a])
        chosen = np.flatnonzero(candidate & (wide[a] == rank) & (wide[b] == rank))
        # The ends may share only the two tips, and no tip may be left with fewer than four neighbours.
        valence = edges.valences()
        start = np.concatenate([[0], np.cumsum(valence)])
        both = np.concatenate([edges.ends, edges.ends[:, ::-1]])
        neighbour = both[np.argsort(both[:, 0], kind="stable"), 1]
        ca, cb = a[chosen], b[chosen]
        owner = np.repeat(np.arange(len(chosen)), valence[ca])
        place = np.arange(len(owner)) - np.repeat(np.cumsum(valence[ca]) - valence[ca], valence[ca]) + start[ca][owner]
        shared = np.bincount(owner, edges.has(neighbour[place], cb[owner]), len(chosen))
        good = (shared == 2) & (valence[edges.tips[chosen]].min(axis=1) > 4)
        # No triangle may turn over or become long.
        becomes = np.arange(len(points))
        becomes[cb] = ca
        moved = points.copy()
        moved[ca] = 0.5 * (points[ca] + points[cb])
        touched = np.full(len(points), -1)
        touched[ca] = touched[cb] = np.arange(len(chosen))
        after = becomes[triangles]
        alive = (after[:, 0] != after[:, 1]) & (after[:, 1] != after[:, 2]) & (after[:, 2] != after[:, 0])
        near = np.flatnonzero(alive & (touched[triangles].max(axis=1) >= 0))
        turned = np.einsum("ij,ij->i", unit(normals_of(points, triangles[near])),
                           unit(normals_of(moved, after[near]))) < 0.5
        corner = moved[after[near]]
        span = np.max([np.linalg.norm(corner[:, i] - corner[:, i - 1], axis=1) for i in range(3)], axis=0)
        turned |= span > longest * target(corner.mean(axis=1))
        good[touched[triangles[near[turned]]].max(axis=1)] = False
        refused.update(edges.keys[chosen[~good]].tolist())
        ca, cb = ca[good], cb[good]
        if len(ca):
            refused = set()
            points[ca] = 0.5 * (points[ca] + points[cb])
            becomes = np.arange(len(points))
            becomes[cb] = ca
            triangles = becomes[triangles]
            alive = (triangles[:, 0] != triangles[:, 1]) & (triangles[:, 1] != triangles[:, 2]) & (
                triangles[:, 2] != triangles[:, 0])
            triangles = triangles[alive]
            used = np.zeros(len(points), bool)
            used[triangles] = True
            renumber = np.cumsum(used) - 1
            points, triangles = points[used], renumber[triangles]
    return points, triangles


def flip(points, triangles, by_valence, passes=20, held=None):
    """Flips edges towards valence six, or, if not `by_valence`, towards larger least angles; none of the triangles `held`,
    nor so that two of their corners are joined."""
    rim = np.zeros(len(points), bool)
    if held is not None:
        rim[triangles[held]] = True
    for _ in range(passes):
        edges = Edges(triangles, len(points))
        a, b = edges.ends.T
        c, d = edges.tips.T
        valence = edges.valences()
        new = [np.column_stack([c, a, d]), np.column_stack([d, b, c])]
        n = [unit(normals_of(points, t)) for t in new]
        n0, n1 = (unit(normals_of(points, triangles[edges.faces[:, i]])) for i in (0, 1))
        flat = np.min([np.einsum("ij,ij->i", x, y) for x in n for y in (n0, n1)], axis=0) > 0.7
        allowed = flat & ~edges.has(c, d) & (valence[a] > 4) & (valence[b] > 4)
        if held is not None:
            allowed &= ~held[edges.faces].any(axis=1) & ~(rim[c] & rim[d])
        before = np.minimum(*[minimum_angles(points, triangles[edges.faces[:, i]]) for i in (0, 1)])
        after = np.minimum(*[minimum_angles(points, t) for t in new])
        if by_valence:
            off = valence - 6
            gain = (off[a] ** 2 + off[b] ** 2 + off[c] ** 2 + off[d] ** 2 - (off[a] - 1) ** 2 - (off[b] - 1) ** 2 -
                    (off[c] + 1) ** 2 - (off[d] + 1) ** 2).astype(float)
            allowed &= after > np.minimum(before, 20.0)
        else:
            gain = after - before - 0.5
        candidate = allowed & (gain > 0)
        if not candidate.any():
            break
        rank = np.where(candidate, ranks(-gain), len(a))
        least = np.full(len(points), len(a))
        for v in (a, b, c, d):
            np.minimum.at(least, v, rank)
        chosen = np.flatnonzero(candidate & np.all([least[v] == rank for v in (a, b, c, d)], axis=0))
        triangles = triangles.copy()
        triangles[edges.faces[chosen, 0]] = new[0][chosen]
        triangles[edges.faces[chosen, 1]] = new[1][chosen]
    return triangles


def relax(points, triangles, target, amount=0.7):
    """Moves each point, in its tangent plane, towards the mean of its triangles' centroids, weighted by relative area."""
    cross = normals_of(points, triangles)
    centroid = points[triangles].mean(axis=1)
    weight = np.linalg.norm(cross, axis=1) / target(centroid) ** 2
    total, sums, normal = np.zeros(len(points)), np.zeros_like(points), np.zeros_like(points)
    for i in range(3):
        total += np.bincount(triangles[:, i], weight, len(points))
        for axis in range(3):
            sums[:, axis] += np.bincount(triangles[:, i], weight * centroid[:, axis], len(points))
            normal[:, axis] += np.bincount(triangles[:, i], cross[:, axis], len(points))
    normal = unit(normal)
    move = sums / total[:, None] - points
    move -= np.einsum("ij,ij->i", move, normal)[:, None] * normal
    return points + amount * move


def target_of(edge, finer):
    return (lambda p: np.full(len(p), edge)) if finer is None else (lambda p: edge * finer(p))


def even(field, edge, finer=None, rounds=6):
    """The field's zero surface as an even mesh of the given edge length; finer(points) scales that length locally."""
    target = target_of(edge, finer)
    points, triangles = field.polygonise(0.8 * edge)
    points = field.project(points, 3, edge)
    for _ in range(rounds):
        points, triangles = split_long(points, triangles, target)
        points, triangles = collapse_short(points, triangles, target)
        triangles = flip(points, triangles, by_valence=True)
        for _ in range(3):
            points = field.project(relax(points, triangles, target), 1, edge)
    for _ in range(8):
        triangles = flip(points, triangles, by_valence=False)
        points = field.project(relax(points, triangles, target), 1, edge)
    points = field.project(points, 3, edge)
    return points, flip(points, triangles, by_valence=False)


def half(points, triangles, snap):
    """The part with x >= 0, cut at x = 0, where points nearer to that plane than `snap` are moved to it."""
    points = np.where(np.abs(points[:, :1]) < snap, points * [0.0, 1.0, 1.0], points)
    side = np.sign(points[:, 0]).astype(int)
    kept, cuts, made = [], {}, list(points)
    for triangle in triangles.tolist():
        if max(side[v] for v in triangle) <= 0:
            continue
        corners = []
        for a, b in zip(triangle, triangle[1:] + triangle[:1]):
            if side[a] >= 0:
                corners.append(a)
            if side[a] * side[b] < 0:
                key = min(a, b), max(a, b)
                if key not in cuts:
                    cuts[key] = len(made)
                    middle = points[a] + points[a, 0] / (points[a, 0] - points[b, 0]) * (points[b] - points[a])
                    made.append(middle * [0.0, 1.0, 1.0])
                corners.append(cuts[key])
        kept += [(corners[0], corners[k], corners[k + 1]) for k in range(1, len(corners) - 1)]
    used, kept = np.unique(kept, return_inverse=True)
    return np.array(made)[used], kept.reshape(-1, 3)


def both_halves(points, triangles):
    """The whole that a half and its reflection make; first the half as it is."""
    aside = points[:, 0] > 0.0
    other = np.arange(len(points))
    other[aside] = len(points) + np.arange(aside.sum())
    return np.vstack([points, points[aside] * [-1.0, 1.0, 1.0]]), np.vstack([triangles, other[triangles][:, ::-1]])


def symmetric(field, edge, finer=None, rounds=12):
    """As even, for a field symmetric about x = 0: points and triangles are, too, to the bit."""
    target = target_of(edge, finer)
    points, triangles = half(*even(field, edge, finer), 0.3 * edge)
    count = len(points)
    for i in range(rounds + 1):
        whole = both_halves(points, triangles)
        held = np.arange(len(whole[1])) >= len(triangles)
        triangles = flip(*whole, by_valence=False, held=held)[:len(triangles)]
        if i < rounds:
            whole = both_halves(points, triangles)
            moved = field.project(relax(*whole, target), 1 if i < rounds - 1 else 3, edge)[:count]
            points = np.where(points[:, :1] == 0.0, moved * [0.0, 1.0, 1.0], moved)
    return both_halves(points, triangles)
