#!/usr/bin/env python3
"""Figure 6: what strokes are. (a) each stroke in its own colour; (b) the areas between them; (c) a boundary, red, closed features, blue, open
ones, green; (d) areas within areas: lines are the strokes between two of them.

usage: classification.py [PICTURE.png]
"""
import numpy as np

import oversketch
from inflated import inked, painted, pixels_of, plate, ring, thicker, view_of
from sheet import BLUE, GREEN, GREY, MAGENTA, ORANGE, PURPLE, RED, Sheet

SIZE, RIM = (800, 600), 32.0
INKS = (RED, BLUE, MAGENTA, GREEN, PURPLE, ORANGE, GREY)
AREAS = ((1.0, 1.0, 1.0), (0.99, 0.86, 0.66), (0.73, 0.85, 0.97), (0.80, 0.93, 0.78), (0.90, 0.82, 0.95), (0.98, 0.80, 0.82))


def arch(x, y, across, up):
    turn = np.linspace(0.2 * np.pi, 0.8 * np.pi, 60)
    return np.c_[x + across * np.cos(turn), y + up * np.sin(turn)]


def between(one, other):
    """A line from the rim of one disc to that of another."""
    way = np.subtract(other, one) / np.linalg.norm(np.subtract(other, one))
    return np.array([one + RIM * way, other - RIM * way])


# A face with an eye and its pupil, a brow and a mouth; beside it a leaf with its rib.
lines = [ring(290, 300, 220, 230, 3, 0.05), ring(370, 360, 70, 52), ring(385, 362, 24, 26), arch(370, 400, 110, 60), arch(320, 250, 120, -120),
         ring(645, 320, 100, 190, 2, 0.06), np.c_[np.linspace(622, 668, 40), np.linspace(180, 460, 40)]]
drawing = oversketch.drawing(lines, SIZE, [True, True, True, False, False, True, False])
system = oversketch.vtkOversketchInflateDrawing()
system.SetInputData(0, drawing)
oversketch.update(system)

# The raster: -1 - i on stroke i, 0 outside, other areas from 1. What a stroke touches tells what it is.
raster = system.GetStep("Classify").GetLabelsOutput()
labels = pixels_of(raster, "Labels")
strokes, areas = np.ones((*labels.shape, 3)), np.array(AREAS)[np.maximum(labels, 0)]
touched = []
for stroke, colour in enumerate(INKS):
    mine = labels == -1 - stroke
    touched.append(set(labels[thicker(mine) & (labels >= 0)].tolist()))
    shown = thicker(thicker(mine))
    strokes[shown], areas[shown] = colour, GREY

# The tree: areas under where they are, each below the one that it is in.
level, links = {0: 0}, []
while any(len(pair) == 2 and len(pair - level.keys()) == 1 for pair in touched):
    for stroke, pair in enumerate(touched):
        if len(pair) == 2 and len(pair - level.keys()) == 1:
            (outer,), (inner,) = pair & level.keys(), pair - level.keys()
            level[inner] = level[outer] + 1
            links.append((stroke, outer, inner))
place = {area: (SIZE[0] / 2 if area == 0 else np.argwhere(labels == area)[:, 1].mean() * SIZE[0] / labels.shape[1], 525 - 150 * depth)
         for area, depth in level.items()}
tree = [(RED if outer == 0 else BLUE, 5.0, between(place[outer], place[inner])) for _, outer, inner in links]
for stroke, pair in enumerate(touched):
    if len(pair) == 1:  # an open feature hangs from its area
        x, y = place[min(pair)]
        aside = -110 if pair in touched[:stroke] else -60  # beside the one before it
        tree.append((GREEN, 5.0, np.array([between((x, y), (x + aside, y - 85))[0], (x + aside, y - 85)])))
for area, spot in place.items():
    tree += [(GREY, 40.0, np.array([spot])), (AREAS[area], 35.0, np.array([spot]))]

view, sheet = view_of(system), Sheet(columns=2, size=(480, 360))
sheet.panel(view, [plate(painted(raster, strokes))])
sheet.panel(view, [plate(painted(raster, areas))])
sheet.panel(view, [], inked(system, 4.0))
sheet.panel(view, [], tree)
sheet.save("classification.png")
