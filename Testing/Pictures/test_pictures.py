"""Baseline pictures: for each shipped model with strokes the silhouette, the thickness, the region and the result of its first stroke."""
import os
import pathlib
import sys

import pytest
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import oversketch

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(pathlib.Path(__file__).parent), str(SOURCE / "Data")]
import compare  # noqa: E402
import listing  # noqa: E402
import scenes  # noqa: E402

MODELS = sorted({name.split("_")[0] for name in listing.ONE_STROKE})


def first_stroke(model):
    return next(path for path in listing.one_stroke() if path.stem.startswith(model + "_"))


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


@pytest.mark.parametrize("kind", scenes.SCENES)
def test_picture(run, kind, monkeypatch):
    model, system, stroke, _ = run
    name = f"{model}_{kind}"
    if not compare.matches(scenes.image(scenes.SCENES[kind](system, stroke)), name):
        return
    # The comparison can fail: the same scene in a wrong colour does.
    for colour in ("STROKE", "SILHOUETTE", "REGION", "CLAY"):
        monkeypatch.setattr(scenes, colour, (0.2, 0.7, 0.3))
    monkeypatch.setattr(scenes.pen, "__defaults__", ((0.2, 0.7, 0.3), 4.0))
    monkeypatch.setattr(scenes.surface, "__defaults__", ((0.2, 0.7, 0.3),))
    monkeypatch.setattr(scenes, "thickness_colours", scenes.region_colours)
    wrong = scenes.image(scenes.SCENES[kind](system, stroke))
    assert compare.difference(wrong, compare.read(name)) > 10 * compare.LIMIT
