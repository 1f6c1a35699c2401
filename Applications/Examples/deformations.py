#!/usr/bin/env python3
"""Figure 2: models deformed by one stroke each. Above the stroke, red, below the result: the region that moved in orange and where its
outline was in blue.

usage: deformations.py [PICTURE.png]
"""
import sys

from oversketch import vtkOversketchOneStroke

from sheet import BLUE, RED, Sheet, View, by_region, clay, curve, lines_of, load

STROKES = ("dog_curled_tail", "hand_bent_thumb", "octopus_longer_arm", "person_longer_arm")

before, after = [], []
for name in STROKES:
    mesh, stroke = load(name)
    system = vtkOversketchOneStroke()
    system.SetInputConnection(0, mesh.GetOutputPort())
    system.SetInputConnection(1, stroke.GetOutputPort())
    system.SetBackendToHost()
    system.Update()
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
sheet.save(sys.argv[1] if len(sys.argv) > 1 else "deformations.png")
