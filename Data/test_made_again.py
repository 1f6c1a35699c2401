"""The scripts make what is shipped: the models, strokes, terrain and drawings."""
import filecmp
import os
import subprocess
import sys

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import figures  # noqa: E402
import listing  # noqa: E402
import remesh  # noqa: E402
from test_data import arrays, assert_sound, model, read, stroke  # noqa: E402
from test_drawings import FOLDER, NAMES, lines, pixels  # noqa: E402


def test_strokes_are_made_again(tmp_path):
    name = "hand_longer_finger"
    subprocess.run([sys.executable, os.path.join(HERE, "make_strokes.py"), "--only", name, "--to", str(tmp_path)], check=True)
    made = read(vtk.vtkXMLPolyDataReader(), str(tmp_path), name + ".vtp")
    there, here = (vtk_to_numpy(s.GetPoints().GetData()) for s in (stroke(name), made))
    assert len(there) == len(here) and np.abs(there - here).max() < 1e-6


def test_augmentations_are_made_again(tmp_path):
    """All of them and the terrain, twice: the same bytes; and what is shipped but for rounding, by which waters may part elsewhere."""
    for folder in ("one", "two"):
        subprocess.run([sys.executable, os.path.join(HERE, "make_augmentations.py"), "--to", str(tmp_path / folder)], check=True)
    for name in listing.AUGMENT:
        file = os.path.join("Strokes", name + ".vtp")
        assert filecmp.cmp(str(tmp_path / "one" / file), str(tmp_path / "two" / file), shallow=False)
        there, here = stroke(name), read(vtk.vtkXMLPolyDataReader(), str(tmp_path), "one", file)
        assert there.GetNumberOfCells() == here.GetNumberOfCells()
        if not name.startswith("valley"):
            there, here = (vtk_to_numpy(s.GetPoints().GetData()) for s in (there, here))
            assert len(there) == len(here) and np.abs(there - here).max() < 1e-6
    file = os.path.join("Terrain", "valley.png")
    assert filecmp.cmp(str(tmp_path / "one" / file), str(tmp_path / "two" / file), shallow=False)
    there, here = (vtk_to_numpy(read(vtk.vtkPNGReader(), path).GetPointData().GetScalars()).astype(float)
                   for path in (file, str(tmp_path / "one" / file)))
    assert np.abs(there - here).mean() < 0.02 * there.max()


def test_models_are_made_again(tmp_path):
    """A model at three times its edge length, twice: the same bytes; and the shipped model lies on the same surface."""
    command = [sys.executable, os.path.join(HERE, "make_models.py"), "--only", "hand", "--coarser", "3", "--to"]
    for folder in ("one", "two"):
        subprocess.run(command + [str(tmp_path / folder)], check=True)
    one, two = (str(tmp_path / folder / "hand.ply") for folder in ("one", "two"))
    assert filecmp.cmp(one, two, shallow=False)
    coarse = read(vtk.vtkPLYReader(), one)
    assert_sound(coarse)
    points, triangles = arrays(coarse)
    assert 1500 < len(triangles) < 4000 and remesh.minimum_angles(points, triangles).mean() > 45.0
    distance = vtk.vtkImplicitPolyDataDistance()
    distance.SetInput(model("hand"))
    assert max(abs(distance.EvaluateFunction(p)) for p in points) < 0.2 * figures.FIGURES["hand"][1]


def along(points, count=200):
    """As many places at equal shares of a line's length."""
    length = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    shares = np.linspace(0.0, length[-1], count)
    return np.column_stack([np.interp(shares, length, points[:, k]) for k in range(points.shape[1])])


def test_drawings_are_made_again(tmp_path):
    """All of them: what is shipped but for rounding, on another processor; one of them twice: the same bytes."""
    for folder, only in (("one", []), ("two", ["--only", "figure_hat"])):
        subprocess.run([sys.executable, os.path.join(HERE, "make_drawings.py"), *only, "--to", str(tmp_path / folder)], check=True)
    for end in (".png", ".vtp"):
        one, two = ((tmp_path / folder / ("figure_hat" + end)).read_bytes() for folder in ("one", "two"))
        assert one == two
    for name in NAMES:
        there, here = (read(vtk.vtkXMLPolyDataReader(), folder, name + ".vtp") for folder in (FOLDER, str(tmp_path / "one")))
        assert there.GetNumberOfCells() == here.GetNumberOfCells()
        slid = 0  # rounding moves the samples of a few strokes along their curves, where there may be one more or less
        for one, two in zip(lines(there), lines(here)):
            one, two = vtk_to_numpy(there.GetPoints().GetData())[one], vtk_to_numpy(here.GetPoints().GetData())[two]
            if len(one) != len(two) or np.abs(one - two).max() >= 1e-3:
                slid += 1
                assert abs(len(one) - len(two)) <= 1 and np.abs(along(one) - along(two)).max() < 0.2, name
        assert slid <= 2, name
        there, here = (pixels(read(vtk.vtkPNGReader(), folder, name + ".png")).astype(int) for folder in (FOLDER, str(tmp_path / "one")))
        assert np.abs(there - here).mean() < 0.01
