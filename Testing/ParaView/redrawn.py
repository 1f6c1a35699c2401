"""In the Python of the VTK build: what a system makes of strokes that ParaView's window told, as a digest: over a model that of one stroke,
over a picture that of a drawing.

usage: redrawn.py STATE.json VIEW_STROKE MODEL.ply|PICTURE.png"""
import json
import pathlib
import sys

import numpy
import oversketch
from digest import digest
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOPLY import vtkPLYReader

state, name, path = sys.argv[1:]
told = json.loads(pathlib.Path(state).read_text())["sources"][name]
strokes, points, lines = vtkPolyData(), vtkPoints(), vtkCellArray()
points.SetData(numpy_to_vtk(numpy.array(told["points"]), deep=True))
start = 0
for count in told["counts"]:
    lines.InsertNextCell(count, range(start, start + count))
    start += count
strokes.SetPoints(points)
strokes.SetLines(lines)
for name, kind in (("ViewTransform", float), ("ProjectionTransform", float), ("ViewportSize", numpy.int32)):
    array = numpy_to_vtk(numpy.array(told["arrays"][name], dtype=kind).reshape(len(told["counts"]), -1), deep=True)
    array.SetName(name)
    strokes.GetCellData().AddArray(array)

model = path.endswith(".ply")
over = vtkPLYReader() if model else vtkPNGReader()
over.SetFileName(path)
system = oversketch.vtkOversketchOneStroke() if model else oversketch.vtkOversketchInflateDrawing()
system.SetInputConnection(0 if model else 1, over.GetOutputPort())
system.SetInputData(1 if model else 0, strokes)
print(digest(oversketch.update(system)))
