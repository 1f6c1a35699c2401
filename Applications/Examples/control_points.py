#!/usr/bin/env python3
"""Figure 4.2: evenly spaced control points. (a) the pen's samples, wherever the hand was slow many; (b) those that are left, 10 px apart
at the least, and the spline that they control; (c) the spline on the mesh, sampled evenly, each sample a vertex.

usage: control_points.py [PICTURE.png]
"""
from vtkmodules.util.numpy_support import vtk_to_numpy

from edited import dots, edited
from sheet import BLUE, GREY, RED, Sheet, View, clay, curve, drawn, lines_of

NAME = "hand_palm"
system, crop = edited(NAME), (345, 255, 160, 120)
line = drawn(NAME).GetOutput()
view, model = View(line), system.GetInputDataObject(0, 0)
fit = system.GetInnerOutput("ReferenceFit")
controls = vtk_to_numpy(fit.GetFieldData().GetArray("NurbsPoints"))[:, :2]
spline, on_mesh = lines_of(fit)[0], lines_of(system.GetInnerOutput("ReferenceProject"))[0]


sheet = Sheet(columns=3, size=(520, 390))
sheet.panel(view, [clay(model)], dots(lines_of(line)[0], RED, 4.0), crop)
sheet.panel(view, [clay(model)], curve([controls], GREY, 1.5) + curve([spline], RED) + dots(controls, BLUE, 9.0), crop)
sheet.panel(view, [clay(system.GetInnerOutput("ReferenceInsert"), edges=True)],
            curve([view.pixels(on_mesh)], RED) + dots(view.pixels(on_mesh), BLUE, 9.0), crop)
sheet.save("control_points.png")
