#!/usr/bin/env python3
"""Figure 5: snapping. (a) where edges of the mesh cross the curve, red; (b) each vertex beside the curve has moved, along one of its own
edges, to the nearest crossing that no other vertex is better for: white to blue. Now edges run along the curve, and no triangle was added.

usage: snapping.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import oversketch

from sheet import BLUE, RED, Sheet, clay, curve, lines_of, snapped
from grown import augmented, camera, plane, seen, strokes

above = camera((0, 0, 0), (0, 0, 1), 0.62)
view = seen(above)
t = np.linspace(0.0, 1.0, 60)
drawn = strokes([np.c_[60 + 680 * t, 247 + 120 * t + 60 * np.sin(5.0 * t + 0.9)]], above)
system = augmented(plane(12), drawn, Radius=0.05, TargetEdgeLength=0.1, Simplify=False)
system.GetStep("Snap").SetMaximumResidualRounds(0)  # what stays crossed stays
oversketch.update(system)
before, after = system.GetInnerOutput("Refine"), system.GetInnerOutput("Snap")
line = view.pixels(lines_of(system.GetInnerOutput("Curves"))[0])


def crossings(mesh):
    """Where edges cross the line, in the picture."""
    places = view.pixels(vtk_to_numpy(mesh.GetPoints().GetData()))
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    found = []
    for a, b in np.unique(np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0):
        along = places[b] - places[a]
        side = along[0] * (line[:, 1] - places[a, 1]) - along[1] * (line[:, 0] - places[a, 0])
        for i in np.flatnonzero(side[:-1] * side[1:] < 0.0):
            place = line[i] + side[i] / (side[i] - side[i + 1]) * (line[i + 1] - line[i])
            if 0.0 < (place - places[a]) @ along / (along @ along) < 1.0:
                found.append(place[None])
    return found


here, there = (view.pixels(vtk_to_numpy(mesh.GetPoints().GetData())) for mesh in (before, after))
moved = np.flatnonzero(np.linalg.norm(here - there, axis=1) > 0.01)
dashes = [line[i:i + 2] for i in range(0, len(line) - 1, 2)]
ways = [np.array([here[i], there[i]]) for i in moved]
sheet = Sheet(columns=2, size=(640, 480))
sheet.panel(view, [clay(before, edges=True)], curve(dashes, RED, 2.0) + curve(crossings(before), RED, 9.0))
sheet.panel(view, [clay(after, edges=True)], curve([view.pixels(edge) for edge in snapped(after)], BLUE, 3.0) + curve(ways, (0.2, 0.2, 0.2), 2.0) +
            curve([here[i][None] for i in moved], (0.2, 0.2, 0.2), 9.0) + curve([here[i][None] for i in moved], (1, 1, 1), 6.0) +
            curve([there[i][None] for i in moved], BLUE, 9.0))
sheet.save("snapping.png")
