"""Sheets of panels in the colours of the paper's figures: stroke red, silhouette blue, region orange. The examples in this folder draw
with it; it needs a display (xvfb-run -a makes one)."""
import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkTexture,
    vtkWindowToImageFilter,
)
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (letters)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the rendering backend)

from oversketch import vtkOversketchOneStroke

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
CLAY, RED, BLUE, ORANGE = (0.86, 0.86, 0.87), (0.85, 0.10, 0.12), (0.13, 0.33, 0.80), (1.00, 0.66, 0.26)
PURPLE, GREEN, MAGENTA, GREY = (0.64, 0.44, 0.82), (0.30, 0.78, 0.45), (0.84, 0.10, 0.62), (0.55, 0.55, 0.58)
YELLOW = (0.95, 0.76, 0.10)


def drawn(stroke):
    """The reader of a shipped stroke, by its name."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(DATA / "Strokes" / (stroke + ".vtp")))
    reader.Update()
    return reader


def load(stroke):
    """The readers of a shipped stroke and of the model it was drawn over."""
    mesh = vtkPLYReader()
    mesh.SetFileName(str(DATA / "Models" / (stroke.split("_")[0] + ".ply")))
    mesh.Update()
    return mesh, drawn(stroke)


def deformed(stroke, **settings):
    """The same two, and the system that has deformed the model by the stroke, by its settings (AsPublished=True)."""
    mesh, pen = load(stroke)
    system = vtkOversketchOneStroke()
    system.SetInputConnection(0, mesh.GetOutputPort())
    system.SetInputConnection(1, pen.GetOutputPort())
    system.SetBackendToHost()
    for name, value in settings.items():
        getattr(system, "Set" + name)(value)
    system.Update()
    return mesh, pen, system


class View:
    """The view that a stroke carries, of several one; turned by some degrees about the picture's upward axis through `middle`."""

    def __init__(self, stroke, turn=0.0, middle=(0.0, 0.0, 0.0), which=0):
        cells = stroke.GetCellData()
        self.view = vtk_to_numpy(cells.GetArray("ViewTransform"))[which].reshape(4, 4)
        self.projection = vtk_to_numpy(cells.GetArray("ProjectionTransform"))[which].reshape(4, 4)
        self.size = vtk_to_numpy(cells.GetArray("ViewportSize"))[which].astype(int)
        if turn:
            c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
            place, about = np.eye(4), np.array([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0], [0, 0, 0, 1.0]])
            place[:3, 3] = (self.view @ np.append(middle, 1.0))[:3]
            self.view = place @ about @ np.linalg.inv(place) @ self.view

    def pixels(self, points):
        """Where points of the world are in the picture [px, y up]."""
        clip = np.c_[points, np.ones(len(points))] @ (self.projection @ self.view).T
        return (clip[:, :2] / clip[:, 3:] + 1.0) * 0.5 * self.size

    def aim(self, renderer, crop=None):
        """The camera of that view, looking at a part of the picture: left, bottom, width, height [px]; None: all of it."""
        crop = crop or (0.0, 0.0, *self.size)
        camera, inverse = renderer.GetActiveCamera(), np.linalg.inv(self.view)
        eye, back, up = inverse[:3, 3], inverse[:3, 2], inverse[:3, 1]
        camera.SetPosition(*eye)
        camera.SetFocalPoint(*(eye - back))
        camera.SetViewUp(*up)
        part = crop[3] / self.size[1]
        if self.projection[3, 2] == 0.0:
            camera.ParallelProjectionOn()
            camera.SetParallelScale(part / self.projection[1, 1])
        else:
            camera.SetViewAngle(2.0 * np.degrees(np.arctan(part / self.projection[1, 1])))
        camera.SetWindowCenter(*[(2.0 * crop[i] + crop[2 + i] - self.size[i]) / crop[2 + i] for i in (0, 1)])
        renderer.ResetCameraClippingRange()


def clay(mesh, colours=None, edges=False, crease=180.0):
    """The mesh, smooth-shaded but for edges where it bends by more than `crease` degrees; `colours` gives one a point or one a triangle, each
    three numbers up to 1."""
    shown = vtkPolyData()
    shown.SetPoints(mesh.GetPoints())
    shown.SetPolys(mesh.GetPolys())
    shown.GetPointData().SetTCoords(mesh.GetPointData().GetTCoords())
    if colours is not None:
        array = numpy_to_vtk((255 * np.asarray(colours)).round().astype(np.uint8), deep=True)
        data = shown.GetPointData() if len(colours) == mesh.GetNumberOfPoints() else shown.GetCellData()
        data.SetScalars(array)
    normals = vtkPolyDataNormals()
    normals.SetInputData(shown)
    normals.SetSplitting(crease < 180.0)
    normals.SetFeatureAngle(crease)
    normals.ConsistencyOff()
    normals.Update()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(normals.GetOutput())
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*CLAY)
    look.SetAmbient(0.16)
    look.SetDiffuse(0.84)
    look.SetSpecular(0.10)
    look.SetSpecularPower(18)
    if edges:
        look.EdgeVisibilityOn()
        look.SetEdgeColor(0.25, 0.25, 0.30)
        look.SetLineWidth(1.6)
    return actor


def textured(mesh, picture):
    """The mesh in its picture, lit as clay is."""
    actor, texture = clay(mesh, crease=60), vtkTexture()
    texture.SetInputData(picture)
    texture.InterpolateOn()
    actor.GetProperty().SetColor(1.0, 1.0, 1.0)
    actor.SetTexture(texture)
    return actor


def by_region(mesh, inside=ORANGE):
    """Colours of the points: the region, the rest."""
    return np.where(vtk_to_numpy(mesh.GetPointData().GetArray("Region"))[:, None] > 0, inside, CLAY)


def by_value(values):
    """Colours of numbers from 0 to 1: dark blue, green, pale yellow, in even steps of lightness."""
    stops = np.array([[0.17, 0.16, 0.45], [0.16, 0.45, 0.60], [0.36, 0.70, 0.55], [0.80, 0.86, 0.45], [0.99, 0.95, 0.75]])
    return np.c_[tuple(np.interp(values, np.linspace(0, 1, len(stops)), stops[:, k]) for k in range(3))]


def snapped(mesh):
    """The edges of a 4-8 mesh that lie on curves: lines of two points."""
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    curve, along = (vtk_to_numpy(mesh.GetPointData().GetArray(name)) for name in ("CurveId", "CurveParam"))
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    edges = np.unique(np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    a, b = edges.T
    length = np.linalg.norm(points[a] - points[b], axis=1)
    on = (curve[a] >= 0) & (curve[a] == curve[b]) & (np.abs(along[a] - along[b]) < 2.0 * length)
    return [points[edge] for edge in edges[on]]


def lines_of(data):
    """The polylines of a polydata, each an array of points; of curves that say which are visible, those."""
    points, visible = vtk_to_numpy(data.GetPoints().GetData()), data.GetCellData().GetArray("Visible")
    lines, offsets = data.GetLines(), vtk_to_numpy(data.GetLines().GetOffsetsArray())
    ids = vtk_to_numpy(lines.GetConnectivityArray())
    return [points[ids[offsets[i]:offsets[i + 1]]] for i in range(len(offsets) - 1)
            if visible is None or visible.GetComponent(i, 0)]


def rope(lines, colour, radius):
    """Lines in the world as tubes, hidden where the model is in front."""
    return [tubed(lines, colour, radius)]


def tubed(lines, colour, radius):
    points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    for line in lines:
        cells.InsertNextCell(len(line))
        for place in line:
            cells.InsertCellPoint(points.InsertNextPoint(place))
    data.SetPoints(points)
    data.SetLines(cells)
    tube = vtkTubeFilter()
    tube.SetInputData(data)
    tube.SetRadius(radius)
    tube.SetNumberOfSides(12)
    tube.CappingOn()
    return flat(tube, colour)


def dotted(place, colour, radius):
    disc = vtkRegularPolygonSource()
    disc.SetCenter(*place)
    disc.SetRadius(radius)
    disc.SetNumberOfSides(32)
    return flat(disc, colour)


def flat(source, colour):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().LightingOff()
    return actor


def curve(lines, colour, width=3.0):
    """Lines in the picture [px], over everything: (colour, width, points). A single point is a dot."""
    return [(colour, width, np.asarray(line)[:, :2]) for line in lines]


def shown_in(window):
    """The picture of a rendered window, as vtkImageData."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    return grab.GetOutput()


class Sheet:
    """Panels of one size, row by row; each is rendered large and averaged down, so edges are smooth everywhere."""

    FINE = 3

    def __init__(self, columns, size=(400, 300)):
        self.columns, self.size, self.panels = columns, size, []

    def panel(self, view, actors, curves=(), crop=None):
        """Adds a panel, with its letter; without a crop it shows the whole picture of the view."""
        crop = crop or (0.0, 0.0, *view.size)
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(0)
        window.SetSize(*[self.FINE * n for n in self.size])
        window.SetNumberOfLayers(2)
        scene, paper = vtkRenderer(), vtkRenderer()
        scene.SetBackground(1.0, 1.0, 1.0)
        scene.AutomaticLightCreationOff()
        for place, strength in (((-0.6, 0.9, 1.0), 0.80), ((0.9, 0.2, 0.8), 0.36), ((0.0, -1.0, 0.3), 0.14)):
            lamp = vtkLight()
            lamp.SetLightTypeToCameraLight()
            lamp.SetPosition(*place)
            lamp.SetFocalPoint(0, 0, 0)
            lamp.SetIntensity(strength)
            scene.AddLight(lamp)
        for actor in actors:
            scene.AddActor(actor)
        view.aim(scene, crop)
        paper.SetLayer(1)
        scale = self.size[0] / crop[2]
        for level, (colour, width, line) in enumerate(curves):
            line = (line - crop[:2]) * scale
            line = line[np.r_[True, np.linalg.norm(np.diff(line, axis=0), axis=1) > 0.05]]
            line = np.c_[line, np.full(len(line), 0.01 * level)]
            paper.AddActor(tubed([line], colour, 0.5 * width) if len(line) > 1 else dotted(line[0], colour, 0.5 * width))
        camera = paper.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(0.5 * self.size[1])
        camera.SetFocalPoint(0.5 * self.size[0], 0.5 * self.size[1], 0.0)
        camera.SetPosition(0.5 * self.size[0], 0.5 * self.size[1], 1000.0)
        camera.SetClippingRange(1.0, 2000.0)
        letter = vtkTextActor()
        letter.SetInput(f"({'abcdefghijklmnopqrstuvwx'[len(self.panels)]})")
        letter.GetTextProperty().SetFontSize(15 * self.FINE)
        letter.GetTextProperty().SetColor(0.2, 0.2, 0.2)
        letter.SetPosition(8 * self.FINE, 8 * self.FINE)
        paper.AddActor2D(letter)
        for renderer in (scene, paper):
            window.AddRenderer(renderer)
        window.Render()
        pixels = vtk_to_numpy(shown_in(window).GetPointData().GetScalars())
        fine = pixels.reshape(self.size[1], self.FINE, self.size[0], self.FINE, 3).astype(float)
        self.panels.append(fine.mean(axis=(1, 3)))
        self.window = window  # till the next one is there: a virtual display may begin anew when its last window closes

    def image(self):
        """All panels, as vtkImageData."""
        width, height = self.size
        rows = -(-len(self.panels) // self.columns)
        sheet = np.full((rows * height, self.columns * width, 3), 255.0)
        for i, pixels in enumerate(self.panels):
            bottom, left = (rows - 1 - i // self.columns) * height, (i % self.columns) * width
            sheet[bottom:bottom + height, left:left + width] = pixels
        image = vtkImageData()
        image.SetDimensions(sheet.shape[1], sheet.shape[0], 1)
        scalars = numpy_to_vtk(sheet.round().astype(np.uint8).reshape(-1, 3), deep=True)
        scalars.SetName("PNGImage")
        image.GetPointData().SetScalars(scalars)
        return image

    def save(self, name):
        """Writes the picture that the command line names, else one of that name."""
        writer = vtkPNGWriter()
        writer.SetFileName(sys.argv[1] if len(sys.argv) > 1 else name)
        writer.SetInputData(self.image())
        writer.Write()
