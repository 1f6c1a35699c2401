"""A mesh that is placed by the command: where it lies, its copy in the mirror, refusals."""
import json
import os

import numpy
import pytest
from vtkmodules.vtkCommonCore import vtkIntArray

from scene import *  # noqa: F403


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("transform")
    write(body(), folder / "body.vtp")
    one, two = points_of(body()), points_of(body()) + [0.0, 10.0, 0.0]
    faces = triangles_of(body())
    pair = polydata(numpy.vstack([one, two]), numpy.vstack([faces, faces + len(one)]))
    parts = vtkIntArray()
    parts.SetName("PartId")
    for number in (0, 1):
        for _ in faces:
            parts.InsertNextValue(number)
    pair.GetCellData().AddArray(parts)
    write(pair, folder / "pair.vtp")
    return folder


def transform(mesh, out, *options):
    done = run("transform", mesh, "-o", out, *options)
    assert done.returncode == 0, done.stderr
    return read(out)


def middle_of(points):
    return (points.min(axis=0) + points.max(axis=0)) / 2


def parts_of(mesh):
    return vtk_to_numpy(mesh.GetCellData().GetArray("PartId"))


def test_it_is_scaled_turned_and_moved_about_its_middle(folder, tmp_path):
    before = points_of(read(folder / "body.vtp"))
    made = transform(folder / "body.vtp", tmp_path / "o.vtp", "--move", "1,2,3", "--turn", "0,0,90", "--scale", "2,1,0.5",
                     "--report", tmp_path / "r.json")
    middle = middle_of(before)
    x, y, z = ((before - middle) * [2, 1, 0.5]).T
    assert numpy.abs(points_of(made) - (numpy.stack([-y, x, z], axis=1) + middle + [1, 2, 3])).max() < 1e-12
    assert (triangles_of(made) == triangles_of(body())).all()
    for name in ("TCoords", "RGB"):
        assert (vtk_to_numpy(made.GetPointData().GetArray(name)) == vtk_to_numpy(body().GetPointData().GetArray(name))).all(), name
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["command"] == "transform" and report["moved"] == len(before) and report["copied"] == 0
    assert report["options"]["move"] == [1, 2, 3] and report["options"]["scale"] == [2, 1, 0.5]


def test_one_factor_is_for_all_axes(folder, tmp_path):
    one = transform(folder / "body.vtp", tmp_path / "one.vtp", "--scale", "2")
    three = transform(folder / "body.vtp", tmp_path / "three.vtp", "--scale", "2,2,2")
    assert digest(one) == digest(three)
    assert volume(one) == pytest.approx(8 * volume(body()), rel=1e-9)


def test_nothing_keeps_the_mesh(folder, tmp_path):
    assert (points_of(transform(folder / "body.vtp", tmp_path / "o.vtp")) == points_of(body())).all()


def test_a_part_and_its_copy(folder, tmp_path):
    before = read(folder / "pair.vtp")
    made = transform(folder / "pair.vtp", tmp_path / "o.vtp", "--part", "1", "--move", "0,0,1", "--copy", "mirrored",
                     "--mirror-axis", "y", "--mirror-offset", "5")
    count = before.GetNumberOfPoints()
    old, new = points_of(before), points_of(made)
    assert (new[: count // 2] == old[: count // 2]).all()
    assert (new[count // 2: count] == old[count // 2:] + [0, 0, 1]).all()
    assert (new[count:] == new[count // 2: count] * [1, -1, 1] + [0, 10, 0]).all()
    assert set(parts_of(made)) == {0, 1, 2}
    assert made.GetNumberOfPolys() == before.GetNumberOfPolys() * 3 // 2
    assert volume(made) == pytest.approx(3 * volume(body()), rel=1e-9)


@pytest.mark.parametrize("more, words", [
    (["--part", "5"], "no part 5"), (["--scale", "0"], "--scale"), (["--move", "1e13,0,0"], "--move"),
])
def test_what_cannot_be_placed_is_refused(folder, tmp_path, more, words):
    assert words in refuse(1, "transform", folder / "pair.vtp", "-o", tmp_path / "o.vtp", *more)
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("more", [
    ["--move", "1"], ["--move", "1,2"], ["--turn", "1,2,x"], ["--scale", "1,2,3,4"], ["--part", "-2"], ["--copy", "twice"], ["--mirror-axis", "w"],
])
def test_bad_use(folder, tmp_path, more):
    refuse(2, "transform", folder / "body.vtp", "-o", tmp_path / "o.vtp", *more)
    assert os.listdir(tmp_path) == []
