"""In pvpython: a state file, saved and loaded in a fresh session, gives the same meshes, parameters and driven filter included; edits by lines
that were drawn in space, on the curves of an earlier edit, and by a painted image.

usage: pvpython state.py FILE.pvsm save|load"""
import sys

from digest import digest
from hosts import DATA, fetched, load_plugin, model, stroke
from paraview import servermanager, simple
from space import CAMERA, LINE, RING

load_plugin(globals())
path, job = sys.argv[1:]


def drawn(points):
    """A polyline in space as the stroke that it is in the palm's view."""
    line = simple.PolyLineSource(Points=[value for point in points for value in point])
    result = OversketchViewStroke(Polyline=line)  # noqa: F821
    for name, value in CAMERA.items():
        setattr(result, name, value)
    return result


def edit(name, operations, mesh, line, ring, **more):
    result = OversketchEdit(registrationName=name, Mesh=mesh, Reference=line, Boundary=ring, **more)  # noqa: F821
    result.Operations = operations
    return result


def report():
    one = simple.FindSource("one")
    each = simple.FindSource("each")
    collection = fetched(each)
    print("one", one.Remesh, one.AdjustNormals, digest(fetched(one)))
    for name in ("edited", "again", "painted"):
        source = simple.FindSource(name)
        print(name, source.Operations, digest(fetched(source)))
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
    edited = edit("edited", "move 0.5 n 0.1", hand, drawn(LINE), drawn(RING))
    edit("again", "rotate 0.5 t 20", edited, servermanager.OutputPort(edited, 1), servermanager.OutputPort(edited, 2))
    image = simple.PNGSeriesReader(FileNames=[str(DATA / "Edits" / "octopus_mantle.png")])
    edit("painted", "move 0.5 n 0.07", model("octopus"), stroke("octopus_mantle"), stroke("octopus_mantle_ring"), Weights=image)
    report()
    simple.SaveState(path)
else:
    simple.LoadState(path)
    report()
