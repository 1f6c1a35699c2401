#!/usr/bin/env python3
"""Figure 3: where the silhouette runs over the mesh. Vertices whose normal looks towards the eye are white dots, those that look away
black ones; the trace, magenta, crosses each edge between the two where the normal, interpolated along it, is at right angles to the view.

usage: silhouette_traces.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

from oversketch import vtkOversketchSilhouette

from sheet import MAGENTA, Sheet, View, clay, curve, lines_of, load, rope

mesh, stroke = load("dog_longer_leg")
silhouette = vtkOversketchSilhouette()
silhouette.SetInputConnection(0, mesh.GetOutputPort())
silhouette.SetInputConnection(1, stroke.GetOutputPort())
silhouette.Update()

model = mesh.GetOutput()
seen_by = View(stroke.GetOutput())
turned = View(stroke.GetOutput(), turn=-50, middle=model.GetCenter())

normals = vtkPolyDataNormals()
normals.SetInputData(model)
normals.SplittingOff()
normals.Update()
towards = vtk_to_numpy(normals.GetOutput().GetPointData().GetNormals()) @ seen_by.view[2, :3] > 0.0
facing = vtk_to_numpy(normals.GetOutput().GetPointData().GetNormals()) @ turned.view[2, :3] > 0.1
places = turned.pixels(vtk_to_numpy(model.GetPoints().GetData()))
lines = lines_of(silhouette.GetOutput())


def dots(crop):
    left, bottom, width, height = crop
    inside = (places[:, 0] > left) & (places[:, 0] < left + width) & (places[:, 1] > bottom) & (places[:, 1] < bottom + height)
    found = []
    for i in np.flatnonzero(inside & facing):
        dot = [places[i:i + 1]]
        found += curve(dot, (0.1, 0.1, 0.1), 9.0) + curve(dot, (1.0, 1.0, 1.0) if towards[i] else (0.1, 0.1, 0.1), 7.0)
    return found


sheet = Sheet(columns=2, size=(600, 450))
sheet.panel(turned, [clay(model), *rope(lines, MAGENTA, 0.003 * model.GetLength())])
close = (290, 352, 48, 36)
sheet.panel(turned, [clay(model, edges=True), *rope(lines, MAGENTA, 0.0005 * model.GetLength())], dots(close), close)
sheet.save("silhouette_traces.png")
