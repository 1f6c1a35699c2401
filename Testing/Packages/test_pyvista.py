"""PyVista beside the package: what the filters put out can be wrapped, and the example draws the pictures that lie beside it."""
import os
import pathlib
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, str(pathlib.Path(os.environ["OVERSKETCH_SOURCE"]) / "Testing" / "Pictures"))
import compare  # noqa: E402
from environment import Environment  # noqa: E402
from vtkmodules.vtkIOImage import vtkPNGReader  # noqa: E402

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
EXAMPLE = SOURCE / "Applications" / "Examples" / "PyVista"
# Where the system has none (Debian 12): the last PyVista that runs on VTK 9.1; what else it needs is taken from the system.
PACKAGES = ["pyvista==0.46.*", "platformdirs", "pooch", "requests", "scooby"]


@pytest.fixture(scope="module")
def environment(tmp_path_factory):
    made = Environment(tmp_path_factory.mktemp("environment"))
    if not made.has("pyvista"):
        made.require_index(tmp_path_factory.mktemp("index"))
        made.run("-m", "pip", "install", "--no-deps", *PACKAGES)
        made.run("-m", "pip", "install", "--no-deps", "--ignore-installed", "typing-extensions")
    made.variables["PYTHONPATH"] = os.environ["PYTHONPATH"]
    return made


def test_an_output_is_wrapped_with_points_faces_and_arrays(environment):
    environment.run("-c", f"""
import numpy, pyvista, oversketch
dog = pyvista.read({str(SOURCE / "Data" / "Models" / "dog.ply")!r})
dog["height"] = dog.points[:, 1].copy()
system = oversketch.vtkOversketchOneStroke()
system.SetRemeshToOff()
system.SetInputData(dog)
system.SetStrokeData(pyvista.read({str(SOURCE / "Data" / "Strokes" / "dog_longer_leg.vtp")!r}))
output = oversketch.update(system)
wrapped = pyvista.wrap(output)
assert isinstance(wrapped, pyvista.PolyData) and wrapped.n_points == dog.n_points == output.GetNumberOfPoints()
assert numpy.array_equal(wrapped.regular_faces, dog.regular_faces)
assert numpy.array_equal(wrapped["height"], dog.points[:, 1])
moved = numpy.any(wrapped.points != dog.points, axis=1)
assert 100 < moved.sum() < 0.5 * dog.n_points
assert wrapped.is_manifold and wrapped.volume > dog.volume
""")


def picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def test_the_example_draws_its_pictures(environment, tmp_path):
    kept = EXAMPLE if os.environ.get("OVERSKETCH_WRITE_BASELINES") else tmp_path
    said = environment.run(EXAMPLE / "one_stroke.py", kept).split()
    assert int(said[0]) > 1000 and 0.2 < float(said[4]) < 0.25
    shown = {name: picture(kept / (name + ".png")) for name in ("before", "region", "after")}
    for name, drawn in shown.items():
        assert compare.difference(drawn, picture(EXAMPLE / (name + ".png"))) < compare.LIMIT, name
        others = [other for other in shown if other != name]
        assert all(compare.difference(drawn, picture(EXAMPLE / (other + ".png"))) > 10 * compare.LIMIT for other in others), name
