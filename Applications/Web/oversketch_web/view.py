"""What a visitor sees: the model, drawn by VTK off screen with the window's camera, as a JPEG picture."""
from vtkmodules import vtkInteractionStyle, vtkRenderingFreeType, vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkIOImage import vtkJPEGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkLightKit, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow, vtkTexture, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor

import oversketch

most = 2.2e6  # pixels of a picture
masked, plain = (0.25, 0.27, 0.32), (1.0, 1.0, 1.0)


class View:
    def __init__(self):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.80, 0.82, 0.84)
        self.renderer.SetBackground2(0.95, 0.96, 0.97)
        self.renderer.GradientBackgroundOn()
        kit = vtkLightKit()
        kit.SetKeyLightWarmth(0.55)
        kit.AddLightsToRenderer(self.renderer)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.AddRenderer(self.renderer)
        self.interactor = vtkGenericRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self.interactor.EnableRenderOff()
        self.style = oversketch.vtkOversketchInteractorStyle()
        self.style.SetModeToDraw()
        self.interactor.SetInteractorStyle(self.style)
        self.size, self.share, self.dirty = (2, 2), 1.0, True

    @property
    def camera(self):
        return self.renderer.GetActiveCamera()

    def resize(self, width, height):
        """Takes the size of the browser's canvas, in its pixels; the picture of a very large one is coarser."""
        width, height = max(2, min(int(width), 8192)), max(2, min(int(height), 8192))
        self.share = min(1.0, (most / (width * height)) ** 0.5)
        before, self.size = self.size, (max(2, round(width * self.share)), max(2, round(height * self.share)))
        self.window.SetSize(*self.size)
        if before != self.size:
            self.style.FollowSize(before, self.size)
            self.dirty = True

    def place(self, x, y):
        """A place of the browser's canvas as VTK counts it, from the lower left corner."""
        return x * self.share, self.size[1] - y * self.share

    def show(self, pieces):
        """Shows meshes in place of those before, each with its picture or None."""
        self.renderer.RemoveAllViewProps()
        for mesh, picture in pieces:
            self.renderer.AddActor(self.dressed(mesh, picture))
        self.dirty = True

    def dressed(self, mesh, picture):
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputData(mesh)
        mapper.ScalarVisibilityOff()
        actor.SetMapper(mapper)
        surface = actor.GetProperty()
        surface.SetColor(*plain)
        surface.SetSpecular(0.1)
        surface.SetSpecularPower(20.0)
        data, colours = mesh.GetPointData(), mesh.GetPointData().GetScalars()
        if data.HasArray("Mask") and data.GetArray("Mask").GetRange()[1] > 0.0:
            table = vtkColorTransferFunction()
            table.AddRGBPoint(0.0, *plain)
            table.AddRGBPoint(1.0, *masked)
            mapper.SetLookupTable(table)
            mapper.SetScalarModeToUsePointFieldData()
            mapper.SelectColorArray("Mask")
            mapper.ScalarVisibilityOn()
        elif picture is not None and data.GetTCoords() is not None:
            texture = vtkTexture()
            texture.SetInputData(picture)
            texture.SetColorModeToDirectScalars()
            texture.InterpolateOn()
            actor.SetTexture(texture)
            actor.ForceOpaqueOn()
            surface.SetAmbient(0.35)
            surface.SetDiffuse(0.65)
        elif colours is not None and colours.GetDataTypeAsString() == "unsigned char" and colours.GetNumberOfComponents() > 2:
            mapper.SetColorModeToDirectScalars()
            mapper.ScalarVisibilityOn()
        return actor

    def look(self, side):
        """From a side, of all of the model, or with the other projection."""
        sides = {"front": (2, False), "back": (2, True), "right": (0, False), "left": (0, True), "top": (1, False), "bottom": (1, True)}
        if side == "projection":
            self.style.SetParallelProjection(not self.style.GetParallelProjection())
        else:
            if side in sides:
                self.style.LookFromSide(*sides[side])
            self.renderer.ResetCamera()
        self.dirty = True

    def hand(self, event, x, y, keys):
        """An event of the mouse, by VTK's name of it, with the keys that are held."""
        x, y = self.place(x, y)
        self.interactor.SetEventInformation(round(x), round(y), int("ctrl" in keys), int("shift" in keys))
        self.interactor.SetAltKey(int("alt" in keys))
        self.interactor.InvokeEvent(event)
        self.dirty = True

    def key(self, name, shift):
        self.interactor.SetKeyEventInformation(0, int(shift), name, 1, name)
        self.interactor.SetAltKey(0)
        self.interactor.InvokeEvent("KeyPressEvent")
        self.dirty = True

    def picture(self, moves):
        """What is seen, as the bytes of a JPEG picture: coarser while it moves."""
        self.renderer.ResetCameraClippingRange()
        self.renderer.SetUseFXAA(not moves)
        self.window.Render()
        grab, writer = vtkWindowToImageFilter(), vtkJPEGWriter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        writer.WriteToMemoryOn()
        writer.SetQuality(65 if moves else 88)
        writer.SetInputConnection(grab.GetOutputPort())
        writer.Write()
        self.dirty = False
        return bytes(memoryview(writer.GetResult()))
