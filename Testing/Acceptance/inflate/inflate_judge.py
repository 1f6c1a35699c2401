"""Judges an inflated drawing by two files and by nothing else: the drawing, and the mesh that was made of it. Distances, skeleton, heights and
rim are computed here anew. Lengths are px of the drawing, whose own view faces the plane z = 0.
"""
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

sys.path[:0] = [str(Path(__file__).resolve().parents[1])]
import judge as surface  # noqa: E402
import meshes  # noqa: E402  also puts Data into the path
import painting  # noqa: E402
import picture  # noqa: E402

HOLE = 1  # of the cell array Treatment
REACH = 18  # px: distances are told up to here
BODY, DEEP, DISC = 8.0, 12.0, 10  # px: T where surfaces must be smooth; where pits count; radius of the disc that closes them
LIMB, LIMB_PIXELS = (4.0, 15.0), 400  # T of a limb [px], and how many skeleton pixels make it one
# A pit counts off the row of triangles at the rim. There the surface rises by several px a px, which one flat triangle replaces by its chord,
# and round a corner that points inwards these chords lie apart: they alone were above the bound on all of the outlines, by up to 10 px, while
# the surface at the triangles' corners is what it should be. What they fill is told, as "rim pit", and no bound.
SLOPE, LEAST = 0.75, 3.0  # of the skeleton: a pixel from which T rises less, and which is that far inside

# What every result must be, and what a result is to reach by default; some outlines are harder.
SOUND = ("closed", "outward", "inverted", "chi")
BOUNDS = {"iou": 0.993, "worst": 4.0, "dihedral": 12.0, "pit": 2.5, "limb low": 0.93, "limb": (0.95, 1.3), "angle low": 10.0, "angle": 34.0}
HARDER = {"lobster": {"iou": 0.984, "angle low": 5.0, "angle": 30.0}, "dinosaur": {"iou": 0.984, "angle low": 5.0, "angle": 30.0},
          "kettle": {"worst": 7.0}, "seahorse": {"limb": (0.95, 1.5)}}
# The same without darts and without smoothing, c = 0; what is not named has no bound there.
PLAIN = {"iou": 0.985, "worst": 10.0, "dihedral": 65.0, "limb low": 0.9, "limb": (0.9, 1.3), "angle low": 2.0, "angle": 18.0}
PLAIN_HARDER = {"lobster": {"iou": 0.975}, "dinosaur": {"iou": 0.975}, "capybara": {"dihedral": 90.0}}
LIMBLESS = ("capybara",)  # its limbs are fur


class Drawing:
    """Strokes in their view: samples in px, closed strokes without their first point again."""

    def __init__(self, path):
        reader, ids = vtkXMLPolyDataReader(), vtkIdList()
        reader.SetFileName(str(path))
        reader.Update()
        strokes = reader.GetOutput()
        points, cells = vtk_to_numpy(strokes.GetPoints().GetData())[:, :2], strokes.GetCellData()
        self.loops = []
        for i in range(strokes.GetNumberOfCells()):
            strokes.GetCellPoints(i, ids)
            self.loops.append(points[[ids.GetId(k) for k in range(ids.GetNumberOfIds() - 1)]].astype(float))
        treatment = cells.GetArray("Treatment")
        self.holes = 0 if treatment is None else int((vtk_to_numpy(treatment) == HOLE).sum())
        values = [vtk_to_numpy(cells.GetArray(name))[0] for name in ("ViewTransform", "ProjectionTransform", "ViewportSize")]
        self.view = picture.View(values[0].reshape(4, 4), values[1].reshape(4, 4), *values[2])

    def place(self, points):
        """Points of the world in px: x and y of the picture, z from the plane towards the viewer."""
        return np.c_[self.view.display(points)[0], points[:, 2] * self.view.projection[0, 0] * self.view.width / 2]


def judge(drawing_file, mesh_file, outline="", plain=False):
    """All measures; `fails` names the bounds that do not hold, those of PLAIN where asked for; `holds` says whether all do."""
    drawing = Drawing(drawing_file)
    try:
        world, triangles = meshes.arrays(meshes.read(mesh_file))
    except RuntimeError:  # without points, or not of triangles
        world, triangles = (), ()
    if not len(triangles):
        return {"fails": ["no result"], "holds": False}
    points = drawing.place(world)
    result = {"triangles": len(triangles)}
    structure(points, triangles, drawing, result)
    front = points[triangles][:, :, 2].mean(1) > 0
    seam = rim(points, triangles, front, drawing, result)
    inside, depth = distances(drawing)
    planar(points, triangles, front, result)
    result["dihedral"] = roughness(points, triangles, depth)
    result["keel"] = keel(points, triangles, seam)
    height, inner = heights(points, triangles[front], drawing, ~np.isin(triangles[front], seam).any(1))
    deep, filled = inside & (depth >= DEEP), closed(height, DISC) - height
    result["pit"], result["rim pit"] = (float(filled[of].max(initial=0.0)) for of in (deep & inner, deep & ~inner))
    ratio = (height / np.maximum(depth, 1e-9))[skeleton(inside, depth) & (depth >= LIMB[0]) & (depth <= LIMB[1])]
    if len(ratio) >= LIMB_PIXELS and outline not in LIMBLESS:
        result["limb low"], result["limb"] = (float(v) for v in np.percentile(ratio, (5, 50)))
    result["fails"] = failing(result, outline, plain)
    result["holds"] = not result["fails"]
    return result


def failing(result, outline, plain=False):
    """The names of the bounds that do not hold."""
    bound = {**PLAIN, **PLAIN_HARDER.get(outline, {})} if plain else {**BOUNDS, **HARDER.get(outline, {})}
    holds = {"closed": lambda v: v == 0, "outward": lambda v: v > 0, "inverted": lambda v: v == 0, "chi": lambda v: v == result["chi wanted"],
             "limb": lambda v: bound["limb"][0] <= v <= bound["limb"][1]}
    holds.update({name: lambda v, b=bound.get(name): v <= b for name in ("worst", "dihedral", "pit")})
    holds.update({name: lambda v, b=bound.get(name): v >= b for name in ("iou", "limb low", "angle low", "angle")})
    return [name for name in (*SOUND, *bound) if name in result and not (np.isfinite(result[name]) and holds[name](result[name]))]


def structure(points, triangles, drawing, result):
    """How many edges and vertices keep it from being a closed manifold, wound alike; its volume; its Euler characteristic."""
    borders, crowded, fans = surface.topology(triangles)
    pairs = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    twice = len(pairs) - len(meshes.distinct(pairs)[0])  # neighbours that are wound against each other
    result["closed"] = borders + crowded + fans + twice
    a, b, c = (points[triangles[:, k]] for k in range(3))
    result["outward"] = float((a * np.cross(b, c)).sum() / 6)
    result["chi"] = len(np.unique(triangles)) - len(meshes.edges_of(triangles)[0]) + len(triangles)
    result["chi wanted"] = 2 - 2 * drawing.holes


def rim(points, triangles, front, drawing, result):
    """Where front and back meet, seen from the front, against the strokes; the points there."""
    pairs, count, edge = meshes.edges_of(triangles)
    sides = np.zeros((len(pairs), 2), int)
    np.add.at(sides, (edge.ravel(), np.repeat(front.astype(int), 3)), 1)
    seam = pairs[(count == 2) & (sides[:, 0] == 1) & (sides[:, 1] == 1)]
    loops = chained(seam)
    result["iou"], result["worst"] = 0.0, np.inf
    if not loops:
        return np.unique(seam)
    polygons = [points[loop, :2] for loop in loops]
    one, two = (area(shapes, drawing.view) for shapes in (polygons, drawing.loops))
    result["iou"] = float((one & two).sum() / (one | two).sum())
    result["worst"] = float(picture.distance_to(np.vstack(drawing.loops), [np.vstack([p, p[:1]]) for p in polygons])[0].max())
    return np.unique(seam)


def chained(edges):
    """The closed curves that edges make, as ids; none where one of them ends or forks."""
    if not len(edges) or not (np.unique(edges, return_counts=True)[1] == 2).all():
        return []
    beside = {}
    for a, b in edges.tolist():
        beside.setdefault(a, []).append(b)
        beside.setdefault(b, []).append(a)
    loops = []
    while beside:
        first = at = next(iter(beside))
        loop, before = [], None
        while not loop or at != first:
            loop.append(at)
            one, two = beside.pop(at)
            before, at = at, two if one == before else one
        loops.append(loop)
    return loops


def area(loops, view, fine=2):
    """What closed curves hold between them, even-odd, as a mask of `fine` samples a px and direction."""
    mask = np.zeros((view.height * fine, view.width * fine), bool)
    for loop in loops:
        mask ^= picture.inside_polygon(loop * fine, view.width * fine, view.height * fine)
    return mask


def distances(drawing):
    """The pixels inside the strokes, and T: how far their middles are from a stroke, at most REACH."""
    view, canvas = drawing.view, painting.Picture(drawing.view.width, drawing.view.height)
    inside = area(drawing.loops, view, 1)
    gap = np.minimum.reduce([canvas.away(np.vstack([loop, loop[:1]]), REACH, REACH) for loop in drawing.loops])
    return inside, np.where(inside, gap, 0.0)


def neighbours(values):
    """Of each pixel the eight around it, 0 beyond the border, and how far off they are."""
    padded = np.pad(values, 1)
    rows, columns = values.shape
    for y in (-1, 0, 1):
        for x in (-1, 0, 1):
            if x or y:
                yield padded[1 + y:1 + y + rows, 1 + x:1 + x + columns], np.hypot(x, y)


def skeleton(inside, depth):
    """The pixels from which T rises less than SLOPE, and its plain maxima."""
    slope, highest = np.full(depth.shape, -np.inf), np.zeros(depth.shape)
    for values, gap in neighbours(depth):
        np.maximum(slope, (values - depth) / gap, out=slope)
        np.maximum(highest, values, out=highest)
    return inside & (((depth >= LEAST) & (slope < SLOPE)) | (depth >= highest))


def planar(points, triangles, front, result):
    """Seen along z: triangles of front and back that are turned over or flat; the smallest angles [degrees] of the front's."""
    corner = points[triangles][:, :, :2]
    cross = lambda p, q: p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    whole = cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    result["inverted"] = int((np.where(front, whole, -whole) <= 0).sum())
    angles = []
    for k in range(3):
        p, q = (corner[front][:, (k + turn) % 3] - corner[front][:, k] for turn in (1, 2))
        angles.append(np.arctan2(np.abs(cross(p, q)), (p * q).sum(1)))
    least = np.degrees(np.min(angles, axis=0)) if front.any() else [0.0]
    result["angle low"], result["angle"] = (float(v) for v in np.percentile(least, (5, 50)))


def roughness(points, triangles, depth):
    """95th percentile of the angle between neighbours [degrees], over edges whose middles are BODY px inside."""
    angle, ends = surface.turns(points, triangles)
    rows, columns = depth.shape
    x, y = points[ends].mean(1)[:, :2].astype(int).T
    deep = depth[np.clip(y, 0, rows - 1), np.clip(x, 0, columns - 1)] >= BODY
    return float(np.percentile(angle[deep], 95)) if deep.any() else 0.0


def keel(points, triangles, rim):
    """The mean angle between faces across the edges of the rim over that across the edges beside it: those of triangles at the rim that do
    not end there."""
    angle, ends = surface.turns(points, triangles)
    there = np.isin(ends, rim).sum(1)
    known = np.sort(triangles[np.isin(triangles, rim).any(1)], axis=1)
    count = len(points)
    beside = np.isin(ends[:, 0] * count + ends[:, 1], np.concatenate([known[:, i] * count + known[:, j] for i, j in ((0, 1), (0, 2), (1, 2))]))
    across, along = angle[there == 2], angle[beside & (there == 0)]
    return float(across.mean() / along.mean()) if len(across) and len(along) and along.mean() > 0 else 0.0


def heights(points, front, drawing, inner):
    """The front's z at each pixel's middle, the highest where it has several, 0 beside it; which pixels some of the triangles cover that
    `inner` marks."""
    width, height = drawing.view.width, drawing.view.height
    pixel, t = picture.fragments(points[:, :2], front, width, height)
    at = np.c_[pixel % width + 0.5, pixel // width + 0.5]
    a, b, c = (points[front[t, k]] for k in range(3))
    cross = lambda p, q: p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    whole = cross((b - a)[:, :2], (c - a)[:, :2])
    whole = np.where(np.abs(whole) < 1e-12, 1e-12, whole)
    one, two = cross(b[:, :2] - at, c[:, :2] - at) / whole, cross(c[:, :2] - at, a[:, :2] - at) / whole
    weights = np.clip(np.c_[one, two, 1 - one - two], 0, 1)
    z = np.zeros(width * height)
    np.maximum.at(z, pixel, (weights * np.c_[a[:, 2], b[:, 2], c[:, 2]]).sum(1))
    covered = np.zeros(width * height, bool)
    covered[pixel[inner[t]]] = True
    return z.reshape(height, width), covered.reshape(height, width)


def widest(values, radius):
    """The greatest value in a disc round each pixel, 0 beyond the border."""
    rows, columns = values.shape
    padded = np.pad(values, radius)
    middle = slice(radius, radius + columns)
    row, wide = [padded[:, middle]], padded[:, middle]  # of the row's 2 x + 1 pixels
    for x in range(1, radius + 1):
        wide = np.maximum(wide, np.maximum(padded[:, radius + x:radius + x + columns], padded[:, radius - x:radius - x + columns]))
        row.append(wide)
    result = wide[radius:radius + rows].copy()
    for y in range(1, radius + 1):
        wide = row[int(np.sqrt(radius * radius - y * y))]
        for start in (radius + y, radius - y):
            np.maximum(result, wide[start:start + rows], out=result)
    return result


def closed(values, radius):
    """Values >= 0 with what is narrower than a disc filled."""
    result, top = np.zeros_like(values), values.max()
    if top > 0:  # nothing is filled farther off
        window = tuple(slice(max(0, at.min() - 2 * radius), at.max() + 2 * radius + 1) for at in np.nonzero(values))
        result[window] = top - widest(top - widest(values[window], radius), radius)
    return result
