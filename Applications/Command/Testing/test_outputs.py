"""What stands at OUT, and what is left where a run fails or is ended."""
import json
import os
import resource
import signal
import subprocess
import time

import numpy
import pytest
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

from scene import *  # noqa: F403


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("outputs")
    write(body(), folder / "body.vtp")
    write(stroke(outline(1.7)), folder / "longer.vtp")
    return folder


def arguments(folder, *more):
    return ["one-stroke", folder / "body.vtp", folder / "longer.vtp", *more, *QUICK]


def session(folder, mesh):
    """A session without strokes, as a folder: replaying it writes the mesh."""
    folder.mkdir()
    (folder / "session.json").write_text(json.dumps(
        {"format": "oversketch-session", "format_version": 1, "mesh": "m.vtp", "mesh_name": "a", "backend": "embree", "result_md5": "",
         "made_by": dict.fromkeys(("version", "backend", "device", "processor"), ""), "strokes": []}))
    write(mesh, folder / "m.vtp")
    return folder


def test_a_file_that_may_not_be_written_to_is_refused(folder, tmp_path):
    (tmp_path / "o.vtp").write_text("mine")
    os.chmod(tmp_path / "o.vtp", 0o444)  # root may write to it all the same
    assert "may not be written to" in refuse(1, *arguments(folder, "-o", tmp_path / "o.vtp"))
    assert (tmp_path / "o.vtp").read_text() == "mine" and os.listdir(tmp_path) == ["o.vtp"]


def test_a_mode_stays_and_a_link_is_followed(folder, tmp_path):
    (tmp_path / "there").mkdir()
    (tmp_path / "there" / "o.vtp").write_text("old")
    os.chmod(tmp_path / "there" / "o.vtp", 0o640)
    (tmp_path / "link.vtp").symlink_to("there/o.vtp")
    (tmp_path / "new.vtp").symlink_to("there/new.vtp")
    for name in ("link.vtp", "new.vtp"):
        done = run(*arguments(folder, "-o", tmp_path / name))
        assert done.returncode == 0, done.stderr
        assert (tmp_path / name).is_symlink()
    assert read(tmp_path / "there" / "o.vtp").GetNumberOfPoints() == read(tmp_path / "there" / "new.vtp").GetNumberOfPoints() > 0
    assert (tmp_path / "there" / "o.vtp").stat().st_mode & 0o7777 == 0o640
    mask = os.umask(0)
    os.umask(mask)
    assert (tmp_path / "there" / "new.vtp").stat().st_mode & 0o7777 == 0o666 & ~mask
    (tmp_path / "round.vtp").symlink_to("round.vtp")
    assert "leads nowhere" in refuse(1, *arguments(folder, "-o", tmp_path / "round.vtp"))
    assert sorted(os.listdir(tmp_path)) == ["link.vtp", "new.vtp", "round.vtp", "there"]
    assert sorted(os.listdir(tmp_path / "there")) == ["new.vtp", "o.vtp"]


def test_no_input_is_replaced_but_the_mesh(folder, tmp_path):
    for name in ("body.vtp", "longer.vtp"):
        (tmp_path / name).write_bytes((folder / name).read_bytes())
    before = (tmp_path / "longer.vtp").read_bytes()
    (tmp_path / "Stroke.vtp").write_bytes(before)
    (tmp_path / "link.vtp").symlink_to("longer.vtp")
    (tmp_path / "hard.vtp").hardlink_to(tmp_path / "longer.vtp")
    for name in ("longer.vtp", "./longer.vtp", "link.vtp", "hard.vtp"):
        assert "would replace the stroke" in refuse(2, *arguments(tmp_path, "-o", tmp_path / name))
    assert "would replace the stroke" in refuse(2, "one-stroke", tmp_path / "body.vtp", tmp_path / "Stroke.vtp", "-o",
                                                tmp_path / "o.vtp", "--inner", tmp_path)
    assert "would replace -o" in refuse(2, *arguments(tmp_path, "-o", tmp_path / "Match.vtp", "--inner", tmp_path))
    assert (tmp_path / "longer.vtp").read_bytes() == before == (tmp_path / "Stroke.vtp").read_bytes()
    assert run(*arguments(tmp_path, "-o", tmp_path / "body.vtp")).returncode == 0
    assert not numpy.array_equal(points_of(read(tmp_path / "body.vtp")), points_of(read(folder / "body.vtp")))
    (tmp_path / "s.ply").write_bytes(b"a session of an odd name")
    assert "would replace the session" in refuse(2, "replay", tmp_path / "s.ply", "-o", tmp_path / "s.ply")


def textured():
    """The body with a picture, which OBJ keeps in files of their own."""
    image = vtkImageData()
    image.SetDimensions(8, 8, 1)
    image.AllocateScalars(3, 3)
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.WriteToMemoryOn()
    writer.Write()
    picture = vtkUnsignedCharArray()
    picture.DeepCopy(writer.GetResult())
    picture.SetName("Texture")
    mesh = body()
    mesh.GetFieldData().AddArray(picture)
    return mesh


@pytest.mark.parametrize("verb", ["one-stroke", "inflate"])
@pytest.mark.parametrize("more", [[], ["--report", "r.json"], ["--inner", "inner"]])
def test_a_full_disk_leaves_nothing(folder, tmp_path, verb, more):
    write(textured(), folder / "textured.vtp")
    leaf = SOURCE / "Data" / "Drawings" / "leaf"
    words = {"one-stroke": [verb, folder / "textured.vtp", folder / "longer.vtp", *QUICK],
             "inflate": [verb, leaf.with_suffix(".vtp"), "--image", leaf.with_suffix(".png"), "--backend", "embree"]}[verb]
    done = run(*words, "-o", "o.obj", *more, cwd=tmp_path)
    assert done.returncode == 0 and {"o.obj", "o.mtl", "o.png"} <= set(os.listdir(tmp_path)), done.stderr
    limit = (tmp_path / "o.obj").stat().st_size - 1  # the picture and the library are smaller
    assert limit > max((tmp_path / name).stat().st_size for name in ("o.mtl", "o.png"))
    for name in ("o.obj", "o.mtl", "o.png"):
        os.remove(tmp_path / name)
    before = sorted(os.listdir(tmp_path))
    full = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
    done = run(*words, "-o", "o.obj", *more, cwd=tmp_path, preexec_fn=full)
    assert done.returncode == 1 and "o.obj: could not be written" in done.stderr, done.stderr
    assert sorted(os.listdir(tmp_path)) == before


def test_what_cannot_be_read_again_is_not_left(tmp_path):
    mesh = body()
    mesh.GetPoints().SetPoint(7, 1e39, 0.0, 0.0)  # no number of single precision
    path = session(tmp_path / "s", mesh)
    message = refuse(1, "replay", path, "-o", tmp_path / "o.stl")
    assert "o.stl: could not be written" in message and "has a corner that is not finite" in message
    assert run("replay", path, "-o", tmp_path / "o.vtp").returncode == 0
    assert sorted(os.listdir(tmp_path)) == ["o.vtp", "s"]


@pytest.mark.parametrize("number, times, code", [(signal.SIGTERM, 1, -signal.SIGTERM), (signal.SIGHUP, 1, -signal.SIGHUP),
                                                 (signal.SIGINT, 2, -signal.SIGINT), (signal.SIGINT, 1, 1)])
def test_a_signal_leaves_no_temporary_file(tmp_path, number, times, code):
    path = session(tmp_path / "s", body(around=400, along=600))  # is written for a while
    (tmp_path / "o.obj").write_text("old")
    program = subprocess.Popen([COMMAND, "replay", path, "-o", tmp_path / "o.obj"], stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 60
    while len(os.listdir(tmp_path)) < 3:  # the temporary file
        assert program.poll() is None and time.monotonic() < deadline
    for _ in range(times):
        program.send_signal(number)
        time.sleep(0.02)
    assert program.wait(60) == code
    assert code != 1 or "nothing is written" in program.stderr.read()
    assert sorted(os.listdir(tmp_path)) == ["o.obj", "s"] and (tmp_path / "o.obj").read_text() == "old"
