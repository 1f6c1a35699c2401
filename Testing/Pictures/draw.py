#!/usr/bin/env python3
"""draw.py MESH.ply STROKE.vtp PICTURE.png: the mesh as it is and the stroke over it, in the stroke's view."""
import sys

from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import scenes

if len(sys.argv) != 4:
    sys.exit(__doc__)
mesh, stroke = vtkPLYReader(), vtkXMLPolyDataReader()
mesh.SetFileName(sys.argv[1])
mesh.Update()
stroke.SetFileName(sys.argv[2])
stroke.Update()
view = scenes.View(stroke.GetOutput())
writer = vtkPNGWriter()
writer.SetFileName(sys.argv[3])
writer.SetInputData(scenes.image(scenes.window(view, [scenes.surface(mesh.GetOutput())], [scenes.pen(stroke.GetOutput())], 8)))
writer.Write()
