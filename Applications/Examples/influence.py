#!/usr/bin/env python3
"""Figure 7.2: how far a handle reaches. Handles are dots on the line, the one that is moved orange, those that hold black. (a) alone it
takes the whole line along; (b) with a neighbour on one side it ends there, on the other at the line's end; (c) between two neighbours;
(d) two of five are moved, two humps.

usage: influence.py [PICTURE.png]
"""
from vtkmodules.vtkFiltersSources import vtkSphereSource

from edited import array, edited, ridden, shape, turned
from sheet import ORANGE, Sheet, clay, flat

NAME = "dog_back"
SETS = ("move 0.5 n 0.2", "pin 0.3; move 0.6 n 0.2", "pin 0.2; move 0.5 n 0.2; pin 0.8",
        "pin 0; move 0.25 n 0.22; pin 0.5; move 0.75 n 0.22; pin 1")


def balls(system):
    """The handles, before the edit."""
    frames = array(system.GetInnerOutput("Handles").GetPointData(), "Frame").reshape(-1, 4, 4)
    actors = []
    for frame, operation in zip(frames, system.GetOperations().split("; ")):
        ball = vtkSphereSource()
        ball.SetCenter(*frame[:3, 3])
        ball.SetRadius(0.024)
        ball.SetThetaResolution(32)
        ball.SetPhiResolution(24)
        actors.append(flat(ball, (0.1, 0.1, 0.1) if operation.startswith("pin") else ORANGE))
    return actors


sheet = Sheet(columns=4, size=(400, 300))
view, above = turned((0.35, 0.5, 1.0), (-0.08, 1.0, 0.0), 1.2), turned((0.35, 1.0, 1.0), (-0.08, 0.9, 0.0), 1.0)
systems = [edited(NAME, Operations=operations) for operations in SETS]
for system in systems:
    sheet.panel(above, [clay(system.GetInputDataObject(0, 0)), *ridden(system, 0.008), *balls(system)])
for system in systems:
    sheet.panel(view, shape(system))
sheet.save("influence.png")
