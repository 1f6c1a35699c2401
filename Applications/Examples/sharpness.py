#!/usr/bin/env python3
"""Figure 8: what sharpness makes of the same stroke, red: above 0.3, soft with a steep foot, below 1.5, a sharp edge that runs out flat.
(b), (e) the feature; (c), (f) the profile, height over the distance from the stroke.

usage: sharpness.py [PICTURE.png]
"""
import numpy as np

from sheet import ORANGE, RED, GREY, Sheet, clay, curve
from grown import augmented, camera, model, seen, strokes

mesh = model("bear")
low, high = (np.array(mesh.GetBounds())[k::2] for k in (0, 1))
size = high[1] - low[1]
front = camera((0.0, low[1] + 0.42 * size, 0.0), (0, 0, 1), 0.62 * size)
t = np.linspace(0.0, 2.0 * np.pi, 120)
heart = np.c_[400 + 7.0 * 16 * np.sin(t) ** 3, 320 + 7.0 * (13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(3 * t) - np.cos(4 * t))]
drawn = strokes([heart], front)
turned = seen(camera((0.0, low[1] + 0.42 * size, 0.0), (0.5, 0.25, 1.0), 0.62 * size))

sheet = Sheet(columns=3, size=(440, 400))
for sharpness in (0.3, 1.5):
    system = augmented(mesh, drawn, Radius=0.038 * size, Height=0.032 * size, Sharpness=sharpness, TargetEdgeLength=0.003 * size)
    sheet.panel(seen(front), [clay(mesh)], curve([heart], RED), crop=(70, 0, 660, 600))
    sheet.panel(turned, [clay(system.GetOutput(), crease=60)], crop=(70, 0, 660, 600))
    x = np.linspace(-1.0, 1.0, 401)
    profile = np.c_[400 + 300 * x, 150 + 300 * (1.0 - np.abs(x)) ** sharpness]
    sheet.panel(turned, [], curve([[(60, 150), (740, 150)], [(400, 120), (400, 500)]], GREY, 1.5) + curve([profile], ORANGE, 4.0),
                crop=(70, 0, 660, 600))
sheet.save("sharpness.png")
