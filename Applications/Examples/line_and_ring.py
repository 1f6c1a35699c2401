#!/usr/bin/env python3
"""Figure 4.1: what is drawn before an edit. (a) the reference curve, red; (b) the boundary round it, blue; (c) both as chains of the
mesh's edges, and the region between them in its greys.

usage: line_and_ring.py [PICTURE.png]
"""
from edited import edited, greyed, ridden
from sheet import BLUE, RED, Sheet, View, clay, curve, drawn, lines_of

NAME = "dinosaur_crest"
system, crop = edited(NAME), (190, 195, 420, 315)
line, ring = drawn(NAME).GetOutput(), drawn(NAME + "_ring").GetOutput()
view, model = View(line), system.GetInputDataObject(0, 0)
red, blue = curve(lines_of(line), RED), curve(lines_of(ring), BLUE)
sheet = Sheet(columns=3, size=(520, 390))
sheet.panel(view, [clay(model)], red, crop)
sheet.panel(view, [clay(model)], red + blue, crop)
sheet.panel(view, [*greyed(system, edges=True), *ridden(system, 0.006)], crop=crop)
sheet.save("line_and_ring.png")
