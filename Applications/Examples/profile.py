#!/usr/bin/env python3
"""Figure 6.2: the profile editor. (a) the cross-section on the mesh, from orange on its left to blue on its right; (b) the same, flat,
from ring to ring, and the arrow outward; (c) drawn anew, black; (d) the mesh follows along the whole line; (e) its triangles; (f) cut
again: black as drawn, coloured as it is.

usage: profile.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

import oversketch
from edited import beside, edited, ridden, shape, turned
from sheet import BLUE, GREY, ORANGE, Sheet, clay, lines_of, rope

NAME, BLACK = "dog_back", (0.1, 0.1, 0.1)


def graded(line, radius):
    """A line as a rope, orange to blue."""
    share = np.linspace(0.0, 1.0, 25)
    ends = np.searchsorted(np.linspace(0.0, 1.0, len(line)), share, side="right")
    return [rope([line[max(a - 1, 0):b]], (1.0 - s) * np.array(ORANGE) + s * np.array(BLUE), radius)[0]
            for s, a, b in zip(share[1:], ends, ends[1:]) if b > max(a - 1, 0) + 1]


def recut(system):
    """The cross-section of the moved mesh in the plane of the first one."""
    step, again, mesh = system.GetStep("Section"), oversketch.vtkOversketchCrossSection(), vtkPolyData()
    mesh.ShallowCopy(system.GetInnerOutput("Bend"))
    again.SetInputData(mesh)
    again.SetBoundaryData(step.GetInputDataObject(1, 0))
    again.SetPlanesData(system.GetInnerOutput("Planes"))
    oversketch.update(again)
    matrix = vtk_to_numpy(system.GetInnerOutput("Section").GetFieldData().GetArray("ProfileMatrix")).reshape(4, 4)
    points = vtk_to_numpy(again.GetOutputDataObject(1).GetPoints().GetData())
    return (np.c_[points, np.ones(len(points))] @ np.linalg.inv(matrix).T)[:, :3] * (1, 1, 0)


system = edited(NAME, **beside(NAME))
on_mesh = vtk_to_numpy(system.GetStep("Section").GetOutputDataObject(1).GetPoints().GetData())
section, drawn_anew = lines_of(system.GetInnerOutput("Section"))[0], lines_of(system.GetInputDataObject(3, 0))[0]
model, view = system.GetInputDataObject(0, 0), turned((0.9, 0.75, 1.0), (-0.08, 0.95, 0.0), 1.1)
window = turned((0, 0, 1), (0.5, 0.27, 0.0), 0.95)
arrow = rope([np.array(line) for line in ([(0.5, -0.1, 0.0), (0.5, 0.66, 0.0)], [(0.47, 0.6, 0.0), (0.5, 0.66, 0.0), (0.53, 0.6, 0.0)])],
             GREY, 0.004)
black, old, sheet = rope([drawn_anew + (0, 0, 0.1)], BLACK, 0.007), graded(section, 0.012), Sheet(columns=3, size=(520, 390))
sheet.panel(view, [clay(model), *ridden(system, 0.008), *graded(on_mesh, 0.013)])
sheet.panel(window, [*old, *arrow])
sheet.panel(window, [*old, *black])
sheet.panel(view, shape(system))
sheet.panel(view, shape(system, edges=True))
sheet.panel(window, [*graded(recut(system), 0.016), *black])
sheet.save("profile.png")
