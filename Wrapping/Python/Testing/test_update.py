"""What is Python's own: update() raises with the filter's message, stroke() makes a stroke of an array."""
import os
import pathlib

import numpy
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkCamera

import oversketch

DATA = pathlib.Path(os.environ["OVERSKETCH_SOURCE"]) / "Data"


def mesh():
    reader = vtkPLYReader()
    reader.SetFileName(str(DATA / "Models" / "dog.ply"))
    return reader


def drawn():
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(DATA / "Strokes" / "dog_longer_leg.vtp"))
    return reader


def system(stroke=None):
    filter, model, stroke = oversketch.vtkOversketchOneStroke(), mesh(), stroke or drawn()
    filter.SetRemeshToOff()
    filter.SetInputConnection(0, model.GetOutputPort())
    filter.SetInputConnection(1, stroke.GetOutputPort())
    return filter


def points(polydata):
    return vtk_to_numpy(polydata.GetPoints().GetData())


def polydata(places, triangles):
    """A mesh of two arrays, (n, 3) and (m, 3)."""
    result, vertices, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    vertices.SetData(numpy_to_vtk(places, deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.astype(numpy.int64).ravel(), deep=True))
    result.SetPoints(vertices)
    result.SetPolys(cells)
    return result


def test_the_output_of_a_good_run_is_returned():
    filter = system()
    output = oversketch.update(filter)
    assert output is filter.GetOutput()
    before = oversketch.update(mesh())
    assert output.GetNumberOfPoints() == before.GetNumberOfPoints()
    moved = numpy.any(points(output) != points(before), axis=1)
    assert 100 < moved.sum() < 0.5 * len(moved)


def test_the_output_of_another_port_is_returned():
    box = oversketch.vtkOversketchOneStroke()
    with pytest.raises(Exception):
        oversketch.update(box, 7)


def refuse(filter):
    with pytest.raises(oversketch.FilterError) as caught:
        oversketch.update(filter)
    assert str(caught.value) == "\n".join(caught.value.messages)
    return caught.value


def test_a_refused_stroke_raises_with_the_filters_message_each_time(capfd):
    filter = system(vtkSphereSource())
    first = refuse(filter)
    assert first.code == filter.GetErrorCode() != 0
    assert len(first.messages) == 1
    assert first.messages[0].startswith("vtkOversketchOneStroke: ") and "ViewTransform" in first.messages[0]
    assert refuse(filter).messages == first.messages  # VTK itself would say nothing the second time
    good = drawn()
    filter.SetInputConnection(1, good.GetOutputPort())
    assert oversketch.update(filter).GetNumberOfPoints() > 1000
    assert capfd.readouterr() == ("", "")


def test_an_error_further_up_raises_with_its_cause(tmp_path):
    lost = vtkXMLPolyDataReader()
    lost.SetFileName(str(tmp_path / "lost.vtp"))
    error = refuse(system(lost))
    assert error.messages[0].startswith("vtkXMLPolyDataReader: ") and "lost.vtp" in error.messages[0]


def test_a_missing_input_raises():
    filter, sphere = oversketch.vtkOversketchSilhouette(), vtkSphereSource()
    filter.SetInputConnection(0, sphere.GetOutputPort())
    assert "port 1" in refuse(filter).messages[0]


def test_a_cancelled_run_raises_and_the_next_one_is_whole():
    filter = system()
    tag = filter.AddObserver("ProgressEvent", lambda caller, event: caller.AbortExecuteOn())
    error = refuse(filter)
    assert error.code == filter.GetErrorCode() != 0 and str(error.code) in str(error)
    filter.RemoveObserver(tag)
    assert numpy.array_equal(points(oversketch.update(filter)), points(oversketch.update(system())))


def test_a_result_that_is_not_as_drawn_is_warned_of():
    filter = system()
    filter.SetCandidate(2)  # another leg, which this stroke folds over and takes through itself
    filter.AllowTornOn()
    with pytest.warns(RuntimeWarning) as told:
        oversketch.update(filter)
    assert [str(one.message) for one in told] == ["vtkOversketchOneStroke: " + filter.GetRemark()]
    assert "The result is not as drawn: " in filter.GetRemark()


def test_no_observer_stays():
    filter = system(vtkSphereSource())
    refuse(filter)
    assert not filter.HasObserver("ErrorEvent")
    assert not filter.GetExecutive().HasObserver("ErrorEvent")


def test_arrays_in_and_arrays_out():
    before = oversketch.update(mesh())
    triangles = vtk_to_numpy(before.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    filter = system()
    filter.SetInputDataObject(0, polydata(points(before), triangles))
    assert numpy.array_equal(points(oversketch.update(filter)), points(oversketch.update(system())))


@pytest.mark.parametrize("parallel", [True, False])
def test_a_stroke_of_an_array_means_the_cameras_pixels(parallel):
    size = (400, 300)
    camera = vtkCamera()
    camera.SetPosition(1.0, 2.0, 9.0)
    camera.SetFocalPoint(0.2, 0.1, 0.0)
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(2.0)
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(32)
    sphere.SetPhiResolution(32)
    world = points(oversketch.update(sphere)).astype(float)
    # Where these points are on the screen, from the camera's position, axes and angle alone.
    z = numpy.array(camera.GetViewPlaneNormal())
    y = numpy.array(camera.GetViewUp()) - numpy.dot(camera.GetViewUp(), z) * z
    y /= numpy.linalg.norm(y)
    eye = (world - camera.GetPosition()) @ numpy.array([numpy.cross(y, z), y, z]).T
    reach = 2.0 if parallel else -eye[:, 2:] * numpy.tan(numpy.radians(camera.GetViewAngle()) / 2)
    pixels = numpy.array(size) / 2 + eye[:, :2] / reach * size[1] / 2

    stroke = oversketch.stroke(pixels, camera, size)
    assert numpy.array_equal(points(stroke)[:, :2], pixels)
    assert stroke.GetNumberOfCells() == 1 and stroke.GetCell(0).GetNumberOfPoints() == len(pixels)
    view, projection, viewport = (vtk_to_numpy(stroke.GetCellData().GetArray(name))[0]
                                  for name in ("ViewTransform", "ProjectionTransform", "ViewportSize"))
    assert tuple(viewport) == size
    clip = numpy.column_stack([world, numpy.ones(len(world))]) @ (projection.reshape(4, 4) @ view.reshape(4, 4)).T
    shown = (clip[:, :2] / clip[:, 3:] + 1.0) / 2.0 * size
    assert numpy.abs(shown - pixels).max() < 1e-9


def test_a_stroke_of_an_array_deforms():
    """A body with one limb along +x; the outline of its tip, moved out by 30 px, pulls it there."""
    camera = vtkCamera()
    camera.SetPosition(0.0, 0.0, 10.0)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(2.0)
    body = vtkSphereSource()
    body.SetThetaResolution(96)
    body.SetPhiResolution(96)
    body.SetRadius(1.0)
    angle = numpy.linspace(-0.5, 0.5, 60)
    pixels = numpy.column_stack([200 + 75 * numpy.cos(angle) + 20 * numpy.cos(3 * angle), 150 + 75 * numpy.sin(angle)])
    filter = oversketch.vtkOversketchOneStroke()
    filter.SetInputConnection(0, body.GetOutputPort())
    filter.SetStrokeData(oversketch.stroke(pixels, camera, (400, 300)))
    tip = points(oversketch.update(filter))[:, 0].max()
    assert tip == pytest.approx(1.0 + 20 / 75, abs=0.03)


@pytest.mark.parametrize("wrong", [[], [[1.0, 2.0]], [[1.0, 2.0, 3.0]] * 4, [1.0, 2.0]])
def test_points_of_another_shape_are_refused(wrong):
    with pytest.raises(ValueError, match="shape"):
        oversketch.stroke(wrong, vtkCamera(), (400, 300))


def test_strokes_are_joined_each_with_its_view():
    camera = vtkCamera()
    first = oversketch.stroke([[10.0, 20.0], [30.0, 40.0]], camera, (400, 300))
    camera.SetPosition(1.0, 2.0, 9.0)
    second = oversketch.stroke([[50.0, 60.0], [70.5, 80.25], [90.0, 100.0]], camera, (200, 100))
    both = oversketch.strokes([first, second])
    assert both.GetNumberOfCells() == 2 and both.GetCell(1).GetNumberOfPoints() == 3
    assert numpy.array_equal(points(both), numpy.vstack([points(first), points(second)]))
    for name in ("ViewTransform", "ProjectionTransform", "ViewportSize"):
        rows = vtk_to_numpy(both.GetCellData().GetArray(name))
        assert numpy.array_equal(rows, numpy.vstack([vtk_to_numpy(part.GetCellData().GetArray(name)) for part in (first, second)]))
    radius = numpy_to_vtk(numpy.array([0.5]), deep=True)
    radius.SetName("Radius")
    second.GetCellData().AddArray(radius)
    with pytest.raises(ValueError, match="cell array Radius"):
        oversketch.strokes([first, second])
    with pytest.raises(ValueError, match="no stroke"):
        oversketch.strokes([])


def test_a_size_without_pixels_is_refused():
    with pytest.raises(ValueError, match="0 x 300"):
        oversketch.stroke([[0.0, 0.0], [1.0, 1.0]], vtkCamera(), (0, 300))
