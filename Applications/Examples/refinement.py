#!/usr/bin/env python3
"""Figure 4: adaptive refinement. (a) the curve, red, and the triangles of the base with a vertex within the radius of it, yellow; (b) what
refinement makes of them: finer there, each step of size between two generations, nothing else touched.

usage: refinement.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from sheet import CLAY, RED, Sheet, clay, lines_of, rope
from grown import augmented, camera, plane, seen, strokes

above = camera((0, 0, 0), (0, 0, 1), 1.05)
t = np.linspace(0.0, 1.0, 60)
drawn = strokes([np.c_[220 + 360 * t, 300 + 130 * np.sin(5.5 * t - 0.6)]], above)
system = augmented(plane(12), drawn, Radius=0.09, TargetEdgeLength=0.02, Simplify=False)
curves = lines_of(system.GetInnerOutput("Curves"))


def near(mesh):
    """Colours of the triangles: pale yellow with a vertex within the radius, darker the nearer."""
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    away = np.min([np.linalg.norm(points - p, axis=1) for p in np.vstack(curves)], axis=0)
    within = (away < system.GetRadius())[vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)].any(axis=1)
    return np.where(within[:, None], (1.0, 0.88, 0.45), CLAY)


sheet = Sheet(columns=2, size=(600, 600))
for mesh in (system.GetInnerOutput("Base"), system.GetInnerOutput("Refine")):
    sheet.panel(seen(above), [clay(mesh, near(mesh), edges=True), *rope(curves, RED, 0.004)], crop=(100, 0, 600, 600))
sheet.save("refinement.png")
