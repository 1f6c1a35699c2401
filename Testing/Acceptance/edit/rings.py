"""Lines and rings of the edit's acceptance, made by rule: over each model six cameras, in each a straight line, an S and an arc at a
place drawn by lot, and round each a ring, which may leave the model or pass behind a part of it; rings round the tips of limbs; and
rings half beside a sphere. All by a hand that strays by 1 px.

    rings.py FOLDER [PART-OF-NAME ...]    writes FOLDER/<model>-<hand>-<camera>-<kind>-line.vtp and …-ring.vtp, index.json, contact sheets
"""
import json
import sys
import zlib
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np

sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parents[1] / "one_stroke")]
import meshes  # noqa: E402  also puts Data into the path
import listing  # noqa: E402
import picture  # noqa: E402
import sheets  # noqa: E402
import stroke_files  # noqa: E402
import strokes  # noqa: E402

SPHERE = "icosphere_20k"
# Of the shared data, with what points up in the file.
SHARED_MODELS = {
    f"{SPHERE}.ply": "+y", "bunny_5k.obj": "+y", "bunny_30k.ply": "+y", "bunny_180k.ply": "+y", "spot_1k6.off": "+y", "spot_5k9.obj": "+y",
    "cat.off": "+y", "hand_closed.obj": "+y", "hand_open_wrist.off": "+y", "koala.stl": "+y", "wingnut.stl": "+y", "mountain_sheet.ply": "+y",
    "armadillo_29k.obj": "+y"}
SHEET = "mountain_sheet"  # which is looked at from above
CAMERAS, HANDS, TIPS, HALVES = 6, 3, 3, 12
KINDS = ("line", "S", "arc")
WOBBLE = 1.0  # px
HALF_LENGTH, REACH = (35.0, 75.0), (24.0, 48.0)  # px: of a line, and from it to the ring
MARGIN = 5.0  # px of the model's edge that lines keep from
LEAP = 10.0  # px in depth from sample to sample that they do not make


def models():
    """(name, path, up) of every model that is here."""
    drawn = {name.split("_")[0] for name in listing.ONE_STROKE}
    found = [(Path(file).stem, meshes.SHARED / "meshes" / file, up) for file, up in SHARED_MODELS.items()]
    found += [(path.stem, path, "+y") for path in sorted((meshes.DATA / "Models").glob("*.ply")) if path.stem in drawn]
    return [model for model in found if model[1].is_file()]


# ------------------------------------------------------------------------------------------------ by hand

def by_hand(line, random, closed=False):
    """Samples of a line, or of a ring that ends where it began, 3 to 6 px apart, as a hand leaves them that strays by WOBBLE."""
    course = picture.resample(line, 1.0)
    tangent = np.gradient(course, axis=0)
    normal = np.c_[-tangent[:, 1], tangent[:, 0]] / np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-9)
    away = WOBBLE * stroke_files.noise(len(course) + (0 if closed else 2 * int(stroke_files.CORRELATED)), random)[:len(course)]
    course = course + away[:, None] * normal
    at = np.cumsum(random.uniform(3.0, 6.0, len(course)))
    at = np.r_[0.0, at[at < len(course) - 3.0], len(course) - 1.0]
    return np.c_[np.interp(at, np.arange(len(course)), course[:, 0]), np.interp(at, np.arange(len(course)), course[:, 1])]


def ring_round(line, reach, begin):
    """The rim of what lies within a reach of the line's convex hull, closed, from some share of its turn on."""
    angle = 2 * np.pi * (begin + np.linspace(0, 1, 361))
    way = np.c_[np.cos(angle), np.sin(angle)]
    return line[np.argmax(way @ line.T, axis=1)] + reach * way


def shape_of(kind, half, random):
    """A line about the origin, along x."""
    t = np.linspace(-1, 1, 121)
    side = random.choice([-1.0, 1.0])
    if kind == "line":
        return np.c_[half * t, np.zeros_like(t)]
    if kind == "S":
        return np.c_[half * t, side * 0.22 * half * np.sin(np.pi * t)]
    angle = 0.5 * np.pi * t
    return 0.8 * half * np.c_[np.sin(angle), side * (0.6 - np.cos(angle))]


def turned(line, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return line @ np.array([[c, s], [-s, c]])


# ------------------------------------------------------------------------------------------------- the places

def up_of(up):
    vector = np.zeros(3)
    vector["xyz".index(up[1])] = -1 if up[0] == "-" else 1
    return vector


def directions(up, hand, raised=0):
    """Where from the six cameras of a hand look: round the model, from above and below in turn, so many degrees higher."""
    front = np.roll(up, 1)
    side = np.cross(up, front)
    for k in range(CAMERAS):
        a, e = np.radians(60 * k + 20 * hand + 10), np.radians((15, -10, 35)[k % 3] + raised)
        yield np.cos(e) * (np.cos(a) * front + np.sin(a) * side) + np.sin(e) * up


class Seen:
    """What a model covers in a view."""

    def __init__(self, view, points, triangles):
        self.depth, _ = picture.depths(view, points, triangles)
        self.loops = picture.outline(view.display(points)[0], triangles, 1.0)

    def holds(self, line):
        """Whether a line lies on the model, off its edge, and passes behind nothing."""
        at = np.floor(line).astype(int)
        if (at < 0).any() or (at >= (picture.WIDTH, picture.HEIGHT)).any():
            return False
        depth = self.depth[at[:, 1], at[:, 0]]
        if not np.isfinite(depth).all() or np.abs(np.diff(depth)).max() > LEAP:
            return False
        return picture.distance_to(line, self.loops, np.inf)[0].min() > MARGIN


def pair(kind, seen, random):
    """A line of a kind on the model, at a place drawn by lot, and a ring round it; smaller where there is no room."""
    rows, columns = np.nonzero(np.isfinite(seen.depth))
    half, reach = random.uniform(*HALF_LENGTH), random.uniform(*REACH)
    for attempt in range(200):
        if attempt and attempt % 10 == 0:
            half, reach = 0.9 * half, 0.9 * reach
        k = random.randint(len(rows))
        line = picture.resample(turned(shape_of(kind, half, random), random.uniform(0, 360)), 1.5) + (columns[k] + 0.5, rows[k] + 0.5)
        if seen.holds(line):
            return by_hand(line, random), by_hand(ring_round(line, reach, random.uniform()), random, True)
    raise RuntimeError("a view of the model has no room for a line")


def tip_pairs(points, triangles, up, random):
    """Rings round the tips of limbs, each seen from beside its limb: (line, ring, view)."""
    found, _ = strokes.tips(points, triangles)
    for number, (tip, away) in enumerate(list(found.items())[:TIPS]):
        reach = 0.16 * away[np.isfinite(away)].max()
        base = points[(away > 0.8 * reach) & (away < 1.2 * reach)].mean(0)
        limb = points[tip] - base
        beside = np.cross(limb, up)
        beside = beside if np.linalg.norm(beside) > 0.2 * np.linalg.norm(limb) else np.cross(limb, np.roll(up, 1))
        beside = beside / np.linalg.norm(beside)
        across = np.cross(limb / np.linalg.norm(limb), beside)
        turn = random.uniform(0, 2 * np.pi)
        view = picture.View.looking(points, np.cos(turn) * beside + np.sin(turn) * across, limb, number % 2 == 1, 0.6)
        # The limb's middle, from its tip on: the line follows it where it bends.
        levels = np.linspace(0.2, 1.0, 9) * reach
        middle = np.array([points[tip]] + [points[(away > level - 0.1 * reach) & (away < level + 0.1 * reach)].mean(0) for level in levels])
        course = strokes.smooth(picture.resample(view.display(middle)[0], 2.0), 6.0)
        along = course[-1] - course[0]
        line = course[int(0.25 * len(course)):int(0.75 * len(course))]
        middle = course[0] + 0.25 * along
        radius = np.linalg.norm(along)
        turns = 2 * np.pi * (random.uniform() + np.linspace(0, 1, 361))
        ring = middle + 1.05 * radius * np.c_[np.cos(turns), np.sin(turns)]
        yield by_hand(line, random), by_hand(ring, random, True), view


def half_pairs(points, random):
    """Rings half beside a sphere in twelve cameras: (line, ring, view)."""
    for k in range(HALVES):
        towards = random.standard_normal(3)
        view = picture.View.looking(points, towards, np.roll(towards, 1) + (0.1, 0.2, 0.3), k % 2 == 1, 0.6)
        xy, _ = view.display(points)
        middle = (xy.max(0) + xy.min(0)) / 2
        radius = (xy.max(0) - xy.min(0)).max() / 2
        turn = random.uniform(0, 2 * np.pi)
        outward = np.array([np.cos(turn), np.sin(turn)])
        size = random.uniform(0.45, 0.6) * radius
        turns = 2 * np.pi * (random.uniform() + np.linspace(0, 1, 361))
        ring = middle + radius * outward + size * np.c_[np.cos(turns), np.sin(turns)]
        side = np.array([-outward[1], outward[0]])
        line = middle + (radius - 0.45 * size) * outward + np.linspace(-0.4, 0.4, 60)[:, None] * size * side
        yield by_hand(line, random), by_hand(ring, random, True), view


# ------------------------------------------------------------------------------------------------- the set

def _make(job):
    folder, name, path, up, only = job
    wanted = [f"{name}-h{hand}" for hand in range(HANDS)]
    if only and not any(part in w or w in part for part in only for w in wanted):
        return []
    points, triangles, _ = meshes.weld(*meshes.arrays(meshes.read(path)))
    entries = []

    def add(entry, pairs):
        """Pairs: case: (line, ring, view)."""
        if only and not any(part in entry for part in only):
            return
        for case, (line, ring, view) in pairs.items():
            stroke_files.write(stroke_files.polydata(line, view), folder / f"{entry}-{case}-line.vtp")
            stroke_files.write(stroke_files.polydata(ring, view), folder / f"{entry}-{case}-ring.vtp")
        if pairs:
            views = {pair[2].perspective for pair in pairs.values()}
            entries.append({"name": entry, "model": name, "mesh": str(path), "cases": list(pairs),
                            "projection": "both" if len(views) == 2 else "perspective" if views == {True} else "orthographic"})

    for hand, start in enumerate(wanted):
        random = lambda what: np.random.RandomState(zlib.crc32(f"{start} {what}".encode()))  # each by itself, whatever else is made
        for k, towards in enumerate(directions(up_of(up), hand, 35 if name == SHEET else 0)):
            entry = f"{start}-c{k + 1}"
            if only and not any(part in entry for part in only):
                continue
            view = picture.View.looking(points, towards, up_of(up), k % 2 == 1, 0.8)
            seen = Seen(view, points, triangles)
            lot = random(entry)
            add(entry, {kind: (*pair(kind, seen, lot), view) for kind in KINDS})
        if name == SPHERE:
            add(f"{start}-half", {f"{k + 1}": made for k, made in enumerate(half_pairs(points, random("half")))})
        elif not only or any(part in f"{start}-tips" for part in only):
            add(f"{start}-tips", {f"{k + 1}": made for k, made in enumerate(tip_pairs(points, triangles, up_of(up), random("tips")))})
    return entries


def of_the_day(day):
    """Entries that are a twentieth of all: a camera of one hand over each model; none, for all, where no day is given."""
    if day is None:
        return ()
    return [f"{name}-h{day % HANDS}-c{day // HANDS % CAMERAS + 1}" for name, _, _ in models()]


def make_all(folder, only=(), workers=2):
    """Writes all lines and rings, or those of some entries, and an index; returns the index."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    with ProcessPoolExecutor(workers) as pool:
        index = [entry for part in pool.map(_make, [(folder, *model, tuple(only)) for model in models()]) for entry in part]
    (folder / "index.json").write_text(json.dumps(index, indent=1))
    return index


def main():
    folder = Path(sys.argv[1])
    pictures = []
    for entry in make_all(folder, sys.argv[2:]):
        points, triangles, _ = meshes.weld(*meshes.arrays(meshes.read(entry["mesh"])))
        for case in entry["cases"]:
            drawn = [stroke_files.read(folder / f"{entry['name']}-{case}-{what}.vtp") for what in ("line", "ring")]
            image = picture.shaded(drawn[0][2], points, triangles, scale=1)
            for (_, samples, _, _), colour in zip(drawn, (picture.RED, picture.BLUE)):
                picture.draw(image, samples, colour)
            image = picture.halve(image)
            picture.write_text(image, f"{entry['name']} {case}", 6, 6, 13)
            pictures.append(image)
    sheets.write(pictures, folder / "sheet", columns=4, rows=6)


if __name__ == "__main__":
    main()
