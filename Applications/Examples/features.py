#!/usr/bin/env python3
"""Figure 16: the mesh follows what was drawn. (a) a fish's head with its strokes; (b) the mesh in the plane, edges on each stroke; (c), (d) as
inflated: the same edges, ready for another tool to pull at.

usage: features.py [PICTURE.png]
"""
import oversketch
from inflated import inked, netted, picture_of, plate, ridden, system_of, view_of
from sheet import Sheet, textured

system = system_of("fish")
mesh = oversketch.update(system)
front, side, picture, crop = view_of(system), view_of(system, -35.0), picture_of(system), (90, 120, 480, 360)
sheet = Sheet(columns=2, size=(560, 420))
sheet.panel(front, [plate(picture)], inked(system, 3.0), crop)
sheet.panel(front, [netted(system.GetInnerOutput("Refine"))], inked(system, 2.5), crop)
sheet.panel(side, [netted(mesh), *ridden(system)], crop=crop)
sheet.panel(side, [textured(mesh, picture), *ridden(system)], crop=crop)
sheet.save("features.png")
