"""Judges an augmentation by the files that its steps wrote, and by nothing else: forests, angles, crossings, crests and
profiles are computed here anew. A folder holds input.vtp, base.vtp, curves.vtp, refined.vtp, snapped.vtp, smoothed.vtp,
displaced.vtp, output.vtp and run.json (radius, height, sharpness [model length, 1], sketched, seconds {step: s}).
"""
import json
from pathlib import Path

import numpy as np

import forest
import measure
import saved

DEGENERATE = 0.05  # degrees
FILES = ("input", "base", "curves", "refined", "snapped", "smoothed", "displaced", "output")

# What the specification asks of every case ("faithful") and of nearly all ("excellent"), where the measure is known.
FAITHFUL = (
    ("structure", lambda r: not r["structure"]), ("angle ratio", lambda r: r["angle ratio"] >= 0.6),
    ("near edge", lambda r: 0.1 <= r["near edge"] <= 0.2), ("degenerate", lambda r: r["degenerate"] == 0),
    ("flipped", lambda r: r["flipped"] == 0), ("residual", lambda r: r["residual"] <= 0.01), ("added", lambda r: r["added"] <= 0.03),
    ("crest mean", lambda r: r["crest mean"] >= 0.99), ("crest min", lambda r: r["crest min"] >= 0.85),
    ("lateral", lambda r: r["lateral"] <= 0.02), ("profile", lambda r: r["profile"] <= 0.03),
    ("terrain flipped", lambda r: r["terrain flipped"] <= 0.01), ("dihedral", lambda r: r["dihedral"] <= 20.0),
    ("segment", lambda r: r["segment"] < 1.0), ("seconds", lambda r: r["seconds"] < 1.0),
    ("far moved", lambda r: r["far moved"] == 0), ("kept", lambda r: r["kept"] >= 0.95),
)
EXCELLENT = (
    ("smallest angle", lambda r: r["smallest angle"] >= min(4.5, r["base angle"])), ("residual", lambda r: r["residual"] <= 0.003),
    ("added", lambda r: r["added"] <= 0.005), ("crest mean", lambda r: r["crest mean"] >= 0.995),
    ("crest min", lambda r: r["crest min"] >= 0.92), ("lateral", lambda r: r["lateral"] <= 0.003),
    ("profile", lambda r: r["profile"] <= 0.02), ("peak", lambda r: r["peak"] <= 1.0 + 1e-9),
    ("terrain flipped", lambda r: r["terrain flipped"] == 0),
    ("dihedral", lambda r: r["dihedral"] <= max(17.0, 1.25 * r["dihedral before"])), ("segment", lambda r: r["segment"] < 0.5),
    ("seconds", lambda r: r["seconds"] < 0.1),
)


class Case:
    """The files of one run, and what several measures read of them."""

    def __init__(self, folder):
        self.files = {name: saved.read(Path(folder) / f"{name}.vtp") for name in FILES}
        self.run = json.loads((Path(folder) / "run.json").read_text())
        curves = self.files["curves"]
        self.radius = self.run["radius"]
        self.pieces = measure.pieces(curves.points, curves.lines, self.radius / 8)

    def __getattr__(self, name):
        if name in FILES:
            return self.files[name]
        raise AttributeError(name)


def judge(folder, about=()):
    """All measures of a folder of files; about: words that say which rows ask more of a case (`terrain`, `bunny`, `time`)."""
    case, result = Case(folder), {}
    result["structure"] = structure(case)
    if any("piece" in w or "root" in w for w in result["structure"]):
        return verdict(result)
    refinement(case, result)
    snapping(case, result)
    places, weights, face = crest_places(case)
    phi, raised = shares(case)
    if len(places):
        along = (weights * phi[case.smoothed.triangles[face]]).sum(1)
        result["crest mean"], result["crest min"] = float(along.mean()), float(along.min())
        result["lateral"], result["lateral worst"] = lateral(case, places, face)
    if case.run["sharpness"] >= 1.0 and not case.run["sketched"]:
        result["profile"] = profile_error(case, phi, raised)
    result["peak"] = float(phi.max())
    after = measure.normals(case.displaced.points, case.displaced.triangles)
    turned = (measure.normals(case.smoothed.points, case.smoothed.triangles) * after).sum(1) < 0
    result["turned"] = int(turned.sum())
    if "terrain" in about:
        # A flank of 56 degrees, as h = r makes it, laid over relief that falls by 40 the other way turns by over 90 degrees and is
        # sound: turned over is what also looks against the way in which its corners rose.
        rose = (case.displaced.points - case.smoothed.points)[case.smoothed.triangles].sum(1) * np.sign(case.run["height"])
        result["terrain flipped"] = float((turned & ((after * rose).sum(1) < 0)).sum() / max(1, raised.sum()))
    if "bunny" in about:
        # Its own facets meet at up to so much there; only what the feature adds to them is its doing.
        result["dihedral before"], result["dihedral"] = flank(case, phi, case.smoothed), flank(case, phi, case.displaced)
    if "time" in about:
        result["seconds"] = sum(case.run["seconds"][step] for step in ("Refine", "Snap", "Displace"))
        result["kept"], result["kept in place"] = kept(case)
    result["faces"] = len(case.output.triangles)
    return verdict(result)


def verdict(result):
    """Adds which bounds do not hold: `fails`, and `lacks` those of the excellent; `holds` where none fails."""
    result["fails"] = [name for name, holds in FAITHFUL if name in result and not holds(result)]
    result["lacks"] = [name for name, holds in EXCELLENT if name in result and not holds(result)]
    result["holds"] = not result["fails"]
    return result


# ------------------------------------------------------------------------------------------------- the forest

def structure(case):
    """What is wrong with the 4-8 meshes, in words: invariants, what of the topology changed, and what welding gives back."""
    wrong = []
    base, topology = case.base, forest.topology(case.base.triangles)
    for name in ("base", "refined", "snapped", "smoothed", "displaced", "output"):
        mesh = case.files[name]
        rebuilt = forest.rebuild(mesh)
        wrong += [f"{name}: {text}" for text in rebuilt.wrong]
        if rebuilt.wrong and not len(rebuilt.base):
            continue
        if forest.topology(mesh.triangles) != topology:
            wrong.append(f"{name}: Euler characteristic or border loops changed")
        if not np.array_equal(rebuilt.base, base.triangles):
            wrong.append(f"{name}: welded back it is not the base")
        if name == "refined":
            made = np.flatnonzero(rebuilt.parents[:, 0] >= 0)
            ends = mesh.points[rebuilt.parents[made]]
            middle = np.array_equal(mesh.points[made], (ends[:, 0] + ends[:, 1]) / 2)
            if not np.array_equal(mesh.points[:len(base.points)], base.points) or not middle:
                wrong.append("refined: welded back its points are not the base's")
    return wrong


# ---------------------------------------------------------------------------------------- refining and snapping

def refinement(case, result):
    """Angles and edges after refining, and what far from the curves is not as it was."""
    base, refined, r = case.base, case.refined, case.radius
    result["base angle"] = float(measure.angles(base.points, base.triangles).min())
    result["angle ratio"] = float(measure.angles(refined.points, refined.triangles).min() / max(result["base angle"], 1e-300))
    edges, _, _ = forest.undirected(refined.triangles)
    near = np.isfinite(measure.distance(refined.points, case.pieces, r))
    chosen = edges[near[edges].all(1)]
    length = np.linalg.norm(refined.points[chosen[:, 0]] - refined.points[chosen[:, 1]], axis=1)
    if case.run["sharpness"] >= 1.0:
        result["near edge"] = float(length.mean() / r)
    # Three base edges are three of the longest that touch what is refined.
    edges, _, _ = forest.undirected(base.triangles)
    touched = np.isfinite(measure.distance(base.points, case.pieces, r))[edges].any(1)
    length = np.linalg.norm(base.points[edges[:, 0]] - base.points[edges[:, 1]], axis=1)
    reach = r + 3 * (length[touched].max() if touched.any() else length.max())
    given = case.input.points
    far = ~np.isfinite(measure.distance(given, case.pieces, reach))
    result["far moved"] = int((case.output.points[:len(given)][far] != given[far]).any(1).sum())
    segments = np.concatenate([np.linalg.norm(np.diff(case.curves.points[ids], axis=0), axis=1) for ids in case.curves.lines])
    result["segment"] = float(segments.max() / r)


def kept(case):
    """Share of the input's triangles that the output has, by its corners' numbers, and of those that stand as they were to the bit."""
    n = len(case.input.points)
    same = (case.output.points[:n] == case.input.points).all(1)
    whole = lambda t: np.sort(t, axis=1) @ np.array([n * n, n, 1])
    after = case.output.triangles[(case.output.triangles < n).all(1)]
    there = np.isin(whole(case.input.triangles), whole(after))
    return float(there.mean()), float((there & same[case.input.triangles].all(1)).mean())


def snapping(case, result):
    """Triangles that snapping spoiled, crossings before it and after, and faces added."""
    refined = case.refined
    spoiled = int((measure.angles(refined.points, refined.triangles).min(1) < DEGENERATE).sum())
    result["degenerate"], result["flipped"], result["smallest angle"] = 0, 0, 180.0
    key = lambda root, path: root.astype(np.uint64) * np.uint64(1 << 40) + path
    own = key(refined.cell["StellarRoot"], refined.cell["StellarPath"].astype(np.uint64))
    order = np.argsort(own)
    for mesh in (case.snapped, case.smoothed):
        least = measure.angles(mesh.points, mesh.triangles).min(1)
        result["degenerate"] = max(result["degenerate"], int((least < DEGENERATE).sum()) - spoiled)
        result["smallest angle"] = min(result["smallest angle"], float(least.min()))
        # Each triangle beside the one of the refined mesh that it is, or is a piece of.
        root, path = mesh.cell["StellarRoot"], mesh.cell["StellarPath"].astype(np.uint64)
        of = np.full(len(path), -1)
        while (of < 0).any() and path.max() > 0:
            at = np.minimum(np.searchsorted(own, key(root, path), sorter=order), len(own) - 1)
            found = (of < 0) & (own[order[at]] == key(root, path))
            of[found] = order[at[found]]
            path = path >> np.uint64(1)
        if (of < 0).any():
            result["structure"].append("snapping took triangles away")
            return
        turn = (measure.normals(mesh.points, mesh.triangles) * measure.normals(refined.points, refined.triangles)[of]).sum(1)
        result["flipped"] = max(result["flipped"], int((turn <= 0).sum()))
    result["crossings"] = crossings(case, refined)
    result["left"] = crossings(case, case.snapped)
    result["residual"] = result["left"] / max(1, result["crossings"])
    result["added"] = len(case.snapped.triangles) / len(refined.triangles) - 1


def crossings(case, mesh):
    """Edges that a curve crosses without a snapped end that explains it."""
    return crossed(mesh.points, mesh.triangles, mesh.point["CurveId"].astype(int), mesh.point["CurveParam"].astype(float),
                   case.radius, *case.pieces)


@saved.by_content
def crossed(p, triangles, ident, where, radius, *values):
    curves = measure.Pieces(*values)
    edges, count, edge = forest.undirected(triangles)
    near = np.isfinite(measure.distance(p, curves, radius))
    chosen = np.flatnonzero(near[edges].any(1))
    a, c = p[edges[chosen, 0]], p[edges[chosen, 1]]
    length = np.linalg.norm(c - a, axis=1)
    reach = 0.5 * (length.max(initial=0.0) + np.linalg.norm(curves.along, axis=1).max()) * 1.01
    # The gap in space is at most half an edge.
    reach = float(np.hypot(reach, 0.5 * length.max(initial=0.0)))
    i, j = measure.near_pairs(0.5 * (a + c), curves.start + 0.5 * curves.along, reach)
    face = measure.normals(p, triangles)
    face /= np.maximum(np.linalg.norm(face, axis=1, keepdims=True), 1e-300)
    normal = np.zeros((len(edges), 3))
    for k in range(3):
        np.add.at(normal, edge[:, k], face)
    n = normal[chosen][i]
    n /= np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300)
    flat = lambda v: v - (v * n).sum(1)[:, None] * n
    u, v, w = flat((c - a)[i]), flat(curves.along[j]), flat(curves.start[j] - a[i])
    cross = lambda x, y: (np.cross(x, y) * n).sum(1)
    whole = cross(u, v)
    safe = np.where(np.abs(whole) > 0, whole, 1.0)
    s, t = cross(w, v) / safe, cross(w, u) / safe
    gap = np.linalg.norm(a[i] + s[:, None] * (c - a)[i] - curves.start[j] - t[:, None] * curves.along[j], axis=1)
    on = (np.abs(whole) > 0) & (s > 1e-9) & (s < 1 - 1e-9) & (t >= 0) & (t < 1) & (gap <= length[i] / 2)
    i, j, t = i[on], j[on], t[on]
    k, l = curves.curve[j], length[i]
    at = curves.arc[j] + t * np.linalg.norm(curves.along[j], axis=1)

    def apart(x, y):
        d = np.abs(x - y)
        return np.where(curves.closed[k], np.minimum(d, curves.total[k] - d), d)

    ends = edges[chosen][i]
    own = ident[ends] == k[:, None]
    explained = (own[:, 0] & (apart(where[ends[:, 0]], at) < l / 2)) | (own[:, 1] & (apart(where[ends[:, 1]], at) < l / 2))
    explained |= own.all(1) & (apart(where[ends[:, 0]], where[ends[:, 1]]) <= 2 * l)
    place = curves.start[j] + t[:, None] * curves.along[j]
    for side in (0, 1):
        explained |= (ident[ends[:, side]] >= 0) & (np.linalg.norm(p[ends[:, side]] - place, axis=1) <= l / 4)
    return len(np.unique(np.c_[chosen[i], k][~explained], axis=0))


# ------------------------------------------------------------------------------------------------ the feature

def shares(case):
    """Per point the share of the height that it rose by, and per face whether any corner did."""
    before, after = case.smoothed, case.displaced
    if not np.array_equal(before.triangles, after.triangles):
        raise RuntimeError("displacing changed the triangles")
    moved = after.points - before.points
    if case.run["sketched"]:  # the vector differs from point to point: the file's own shares
        phi = after.point["Feature"].astype(float)
    else:
        normal = np.zeros_like(before.points)
        face = measure.normals(before.points, before.triangles)
        for k in range(3):
            np.add.at(normal, before.triangles[:, k], face)
        side = np.sign((moved * normal).sum(1)) * np.sign(case.run["height"])
        phi = side * np.linalg.norm(moved, axis=1) / abs(case.run["height"])
    return phi, (phi[before.triangles] != 0).any(1)


def crest_places(case):
    """Places on the curves every r/20, the face of the smoothed mesh nearest to each, and the weights of its corners."""
    places, _ = measure.even(case.pieces, case.radius / 20, case.radius)
    mesh = case.smoothed
    near = np.isfinite(measure.distance(mesh.points, case.pieces, case.radius))
    faces = np.flatnonzero(near[mesh.triangles].any(1))
    if not len(places) or not len(faces):
        return np.empty((0, 3)), np.empty((0, 3)), np.empty(0, int)
    corner = mesh.points[mesh.triangles[faces]]
    centre = corner.mean(1)
    size = np.linalg.norm(corner - centre[:, None], axis=2).max()
    i, j = measure.near_pairs(places, centre, size + 0.25 * case.radius)
    weights, square = measure.on_triangles(places[i], corner[j, 0], corner[j, 1], corner[j, 2])
    best = measure.least(i, square, len(places))
    found = best >= 0
    return places[found], weights[best[found]], faces[j[best[found]]]


def lateral(case, places, face):
    """(mean, largest) tangential distance from the places to the nearest edge of snapped vertices [r]."""
    mesh = case.smoothed
    edges, _, _ = forest.undirected(mesh.triangles)
    ident = mesh.point["CurveId"]
    on = edges[(ident[edges] >= 0).all(1)]
    if not len(on):
        return 1.0, 1.0
    a, d = mesh.points[on[:, 0]], mesh.points[on[:, 1]] - mesh.points[on[:, 0]]
    i, j = measure.near_pairs(places, a + 0.5 * d, case.radius)
    t = np.clip(((places[i] - a[j]) * d[j]).sum(1) / np.maximum((d[j] ** 2).sum(1), 1e-300), 0, 1)
    gap = a[j] + t[:, None] * d[j] - places[i]
    best = measure.least(i, (gap ** 2).sum(1), len(places))
    n = measure.normals(mesh.points, mesh.triangles)[face]
    n /= np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300)
    aside = np.full(len(places), case.radius)
    found = best >= 0
    g = gap[best[found]]
    aside[found] = np.linalg.norm(g - (g * n[found]).sum(1)[:, None] * n[found], axis=1)
    return float(aside.mean() / case.radius), float(aside.max() / case.radius)


def profile_error(case, phi, raised):
    """Area-weighted root of the mean square of the interpolated share less (1 - distance / r)^s, over raised faces."""
    mesh, s = case.smoothed, case.run["sharpness"]
    triangles = mesh.triangles[raised]
    area = np.linalg.norm(measure.normals(mesh.points, triangles), axis=1)
    total = 0.0
    for weights in np.array([[4, 1, 1], [1, 4, 1], [1, 1, 4], [2, 2, 2]]) / 6.0:  # the middles of four quarters
        at = np.einsum("k,nkx->nx", weights, mesh.points[triangles])
        away = measure.distance(at, case.pieces, case.radius)
        wanted = np.where(np.isfinite(away), np.maximum(1 - np.where(np.isfinite(away), away, 0) / case.radius, 0) ** s, 0)
        total += (area * (phi[triangles] @ weights - wanted) ** 2).sum() / 4
    return float(np.sqrt(total / max(area.sum(), 1e-300)))


def flank(case, phi, mesh):
    """95th percentile of the angle between neighbouring faces at edges of the flanks [degrees], in one of the run's meshes."""
    edges, count, edge = forest.undirected(mesh.triangles)
    part = (phi[edges] > 0) & (phi[edges] < 1 - 1e-9)
    if not part.any():
        return 180.0
    return float(np.percentile(measure.dihedral(mesh.points, mesh.triangles, edge, count, part.any(1)), 95))
