"""Situations that hands and files from outside brought, each over three models: strokes, drawings and terrains that a program of the
house may do as meant or refuse in words, and must not wreck in silence. All made by rule.

    situations.py FOLDER [PART-OF-NAME ...]    writes FOLDER/<situation>-<model>.json and its inputs, and index.json
"""
import functools
import json
import sys
from pathlib import Path

import numpy as np
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parent / "one_stroke"), str(HERE.parent / "augment")]
import frame  # noqa: E402
import meshes  # noqa: E402  also puts Data into the path
import implicit  # noqa: E402
import lines as lines_over  # noqa: E402
import make_drawings  # noqa: E402
import picture  # noqa: E402
import stroke_files  # noqa: E402
import strokes  # noqa: E402

CANVAS = (1024, 1024)  # px of a drawing
HOLE = 1  # of the cell array Treatment
UP = np.array([0.0, 1.0, 0.0])


# -------------------------------------------------------------------------------------------------- models of its own

def goat(step=0.022):
    """A body on four thin legs with split feet, two thin horns beside each other and a curled tail."""
    f = implicit.Field()
    f.add(implicit.Ellipsoid((0, 0.75, 0), (0.5, 0.24, 0.22)))
    f.add(implicit.Tube([(0.4, 0.82, 0, 0.15), (0.6, 1.05, 0, 0.11), (0.66, 1.2, 0, 0.1)]), 0.1)
    f.add(implicit.Tube([(0.64, 1.24, 0, 0.12), (0.85, 1.18, 0, 0.08), (0.94, 1.15, 0, 0.06)]), 0.06)
    for side in (-1, 1):
        f.add(implicit.Tube([(0.62, 1.32, 0.05 * side, 0.036), (0.55, 1.5, 0.09 * side, 0.032), (0.42, 1.66, 0.13 * side, 0.024),
                             (0.28, 1.72, 0.15 * side, 0.016)]), 0.03)
        for x, lean in ((0.32, 0.04), (-0.34, -0.05)):
            foot = x + lean
            f.add(implicit.Tube([(x, 0.68, 0.13 * side, 0.1), (x + 0.5 * lean, 0.4, 0.15 * side, 0.062), (foot, 0.08, 0.15 * side, 0.05)]), 0.06)
            for toe in (-0.032, 0.032):
                f.add(implicit.Ellipsoid((foot + 0.05, 0.035, 0.15 * side + toe), (0.07, 0.035, 0.028)), 0.012)
    f.add(implicit.Tube([(-0.46, 0.82, 0, 0.05), (-0.62, 0.95, 0, 0.042), (-0.66, 1.12, 0, 0.036), (-0.56, 1.2, 0, 0.03), (-0.47, 1.13, 0, 0.022)]),
          0.04)
    return f.polygonise(step)


def decimated(points, triangles, count):
    """By quadrics, which leaves long thin triangles."""
    few = vtkQuadricDecimation()
    few.SetInputData(meshes.to_polydata(points, triangles))
    few.SetTargetReduction(1 - count / len(triangles))
    few.Update()
    return meshes.arrays(few.GetOutput())


def boxes(cell):
    """A figure of boxes, its surface on a grid: a trunk, two arms, two legs, a head."""
    spans = [((-3, 3), (4, 10), (-2, 2)), ((-8, -3), (8, 10), (-1, 1)), ((3, 8), (8, 10), (-1, 1)), ((-3, -1), (-3, 4), (-1, 1)),
             ((1, 3), (-3, 4), (-1, 1)), ((-1, 1), (10, 13), (-1, 1))]
    filled = np.zeros((20 * cell, 20 * cell, 20 * cell), bool)
    for span in spans:
        filled[tuple(slice((a + 10) * cell, (b + 10) * cell) for a, b in span)] = True
    filled = np.pad(filled, 1)
    quads = []
    for axis in range(3):
        u, v = np.eye(3, dtype=int)[(axis + 1) % 3], np.eye(3, dtype=int)[(axis + 2) % 3]
        for way in (1, -1):
            at = np.argwhere(filled & ~np.roll(filled, -way, axis)) - 1
            corner = at + (way > 0) * np.eye(3, dtype=int)[axis]
            ring = [corner, corner + u, corner + u + v, corner + v]
            quads.append(np.stack(ring if way > 0 else ring[::-1], axis=1))
    quads = np.concatenate(quads)
    points, number = meshes.distinct(quads.reshape(-1, 3))
    q = number.reshape(-1, 4)
    odd = (quads.sum((1, 2)) // 2 % 2 == 1)[:, None]
    triangles = np.where(np.c_[odd, odd, odd, odd, odd, odd], q[:, [0, 1, 2, 0, 2, 3]], q[:, [0, 1, 3, 1, 2, 3]]).reshape(-1, 3)
    return points / cell, triangles


@functools.lru_cache(maxsize=4)
def surface(name):
    """Points and triangles of a model, welded: one of its own, or one that is shipped."""
    if name == "goat":
        return goat()
    if name == "goat_coarse":
        return decimated(*goat(), 2400)
    if name.startswith("boxes"):
        return boxes(int(name[5:]))
    points, triangles, _ = meshes.weld(*meshes.arrays(meshes.read(meshes.DATA / "Models" / f"{name}.ply")))
    return points, triangles


def mesh_file(name, folder):
    """The model's file; one of its own is written into the folder."""
    shipped = meshes.DATA / "Models" / f"{name}.ply"
    if shipped.is_file():
        return shipped
    path = Path(folder) / f"{name}.ply"
    if not path.is_file():
        writer = vtkPLYWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(meshes.to_polydata(*surface(name)))
        writer.Write()
    return path


# ------------------------------------------------------------------------------------------------- limbs and lines

@functools.lru_cache(maxsize=None)
def seen(name, azimuth, perspective=False):
    """A view of a model, its limbs there, the best first, and display px of its points."""
    points, triangles = surface(name)
    a = np.radians(azimuth)
    view = picture.View.looking(points, (np.sin(a), 0.1, np.cos(a)), UP, perspective, 0.62)
    limbs, xy, _, _ = strokes.limbs_in(view, points, triangles)
    return view, limbs, xy


def limb_of(name, azimuth, way, number=0):
    """The view, and of the limbs whose tip looks a way the one of a number, from left to right."""
    view, limbs, _ = seen(name, azimuth)
    axis = {"up": (0, 1), "down": (0, -1), "left": (-1, 0), "right": (1, 0), "any": (0, 0)}[way]
    turned = [limb for limb in limbs if (limb["tip"] - limb["base"]) @ axis >= 0.6 * limb["length"] * (way != "any")]
    if not turned:
        raise RuntimeError(f"{name} has no limb that looks {way} at {azimuth} degrees")
    if way != "any":
        turned.sort(key=lambda limb: limb["tip"][0] if way in ("up", "down") else -limb["tip"][1])
    return view, turned[number % len(turned)]


def normal_of(line):
    """Outward of a limb's section, which has the model on its left."""
    tangent = np.gradient(line, axis=0)
    return np.c_[tangent[:, 1], -tangent[:, 0]] / np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-9)


def away(line, by):
    """Displaced outward, less and less towards its ends."""
    share = np.linspace(0, 1, len(line))
    return strokes.smooth(line + normal_of(strokes.smooth(line, 4.0)) * (by * strokes.ramp(np.minimum(share, 1 - share) / 0.15))[:, None], 2.0)


def axis_line(limb, begin, end):
    """Along the middle of a limb, between two shares of its length."""
    section = picture.resample(limb["section"], 1.0)
    share = np.linspace(0, 1, 60)
    tip = int(np.argmax(np.linalg.norm(section - limb["base"], axis=1)))
    one, two = section[:tip + 1], section[tip:][::-1]
    at = lambda side: np.array([np.interp(share, np.linspace(0, 1, len(side)), side[:, k]) for k in range(2)]).T
    middle = (at(one) + at(two)) / 2
    return strokes.smooth(picture.resample(middle[int(60 * begin):int(60 * end)], 2.0), 3.0)


def round_line(line, reach):
    """A ring about a line: what lies within a reach of its convex hull."""
    angle = np.linspace(0, 2 * np.pi, 181)
    way = np.c_[np.cos(angle), np.sin(angle)]
    return line[np.argmax(way @ line.T, axis=1)] + reach * way


def px_length(view):
    """The length of a pixel in an orthographic view."""
    return 2.0 / (view.height * view.projection[1, 1])


# --------------------------------------------------------------------------------------------- strokes of the systems

def put(folder, name, line, view, number=0):
    stroke_files.write(stroke_files.polydata(strokes.pen(line, number), view), Path(folder) / name)
    return name


def put_lines(folder, name, lines, view):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(Path(folder) / name))
    writer.SetInputData(lines_over.joined([picture.resample(line, 3.0) for line in lines], view))
    writer.Write()
    return name


def one_stroke(folder, name, model, view, line, **facts):
    """A case of one-stroke, whose stroke is the outline that is meant."""
    put(folder, f"{name}.vtp", line, view)
    return {"verb": "one-stroke", "inputs": ["MESH", f"{name}.vtp"], "model": model, "stroke": f"{name}.vtp", **facts}


def on_limb(change, **facts):
    """A situation of one-stroke: what is drawn in a limb's place."""
    def make(folder, name, model, azimuth, way, number):
        view, limb = limb_of(model, azimuth, way, number)
        return one_stroke(folder, name, model, view, change(limb), section=np.round(limb["section"], 1).tolist(), **facts)
    return make


def over_both(model, azimuth, way, number, gap):
    """A line round two limbs that stand beside each other: up the outer side of one, over both tips, down that of the other; and its view."""
    view, one = limb_of(model, azimuth, way, number)
    _, two = limb_of(model, azimuth, way, number + 1)
    left, right = (one, two) if one["tip"][0] < two["tip"][0] else (two, one)
    out = {"up": np.array([0, 1.0]), "down": np.array([0, -1.0])}[way]
    ends = [limb["section"][[0, -1]] for limb in (left, right)]
    corners = [min(ends[0], key=lambda p: p[0]), left["tip"] + gap * out, right["tip"] + gap * out, max(ends[1], key=lambda p: p[0])]
    return strokes.smooth(picture.resample(np.array(corners), 2.0), 8.0), view


def both_tips(folder, name, *which):
    line, view = over_both(*which, 15.0)
    return one_stroke(folder, name, which[0], view, line)


def outline_anew(change):
    """`augment --sketch silhouette` of what is drawn in a limb's place."""
    def make(folder, name, model, azimuth, way, number):
        view, limb = limb_of(model, azimuth, way, number)
        put(folder, f"{name}.vtp", change(limb), view)
        return {"verb": "augment", "inputs": ["MESH", f"{name}.vtp"], "options": ["--sketch", "silhouette"], "model": model,
                "stroke": f"{name}.vtp", "follows": 3.0}
    return make


def outline_over_two(folder, name, *which):
    """The same as a new outline."""
    line, view = over_both(*which, 15.0)
    put(folder, f"{name}.vtp", line, view)
    return {"verb": "augment", "inputs": ["MESH", f"{name}.vtp"], "options": ["--sketch", "silhouette"], "model": which[0]}


def dent(folder, name, model, azimuth, _way, _number):
    """A stretch of the outline drawn further in."""
    view, _, _ = seen(model, azimuth)
    points, triangles = surface(model)
    line, = lines_over.raised_outline(view, points, triangles)
    chord = np.linspace(0, 1, len(line))[:, None]
    flat = line[0] + (line[-1] - line[0]) * chord
    put(folder, f"{name}.vtp", flat - 0.6 * (line - flat), view)
    return {"verb": "augment", "inputs": ["MESH", f"{name}.vtp"], "options": ["--sketch", "silhouette"], "model": model,
            "stroke": f"{name}.vtp", "follows": 3.0}


def groove(folder, name, model, azimuth, way, number):
    """A line along a limb, carved twice as deep as the limb is wide."""
    view, limb = limb_of(model, azimuth, way, number)
    put_lines(folder, f"{name}.vtp", [axis_line(limb, 0.25, 0.75)], view)
    wide = limb["width"] * px_length(view)
    return {"verb": "augment", "inputs": ["MESH", f"{name}.vtp"], "model": model,
            "options": ["--radius", f"{0.4 * wide:.5f}", f"--height={-2 * wide:.5f}"]}


def over_two(folder, name, model, azimuth, way, number):
    """One line on the surface of two limbs and over the gap between."""
    view, one = limb_of(model, azimuth, way, number)
    _, two = limb_of(model, azimuth, way, number + 1)
    a, b = ((limb["base"] + limb["tip"]) / 2 for limb in (one, two))
    step = (b - a) / np.linalg.norm(b - a)
    put_lines(folder, f"{name}.vtp", [np.linspace(a - 0.3 * one["width"] * step, b + 0.3 * two["width"] * step, 50)], view)
    return {"verb": "augment", "inputs": ["MESH", f"{name}.vtp"], "model": model, "options": []}


def hatching(spacing, cross):
    """Parallel lines on a body, or such across each other, one by one."""
    def make(folder, name, model, azimuth, _way, _number):
        view, _, _ = seen(model, azimuth)
        points, triangles = surface(model)
        radius = 0.03 * np.linalg.norm(np.ptp(points, axis=0)) / px_length(view)
        centre, wide, _ = lines_over.room(view, points, triangles)
        along, t = 0.7 * wide, np.linspace(-1, 1, 30)[:, None]
        drawn = []
        for turn in ((25, 115) if cross else (25,)):
            a = np.array([np.cos(np.radians(turn)), np.sin(np.radians(turn))])
            side = np.array([-a[1], a[0]])
            drawn += [centre + along * t * a + k * spacing * radius * side for k in range(-2, 3)]
        put_lines(folder, f"{name}.vtp", drawn, view)
        return {"verb": "augment", "inputs": ["MESH", f"{name}.vtp"], "model": model, "options": ["--one-by-one"]}
    return make


def section(depth):
    """A cross-section drawn anew, so deep [of half the ring's width], along a limb."""
    def make(folder, name, model, azimuth, way, number):
        view, limb = limb_of(model, azimuth, way, number)
        line = axis_line(limb, 0.35, 0.65)
        put(folder, f"{name}-line.vtp", line, view)
        put(folder, f"{name}-ring.vtp", round_line(line, 0.3 * limb["width"]), view)
        text = f"0 0, 0.2 {0.5 * depth}, 0.35 {depth}, 0.65 {depth}, 0.8 {0.5 * depth}, 1 0"
        return {"verb": "edit", "inputs": ["MESH"], "model": model, "must not say": ["rag less far"],
                "options": ["--reference", f"@{name}-line.vtp", "--boundary", f"@{name}-ring.vtp", "--profile", text]}
    return make


def ring_beside(folder, name, model, azimuth, way, number):
    """A ring round a tip that reaches over the next limb's side."""
    view, limb = limb_of(model, azimuth, way, number)
    line = axis_line(limb, 0.55, 0.9)
    ring = round_line(line, 0.85 * limb["width"])
    put(folder, f"{name}-line.vtp", line, view)
    put(folder, f"{name}-ring.vtp", ring, view)
    wide = limb["width"] * px_length(view)
    return {"verb": "edit", "inputs": ["MESH"], "model": model, "ring": f"{name}-ring.vtp",
            "options": ["--reference", f"@{name}-line.vtp", "--boundary", f"@{name}-ring.vtp", "--move", f"0.5,n,{0.25 * wide:.5f}"]}


# -------------------------------------------------------------------------------------------------------- drawings

def ring_of(radius, waves=0, depth=0.0, turn=0.0, middle=(512, 512), count=160):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    r = radius * (1 + depth * np.cos(waves * angle + turn))
    return np.asarray(middle) + r[:, None] * np.c_[np.cos(angle), np.sin(angle)]


SHAPES = {"disc": ring_of(300), "blob": ring_of(300, 3, 0.18, 0.4), "flower": ring_of(300, 5, 0.25)}
CORNERED = {"ell": [(200, 200), (800, 200), (800, 450), (450, 450), (450, 800), (200, 800)],
            "plus": [(400, 200), (600, 200), (600, 400), (800, 400), (800, 600), (600, 600), (600, 800), (400, 800), (400, 600), (200, 600),
                     (200, 400), (400, 400)],
            "star": [tuple(512 + (380 if k % 2 == 0 else 170) * np.array([np.cos(k * np.pi / 5 + 0.3), np.sin(k * np.pi / 5 + 0.3)]))
                     for k in range(10)]}


def drawing(folder, name, lines, treatments=None, **facts):
    """A case of inflate: lines, each with whether it is closed."""
    cells = {"Treatment": np.array(treatments, np.int32)} if treatments else {}
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(Path(folder) / f"{name}.vtp"))
    writer.SetInputData(make_drawings.polydata(lines, CANVAS, cells, {}))
    writer.Write()
    return {"verb": "inflate", "inputs": [f"{name}.vtp"], "model": "", **facts}


def overshoot(folder, name, shape):
    """A ring that goes on 7 degrees past its start, 5 px beside it."""
    ring = SHAPES[shape]
    more = ring[:4] + 5 * normal_of(ring)[:4] * np.linspace(0.2, 1, 4)[:, None]
    return drawing(folder, name, [(np.vstack([ring, more]), False)], pieces=1, euler=2, outline=ring.tolist())


def island(folder, name, shape):
    ring, middle = SHAPES[shape], np.array([512, 512])
    lines = [middle + share * (ring - middle) for share in (1.0, 0.6, 0.25)]
    return drawing(folder, name, [(line, True) for line in lines], [0, HOLE, 0], pieces=2, euler=2)


def summit(folder, name, shape):
    return drawing(folder, name, [(SHAPES[shape], True)], pieces=1, euler=2, summit=True, outline=SHAPES[shape].tolist())


def near_rim(folder, name, shape):
    """A line of the drawing 5 px inside its rim."""
    ring = SHAPES[shape]
    inner = ring[10:60] - 5 * normal_of(ring)[10:60]
    return drawing(folder, name, [(ring, True), (inner, False)], pieces=1, euler=2, even=True)


def cornered(folder, name, shape):
    ring = picture.resample(np.array([*CORNERED[shape], CORNERED[shape][0]], float), 6.0)[:-1]
    return drawing(folder, name, [(ring, True)], pieces=1, euler=2, outline=ring.tolist(), notches=True)


def sticking_out(folder, name, shape):
    """A line over an object whose ends stick out, with --arrange."""
    ring = SHAPES[shape]
    bar = np.linspace((140, 540), (890, 500), 120)
    return drawing(folder, name, [(ring, True), (bar, False)], pieces=1, euler=2, options=["--arrange"], **{"must say": "sticks out"})


def missing(folder, name, share):
    """Heights of hills with single samples missing."""
    size, random = 97, np.random.RandomState(share)
    x, y = np.meshgrid(np.arange(size), np.arange(size))
    heights = 8 * np.sin(x / 13) * np.cos(y / 17) + 3 * np.sin((x + y) / 7)
    heights[random.uniform(size=heights.shape) < share / 100] = -9999
    rows = "\n".join(" ".join(f"{v:.4f}" for v in row) for row in heights)
    (Path(folder) / f"{name}.asc").write_text(
        f"ncols {size}\nnrows {size}\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n{rows}\n")
    return {"verb": "terrain", "inputs": [f"{name}.asc"], "model": "", "options": ["--quads", f"{size - 1}"],
            "triangles": 2 * (size - 1) ** 2}


# ------------------------------------------------------------------------------------------------------- all of them

LONGER = lambda share: lambda limb: strokes.displaced(limb, "lengthen", share)
BENT = lambda degrees: lambda limb: strokes.displaced(limb, "bend", degrees)
LIMBS = (("dog", 0, "down", 0), ("hand", 0, "up", 1), ("octopus", 0, "any", 0))
HORNS = (("goat", 90, "up", 0), ("goat_coarse", 90, "up", 1), ("goat", 60, "up", 0))
PAIRS = (("goat", 90, "up", 0), ("hand", 0, "up", 1), ("person", 0, "down", 0))
LEGS = (("dog", 0, "down", 0), ("bear", 0, "down", 0), ("person", 0, "down", 0))

SITUATIONS = {
    "horn_longer": (on_limb(LONGER(0.5), near=2.5), HORNS),
    "horn_crossed": (on_limb(lambda limb: away(limb["section"], -1.3 * limb["width"])), HORNS),
    "two_tips": (both_tips, PAIRS),
    "leg_beside": (on_limb(lambda limb: limb["section"] + (25.0, 0.0), near=4.0), LEGS),
    "leg_shorter": (on_limb(lambda limb: strokes.displaced(limb, "shorten", 0.28), near=2.5, left_over=0.02), LEGS),
    "limb_thrice": (on_limb(LONGER(1.2), near=2.5), (("octopus", 0, "any", 1), ("goat", 90, "up", 0), ("hand", 0, "up", 2))),
    "hard_edges": (on_limb(LONGER(0.5), near=4.0, sharp=True), (("boxes1", 12, "left", 0), ("boxes2", 12, "right", 0), ("boxes3", 0, "right", 0))),
    "deep_section": (section(-6.0), LIMBS),
    "steep_section": (section(1.2), LIMBS),
    "ring_beside": (ring_beside, (("hand", 0, "up", 1), ("hand", 0, "up", 2), ("goat", 90, "up", 0))),
    "deep_groove": (groove, LIMBS),
    "outline_two": (outline_over_two, PAIRS),
    "outline_tip": (outline_anew(LONGER(0.3)), LIMBS),
    "outline_bent": (outline_anew(BENT(24)), (("hand", 0, "up", 0), ("dog", 0, "up", 0), ("goat", 35, "up", 0))),
    "hatching": (hatching(0.7, False), (("dog", 0, "any", 0), ("bear", 0, "any", 0), ("goat_coarse", 0, "any", 0))),
    "cross_hatching": (hatching(0.7, True), (("dog", 0, "any", 0), ("bear", 0, "any", 0), ("goat_coarse", 0, "any", 0))),
    "dent": (dent, (("bear", 20, "any", 0), ("dog", 20, "any", 0), ("person", 20, "any", 0))),
    "line_over_two": (over_two, PAIRS),
    "overshoot": (overshoot, [(shape,) for shape in SHAPES]),
    "island": (island, [(shape,) for shape in SHAPES]),
    "summit": (summit, [(shape,) for shape in SHAPES]),
    "near_rim": (near_rim, [(shape,) for shape in SHAPES]),
    "concave_corners": (cornered, [(shape,) for shape in CORNERED]),
    "sticking_out": (sticking_out, [(shape,) for shape in SHAPES]),
    "missing_samples": (missing, [(2,), (5,), (10,)]),
}


def make_all(folder, day=None, only=()):
    """Writes all situations or a day's, and the index that the frame of the run reads."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    jobs = [(f"{name}-{'-'.join(str(word) for word in which)}", make, which) for name, (make, models) in SITUATIONS.items() for which in models]
    index = []
    for name, make, which in frame.tenth(jobs, day):
        if only and not any(part in name for part in only):
            continue
        case = make(folder, name, *which)
        mesh = str(mesh_file(case["model"], folder)) if case["model"] else ""
        (folder / f"{name}.json").write_text(json.dumps(case))
        index.append({"name": name, "mesh": mesh, "model": str(which[0]), "kind": name.split("-")[0], "projection": case["verb"]})
    (folder / "index.json").write_text(json.dumps(index, indent=1))
    return index


if __name__ == "__main__":
    print(len(make_all(sys.argv[1], None, sys.argv[2:])), "situations")
