"""The pen that raises lines, from Python in a real window: it works in ten lines, logs of events play, pictures are as they were."""
import os
import pathlib
import sys

import pytest
import vtk

import oversketch

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path.insert(0, str(SOURCE / "Testing" / "Pictures"))
import compare  # noqa: E402
import scenes  # noqa: E402
from window import Stage  # noqa: E402


class Ball(Stage):
    """A ball of 100 px radius."""

    def __init__(self):
        source = vtk.vtkSphereSource()
        source.SetRadius(1.0)
        source.SetThetaResolution(40)
        source.SetPhiResolution(40)
        source.Update()
        self.mesh = source.GetOutput()
        self.widget = oversketch.vtkOversketchAugmentWidget()
        self.widget.SetInputConnection(source.GetOutputPort())
        actor = scenes.surface(self.mesh)
        actor.GetMapper().GetInputAlgorithm().SetInputConnection(self.widget.GetOutputPort())
        super().__init__(actor, samples=8)
        self.look((0.0, 0.0, 0.0), 1.5)
        self.start(self.widget)


def highest(mesh):
    """How far the farthest point is from the middle of the ball."""
    return max(sum(x * x for x in mesh.GetPoint(i)) for i in range(mesh.GetNumberOfPoints())) ** 0.5


def test_frames_of_a_line():
    ball = Ball()
    widget, system = ball.widget, ball.widget.GetAugment()
    ball.play("augment_line")
    assert widget.GetPen().IsDrawing()
    if compare.matches(ball.picture(), "augment_pen_down"):
        crest = widget.GetPen().GetStrokeRepresentation().GetCrestProperty()
        orange = crest.GetColor()
        crest.SetColor(0.2, 0.7, 0.3)
        assert compare.difference(ball.picture(), compare.read("augment_pen_down")) > 4 * compare.LIMIT
        crest.SetColor(*orange)
    ball.play("augment_up")
    assert system.GetErrorCode() == 0 and system.GetFigure("met.flipped_faces") == 0
    assert system.GetOutput().GetNumberOfPolys() > ball.mesh.GetNumberOfPolys()
    # The default height is half of 3 % of the diagonal of the ball's box; no point of the ball itself is farther out than 1.
    assert highest(system.GetOutput()) == pytest.approx(1.0 + 0.015 * 12.0 ** 0.5, abs=2e-3)
    compare.matches(ball.picture(), "augment_pen_up")
    # The wheel raises and widens the line that is there.
    height, radius, before = system.GetHeight(), system.GetRadius(), highest(system.GetOutput())
    ball.play("augment_wheel")
    assert (system.GetHeight(), system.GetRadius()) != (height, radius)
    assert highest(widget.GetOutput()) != pytest.approx(before, abs=1e-6)
    compare.matches(ball.picture(), "augment_wheel")


def test_in_ten_lines_on_a_model():
    reader, window = vtk.vtkPLYReader(), vtk.vtkRenderWindow()
    reader.SetFileName(str(SOURCE / "Data" / "Models" / "dog.ply"))
    interactor, renderer = vtk.vtkRenderWindowInteractor(), vtk.vtkRenderer()
    window.AddRenderer(renderer)
    interactor.SetRenderWindow(window)
    pen = oversketch.vtkOversketchAugmentWidget()
    pen.SetInputConnection(reader.GetOutputPort())
    pen.SetInteractor(interactor)
    pen.On()
    pen.Update()
    assert pen.GetOutput().GetNumberOfPolys() == reader.GetOutput().GetNumberOfPolys()
    assert pen.GetMessage() == ""
