"""What the examples of drawings share: the system on a shipped drawing, pictures to lie under it, its lines and meshes."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkImageActor

import oversketch

from sheet import BLUE, DATA, GREEN, GREY, RED, View, clay, lines_of, tubed

ROLES = {1: RED, 2: BLUE, 3: GREEN}


def system_of(name, **parameters):
    """The system on a shipped drawing and its picture; parameters are its properties."""
    picture, strokes, system = vtkPNGReader(), vtkXMLPolyDataReader(), oversketch.vtkOversketchInflateDrawing()
    picture.SetFileName(str(DATA / "Drawings" / (name + ".png")))
    strokes.SetFileName(str(DATA / "Drawings" / (name + ".vtp")))
    system.SetInputConnection(0, strokes.GetOutputPort())
    system.SetInputConnection(1, picture.GetOutputPort())
    for parameter, value in parameters.items():
        getattr(system, "Set" + parameter)(value)
    return system


def ring(x, y, across, up, waves=0, depth=0.0):
    """A closed line about a place, wavy as a hand would have it."""
    turn = np.linspace(0, 2 * np.pi, 240, endpoint=False)
    out = 1 + depth * np.sin(waves * turn)
    return np.c_[x + across * out * np.cos(turn), y + up * out * np.sin(turn)]


def strokes_of(system):
    return system.GetInputDataObject(0, 0)


def picture_of(system):
    return system.GetInputDataObject(1, 0)


def view_of(system, turn=0.0):
    """The drawing's own view, turned by some degrees about the canvas's middle and moved back, so that nothing is behind the eye."""
    x, y, across, up = system.GetInnerOutput("Treatment").GetFieldData().GetArray("Canvas").GetTuple4(0)
    view = View(strokes_of(system), turn, (x + across / 2, y + up / 2, 0.0))
    view.view[2, 3] -= 2.0 * max(across, up)
    return view


def thicker(mask):
    """A part of a raster with the pixels beside it."""
    return np.logical_or.reduce([mask, *(np.roll(mask, shift, axis) for shift in (-1, 1) for axis in (0, 1))])


def whole(view, share=1.2):
    """The crop that shows all of a view, and some paper round it, in a panel of 4 to 3."""
    width, height = view.size
    across = share * max(width, 4 * height / 3)
    return 0.5 * width - 0.5 * across, 0.5 * height - 0.375 * across, across, 0.75 * across


def plate(picture):
    """A picture itself, at z = 0."""
    actor = vtkImageActor()
    actor.SetInputData(picture)
    actor.GetMapper().BorderOn()
    return actor


def pixels_of(picture, name=None):
    """A picture's values by row, the lowest first, and column."""
    data = picture.GetPointData()
    values = vtk_to_numpy(data.GetArray(name) if name else data.GetScalars())
    columns, rows, _ = picture.GetDimensions()
    return values.reshape(rows, columns, *values.shape[1:])


def painted(picture, colours):
    """A picture of the same place in other colours, three numbers up to 1 for each pixel."""
    made = vtkImageData()
    made.CopyStructure(picture)
    made.GetPointData().SetScalars(numpy_to_vtk((255 * colours).round().astype(np.uint8).reshape(-1, 3), deep=True))
    return made


def on_paper(points):
    """Places of the world in the drawing's view [px]: samples of the picture are the middles of its pixels."""
    return np.asarray(points)[:, :2] + 0.5


def resampled(line, step):
    """Places along a line, so far apart at most."""
    arc = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]
    at = np.linspace(0.0, arc[-1], int(np.ceil(arc[-1] / step)) + 1)
    return np.c_[tuple(np.interp(at, arc, line[:, k]) for k in (0, 1))]


def inked(system, width=3.0, stage="Treatment"):
    """The curves, or polylines, in the picture [px], by what they are."""
    curves = system.GetInnerOutput(stage)
    roles = vtk_to_numpy(curves.GetCellData().GetArray("Role"))
    return [(ROLES.get(role, GREY), width, on_paper(line)) for role, line in zip(roles, lines_of(curves))]


def netted(mesh, width=2.2):
    """A mesh in the plane, or one that was made of it, with its edges."""
    actor = clay(mesh, edges=True)
    look = actor.GetProperty()
    look.SetLineWidth(width)
    if mesh.GetBounds()[4] == mesh.GetBounds()[5]:
        look.LightingOff()
        look.SetColor(0.93, 0.94, 0.96)
    return actor


def ridden(system, radius=1.2):
    """The edges of the inflated front that lie on strokes, by what these are."""
    curves, surface, edges = system.GetInnerOutput("Treatment"), system.GetInnerOutput("Inflate"), system.GetStep("Refine").GetEdgesOutput()
    planar = vtk_to_numpy(surface.GetPointData().GetArray("PlanarId"))
    front = np.zeros(planar.max() + 1, int)
    front[planar[::-1]] = np.arange(len(planar))[::-1]  # the front's points come first
    points = vtk_to_numpy(surface.GetPoints().GetData())
    lines = points[front[vtk_to_numpy(edges.GetLines().GetConnectivityArray()).reshape(-1, 2)]]
    stroke_ids, strokes = (vtk_to_numpy(data.GetCellData().GetArray("StrokeId")) for data in (curves, edges))
    roles = dict(zip(stroke_ids.tolist(), vtk_to_numpy(curves.GetCellData().GetArray("Role")).tolist()))
    return [tubed(list(lines[strokes == stroke]), ROLES[role], radius) for stroke, role in roles.items() if (strokes == stroke).any()]
