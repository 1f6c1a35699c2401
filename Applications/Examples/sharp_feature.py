#!/usr/bin/env python3
"""Figure 7: a sharp feature without snapping, above, and with it, below. (a), (c) the mesh and the curve, red; (b), (d) raised: where no edges
lie along the curve the crest is a saw, of vertices that happen to be near it.

usage: sharp_feature.py [PICTURE.png]
"""
import numpy as np

import oversketch

from sheet import RED, Sheet, clay, lines_of, rope
from grown import augmented, camera, plane, seen, strokes

above = camera((0, 0, 0), (0, 0, 1), 1.0)
t = np.linspace(0.0, 1.0, 80)
drawn = strokes([np.c_[400 + 170 * np.sin(2 * np.pi * t) * (1 - 0.25 * t), 460 - 320 * t]], above)
system = augmented(plane(14), drawn, Radius=0.09, Height=0.10, TargetEdgeLength=0.035, Simplify=False)
curves = system.GetInnerOutput("Curves")
rough = oversketch.vtkOversketchStellarDisplace()
rough.SetInputData(0, system.GetInnerOutput("Refine"))
rough.SetCurvesData(curves)
rough.SetRadius(0.09)
rough.SetHeight(0.10)

sheet = Sheet(columns=2, size=(480, 330))
slanted = seen(camera((0, 0.0, 0.02), (0.25, -1.0, 0.85), 0.72, (0, 0, 1)))
for before, after in ((system.GetInnerOutput("Refine"), oversketch.update(rough)), (system.GetInnerOutput("Smooth"), system.GetOutput())):
    sheet.panel(slanted, [clay(before, edges=True), *rope(lines_of(curves), RED, 0.003)], crop=(0, 25, 800, 550))
    sheet.panel(slanted, [clay(after, crease=35)], crop=(0, 25, 800, 550))
sheet.save("sharp_feature.png")
