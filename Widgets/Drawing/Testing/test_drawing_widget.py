"""The pen over a picture, from Python in a real window: it works in ten lines, logs of events play, pictures are as they were."""
import os
import pathlib
import sys

import vtk

import oversketch

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path.insert(0, str(SOURCE / "Testing" / "Pictures"))
import compare  # noqa: E402
from window import Stage  # noqa: E402


class Fish(Stage):
    """The shipped picture of a fish, drawn over."""

    def __init__(self):
        super().__init__(background=(0.9, 0.9, 0.9))
        reader = vtk.vtkPNGReader()
        reader.SetFileName(str(SOURCE / "Data" / "Drawings" / "fish.png"))
        reader.Update()
        self.widget = oversketch.vtkOversketchDrawingWidget()
        self.widget.SetSnapRadius(4.0)
        self.widget.SetInteractor(self.interactor)
        self.widget.On()
        self.widget.SetPicture(reader.GetOutput())
        self.start()

    def labels(self, name):
        array = self.widget.GetCurves().GetCellData().GetArray(name)
        return [int(array.GetTuple1(i)) for i in range(array.GetNumberOfTuples())]


def test_frames_of_a_drawing():
    fish = Fish()
    fish.play("drawing_pen_down")
    assert fish.widget.GetPen().IsDrawing()
    if compare.matches(fish.picture(), "drawing_pen_down"):  # the corridor is seen
        fish.widget.GetPen().GetStrokeRepresentation().SetSection(None)
        assert compare.difference(fish.picture(), compare.read("drawing_pen_down")) > 4 * compare.LIMIT
    fish.widget.GetPen().CancelStroke()
    assert fish.widget.GetDrawing().GetNumberOfCells() == 0
    fish.play("drawing_outline")
    assert fish.labels("Role") == [1], fish.widget.GetText()
    snapped = fish.widget.GetCurves().GetPointData().GetArray("Snapped")
    assert sum(snapped.GetTuple1(i) for i in range(snapped.GetNumberOfTuples())) > 0.5 * snapped.GetNumberOfTuples()
    fish.widget.MagneticOff()
    fish.play("drawing_features")  # gill, eye, fin
    assert fish.labels("Role") == [1, 3, 2, 2], fish.widget.GetText()
    fish.widget.CycleTreatment(237.0, 356.0)  # the eye
    assert fish.labels("Treatment") == [0, 0, 1, 0]
    compare.matches(fish.picture(), "drawing_fish")


def test_in_ten_lines_to_a_model():
    reader, strokes, window = vtk.vtkPNGReader(), vtk.vtkXMLPolyDataReader(), vtk.vtkRenderWindow()
    reader.SetFileName(str(SOURCE / "Data" / "Drawings" / "fish.png"))
    reader.Update()
    interactor, renderer = vtk.vtkRenderWindowInteractor(), vtk.vtkRenderer()
    window.AddRenderer(renderer)
    interactor.SetRenderWindow(window)
    sheet, system = oversketch.vtkOversketchDrawingWidget(), oversketch.vtkOversketchInflateDrawing()
    sheet.SetPicture(reader.GetOutput())
    sheet.SetInteractor(interactor)
    sheet.On()
    system.SetInputConnection(0, sheet.GetOutputPort())
    system.SetInputData(1, reader.GetOutput())
    assert oversketch.update(system).GetNumberOfPolys() == 0  # nothing is drawn yet
    strokes.SetFileName(str(SOURCE / "Data" / "Drawings" / "fish.vtp"))
    strokes.Update()
    assert sheet.SetDrawing(strokes.GetOutput())
    assert sheet.GetText() == ""
    assert oversketch.update(system).GetNumberOfPolys() > 1000
