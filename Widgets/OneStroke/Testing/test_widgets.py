"""The pen in a real window: it works in under ten lines, logs of events play, pictures are as they were."""
import os
import pathlib
import re
import sys

import numpy as np
import pytest
import vtk

import oversketch

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path.insert(0, str(SOURCE / "Testing" / "Pictures"))
sys.path.insert(0, str(SOURCE / "Testing" / "Acceptance"))
import compare  # noqa: E402
import drawing  # noqa: E402
import judge  # noqa: E402
import meshes  # noqa: E402
import picture  # noqa: E402
import scenes  # noqa: E402
from window import Window  # noqa: E402


def look_at_the_dog(window):
    """The view of the shipped stroke dog_longer_leg, at half its size."""
    camera = window.renderer.GetActiveCamera()
    camera.SetFocalPoint(0.05, 0.75, 0.0)
    camera.SetPosition(0.05, 0.75, 10.0)
    camera.SetParallelScale(60.0 / 47.0)
    window.renderer.ResetCameraClippingRange()
    window.window.Render()


def snippet(word):
    """The snippet that uses this, of the README or of the page of the widgets."""
    pages = [SOURCE / "README.md", SOURCE / "Documentation" / "widgets.md"]
    found = [text for page in pages for text in re.findall(r"```python\n(.*?)```", page.read_text(), re.S) if word in text]
    assert len(found) == 1
    assert len(found[0].strip().splitlines()) <= 10
    return found[0]


@pytest.fixture
def pen():
    """A window on the dog with the pen of the page's snippet, as written there."""
    window = Window()
    look_at_the_dog(window)
    names = {"interactor": window.interactor, "mapper": window.renderer.GetActors().GetLastActor().GetMapper()}
    cwd = os.getcwd()
    os.chdir(SOURCE)
    exec(compile(snippet("vtkOversketchOneStroke()") + snippet("vtkOversketchStrokeWidget()"), "widgets.md", "exec"), names)
    os.chdir(cwd)
    names["system"].SetBackendToHost()  # the same rays whatever OpenCL device there is
    return window, names


def test_the_snippet_draws_and_the_mesh_follows(pen):
    window, names = pen
    window.play("pen_dog_leg")
    assert names["pen"].IsDrawing()
    line = names["pen"].GetStrokeRepresentation().GetProperty()
    if compare.matches(window.picture(), "pen_down"):
        red = line.GetColor()
        line.SetColor(*scenes.SILHOUETTE)
        window.window.Render()
        assert compare.difference(window.picture(), compare.read("pen_down")) > 10 * compare.LIMIT
        line.SetColor(*red)
    window.play("pen_up")
    assert not names["pen"].IsDrawing()
    system = names["system"]
    assert system.GetErrorCode() == 0
    assert names["mapper"].GetInput().GetNumberOfPoints() == system.GetOutput().GetNumberOfPoints()
    moved = system.GetOutput().GetBounds()[2] - window.mesh.GetBounds()[2]
    assert moved < -0.1  # the leg is longer: the lowest point is lower
    compare.matches(window.picture(), "pen_up")


def test_the_stroke_goes_to_a_file_and_back(pen, tmp_path):
    window, names = pen
    window.play("pen_dog_leg")
    window.play("pen_up")
    writer, reader = vtk.vtkXMLPolyDataWriter(), vtk.vtkXMLPolyDataReader()
    writer.SetFileName(str(tmp_path / "stroke.vtp"))
    writer.SetInputConnection(names["pen"].GetOutputPort())
    assert writer.Write()
    reader.SetFileName(str(tmp_path / "stroke.vtp"))
    system = oversketch.vtkOversketchOneStroke()
    system.SetBackendToHost()
    system.SetInputData(0, window.mesh)
    system.SetInputConnection(1, reader.GetOutputPort())
    system.Update()
    assert system.GetErrorCode() == 0
    drawn = names["system"].GetOutput().GetPoints().GetData()
    again = system.GetOutput().GetPoints().GetData()
    assert drawn.GetNumberOfValues() == again.GetNumberOfValues()
    assert all(drawn.GetValue(i) == again.GetValue(i) for i in range(0, drawn.GetNumberOfValues(), 7))


def test_the_one_stroke_snippet_draws_and_the_mesh_follows():
    window = Window()
    look_at_the_dog(window)
    mapper = window.renderer.GetActors().GetLastActor().GetMapper()
    names = {"interactor": window.interactor, "mapper": mapper}
    cwd = os.getcwd()
    os.chdir(SOURCE)
    exec(compile(snippet("vtkOversketchOneStroke()") + snippet("vtkOversketchOneStrokeWidget()"), "widgets.md", "exec"), names)
    os.chdir(cwd)
    names["drawing"].GetOneStroke().SetBackendToHost()
    window.window.Render()
    window.play("pen_dog_leg")
    window.play("pen_up")
    assert names["drawing"].GetMessage() == ""
    assert mapper.GetInput().GetNumberOfPoints() == names["drawing"].GetOutput().GetNumberOfPoints()
    assert mapper.GetInput().GetBounds()[2] - window.mesh.GetBounds()[2] < -0.1


def test_frames_of_a_drawing_and_how_near_the_outline_comes():
    scene = drawing.Drawing()
    widget = scene.widget
    scene.play("pen_dog_leg")
    if compare.matches(scene.picture(), "one_stroke_pen_down"):
        pen = widget.GetPen().GetStrokeRepresentation()
        blue = pen.GetSectionProperty().GetColor()
        pen.GetSectionProperty().SetColor(0.2, 0.7, 0.3)
        scene.window.Render()
        assert compare.difference(scene.picture(), compare.read("one_stroke_pen_down")) > 4 * compare.LIMIT
        pen.GetSectionProperty().SetColor(*blue)
    scene.play("pen_up")
    compare.matches(scene.picture(), "one_stroke_pen_up")
    # The acceptance's own measure and bounds.
    stroke = widget.GetStroke()
    seen = scenes.View(stroke)
    view = picture.View(seen.view, seen.projection, *seen.size)
    line = np.array([stroke.GetPoint(i)[:2] for i in range(stroke.GetNumberOfPoints())])
    mean, worst, back = judge.outline_distances(view, *meshes.arrays(widget.GetOutput()), line)
    before = judge.outline_distances(view, *meshes.arrays(scene.mesh), line)[0]
    print(f"outline to stroke {before:.2f} px before, {mean:.2f} mean, {worst:.2f} worst, {back:.2f} back after")
    assert before > 2 * judge.MEAN
    assert mean <= judge.MEAN and worst <= judge.WORST and back <= judge.BACK
    widget.ShowRegionOn()
    scene.window.Render()
    if compare.matches(scene.picture(), "one_stroke_region"):
        widget.GetLiveStrokeRepresentation().GetRegionProperty().SetColor(0.2, 0.7, 0.3)
        scene.window.Render()
        assert compare.difference(scene.picture(), compare.read("one_stroke_region")) > 10 * compare.LIMIT
    scene.play("one_stroke_drag")
    compare.matches(scene.picture(), "one_stroke_drag")


def test_latency_is_measured():
    sys.path.insert(0, str(SOURCE / "Testing" / "Benchmarks"))
    import pen_latency

    triangles, times = pen_latency.measure(0, 1)
    assert triangles == 26578
    assert [len(times[name]) for name in ("redraw", "pen down", "sample", "mesh")] == [5, 1, 112, 1]
    assert all(t > 0.0 for values in times.values() for t in values)
