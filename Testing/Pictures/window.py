"""Windows for tests of what is drawn and played there."""
import pathlib

import vtk

import oversketch
import scenes

SOURCE = pathlib.Path(__file__).resolve().parents[2]


class Stage:
    """A window of 400 x 300 px and an interactor; logs of events play there, and it is pictured."""

    def __init__(self, actor=None, samples=0, background=(1.0, 1.0, 1.0)):
        self.renderer, self.window, self.interactor = vtk.vtkRenderer(), vtk.vtkRenderWindow(), vtk.vtkRenderWindowInteractor()
        self.renderer.SetBackground(*background)
        if actor:
            self.renderer.AddActor(actor)
        self.window.SetMultiSamples(samples)
        self.window.SetSize(400, 300)
        self.window.AddRenderer(self.renderer)
        self.interactor.SetRenderWindow(self.window)

    def look(self, at, scale):
        """Along -z, in parallel: `scale` is half of the window's height."""
        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*at)
        camera.SetPosition(at[0], at[1], at[2] + 10.0)
        camera.SetParallelScale(scale)
        self.renderer.ResetCameraClippingRange()
        return camera

    def start(self, widget=None):
        if widget:
            widget.SetInteractor(self.interactor)
            widget.On()
        self.interactor.Initialize()
        self.window.Render()

    def play(self, *names):
        """Logs of events, of Testing/Recordings, one after the other."""
        for name in names:
            recorder = vtk.vtkInteractorEventRecorder()
            recorder.SetInteractor(self.interactor)
            recorder.KeyPressActivationOff()
            recorder.SetFileName(str(SOURCE / "Testing" / "Recordings" / (name + ".log")))
            recorder.Play()
            recorder.Off()

    def picture(self):
        self.window.Render()
        return scenes.image(self.window)


def shipped(model):
    """The reader of a shipped model."""
    reader = vtk.vtkPLYReader()
    reader.SetFileName(str(SOURCE / "Data" / "Models" / (model + ".ply")))
    reader.Update()
    return reader


class Window(Stage):
    """A shipped model, seen along -z, under the camera's interactor style."""

    def __init__(self, model="dog", colour=scenes.CLAY):
        self.mesh = shipped(model).GetOutput()
        super().__init__(scenes.surface(self.mesh, colour))
        self.style = oversketch.vtkOversketchInteractorStyle()
        self.interactor.SetInteractorStyle(self.style)
        self.renderer.GetActiveCamera().ParallelProjectionOn()
        self.renderer.ResetCamera()
        self.start()
