#!/usr/bin/env python3
"""Figure 3: the magnetic pen. (a) what was drawn, red, beside a heron's edges, and the corridor that is searched, orange; (b) the stroke on the edges,
blue; (c), (d) nearer by.

usage: magnetic_pen.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import oversketch
from inflated import on_paper, painted, picture_of, pixels_of, plate, resampled, system_of, view_of
from sheet import BLUE, ORANGE, RED, Sheet, lines_of

system = system_of("heron")
oversketch.update(system)
picture, view = picture_of(system), view_of(system)
drawn, snapped = ([on_paper(line) for line in lines_of(system.GetInnerOutput(name))] for name in ("Canvas", "MagneticSnap"))

# The picture, tinted where the pen searches: each pixel's distance from the strokes, as far as that counts.
colours = pixels_of(picture)[..., :3] / 255.0
radius = vtk_to_numpy(system.GetInnerOutput("Canvas").GetCellData().GetArray("SnapRadius")).max()
reach = int(radius) + 2
away = np.full(colours.shape[:2], radius + 1.0)
for line in drawn:
    for x, y in resampled(line, 0.5):
        low, left = max(int(y) - reach, 0), max(int(x) - reach, 0)
        window = away[low:int(y) + reach + 1, left:int(x) + reach + 1]
        rows, columns = np.ogrid[:window.shape[0], :window.shape[1]]
        np.minimum(window, np.hypot(rows + low + 0.5 - y, columns + left + 0.5 - x), out=window)
share = 0.45 * np.clip(radius + 0.5 - away, 0.0, 1.0)[..., None]
tinted = painted(picture, (1.0 - share) * colours + share * np.array(ORANGE))

sheet = Sheet(columns=2, size=(480, 360))
for crop, width in (((60, 520, 640, 480), 3.0), ((120, 780, 240, 180), 4.0)):
    sheet.panel(view, [plate(tinted)], [(RED, width, line) for line in drawn], crop)
    sheet.panel(view, [plate(picture)], [(BLUE, width, line) for line in snapped], crop)
sheet.save("magnetic_pen.png")
