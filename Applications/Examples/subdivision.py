#!/usr/bin/env python3
"""Figure 9: refinement. (a) the coarse mesh over its strokes; (b) subdivided twice by Loop's scheme alone, which draws rims inward; (c) with new
points of edges on strokes snapped onto them.

usage: subdivision.py [PICTURE.png]
"""
from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter

import oversketch
from inflated import inked, netted, system_of, view_of
from sheet import Sheet

system = system_of("fish", Levels=2)
oversketch.update(system)
coarse, loop = system.GetInnerOutput("CoarseMesh"), vtkLoopSubdivisionFilter()
loop.SetInputData(coarse)
loop.SetNumberOfSubdivisions(2)
loop.Update()
sheet = Sheet(columns=3, size=(480, 360))
for mesh in (coarse, loop.GetOutput(), system.GetInnerOutput("Refine")):
    sheet.panel(view_of(system), [netted(mesh)], inked(system, 2.0), crop=(680, 60, 344, 258))
sheet.save("subdivision.png")
