#!/usr/bin/env python3
"""Figure 9: features on a sphere and on a double torus. (a), (d) raised along red strokes, carved along yellow ones; (b), (e) the mesh after
refinement; (c), (f) the features.

usage: adaptive.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource

from sheet import RED, YELLOW, Sheet, clay, lines_of, rope
from grown import augmented, camera, seen, strokes

from implicit import Field, Tube  # of Data, which grown has found
from make_models import polydata
import remesh


def sphere():
    """1,280 triangles: those of an icosahedron, each in 64; facing out, which VTK 9.1's do not."""
    solid, finer = vtkPlatonicSolidSource(), vtkLinearSubdivisionFilter()
    solid.SetSolidTypeToIcosahedron()
    finer.SetInputConnection(solid.GetOutputPort())
    finer.SetNumberOfSubdivisions(3)
    finer.Update()
    points = vtk_to_numpy(finer.GetOutput().GetPoints().GetData()).astype(float)
    places, mesh = vtkPoints(), vtkPolyData()
    places.SetData(numpy_to_vtk(points / np.linalg.norm(points, axis=1, keepdims=True), deep=True))
    mesh.SetPoints(places)
    mesh.SetPolys(finer.GetOutput().GetPolys())
    outward = vtkPolyDataNormals()
    outward.SetInputData(mesh)
    outward.SplittingOff()
    outward.AutoOrientNormalsOn()
    outward.Update()
    mesh.SetPolys(outward.GetOutput().GetPolys())
    return mesh


def double_torus():
    """Two rings of tube that meet."""
    field, t = Field(), np.linspace(0.0, 2.0 * np.pi, 17)
    for side in (-1, 1):
        field.add(Tube([(x + 0.72 * side, y, 0.0, 0.30) for x, y in 0.70 * np.c_[np.cos(t), np.sin(t)]]), 0.12)
    return polydata(*remesh.even(field, 0.085))


def ring(x, y, radius, waves=0, height=0.0, first=0.0, last=360.0):
    t = np.radians(np.linspace(first, last, 160))
    away = radius + height * np.cos(waves * t)
    return np.c_[x + away * np.cos(t), y + away * np.sin(t)]


front = camera((0, 0, 0), (0.0, 0.0, 1.0), 2.3)
ball = strokes([ring(400, 300, 172, 5, 30), ring(400, 300, 52)], front, Radius=(0.16, 0.13), Height=(0.13, -0.08), Sharpness=(1.5, 1.5))
above = camera((0, 0, 0), (0.0, 0.0, 1.0), 2.6)
rings = strokes([ring(400 - 166, 300, 161, first=48, last=312), ring(400 + 166, 300, 161, 9, 14, first=-132, last=132)], above, Radius=(0.10, 0.09), Height=(0.10, -0.06))

sheet = Sheet(columns=3, size=(420, 350))
for mesh, drawn, colours, view in ((sphere(), ball, (RED, YELLOW), seen(camera((0, 0, 0), (0.35, 0.25, 1.0), 2.4))),
                                   (double_torus(), rings, (RED, YELLOW), seen(camera((0, 0, 0), (0.2, -0.6, 1.0), 2.75)))):
    system = augmented(mesh, drawn)
    thin = 0.0025 * mesh.GetLength()
    ropes = [tube for line, colour in zip(lines_of(system.GetInnerOutput("Curves")), colours) for tube in rope([line], colour, thin)]
    sheet.panel(view, [clay(mesh, edges=True), *ropes], crop=(40, 0, 720, 600))
    sheet.panel(view, [clay(system.GetInnerOutput("Refine"), edges=True)], crop=(40, 0, 720, 600))
    sheet.panel(view, [clay(system.GetOutput(), crease=40)], crop=(40, 0, 720, 600))
sheet.save("adaptive.png")
