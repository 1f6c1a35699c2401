"""What a line and a ring of edges enclose on a mesh, how far from both its vertices are, the plain map of it onto a disc, and where a
plane cuts it: in numpy, without Oversketch."""
import heapq
from typing import NamedTuple

import numpy as np

import measure
import meshes


class Linked:
    """Triangles, their edges, and of each triangle the one beyond its edge from corner k to k + 1, -1 where there is none."""

    def __init__(self, triangles):
        self.triangles = triangles
        self.edges, self.count, self.edge = meshes.edges_of(triangles)
        self.size = int(triangles.max()) + 1
        order = np.argsort(self.edge.ravel(), kind="stable")
        start = (np.cumsum(self.count) - self.count)[self.count == 2]
        one, other = order[start], order[start + 1]
        beyond = np.full(self.edge.size, -1)
        beyond[one], beyond[other] = other // 3, one // 3
        self.beyond = beyond.reshape(-1, 3)

    def between(self, chain):
        """The edges along a chain of vertices, -1 where two have none."""
        ends = np.sort(np.c_[chain[:-1], chain[1:]], axis=1)
        wanted, known = ends[:, 0] * self.size + ends[:, 1], self.edges[:, 0] * self.size + self.edges[:, 1]
        at = np.minimum(np.searchsorted(known, wanted), len(known) - 1)
        return np.where(known[at] == wanted, at, -1)


class Patch(NamedTuple):
    inside: np.ndarray  # per triangle of the mesh
    interior: np.ndarray  # vertices strictly inside
    faces: np.ndarray  # the triangles inside, with vertices of the mesh
    vertices: np.ndarray  # their vertices, those of the ring too
    local: np.ndarray  # faces, by places in vertices


def enclosed(linked, line, ring):
    """What can be reached from the middle of the line without a step over the ring."""
    barred = np.zeros(len(linked.edges), bool)
    barred[linked.between(ring)] = True
    middle = linked.between(line[len(line) // 2 - 1:len(line) // 2 + 1])[0]
    inside = np.zeros(len(linked.triangles), bool)
    new = np.flatnonzero((linked.edge == middle).any(1))
    while len(new):
        inside[new] = True
        over = linked.beyond[new][~barred[linked.edge[new]]]
        new = np.unique(over[over >= 0])
        new = new[~inside[new]]
    faces = linked.triangles[inside]
    vertices = np.unique(faces)
    out = np.zeros(linked.size, bool)
    out[ring] = True
    out[linked.edges[linked.count == 1]] = True
    return Patch(inside, vertices[~out[vertices]], faces, vertices, np.searchsorted(vertices, faces))


def chain(curve):
    """The vertices of a saved curve, in their order; of a closed one the first again."""
    return curve.point["VertexId"].astype(np.int64)[curve.lines[0]]


def half_width(line, ring):
    """How far the line is from the ring [points of both], in the middle of what its points find."""
    return float(np.median([np.linalg.norm(ring - p, axis=1).min() for p in line]))


def shares(points, patch, line, ring):
    """Of each vertex of a patch d / (d + e), d its way to the line and e that to the ring, over edges and straight across pairs of
    triangles, so that a way is at most some percent too long."""
    linked = Linked(patch.local)
    p = points[patch.vertices]
    one, other = np.nonzero(linked.beyond >= 0)
    mate = linked.beyond[one, other]
    a, b, c = (patch.local[one, (other + k) % 3] for k in range(3))
    d = patch.local[mate].sum(1) - a - b
    base = p[b] - p[a]
    length = np.linalg.norm(base, axis=1)
    unit = base / length[:, None]

    def flat(q):
        along = ((q - p[a]) * unit).sum(1)
        return along, np.linalg.norm(q - p[a] - along[:, None] * unit, axis=1)

    (x, y), (u, v) = flat(p[c]), flat(p[d])
    crossing = x + (u - x) * y / np.maximum(y + v, 1e-300)
    sound = (crossing > 0) & (crossing < length)
    ends = np.vstack([linked.edges, np.c_[c, d][sound]])
    cost = np.r_[np.linalg.norm(p[linked.edges[:, 1]] - p[linked.edges[:, 0]], axis=1), np.hypot(x - u, y + v)[sound]]
    ends, cost = np.vstack([ends, ends[:, ::-1]]), np.r_[cost, cost]
    order = np.argsort(ends[:, 0], kind="stable")
    begin = np.searchsorted(ends[order, 0], np.arange(len(p) + 1)).tolist()
    to, cost = ends[order, 1].tolist(), cost[order].tolist()
    ways = []
    for sources in (line, ring):
        way = [np.inf] * len(p)
        heap = [(0.0, int(v)) for v in np.searchsorted(patch.vertices, np.intersect1d(sources, patch.vertices))]
        for _, v in heap:
            way[v] = 0.0
        while heap:
            length, v = heapq.heappop(heap)
            if length > way[v]:
                continue
            for k in range(begin[v], begin[v + 1]):
                reached = length + cost[k]
                if reached < way[to[k]]:
                    way[to[k]] = reached
                    heapq.heappush(heap, (reached, to[k]))
        ways.append(np.array(way))
    return ways[0] / (ways[0] + ways[1])


def harmonic(points, faces):
    """The plain map of a disc: the border on a circle by its length, the inside at means with weights max(cotangent, 1e-3); None
    where the border is not one loop."""
    pairs = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    linked = Linked(faces)
    rim = pairs[linked.count[linked.edge.ravel()] == 1]
    if not len(rim):
        return None
    following = dict(zip(rim[:, 0].tolist(), rim[:, 1].tolist()))
    loop = [int(rim[0, 0])]
    while len(loop) <= len(rim) and following[loop[-1]] != loop[0]:
        loop.append(following[loop[-1]])
    if len(loop) != len(rim):
        return None
    n = len(points)
    way = np.r_[0, np.cumsum(np.linalg.norm(points[np.roll(loop, -1)] - points[loop], axis=1))]
    turn = 2 * np.pi * way[:-1] / way[-1]
    place = np.zeros((n, 2))
    place[loop] = np.c_[np.cos(turn), np.sin(turn)]
    weight = np.zeros(len(linked.edges))
    for k in range(3):
        u, v = points[faces[:, k]] - points[faces[:, (k + 2) % 3]], points[faces[:, (k + 1) % 3]] - points[faces[:, (k + 2) % 3]]
        np.add.at(weight, linked.edge[:, k], 0.5 * (u * v).sum(1) / np.maximum(np.linalg.norm(np.cross(u, v), axis=1), 1e-300))
    weight = np.maximum(weight, 1e-3)
    i, j = linked.edges.T
    free = np.ones(n, bool)
    free[loop] = False
    diagonal = np.bincount(i, weight, n) + np.bincount(j, weight, n)

    def product(x):
        result = diagonal[:, None] * x
        for k in range(2):
            result[:, k] -= np.bincount(i, weight * x[j, k], n) + np.bincount(j, weight * x[i, k], n)
        return result * free[:, None]

    rest = -product(place)
    start = (rest ** 2).sum(0)
    step = rest / diagonal[:, None]
    inner = (rest * step).sum(0)
    for _ in range(20 * int(np.sqrt(n)) + 500):  # conjugate gradients
        image = product(step)
        amount = inner / np.maximum((step * image).sum(0), 1e-300)
        place += amount * step
        rest -= amount * image
        if ((rest ** 2).sum(0) <= 1e-24 * start).all():
            break
        scaled = rest / diagonal[:, None]
        before, inner = inner, (rest * scaled).sum(0)
        step = scaled + inner / np.maximum(before, 1e-300) * step
    return place


def turn_of(disc, faces):
    """Twice the area of each triangle on a disc, with its sign."""
    u, v = disc[faces[:, 1]] - disc[faces[:, 0]], disc[faces[:, 2]] - disc[faces[:, 0]]
    return u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]


def spread(points, disc, faces, chosen):
    """p95 / p5 of a vertex's share of the surface over its share of the disc."""
    gathered = lambda area: np.bincount(faces.ravel(), np.repeat(area, 3), len(points)) / area.sum()
    surface = gathered(np.linalg.norm(measure.normals(points, faces), axis=1))
    flat = gathered(np.abs(turn_of(disc, faces)))
    low, high = np.percentile(surface[chosen] / np.maximum(flat[chosen], 1e-300), (5, 95))
    return float(high / low)


def slope_jumps(points, faces, values, line, ring):
    """Medians over the edges of both chains of how much the slope across them jumps, over the mean slope of the faces."""
    linked = Linked(faces)
    corner, n = points[faces], measure.normals(points, faces)
    square = np.maximum((n ** 2).sum(1), 1e-300)
    slope = sum(values[faces[:, k]][:, None] * np.cross(n, corner[:, (k + 2) % 3] - corner[:, (k + 1) % 3]) for k in range(3))
    slope /= square[:, None]
    area = np.sqrt(square)
    mean = (area * np.linalg.norm(slope, axis=1)).sum() / area.sum()
    jump = np.zeros(len(linked.edges))
    for k in range(3):
        along = corner[:, (k + 1) % 3] - corner[:, k]
        along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-300)
        away = corner[:, (k + 2) % 3] - corner[:, k]
        away -= (away * along).sum(1, keepdims=True) * along
        away /= np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 1e-300)
        np.add.at(jump, linked.edge[:, k], (slope * away).sum(1))
    found = []
    for chain in (line, ring):
        at = linked.between(chain)
        found.append(float(np.median(np.abs(jump[at[at >= 0]])) / mean))
    return found


def cut(points, triangles, origin, normal):
    """Where a plane cuts triangles: segments (n, 2, 3)."""
    side = (points - origin) @ normal
    above = side >= 0
    crossed = triangles[above[triangles].any(1) & ~above[triangles].all(1)]
    ends = []
    for k in range(3):
        a, b = crossed[:, k], crossed[:, (k + 1) % 3]
        t = side[a] / np.where(side[a] != side[b], side[a] - side[b], 1.0)
        ends.append(np.where((above[a] != above[b])[:, None], points[a] + t[:, None] * (points[b] - points[a]), np.nan))
    ends = np.stack(ends, axis=1)
    return ends[~np.isnan(ends[:, :, 0])].reshape(-1, 2, 3)


def goes_round(points, faces, origin, normal):
    """Whether a plane cuts a patch, where that is nearest to a place, in a closed curve: it goes round a limb and meets no ring."""
    segments = cut(points, faces, origin, normal)
    if not len(segments):
        return False
    size = np.ptp(points[np.unique(faces)], axis=0).max()
    _, ends = np.unique(np.round(segments.reshape(-1, 3) / (1e-9 * size)), axis=0, return_inverse=True)
    ends = ends.reshape(-1, 2)
    found, before = np.zeros(len(segments), bool), -1
    found[np.linalg.norm(segments.mean(1) - origin, axis=1).argmin()] = True
    while found.sum() > before:
        before = found.sum()
        found = np.isin(ends, ends[found]).any(1)
    return bool((np.bincount(ends[found].ravel())[np.unique(ends[found])] == 2).all())


def to_segments(points, segments):
    """Distance of each point to the nearest segment, infinite where there is none."""
    if not len(segments):
        return np.full(len(points), np.inf)
    a, d = segments[:, 0], segments[:, 1] - segments[:, 0]
    gap = points[:, None] - a
    t = np.clip((gap * d).sum(2) / np.maximum((d ** 2).sum(1), 1e-300), 0, 1)
    return np.linalg.norm(gap - t[:, :, None] * d, axis=2).min(1)


def bits(values):
    """Numbers as whole ones of the same bits."""
    return np.ascontiguousarray(values).view(f"i{values.dtype.itemsize}")
