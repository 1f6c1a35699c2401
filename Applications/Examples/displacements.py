#!/usr/bin/env python3
"""Figure 2: the two ways to displace. Above along the surface's normal: strokes, red, become veins of an octopus. Below towards a new
silhouette, green: a person's hair is combed up; in the last picture from another side.

usage: displacements.py [PICTURE.png]
"""
from sheet import GREEN, RED, Sheet, View, clay, curve, drawn, lines_of
from grown import camera, seen, shipped

sheet = Sheet(columns=3, size=(520, 390))
for name, colour, turned, crop in (
        ("octopus_veins", RED, camera((0.0, 0.9, 0.0), (0.75, 0.45, 1.0), 1.35), (90, 70, 620, 465)),
        ("person_crest", GREEN, camera((0.0, 1.78, 0.0), (-0.7, 0.25, 0.8), 0.62), (20, 10, 760, 570))):
    system = shipped(name, SketchMode=name == "person_crest")
    stroke = drawn(name).GetOutput()
    view = View(stroke)
    sheet.panel(view, [clay(system.GetInputDataObject(0, 0))], curve(lines_of(stroke), colour), crop)
    sheet.panel(view, [clay(system.GetOutput(), crease=60)], crop=crop)
    sheet.panel(seen(turned), [clay(system.GetOutput(), crease=60)])
sheet.save("displacements.png")
