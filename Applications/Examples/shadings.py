#!/usr/bin/env python3
"""Figure 5.2: one line and one ring, four shadings, four shapes. Above the region in its greys, in the middle and below what comes of the
same move: (a) as shaded by default, (b) its layers dragged in, a thin sail, (c) dragged out, a plateau, (d) painted in bars across the
line.

usage: shadings.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from edited import array, edited, greyed, shape, turned
from sheet import Sheet, lines_of

NAME, MOVE = "dinosaur_crest", "move 0.5 n 0.22"


def bars(system, count=6):
    """The default weights, by turns white and black along the line: an image on the disc."""
    weights = system.GetStep("Shading").GetWeightsOutput()
    side, image = weights.GetDimensions()[0], vtkImageData()
    line = lines_of(system.GetStep("Flatten").GetOutputDataObject(2))[0][:, :2]
    along = line[-1] - line[0]
    y, x = np.mgrid[-1.0:1.0:side * 1j, -1.0:1.0:side * 1j]
    share = ((x - line[0, 0]) * along[0] + (y - line[0, 1]) * along[1]) / (along @ along)
    white = np.where(np.abs(share - 0.5) < 0.5 + 0.5 / count, 0.5 + 0.5 * np.cos(2.0 * np.pi * (count - 1) * share), 0.0)
    image.SetDimensions(side, side, 1)
    grey = (255.0 * white.ravel() * array(weights.GetPointData(), "Weight")).round().astype(np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(grey, deep=True))
    return image


systems = [edited(NAME, Operations=MOVE, **parameters) for parameters in
           ({}, {"Layers": "handle 0.5 0.3"}, {"Layers": "handle 0.5 0.8"}, {"WeightsData": bars(edited(NAME))})]
sheet, middle = Sheet(columns=4, size=(400, 300)), (0.0, 1.25, 0.0)
above, beside = turned((0.0, 1.0, 0.8), middle, 0.95), turned((0.9, 0.55, 1.0), (0.0, 1.25, 0.0), 1.1)
for view, actors in ((above, greyed), (beside, shape), (beside, lambda system: shape(system, edges=True))):
    for system in systems:
        sheet.panel(view, actors(system))
sheet.save("shadings.png")
