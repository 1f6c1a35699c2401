#!/usr/bin/env python3
"""Figure 10: the sign of the height. (a), (b) below 0 strokes, yellow, cut inward: the lines of a palm; (c), (d) above 0, red, they raise
spines along a dinosaur's back.

usage: inward_outward.py [PICTURE.png]
"""
from sheet import RED, YELLOW, Sheet, clay, lines_of, rope
from grown import camera, seen, shipped

sheet = Sheet(columns=2, size=(640, 480))
for name, colour, view in (("hand_palm_lines", YELLOW, seen(camera((-0.08, 0.22, 0.0), (-0.25, 0.05, 1.0), 2.35))),
                           ("dinosaur_spines", RED, seen(camera((-0.1, 1.22, 0.0), (0.35, 0.35, 1.0), 3.1)))):
    system = shipped(name)
    mesh = system.GetInputDataObject(0, 0)
    sheet.panel(view, [clay(mesh), *rope(lines_of(system.GetInnerOutput("Curves")), colour, 0.0025 * mesh.GetLength())])
    sheet.panel(view, [clay(system.GetOutput(), crease=50)])
sheet.save("inward_outward.png")
