#!/usr/bin/env python3
"""Figure 9: the seeds, blue, at the matched section of the silhouette, red, and the region that grows from them, purple. Turned
away from the view of the stroke, to show the seeds.

usage: region_growing.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from sheet import BLUE, PURPLE, RED, Sheet, View, by_region, clay, deformed, lines_of, rope

sheet = Sheet(columns=3)
SHOWN = (  # stroke, turn [degrees], part of the picture [px]
    ("hand_longer_finger", 50, (290, 385, 240, 180)),
    ("dinosaur_longer_tail", 40, (200, 200, 240, 180)),
    ("dog_curled_tail", -40, (170, 350, 240, 180)),
)
for name, turn, crop in SHOWN:
    mesh, stroke, system = deformed(name)
    grown = system.GetInnerOutput("MixtureRegion")
    seeds = vtk_to_numpy(grown.GetPointData().GetArray("RegionSeed"))[:, None] > 0
    model = mesh.GetOutput()
    view = View(stroke.GetOutput(), turn=turn, middle=model.GetCenter())
    section = rope(lines_of(system.GetInnerOutput("Match")), RED, 0.0012 * model.GetLength())
    sheet.panel(view, [clay(grown, np.where(seeds, BLUE, by_region(grown, PURPLE))), *section], crop=crop)
sheet.save("region_growing.png")
