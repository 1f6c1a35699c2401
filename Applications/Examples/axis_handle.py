#!/usr/bin/env python3
"""Figure 7.1: a handle, three axes at a place of the line: along it, red, beside it, green, outward, blue. (a) the handle, its axes in
thirds: the inner one moves, the middle one scales, the outer one, thin, turns; (b) moved outward; (c) and made shorter along the line at
once; (d) moved and turned about the axis beside it.

usage: axis_handle.py [PICTURE.png]
"""
import numpy as np

from edited import array, edited, ridden, shape, turned
from sheet import BLUE, GREEN, RED, Sheet, clay, curve

NAME = "dog_back"


def handle(system, view, length=0.45):
    """The axes, before the edit, thinner from third to third, over the model as the widget draws them."""
    frame = array(system.GetInnerOutput("Handles").GetPointData(), "Frame")[0].reshape(4, 4)
    return [curve([view.pixels(frame[:3, 3] + length / 3.0 * np.outer((third + 0.04, third + 0.96), frame[:3, k]))], colour, width)[0]
            for k, colour in enumerate((RED, GREEN, BLUE)) for third, width in enumerate((9.0, 6.0, 3.0))]


done = ["move 0.5 n 0.2", "move 0.5 n 0.2; scale 0.5 t 0.4", "move 0.5 n 0.2; rotate 0.5 w -28"]
sheet, view = Sheet(columns=4, size=(400, 300)), turned((0.35, 0.6, 1.0), (0.0, 0.98, 0.0), 1.25)
rest = edited(NAME, Operations="pin 0.5")
sheet.panel(view, [clay(rest.GetInputDataObject(0, 0)), *ridden(rest, 0.009)], handle(rest, view))
for operation in done:
    sheet.panel(view, shape(edited(NAME, Operations=operation)))
sheet.save("axis_handle.png")
