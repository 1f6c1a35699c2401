#!/usr/bin/env python3
"""Figure 5.3: the region as the shading editor shows it. (a) on the model; (b) flat, a disc, each triangle with about the share of it
that it has of the region; (c) with the default texture of five grey levels; (d) that texture on the model.

usage: flattened.py [PICTURE.png]
"""
from edited import UPRIGHT, disc, edited, greyed, ridden, weighed
from sheet import Sheet, View, clay, drawn

NAME, CROP = "hand_palm", (255, 170, 330, 248)
system, view, sheet = edited(NAME), View(drawn(NAME).GetOutput()), Sheet(columns=4, size=(440, 330))
sheet.panel(view, [clay(weighed(system), edges=True), *ridden(system, 0.007)], crop=CROP)
sheet.panel(UPRIGHT, disc(system, edges=True))
sheet.panel(UPRIGHT, disc(system))
sheet.panel(view, greyed(system), crop=CROP)
sheet.save("flattened.png")
