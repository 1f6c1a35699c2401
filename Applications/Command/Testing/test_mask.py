"""Lassos that mask a mesh, by the command: what is masked, what steps after it leave alone, refusals."""
import json
import os

import numpy
import pytest

from scene import *  # noqa: F403

MIDDLE = numpy.array([WIDTH / 3, HEIGHT / 2])


def box(left, bottom, right, top):
    """A rectangle of model lengths, as a lasso in the picture."""
    return MIDDLE + PIXELS * numpy.array([[left, bottom], [right, bottom], [right, top], [left, top]])


LINE = MIDDLE + PIXELS * numpy.column_stack([numpy.linspace(-0.4, 0.4, 30), numpy.zeros(30)])


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("mask")
    mesh = body()
    points = points_of(mesh)
    noise = 1 + numpy.random.default_rng(5).normal(0, 0.008, len(points))
    mesh.GetPoints().SetData(numpy_to_vtk(points * noise[:, None], deep=True))
    write(mesh, folder / "body.vtp")
    write(stroke(box(0.0013, -2, 4, 2)), folder / "right.vtp")
    write(stroke(LINE), folder / "line.vtp")
    return folder


def masked(folder, out, *options, mesh="body.vtp"):
    done = run("mask", folder / mesh, "-o", out, *options)
    assert done.returncode == 0, done.stderr
    return vtk_to_numpy(read(out).GetPointData().GetArray("Mask"))


def test_what_the_lasso_encloses_is_masked(folder, tmp_path):
    before = points_of(read(folder / "body.vtp"))
    seen = masked(folder, tmp_path / "seen.vtp", "--lasso", folder / "right.vtp", "--report", tmp_path / "r.json")
    both = masked(folder, tmp_path / "both.vtp", "--lasso", folder / "right.vtp", "--through")
    assert (points_of(read(tmp_path / "seen.vtp")) == before).all()
    assert (both == (before[:, 0] > 0.0013)).all()
    assert set(numpy.unique(seen)) == {0.0, 1.0} and (seen <= both).all() and 0.3 * both.sum() < seen.sum() < 0.7 * both.sum()
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["command"] == "mask" and report["masked"] == seen.sum() and report["of_points"] == len(before)
    inverted = masked(folder, tmp_path / "i.vtp", "--invert", mesh=tmp_path / "both.vtp")
    assert (inverted == 1 - both).all()
    cleared = masked(folder, tmp_path / "c.vtp", "--mode", "replace", mesh=tmp_path / "both.vtp")
    assert (cleared == 0).all()
    share, length = (masked(folder, tmp_path / f"{k}.vtp", "--grow", grow, mesh=tmp_path / "both.vtp")
                     for k, grow in enumerate(("5%", str(0.05 * diagonal(read(folder / "body.vtp"))))))
    assert (share == length).all() and share.sum() > both.sum()


def test_steps_leave_alone_what_is_masked(folder, tmp_path):
    """The right half stays to the bit under a smoothing across the border; what is free moves."""
    mask = masked(folder, tmp_path / "both.vtp", "--lasso", folder / "right.vtp", "--through") == 1
    before = points_of(read(folder / "body.vtp"))
    for mesh, expected in ((folder / "body.vtp", True), (tmp_path / "both.vtp", False)):
        done = run("relax", mesh, folder / "line.vtp", "-o", tmp_path / "o.vtp", "--radius", "8%")
        assert done.returncode == 0, done.stderr
        moved = (points_of(read(tmp_path / "o.vtp")) != before).any(axis=1)
        assert moved[~mask].sum() > 20 and moved[mask].any() == expected
        kept = read(tmp_path / "o.vtp").GetPointData().GetArray("Mask")
        assert expected or ((vtk_to_numpy(kept) == 1) == mask).all()


def test_a_lasso_in_the_void_and_none_are_refused(folder, tmp_path):
    write(stroke(numpy.array([[5.0, 5.0], [40.0, 8.0], [20.0, 30.0]])), tmp_path / "void.vtp")
    assert "encloses no point" in refuse(1, "mask", folder / "body.vtp", "--lasso", tmp_path / "void.vtp", "-o", tmp_path / "o.vtp")
    assert "There is no lasso" in refuse(1, "mask", folder / "body.vtp", "-o", tmp_path / "o.vtp")
    assert "view of a stroke" in refuse(1, "mask", folder / "body.vtp", "--invert", "-o", tmp_path / "o.vtp", "--picture", tmp_path / "o.png")
    assert os.listdir(tmp_path) == ["void.vtp"]


@pytest.mark.parametrize("more", [["--mode", "xor"], ["--grow", "wide"], ["--radius", "1"]])
def test_bad_use(folder, tmp_path, more):
    refuse(2, "mask", folder / "body.vtp", "--lasso", folder / "right.vtp", "-o", tmp_path / "o.vtp", *more)
    assert os.listdir(tmp_path) == []
