#!/usr/bin/env python3
"""Figure 9.1: a turn, and a profile drawn anew. (a) a dinosaur, a line along its back and the ring; (b) the line moved and turned about
the axis beside it, so that the back rises towards the neck; (c) on what came of that, by the same line and ring, a profile with two
ridges; (d), (e), (f) their triangles.

usage: rotated_and_resketched.py [PICTURE.png]
"""
import numpy as np

from edited import edited, flat, further, in_three, turned
from grown import rounded

HEIGHTS = (0.0, 0.2, 0.42, 0.55, 0.48, 0.36, 0.48, 0.55, 0.42, 0.2, 0.0)
first = edited("dinosaur_crest", Operations="move 0.5 n 0.08; rotate 0.5 w -9")
second = further(first, ProfileData=flat(rounded(np.c_[np.linspace(0.0, 1.0, len(HEIGHTS)), HEIGHTS])))
sheet = in_three(turned((1.0, 0.75, 0.9), (0.0, 1.25, 0.0), 1.2), first, second)
sheet.save("rotated_and_resketched.png")
