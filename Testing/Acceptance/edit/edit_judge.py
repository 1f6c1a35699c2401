"""Judges an edit by the files that its steps wrote, and by nothing else: region, fields, sections, angles are computed here anew.
A folder holds

    input.vtp, reference.vtp, boundary.vtp      what went in
    region.vtp, line.vtp, ring.vtp              the mesh at rest with region, disc and weights, the curves in it (VertexId)
    dragged.vtp, dragged_line.vtp, …_ring.vtp   the line moved outward by a half width; off.vtp: without new triangles
    turned.vtp, handles.vtp                     turned by 60 degrees about the line, without new triangles; the handle's frame
    part.vtp, part_line.vtp, …, part_off.vtp     moved at a quarter of the line, pinned at its middle
    profile.vtp, asked.vtp                      the section and what was drawn in its plane
    profiled.vtp, profiled_line.vtp, …_ring.vtp what became of the mesh
    zero.vtp, same.vtp, black.vtp               what comes of zero amounts, the same profile, black weights
    run.json                                    mode, kind (line, S, arc, tip or half), model, whether its name is the sphere's

of which the last five rows but run.json and profiles are asked for by default alone.
"""
import json
from pathlib import Path

import numpy as np

import measure
import meshes
import patch as patches
import picture
import saved
import stroke_files

TURN = 60.0  # degrees
FEW, MANY, COARSE = 1000, 4000, 2000  # vertices of a patch, from which on bounds hold, or stricter ones; triangles of a coarse mesh
ASTRAY = 12.0  # px off the stroke, beyond which a curve that was led over a gap is not looked at; what is missing there `covered` tells
AHEAD, LEAP = 2.0, 15.0  # px of depth: by which something hides a point; in which edges of what is seen are told

default = lambda r: not r["published"]
# Name, whether the row asks something of a case, and whether that holds; rows without their measure ask nothing.
BOUNDS = (
    ("region", lambda r: True, lambda r: r["region"] == 0),
    ("disc", lambda r: True, lambda r: r["disc"] == 1),
    ("curves", lambda r: True, lambda r: not r["curves"]),
    ("sound", lambda r: True, lambda r: not r["sound"]),
    ("flips", lambda r: True, lambda r: r["flips"] == 0),
    ("curve angle", default, lambda r: r["curve angle"] >= (9.0 if r["coarse"] else 12.0)),
    ("px", default, lambda r: r["px"] <= 1.2),
    ("worst px", default, lambda r: r["worst px"] <= (7.0 if r["coarse"] else 4.0)),
    ("covered", default, lambda r: r["covered"] >= 0.9),
    ("line slope", lambda r: r["patch"] >= FEW,
     lambda r: r["line slope"] >= 1.8 if r["published"] else r["line slope"] <= (0.4 if r["patch"] >= MANY else 1.1)),
    ("ring slope", lambda r: r["patch"] >= FEW,
     lambda r: r["ring slope"] >= 0.85 if r["published"] else r["ring slope"] <= (0.15 if r["patch"] >= MANY else 0.3)),
    ("ends", lambda r: True, lambda r: r["ends"] <= 1e-9),
    ("share", lambda r: True, lambda r: r["share"] <= 0.06),
    ("tau step", lambda r: default(r) and r["patch"] >= FEW, lambda r: r["tau step"] <= 0.4),
    ("spread", lambda r: r["plain spread"] > 30, lambda r: r["spread"] <= r["plain spread"] / 5),
    ("recut", lambda r: True, lambda r: r["recut"] <= recut_bound(r)),
    ("drag", lambda r: True, lambda r: abs(r["drag"] - 1) <= 0.02),
    ("folds", default, lambda r: r["folds"] <= 0.02),
    ("angle", default, lambda r: r["angle"] >= (19.0 if r["coarse"] else 24.0)),
    ("dihedral", default, lambda r: r["dihedral"] < r["dihedral off"]),
    ("turned", default, lambda r: r["turned"] <= 1e-4),
    ("kept", default, lambda r: r["kept"] >= 0.98),
    ("far", lambda r: True, lambda r: r["far"] == 0),
    ("as it was", default, lambda r: not r["as it was"]),
)


def recut_bound(r):
    """Mean edges: of a straight line, of an S or an arc, and there of a thin limb."""
    straight = r["kind"] not in ("S", "arc")
    if r["published"]:
        return 0.25 if straight else 1.1
    return 0.15 if straight else 0.8 if r["thin"] else 0.4


class Case:
    """The files of a run, each read when it is asked for; what several rows read of the mesh at rest."""

    def __init__(self, folder):
        self.folder, self.read = Path(folder), {}
        self.run = json.loads((self.folder / "run.json").read_text())
        self.input, self.rest = self["input"], self["region"]
        self.line, self.ring = (patches.chain(self[name]) for name in ("line", "ring"))
        self.linked = patches.Linked(self.rest.triangles)
        edges, _, _ = meshes.edges_of(self.input.triangles)
        self.edge = float(np.linalg.norm(self.input.points[edges[:, 0]] - self.input.points[edges[:, 1]], axis=1).mean())
        self.patch = patches.enclosed(self.linked, self.line, self.ring)
        self.half = patches.half_width(self.rest.points[self.line], self.rest.points[self.ring])

    def __getitem__(self, name):
        if name not in self.read:
            self.read[name] = saved.read(self.folder / f"{name}.vtp")
        return self.read[name]

    def has(self, name):
        return (self.folder / f"{name}.vtp").is_file()

    def enclosed(self, name):
        """What the ring encloses in a result: (result, patch)."""
        result = self[name]
        line, ring = (patches.chain(self[f"{name}_{what}"]) for what in ("line", "ring"))
        return result, patches.enclosed(patches.Linked(result.triangles), line, ring)


def judge(folder):
    """All measures of a folder of files, which bounds do not hold (`fails`), and whether all do (`holds`)."""
    case = Case(folder)
    result = {"kind": case.run["kind"], "published": case.run["mode"] == "published", "coarse": len(case.input.triangles) <= COARSE,
              "edge": case.edge, "half width": case.half / case.edge, "triangles": len(case.input.triangles)}
    soundness(case, result)
    region(case, result)
    drawn(case, result)
    fields(case, result)
    if case.has("dragged"):
        dragged(case, result)
    if case.has("turned"):
        result["turned"] = turned(case)
    if case.has("part"):
        result["kept"] = kept(case)
    if case.has("profiled"):
        recut(case, result)
    result["far"] = sum(far(case, name) for name in ("dragged", "profiled", "part") if case.has(name))
    if case.has("zero"):
        result["as it was"] = " ".join(name for name in ("zero", "same", "black") if (name != "same" or case.has("profile"))
                                       and not (case.has(name) and same(case, name)))
    asked = [(name, holds) for name, asks, holds in BOUNDS if result.get(name) is not None and asks(result)]
    result["asks"], result["fails"] = [name for name, _ in asked], [name for name, holds in asked if not holds(result)]
    result["holds"] = not result["fails"]
    return result


# ------------------------------------------------------------------------------------------ mesh and curves

def counts(points, triangles):
    """(Euler number, edges of more than two triangles, vertices at a place that another one has, triangles with a corner twice)."""
    _, count, _ = meshes.edges_of(triangles)
    used = np.unique(triangles)
    twice = (triangles == np.roll(triangles, 1, axis=1)).any(1).sum()
    twins = len(used) - len(meshes.distinct(points[used])[0])
    return len(used) - len(count) + len(triangles), int((count > 2).sum()), int(twins), int(twice)


def soundness(case, result):
    """What of the topology is not as it was, and where curves are no simple chains, in words."""
    before, wrong, broken = counts(case.input.points, case.input.triangles), [], []
    for name in ("region", "dragged", "part", "profiled"):
        if not case.has(name):
            continue
        mesh = case[name]
        for what, was, now in zip(("Euler number", "edges of three", "twins", "collapsed"), before, counts(mesh.points, mesh.triangles)):
            if now != was and (what == "Euler number" or now > was):
                wrong.append(f"{name}: {what} {was} to {now}")
        linked = case.linked if name == "region" else patches.Linked(mesh.triangles)
        for curve in ("line", "ring"):
            file = curve if name == "region" else f"{name}_{curve}"
            if not case.has(file):
                continue
            chain = patches.chain(case[file])
            inner = chain[:-1] if curve == "ring" else chain
            if (chain < 0).any() or (linked.between(chain) < 0).any():
                broken.append(f"{file} is no chain of edges")
            if len(np.unique(inner)) != len(inner) or (curve == "ring") != (chain[0] == chain[-1]):
                broken.append(f"{file} is not simple")
    result["sound"], result["curves"] = "; ".join(wrong), "; ".join(broken)


def region(case, result):
    """Vertices that are of the region and not in it, or the other way: by their label, and by having moved."""
    interior = np.zeros(len(case.rest.points), bool)
    interior[case.patch.interior] = True
    labelled = case.rest.point["EditRegion"] == 2
    result["region"] = int((labelled != interior).sum())
    for name in ("off", "turned", "part_off"):
        if case.has(name):
            moved = (case[name].points != case.rest.points).any(1)
            result["region"] = max(result["region"], int((moved & ~interior).sum()))
            # What is on the axis that it turns about, or beyond the pin, stays.
            if name == "off" and moved.sum() < 0.9 * interior.sum():
                result["region"] = max(result["region"], int((interior & ~moved).sum()))
    linked = patches.Linked(case.patch.local)
    result["disc"] = len(case.patch.vertices) - len(linked.edges) + len(case.patch.local)
    result["patch"] = len(case.patch.vertices)
    # A limb that the ring goes round: what it encloses is thin against its length.
    area = 0.5 * np.linalg.norm(measure.normals(case.rest.points, case.patch.faces), axis=1)
    turn = measure.normals(case.rest.points, case.patch.faces).sum(0) / 2
    result["thin"] = bool(np.linalg.norm(turn) < 0.5 * area.sum())


def in_sight(depth, xy, z):
    """Which places are before all, or nearly, of what is seen about them; none at an edge of what is seen, where depth leaps."""
    at = np.clip(np.floor(xy).astype(int), 2, (depth.shape[1] - 3, depth.shape[0] - 3))
    around = np.array([depth[at[:, 1] + j, at[:, 0] + i] for i in range(-2, 3) for j in range(-2, 3)])
    with np.errstate(invalid="ignore"):
        return (around.min(0) <= z + AHEAD) & (around.max(0) - around.min(0) <= LEAP)


def within(polygon, places):
    """Which places a closed polygon goes round: a line to the right crosses it an odd number of times."""
    inside, (a, b) = np.zeros(len(places), bool), (polygon, np.roll(polygon, 1, axis=0))
    for (x, y), (u, v) in zip(a, b):
        if y != v:
            inside ^= ((y > places[:, 1]) != (v > places[:, 1])) & (places[:, 0] < x + (places[:, 1] - y) * (u - x) / (v - y))
    return inside


def limb(linked, line, passes):
    """Triangles at what the line reaches over edges whose vertices pass."""
    edges = linked.edges[passes[linked.edges].all(1)]
    reached, before = np.zeros(len(passes), bool), -1
    reached[line] = passes[line]
    while reached.sum() > before:
        before = reached.sum()
        reached[edges[reached[edges].any(1)]] = True
    return linked.triangles[reached[linked.triangles].any(1)]


def on_line_side(linked, line, xy):
    """Which vertices look to where the line is seen from, or away from there where the line does too."""
    corner = xy[linked.triangles]
    (ux, uy), (vx, vy) = (corner[:, 1] - corner[:, 0]).T, (corner[:, 2] - corner[:, 0]).T
    turn = np.zeros(len(xy))
    np.add.at(turn, linked.triangles, (ux * vy - uy * vx)[:, None])
    return turn * np.sign(turn[line].sum()) > 0


def own_stretches(course, under, alone, shown):
    """Which samples of a ring lie on the line's limb, by the depths of all, of that limb and of what of it the line reaches on its own
    side: a stretch that it does not reach there counts where the leaps to those before and after are at most half as long again."""
    place = np.c_[course, under]
    with np.errstate(invalid="ignore"):
        own = np.abs(alone - under) <= AHEAD
        starts = ~np.isfinite(under) | ~(np.linalg.norm(place - np.roll(place, 1, axis=0), axis=1) <= LEAP)
    if not starts.any():
        return own
    first = np.flatnonzero(starts)[0]
    order = np.roll(np.arange(len(course)), -first)
    stretches = [s for s in np.split(order, np.flatnonzero(starts[order])[1:]) if np.isfinite(under[s]).all()]
    leap = lambda a, b: np.linalg.norm(place[a[-1]] - place[b[0]])
    for k, s in enumerate(stretches):
        with np.errstate(invalid="ignore"):
            reached = (np.abs(shown[s] - under[s]) <= AHEAD).any()
        length = np.linalg.norm(np.diff(place[s], axis=0), axis=1).sum()
        if not reached and 1.5 * length < leap(stretches[k - 1], s) + leap(s, stretches[(k + 1) % len(stretches)]):
            own[s] = False
    return own


def on_limb(case, view, samples, course, at, under):
    """Which samples of a ring lie on the limb that the line is on; all, where the line lies beside its ring."""
    xy, _ = view.display(case.rest.points)
    inside, faces = within(samples, xy), on_line_side(case.linked, case.line, xy)
    whole = limb(case.linked, case.line, inside)
    if not len(whole):
        return np.ones(len(course), bool)
    under_of = lambda part: picture.depths(view, case.rest.points, part)[0][at[:, 1], at[:, 0]] if len(part) else np.full(len(course), np.inf)
    return own_stretches(course, under, under_of(whole), under_of(limb(case.linked, case.line, inside & faces)))


def drawn(case, result):
    """How far curves are off their strokes, and angles beside them."""
    beside = np.zeros(len(case.rest.points), bool)
    beside[case.line] = beside[case.ring] = True
    near = case.rest.triangles[beside[case.rest.triangles].any(1)]
    result["curve angle"] = float(np.percentile(measure.angles(case.rest.points, near).min(1), 5))
    away, covered = [], []
    for name, curve in (("reference", case.line), ("boundary", case.ring)):
        _, samples, view, _ = stroke_files.read(case.folder / f"{name}.vtp")
        depth, size = picture.depths(view, case.rest.points, case.rest.triangles)
        xy, z = view.display(case.rest.points[curve])
        z = z / size
        seen = in_sight(depth, xy, z)
        course = picture.resample(samples, 1.0)
        at = np.clip(np.floor(course).astype(int), 0, (view.width - 1, view.height - 1))
        under = depth[at[:, 1], at[:, 0]]
        # What leads over a gap behind something may come into sight too: it is not on what the stroke passes over there, or far off.
        off, _, where = picture.distance_to(xy, [course], np.inf)
        nearest = np.clip(np.round(where / picture.lengths(course)[-1] * (len(course) - 1)).astype(int), 0, len(course) - 1)
        clear = in_sight(depth, course, under)
        if name == "boundary":  # one round the tip of a limb may pass over another one too, on which it has no part
            clear &= on_limb(case, view, samples, course, at, under)
        with np.errstate(invalid="ignore"):
            gaps = not np.isfinite(under).all() or np.abs(np.diff(under)).max() > LEAP
        if gaps:
            seen &= clear[nearest] & (np.abs(under[nearest] - z) <= LEAP + off) & (off <= ASTRAY)
        parts = [picture.resample(xy[k:k + 2], 1.0) for k in np.flatnonzero(seen[:-1] & seen[1:])]
        if parts:
            away.append(picture.distance_to(np.vstack(parts), [samples], np.inf)[0])
        if clear.any():
            covered.append(float((picture.distance_to(course[clear], [xy], np.inf)[0] <= (9.0 if result["coarse"] else 6.0)).mean()))
    away = np.concatenate(away or [np.zeros(1)])
    result["covered"] = min(covered, default=0.0)
    result["px"], result["worst px"] = float(np.sqrt((away ** 2).mean())), float(away.max())


# ------------------------------------------------------------------------------------------------- the fields

def fields(case, result):
    """Disc, weights and parameter."""
    p, patch, points = case.rest.points, case.patch, case.rest.point
    disc = points["DiscCoords"].astype(float)
    areas = patches.turn_of(disc, patch.faces)
    result["flips"] = int(min((areas <= 0).sum(), (areas >= 0).sum()))
    weight = points["EditWeight"].astype(float)
    outside = np.ones(len(p), bool)
    outside[patch.interior] = False
    result["ends"] = float(max(np.abs(weight[case.line] - 1).max(), np.abs(weight[outside]).max()))
    inner, outer = patches.slope_jumps(p[patch.vertices], patch.local, weight[patch.vertices],
                                       *(np.searchsorted(patch.vertices, chain) for chain in (case.line, case.ring)))
    result["line slope"], result["ring slope"] = inner, outer
    s = patches.shares(p, patch, case.line, case.ring)
    expected = 1 - s if result["published"] else 1 - 3 * s ** 2 + 2 * s ** 3
    result["share"] = float(np.abs(weight[patch.vertices] - expected).mean())
    tau = points["CurveParameter"].astype(float)
    edges, _, _ = meshes.edges_of(patch.faces)
    result["tau step"] = float(np.abs(tau[edges[:, 0]] - tau[edges[:, 1]]).max())
    if not result["published"]:
        plain = patches.harmonic(p[patch.vertices], patch.local)
        if plain is not None:
            inside = np.isin(patch.vertices, patch.interior)
            result["plain spread"] = patches.spread(p[patch.vertices], plain, patch.local, inside)
            result["spread"] = patches.spread(p[patch.vertices], disc[patch.vertices], patch.local, inside)


# --------------------------------------------------------------------------------------------------- edits

def bends(points, triangles):
    """Degrees between the two triangles at each edge of two."""
    _, count, edge = meshes.edges_of(triangles)
    return measure.dihedral(points, triangles, edge, count, np.ones(len(count), bool))


def dragged(case, result):
    """How far the line went, folds, angles and bends of the region, with new triangles and without."""
    mesh, patch = case.enclosed("dragged")
    rest, off = (bends(case[name].points, case.patch.faces) for name in ("region", "off"))
    way = np.linalg.norm(case["off"].points[case.line] - case.rest.points[case.line], axis=1)
    result["drag"] = float(np.median(way) / case.half)
    now = bends(mesh.points, patch.faces)
    result["folds"] = max(0, int((now > 120).sum()) - int((rest > 120).sum())) / max(1, len(now))
    result["angle"] = float(np.percentile(measure.angles(mesh.points, patch.faces).min(1), 5))
    result["angle off"] = float(np.percentile(measure.angles(case["off"].points, case.patch.faces).min(1), 5))
    result["dihedral"], result["dihedral off"] = float(np.percentile(now, 95)), float(np.percentile(off, 95))
    result["faces"] = len(patch.faces) / max(1, len(case.patch.faces))


def turned(case):
    """How far vertices are from where a turn by their share of the angle about the handle's axis takes them [mean edges]."""
    frame = case["handles"].point["Frame"][0].reshape(4, 4)
    axis, place = frame[:3, 0] / np.linalg.norm(frame[:3, 0]), frame[:3, 3]
    line = case.rest.points[case.line]
    way = picture.lengths(line)
    middle = [np.array([np.interp(share * way[-1], way, line[:, k]) for k in range(3)]) for share in (0.35, 0.5, 0.65)]
    along = middle[2] - middle[0]
    if abs(axis @ along) < 0.8 * np.linalg.norm(along) or np.linalg.norm(place - middle[1]) > 0.1 * way[-1]:
        return 1.0  # another axis
    angle = np.radians(TURN) * case.rest.point["EditWeight"].astype(float)[:, None]
    d = case.rest.points - place
    expected = place + d * np.cos(angle) + np.cross(axis, d) * np.sin(angle) + np.outer(d @ axis, axis) * (1 - np.cos(angle))
    return float(np.linalg.norm(case["turned"].points - expected, axis=1)[case.patch.vertices].max() / case.edge)


def kept(case):
    """Of the region's triangles that the edit neither moved nor changed, nor any neighbour of theirs, the share that is still there;
    None where there are few."""
    p, q, faces = case.rest.points, case["part_off"].points, case.patch.faces
    edges, _, edge = meshes.edges_of(faces)
    before, after = (np.linalg.norm(x[edges[:, 0]] - x[edges[:, 1]], axis=1) for x in (p, q))
    touched = np.zeros(len(p), bool)
    touched[faces[(np.abs(after / before - 1) > 1e-6)[edge].any(1)]] = True
    for _ in range(2):
        touched[faces[touched[faces].any(1)]] = True
    still = faces[~touched[faces].any(1) & (p == q).all(1)[faces].all(1)]
    return present(p, still, case["part"]) if len(still) >= 20 else None


def present(points, triangles, mesh):
    """The share of triangles that a mesh has at the same places, to the bit."""
    _, number = meshes.distinct(np.vstack([points, mesh.points]))
    whole = lambda ids: np.sort(ids, axis=1)
    return float(meshes.among(whole(number[triangles]), whole(number[len(points):][mesh.triangles])).mean())


def far(case, name):
    """Points and triangles of the input beyond the ring's triangles and two mean edges that a result does not have to the bit."""
    near = np.zeros(len(case.input.points), bool)
    ring = case.rest.points[case.ring]
    between = [ring[:-1] + share * np.diff(ring, axis=0) for share in (0.25, 0.5, 0.75)]
    region = np.vstack([case.rest.points[case.patch.vertices], *between])
    i, _ = measure.near_pairs(case.input.points, region, 2 * case.edge)
    near[i] = True
    # Vertices of triangles that touch the region; those of the input keep their places.
    touching = np.zeros(len(case.rest.points), bool)
    touching[case.patch.vertices] = True
    touching[case.rest.triangles[touching[case.rest.triangles].any(1)]] = True
    near |= meshes.among(patches.bits(case.input.points), patches.bits(case.rest.points[touching]))
    lost = ~meshes.among(patches.bits(case.input.points[~near]), patches.bits(case[name].points))
    outside = case.input.triangles[~near[case.input.triangles].any(1)]
    gone = round((1 - present(case.input.points, outside, case[name])) * len(outside)) if len(outside) else 0
    return int(lost.sum()) + gone


def same(case, name):
    """Whether a result is the input: points, triangles and arrays."""
    a, b = case.input, case[name]
    alike = lambda x, y: x.dtype == y.dtype and np.array_equal(x, y, equal_nan=x.dtype.kind == "f")
    arrays = all(x.keys() == y.keys() and all(alike(x[key], y[key]) for key in x)
                 for x, y in ((a.point, b.point), (a.cell, b.cell), (a.field, b.field)))
    return alike(a.points, b.points) and alike(a.triangles, b.triangles) and arrays


def goes_round(folder):
    """Whether the plane across the line's middle goes round a limb, whose tip the ring encloses."""
    case = Case(folder)
    line = case.rest.points[case.line]
    way = picture.lengths(line)
    at = lambda share: np.array([np.interp(share * way[-1], way, line[:, k]) for k in range(3)])
    return patches.goes_round(case.rest.points, case.patch.faces, at(0.5), at(0.65) - at(0.35))


def recut(case, result):
    """How far what was drawn is from where its plane cuts the result now [mean edges]: worst of a straight line, mean of another."""
    matrix = case["profile"].field["ProfileMatrix"].reshape(4, 4)
    place = lambda p: p @ matrix[:3, :3].T + matrix[:3, 3]
    asked, before = place(case["asked"].points), place(case["profile"].points)
    normal = matrix[:3, 2] / np.linalg.norm(matrix[:3, 2])
    mesh, patch = case.enclosed("profiled")
    section = patches.cut(mesh.points, patch.faces, matrix[:3, 3], normal)
    away = patches.to_segments(asked, section) / case.edge
    result["recut mean"], result["recut worst"] = float(away.mean()), float(away.max())
    result["recut"] = result["recut mean"] if result["kind"] in ("S", "arc") else result["recut worst"]
    result["raised"] = float(np.linalg.norm(asked - before, axis=1).max() / case.half)
