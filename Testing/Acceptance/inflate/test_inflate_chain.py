"""A leg of a shipped drawing, inflated, is pulled by one stroke from the front; what is said of its texture is right."""
import os
import subprocess
import sys
from pathlib import Path

import pytest
from vtkmodules.vtkCommonDataModel import vtkPolyData

sys.path[:0] = [str(Path(__file__).resolve().parent)]
import inflate_chain  # noqa: E402
import meshes  # noqa: E402
import stroke_files  # noqa: E402
import strokes  # noqa: E402


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    drawing, out = meshes.DATA / "Drawings" / "heron.vtp", tmp_path_factory.mktemp("chain") / "heron.vtp"
    picture = str(drawing.with_suffix(".png"))
    subprocess.run([os.environ["OVERSKETCH_COMMAND"], "inflate", str(drawing), "-o", str(out), "--image", picture], check=True)
    return out


def test_a_limb_is_pulled(model):
    (stroke, note), = strokes.strokes_for("heron", meshes.read(model), "+y", 0, 1, inflate_chain.views_from("front"))
    path = model.with_name("stroke.vtp")
    stroke_files.write(stroke, path)
    found = inflate_chain.run(path, model, ["default"], "auto", None)["default"]
    print(note["kind"], found)
    assert found["holds"] and found["texture"] == 0 and found["closed"]


def test_texture_that_was_lost(model):
    mesh = meshes.read(model)

    def judged(alter):
        output, result = vtkPolyData(), {"fails": [], "holds": True}
        output.DeepCopy(mesh)
        alter(output)
        inflate_chain.textured(result, mesh, output)
        return result
    assert judged(lambda _: None) == {"fails": [], "holds": True, "texture": 0}
    one = judged(lambda output: output.GetPointData().GetArray("TCoords").SetComponent(7, 0, 0.25))
    beside = judged(lambda output: (output.GetPoints().SetPoint(7, 1, 2, 3), output.GetPointData().GetArray("TCoords").SetComponent(7, 0, 9)))
    assert one == beside == {"fails": ["texture"], "holds": False, "texture": 1}
    assert judged(lambda output: output.GetPointData().RemoveArray("TCoords"))["texture"] == mesh.GetNumberOfPoints()


def test_enough():
    runs = {f"model{k % 8}-front-{k}": {"holds": k > 0} for k in range(20)}
    assert inflate_chain.enough(runs)
    assert not inflate_chain.enough({**runs, "model1-front-1": {"holds": False}})
    assert not inflate_chain.enough(dict(list(runs.items())[:19]))
    assert not inflate_chain.enough({name.replace("model7", "model1"): run for name, run in runs.items()})
