"""Lengths, angles and distances between meshes and curves, in numpy, near the curves alone."""
from typing import NamedTuple

import numpy as np

from saved import by_content


class Pieces(NamedTuple):
    """Curves cut into straight pieces no longer than a step."""

    start: np.ndarray
    along: np.ndarray
    arc: np.ndarray  # arc length at the start
    curve: np.ndarray
    total: np.ndarray  # per curve its length
    closed: np.ndarray  # per curve


def pieces(points, lines, step) -> Pieces:
    start, along, arc, curve, total, closed = [], [], [], [], [], []
    for number, ids in enumerate(lines):
        p = points[ids]
        d = np.diff(p, axis=0)
        length = np.linalg.norm(d, axis=1)
        s = np.r_[0.0, np.cumsum(length)]
        cuts = np.maximum(1, np.ceil(length / step)).astype(int)
        of = np.repeat(np.arange(len(d)), cuts)
        k = np.arange(len(of)) - np.repeat(np.cumsum(cuts) - cuts, cuts)
        share = k / cuts[of]
        start.append(p[of] + d[of] * share[:, None])
        along.append(d[of] / cuts[of, None])
        arc.append(s[of] + length[of] * share)
        curve.append(np.full(len(of), number))
        total.append(s[-1])
        closed.append(len(ids) > 2 and ids[0] == ids[-1])
    return Pieces(np.vstack(start), np.vstack(along), np.concatenate(arc), np.concatenate(curve), np.array(total), np.array(closed))


def near_pairs(a, b, reach):
    """Every (i, j) with a[i] and b[j] no farther apart than reach."""
    inside = np.flatnonzero(((a >= b.min(0) - reach) & (a <= b.max(0) + reach)).all(1))
    if not len(inside):
        return inside, inside
    low = b.min(0) - 2 * reach
    cell_a, cell_b = (((p - low) / reach).astype(np.int64) for p in (a[inside], b))
    size = np.maximum(cell_a.max(0), cell_b.max(0)) + 2
    key = lambda c: (c[:, 0] * size[1] + c[:, 1]) * size[2] + c[:, 2]
    order = np.argsort(key(cell_b), kind="stable")
    sorted_b = key(cell_b)[order]
    first, second = [], []
    # The cells of a column of three stand in a row.
    for dx in (-1, 0, 1):
        for dy in (-1, 0, 1):
            k = key(cell_a + (dx, dy, 0))
            begin, end = np.searchsorted(sorted_b, k - 1, "left"), np.searchsorted(sorted_b, k + 1, "right")
            number = end - begin
            i = np.repeat(np.arange(len(inside)), number)
            j = order[np.arange(len(i)) - np.repeat(np.cumsum(number) - number, number) + begin[i]]
            near = ((a[inside[i]] - b[j]) ** 2).sum(1) <= reach ** 2
            first.append(inside[i[near]])
            second.append(j[near])
    return np.concatenate(first), np.concatenate(second)


def least(owner, value, count):
    """Per owner the number of its entry with the least value, -1 where it has none."""
    order = np.lexsort((value, owner))
    heads = order[np.r_[True, np.diff(owner[order]) != 0]] if len(order) else order
    best = np.full(count, -1)
    best[owner[heads]] = heads
    return best


def distance(points, curves: Pieces, reach):
    """Distance of each point to the curves, inf beyond reach."""
    return to_pieces(points, curves.start, curves.along, reach)


@by_content
def to_pieces(points, start, along, reach):
    longest = np.sqrt((along ** 2).sum(1).max())
    i, j = near_pairs(points, start + 0.5 * along, reach + 0.5 * longest)
    gap = points[i] - start[j]
    square = np.maximum((along[j] ** 2).sum(1), 1e-300)
    t = np.clip((gap * along[j]).sum(1) / square, 0, 1)
    result = np.full(len(points), np.inf)
    np.minimum.at(result, i, np.linalg.norm(gap - t[:, None] * along[j], axis=1))
    result[result > reach] = np.inf
    return result


def even(curves: Pieces, step, margin):
    """Places on the curves at every step of arc length, without a margin at the ends of open ones, and their directions."""
    places, directions = [], []
    for number, total in enumerate(curves.total):
        cut = 0.0 if curves.closed[number] else margin
        if total <= 2 * cut:
            continue
        at = np.arange(cut, total - cut, step)
        own = np.flatnonzero(curves.curve == number)
        piece = own[np.searchsorted(curves.arc[own], at, "right") - 1]
        length = np.linalg.norm(curves.along[piece], axis=1)
        direction = curves.along[piece] / np.maximum(length, 1e-300)[:, None]
        places.append(curves.start[piece] + direction * (at - curves.arc[piece])[:, None])
        directions.append(direction)
    none = np.empty((0, 3))
    return np.vstack(places or [none]), np.vstack(directions or [none])


def on_triangles(points, a, b, c):
    """(weights of the corners, squared distance) of the place of each triangle nearest to each point."""
    ab, ac, ap = b - a, c - a, points - a
    d00, d01, d11 = (ab * ab).sum(1), (ab * ac).sum(1), (ac * ac).sum(1)
    d20, d21 = (ap * ab).sum(1), (ap * ac).sum(1)
    whole = d00 * d11 - d01 * d01
    safe = np.where(whole > 0, whole, 1.0)
    v, w = (d11 * d20 - d01 * d21) / safe, (d00 * d21 - d01 * d20) / safe
    weights = np.c_[1 - v - w, v, w]
    inside = (whole > 0) & (weights >= 0).all(1)
    square = np.where(inside, ((points - a - v[:, None] * ab - w[:, None] * ac) ** 2).sum(1), np.inf)
    for p, q, i, j in ((a, b, 0, 1), (b, c, 1, 2), (c, a, 2, 0)):
        d = q - p
        t = np.clip(((points - p) * d).sum(1) / np.maximum((d * d).sum(1), 1e-300), 0, 1)
        away = ((points - p - t[:, None] * d) ** 2).sum(1)
        better = away < square
        square[better] = away[better]
        weights[better] = 0.0
        weights[better, i], weights[better, j] = 1 - t[better], t[better]
    return weights, square


def normals(points, triangles):
    """Of each triangle, twice its area long."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.cross(b - a, c - a)


@by_content
def angles(points, triangles):
    """The three angles of each triangle [degrees]; 0 at a side without length."""
    corner = points[triangles]
    out = []
    for k in range(3):
        u, v = corner[:, (k + 1) % 3] - corner[:, k], corner[:, (k + 2) % 3] - corner[:, k]
        out.append(np.degrees(np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(1))))
    out = np.array(out).T
    side = np.linalg.norm(np.roll(corner, -1, axis=1) - corner, axis=2)
    out[(side == 0).any(1)] = 0.0
    return out


def dihedral(points, triangles, edge, count, wanted):
    """Degrees between the two faces at each wanted edge of exactly two."""
    order = np.argsort(edge.ravel(), kind="stable")
    start = np.cumsum(count) - count
    chosen = np.flatnonzero(wanted & (count == 2))
    n = normals(points, triangles)
    p, q = n[order[start[chosen]] // 3], n[order[start[chosen] + 1] // 3]
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(p, q), axis=1), (p * q).sum(1)))
