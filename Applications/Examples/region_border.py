#!/usr/bin/env python3
"""Figure 10: smoothing the region's border. Vertices that stick out of it are taken away (triangles red, none
here), notches are filled (green).

usage: region_border.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from oversketch import vtkOversketchRegionBorder

from sheet import CLAY, GREEN, ORANGE, RED, Sheet, View, clay, deformed

mesh, stroke, system = deformed("dog_longer_leg", AsPublished=True)  # the border as the mixtures leave it, ragged
border = vtkOversketchRegionBorder()
border.SetInputData(system.GetInnerOutput("MixtureRegion"))
border.Update()


def inside(data):
    """Triangles whose three vertices are in the region."""
    region = vtk_to_numpy(data.GetPointData().GetArray("Region"))
    return region[vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)].all(axis=1)[:, None]


before, after = inside(border.GetInput()), inside(border.GetOutput())
colours = np.where(before & after, ORANGE, np.where(before, RED, np.where(after, GREEN, CLAY)))
view = View(stroke.GetOutput())
crop = (440, 220, 96, 72)
sheet = Sheet(columns=2, size=(600, 450))
sheet.panel(view, [clay(mesh.GetOutput(), np.where(before, ORANGE, CLAY), edges=True)], crop=crop)
sheet.panel(view, [clay(mesh.GetOutput(), colours, edges=True)], crop=crop)
sheet.save("region_border.png")
