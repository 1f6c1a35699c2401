"""In pvpython: a state file, saved and loaded in a fresh session, gives the same meshes, parameters and driven filter included.

usage: pvpython state.py FILE.pvsm save|load"""
import sys

from digest import digest
from hosts import fetched, load_plugin, model, stroke
from paraview import simple

load_plugin(globals())
path, job = sys.argv[1:]


def report():
    one = simple.FindSource("one")
    each = simple.FindSource("each")
    collection = fetched(each)
    print("one", one.Remesh, one.AdjustNormals, digest(fetched(one)))
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
    report()
    simple.SaveState(path)
else:
    simple.LoadState(path)
    report()
