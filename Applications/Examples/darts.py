#!/usr/bin/env python3
"""Figure 11: points thrown between strokes. (a) the coarse mesh of an outline without them, whose triangles span all of it, and (b) refined; (c), (d)
with them: even ones.

usage: darts.py [PICTURE.png]
"""
import oversketch
from inflated import inked, netted, ring, view_of
from sheet import Sheet

line = ring(400, 300, 300, 230, 5, 0.12)
line[:, 0] += 0.1 * (line[:, 1] - 300)  # leans: both sides alike, rounding would choose between them
system, sheet = oversketch.vtkOversketchInflateDrawing(), Sheet(columns=2, size=(560, 420))
system.SetInputData(0, oversketch.drawing([line], (800, 600), True))
system.SetLevels(2)
darts = system.GetStep("Darts")
for mode in (darts.OFF, darts.LOCAL):
    darts.SetDartMode(mode)
    oversketch.update(system)
    for stage in ("CoarseMesh", "Refine"):
        sheet.panel(view_of(system), [netted(system.GetInnerOutput(stage))], inked(system, 2.0))
sheet.save("darts.png")
