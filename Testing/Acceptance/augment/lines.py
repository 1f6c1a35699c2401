"""Strokes of the augmentation's acceptance, made by rule: on each model the roomiest place of a view, through it a line, a sine
and a spiral, and a logo of strokes that cross; on three models outlines raised in four cameras.

    python3 lines.py FOLDER    writes the strokes (.vtp), terrains, index.json and contact sheets
"""
import json
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import frame  # noqa: E402
import meshes  # noqa: E402
import picture  # noqa: E402
import saved  # noqa: E402
import sheets  # noqa: E402
import stroke_files  # noqa: E402

# Model: from where it is looked at, what is up.
MODELS = {
    "bunny_5k.obj": ((0.3, 0.2, 1), (0, 1, 0)), "armadillo_29k.obj": ((0.2, 0.1, -1), (0, 1, 0)),
    "spot_5k9.obj": ((1, 0.25, -0.3), (0, 1, 0)), "cat.off": ((0.2, 0.1, 1), (0, 1, 0)), "man.ply": ((0.15, 0.1, 1), (0, 1, 0)),
    "hand_closed.obj": ((0, 0.1, 1), (0, 1, 0)), "torus.obj": ((0.2, 1, 0.4), (0, 0, -1)),
    "skull_genus2.off": ((0.4, 0.2, 1), (0, 1, 0)), "hand_open_wrist.off": ((0.1, 0, 1), (0, 1, 0)),
    "mountain_sheet.ply": ((0.3, 1, 0.5), (0, 1, 0)),
}
SKETCHED = {"cat.off": (0, 1, 0), "spot_5k9.obj": (0, 1, 0), "armadillo_29k.obj": (0, 1, 0)}
# Grid, quads along the longer side, samples' spacing in m (the first file gives it in degrees), heights drawn so many times too high.
TERRAINS = {"jacksboro_19": ("jacksboro_90m.asc", 19, (74.5, 92.8), 4), "jacksboro_67": ("jacksboro_90m.asc", 67, (74.5, 92.8), 4),
            "vancouver": ("vancouver_topobathy_2400m.asc", 0, (2430.0, 2430.0), 12)}
KINDS = ("line", "sine", "spiral", "logo")
SHAPES = [f"s{s} {side}" for s in ("0.3", "1", "1.5") for side in ("up", "down")]
MARGIN = 8.0  # px of the model's edge that lines keep from


def grid(name, spacing):
    """An ESRI grid as an image of one slice, its first row the highest in y; missing samples are NaN."""
    words = (meshes.SHARED / "terrain" / name).read_text().split()
    head = {}
    while words[2 * len(head)][0].isalpha():
        head[words[2 * len(head)].lower()] = float(words[2 * len(head) + 1])
    columns, rows = int(head["ncols"]), int(head["nrows"])
    heights = np.array(words[2 * len(head):], float).reshape(rows, columns)[::-1]
    heights[heights == head.get("nodata_value", np.nan)] = np.nan
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.SetSpacing(*spacing, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(heights.ravel()), deep=True))
    return image


def terrain(name, path):
    """The 4-8 mesh of a grid, so many quads along the longer side, as a file. Without the grid, so that what is measured is what the
    strokes make of a mesh, and not the relief between so few quads, which is as rough as it is."""
    from oversketch import vtkOversketchTerrain
    file, quads, spacing, scale = TERRAINS[name]
    made = vtkOversketchTerrain()
    made.SetInputData(grid(file, spacing))
    made.SetScale(scale)
    made.SetColumns(quads)
    made.SetRows(quads)
    made.Update()
    mesh = made.GetOutput()
    for array in ("TerrainGray", "TerrainRules"):
        mesh.GetFieldData().RemoveArray(array)
    saved.write(mesh, path)


# ------------------------------------------------------------------------------------------------- the strokes

def room(view, points, triangles):
    """(centre, radius) of a wide circle in what the model covers [px], and the loops of its outline."""
    xy, _ = view.display(points)
    loops = picture.outline(xy, triangles, 1.0)
    covered = picture.layers(xy, triangles) > 0
    row, column = np.nonzero(covered[::6, ::6])
    places = np.c_[column, row] * 6 + 0.5
    away = picture.distance_to(places, loops, np.inf)[0]
    best = int(np.argmax(away))
    return places[best], float(away[best]), loops


def run_of(line, centre, loops, mask):
    """The longest run of samples about the centre that stay on the model, off its edge."""
    ij = np.clip(np.round(line).astype(int), 0, (picture.WIDTH - 1, picture.HEIGHT - 1))
    ok = mask[ij[:, 1], ij[:, 0]] & (picture.distance_to(line, loops, np.inf)[0] > MARGIN)
    middle = int(np.argmin(np.linalg.norm(line - centre, axis=1) + 1e6 * ~ok))
    first = last = middle
    while first > 0 and ok[first - 1]:
        first -= 1
    while last + 1 < len(line) and ok[last + 1]:
        last += 1
    return line[first:last + 1]


def drawn(kind, view, points, triangles):
    """The polylines of a kind of stroke, a list of (n, 2) px."""
    centre, wide, loops = room(view, points, triangles)
    mask = picture.layers(view.display(points)[0], triangles) > 0
    t = np.linspace(-1, 1, 400)

    def axis(degrees):
        return np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])

    def along(degrees, wave=0.0):
        a = axis(degrees)
        across = np.array([-a[1], a[0]])
        length = 700.0
        return run_of(centre + length * t[:, None] * a + wave * np.sin(length * t / (0.35 * wide))[:, None] * across, centre, loops, mask)

    longest = max((15 + 30 * k for k in range(6)), key=lambda d: picture.lengths(along(d))[-1])
    if kind == "line":
        return [picture.resample(along(longest), 5.0)]
    if kind == "sine":
        best = max((longest + turn for turn in (-8, 0, 8)), key=lambda d: picture.lengths(along(d, 0.3 * wide))[-1])
        return [picture.resample(along(best, 0.3 * wide), 4.0)]
    if kind == "spiral":
        turn, reach = 2.5 * 2 * np.pi * (t + 1) / 2, wide * (0.12 + 0.78 * (t + 1) / 2)
        return [picture.resample(centre + np.c_[reach * np.cos(turn), reach * np.sin(turn)], 3.0)]
    angle = np.pi * t
    ring = centre + 0.6 * wide * np.c_[np.cos(angle), np.sin(angle)]
    bar = centre + 0.92 * wide * t[:, None] * axis(35)
    wave = centre + 0.92 * wide * t[:, None] * axis(125) + 0.3 * wide * np.sin(4 * t)[:, None] * axis(35)
    return [picture.resample(part, 4.0) for part in (ring, bar, wave)]


def raised_outline(view, points, triangles):
    """A stretch of the outline, straight and on the upper side and of one part of the model, and over it the stroke: 1.2 r outward in the middle."""
    xy, _ = view.display(points)
    loops = picture.outline(xy, triangles, 1.0)
    area = [0.5 * np.sum(l[:-1, 0] * l[1:, 1] - l[1:, 0] * l[:-1, 1]) for l in loops]
    outer = picture.resample(loops[int(np.argmax(area))], 2.0)[:-1]
    count, n = 55, len(outer)
    r_px = 0.03 * np.linalg.norm(np.ptp(points, axis=0)) * view.projection[1, 1] * view.height / 2
    r_px /= -view.display(points.mean(0)[None])[1][0] if view.perspective else 1.0
    depth = view.display(points)[1][[int(np.argmin(((xy - p) ** 2).sum(1))) for p in outer]]
    leap = np.abs(np.diff(depth, append=depth[:1])) > 0.05 * np.linalg.norm(np.ptp(points, axis=0))
    best, chosen = -np.inf, 0
    for k in range(0, n, 4):
        if leap[(k + np.arange(count)) % n].any():  # another part of the model begins
            continue
        part = outer[(k + np.arange(count)) % n]
        chord = part[-1] - part[0]
        straight = np.linalg.norm(chord) / picture.lengths(part)[-1]
        up = -chord[0] / np.linalg.norm(chord)  # the area is on the left, so its top runs to the left
        merit = straight + 0.2 * min(up, 0.5)
        if merit > best:
            best, chosen = merit, k
    part = outer[(chosen + np.arange(count)) % n]
    kernel = np.ones(9) / 9
    inner = np.c_[np.convolve(part[:, 0], kernel, "valid"), np.convolve(part[:, 1], kernel, "valid")]
    tangent = np.gradient(inner, axis=0)
    outward = np.c_[tangent[:, 1], -tangent[:, 0]] / np.linalg.norm(tangent, axis=1, keepdims=True)
    s = np.linspace(0, np.pi, len(inner))
    return [inner + outward * (1.2 * r_px * np.sin(s) - 1.5)[:, None]]


def joined(lines, view):
    append = vtkAppendPolyData()
    for line in lines:
        append.AddInputData(stroke_files.polydata(line, view))
    append.Update()
    return append.GetOutput()


def _make_for_model(job):
    folder, number, name, path, direction, up, sketched = job
    points, triangles, _ = meshes.weld(*meshes.arrays(meshes.read(path)))
    entries = []

    def add(kind, lines, view, cases):
        entry = {"name": f"{name}-{kind}", "model": name, "mesh": str(path), "kind": kind, "cases": cases,
                 "projection": "perspective" if view.perspective else "orthographic"}
        saved.write(joined(lines, view), folder / f"{entry['name']}.vtp")
        entries.append(entry)

    if sketched:
        for k in range(4):
            turn = np.radians(90 * k + 20)
            view = picture.View.looking(points, (np.sin(turn), 0.15, np.cos(turn)), up, k % 2 == 1, 0.8)
            add(f"outline{k + 1}", raised_outline(view, points, triangles), view, ["sketch"])
        return entries
    for k, kind in enumerate(KINDS):
        view = picture.View.looking(points, direction, up, (number + k) % 2 == 1, 0.85)
        steep = ["s1.5 h=r"] if name == "jacksboro_19" else []
        add(kind, drawn(kind, view, points, triangles), view, SHAPES + steep)
    return entries


def make_all(folder, day=None, workers=2):
    """Writes all strokes or a day's, terrains and an index; returns the index."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    jobs = []
    for number, (file, (direction, up)) in enumerate(MODELS.items()):
        jobs.append((folder, number, Path(file).stem, meshes.SHARED / "meshes" / file, direction, up, False))
    for name, values in TERRAINS.items():
        path = folder / f"{name}-mesh.vtp"
        if (meshes.SHARED / "terrain" / values[0]).is_file():
            terrain(name, path)
        jobs.append((folder, len(jobs), name, path, (0.1, -0.5, 1), (0, 1, 0), False))
    for file, up in SKETCHED.items():
        jobs.append((folder, len(jobs), Path(file).stem, meshes.SHARED / "meshes" / file, (0, 0, 1), up, True))
    jobs = frame.tenth([job for job in jobs if job[3].is_file()], day)
    with ProcessPoolExecutor(workers) as pool:
        index = [entry for entries in pool.map(_make_for_model, jobs) for entry in entries]
    (folder / "index.json").write_text(json.dumps(index, indent=1))
    return index


def main():
    folder = Path(sys.argv[1])
    pictures = []
    for entry in make_all(folder):
        stroke, _, view, _ = stroke_files.read(folder / f"{entry['name']}.vtp")
        points, triangles, _ = meshes.weld(*meshes.arrays(meshes.read(entry["mesh"])))
        image = picture.shaded(view, points, triangles, scale=1)
        for line in polylines(stroke):
            picture.draw(image, line, picture.RED)
        image = picture.halve(image)
        picture.write_text(image, entry["name"], 6, 6, 13)
        pictures.append(image)
    sheets.write(pictures, folder / "sheet", columns=4, rows=4)


def polylines(stroke):
    """Each line of a stroke file as (n, 2) px."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    points = vtk_to_numpy(stroke.GetPoints().GetData())[:, :2].astype(float)
    offsets = vtk_to_numpy(stroke.GetLines().GetOffsetsArray())
    return [points[ids] for ids in np.split(vtk_to_numpy(stroke.GetLines().GetConnectivityArray()), offsets[1:-1])]


if __name__ == "__main__":
    main()
