"""What the examples of edits share: the system's run over shipped lines and rings, the region in its greys, the disc, curves."""
import json
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkProbeFilter
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkTexture

import oversketch

from grown import camera, seen
from sheet import BLUE, DATA, RED, Sheet, clay, curve, drawn, lines_of, load, rope

sys.path.insert(0, str(DATA))
from listing import EDIT  # noqa: E402
from make_edits import flat  # noqa: E402, F401

UPRIGHT = seen(camera((0.0, 0.0, 0.0), (0, 0, 1), 2.4))  # what the disc is shown in


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def text_of(handles):
    return "".join(f"handle {start!r} {end!r}; " for start, end in handles)


def beside(name):
    """Parameters that make the edit that a shipped line and ring are for, of what is beside them in Data/Edits."""
    parameters, file = {"Operations": EDIT[name]}, DATA / "Edits" / name
    if file.with_suffix(".json").exists():
        layers = json.loads(file.with_suffix(".json").read_text())
        parameters.update(Levels=layers["levels"], Layers=text_of(layers["handles"]))
        for area in layers.get("areas", []):  # one at the most, of those that are shipped
            parameters["AreasData"] = read(vtkXMLPolyDataReader(), file.with_name(area["stroke"]))
            parameters["Layers"] += f"area 0 {area['levels']}; {text_of(area['handles'])}"
    if file.with_suffix(".png").exists():
        parameters["WeightsData"] = read(vtkPNGReader(), file.with_suffix(".png"))
    if file.with_name(name + "_profile.vtp").exists():
        parameters["ProfileData"] = read(vtkXMLPolyDataReader(), file.with_name(name + "_profile.vtp"))
    return parameters


def edit(mesh, line, ring, **parameters):
    """The system, run over a mesh with a line and a ring; parameters are its properties."""
    system = oversketch.vtkOversketchEdit()
    for port, data in enumerate((mesh, line, ring)):
        system.SetInputData(port, data)
    for name, value in parameters.items():
        getattr(system, "Set" + name)(value)
    oversketch.update(system)
    return system


def edited(name, **parameters):
    """The system, run over a shipped model with its line and ring."""
    mesh, line = load(name)
    return edit(mesh.GetOutput(), line.GetOutput(), drawn(name + "_ring").GetOutput(), **parameters)


def redrawn(stroke, line):
    """A stroke, and a further one, places in its picture, that is drawn over it in the same view."""
    more, both = flat(line), vtkAppendPolyData()
    for name in ("ViewTransform", "ProjectionTransform", "ViewportSize"):
        more.GetCellData().AddArray(stroke.GetCellData().GetArray(name))
    both.AddInputData(stroke)
    both.AddInputData(more)
    both.Update()
    return both.GetOutput()


def dots(places, colour, width):
    """Dots in the picture."""
    return [each for place in places for each in curve([place[None]], colour, width)]


def array(data, name):
    return vtk_to_numpy(data.GetArray(name))


def display(system):
    """The greys on the disc: layers, or what was painted."""
    return system.GetInputDataObject(5, 0) or system.GetStep("Shading").GetDisplayOutput()


def weighed(system):
    """The mesh at rest with curves, region and weights."""
    painted = system.GetInnerOutput("Texture")
    return painted if painted.GetNumberOfPoints() else system.GetInnerOutput("Shading")


def part(mesh, chosen):
    """The triangles of a mesh that are chosen."""
    cells, result = vtkCellArray(), vtkPolyData()
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)[chosen]
    offsets = numpy_to_vtk(np.arange(0, 3 * len(corners) + 1, 3), deep=True, array_type=mesh.GetPolys().GetOffsetsArray().GetDataType())
    cells.SetData(offsets, numpy_to_vtk(corners.ravel(), deep=True, array_type=mesh.GetPolys().GetConnectivityArray().GetDataType()))
    result.SetPoints(mesh.GetPoints())
    result.SetPolys(cells)
    return result


def wearing(actor, coordinates, image):
    """An actor in the greys of an image, which are not blended: layers have edges."""
    texture, mapped = vtkTexture(), numpy_to_vtk(np.ascontiguousarray(coordinates, np.float32), deep=True)
    texture.SetInputData(image)
    texture.SetInterpolate(image.GetDimensions()[0] < 512)
    actor.GetMapper().GetInput().GetPointData().SetTCoords(mapped)
    actor.GetProperty().SetColor(1.0, 1.0, 1.0)
    actor.SetTexture(texture)
    return actor


def greyed(system, mesh=None, edges=False):
    """The model with the region in its greys: `mesh` is what a step puts out, without one the mesh at rest."""
    mesh = mesh or weighed(system)
    inside = array(mesh.GetCellData(), "EditRegion") == 2
    region = wearing(clay(part(mesh, inside), edges=edges), array(mesh.GetPointData(), "DiscCoords"), display(system))
    return [clay(part(mesh, ~inside), edges=edges), region]


def shape(system, edges=False):
    """The edited model."""
    return [clay(system.GetOutput(), edges=edges)]


def disc(system, edges=False):
    """The disc in its greys, or as a net, with the line on it; to be seen UPRIGHT."""
    flattened = system.GetStep("Flatten")
    shown = clay(flattened.GetOutputDataObject(1), edges=edges)
    if not edges:
        shown = wearing(shown, array(flattened.GetOutputDataObject(1).GetPointData(), "DiscCoords"), display(system))
    shown.GetProperty().SetAmbient(1.0)
    shown.GetProperty().SetDiffuse(0.0)
    return [shown, *rope([line + (0, 0, 0.02) for line in lines_of(flattened.GetOutputDataObject(2))], RED, 0.012)]


def on_disc(system, towards, shares):
    """Where on the disc so large shares of the way from the line's middle to the ring are done, in a direction: places of UPRIGHT [px]."""
    flattened, probe, way = system.GetStep("Flatten"), vtkProbeFilter(), vtkPolyData()
    disc = vtkPolyData()
    disc.ShallowCopy(flattened.GetOutputDataObject(1))
    distance = array(system.GetInnerOutput("Distance").GetPointData(), "CurveDistance")[array(disc.GetPointData(), "VertexId")]
    values = numpy_to_vtk(distance, deep=True)
    values.SetName("Share")
    disc.GetPointData().AddArray(values)
    line = lines_of(flattened.GetOutputDataObject(2))[0]
    radii = np.linspace(0.0, 0.97, 400)
    places = line[len(line) // 2] + np.outer(radii, np.append(np.asarray(towards, float) / np.linalg.norm(towards), 0.0))
    way.ShallowCopy(flat(places[:, :2]))
    probe.SetInputData(way)
    probe.SetSourceData(disc)
    probe.Update()
    inside = array(probe.GetOutput().GetPointData(), "vtkValidPointMask") > 0
    along = np.maximum.accumulate(array(probe.GetOutput().GetPointData(), "Share")[inside])
    return UPRIGHT.pixels(np.column_stack([np.interp(shares, along, places[inside][:, k]) for k in (0, 1, 2)]))


def at_rest(system):
    """The line and the ring in the mesh before the edit, as arrays of places; the ring ends where it begins."""
    line, mesh = vtkPolyData(), system.GetInnerOutput("Enclose")
    system.GetHold(line)
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    ring = array(system.GetStep("Enclose").GetInputDataObject(2, 0).GetPointData(), "VertexId")
    return vtk_to_numpy(line.GetPoints().GetData()), points[np.append(ring, ring[0])]


def ridden(system, radius):
    """The line, red, and the ring, blue, on the mesh before the edit."""
    line, ring = at_rest(system)
    return [*rope([line], RED, radius), *rope([ring], BLUE, radius)]


def turned(towards, focus, height, up=(0, 1, 0)):
    """An orthographic view of a place, `height` of the world in the picture."""
    return seen(camera(focus, towards, height, up))


def further(system, **parameters):
    """Another edit of what came of one, by its line and ring as they lie there."""
    return edit(*(system.GetOutputDataObject(port) for port in (0, 1, 2)), **parameters)


def in_three(view, first, second, size=(480, 360)):
    """Two edits, one on the other: the model with line and ring, and what came of each; below with the triangles."""
    sheet, model = Sheet(columns=3, size=size), first.GetInputDataObject(0, 0)
    sheet.panel(view, [clay(model), *ridden(first, 0.008)])
    sheet.panel(view, shape(first))
    sheet.panel(view, shape(second))
    sheet.panel(view, [clay(model, edges=True)])
    sheet.panel(view, shape(first, edges=True))
    sheet.panel(view, shape(second, edges=True))
    return sheet
