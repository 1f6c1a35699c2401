#!/usr/bin/env python3
"""drawing.py PICTURE.png: three frames of vtkOversketchOneStrokeWidget: the pen is down, up, and the region is shown."""
import pathlib
import sys

import vtk

import oversketch
import scenes

SOURCE = pathlib.Path(__file__).resolve().parents[2]


def play(interactor, *names):
    """Logs of events, of Testing/Recordings, one after the other."""
    for name in names:
        recorder = vtk.vtkInteractorEventRecorder()
        recorder.SetInteractor(interactor)
        recorder.KeyPressActivationOff()
        recorder.SetFileName(str(SOURCE / "Testing" / "Recordings" / (name + ".log")))
        recorder.Play()
        recorder.Off()


class Drawing:
    """The dog in a window of 400 x 300 px with the pen that deforms it."""

    def __init__(self, samples=0):
        reader = vtk.vtkPLYReader()
        reader.SetFileName(str(SOURCE / "Data" / "Models" / "dog.ply"))
        reader.Update()
        self.mesh = reader.GetOutput()
        self.interactor, self.window, self.renderer = vtk.vtkRenderWindowInteractor(), vtk.vtkRenderWindow(), vtk.vtkRenderer()
        self.widget = oversketch.vtkOversketchOneStrokeWidget()
        self.widget.SetInputConnection(reader.GetOutputPort())
        self.widget.GetOneStroke().SetBackendToHost()  # the same rays whatever OpenCL device there is
        self.widget.Update()
        actor = scenes.surface(self.mesh)
        self.normals = actor.GetMapper().GetInputAlgorithm()
        self.normals.SetInputConnection(self.widget.GetOutputPort())
        self.renderer.SetBackground(1.0, 1.0, 1.0)
        self.renderer.AddActor(actor)
        self.window.SetMultiSamples(samples)
        self.window.SetSize(400, 300)
        self.window.AddRenderer(self.renderer)
        self.interactor.SetRenderWindow(self.window)
        camera = self.renderer.GetActiveCamera()  # the view of the shipped stroke dog_longer_leg, at half its size
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(0.05, 0.75, 0.0)
        camera.SetPosition(0.05, 0.75, 10.0)
        camera.SetParallelScale(60.0 / 47.0)
        self.renderer.ResetCameraClippingRange()
        self.widget.SetInteractor(self.interactor)
        self.widget.On()
        self.interactor.Initialize()
        self.window.Render()

    def play(self, *names):
        play(self.interactor, *names)

    def picture(self):
        return scenes.image(self.window)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    drawing, strip = Drawing(samples=8), vtk.vtkImageAppend()
    for step in (lambda: drawing.play("pen_dog_leg"), lambda: drawing.play("pen_up"), drawing.widget.ShowRegionOn):
        step()
        drawing.window.Render()
        strip.AddInputData(drawing.picture())
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(strip.GetOutputPort())
    writer.SetFileName(sys.argv[1])
    writer.Write()


if __name__ == "__main__":
    main()
