"""Baseline pictures: for each shipped model the silhouette, the thickness, the region and the result of its first stroke.

OVERSKETCH_WRITE_BASELINES=1 writes them instead of comparing; look at each before it is committed. One set is meant for Debian 12 and 13; made on 12.
"""
import os
import pathlib
import sys

import pytest
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import oversketch

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import scenes  # noqa: E402

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
BASELINES = SOURCE / "Testing" / "Baseline"
MODELS = sorted(p.stem for p in (SOURCE / "Data" / "Models").glob("*.ply"))
LIMIT = 12.0  # summed difference, in pixels of full contrast, after vtkImageDifference's tolerance of one pixel's shift


def first_stroke(model):
    return sorted((SOURCE / "Data" / "Strokes").glob(model + "_*.vtp"))[0]


@pytest.fixture(scope="module", params=MODELS)
def run(request):
    mesh, stroke = vtkPLYReader(), vtkXMLPolyDataReader()
    mesh.SetFileName(str(SOURCE / "Data" / "Models" / (request.param + ".ply")))
    stroke.SetFileName(str(first_stroke(request.param)))
    system = oversketch.vtkOversketchOneStroke()
    system.SetInputConnection(0, mesh.GetOutputPort())
    system.SetInputConnection(1, stroke.GetOutputPort())
    system.SetBackendToHost()  # the same rays whatever OpenCL device there is
    system.Update()
    assert system.GetErrorCode() == 0
    return request.param, system, stroke.GetOutput(), (mesh, stroke)


def difference(a, b):
    compare = vtkImageDifference()
    compare.SetInputData(a)
    compare.SetImageData(b)
    compare.SetThreshold(16)  # of 255; the default of 105 takes teal for green
    compare.Update()
    return compare.GetThresholdedError()


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


@pytest.mark.parametrize("kind", scenes.SCENES)
def test_picture(run, kind, tmp_path, monkeypatch):
    model, system, stroke, _ = run
    path = BASELINES / f"{model}_{kind}.png"
    picture = scenes.image(scenes.SCENES[kind](system, stroke))
    if os.environ.get("OVERSKETCH_WRITE_BASELINES"):
        writer = vtkPNGWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(picture)
        writer.Write()
        return
    baseline = read(path)
    assert picture.GetDimensions() == baseline.GetDimensions()
    error = difference(picture, baseline)
    assert error < LIMIT, f"{path.name}: {error}"
    # The comparison can fail: the same scene in a wrong colour does.
    for name in ("STROKE", "SILHOUETTE", "REGION", "CLAY"):
        monkeypatch.setattr(scenes, name, (0.2, 0.7, 0.3))
    monkeypatch.setattr(scenes.pen, "__defaults__", ((0.2, 0.7, 0.3), 4.0))
    monkeypatch.setattr(scenes.surface, "__defaults__", ((0.2, 0.7, 0.3),))
    monkeypatch.setattr(scenes, "thickness_colours", scenes.region_colours)
    wrong = scenes.image(scenes.SCENES[kind](system, stroke))
    assert difference(wrong, baseline) > 10 * LIMIT
