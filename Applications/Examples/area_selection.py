#!/usr/bin/env python3
"""Figure 5.5: an area of the disc with layers of its own. (a) the lasso, orange, crosses itself: inside is what it goes round an odd
number of times; (b) eleven levels there, five round them, and the same weights; (c) a handle dragged out there, blended with what is
round it over 0.4 of the disc's radius. Below the same move as (a), (b) and (c) weigh it, in the greys and without.

usage: area_selection.py [PICTURE.png]
"""
import numpy as np

from edited import UPRIGHT, disc, edited, flat, greyed, shape, turned
from sheet import ORANGE, Sheet, curve

NAME, MOVE = "hand_palm", "move 0.5 n 0.18"
turn = np.linspace(0.0, 2.0 * np.pi, 300)
radius = 0.30 + 0.44 * np.cos(turn)
lasso = np.c_[-0.12 - radius * np.sin(turn + 0.9), 0.12 + radius * np.cos(turn + 0.9)]
drawn = curve([UPRIGHT.pixels(np.c_[lasso, np.zeros(len(lasso))])], ORANGE, 2.5)
whole = edited(NAME, Operations=MOVE)
levels, dragged = (edited(NAME, Operations=MOVE, AreasData=flat(lasso), Layers=text, Feather=0.4)
                   for text in ("area 0 11", "area 0 5; handle 0.35 0.65"))
sheet, front = Sheet(columns=3, size=(440, 330)), turned((0.3, 0.2, 1.0), (0.0, -0.05, 0.1), 1.05)
for system, marks in ((whole, drawn), (levels, ()), (dragged, drawn)):
    sheet.panel(UPRIGHT, disc(system), marks)
for system in (whole, levels, dragged):
    sheet.panel(front, greyed(system, system.GetInnerOutput("Retriangulate")))
for system in (whole, levels, dragged):
    sheet.panel(front, shape(system))
sheet.save("area_selection.png")
