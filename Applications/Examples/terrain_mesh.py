#!/usr/bin/env python3
"""Figure 12: a terrain that is given as triangles, here of points scattered over the shipped valley. Above as it was, with a river, yellow, and
a ridge, red; below the 4-8 mesh that was made of it directly, augmented; (b), (d) from nearer by.

usage: terrain_mesh.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkDelaunay2D

from sheet import RED, YELLOW, Sheet, View, clay, drawn, lines_of, rope
from grown import GRAY, augmented, camera, heights, seen


def triangles(count=4500):
    """So many triangles, or a few less, over the points of a grid, each a little off its place but for the border."""
    gray = heights()
    side = gray.GetDimensions()[0]
    land = GRAY * vtk_to_numpy(gray.GetPointData().GetScalars()).reshape(side, side)
    cells = int(np.sqrt(count / 2.0))
    step = (side - 1) / cells
    random, at = np.random.RandomState(3), np.arange(cells + 1) * step
    x, y = np.meshgrid(at, at)
    inside = (x > 0) & (x < side - 1), (y > 0) & (y < side - 1)
    x, y = (v + 0.6 * step * (random.rand(*v.shape) - 0.5) * free for v, free in zip((x, y), inside))
    column, row = (np.minimum(v.astype(int), side - 2) for v in (x, y))
    u, v = x - column, y - row
    z = (1 - v) * ((1 - u) * land[row, column] + u * land[row, column + 1]) + v * ((1 - u) * land[row + 1, column] + u * land[row + 1, column + 1])
    points, cloud, mesh = vtkPoints(), vtkPolyData(), vtkDelaunay2D()
    points.SetData(numpy_to_vtk(np.column_stack([v.ravel() for v in (x, y, z)]), deep=True))
    cloud.SetPoints(points)
    mesh.SetInputData(cloud)
    mesh.Update()
    return mesh.GetOutput()


pens = drawn("valley_river_ridge_road").GetOutput()
system = augmented(triangles(), pens)
mesh, result = system.GetInputDataObject(0, 0), system.GetOutput()
lines = lines_of(system.GetInnerOutput("Curves"))
near = seen(camera((100, 100, 15), (-0.25, -0.9, 0.75), 110, (0, 0, 1)))

sheet = Sheet(columns=2, size=(480, 360))
for view in (View(pens), near):
    sheet.panel(view, [clay(mesh, edges=True), *rope(lines[:1], YELLOW, 0.7), *rope(lines[1:], RED, 0.7)])
for view in (View(pens), near):
    sheet.panel(view, [clay(result, crease=60)])
sheet.save("terrain_mesh.png")
