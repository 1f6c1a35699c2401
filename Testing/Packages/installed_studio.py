"""The installed Studio opens on its model, shows it, and closes: installed_studio.py PICTURE.png

desk.py of Testing/Studio lies beside it, or on PYTHONPATH.
"""
import os
import pathlib
import sys
import tempfile
import time

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGWriter

os.environ.setdefault("OVERSKETCH_STUDIO", "oversketch-studio")
from desk import Desk, Studio, until  # noqa: E402

desk = Desk()
studio = Studio(pathlib.Path(tempfile.mkdtemp()))


def pixels():
    return vtk_to_numpy(desk.picture().GetPointData().GetScalars()).astype(int)


def shown():
    """The window's size and, in its middle, the model: many shades of one colour."""
    assert studio.process.poll() is None, "the Studio ended"
    windows = desk.windows()
    return windows and len(numpy.unique(pixels(), axis=0)) > 300 and windows[-1]


window, shape = until(shown, "the Studio shows no model", 120)
before = None
while before is None or not numpy.array_equal(before, (now := pixels())):  # until the picture is at rest
    before = pixels()
    time.sleep(1.0)
writer = vtkPNGWriter()
writer.SetInputData(desk.picture())
writer.SetFileName(sys.argv[1])
writer.Write()
desk.focus(window)
desk.key("ctrl+q")
code = studio.ended(60)
assert code == 0, f"the Studio ended with {code}"
print(f"studio: a window of {shape.width} x {shape.height}, {len(numpy.unique(before, axis=0))} colours; closed with 0")
