#!/usr/bin/env python3
"""drawing.py PICTURE.png: three frames of vtkOversketchOneStrokeWidget: the pen is down, up, and the region is shown."""
import sys

import vtk

import oversketch
import scenes
from window import Stage, shipped


class Drawing(Stage):
    """The dog with the pen that deforms it."""

    def __init__(self, samples=0):
        reader = shipped("dog")
        self.mesh = reader.GetOutput()
        self.widget = oversketch.vtkOversketchOneStrokeWidget()
        self.widget.SetInputConnection(reader.GetOutputPort())
        self.widget.GetOneStroke().SetBackendToHost()  # the same rays whatever OpenCL device there is
        self.widget.Update()
        actor = scenes.surface(self.mesh)
        self.normals = actor.GetMapper().GetInputAlgorithm()
        self.normals.SetInputConnection(self.widget.GetOutputPort())
        super().__init__(actor, samples)
        self.look((0.05, 0.75, 0.0), 60.0 / 47.0)  # the view of the shipped stroke dog_longer_leg, at half its size
        self.start(self.widget)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    drawing, strip = Drawing(samples=8), vtk.vtkImageAppend()
    for step in (lambda: drawing.play("pen_dog_leg"), lambda: drawing.play("pen_up"), drawing.widget.ShowRegionOn):
        step()
        drawing.window.Render()
        strip.AddInputData(drawing.picture())
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(strip.GetOutputPort())
    writer.SetFileName(sys.argv[1])
    writer.Write()


if __name__ == "__main__":
    main()
