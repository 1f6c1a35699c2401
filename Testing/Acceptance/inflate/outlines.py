"""The drawings of the acceptance run: fourteen outlines of the shared images and ten of our own, as a hand that wobbles draws them.

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
# Outlines of our own, whose ridges meet: by radius over the angle, and by limbs, which lead from a place and radius to the next; how far two
# of them run into each other. Units are px of the canvas before its longest side is made LONGEST.
POLAR = {"trefoil": (3, 0.45), "clover": (4, 0.3), "star": (5, 0.35), "daisy": (7, 0.22)}
LIMBS = {
    "flamingo": (20, [[(380, 380, 150), (560, 430, 120), (700, 480, 40)], [(320, 440, 70), (190, 600, 34), (260, 760, 30), (370, 800, 44), (440, 730, 16)],
                      [(400, 260, 40), (430, 20, 14)], [(480, 270, 36), (560, 40, 14)]]),
    "tiger": (12, [[(500, 480, 300)], [(260, 720, 90), (210, 820, 60)], [(740, 720, 90), (790, 820, 60)], [(380, 260, 110), (360, 200, 100)],
                   [(620, 260, 110), (640, 200, 100)]]),
    "palm": (10, [[(480, 280, 170), (500, 420, 180)], [(340, 480, 55), (270, 800, 42)], [(450, 520, 58), (430, 900, 44)],
                  [(560, 520, 58), (590, 880, 44)], [(650, 460, 52), (750, 740, 38)], [(340, 300, 70), (140, 470, 44)]]),
    "bough": (8, [[(500, 20, 70), (500, 420, 60)], [(500, 400, 58), (300, 620, 46), (280, 860, 30)], [(500, 420, 58), (700, 600, 44), (820, 820, 26)],
                  [(310, 610, 44), (120, 700, 24)], [(690, 590, 44), (620, 860, 28)]]),
    "squid": (15, [[(500, 620, 210), (500, 760, 150)], *[[(500 + 60 * k, 520, 60), (500 + 110 * k, 300, 40), (500 + 170 * k, 80 + 15 * k * k, 26)]
                                                       for k in (-2, -1, 0, 1, 2)]]),
    "snowman": (6, [[(500, 250, 230)], [(500, 600, 170)], [(500, 850, 110)], [(380, 640, 50), (120, 760, 30)], [(620, 640, 50), (880, 760, 30)]])}
OWN, OWN_WOBBLE, OWN_SEEDS = (*POLAR, *LIMBS), 1, 3
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


def limbs(name):
    """The field of an outline of limbs that run into each other, above 0 on the figure; by Quilez' polynomial smooth maximum."""
    blend, chains = LIMBS[name]
    at, result = np.indices((CANVAS + 16, CANVAS + 16))[::-1].transpose(1, 2, 0) - 8.0, None
    for chain in chains:
        near = np.full(at.shape[:2], -np.inf)
        for start, end in zip(chain, chain[1:] or chain):
            (a, r), (b, s) = ((np.array(place[:2], float), place[2]) for place in (start, end))
            along = np.clip((at - a) @ (b - a) / max((b - a) @ (b - a), 1e-9), 0, 1)
            near = np.maximum(near, r + (s - r) * along - np.linalg.norm(at - a - along[..., None] * (b - a), axis=2))
        between = 0 if result is None else np.maximum(blend - np.abs(result - near), 0) ** 2 / (4 * blend)
        result = near if result is None else np.maximum(result, near) + between
    return result


def own(name):
    """The boundary of an outline of our own."""
    if name in LIMBS:
        return contour(limbs(name))
    petals, depth = POLAR[name]
    angle = 2 * np.pi * np.arange(2000) / 2000
    return (1 + depth * np.cos(petals * angle))[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])


def curves(name):
    """The closed curves of an outline in px of the canvas: the boundary, and of the holed ones the hole."""
    if name in OWN:
        return fitted([own(name)])
    ink = field(name)
    outside = pieces(ink <= 0) == pieces(ink <= 0)[0, 0]
    figure = pieces(~outside) == 1  # filled, the largest piece
    loops = [contour(np.where(figure, np.where(ink > 0, ink, 55.0), np.minimum(ink, -1.0)))]
    if name in HOLED:
        gap = pieces(figure & (ink <= 0)) == 1
        loops.append(contour(np.where(gap, np.maximum(-ink, 0.5), np.minimum(-ink, -0.5))))
    return fitted(loops)


def fitted(loops):
    """Curves in the middle of the canvas, the first one's longest side LONGEST."""
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
    random = np.random.RandomState(10000 * [*sorted(OUTLINES), *OWN].index(name) + 100 * wobble + seed)
    samples = by_hand(curves(name), wobble, random)
    cells = {"Treatment": np.array([0, HOLE], np.int32)} if name in HOLED else {}
    return make_drawings.polydata([(line, True) for line in samples], (CANVAS, CANVAS), cells, {})


def name_of(outline, wobble, seed):
    return f"{outline}-{wobble}px-{seed}"


def make_all(folder, day=None):
    """Writes every drawing, or those of a day, and the index that the frame of the run reads; our own alone where the images are not here."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    index = []
    drawn = [(outline, wobble, seed) for outline in OUTLINES if IMAGES.is_dir() for wobble in WOBBLES for seed in range(SEEDS)]
    invented = [(outline, OWN_WOBBLE, seed) for outline in OWN for seed in range(OWN_SEEDS)]
    for outline, wobble, seed in frame.tenth(drawn, day) + frame.tenth(invented, day):
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(folder / (name_of(outline, wobble, seed) + ".vtp")))
        writer.SetInputData(drawing(outline, wobble, seed))
        writer.Write()
        index.append({"name": name_of(outline, wobble, seed), "mesh": outline, "model": outline, "projection": f"{wobble} px"})
    (folder / "index.json").write_text(json.dumps(index, indent=1))
    return index


if __name__ == "__main__":
    print(len(make_all(sys.argv[1])), "drawings")
