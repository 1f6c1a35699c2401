#!/usr/bin/env python3
"""Figure 4.4: how an old curve, grey, runs over into a new one, green: their blend, red, leaves the old one, blue dots, six times as far
away as the new one's end is from it. (a) a part within; (b) over the begin and (c) over the end it extends; (d) as published the part
between is of closest places, and a bulge is lost.

usage: transitions.py [PICTURE.png]
"""
import numpy as np

import oversketch
from edited import flat, turned
from sheet import BLUE, GREEN, GREY, RED, Sheet, dotted, lines_of, rope

view = turned((0, 0, 1), (400.0, 300.0, 0.0), 600.0)
t = np.linspace(0.0, 1.0, 400)


def on_old(share):
    return np.c_[100 + 600 * share, 280 + 30 * np.sin(2 * np.pi * share)]


def bow(first, last, height, off):
    """A new curve beside the old one between two shares of it."""
    u = np.linspace(0.0, 1.0, 80)
    return on_old(first + (last - first) * u) + np.outer(off + height * np.sin(np.pi * u), (0.0, 1.0))


half, old, sheet = np.linspace(np.pi, 0.0, 80), on_old(t), Sheet(columns=2, size=(560, 280))
for new, middle in ((bow(0.38, 0.62, 55.0, 22.0), 0), (bow(-0.06, 0.35, 40.0, 18.0), 0), (bow(0.65, 1.06, 55.0, 18.0), 0),
                    (np.c_[400 + 75 * np.cos(half), 290 + 100 * np.sin(half)], 1)):
    step = oversketch.vtkOversketchResketch()
    step.SetInputData(flat(old))
    step.SetStrokeData(flat(new))
    step.SetMiddle(middle)
    blend = lines_of(oversketch.update(step))[0][:, :2]
    off = np.array([np.linalg.norm(old - place, axis=1).min() > 1.0 for place in blend])
    left = blend[np.flatnonzero(np.diff(off))[[0, -1]]]  # where it goes off the old curve, and comes back
    ends = [place for place, end in zip(left, (blend[0], blend[-1])) if np.linalg.norm(old - end, axis=1).min() <= 1.0]
    lines = [rope([np.c_[line, np.full(len(line), 10.0 * level)]], colour, radius)[0] for level, (line, colour, radius) in
             enumerate(((old, GREY, 5.0), (new, GREEN, 4.0), (blend, RED, 1.6)))]
    sheet.panel(view, lines + [dotted((*place, 30.0), BLUE, 6.0) for place in ends], crop=(60, 165, 680, 340))
sheet.save("transitions.png")
