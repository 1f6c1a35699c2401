#!/usr/bin/env python3
"""Figure 14: three strokes, one after the other. (a) the height image; (b), (c), (d) the mesh so far and the next stroke, yellow where it cuts
in and red where it raises; (e) all three; (f) the mesh: each stroke made finer what it reached, whatever was there.

usage: terrain_strokes.py [PICTURE.png]
"""
import numpy as np

from sheet import RED, YELLOW, Sheet, clay, curve
from grown import augmented, camera, heights, plate, rounded, seen, strokes, terrain

by = camera((96, 84, 15), (0.0, -0.6, 1.0), 175, (0, 0, 1))
view = seen(by)
# Height, radius, sharpness and course [px] of a river, a wall across its valley and a road over that.
STROKES = ((-3.0, 5.0, 1.2, [(232, 440), (246, 400), (285, 345), (318, 305), (368, 285), (392, 255), (374, 215), (332, 180), (306, 158), (340, 120),
                             (388, 85)]),
           (3.5, 6.0, 1.2, [(215, 165), (290, 205), (384, 236), (480, 250), (600, 290)]),
           (2.0, 4.5, 0.8, [(620, 470), (560, 400), (500, 330), (482, 270), (500, 200), (560, 130), (640, 90)]))

sheet = Sheet(columns=3, size=(480, 360))
sheet.panel(*plate(heights()))
mesh = terrain().GetOutput()
for height, radius, sharpness, line in STROKES:
    pen = rounded(np.array(line, float))
    sheet.panel(view, [clay(mesh, crease=60)], curve([pen], RED if height > 0 else YELLOW))
    mesh = augmented(mesh, strokes([pen], by), Height=height, Radius=radius, Sharpness=sharpness).GetOutput()
sheet.panel(view, [clay(mesh, crease=60)])
sheet.panel(view, [clay(mesh, edges=True)])
sheet.save("terrain_strokes.png")
