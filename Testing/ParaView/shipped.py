"""In pvpython and in the Python of the VTK build: VTK's version, then the meshes that the shipped strokes make, remeshed and not, as
digests.

usage: shipped.py DATA"""
import pathlib
import sys

import oversketch
from digest import digest
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

print(vtkVersion.GetVTKVersion())
data = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(data))
import listing  # noqa: E402

model, stroke, system = vtkPLYReader(), vtkXMLPolyDataReader(), oversketch.vtkOversketchOneStroke()
system.SetInputConnection(0, model.GetOutputPort())
system.SetInputConnection(1, stroke.GetOutputPort())
for path in listing.one_stroke():
    model.SetFileName(str(data / "Models" / path.stem.split("_")[0]) + ".ply")
    stroke.SetFileName(str(path))
    for remesh in (system.RemeshOn, system.RemeshOff):
        system.SetRemesh(remesh)
        mesh = oversketch.update(system)
        print(path.stem, "remeshed" if remesh == system.RemeshOn else "as it is", mesh.GetNumberOfPoints(), digest(mesh))
