"""Strokes that smooth a mesh, by the command: what moves and what keeps its bits, lengths, pressure, refusals."""
import json
import os

import numpy
import pytest

from scene import *  # noqa: F403

LINE = numpy.column_stack([WIDTH / 3 - 30 + numpy.linspace(-20, 20, 30), HEIGHT / 2 + 12 * numpy.sin(numpy.linspace(0, 5, 30))])


def bumpy():
    """The body with noise along its radii."""
    mesh = body()
    points = points_of(mesh)
    noise = 1 + numpy.random.default_rng(5).normal(0, 0.008, len(points))
    mesh.GetPoints().SetData(numpy_to_vtk(points * noise[:, None], deep=True))
    return mesh


def bumps(points):
    """How far points are from the body without noise."""
    far = numpy.linalg.norm(points, axis=1)
    return numpy.abs(far - radius(numpy.arccos(points[:, 0] / far), 1.4))


def with_values(data, cells, name, values):
    array = numpy_to_vtk(numpy.asarray(values, dtype=float), deep=True)
    array.SetName(name)
    (data.GetCellData() if cells else data.GetPointData()).AddArray(array)
    return data


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("relax")
    write(bumpy(), folder / "body.vtp")
    write(stroke(LINE), folder / "line.vtp")
    return folder


def relax(folder, out, *options, line="line.vtp"):
    done = run("relax", folder / "body.vtp", folder / line, "-o", out, *options)
    assert done.returncode == 0, done.stderr
    return read(out)


def test_bumps_go_near_the_stroke_and_all_else_keeps_its_bits(folder, tmp_path):
    before, reach = points_of(read(folder / "body.vtp")), 1.25 * 0.04 * diagonal(read(folder / "body.vtp"))
    made = relax(folder, tmp_path / "o.vtp", "--radius", "4%", "--report", tmp_path / "r.json")
    after = points_of(made)
    moved = (after != before).any(axis=1)
    line = (LINE - [WIDTH / 3, HEIGHT / 2]) / PIXELS
    away = numpy.linalg.norm(before[:, None, :2] - line[None], axis=2).min(axis=1)
    assert 80 < moved.sum() < len(before) / 4
    assert (away[moved] < reach).all() and (before[moved, 2] > 0).all()  # under the stroke, on the side that is seen
    rough = [bumps(points)[moved & (away < reach / 2)].mean() for points in (before, after)]
    assert rough[1] < 0.5 * rough[0], rough
    assert volume(made) == pytest.approx(volume(read(folder / "body.vtp")), rel=0.005)
    assert (triangles_of(made) == triangles_of(read(folder / "body.vtp"))).all()
    for name in ("TCoords", "RGB"):
        assert (vtk_to_numpy(made.GetPointData().GetArray(name)) == vtk_to_numpy(body().GetPointData().GetArray(name))).all(), name
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["command"] == "relax" and report["moved"] == moved.sum() and report["warnings"] == []
    assert report["farthest"] == pytest.approx(numpy.linalg.norm(after - before, axis=1).max(), rel=1e-6)


def test_lengths_are_the_models_or_shares_of_its_diagonal(folder, tmp_path):
    size = diagonal(read(folder / "body.vtp"))
    share = points_of(relax(folder, tmp_path / "share.vtp", "--radius", "8%"))
    length = points_of(relax(folder, tmp_path / "length.vtp", "--radius", str(0.08 * size)))
    assert numpy.abs(share - length).max() < 1e-12
    assert digest(relax(folder, tmp_path / "usual.vtp")) == digest(relax(folder, tmp_path / "negative.vtp", "--radius", "-1"))
    # A stroke's own radius goes before the option, and one is told.
    write(with_values(stroke(LINE), True, "Radius", [0.08 * size]), tmp_path / "own.vtp")
    done = run("relax", folder / "body.vtp", tmp_path / "own.vtp", "-o", tmp_path / "same.vtp", "--radius", "3%")
    assert numpy.abs(points_of(read(tmp_path / "same.vtp")) - length).max() < 1e-12
    assert "warning: --radius is not used" in done.stderr, done.stderr


def test_strength_and_pressure_are_shares_of_the_way(folder, tmp_path):
    before = points_of(read(folder / "body.vtp"))
    full = points_of(relax(folder, tmp_path / "full.vtp", "--radius", "8%"))
    half = points_of(relax(folder, tmp_path / "half.vtp", "--radius", "8%", "--strength", "0.5"))
    assert numpy.abs(half - (before + full) / 2).max() < 1e-12
    write(with_values(stroke(LINE), False, "Pressure", numpy.full(len(LINE), 0.5)), tmp_path / "light.vtp")
    light = points_of(relax(folder, tmp_path / "light_out.vtp", "--radius", "8%", line=tmp_path / "light.vtp"))
    assert numpy.abs(light - half).max() < 1e-12
    off = points_of(relax(folder, tmp_path / "off.vtp", "--radius", "8%", "--use-pressure", "off", line=tmp_path / "light.vtp"))
    assert (off == full).all()


@pytest.mark.parametrize("more, words", [
    (["--radius", "0"], "The --radius must be a positive number"), (["--radius", "1e-6"], "may move"),
    (["--radius", "8%", "--feature-angle", "0"], "may move"),
])
def test_a_band_in_which_nothing_moves_is_refused(folder, tmp_path, more, words):
    assert words in refuse(1, "relax", folder / "body.vtp", folder / "line.vtp", "-o", tmp_path / "o.vtp", *more)
    assert os.listdir(tmp_path) == []


def test_a_stroke_in_the_void_is_refused(folder, tmp_path):
    write(stroke(numpy.array([[5.0, 5.0], [40.0, 8.0]])), tmp_path / "void.vtp")
    assert "draw it over the model" in refuse(1, "relax", folder / "body.vtp", tmp_path / "void.vtp", "-o", tmp_path / "o.vtp")
    assert os.listdir(tmp_path) == ["void.vtp"]


@pytest.mark.parametrize("more", [
    ["--radius", "wide"], ["--radius", "nan"], ["--strength", "2"], ["--use-pressure", "maybe"], ["--feature-angle", "200"], ["--height", "1"],
])
def test_bad_use(folder, tmp_path, more):
    refuse(2, "relax", folder / "body.vtp", folder / "line.vtp", "-o", tmp_path / "o.vtp", *more)
    assert os.listdir(tmp_path) == []
