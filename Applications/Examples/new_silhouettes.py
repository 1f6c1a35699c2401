#!/usr/bin/env python3
"""Figure 11: silhouettes drawn anew, green. Above a sail on a dinosaur's back, below fins on an octopus, one after the other; (c), (f) from
another side.

usage: new_silhouettes.py [PICTURE.png]
"""
import numpy as np

from sheet import GREEN, Sheet, clay, curve
from grown import augmented, camera, model, rounded, seen, strokes

SAIL = [(0.48, 1.46), (0.36, 1.53), (0.20, 1.70), (0.0, 1.80), (-0.20, 1.79), (-0.42, 1.64), (-0.58, 1.40), (-0.70, 1.12)]
FIN = [(0.35, 1.33), (0.46, 1.28), (0.60, 1.24), (0.67, 1.16), (0.62, 1.07), (0.50, 1.00), (0.42, 0.90)]

sheet = Sheet(columns=3, size=(520, 390))
for mesh, lines, radius, from_front, turned in (
        (model("dinosaur"), [SAIL], 0.13, camera((-0.05, 1.22, 0.0), (0, 0, 1), 2.5), camera((0.0, 1.25, 0.0), (0.7, 0.6, 1.0), 2.5)),
        (model("octopus"), [FIN, [(-x, y) for x, y in FIN]], 0.11, camera((0.0, 0.95, 0.0), (0, 0, 1), 1.5),
         camera((0.0, 0.95, -0.1), (0.55, 0.5, 1.0), 1.6))):
    view = seen(from_front)
    pens = [view.pixels(np.column_stack([rounded(np.array(line)), np.zeros(20 * len(line) - 19)])) for line in lines]
    system = augmented(mesh, strokes(pens, from_front), SketchMode=1, Radius=radius, TargetEdgeLength=0.012)
    sheet.panel(view, [clay(mesh)], curve(pens, GREEN))
    sheet.panel(view, [clay(system.GetOutput(), crease=50)])
    sheet.panel(seen(turned), [clay(system.GetOutput(), crease=50)])
sheet.save("new_silhouettes.png")
