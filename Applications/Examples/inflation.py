#!/usr/bin/env python3
"""Figure 12: what becomes of a drawing. (a) strokes over a picture: a boundary, red, closed features, blue, open ones, green; (b), (c) inflated,
its picture on it; (d) an outline with a keyhole and a shackle; (e), (f) extruded, the keyhole a tunnel, what the shackle spans a hole.

usage: inflation.py [PICTURE.png]
"""
import sys

import numpy as np
import vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

import oversketch
from sheet import BLUE, DATA, GREEN, GREY, RED, Sheet, View, lines_of, textured

ROLES = {1: RED, 2: BLUE, 3: GREEN}


def system_of(name):
    """The system on a shipped drawing and its picture."""
    picture, strokes, system = vtk.vtkPNGReader(), vtk.vtkXMLPolyDataReader(), oversketch.vtkOversketchInflateDrawing()
    picture.SetFileName(str(DATA / "Drawings" / (name + ".png")))
    strokes.SetFileName(str(DATA / "Drawings" / (name + ".vtp")))
    system.SetInputConnection(0, strokes.GetOutputPort())
    system.SetInputConnection(1, picture.GetOutputPort())
    return system


def plate(picture):
    """The picture itself, at z = 0."""
    actor = vtk.vtkImageActor()
    actor.SetInputData(picture)
    actor.GetMapper().BorderOn()
    return actor


def inked(system):
    """The curves in the picture [px], by what they are."""
    curves = system.GetInnerOutput("Treatment")
    roles = vtk_to_numpy(curves.GetCellData().GetArray("Role"))
    return [(ROLES.get(role, GREY), 3.0, line[:, :2] + 0.5) for role, line in zip(roles, lines_of(curves))]


def panels(sheet, system, turns):
    oversketch.update(system)
    strokes, picture = system.GetInputDataObject(0, 0), system.GetInputDataObject(1, 0)
    middle = np.array(picture.GetCenter())
    front = View(strokes)
    width, height = front.size
    crop = (0.5 * width - 0.6 * max(width, 4 * height / 3), 0.5 * height - 0.45 * max(width, 4 * height / 3),
            1.2 * max(width, 4 * height / 3), 0.9 * max(width, 4 * height / 3))
    sheet.panel(front, [plate(picture)], inked(system), crop)
    for turn in turns:
        sheet.panel(View(strokes, turn, middle), [textured(system.GetOutput(), picture)], crop=crop)


if __name__ == "__main__":
    page = Sheet(columns=3)
    panels(page, system_of("fish"), (-40.0, 55.0))
    lock = system_of("padlock")
    lock.SetExtrudeDepth(60.0)
    panels(page, lock, (-40.0, 30.0))
    page.save(sys.argv[1] if len(sys.argv) > 1 else "inflation.png")
