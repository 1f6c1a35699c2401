"""The widgets of the edit, from Python in real windows: they work in ten lines, logs of events play, pictures are as they were."""
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


def ball():
    source = vtk.vtkSphereSource()
    source.SetRadius(1.0)
    source.SetThetaResolution(60)
    source.SetPhiResolution(60)
    rotate = vtk.vtkTransformPolyDataFilter()  # its poles to the sides
    turn = vtk.vtkTransform()
    turn.RotateX(90.0)
    turn.RotateY(37.0)
    rotate.SetTransform(turn)
    rotate.SetInputConnection(source.GetOutputPort())
    rotate.Update()
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(rotate.GetOutput().GetPoints())
    mesh.SetPolys(rotate.GetOutput().GetPolys())
    return mesh


class Scene(Stage):
    """100 px to a unit, with the ball or nothing."""

    def __init__(self, widget, mesh=None, scale=1.5, azimuth=0.0, elevation=0.0):
        self.actor = scenes.surface(mesh) if mesh else None
        super().__init__(self.actor)
        camera = self.look((0.0, 0.0, 0.0), scale)
        camera.Azimuth(azimuth)
        camera.Elevation(elevation)
        self.widget = widget
        if widget:
            widget.SetInteractor(self.interactor)
            widget.On()
        self.renderer.ResetCameraClippingRange()
        self.start()

    def picture(self):
        self.renderer.ResetCameraClippingRange()
        return super().picture()


@pytest.fixture(scope="module")
def region():
    """The ball with a line and a ring, by the logs, and the system over them."""
    mesh = ball()
    widget = oversketch.vtkOversketchRegionWidget()
    widget.SetModel(mesh)
    scene = Scene(widget, mesh)
    scene.play("region_line", "region_ring")
    system = oversketch.vtkOversketchEdit()
    system.SetInputData(0, mesh)
    system.SetInputConnection(1, widget.GetReferencePort())
    system.SetInputConnection(2, widget.GetBoundaryPort())
    oversketch.update(system)
    line = vtk.vtkPolyData()
    system.GetHold(line)
    return mesh, system, line, system.GetStep("Enclose").GetInputDataObject(2, 0)


def test_frames_of_a_region():
    mesh, widget = ball(), oversketch.vtkOversketchRegionWidget()
    widget.SetModel(mesh)
    scene = Scene(widget, mesh)
    scene.play("region_line", "region_ring_down")
    assert widget.GetPen().IsDrawing()
    compare.matches(scene.picture(), "region_pen_down")
    widget.GetPen().CancelStroke()
    scene.play("region_ring", "region_redraw_ring")
    assert (widget.GetReference().GetNumberOfLines(), widget.GetBoundary().GetNumberOfLines()) == (1, 2)
    if compare.matches(scene.picture(), "region_redrawn"):
        widget.GetRegionRepresentation().SetReference(None)
        assert compare.difference(scene.picture(), compare.read("region_redrawn")) > 4 * compare.LIMIT


def test_frames_of_axes(region):
    mesh, system, line, _ = region
    widget = oversketch.vtkOversketchAxisHandleWidget()
    scene = Scene(widget, mesh, azimuth=-30.0, elevation=25.0)
    assert widget.SetCurve(line, system.GetInnerOutput("Distance"))
    widget.AddHandle(0.85)
    widget.AddHandle(0.4)
    compare.matches(scene.picture(), "axes_idle")
    scene.renderer.GetActiveCamera().SetPosition(0.0, 0.0, 10.0)
    scene.renderer.GetActiveCamera().SetViewUp(0.0, 1.0, 0.0)
    widget.SetOperations("pin 0.5")
    widget.AddHandle(0.5)
    scene.play("axis_drag")
    assert widget.IsDragging() and widget.GetOperations().startswith("move 0.5 w ")
    if compare.matches(scene.picture(), "axes_dragged"):
        widget.GetAxisHandleRepresentation().SetSelectedHandle(-1)
        assert compare.difference(scene.picture(), compare.read("axes_dragged")) > 4 * compare.LIMIT


def test_frames_of_layers(region):
    mesh, system, _, _ = region
    for side, name in ((0, "layers"), (1, "layers_model")):
        widget = oversketch.vtkOversketchLayerHandleWidget()
        assert widget.SetRegion(system.GetInnerOutput("Distance"))
        widget.GetLayerHandleRepresentation().SetSide(side)
        scene = Scene(widget, mesh if side else None, 1.5 if side else 1.15)
        compare.matches(scene.picture(), name + "_idle")
        scene.play("layer_drag")
        assert widget.IsDragging() and widget.GetLayers().startswith("handle ")
        if compare.matches(scene.picture(), name + "_dragged"):
            widget.SetLayers("")
            assert compare.difference(scene.picture(), compare.read(name + "_dragged")) > 4 * compare.LIMIT


def test_frames_of_an_area(region):
    mesh, system, _, _ = region
    for side, name in ((0, "area"), (1, "area_model")):
        widget = oversketch.vtkOversketchAreaSelectWidget()
        widget.SetRegion(system.GetInnerOutput("Distance"))
        widget.GetAreaSelectRepresentation().SetSide(side)
        scene = Scene(widget, mesh if side else None, 1.5 if side else 1.15)
        scene.play("area_lasso_down")
        assert widget.GetPen().IsDrawing()
        compare.matches(scene.picture(), name + "_pen_down")
        widget.GetPen().CancelStroke()
        scene.play("area_lasso")
        assert widget.GetAreas().GetNumberOfLines() == 1
        compare.matches(scene.picture(), name + "_selected")


def test_frames_of_a_profile(region):
    mesh, system, line, ring = region
    flat = Scene(None)
    widget = oversketch.vtkOversketchProfilePlaneWidget()
    widget.SetProfileRenderer(flat.renderer)
    scene = Scene(widget, mesh, azimuth=-25.0, elevation=20.0)
    assert widget.SetRegion(system.GetInnerOutput("Distance"), line, ring)
    compare.matches(scene.picture(), "planes_idle")
    flat.window.Render()
    compare.matches(scenes.image(flat.window), "profile_idle")
    widget.SetProfileAt(0.2)
    scene.interactor.SetEventInformation(0, 0, 0, 0, "9", 0, "9")
    scene.interactor.InvokeEvent("KeyPressEvent")
    assert widget.GetProfilePlaneRepresentation().GetNumberOfVisiblePlanes() == 1
    compare.matches(scene.picture(), "planes_slid")
    # Under the hand, seen from the front, with all planes.
    widget.SetProfileAt(0.5)
    scene.interactor.SetEventInformation(0, 0, 0, 0, "6", 0, "6")
    scene.interactor.InvokeEvent("KeyPressEvent")
    scene.renderer.GetActiveCamera().SetPosition(0.0, 0.0, 10.0)
    scene.renderer.GetActiveCamera().SetViewUp(0.0, 1.0, 0.0)
    scene.play("profile_slide")
    assert widget.IsDragging() and 0.75 < widget.GetProfileAt() < 0.82
    assert widget.GetProfilePlaneRepresentation().GetNumberOfVisiblePlanes() == 3
    if compare.matches(scene.picture(), "planes_dragged"):
        widget.SetProfileAt(0.5)
        assert compare.difference(scene.picture(), compare.read("planes_dragged")) > 4 * compare.LIMIT
    scene.play("profile_let_go")
    assert not widget.IsDragging()
    widget.SetProfileAt(0.2)
    flat.play("profile_stroke")
    assert widget.GetPen().IsWaiting()
    flat.interactor.SetEventInformation(0, 0, 0, 0, "\r", 0, "Return")
    flat.interactor.InvokeEvent("KeyPressEvent")
    assert widget.GetProfile().GetNumberOfLines() == 1
    flat.window.Render()
    compare.matches(scenes.image(flat.window), "profile_drawn")


def test_frames_of_an_edit():
    widget = oversketch.vtkOversketchEditWidget()
    widget.SetInputData(ball())
    widget.Update()
    scene = Scene(widget, widget.GetOutput())
    scene.actor.GetMapper().GetInputAlgorithm().SetInputConnection(widget.GetOutputPort())
    scene.play("region_line", "region_ring")
    assert widget.HasRegion(), widget.GetMessage()
    widget.GetEdit().SetOperations("move 0.5 n 0.25; pin 0.1")
    widget.SetShowRegion(True)
    camera = scene.renderer.GetActiveCamera()
    camera.Azimuth(-25.0)
    camera.Elevation(-30.0)
    compare.matches(scene.picture(), "edit_idle")
    widget.SetShowRegion(False)
    widget.SetModeToDirect()
    widget.GetAxisHandleWidget().GetAxisHandleRepresentation().SetSelectedHandle(1)
    camera.SetPosition(0.0, 0.0, 10.0)
    camera.SetViewUp(0.0, 1.0, 0.0)
    scene.picture()
    scene.play("axis_drag")
    assert widget.IsPreviewing()
    compare.matches(scene.picture(), "edit_dragged")
    scene.play("axis_drop")
    assert not widget.IsPreviewing() and widget.GetEdit().GetMovedPoints() > 50
    compare.matches(scene.picture(), "edit_let_go")
    widget.SetModeToShade()
    compare.matches(scene.picture(), "edit_shaded")


def test_in_ten_lines_to_an_edit():
    reader, window, renderer, interactor = vtk.vtkPLYReader(), vtk.vtkRenderWindow(), vtk.vtkRenderer(), vtk.vtkRenderWindowInteractor()
    reader.SetFileName(str(SOURCE / "Data" / "Models" / "dog.ply"))
    reader.Update()
    window.AddRenderer(renderer)
    interactor.SetRenderWindow(window)
    pen = oversketch.vtkOversketchRegionWidget()
    pen.SetModel(reader.GetOutput())
    pen.SetInteractor(interactor)
    pen.On()
    assert not pen.HasReference() and pen.GetReference().GetNumberOfPoints() == 0
    assert pen.GetPen().GetEnabled()
