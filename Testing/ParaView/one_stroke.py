"""In pvpython or pvbatch: the proxy makes of mesh and stroke what the class by itself makes. With HOST PORT as arguments, the
pipeline runs on that pvserver."""
import sys

import oversketch
from digest import digest
from hosts import fetched, load_plugin, model, stroke
from paraview import simple

remote = len(sys.argv) > 2
if remote:
    simple.Connect(sys.argv[1], int(sys.argv[2]))
load_plugin(globals(), remote)

for model_name, stroke_name in (("dog", "dog_longer_leg"), ("octopus", "octopus_bent_arm")):
    mesh, drawn = model(model_name), stroke(stroke_name)
    system = OversketchOneStroke(Mesh=mesh, Stroke=drawn)  # noqa: F821
    if model_name == "dog":
        system.Remesh = "Off"
    made = fetched(system)

    alone = oversketch.vtkOversketchOneStroke()
    alone.SetRemesh(2 if model_name == "dog" else 0)
    alone.SetInputDataObject(0, fetched(mesh))
    alone.SetInputDataObject(1, fetched(drawn))
    alone.Update()
    assert made.GetNumberOfPoints() > 1000
    assert digest(made) == digest(alone.GetOutput()), f"{model_name}: proxy and class differ"
    assert digest(made) != digest(fetched(mesh)), f"{model_name}: nothing moved"
    print(model_name, made.GetNumberOfPoints(), digest(made))

# The steps by hand, each from its own menu entry.
silhouette = OversketchSilhouette(Mesh=mesh, Stroke=drawn)  # noqa: F821
assert fetched(silhouette).GetNumberOfLines() > 0
diameter = OversketchShapeDiameter(Mesh=mesh)  # noqa: F821
assert fetched(diameter).GetPointData().GetArray("ShapeDiameter").GetRange()[0] > 0.0
