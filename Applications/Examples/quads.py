#!/usr/bin/env python3
"""Figure 10: triangles or quads. (a), (b) a leaf of triangles, refined by Loop's scheme: in the plane, and inflated; (c), (d) of quads, by that of
Catmull and Clark.

usage: quads.py [PICTURE.png]
"""
import oversketch
from inflated import inked, netted, system_of, view_of, whole
from sheet import Sheet

system, sheet = system_of("leaf", Levels=2, Height=0.5), Sheet(columns=2, size=(640, 480))
for quads in (False, True):
    system.SetQuads(quads)
    oversketch.update(system)
    front = view_of(system)
    sheet.panel(front, [netted(system.GetInnerOutput("Refine"))], inked(system, 1.5), whole(front, 1.02))
    sheet.panel(view_of(system, 30.0), [netted(system.GetOutput())], crop=whole(front, 0.9))
sheet.save("quads.png")
