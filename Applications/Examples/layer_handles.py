#!/usr/bin/env python3
"""Figure 5.4: handles on layers: each was placed at a white dot and dragged to the orange one. (a) none; (b) one, dragged in, moves all
layers; (c) one dragged onto the line makes the inner ones vanish; (d) of three the middle one moves only those between its neighbours.
Below what the same move makes.

usage: layer_handles.py [PICTURE.png]
"""
from edited import UPRIGHT, disc, dots, edited, on_disc, shape, text_of, turned
from sheet import ORANGE, Sheet

NAME, MOVE, TOWARDS = "hand_palm", "move 0.5 n 0.22", (-1.0, 0.9)
HANDLES = ((), ((0.6, 0.35),), ((0.3, 0.0),), ((0.2, 0.2), (0.5, 0.7), (0.92, 0.92)))

systems = [edited(NAME, Operations=MOVE, Layers=text_of(handles)) for handles in HANDLES]
sheet, side = Sheet(columns=4, size=(400, 300)), turned((0.9, 0.1, 1.0), (0.0, -0.05, 0.1), 1.25)
for system, handles in zip(systems, HANDLES):
    marks = []
    for start, end in handles:
        placed, dragged = on_disc(system, TOWARDS, [start, end])
        marks += dots([placed], (0.3, 0.3, 0.3), 15.0) + dots([placed], (1.0, 1.0, 1.0), 11.0)
        marks += dots([dragged], (0.3, 0.3, 0.3), 15.0) + dots([dragged], ORANGE, 11.0)
    sheet.panel(UPRIGHT, disc(system), marks)
for system in systems:
    sheet.panel(side, shape(system))
sheet.save("layer_handles.png")
