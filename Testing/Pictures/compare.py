"""A picture against its baseline in Testing/Baseline. OVERSKETCH_WRITE_BASELINES=1 writes baselines instead; look at each before it is
committed. One set is meant for Debian 12 and 13; made on 12."""
import os
import pathlib

from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

BASELINES = pathlib.Path(os.environ["OVERSKETCH_SOURCE"]) / "Testing" / "Baseline"
LIMIT = 12.0  # summed difference, in pixels of full contrast, after vtkImageDifference's tolerance of one pixel's shift


def difference(a, b):
    compare = vtkImageDifference()
    compare.SetInputData(a)
    compare.SetImageData(b)
    compare.SetThreshold(16)  # of 255; the default of 105 takes teal for green
    compare.Update()
    return compare.GetThresholdedError()


def read(name):
    reader = vtkPNGReader()
    reader.SetFileName(str(BASELINES / (name + ".png")))
    reader.Update()
    return reader.GetOutput()


def matches(picture, name):
    """Asserts that a picture is its baseline; False when the baseline was written instead."""
    if os.environ.get("OVERSKETCH_WRITE_BASELINES"):
        writer = vtkPNGWriter()
        writer.SetFileName(str(BASELINES / (name + ".png")))
        writer.SetInputData(picture)
        writer.Write()
        return False
    baseline = read(name)
    assert picture.GetDimensions() == baseline.GetDimensions()
    error = difference(picture, baseline)
    assert error < LIMIT, f"{name}.png: {error}"
    return True
