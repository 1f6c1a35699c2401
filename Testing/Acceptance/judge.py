"""Judges what a stroke did to a mesh: the outline it has now against the stroke, and what must not have changed."""
import numpy as np

import meshes
import picture

# The bounds of the specification (stage 12) and of the project's acceptance: largest value that holds, or least.
MEAN, WORST, BACK, FOLDS, UNTOUCHED, OVERLAP = 1.0, 2.5, 3.0, 10, 0.5, 0.95
FOLD_ANGLE = 100.0  # degrees between the normals of two neighbours, above which their edge counts as folded
SHARP_ANGLE = 40.0  # degrees, above which it counts as sharp
# How much rougher than the same stroke's result without remeshing what moved may be: mean angle between neighbours, and share of
# the edges' length that is sharp.
ROUGHER, ROUGHER_BY, SHARPER_BY = 1.25, 1.0, 0.01
INSIDE_OUT = 0.002  # share of what is covered of the picture that may newly show the back of a triangle


# ----------------------------------------------------------------------------------------------- the outline

def part(line, start, end):
    """The part of a polyline between two arc lengths."""
    s = picture.lengths(line)
    keep = (s > start) & (s < end)
    ends = [[np.interp(t, s, line[:, 0]), np.interp(t, s, line[:, 1])] for t in (start, end)]
    return np.vstack([ends[:1], line[keep], ends[1:]])


def outline_distances(view, points, triangles, stroke):
    """mean, worst: px from the stroke's middle 60 % to the mesh's outline; back: largest px from the outline between
    the points nearest to the stroke's 20 % and 80 % points to the stroke (inf where no outline joins these two)."""
    xy, _ = view.display(points)
    loops = picture.outline(xy, triangles)
    total = picture.lengths(stroke)[-1]
    middle = picture.resample(part(stroke, 0.2 * total, 0.8 * total), 0.5)
    distance, which, where = picture.distance_to(middle, loops)
    back = np.inf
    if which[0] == which[-1]:
        loop = loops[which[0]]
        around = picture.lengths(loop)[-1]
        arcs = []
        for a, b in ((where[0], where[-1]), (where[-1], where[0])):
            if b >= a:
                arc = part(loop, a, b)
            else:
                arc = np.vstack([part(loop, a, around), part(loop, 0, b)])
            gap, _, _ = picture.distance_to(picture.resample(arc, 8.0), [stroke])
            arcs.append((gap.mean(), len(arcs), arc))
        arc = min(arcs)[2]  # a loop has two ways between two points: the one along the stroke
        back = picture.distance_to(picture.resample(arc, 1.0), [stroke])[0].max()
    return float(distance.mean()), float(distance.max()), float(back)


def back_share(view, points, triangles):
    """The share of the pixels that the mesh covers in which the front triangle shows its back; points must not lie behind the eye."""
    xy, depth = view.display(points)
    nearness = -1 / depth if view.perspective else depth  # affine on screen over a plane
    a, b, c = (xy[triangles[:, k]] for k in range(3))
    cross = lambda u, v: u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    area = cross(b - a, c - a)
    pixel, t = picture.fragments(xy, triangles, view.width, view.height)
    pixel, t = pixel[area[t] != 0], t[area[t] != 0]
    at = np.c_[pixel % view.width, pixel // view.width] + 0.5
    share = [cross(q[t] - p[t], at - p[t]) / area[t] for p, q in ((b, c), (c, a), (a, b))]
    near = sum(weight * nearness[triangles[t, k]] for k, weight in enumerate(share))
    order = np.lexsort((area[t] > 0, near, pixel))
    front = order[np.diff(pixel[order], append=-1) != 0]  # of each pixel the last, which is the nearest
    return float((area[t[front]] < 0).mean()) if len(front) else 0.0


# ----------------------------------------------------------------------------------------------- the surface

def turns(points, triangles):
    """Degrees between the normals of the two triangles at an edge, and that edge's ends, for every edge of exactly two
    triangles that have an area."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    size = np.linalg.norm(normal, axis=1)
    good = size > 0
    normal[good] /= size[good, None]
    pairs, count, edge = meshes.edges_of(triangles)
    order = np.argsort(edge.ravel(), kind="stable")
    start = np.cumsum(count) - count
    twice = np.flatnonzero(count == 2)
    sides = np.stack([order[start[twice]], order[start[twice] + 1]])
    both = good[sides // 3].all(0)
    sides, ends = sides[:, both], pairs[twice[both]]
    p, q = normal[sides // 3]
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(p, q), axis=1), (p * q).sum(1))), ends


def folded_edges(points, triangles):
    """Edges of two triangles whose normals are more than 100 degrees apart."""
    return int((turns(points, triangles)[0] > FOLD_ANGLE).sum())


def roughness(points, triangles, moved):
    """(mean angle between neighbouring triangles in degrees, share of the edges' length over 40 degrees) of the edges that
    have an end among the moved points; zero where there are none."""
    angle, ends = turns(points, triangles)
    here = moved[ends].any(1)
    angle, ends = angle[here], ends[here]
    if not len(angle):
        return 0.0, 0.0
    length = np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)
    return float(angle.mean()), float(length[angle > SHARP_ANGLE].sum() / length.sum())


def degenerate_triangles(points, triangles):
    """Triangles with a repeated vertex or an area of at most 1e-7 of the longest edge squared."""
    corners = points[triangles]
    longest = (np.roll(corners, -1, axis=1) - corners) ** 2
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    return int((area <= 1e-7 * longest.sum(2).max(1)).sum())


def topology(triangles):
    """(border edges, edges with more than two triangles, vertices with more than one fan of triangles)."""
    pairs, count, edge = meshes.edges_of(triangles)
    # Fans: a triangle's corner is joined with the neighbour's corner at the same vertex across each shared edge.
    order = np.argsort(edge.ravel(), kind="stable")
    start = np.cumsum(count) - count
    first, second = [], []
    for k in range(1, count.max()):
        shared = np.flatnonzero(count > k)
        a, b = order[start[shared]], order[start[shared] + k]  # corner k of a triangle starts its edge k
        for v in pairs[shared].T:
            for side, at in ((a, first), (b, second)):
                ends = side // 3 * 3 + (side + 1) % 3
                at.append(np.where(triangles.ravel()[side] == v, side, ends))
    first, second = (np.concatenate(x) if x else np.empty(0, int) for x in (first, second))
    fan = np.arange(3 * len(triangles))
    joined, other = np.r_[first, second], np.r_[second, first]
    order = np.argsort(joined, kind="stable")
    joined, other = joined[order], other[order]
    begin = np.flatnonzero(np.diff(joined, prepend=-1))
    while True:
        least = fan.copy()
        if len(begin):
            least[joined[begin]] = np.minimum(fan[joined[begin]], np.minimum.reduceat(fan[other], begin))
        if (least == fan).all():
            break
        fan = least
    heads = triangles.ravel()[np.unique(fan)]
    return int((count == 1).sum()), int((count > 2).sum()), int((np.bincount(heads) > 1).sum())


def areas(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def about(points, edges, tip, radius):
    """The points of a surface within a radius of one of them, as a mask: those that edges between such points join to it. A
    neighbouring limb may come nearer than that."""
    away = np.linalg.norm(points - tip, axis=1)
    near = edges[(away[edges] < radius).all(1)]
    found, before = np.arange(len(points)) == away.argmin(), None
    while before is None or (found != before).any():
        before = found.copy()
        found[near[before[near].any(1)]] = True
    return found


def capsule_limb(points, triangles, at):
    """Triangles of capsule_figure nearer to the capsule at a point than to any other, as a mask; and its name."""
    def gaps(p):
        columns = []
        for _, a, b, radius in meshes.CAPSULES:
            a, d = np.array(a, float), np.subtract(b, a)
            t = np.clip((p - a) @ d / (d @ d), 0, 1)
            columns.append(np.linalg.norm(p - a - np.outer(t, d), axis=1) - radius)
        return np.array(columns)

    own = int(gaps(np.atleast_2d(at)).argmin(0)[0])
    return gaps(points[triangles].mean(1)).argmin(0) == own, meshes.CAPSULES[own][0]


# ------------------------------------------------------------------------------------------------- all of it

def facts_of(mesh):
    """What the judge needs to know of a mesh (points, triangles) as read."""
    points, triangles, welded = meshes.weld(*mesh)
    return {"points": points, "triangles": triangles, "welded": welded, "folds": folded_edges(points, triangles),
            "topology": topology(triangles), "degenerate": degenerate_triangles(points, triangles)}


def judge(before, after, stroke, view, region=None, note=None):
    """Measures of one result. before: facts_of the mesh; after: (points, triangles) as read; region: byte per point of before, or None;
    note: what the stroke's maker knows (other_tips, tip, model). Returns a dict with every measure and `holds`."""
    result = {}
    p0, t0, to_welded = before["points"], before["triangles"], before["welded"]
    result["finite"] = bool(np.isfinite(after[0]).all())
    if not result["finite"]:
        result["fails"], result["holds"] = ["not finite"], False
        return result
    changed = facts_of(after)
    p1, t1 = changed["points"], changed["triangles"]
    result["mean"], result["worst"], result["back"] = outline_distances(view, p1, t1, stroke)
    if "start" not in before:
        before["start"] = outline_distances(view, p0, t0, stroke) + (back_share(view, p0, t0),)
    result["mean before"], result["worst before"] = before["start"][:2]
    result["inside out"] = back_share(view, p1, t1) - before["start"][3]
    result["folds"] = changed["folds"] - before["folds"]
    result["angle"], result["sharp"] = roughness(p1, t1, ~meshes.among(p1, p0))
    stays = meshes.among(p0, p1)
    area = areas(p0, t0)
    result["untouched"] = float(area[stays[t0].all(1)].sum() / area.sum())
    top0, top1 = before["topology"], changed["topology"]
    result["closed"] = not (top0[0] == 0 and top1[0] > 0)
    result["manifold"] = not (top0[1] == 0 and top0[2] == 0 and (top1[1] > 0 or top1[2] > 0))
    result["degenerate"] = changed["degenerate"] - before["degenerate"]
    if region is not None:
        chosen = np.zeros(len(p0), bool)
        chosen[to_welded[np.asarray(region) != 0]] = True
        result["outside changed"] = int((~stays & ~chosen).sum())
        result["region area"] = float(area[chosen[t0].all(1)].sum() / area.sum())
        if note and note.get("model") == "capsule_figure":
            limb, result["capsule"] = capsule_limb(p0, t0, note["tip"])
            inside = chosen[t0].sum(1) >= 2
            result["overlap"] = float(area[inside & limb].sum() / area[inside | limb].sum())
    if note and note.get("other_tips"):
        # A limb's tip stays when the points about it do, within 2 % of the model's size.
        size, edges = np.linalg.norm(np.ptp(p0, axis=0)), meshes.edges_of(t0)[0]
        result["other limbs moved"] = int(sum(not stays[about(p0, edges, tip, 0.02 * size)].all() for tip in np.array(note["other_tips"])))
    result["fails"] = failures(result)
    result["holds"] = not result["fails"]
    return result


CHECKS = (
    ("mean", lambda v: v <= MEAN), ("worst", lambda v: v <= WORST), ("back", lambda v: v <= BACK),
    ("folds", lambda v: v <= FOLDS), ("inside out", lambda v: v <= INSIDE_OUT), ("untouched", lambda v: v >= UNTOUCHED), ("closed", bool), ("manifold", bool),
    ("degenerate", lambda v: v <= 0), ("outside changed", lambda v: v == 0), ("overlap", lambda v: v >= OVERLAP),
    ("other limbs moved", lambda v: v == 0), ("rougher", lambda v: v <= 0),
)


def compare(result, plain):
    """Adds to a result what it is beside the same stroke's without remeshing: `rougher`, degrees of mean angle or hundredths of
    sharp length, whichever is more, above what is allowed (at most 0 holds). Two results without a moved edge are alike."""
    if "angle" in result and "angle" in plain:
        result["rougher"] = max(result["angle"] - (ROUGHER * plain["angle"] + ROUGHER_BY),
                                100 * (result["sharp"] - plain["sharp"] - SHARPER_BY))
        result["fails"] = failures(result)
        result["holds"] = not result["fails"]


def failures(result):
    """The names of the measures that do not hold."""
    return [name for name, holds in CHECKS if name in result and not holds(result[name])]
