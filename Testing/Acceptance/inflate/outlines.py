"""The drawings of the acceptance run: fourteen outlines of the shared images, as a hand that wobbles draws them.

    outlines.py FOLDER      writes FOLDER/<outline>-<wobble>px-<seed>.vtp, all of them, and FOLDER/index.json

The outline of a cut-out is where its alpha passes 127, of the others where the grey passes 200, found to parts of a pixel by linear
interpolation; only the largest piece counts, filled. Crane, kettle and mushroom have their largest gap as a hole. Scaled so that the longest
side takes 1000 of 1024 px, displaced across itself by smooth noise of a given root mean square, whose values 20 px apart correlate by 1/e,
and sampled 2 to 12 px apart at random; where a displaced line would cross itself or another it is displaced less.
"""
import json
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkStripper
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.vtkImagingMorphological import vtkImageConnectivityFilter

sys.path[:0] = [str(Path(__file__).resolve().parents[1])]
import frame  # noqa: E402
import meshes  # noqa: E402  also puts Data into the path
import make_drawings  # noqa: E402
import stroke_files  # noqa: E402

IMAGES = meshes.SHARED / "images"
OUTLINES = {
    "blackbuck": "cutout_blackbuck", "capybara": "cutout_capybara", "crane": "cutout_crane", "kettle": "cutout_kettle_handle",
    "lobster": "cutout_lobster", "mushroom": "cutout_mushrooms_gap", "seahorse": "cutout_seahorse", "dog": "drawing_dog_straight_lines",
    "angelfish": "drawing_angelfish", "elephant": "lineart_elephant", "dinosaur": "lineart_dinosaur", "camel": "silhouette_camel",
    "horse": "silhouette_horse", "kangaroo": "silhouette_kangaroo"}
HOLED = ("crane", "kettle", "mushroom")
CLOSED = {"dinosaur": 4}  # px by which gaps in the line are closed first
CANVAS, LONGEST = 1024, 1000  # px
WOBBLES, SEEDS = (0, 1, 2), 5
GAPS = (2.0, 12.0)  # px between samples
HOLE = 1  # of the cell array Treatment


# -------------------------------------------------------------------------------------------------- from the image

def pieces(mask):
    """The pieces of a mask by number from 1, pixels joined by their sides; 0 outside."""
    image, label = vtkImageData(), vtkImageConnectivityFilter()
    image.SetDimensions(mask.shape[1], mask.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(mask.astype(np.uint8).ravel(), deep=True))
    label.SetInputData(image)
    label.SetScalarRange(1, 1)
    label.SetLabelModeToSizeRank()
    label.SetExtractionModeToAllRegions()
    label.SetLabelScalarTypeToInt()
    label.Update()
    return vtk_to_numpy(label.GetOutput().GetPointData().GetScalars()).reshape(mask.shape)


def grown(mask, radius):
    """A mask and what lies within a radius of it."""
    result = mask.copy()
    for y in range(-radius, radius + 1):
        for x in range(-radius, radius + 1):
            if x * x + y * y <= radius * radius:
                result |= np.roll(mask, (y, x), axis=(0, 1))
    return result


def field(name):
    """The image as numbers above 0 on the figure, row 0 at the bottom, in a margin of 8 px."""
    reader = vtkPNGReader()
    reader.SetFileName(str(IMAGES / (OUTLINES[name] + ".png")))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1).astype(float)
    if OUTLINES[name].startswith("cutout"):
        ink = values[:, :, 3] - 127.5
    else:
        opaque = values[:, :, 3:] / 255.0 if values.shape[2] in (2, 4) else 1.0
        paper = values[:, :, :3 if values.shape[2] > 2 else 1] * opaque + 255.0 * (1.0 - opaque)
        ink = 199.5 - paper @ ((0.299, 0.587, 0.114) if paper.shape[2] == 3 else (1.0,))
    ink = np.pad(ink, 8, constant_values=-55.0)
    if name in CLOSED:
        closed = ~grown(~grown(ink > 0, CLOSED[name]), CLOSED[name])
        ink[closed & (ink <= 0)] = 55.0
    return ink


def contour(values):
    """The longest closed curve on which a field is 0; its first point stands once."""
    image, lines, strip, ids = vtkImageData(), vtkContourFilter(), vtkStripper(), vtkIdList()
    image.SetDimensions(values.shape[1], values.shape[0], 1)
    image.SetOrigin(0.5, 0.5, 0.0)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(values, float).ravel(), deep=True))
    lines.SetInputData(image)
    lines.SetValue(0, 0.0)
    strip.SetInputConnection(lines.GetOutputPort())
    strip.SetMaximumLength(10 ** 6)
    strip.Update()
    points, loops = vtk_to_numpy(strip.GetOutput().GetPoints().GetData())[:, :2].astype(float), []
    for i in range(strip.GetOutput().GetNumberOfCells()):
        strip.GetOutput().GetCellPoints(i, ids)
        loops.append(points[[ids.GetId(k) for k in range(ids.GetNumberOfIds() - 1)]])
    return max(loops, key=around)


def around(loop):
    return np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1).sum()


def curves(name):
    """The closed curves of an outline in px of the canvas: the boundary, and of the holed ones the hole."""
    ink = field(name)
    outside = pieces(ink <= 0) == pieces(ink <= 0)[0, 0]
    figure = pieces(~outside) == 1  # filled, the largest piece
    loops = [contour(np.where(figure, np.where(ink > 0, ink, 55.0), np.minimum(ink, -1.0)))]
    if name in HOLED:
        gap = pieces(figure & (ink <= 0)) == 1
        loops.append(contour(np.where(gap, np.maximum(-ink, 0.5), np.minimum(-ink, -0.5))))
    low, high = loops[0].min(0), loops[0].max(0)
    scale = LONGEST / (high - low).max()
    return [(loop - (low + high) / 2) * scale + CANVAS / 2 for loop in loops]


# ---------------------------------------------------------------------------------------------------- by hand

def even(loop):
    """A closed curve by points about 1 px apart."""
    path = np.vstack([loop, loop[:1]])
    along = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    at = np.arange(int(along[-1])) * along[-1] / int(along[-1])
    return np.column_stack([np.interp(at, along, path[:, k]) for k in (0, 1)])


def crossing(loops):
    """Of closed polylines, (curve, segment) of every segment that meets one which is not its neighbour."""
    a = np.vstack(loops)
    b = np.vstack([np.roll(loop, -1, axis=0) for loop in loops])
    curve = np.repeat(np.arange(len(loops)), [len(loop) for loop in loops])
    number = np.concatenate([np.arange(len(loop)) for loop in loops])
    order = np.argsort(np.minimum(a[:, 0], b[:, 0]), kind="stable")
    left, right = np.minimum(a[:, 0], b[:, 0])[order], np.maximum(a[:, 0], b[:, 0])[order]
    last = np.searchsorted(left, right, "right")  # those that begin before this one ends
    count = last - np.arange(len(order)) - 1
    first = np.repeat(np.arange(len(order)), count)
    second = first + 1 + np.arange(len(first)) - np.repeat(np.cumsum(count) - count, count)
    i, j = order[first], order[second]
    size = np.array([len(loop) for loop in loops])[curve[i]]
    apart = np.abs(number[i] - number[j])
    keep = (curve[i] != curve[j]) | ((apart > 1) & (apart < size - 1))
    keep &= (np.minimum(a[i, 1], b[i, 1]) <= np.maximum(a[j, 1], b[j, 1])) & (np.minimum(a[j, 1], b[j, 1]) <= np.maximum(a[i, 1], b[i, 1]))
    i, j = i[keep], j[keep]
    turn = lambda p, q, r: (q - p)[:, 0] * (r - p)[:, 1] - (q - p)[:, 1] * (r - p)[:, 0]
    meet = (turn(a[i], b[i], a[j]) * turn(a[i], b[i], b[j]) <= 0) & (turn(a[j], b[j], a[i]) * turn(a[j], b[j], b[i]) <= 0)
    both = np.unique(np.r_[i[meet], j[meet]])
    return [(int(curve[k]), int(number[k])) for k in both]


def by_hand(loops, wobble, random):
    """The samples of closed curves, as a hand draws them; they cross nothing."""
    courses = [even(loop) for loop in loops]
    normals, displaced, places = [], [], []
    for course in courses:
        tangent = np.roll(course, -3, axis=0) - np.roll(course, 3, axis=0)
        normals.append(np.column_stack([-tangent[:, 1], tangent[:, 0]]) / np.maximum(np.linalg.norm(tangent, axis=1), 1e-9)[:, None])
        displaced.append(wobble * stroke_files.noise(len(course), random))
        at = np.cumsum(random.uniform(*GAPS, len(course)))
        places.append(at[at < len(course) - GAPS[0]])
    for _ in range(60):
        lines = [course + amount[:, None] * normal for course, amount, normal in zip(courses, displaced, normals)]
        samples = [np.column_stack([np.interp(at, np.arange(len(line) + 1), np.r_[line[:, k], line[:1, k]]) for k in (0, 1)])
                   for line, at in zip(lines, places)]
        faults = crossing(samples)
        if not faults:
            return samples
        # There the hand is steadier, and slower.
        more = [[] for _ in samples]
        for curve, k in faults:
            start, end = places[curve][k], places[curve][(k + 1) % len(places[curve])]
            end += len(courses[curve]) if end <= start else 0.0
            near = np.arange(int(start) - 10, int(end) + 11) % len(courses[curve])
            displaced[curve][near] *= 0.5
            if end - start > 1.0:
                more[curve].append(((start + end) / 2) % len(courses[curve]))
        places = [np.unique(np.r_[at, added]) for at, added in zip(places, more)]
    raise RuntimeError("a line crosses another even without wobble")


def drawing(name, wobble, seed):
    """One of the drawings, a polydata."""
    random = np.random.RandomState(10000 * sorted(OUTLINES).index(name) + 100 * wobble + seed)
    samples = by_hand(curves(name), wobble, random)
    cells = {"Treatment": np.array([0, HOLE], np.int32)} if name in HOLED else {}
    return make_drawings.polydata([(line, True) for line in samples], (CANVAS, CANVAS), cells, {})


def name_of(outline, wobble, seed):
    return f"{outline}-{wobble}px-{seed}"


def make_all(folder, day=None):
    """Writes every drawing, or those of a day, and the index that the frame of the run reads; none where the images are not here."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    index = []
    all_of_them = [(outline, wobble, seed) for outline in OUTLINES for wobble in WOBBLES for seed in range(SEEDS)]
    for outline, wobble, seed in frame.tenth(all_of_them, day) if IMAGES.is_dir() else ():
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(folder / (name_of(outline, wobble, seed) + ".vtp")))
        writer.SetInputData(drawing(outline, wobble, seed))
        writer.Write()
        index.append({"name": name_of(outline, wobble, seed), "mesh": outline, "model": outline, "projection": f"{wobble} px"})
    (folder / "index.json").write_text(json.dumps(index, indent=1))
    return index


if __name__ == "__main__":
    print(len(make_all(sys.argv[1])), "drawings")
