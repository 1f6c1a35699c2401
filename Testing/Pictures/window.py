"""A shipped model in a window, for tests of what is drawn and played there."""
import pathlib

import vtk

import oversketch
import scenes

SOURCE = pathlib.Path(__file__).resolve().parents[2]


class Window:
    """A shipped model in a window of 400 x 300 px, seen along -z, and an interactor."""

    def __init__(self, model="dog", colour=scenes.CLAY):
        reader = vtk.vtkPLYReader()
        reader.SetFileName(str(SOURCE / "Data" / "Models" / (model + ".ply")))
        reader.Update()
        self.mesh = reader.GetOutput()
        self.renderer, self.window, self.interactor = vtk.vtkRenderer(), vtk.vtkRenderWindow(), vtk.vtkRenderWindowInteractor()
        self.renderer.SetBackground(1.0, 1.0, 1.0)
        self.renderer.AddActor(scenes.surface(self.mesh, colour))
        self.window.SetMultiSamples(0)
        self.window.SetSize(400, 300)
        self.window.AddRenderer(self.renderer)
        self.interactor.SetRenderWindow(self.window)
        self.style = oversketch.vtkOversketchInteractorStyle()
        self.interactor.SetInteractorStyle(self.style)
        self.renderer.GetActiveCamera().ParallelProjectionOn()
        self.renderer.ResetCamera()
        self.interactor.Initialize()
        self.window.Render()

    def play(self, name):
        recorder = vtk.vtkInteractorEventRecorder()
        recorder.SetInteractor(self.interactor)
        recorder.KeyPressActivationOff()
        recorder.SetFileName(str(SOURCE / "Testing" / "Recordings" / name))
        recorder.Play()
        recorder.Off()

    def picture(self):
        return scenes.image(self.window)
