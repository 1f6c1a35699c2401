"""A valley, made by rain: land that rises while its rivers cut into it and its slopes creep.

Each node drains to the lowest of its eight neighbours; a river wears its bed down by its water and slope, dz/dt = -K sqrt(A) S, solved
implicitly from the mouth upward; slopes creep by diffusion. Land without a way out is filled first. Needs only numpy; deterministic.
"""
import functools
import heapq

import numpy as np

SIDE = 193  # samples along x and along y, one unit apart
PEAK = 52.0  # height of the highest sample [units]
AROUND = [(dx, dy, float(np.hypot(dx, dy))) for dy in (-1, 0, 1) for dx in (-1, 0, 1) if dx or dy]


def mouth(side):
    """Where water leaves: the middle of the southern edge (row 0), [first, last) of its nodes."""
    return int(0.44 * side), int(0.53 * side) + 1


def drained(z, random):
    """Fills what has no way out; nodes from the mouth upward, and for each the node that it drains to and how far that is. Of the eight
    ways down the steepest is taken by and large: by rule alone all water would run along the grid."""
    side = len(z)
    level, down, away = z.copy(), np.full(side * side, -1), np.ones(side * side)
    seen, order = np.zeros(side * side, bool), []
    first, last = mouth(side)
    queue = [(level[0, i], i) for i in range(first, last)]
    seen[first:last] = True
    heapq.heapify(queue)
    flat = level.ravel()
    while queue:
        height, node = heapq.heappop(queue)
        order.append(node)
        y, x = divmod(node, side)
        for dx, dy, _ in AROUND:
            if 0 <= x + dx < side and 0 <= y + dy < side:
                other = node + dy * side + dx
                if not seen[other]:
                    seen[other] = True
                    flat[other] = max(flat[other], height + 1e-4)
                    down[other] = node
                    heapq.heappush(queue, (flat[other], other))
    padded = np.pad(level, 1, constant_values=np.inf)
    steepest = np.zeros((side, side))
    for dx, dy, length in AROUND:
        slope = (level - padded[1 + dy:side + 1 + dy, 1 + dx:side + 1 + dx]) / length * (0.6 + random.rand(side, side))
        better = (slope > steepest).ravel() & (down >= 0)
        steepest = np.where(better.reshape(side, side), slope, steepest)
        down[better] = np.flatnonzero(better) + dy * side + dx
        away[better] = length
    order = np.argsort(flat, kind="stable")
    return level, order, down, away


def rained(z, rise, years, step, wear, creep, random):
    """Land after so many steps of rising, rain and creep; one node is `step` units wide."""
    side = len(z)
    first, last = mouth(side)
    for _ in range(years):
        z = z + rise
        z[0, first:last] = 0.0
        level, order, down, away = drained(z, random)
        water = np.full(side * side, step * step)
        for node in order[::-1].tolist():
            if down[node] >= 0:
                water[down[node]] += water[node]
        bed = level.ravel()
        factor = (wear * np.sqrt(water) / (away * step)).tolist()
        height, lower = bed.tolist(), down.tolist()
        for node in order.tolist():
            if lower[node] >= 0:
                height[node] = (height[node] + factor[node] * height[lower[node]]) / (1.0 + factor[node])
        z = np.array(height).reshape(side, side)
        p = np.pad(z, 1, mode="edge")
        z = z + creep / step ** 2 * (p[2:, 1:-1] + p[:-2, 1:-1] + p[1:-1, 2:] + p[1:-1, :-2] - 4.0 * z)
    return z


def finer(z):
    """Twice as many samples: the old ones and those between."""
    z = np.insert(z, np.arange(1, len(z)), 0.5 * (z[1:] + z[:-1]), axis=0)
    return np.insert(z, np.arange(1, z.shape[1]), 0.5 * (z[:, 1:] + z[:, :-1]), axis=1)


def floored(z, water=1500, deep=4.0, reach=14.0):
    """Land with gravel in its larger valleys, those of so much water: `deep` over the river's bed; and soft as after a last creep."""
    side = len(z)
    _, order, down, _ = drained(z, np.random.RandomState(0))
    flow = np.ones(side * side)
    for node in order[::-1].tolist():
        if down[node] >= 0:
            flow[down[node]] += flow[node]
    bed = np.flatnonzero(flow > water)
    y, x = np.divmod(np.arange(side * side), side)
    away, floor = np.full(side * side, np.inf), np.zeros(side * side)
    for node in bed:
        length = np.hypot(x - x[node], y - y[node])
        nearer = length < away
        away[nearer], floor[nearer] = length[nearer], z.ravel()[node]
    filled = np.maximum(z, np.where(away < reach, floor + deep - 0.15 * away, -1.0).reshape(side, side))
    for _ in range(16):
        p = np.pad(filled, 1, mode="edge")
        filled = filled + 0.2 * (p[2:, 1:-1] + p[:-2, 1:-1] + p[1:-1, 2:] + p[1:-1, :-2] - 4.0 * filled)
    return filled


@functools.lru_cache(None)
def valley():
    """Heights [units], SIDE x SIDE, the first row in the south: a river's whole land, its mouth in the middle of the southern edge."""
    side = (SIDE - 1) // 4 + 1
    random = np.random.RandomState(5)
    z = 2.0 * random.rand(side, side)
    for step, years in ((4.0, 70), (2.0, 40), (1.0, 25)):
        y, x = np.mgrid[0:1:side * 1j, 0:1:side * 1j]
        out = np.hypot(1.15 * (x - 0.5), 0.75 * (y - 0.1)) / 0.7
        rise = 0.30 + 0.60 * np.clip(out, 0.0, 1.0) ** 2 + 0.16 * np.sin(9.0 * x + 3.0 * np.sin(5.0 * y)) * np.cos(8.0 * y - 2.0 * x)
        z = rained(z, rise, years, step, 0.045, 0.10 * step, random)
        if step > 1.0:
            z = finer(z) + 0.05 * random.rand(2 * side - 1, 2 * side - 1)
            side = 2 * side - 1
    z = floored(z)
    return z * (PEAK / z.max())


def way_down(z, start):
    """Where water runs from a place (x, y) to the mouth."""
    _, _, down, _ = drained(z, np.random.RandomState(0))
    node, way = start[1] * len(z) + start[0], []
    while node >= 0:
        way.append((node % len(z), node // len(z)))
        node = down[node]
    return np.array(way, float)
