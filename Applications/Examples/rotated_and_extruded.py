#!/usr/bin/env python3
"""Figure 9.2: a turn, and an extrusion. (a) an octopus, a line down its mantle and the ring; (b) the line drawn out; (c) on what came of
that, by the same line and ring, turned about the axis beside it: a crooked horn; (d), (e), (f) their triangles.

usage: rotated_and_extruded.py [PICTURE.png]
"""
from edited import edited, further, in_three, turned

first = edited("octopus_mantle", Operations="move 0.5 n 0.3; scale 0.5 t 0.5", Layers="handle 0.5 0.4")
second = further(first, Operations="move 0.5 n 0.2; rotate 0.5 w 40", Layers="handle 0.5 0.35")
sheet = in_three(turned((1.0, 0.35, 0.8), (0.0, 1.0, 0.05), 1.7), first, second)
sheet.save("rotated_and_extruded.png")
