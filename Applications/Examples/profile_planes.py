#!/usr/bin/env python3
"""Figure 6.1: the three planes of a profile. (a) the b-plane, orange, crosses the line, red, at its middle and cuts the cross-section;
lengthwise stands the t-plane, green, along the surface lies the n-plane, blue; (b) the b-plane alone, slid along the line, turns with it;
(c) the cross-sections at five places.

usage: profile_planes.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonMath import vtkMatrix4x4

from edited import array, edited, flat, ridden, turned
from sheet import BLUE, GREEN, ORANGE, Sheet, clay, rope
from grown import plane

NAME = "dog_back"


def cut_at(share):
    """The system with planes and cross-section at a place of the line; a profile is what it cuts for."""
    return edited(NAME, ProfileData=flat([(0.0, 0.0), (0.5, 0.3), (1.0, 0.0)]), ProfileAt=share)


def matrix(columns):
    result = vtkMatrix4x4()
    for i in range(3):
        for j in range(4):
            result.SetElement(i, j, columns[i, j])
    return result


def sheets(system, chosen, half=0.42):
    """The planes, smaller than they are cut with, half seen through."""
    frame = array(system.GetInnerOutput("Planes").GetFieldData(), "Frame").reshape(4, 4)
    along, side, outward, place = frame[:3].T
    actors = []
    for colour, a, b in ((BLUE, along, side), (GREEN, along, outward), (ORANGE, side, outward)):
        square = clay(plane(1, 2.0 * half))
        square.SetUserMatrix(matrix(np.column_stack([a, b, np.cross(a, b), place])))
        look = square.GetProperty()
        look.SetColor(*colour)
        look.SetOpacity(0.45)
        look.LightingOff()
        actors.append(square)
    return [actors[i] for i in chosen]


def section(system):
    return rope([vtk_to_numpy(system.GetStep("Section").GetOutputDataObject(1).GetPoints().GetData())], ORANGE, 0.011)


middle, slid = cut_at(0.5), cut_at(0.9)
model, view, sheet = middle.GetInputDataObject(0, 0), turned((0.9, 0.75, 1.0), (-0.05, 0.92, 0.0), 1.3), Sheet(columns=3, size=(520, 390))
for shown in ([*sheets(middle, (0, 1, 2)), *section(middle)], [*sheets(slid, (2,)), *section(slid)],
              [actor for share in (0.0, 0.25, 0.5, 0.75, 1.0) for actor in section(cut_at(share))]):
    sheet.panel(view, [clay(model), *ridden(middle, 0.009), *shown])
sheet.save("profile_planes.png")
