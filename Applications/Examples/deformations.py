#!/usr/bin/env python3
"""Figure 2: models deformed by one stroke each. Above the stroke, red, below the result: the region that moved in orange and where its
outline was in blue.

usage: deformations.py [PICTURE.png]
"""
from sheet import BLUE, RED, Sheet, View, by_region, clay, curve, deformed, lines_of

STROKES = ("dog_curled_tail", "hand_bent_thumb", "octopus_longer_arm", "person_longer_arm")

before, after = [], []
for name in STROKES:
    mesh, stroke, system = deformed(name)
    view = View(stroke.GetOutput())
    pen = curve(lines_of(stroke.GetOutput()), RED)
    was = curve([view.pixels(line) for line in lines_of(system.GetInnerOutput("Match"))], BLUE)
    # The last step that ran has the region on the points of the result.
    last = system.GetInnerOutput("Restore" if system.GetRemeshed() else "RegionBorder")
    before.append((view, [clay(mesh.GetOutput())], pen))
    after.append((view, [clay(system.GetOutput(), by_region(last))], was + pen))

sheet = Sheet(columns=len(STROKES))
for panel in before + after:
    sheet.panel(*panel)
sheet.save("deformations.png")
