"""A bone and its new course bend a limb, by the command: what moves and what keeps its bits, stretching, refusals."""
import json
import os

import numpy
import pytest

from scene import *  # noqa: F403

JOINT, TIP = numpy.array([205.0, HEIGHT / 2]), numpy.array([285.0, HEIGHT / 2])
LONG = TIP - JOINT


def line(a, b):
    return stroke(numpy.linspace(a, b, 40))


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pose")
    write(body(), folder / "body.vtp")
    write(line(JOINT, TIP), folder / "bone.vtp")
    write(line(JOINT, JOINT + LONG[::-1]), folder / "up.vtp")
    return folder


def pose(folder, out, *options):
    done = run("pose", folder / "body.vtp", "--bone", folder / "bone.vtp", "-o", out, *options)
    assert done.returncode == 0, done.stderr
    return read(out)


def test_the_limb_turns_and_all_else_keeps_its_bits(folder, tmp_path):
    before = points_of(read(folder / "body.vtp"))
    made = pose(folder, tmp_path / "o.vtp", "--pose", folder / "up.vtp", "--report", tmp_path / "r.json")
    after = points_of(made)
    joint = (JOINT[0] - WIDTH / 3) / PIXELS
    moved = (after != before).any(axis=1)
    assert 50 < moved.sum() < len(before) / 2
    assert (before[moved, 0] > joint).all()
    tip = before[0] - [joint, 0, 0]
    assert after[0] == pytest.approx([joint - tip[1], tip[0], tip[2]], abs=0.01)
    assert numpy.abs(after[:, 2] - before[:, 2]).max() < 1e-9
    assert volume(made) == pytest.approx(volume(read(folder / "body.vtp")), rel=0.05)
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["command"] == "pose" and report["moved"] == moved.sum()
    assert report["bend"] == pytest.approx(90, abs=1)


def test_without_a_course_and_along_the_bone_nothing_moves(folder, tmp_path):
    before = points_of(read(folder / "body.vtp"))
    assert (points_of(pose(folder, tmp_path / "bone.vtp")) == before).all()
    assert (points_of(pose(folder, tmp_path / "same.vtp", "--pose", folder / "bone.vtp")) == before).all()


def test_a_longer_course_stretches_on_request_alone(folder, tmp_path):
    write(line(JOINT, JOINT + 1.5 * LONG), tmp_path / "long.vtp")
    before = points_of(read(folder / "body.vtp"))
    same = points_of(pose(folder, tmp_path / "same.vtp", "--pose", tmp_path / "long.vtp"))
    long = points_of(pose(folder, tmp_path / "longer.vtp", "--pose", tmp_path / "long.vtp", "--stretch"))
    assert (same == before).all()
    assert long[0, 0] - before[0, 0] == pytest.approx(0.5 * LONG[0] / PIXELS, abs=0.02)


def test_softness_spreads_the_bend(folder, tmp_path):
    soft, sharp = (points_of(pose(folder, tmp_path / f"{value}.vtp", "--pose", folder / "up.vtp", "--softness", value)) for value in ("1", "0.25"))
    assert numpy.linalg.norm(soft - sharp, axis=1).max() > 0.05
    assert soft[0] == pytest.approx(sharp[0], abs=1e-9)


def test_a_bone_in_the_void_is_refused(folder, tmp_path):
    write(line(numpy.array([5.0, 5.0]), numpy.array([40.0, 8.0])), tmp_path / "void.vtp")
    assert "beside the model" in refuse(1, "pose", folder / "body.vtp", "--bone", tmp_path / "void.vtp", "-o", tmp_path / "o.vtp")
    assert os.listdir(tmp_path) == ["void.vtp"]


@pytest.mark.parametrize("more", [["--softness", "0"], ["--softness", "nan"], ["--stretch", "maybe"], ["--radius", "1"]])
def test_bad_use(folder, tmp_path, more):
    refuse(2, "pose", folder / "body.vtp", "--bone", folder / "bone.vtp", "--pose", folder / "up.vtp", "-o", tmp_path / "o.vtp", *more)
    assert os.listdir(tmp_path) == []


def test_the_bone_must_be_there(folder, tmp_path):
    assert "--bone" in refuse(2, "pose", folder / "body.vtp", "-o", tmp_path / "o.vtp")
