#!/usr/bin/env python3
"""Figure 1: the framework on a dog's collar. (a) feature curves, red, drawn on the mesh, a quarter of the ring in each of four views; (b) the
mesh made finer round them and nowhere else; (c) edges moved onto the curves, blue; (d) the feature, raised.

usage: augmentation.py [PICTURE.png]
"""
from sheet import BLUE, RED, Sheet, clay, lines_of, rope, snapped
from grown import by_feature, camera, seen, shipped

system = shipped("dog_collar")
mesh = system.GetInputDataObject(0, 0)
side = seen(camera((0.53, 1.13, 0.0), (0.42, 0.25, 1.0), 0.72))
thin = 0.001 * mesh.GetLength()

sheet = Sheet(columns=2, size=(480, 360))
sheet.panel(side, [clay(mesh, edges=True), *rope(lines_of(system.GetInnerOutput("Curves")), RED, 2.5 * thin)])
sheet.panel(side, [clay(system.GetInnerOutput("Refine"), edges=True)])
snap = system.GetInnerOutput("Smooth")
sheet.panel(side, [clay(snap, edges=True), *rope(snapped(snap), BLUE, thin)])
sheet.panel(side, [clay(system.GetOutput(), by_feature(system.GetOutput()), crease=60)])
sheet.save("augmentation.png")
