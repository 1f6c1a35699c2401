"""Baseline pictures of augmentation: for three shipped models and the terrain the curves, the refined and the snapped mesh, the result."""
import os
import pathlib
import sys

import pytest
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import oversketch

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(pathlib.Path(__file__).parent), str(SOURCE / "Data")]
import compare  # noqa: E402
import make_augmentations  # noqa: E402
import scenes  # noqa: E402

SHOWN = {"octopus_veins": 0, "dog_collar": 1, "hand_palm_lines": 0, "valley_river_ridge_road": 0}  # which stroke's view


@pytest.fixture(scope="module", params=SHOWN)
def run(request):
    model = request.param.split("_")[0]
    if model == "valley":
        image, mesh = vtkPNGReader(), oversketch.vtkOversketchTerrain()
        image.SetFileName(str(SOURCE / "Data" / "Terrain" / "valley.png"))
        mesh.SetInputConnection(image.GetOutputPort())
        mesh.SetScale(make_augmentations.GRAY)
    else:
        mesh = vtkPLYReader()
        mesh.SetFileName(str(SOURCE / "Data" / "Models" / (model + ".ply")))
    strokes = vtkXMLPolyDataReader()
    strokes.SetFileName(str(SOURCE / "Data" / "Strokes" / (request.param + ".vtp")))
    system = oversketch.vtkOversketchAugment()
    system.SetInputConnection(0, mesh.GetOutputPort())
    system.SetInputConnection(1, strokes.GetOutputPort())
    system.Update()
    assert system.GetErrorCode() == 0 and system.GetFigure("met.flipped_faces") == 0
    return model, system, scenes.View(strokes.GetOutput(), which=SHOWN[request.param]), (mesh, strokes)


@pytest.mark.parametrize("kind", scenes.AUGMENT_SCENES)
def test_picture(run, kind, monkeypatch):
    model, system, view, _ = run
    name = f"{model}_{kind}"
    if not compare.matches(scenes.image(scenes.AUGMENT_SCENES[kind](system, view)), name):
        return
    # The comparison can fail: the same scene in a wrong colour does, and that of another stage.
    for other in scenes.AUGMENT_SCENES:
        if other != kind:
            assert compare.difference(scenes.image(scenes.AUGMENT_SCENES[other](system, view)), compare.read(name)) > 2 * compare.LIMIT
    for colour in ("STROKE", "SILHOUETTE", "REGION", "CLAY"):
        monkeypatch.setattr(scenes, colour, (0.2, 0.7, 0.3))
    monkeypatch.setattr(scenes.surface, "__defaults__", ((0.2, 0.7, 0.3),))
    monkeypatch.setattr(scenes, "by_value", lambda values: values[:, None] * [0.2, 0.7, 0.3])
    wrong = scenes.image(scenes.AUGMENT_SCENES[kind](system, view))
    assert compare.difference(wrong, compare.read(name)) > 10 * compare.LIMIT
