#!/usr/bin/env python3
"""Figure 7: which point of the matched silhouette, blue, goes to which point of the stroke, red. (a) to the nearest one, which bunches;
(b) to the one of the same relative position along the line, as it is done.

usage: matching.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from sheet import BLUE, GREY, RED, Sheet, View, clay, curve, deformed, lines_of

mesh, stroke, system = deformed("dog_curled_tail")

view = View(stroke.GetOutput())
targets = system.GetInnerOutput("Targets")
order = np.argsort(vtk_to_numpy(targets.GetPointData().GetArray("RelativePosition")))[::6]
handles = view.pixels(vtk_to_numpy(targets.GetPoints().GetData()))[order]
goals = view.pixels(vtk_to_numpy(targets.GetPointData().GetArray("Target")))[order]
line = lines_of(system.GetInnerOutput("Stroke"))[0][:, :2]
nearest = line[np.linalg.norm(handles[:, None] - line[None], axis=2).argmin(axis=1)]

blue = curve([view.pixels(part) for part in lines_of(system.GetInnerOutput("Match"))], BLUE)
red = curve([line], RED)
crop = (60, 320, 320, 240)
sheet = Sheet(columns=2, size=(600, 450))
for ends in (nearest, goals):
    sheet.panel(view, [clay(mesh.GetOutput())], curve(np.stack([handles, ends], axis=1), GREY, 1.5) + blue + red, crop)
sheet.save("matching.png")
