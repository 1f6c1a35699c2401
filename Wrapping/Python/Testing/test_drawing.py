"""drawing(lines, image): strokes over a picture, through the filters that take them."""
import math
import os
import pathlib

import numpy
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import oversketch

DRAWINGS = pathlib.Path(os.environ["OVERSKETCH_SOURCE"]) / "Data" / "Drawings"


def ring(x, y, radius, count=80, share=1.0):
    angles = numpy.arange(count) * (2 * math.pi * share / count)
    return numpy.column_stack([x + radius * numpy.cos(angles), y + radius * numpy.sin(angles)])


def picture(columns, rows, origin=(0.0, 0.0), spacing=(1.0, 1.0)):
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.SetOrigin(*origin, 7.0)
    image.SetSpacing(*spacing, 1.0)
    return image


def curves_of(drawing, image=None):
    canvas = oversketch.vtkOversketchCanvas()
    canvas.SetInputData(drawing)
    if image is not None:
        canvas.SetPictureData(image)
    return oversketch.update(canvas)


def values(data, name):
    array = data.GetArray(name)
    return [array.GetTuple(i) if array.GetNumberOfComponents() > 1 else array.GetValue(i) for i in range(array.GetNumberOfTuples())]


def test_pixels_of_the_picture_are_places_in_the_world():
    image = picture(40, 20, origin=(-3.0, 5.0), spacing=(0.5, 2.0))
    drawing = oversketch.drawing([[(0.5, 0.5), (39.5, 19.5)], [(0, 0), (40, 20), (40, 0)]], image)
    curves = curves_of(drawing, image)
    assert numpy.allclose(curves.GetPoint(0), (-3.0, 5.0, 0.0), atol=1e-12)
    assert numpy.allclose(curves.GetPoint(1), (-3.0 + 39 * 0.5, 5.0 + 19 * 2.0, 0.0), atol=1e-12)
    assert numpy.allclose(curves.GetPoint(2), (-3.25, 4.0, 0.0), atol=1e-12)
    assert values(curves.GetFieldData(), "Canvas") == [(-3.25, 4.0, 20.0, 40.0)]
    # The drawing says it itself; the samples of a part of a picture lie where they lay.
    assert values(curves_of(drawing).GetFieldData(), "Canvas") == [(-3.25, 4.0, 20.0, 40.0)]
    image.SetExtent(10, 49, -5, 14, 0, 0)
    moved = curves_of(oversketch.drawing([[(0.5, 0.5), (1, 1)]], image), image)
    assert numpy.allclose(moved.GetPoint(0), (2.0, -5.0, 0.0), atol=1e-12)


def test_a_bare_size_is_a_picture_as_it_is_read_from_a_file():
    curves = curves_of(oversketch.drawing([[(0.5, 0.5), (9, 9)]], (640, 480)))
    assert values(curves.GetFieldData(), "Canvas") == [(-0.5, -0.5, 640.0, 480.0)]
    assert numpy.allclose(curves.GetPoint(0), (0.0, 0.0, 0.0), atol=1e-10)


@pytest.mark.parametrize("closed, expected", [
    (None, [1, 0, 0]), (True, [1, 1, 1]), (False, [0, 0, 0]), ([None, True, None], [1, 1, 0]), ([False, None, True], [0, 0, 1])])
def test_strokes_are_closed_as_said_else_by_their_ends(closed, expected):
    lines = [ring(50, 50, 20, 120), ring(50, 50, 40, share=0.6), ring(20, 20, 10, share=0.5)]
    drawing = oversketch.drawing(lines, (100, 100), closed=closed)
    assert drawing.GetNumberOfLines() == 3
    assert values(curves_of(drawing).GetCellData(), "Closed") == expected


def test_a_drawing_becomes_objects_and_distances():
    image = picture(200, 200)
    lines = [ring(100, 100, 80), ring(100, 100, 30), [(60, 150), (90, 160), (120, 150)]]
    canvas = oversketch.vtkOversketchCanvas()
    canvas.SetInputData(oversketch.drawing(lines, image, closed=[True, True, False]))
    canvas.SetPictureData(image)
    steps = [canvas] + [getattr(oversketch, "vtkOversketch" + name)() for name in ("Resample", "Classify", "Treatment", "Distance")]
    for before, after in zip(steps, steps[1:]):
        after.SetInputConnection(before.GetOutputPort())
    steps[3].SetHoles("1")
    curves = oversketch.update(steps[-1])
    assert values(curves.GetCellData(), "Role") == [1, 2, 3]
    assert values(curves.GetCellData(), "Treatment") == [0, 1, 0]
    assert steps[2].GetLabelsOutput().GetDimensions() == (1028, 1028, 1)
    deepest = steps[-1].GetDistanceOutput().GetPointData().GetArray("T").GetRange()[1]
    assert abs(deepest - 25 * 1024 / 200) < 2  # half of the ring of 50 px between both


def test_strokes_say_where_their_bodies_lie():
    lines = [ring(100, 100, 80), ring(130, 110, 25)]
    drawing = oversketch.drawing(lines, (200, 200), closed=True, depth=[0, 3], height=[0, 0.5], cross_section=[0, 2])
    assert [values(drawing.GetCellData(), name) for name in ("Depth", "Height", "CrossSection")] == [[0, 3], [0.0, 0.5], [0, 2]]
    system = oversketch.vtkOversketchInflateDrawing()
    system.SetInputDataObject(0, drawing)
    mesh = oversketch.update(system)
    assert set(values(mesh.GetCellData(), "LayerId")) == {0, 1} and mesh.GetBounds()[4] == -mesh.GetBounds()[5]
    assert system.GetLayer(1).GetInnerOutput("Refine").GetNumberOfPolys() > 100 and system.GetLayer(2) is None
    with pytest.raises(ValueError, match="Depth must be one number of each of 2 lines"):
        oversketch.drawing(lines, (200, 200), depth=[1])


@pytest.mark.parametrize("lines, image, closed, words", [
    ([], (9, 9), None, "no line"),
    ([[(1, 2)]], (9, 9), None, r"line 0 must have shape \(n, 2\)"),
    ([[(1, 2, 3), (4, 5, 6)]], (9, 9), None, "line 0 must have shape"),
    ([[(1, 2), (3, 4)]], (0, 9), None, "two positive numbers of pixels"),
    ([[(1, 2), (3, 4)]], (9, 9), [True, False], "of each of 1 lines, not of 2"),
    ([[(1, 2), (3, 4)]], vtkImageData(), None, "one slice across z"),
    ([[(1, 2), (3, 4)]], picture(9, 9, spacing=(1.0, -1.0)), None, "spacing must be positive"),
])
def test_what_is_no_drawing_is_refused(lines, image, closed, words):
    with pytest.raises(ValueError, match=words):
        oversketch.drawing(lines, image, closed=closed)


def bits(mesh):
    faces = mesh.GetPolys()
    return [vtk_to_numpy(data).tobytes() for data in (mesh.GetPoints().GetData(), faces.GetOffsetsArray(), faces.GetConnectivityArray())]


@pytest.mark.parametrize("pictured", [False, True], ids=["without a picture", "with pictures"])
def test_for_each_makes_of_drawings_what_the_system_makes_of_each(pictured):
    def read(reader, name):
        reader.SetFileName(str(DRAWINGS / name))
        return oversketch.update(reader)

    names = ("mug", "leaf")
    drawings = [read(vtkXMLPolyDataReader(), name + ".vtp") for name in names]
    pictures = [read(vtkPNGReader(), name + ".png") for name in names]
    collection, images = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
    for i in range(2):
        collection.SetBlock(i, drawings[i])
        images.SetBlock(i, pictures[i])
    system = oversketch.vtkOversketchInflateDrawing()
    system.SetLevels(2)
    each = oversketch.vtkOversketchForEach()
    each.SetFilter(system)
    each.SetInputDataObject(0, collection)
    if pictured:
        each.SetInputDataObject(1, images)
    made = oversketch.update(each)
    assert each.GetNumberOfFailures() == 0 and made.GetNumberOfBlocks() == 2
    for i in range(2):
        alone = oversketch.vtkOversketchInflateDrawing()
        alone.SetLevels(2)
        alone.SetInputData(0, drawings[i])
        if pictured:
            alone.SetInputData(1, pictures[i])
        alone = oversketch.update(alone)
        assert alone.GetNumberOfPolys() > 1000 and bits(made.GetBlock(i)) == bits(alone), names[i]
    assert bits(made.GetBlock(0)) != bits(made.GetBlock(1))
