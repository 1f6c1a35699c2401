"""The Studio as a person uses it: real mouse and keys, one long sitting with a crash in it. What the program shows is read from its
autosave, which names the digest of the shown mesh, from the pictures it saves and from what it tells a screen reader."""
import json
import math
import os
import pathlib
import subprocess
import sys
import time
import zipfile

import numpy
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance
from vtkmodules.vtkIOImage import vtkPNGReader

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(SOURCE / "Testing" / "Studio"), str(SOURCE / "Testing" / "Pictures")]
import compare  # noqa: E402
import reader  # noqa: E402
from desk import until  # noqa: E402
from sitting import DOG, TAIL, VIEW, Sitting, digest, mesh, sitting  # noqa: E402, F401

# On the dog as it opens.
HEAD = [(538 + 3 * i, 167 - 30 * math.sin(math.pi * i / 20)) for i in range(21)]
NOSE = [(683 + 38 * math.sin(math.pi * i / 20), 230 + 2.0 * i) for i in range(21)]


def pixels_of(path):
    """Rows from the top."""
    image = vtkPNGReader()
    image.SetFileName(str(path))
    image.Update()
    width, height, _ = image.GetOutput().GetDimensions()
    return vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]


def redder(picture):
    """The same picture in a slightly wrong colour."""
    wrong = vtkImageData()
    wrong.DeepCopy(picture)
    pixels = vtk_to_numpy(wrong.GetPointData().GetScalars())
    pixels[:, 0] = numpy.minimum(255, pixels[:, 0] * 1.25)
    return wrong


def test_a_sitting_with_a_crash_in_it(sitting, tmp_path):
    desk = sitting.desk
    sitting.start(DOG)
    first = sitting.shows(0)
    assert first == digest(mesh(DOG))
    sitting.fit()
    sitting.alone()
    sitting.shot("opened")
    opened = sitting.picture(tmp_path / "opened.png")
    if compare.matches(opened, "studio_opened"):
        assert compare.difference(redder(opened), compare.read("studio_opened")) > 10 * compare.LIMIT

    # Turning the model with the middle button moves no vertex; w looks as at first.
    sitting.draw([(400, 320), (420, 330), (460, 340), (500, 345)], button=2)
    turned = sitting.picture(tmp_path / "turned.png")
    assert compare.difference(opened, turned) > 1000
    assert sitting.shows(0) == first
    desk.move(*sitting.view.middle)
    desk.key("w")
    assert compare.difference(opened, sitting.picture(tmp_path / "w.png")) < 1

    # One stroke; undo and redo show the same bits again.
    sitting.draw(TAIL)
    tail = sitting.shows(1)
    assert tail != first
    sitting.shot("one_stroke")
    desk.key("ctrl+z")
    assert sitting.shows(0) == first
    desk.key("ctrl+shift+z")
    assert sitting.shows(1) == tail
    desk.key("ctrl+z")
    assert sitting.shows(0) == first
    desk.key("ctrl+y")
    assert sitting.shows(1) == tail
    compare.matches(sitting.picture(tmp_path / "tail.png"), "studio_tail")

    # Two more; then the first one is switched off and on.
    sitting.draw(HEAD)
    head = sitting.shows(2)
    sitting.draw(NOSE)
    three = sitting.shows(3)
    assert len({first, tail, head, three}) == 4
    compare.matches(sitting.picture(tmp_path / "three.png"), "studio_three")
    line = sitting.place("list item", "Stroke 1")
    tick = line.left + 10, line.middle[1]  # its box, left of the picture
    desk.click(*tick)
    without = sitting.shows(3, other_than=three)
    assert without not in (first, tail, head, three)
    assert [stroke["on"] for stroke in sitting.session()["strokes"]] == [False, True, True]
    desk.click(*tick)
    assert sitting.shows(3, other_than=without) == three

    # How stroke 1 of 3 acts is changed by mouse, twice; both are undone.
    sitting.click("list item", "Stroke 1")
    sitting.click("check box", "Details turn with the limb")
    turning = sitting.shows(3, other_than=three)
    assert turning not in (first, tail, head, three, without)
    assert [stroke["adjust_normals"] for stroke in sitting.session()["strokes"]] == [True, False, False]
    sitting.click("combo box", "where needed")
    until(lambda: len(desk.windows()) > 1, "the choices")
    time.sleep(0.3)  # a click as quick as a double click would be the first one's
    choices = desk.windows()[-1][1]
    desk.click(choices.x + choices.width // 3, choices.y + choices.height * 5 // 6)  # the last of three
    remeshed = sitting.shows(3, other_than=turning)
    assert [stroke["remesh"] for stroke in sitting.session()["strokes"]] == ["off", "auto", "auto"]
    assert remeshed not in (first, tail, head, three, without)
    sitting.shot("stroke_1_of_3")
    compare.matches(sitting.picture(tmp_path / "changed.png"), "studio_changed")
    desk.key("ctrl+z")
    assert sitting.shows(3, other_than=remeshed) == turning
    desk.key("ctrl+z")
    assert sitting.shows(3, other_than=turning) == three

    # Saved by the dialogue.
    saved = tmp_path / "dog.oversketch"
    desk.move(400, 600)
    desk.key("ctrl+s")
    sitting.dialogue()
    desk.key("ctrl+a")
    desk.type(str(saved))
    desk.key("Return")
    until(saved.exists, "the file")
    with zipfile.ZipFile(saved) as file:
        document = json.loads(file.read("session.json"))
    assert document["result_md5"] == three and len(document["strokes"]) == 3

    # A stroke is cut short by a crash, and not all that was committed before was saved: it comes back.
    sitting.alone()
    desk.click(*tick)
    changed = sitting.shows(3, other_than=three)
    sitting.draw(TAIL[:20], release=False)
    sitting.studio.kill()
    desk.release()
    sitting.start()
    sitting.dialogue()
    sitting.shot("after_a_crash")
    desk.key("Return")
    assert sitting.shows(3) == changed

    # The command makes the same bits from the file.
    out = tmp_path / "replayed.vtp"
    environment = dict(os.environ, OVERSKETCH_OPENCL="off")
    replay = subprocess.run([os.environ["OVERSKETCH_COMMAND"], "replay", saved, "-o", out], env=environment,
                            capture_output=True, text=True)
    assert replay.returncode == 0 and "not bit for bit" not in replay.stderr, replay.stderr
    assert digest(mesh(out)) == three


def outcome(sitting, path):
    """What the session that is shown gives, made by the command."""
    environment = dict(os.environ, OVERSKETCH_OPENCL="off")
    subprocess.run([os.environ["OVERSKETCH_COMMAND"], "replay", sitting.autosave(), "-o", path], env=environment, check=True,
                   capture_output=True)
    return mesh(path)


def farthest(a, b):
    """The longest way from a point of one mesh to the other mesh."""
    to = vtkImplicitPolyDataDistance()
    to.SetInput(b)
    return max(abs(to.EvaluateFunction(a.GetPoint(i))) for i in range(a.GetNumberOfPoints()))


def test_a_screen_twice_as_dense(tmp_path):
    """The same hand over the same place draws the same, in finer steps; lines and texts are as large to the eye."""
    meshes, pictures, lines, texts, samples = [], [], [], [], []
    for scale in (1, 2):
        made = Sitting(tmp_path / str(scale))
        try:
            made.start(scale=scale)
            made.shows(0)
            made.fit()
            made.alone()
            file = tmp_path / f"hint{scale}.png"
            made.picture(file, overlays=True)
            pixels = pixels_of(file)
            rows, columns = numpy.nonzero(pixels[:int(0.3 * len(pixels))].min(axis=2) > 200)
            texts.append((numpy.ptp(rows), numpy.ptp(columns)))
            made.draw(TAIL)
            made.shows(1)
            file = tmp_path / f"drawn{scale}.png"
            made.picture(file, overlays=True)
            pixels = pixels_of(file).astype(int)
            lines.append((pixels[:, :, 0] > 60 + pixels[:, :, 1:].max(axis=2)).sum())
            pictures.append(made.picture(tmp_path / f"bare{scale}.png"))
            meshes.append(outcome(made, tmp_path / f"result{scale}.vtp"))
            stroke = mesh(next((made.autosave() / "strokes").glob("*.vtp")))
            assert tuple(stroke.GetCellData().GetArray("ViewportSize").GetTuple(0)) == tuple(scale * v for v in VIEW)
            samples.append(vtk_to_numpy(stroke.GetPoints().GetData())[:, :2] / scale)
        finally:
            made.studio.kill()
    assert numpy.array(texts[1]) / texts[0] == pytest.approx(2.0, rel=0.1), texts
    assert 3.0 < lines[1] / lines[0] < 5.0, lines
    for side in (numpy.min, numpy.max):
        assert numpy.abs(side(samples[0], axis=0) - side(samples[1], axis=0)).max() < 2.0
    print("Scales 1 and 2 differ by", compare.difference(*pictures), "of", compare.LIMIT)
    assert compare.difference(*pictures) < compare.LIMIT
    assert compare.difference(pictures[0], compare.read("studio_opened")) > 5 * compare.LIMIT
    pixel = meshes[0].GetLength() / 700.0
    apart = [farthest(*meshes) / pixel, farthest(*meshes[::-1]) / pixel]
    print("Their meshes are", apart, "px apart")
    assert max(apart) < 2.0


def test_a_file_is_dropped_on_the_window(sitting):
    sitting.start(DOG)
    first = sitting.shows(0)
    octopus = SOURCE / "Data" / "Models" / "octopus.ply"
    sitting.desk.drop(octopus, 400, 400)
    assert sitting.shows(0, other_than=first) == digest(mesh(octopus))


def test_opens_on_a_model_and_leaves_nothing_behind(sitting):
    sitting.start()
    assert sitting.shows(0) == digest(mesh(DOG))
    sitting.desk.focus(sitting.desk.windows()[-1][0])
    sitting.desk.key("ctrl+q")
    assert sitting.studio.ended() == 0
    autosave = sitting.home / "state" / "oversketch" / "autosave"
    assert not list(autosave.iterdir())
    # Of files it leaves the preferences; caches are the libraries', the log is this test's.
    left = {str(file.relative_to(sitting.home)) for file in sitting.home.rglob("*") if file.is_file()}
    left = {file for file in left if not file.startswith((".cache/", "run/"))}
    assert left == {"config/oversketch/oversketch-studio.conf", "log.txt"}


def test_a_bad_file_is_told_and_nothing_is_lost(sitting, tmp_path):
    bad = tmp_path / "bad.ply"
    bad.write_text("ply\nno mesh")
    desk = sitting.desk
    sitting.start(DOG)
    sitting.shows(0)
    sitting.fit()
    sitting.draw(TAIL)
    tail = sitting.shows(1)
    desk.drop(bad, 400, 400)
    sitting.click("button", "Discard")  # before anything is read
    until(lambda: not reader.shown(sitting.studio.process.pid, "button", "Discard"), "the question is answered")
    sitting.dialogue()
    sitting.shot("bad_file")
    desk.key("Return")
    sitting.alone()
    assert sitting.shows(1) == tail
    desk.key("ctrl+z")
    assert sitting.shows(0, other_than=tail) == digest(mesh(DOG))


@pytest.mark.parametrize("arguments", [["a.ply", "b.ply"], ["--nothing"]])
def test_bad_use(sitting, arguments):
    sitting.start(*arguments)
    assert sitting.studio.ended() == 2
    assert (sitting.home / "log.txt").read_text().startswith("oversketch-studio: ")
    assert not (sitting.home / "state").exists()


AXES = 120  # px; of the corner that shows them, in colours


def pixels_like(sitting, colour):
    """How many pixels of the view, on the screen, are about of a colour."""
    view = sitting.view
    image = sitting.desk.picture(view.left, view.top, view.width, view.height)
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).astype(int).reshape(view.height, view.width, -1)
    like = abs(pixels - colour).max(axis=2) < 40
    like[:AXES, -AXES:] = like[-AXES:, -AXES:] = False  # wherever pictures begin
    return int(like.sum())


def orange_pixels(sitting):
    """The same for the region, which is lit."""
    view = sitting.view
    image = sitting.desk.picture(view.left, view.top, view.width, view.height)
    red, green, blue = vtk_to_numpy(image.GetPointData().GetScalars()).astype(int).T
    return int(((red > 90) & (red - blue > 60) & (green > 0.45 * red) & (green < 0.8 * red)).sum())


BLUE, RED = (41, 107, 242), (219, 33, 31)


def test_a_stroke_is_taken_hold_of(sitting):
    desk = sitting.desk
    sitting.start(DOG)
    first = sitting.shows(0)
    sitting.fit()
    sitting.alone()
    assert pixels_like(sitting, BLUE) == 0
    sitting.draw(TAIL, release=False)
    until(lambda: pixels_like(sitting, BLUE) > 100, "the section under the pen")
    assert pixels_like(sitting, RED) > 300
    sitting.shot("section")
    assert sitting.shows(0) == first  # nothing is deformed while the pen is down
    desk.release()
    tail = sitting.shows(1)
    desk.move(sitting.view.left + 700, sitting.view.top + 600)

    def clay(x, y):
        """Whether the model is seen at a place of the view."""
        image = desk.picture(sitting.view.left + x, sitting.view.top + y, 1, 1)
        return vtk_to_numpy(image.GetPointData().GetScalars()).min() > 90
    until(lambda: clay(197, 150) and pixels_like(sitting, BLUE) < 20, "the tail has followed")

    # Dragged by its flank: the mesh follows, Escape takes it back, nothing was committed.
    place = (sitting.view.left, sitting.view.top, sitting.view.width, sitting.view.height)
    before = desk.picture(*place)
    flank = TAIL[8]
    path = [(flank[0] - 2 * i, flank[1] - i) for i in range(12)]
    sitting.draw(path, release=False, pause=0.05)
    until(lambda: compare.difference(before, desk.picture(*place)) > 400, "the preview")
    sitting.shot("drag")
    desk.key("Escape")
    desk.release()
    desk.move(sitting.view.left + 700, sitting.view.top + 600)
    until(lambda: compare.difference(before, desk.picture(*place)) < 20, "the mesh as it was")
    assert sitting.shows(1) == tail

    # Let go, the moved stroke runs: still one stroke, and undo is one step.
    sitting.draw(path, pause=0.05)
    moved = sitting.shows(1, other_than=tail)
    assert moved not in (first, tail)
    desk.key("ctrl+z")
    assert sitting.shows(1, other_than=moved) == tail
    desk.key("ctrl+y")
    assert sitting.shows(1, other_than=tail) == moved

    # With Shift a part of it is drawn anew.
    desk.key("ctrl+z")
    assert sitting.shows(1, other_than=moved) == tail
    until(lambda: clay(197, 150), "the tail as it was")
    desk.hold("shift")
    sitting.draw([(x - 10 * math.sin(math.pi * i / 8), y) for i, (x, y) in enumerate(TAIL[6:15])], pause=0.05)
    desk.hold("shift", down=False)
    part = sitting.shows(1, other_than=tail)
    assert part not in (first, tail, moved)

    # After Return the line is left alone: the next stroke begins on it.
    desk.click(sitting.view.left + 700, sitting.view.top + 600)
    desk.key("Return")
    until(lambda: pixels_like(sitting, RED) < 50, "no line")
    sitting.draw([(x - 6 * math.sin(math.pi * i / 12), y) for i, (x, y) in enumerate(TAIL[4:17])])
    assert sitting.shows(2) not in (first, tail, moved, part)
    desk.key("ctrl+z")
    assert sitting.shows(1) == part

    # The region on request.
    assert orange_pixels(sitting) < 400
    desk.key("o")
    until(lambda: orange_pixels(sitting) > 1500, "the region")
    sitting.shot("region")
    desk.key("o")
    until(lambda: orange_pixels(sitting) < 400, "no region")
