#!/usr/bin/env python3
"""Figure 1: what happens between the stroke and the deformed model.

(a) the model and the stroke; (b) the silhouette of the mesh as it is, around the head, seen from the side; (c) the same after smoothing by the snake; (d)
the matched section, blue, and where it is to go, red; (e) the shape diameter, thin is dark; (f) how probably each vertex belongs to the
region, by the two Gaussian mixtures; (g) the region; (h) the result.

usage: working_procedure.py [PICTURE.png]
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from oversketch import vtkOversketchOneStroke

from sheet import BLUE, RED, Sheet, View, by_region, by_value, clay, curve, lines_of, load, rope

mesh, stroke = load("dinosaur_raised_neck")
system = vtkOversketchOneStroke()
system.SetInputConnection(0, mesh.GetOutputPort())
system.SetInputConnection(1, stroke.GetOutputPort())
system.SetBackendToHost()
system.GetStep("ShapeDiameter").OnDemandOff()  # a stroke asks for a part of it, the picture shows all
system.Update()

model, drawn = mesh.GetOutput(), stroke.GetOutput()
front, side = View(drawn), View(drawn, turn=-60, middle=model.GetCenter())
head = (436, 414, 140, 105)  # left, bottom, width, height in the picture seen from the side [px]
inner = system.GetInnerOutput
pen = curve(lines_of(drawn), RED)


def blue(name):
    return rope(lines_of(inner(name)), BLUE, 0.0015 * model.GetLength())


section = curve([front.pixels(line) for line in lines_of(inner("Match"))], BLUE, 2.0)
targets = vtk_to_numpy(inner("Targets").GetPointData().GetArray("Target"))
order = np.argsort(vtk_to_numpy(inner("Targets").GetPointData().GetArray("RelativePosition")))
thickness = vtk_to_numpy(inner("ShapeDiameter").GetPointData().GetArray("ShapeDiameter"))
low, high = np.percentile(thickness, [2, 98])
probability = vtk_to_numpy(inner("MixtureRegion").GetPointData().GetArray("RegionProbability"))

sheet = Sheet(columns=4)
sheet.panel(front, [clay(model)], pen)
sheet.panel(side, [clay(model), *blue("Silhouette")], crop=head)
sheet.panel(side, [clay(model), *blue("Snake")], crop=head)
sheet.panel(front, [clay(model)], section + curve([front.pixels(targets[order])], RED))
sheet.panel(front, [clay(model, by_value((thickness - low) / (high - low)))])
sheet.panel(front, [clay(model, by_value(probability))])
sheet.panel(front, [clay(model, by_region(inner("RegionBorder")))], section)
sheet.panel(front, [clay(system.GetOutput())], pen)
sheet.save("working_procedure.png")
