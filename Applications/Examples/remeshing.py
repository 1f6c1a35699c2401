#!/usr/bin/env python3
"""Figure 11: remeshing before and after. (a) the stroke; (b) the region; (c) the region remeshed, fine where it will stretch; (d) deformed;
(e) remeshed again to its own edge length; (f) the same without remeshing.

usage: remeshing.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from oversketch import vtkOversketchOneStroke

from sheet import ORANGE, CLAY, RED, Sheet, View, clay, curve, lines_of, load

mesh, stroke = load("octopus_longer_arm")
systems = []
for remeshed in (True, False):
    system = vtkOversketchOneStroke()
    system.SetInputConnection(0, mesh.GetOutputPort())
    system.SetInputConnection(1, stroke.GetOutputPort())
    system.SetBackendToHost()
    (system.SetRemeshToOn if remeshed else system.SetRemeshToOff)()
    system.Update()
    systems.append(system)
on, off = systems

view = View(stroke.GetOutput())
pen = curve(lines_of(stroke.GetOutput()), RED)


def net(data):
    region = vtk_to_numpy(data.GetPointData().GetArray("Region"))
    triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return clay(data, np.where(region[triangles].all(axis=1)[:, None], ORANGE, CLAY), edges=True)


deformed = on.GetInnerOutput("Deform")
sheet = Sheet(columns=3, size=(520, 390))
sheet.panel(view, [clay(mesh.GetOutput())], pen)
for data in (on.GetInnerOutput("RegionBorder"), on.GetInnerOutput("Stretch"), deformed, on.GetInnerOutput("Restore"), off.GetInnerOutput("Deform")):
    sheet.panel(view, [net(data)], crop=(370, 20, 320, 240))
sheet.save("remeshing.png")
