#!/usr/bin/env python3
"""Figure 8: a coarse mesh in the plane. (a) strokes, grey, approximated by polylines; (b) the constrained Delaunay triangulation of their
vertices, and of points thrown between them; edges on strokes in their colours.

usage: planar_meshing.py [PICTURE.png]
"""
import oversketch
from inflated import inked, netted, on_paper, system_of, view_of, whole
from sheet import GREY, Sheet, lines_of

system = system_of("fish")
oversketch.update(system)
view, sheet = view_of(system), Sheet(columns=2, size=(640, 480))
drawn = [(GREY, 2.0, on_paper(line)) for line in lines_of(system.GetInnerOutput("Treatment"))]
pieces = inked(system, 2.5, "Polyline")
dots = [(colour, 8.0, line[i:i + 1]) for colour, _, line in pieces for i in range(len(line))]
sheet.panel(view, [], drawn + pieces + dots, whole(view, 1.05))
sheet.panel(view, [netted(system.GetInnerOutput("CoarseMesh"))], pieces, whole(view, 1.05))
sheet.save("planar_meshing.png")
