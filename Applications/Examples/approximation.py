#!/usr/bin/env python3
"""Figure 7: strokes as polylines of few vertices. (a) at corners alone, where the direction changes; (b) split where a stroke is farther from its
piece than 0.05 of the canvas, as published; (c) than a fourth of the thickness there, by default.

usage: approximation.py [PICTURE.png]
"""
import oversketch
from inflated import on_paper, system_of, view_of, whole
from sheet import GREY, RED, Sheet, lines_of

system = system_of("fish")
oversketch.update(system)
distance = system.GetStep("Distance")
view, sheet = view_of(system), Sheet(columns=3, size=(480, 360))
drawn = [(GREY, 2.0, on_paper(line)) for line in lines_of(system.GetInnerOutput("Treatment"))]
for fixed, tolerance in ((True, 1.0), (True, 0.05), (False, 0.05)):
    polyline = oversketch.vtkOversketchPolyline()
    polyline.SetInputData(0, distance.GetOutputDataObject(0))
    polyline.SetDistanceData(distance.GetOutputDataObject(1))
    polyline.SetDeltaMode(polyline.FIXED if fixed else polyline.ADAPTIVE)
    polyline.SetTolerance(tolerance)
    found = [on_paper(line) for line in lines_of(oversketch.update(polyline))]
    sheet.panel(view, [], drawn + [(RED, 2.0, line) for line in found] + [(RED, 7.0, line[i:i + 1]) for line in found for i in range(len(line))],
                whole(view, 1.05))
sheet.save("approximation.png")
