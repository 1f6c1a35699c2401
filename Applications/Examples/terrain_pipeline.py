#!/usr/bin/env python3
"""Figure 13: from a height image to an augmented terrain. (a) the image; (b) the coarse 4-8 mesh of it and the strokes: a river, yellow, a
ridge and a road, red; (c) refined round them; (d) the features.

usage: terrain_pipeline.py [PICTURE.png]
"""
from sheet import RED, YELLOW, Sheet, View, clay, drawn, lines_of, rope
from grown import heights, plate, shipped

system = shipped("valley_river_ridge_road")
lines = lines_of(system.GetInnerOutput("Curves"))
view = View(drawn("valley_river_ridge_road").GetOutput())

sheet = Sheet(columns=2, size=(480, 360))
sheet.panel(*plate(heights()))
sheet.panel(view, [clay(system.GetInnerOutput("Base"), edges=True), *rope(lines[:1], YELLOW, 0.7), *rope(lines[1:], RED, 0.7)])
sheet.panel(view, [clay(system.GetInnerOutput("Refine"), edges=True)])
sheet.panel(view, [clay(system.GetOutput(), crease=60)])
sheet.save("terrain_pipeline.png")
