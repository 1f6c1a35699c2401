#!/usr/bin/env python3
"""Figure 9.3: sinking, and an extrusion. (a) a hand, a line on its palm and the ring; (b) sunk, a bowl; (c) out of its ground, by the
same line and layers that were dragged in, a wall is drawn; (d), (e), (f) their triangles.

usage: sunk_and_extruded.py [PICTURE.png]
"""
from edited import edited, further, in_three, turned

first = edited("hand_palm", Operations="move 0.5 n -0.14", Layers="handle 0.5 0.75")
second = further(first, Operations="move 0.5 n 0.2", Layers="handle 0.5 0.3")
sheet = in_three(turned((0.75, 0.35, 1.0), (0.02, -0.02, 0.05), 1.15), first, second)
sheet.save("sunk_and_extruded.png")
