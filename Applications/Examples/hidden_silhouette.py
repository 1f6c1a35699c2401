#!/usr/bin/env python3
"""Figure 6: (a) the model; (b) its whole silhouette; (c) what of it can be seen. Circles mark where the visibility changes.

usage: hidden_silhouette.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from sheet import BLUE, RED, Sheet, View, clay, curve, deformed, lines_of

mesh, stroke, system = deformed("dinosaur_raised_neck")

model, view = mesh.GetOutput(), View(stroke.GetOutput())
whole, parted = system.GetInnerOutput("Snake"), system.GetInnerOutput("Visibility")
visible = vtk_to_numpy(parted.GetCellData().GetArray("Visible"))
of = vtk_to_numpy(parted.GetCellData().GetArray("CurveId"))
points = vtk_to_numpy(parted.GetPoints().GetData())

# Neighbouring parts of a curve, of which one is seen and the other not, meet where the visibility changes.
meeting = {}
for cell in range(parted.GetNumberOfCells()):
    ids = parted.GetCell(cell).GetPointIds()
    for end in (ids.GetId(0), ids.GetId(ids.GetNumberOfIds() - 1)):
        meeting.setdefault((of[cell], *points[end].round(6)), set()).add(bool(visible[cell]))
changes = view.pixels(np.array([key[1:] for key, seen in meeting.items() if len(seen) == 2]))
round_ = np.linspace(0.0, 2.0 * np.pi, 33)
circles = [place + 7.0 * np.c_[np.cos(round_), np.sin(round_)] for place in changes]

sheet = Sheet(columns=3)
sheet.panel(view, [clay(model)])
for curves in (whole, parted):
    blue = curve([view.pixels(line) for line in lines_of(curves)], BLUE, 2.0)
    sheet.panel(view, [], blue + (curve(circles, RED, 1.5) if curves is parted else []))
sheet.save("hidden_silhouette.png")
