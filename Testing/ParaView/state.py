"""In pvpython: a state file, saved and loaded in a fresh session, gives the same meshes, parameters and driven filter included; edits by
lines that were drawn in space, on the curves of an earlier edit, by a painted image, a profile, layers of an area and handles of a file; a
drawing over its picture, and one of several lines that were drawn in space.

usage: pvpython state.py FILE.pvsm save|load"""
import sys

from digest import digest
from hosts import DATA, fetched, load_plugin, model, stroke
from paraview import servermanager, simple
from space import CAMERA, LINE, MUG, OVER_PICTURE, RING
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

EDITS = ("edited", "again", "painted", "profiled", "layered", "handled")

load_plugin(globals())
path, job = sys.argv[1:]


def drawn(lines, camera):
    """Polylines in space as the strokes that they are in a view."""
    sources = [simple.PolyLineSource(Points=[value for point in points for value in point], Closed=closed) for points, closed in lines]
    result = OversketchViewStroke(Polyline=simple.AppendGeometry(Input=sources))  # noqa: F821
    for name, value in camera.items():
        setattr(result, name, value)
    return result


def edit(name, operations, mesh, line, ring, **more):
    result = OversketchEdit(registrationName=name, Mesh=mesh, Reference=line, Boundary=ring, **more)  # noqa: F821
    result.Operations = operations
    return result


def inflate(name, strokes, picture):
    picture = png(DATA / "Drawings" / (picture + ".png"))
    return OversketchInflateDrawing(registrationName=name, Strokes=strokes, Picture=picture)  # noqa: F821


def polydata(path):
    return simple.XMLPolyDataReader(FileName=[str(path)])


def png(path):
    return simple.PNGSeriesReader(FileNames=[str(path)])


def handles(path):
    """A file with one handle, which moves the line outward at its first quarter."""
    points = vtkPoints()
    points.InsertNextPoint(0.0, 0.0, 0.0)
    data = vtkPolyData()
    data.SetPoints(points)
    for name, values in (("CurveT", [0.25]), ("Matrix", [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0.1, 0, 0, 0, 1])):
        array = vtkDoubleArray()
        array.SetName(name)
        array.SetNumberOfComponents(len(values))
        array.InsertNextTuple(values)
        data.GetPointData().AddArray(array)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    assert writer.Write()
    return path


def report():
    one = simple.FindSource("one")
    each = simple.FindSource("each")
    collection = fetched(each)
    print("one", one.Remesh, one.AdjustNormals, digest(fetched(one)))
    for name in EDITS:
        source = simple.FindSource(name)
        print(name, source.Operations, source.Layers, digest(fetched(source)))
    drawing = simple.FindSource("inflated")
    print("inflated", drawing.ExtrudeDepth, digest(fetched(drawing)))
    drawing = simple.FindSource("sketched")
    print("sketched", drawing.Holes, digest(fetched(drawing)))
    print("each", each.Filter.Remesh, [digest(collection.GetBlock(i)) for i in range(collection.GetNumberOfBlocks())])


if job == "save":
    dog, hand = model("dog"), model("hand")
    leg, finger = stroke("dog_longer_leg"), stroke("hand_longer_finger")
    one = OversketchOneStroke(registrationName="one", Mesh=dog, Stroke=leg)  # noqa: F821
    one.Remesh = "Off"
    one.AdjustNormals = 1
    models = simple.GroupDatasets(Input=[dog, hand])
    strokes = simple.GroupDatasets(Input=[leg, finger])
    models.BlockNames = strokes.BlockNames = ["first", "second"]
    each = OversketchForEach(registrationName="each", Models=models, Strokes=strokes)  # noqa: F821
    each.Filter.Remesh = "Off"
    line, ring = drawn([(LINE, 0)], CAMERA), drawn([(RING, 0)], CAMERA)
    edited = edit("edited", "move 0.5 n 0.1", hand, line, ring)
    edit("again", "rotate 0.5 t 20", edited, servermanager.OutputPort(edited, 1), servermanager.OutputPort(edited, 2))
    image = png(DATA / "Edits" / "octopus_mantle.png")
    edit("painted", "move 0.5 n 0.07", model("octopus"), stroke("octopus_mantle"), stroke("octopus_mantle_ring"), Weights=image)
    edit("profiled", "", dog, stroke("dog_back"), stroke("dog_back_ring"), Profile=polydata(DATA / "Edits" / "dog_back_profile.vtp"))
    layered = edit("layered", "move 0.5 n 0.11", model("person"), stroke("person_belly"), stroke("person_belly_ring"),
                   Areas=polydata(DATA / "Edits" / "person_belly_area.vtp"))
    layered.Layers = "handle 0.4 0.6; area 0 3; handle 0.45 0.45"
    edit("handled", "", hand, line, ring, Handles=polydata(handles(path + ".vtp")))
    inflate("inflated", polydata(DATA / "Drawings" / "fish.vtp"), "fish")
    inflate("sketched", drawn(MUG, OVER_PICTURE), "mug").Holes = "1"
    report()
    simple.SaveState(path)
    still = {digest(fetched(model(name))) for name in ("dog", "hand", "octopus", "person")}
    assert not still & {digest(fetched(simple.FindSource(name))) for name in EDITS}, "an edit that moves nothing"
else:
    simple.LoadState(path)
    report()
