#!/usr/bin/env python3
"""Figure 6: snapping keeps the levels of the mesh. (a) snapped once, coarse; (b) and (c) refined twice further, without another snap: an edge
that lies on the curve, red, is split there, so the finer edges, blue, follow it closer and closer.

usage: resolution.py [PICTURE.png]
"""
import numpy as np

import oversketch

from sheet import BLUE, RED, Sheet, clay, curve, lines_of, rope, snapped
from grown import augmented, camera, plane, seen, strokes

above = camera((0, 0, 0), (0, 0, 1), 0.9)
view = seen(above)
t = np.linspace(0.0, 1.0, 80)
angle, away = 4.6 * t + 2.4, 60 + 150 * t
drawn = strokes([np.c_[400 + away * np.cos(angle), 290 + away * np.sin(angle)]], above)
system = augmented(plane(8), drawn, Radius=0.07, TargetEdgeLength=0.12, Simplify=False)
curves, mesh = system.GetInnerOutput("Curves"), system.GetInnerOutput("Snap")
line = [view.pixels(way) for way in lines_of(curves)]

sheet = Sheet(columns=3, size=(480, 480))
for length in (None, 0.04, 0.02):
    if length:
        refine = oversketch.vtkOversketchStellarRefine()
        refine.SetInputData(0, mesh)
        refine.SetCurvesData(curves)
        refine.SetRadius(0.07)
        refine.SetTargetEdgeLength(length)
        mesh = oversketch.update(refine)
    sheet.panel(view, [clay(mesh, edges=True), *rope(snapped(mesh), BLUE, 0.003)], curve(line, RED, 2.0), crop=(150, 30, 500, 500))
sheet.save("resolution.png")
