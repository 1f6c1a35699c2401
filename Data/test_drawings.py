"""The shipped drawings keep what README.md says of them."""
import json
import os
import sys

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import vtk_to_numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import drawings  # noqa: E402
import listing  # noqa: E402
import make_drawings  # noqa: E402
from painting import Picture, circle  # noqa: E402

FOLDER = os.path.join(HERE, "Drawings")
NAMES = sorted(drawings.DRAWINGS)
SHARED = {}


def drawing(name):
    """As its script makes it, once for all tests."""
    if name not in SHARED:
        SHARED[name] = drawings.DRAWINGS[name]()
    return SHARED[name]


def read(reader, *path):
    reader.SetFileName(os.path.join(*path))
    reader.Update()
    return reader.GetOutput()


def pixels(image):
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


def lines(strokes):
    """Ids of each stroke's points."""
    ids, found = vtk.vtkIdList(), []
    for i in range(strokes.GetNumberOfCells()):
        strokes.GetCellPoints(i, ids)
        found.append([ids.GetId(k) for k in range(ids.GetNumberOfIds())])
    return found


def shipped(name):
    """The strokes, and their samples by stroke."""
    strokes = read(vtk.vtkXMLPolyDataReader(), FOLDER, name + ".vtp")
    points = vtk_to_numpy(strokes.GetPoints().GetData())
    assert points.dtype == np.float64 and not points[:, 2].any()
    return strokes, [points[ids, :2] for ids in lines(strokes)]


def crossings(one, two=None):
    """Pairs of segments that cross, of a polyline with itself or another; neighbours touch, and the ends of a closed one."""
    own = two is None
    two = one if own else two
    a, b, c, d = (v[:, None] if k < 2 else v[None] for k, v in enumerate((one[:-1], one[1:], two[:-1], two[1:])))
    turn = lambda p, q, r: (q - p)[..., 0] * (r - p)[..., 1] - (q - p)[..., 1] * (r - p)[..., 0]
    cross = (turn(a, b, c) * turn(a, b, d) <= 0) & (turn(c, d, a) * turn(c, d, b) <= 0)
    if own:
        i, j = np.indices(cross.shape)
        gap = np.abs(i - j)
        cross &= (i < j) & (gap > 1) & ~((gap == len(one) - 2) & np.array_equal(one[0], one[-1]))
    return int(cross.sum())


def distance(points, curve):
    """Of each point from a closed curve."""
    a, along = curve, np.roll(curve, -1, axis=0) - curve
    square = np.maximum((along ** 2).sum(1), 1e-12)
    gaps = []
    for p in points:
        t = np.clip(((p - a) * along).sum(1) / square, 0, 1)
        gaps.append(np.linalg.norm(p - a - t[:, None] * along, axis=1).min())
    return np.array(gaps)


def test_what_is_shipped():
    assert sorted(os.listdir(FOLDER)) == sorted([name + end for name in NAMES for end in (".png", ".vtp")] + ["figure.json"])
    assert sum(os.path.getsize(os.path.join(FOLDER, file)) for file in os.listdir(FOLDER)) < 4e6
    assert [path.stem for path in listing.drawings()] == NAMES
    assert all(path.is_file() and path.with_suffix(".png").is_file() for path in listing.drawings())


def test_figure():
    """The parts' files are there, their matrices move alone, the head stands on the body and the hat on the head."""
    with open(os.path.join(FOLDER, "figure.json"), encoding="utf-8") as file:
        figure = json.load(file)
    assert figure == make_drawings.figure()
    boxes = []
    for part in figure["parts"]:
        assert sorted(part) == ["parameters", "picture", "placement", "strokes"]
        assert os.path.isfile(os.path.join(FOLDER, part["picture"]))
        place = np.array(part["placement"])
        assert place.shape == (4, 4) and np.array_equal(place[:3, :3], np.eye(3)) and np.array_equal(place[3], (0, 0, 0, 1))
        outline = shipped(os.path.splitext(part["strokes"])[0])[1][0] + place[:2, 3]
        boxes.append((outline.min(0), outline.max(0)))
    for below, above in zip(boxes, boxes[1:]):
        assert below[0][1] < above[0][1] < below[1][1] < above[1][1], "they overlap, each reaching higher"
        assert abs((below[0] + below[1] - above[0] - above[1])[0]) < 60, "one over the other"


@pytest.mark.parametrize("name", NAMES)
def test_strokes(name):
    strokes, samples = shipped(name)
    picture = read(vtk.vtkPNGReader(), FOLDER, name + ".png")
    width, height, _ = picture.GetDimensions()
    assert 512 <= max(width, height) <= 1024 and picture.GetNumberOfScalarComponents() == 3 and picture.GetScalarType() == vtk.VTK_UNSIGNED_CHAR
    made, cells = drawing(name).lines, strokes.GetCellData()
    assert strokes.GetNumberOfCells() == strokes.GetNumberOfLines() == len(made)
    time, pressure = (vtk_to_numpy(strokes.GetPointData().GetArray(k)) for k in ("Time", "Pressure"))
    assert pressure.dtype == np.float32 and pressure.min() >= 0 and pressure.max() <= 1
    used = []
    for i, (ids, points, line) in enumerate(zip(lines(strokes), samples, made)):
        # A closed stroke ends in its first point, which no other stroke has; a stroke's time begins at 0.
        assert (ids[0] == ids[-1]) == line.closed
        own = ids[:-1] if line.closed else ids
        assert len(set(own)) == len(own)
        used += own
        assert time[own[0]] == 0.0 and np.all(np.diff(time[own]) > 0)
        step = np.linalg.norm(np.diff(points, axis=0), axis=1)
        assert step.min() > 0.05 and step.max() < 9.0 and step.sum() > 40
        # It lies in its picture, in the picture's own view: the corners of the viewport are those of the rectangle.
        assert points.min() > 8 and np.all(points.max(axis=0) < (width - 8, height - 8))
        view, projection = (vtk_to_numpy(cells.GetArray(k))[i].reshape(4, 4) for k in ("ViewTransform", "ProjectionTransform"))
        assert np.array_equal(view[:3, :3], np.eye(3)) and np.array_equal(projection[3], (0, 0, 0, 1))
        assert cells.GetArray("ViewportSize").GetDataType() == vtk.VTK_INT
        assert [cells.GetArray("ViewportSize").GetComponent(i, k) for k in (0, 1)] == [width, height]
        corners = np.array([(-0.5, -0.5, 0, 1), (width - 0.5, height - 0.5, 0, 1)]) @ (projection @ view).T
        assert np.allclose(corners[:, :2], [(-1, -1), (1, 1)], atol=1e-12) and np.all(np.abs(corners[:, 2]) < 1)
    assert sorted(used) == list(range(strokes.GetNumberOfPoints()))
    # Nothing crosses: no boundary itself, no stroke another one, and all of them lie within the first.
    for i, points in enumerate(samples):
        assert crossings(points) == 0
        assert all(crossings(points, other) == 0 for other in samples[:i])
    canvas = Picture(width, height)
    inside = canvas._enclosed(samples[0][:-1])
    assert all(inside[int(y), int(x)] for points in samples[1:] for x, y in points)


@pytest.mark.parametrize("name", NAMES)
def test_what_the_strokes_say(name):
    """Treatments and snap radii stand in a file where they say something."""
    cells, made = shipped(name)[0].GetCellData(), drawing(name).lines
    for array, values in (("Treatment", [line.treatment for line in made]), ("Magnetic", [int(line.edge is not None) for line in made])):
        assert (cells.GetArray(array) is not None) == any(values)
        if any(values):
            assert cells.GetArray(array).GetDataType() == vtk.VTK_INT and list(vtk_to_numpy(cells.GetArray(array))) == values
    assert (cells.GetArray("SnapRadius") is None) == (cells.GetArray("Magnetic") is None)
    assert sorted(line.treatment for line in made if line.treatment) == {"mug": [1], "padlock": [1, 2]}.get(name, [])
    assert all(line.closed for line in made if line.treatment or line.edge is not None)


def test_magnetic_strokes_lie_beside_the_edge():
    """All along, by 3 to 6 px but for the pen, within the snap radius; and the picture has an edge there."""
    strokes, samples = shipped("heron")
    gray = pixels(read(vtk.vtkPNGReader(), FOLDER, "heron.png")) @ (0.299, 0.587, 0.114)
    for i, (points, line) in enumerate(zip(samples, drawing("heron").lines)):
        away = distance(points, line.edge)
        print(f"stroke {i}: {away.min():.2f} to {away.max():.2f} px, mean {away.mean():.2f}")
        assert 1.5 < away.min() and away.max() < 7.0 < strokes.GetCellData().GetArray("SnapRadius").GetValue(i)
        assert 4.0 < away.mean() < 5.0
        # Across the true edge the picture changes: 2 px outside against 2 px inside.
        along = np.roll(line.edge, -3, axis=0) - np.roll(line.edge, 3, axis=0)
        normal = np.column_stack([-along[:, 1], along[:, 0]]) / np.linalg.norm(along, axis=1, keepdims=True)
        at = lambda p: gray[tuple(np.floor(p).astype(int).T[::-1])]
        contrast = np.abs(at(line.edge + 2 * normal) - at(line.edge - 2 * normal))
        print(f"contrast: 5th percentile {np.percentile(contrast, 5):.0f}, median {np.median(contrast):.0f}")
        assert np.percentile(contrast, 5) > (60 if i == 0 else 15)


# ------------------------------------------------------------------------------------------------- the painter's own

def test_fields_are_distances():
    """Of a disc and of a capsule, inside and outside, from a curve of many points; and a contour lies on its disc."""
    p = Picture(200, 160)
    exact = 40.0 - np.hypot(p.x - 101.3, p.y - 77.7)
    disc = p.inside(circle((101.3, 77.7), 40.0, 2000))
    assert np.abs(disc - exact)[np.abs(exact) < 8].max() < 0.01 and np.abs(disc - exact).max() < 0.4
    tube = p.tube([(50, 80), (150, 80)], [10, 20])
    assert np.abs(tube[np.abs(p.x - 100.5) < 0.1] - (15.05 - np.abs(p.y[np.abs(p.x - 100.5) < 0.1] - 80))).max() < 1e-9
    ring = p.contours(exact)[0]
    assert np.abs(np.linalg.norm(ring - (101.3, 77.7), axis=1) - 40.0).max() < 0.01


def test_an_edge_is_one_pixel_soft():
    p = Picture(40, 20)
    p.paint((0, 0, 0), p.cover(20.0 - p.x))
    assert np.array_equal(p.rgb[10, 18:22, 0], [0.0, 0.0, 1.0, 1.0])
    p = Picture(40, 20)
    p.paint((0, 0, 0), p.cover(20.25 - p.x))
    assert np.allclose(p.rgb[10, 18:22, 0], [0.0, 0.0, 0.75, 1.0])
