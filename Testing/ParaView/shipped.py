"""In pvpython and in the Python of the VTK build: VTK's version, then the meshes that the shipped strokes make, remeshed and not, the
shipped edits, the shipped drawings over their pictures, and an edit and a drawing by lines in space, as digests.

usage: shipped.py DATA"""
import hashlib
import pathlib
import sys

import oversketch
from digest import digest
from space import CAMERA, LINE, MUG, OVER_PICTURE, RING
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkPolyLineSource
from vtkmodules.vtkIOImage import vtkPNGReader
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

line, ring, profile, edit = vtkXMLPolyDataReader(), vtkXMLPolyDataReader(), vtkXMLPolyDataReader(), oversketch.vtkOversketchEdit()
for port, source in enumerate((model, line, ring)):
    edit.SetInputConnection(port, source.GetOutputPort())
for path in listing.edits():
    model.SetFileName(str(data / "Models" / path.stem.split("_")[0]) + ".ply")
    line.SetFileName(str(path))
    ring.SetFileName(str(path.with_name(path.stem + "_ring.vtp")))
    profile.SetFileName(str(data / "Edits" / (path.stem + "_profile.vtp")))
    edit.SetInputConnection(3, profile.GetOutputPort() if pathlib.Path(profile.GetFileName()).exists() else None)
    edit.SetOperations(listing.EDIT[path.stem])
    mesh = oversketch.update(edit)
    print(path.stem, "edited", mesh.GetNumberOfPoints(), digest(mesh))

picture, drawing, inflate = vtkPNGReader(), vtkXMLPolyDataReader(), oversketch.vtkOversketchInflateDrawing()
inflate.SetInputConnection(0, drawing.GetOutputPort())
inflate.SetInputConnection(1, picture.GetOutputPort())
for path in listing.drawings():
    drawing.SetFileName(str(path))
    picture.SetFileName(str(path.with_suffix(".png")))
    inflate.SetExtrudeDepth(40.0 if path.stem == "padlock" else 0.0)  # these two as Data/README.md has them
    inflate.SetQuads(path.stem == "leaf")
    mesh = oversketch.update(inflate)
    worn = hashlib.md5(vtk_to_numpy(mesh.GetPointData().GetTCoords()).tobytes()).hexdigest()
    print(path.stem, "inflated", mesh.GetNumberOfPoints(), "wears", worn, digest(mesh))


def drawn(lines, camera):
    """Polylines in space as the strokes that they are in a view."""
    together, strokes = vtkAppendPolyData(), oversketch.vtkOversketchViewStroke()
    for points, closed in lines:
        source = vtkPolyLineSource()
        source.Resize(len(points))
        for index, point in enumerate(points):
            source.SetPoint(index, *point)
        source.SetClosed(closed)
        together.AddInputConnection(source.GetOutputPort())
    strokes.SetInputConnection(together.GetOutputPort())
    for name, value in camera.items():
        getattr(strokes, "Set" + name)(value)
    return strokes


model.SetFileName(str(data / "Models" / "hand.ply"))
edit = oversketch.vtkOversketchEdit()
line, ring, mug = drawn([(LINE, 0)], CAMERA), drawn([(RING, 0)], CAMERA), drawn(MUG, OVER_PICTURE)
for port, source in enumerate((model, line, ring)):
    edit.SetInputConnection(port, source.GetOutputPort())
edit.SetOperations("move 0.5 n 0.1")
print("edited in space", digest(oversketch.update(edit)))
inflate = oversketch.vtkOversketchInflateDrawing()
picture.SetFileName(str(data / "Drawings" / "mug.png"))
inflate.SetInputConnection(0, mug.GetOutputPort())
inflate.SetInputConnection(1, picture.GetOutputPort())
inflate.SetHoles("1")
print("sketched in space", digest(oversketch.update(inflate)))
