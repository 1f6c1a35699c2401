#!/usr/bin/env python3
"""Figure 8: the shape diameter: how far rays go that start at a vertex into the model, in a cone about its normal. (a) rays of one
vertex, to where they leave the model again; (b) the value at every vertex, thin is dark.

usage: shape_diameter.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

from oversketch import vtkOversketchShapeDiameter

from sheet import GREEN, MAGENTA, PURPLE, Sheet, View, by_value, clay, curve, load

mesh, stroke = load("dog_longer_leg")
diameter = vtkOversketchShapeDiameter()
diameter.SetInputConnection(mesh.GetOutputPort())
diameter.SetBackendToHost()
diameter.Update()

model, view = mesh.GetOutput(), View(stroke.GetOutput())
points = vtk_to_numpy(model.GetPoints().GetData())
normals = vtkPolyDataNormals()
normals.SetInputData(model)
normals.SplittingOff()
normals.Update()
normals = vtk_to_numpy(normals.GetOutput().GetPointData().GetNormals())

# A vertex on the outline of the back, so that its cone lies in the picture; rays in that plane, as many as fit to be seen.
back = np.flatnonzero(np.abs(normals @ view.view[2, :3]) < 0.05)
start = back[np.linalg.norm(view.pixels(points[back]) - (330, 370), axis=1).argmin()]
inward, across = -normals[start], np.cross(normals[start], view.view[2, :3])
angles = np.radians(np.linspace(-0.5, 0.5, 9) * diameter.GetConeAngle())
locator = vtkStaticCellLocator()
locator.SetDataSet(model)
locator.BuildLocator()
size = model.GetLength()
ends = []
for angle in angles:
    along = np.cos(angle) * inward + np.sin(angle) * across / np.linalg.norm(across)
    hit, t, where, cell = [0.0] * 3, mutable(0.0), [0.0] * 3, mutable(0)
    assert locator.IntersectWithLine(points[start] + 1e-4 * size * along, points[start] + size * along, 1e-9, t, hit, where, mutable(0), cell)
    ends.append(hit)
places = view.pixels(np.vstack([points[start], ends]))
dots = [[place] for place in places]

values = vtk_to_numpy(diameter.GetOutput().GetPointData().GetArray("ShapeDiameter"))
low, high = np.percentile(values, [2, 98])
sheet = Sheet(columns=2, size=(600, 450))
rays = curve([[places[0], end] for end in places[1:]], PURPLE, 2.0)
sheet.panel(view, [clay(model)], rays + curve(dots[1:], MAGENTA, 8.0) + curve(dots[:1], GREEN, 10.0), (200, 180, 280, 210))
sheet.panel(view, [clay(model, by_value((values - low) / (high - low)))])
sheet.save("shape_diameter.png")
