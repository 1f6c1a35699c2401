"""The Studio as a person uses it: real mouse and keys, one long sitting with a crash in it. What the program shows is read from its
autosave, which names the digest of the shown mesh, and from the screen."""
import hashlib
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
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(SOURCE / "Testing" / "Studio"), str(SOURCE / "Testing" / "Pictures")]
import compare  # noqa: E402
from desk import Desk, Studio, until  # noqa: E402

DOG = SOURCE / "Data" / "Models" / "dog.ply"
MODEL = (60, 60, 780, 680)  # the part of the screen with the model: left, top, width, height


def digest(mesh):
    """As Applications/Session/README.md describes it."""
    sums = hashlib.md5(numpy.int32(mesh.GetPoints().GetDataType()).tobytes())
    sums.update(vtk_to_numpy(mesh.GetPoints().GetData()).tobytes())
    cells = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(numpy.int64)
    sums.update(numpy.hstack([numpy.full((len(cells), 1), 3, dtype=numpy.int64), cells]).tobytes())
    return sums.hexdigest()


def mesh(path):
    reader = vtkPLYReader() if path.suffix == ".ply" else vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


class Sitting:
    def __init__(self, home):
        self.home, self.desk, self.studio = home, Desk(), None

    def start(self, *arguments):
        self.studio = Studio(self.home, *arguments)

    def session(self):
        """The autosave of the running program, once its result is there."""
        folder = self.home / "state" / "oversketch" / "autosave"
        mine = [f for f in folder.glob("*-%d" % self.studio.process.pid) if (f / "session.json").exists()]
        if not mine:
            return None
        document = json.loads((mine[0] / "session.json").read_text())
        return document if document["result_md5"] else None

    def shows(self, strokes, other_than=None):
        """Waits until that many strokes are done; returns the digest of the shown mesh."""
        def done():
            assert self.studio.process.poll() is None, (self.home / "log.txt").read_text()
            document = self.session()
            good = document and len(document["strokes"]) == strokes and document["result_md5"] != other_than
            return document["result_md5"] if good else None
        return until(done, f"{strokes} strokes")

    def tick_of_first_stroke(self):
        """Clicks along the first line of the history, whose place depends on the fonts, until the stroke is off. Returns the place."""
        for x in range(904, 936, 4):
            self.desk.click(x, 92)
            end = time.time() + 0.6
            while time.time() < end:
                document = self.session()
                if document and not document["strokes"][0]["on"]:
                    return x, 92
                time.sleep(0.05)
        raise AssertionError("no tick found")

    def settled(self):
        """The model's picture, once it has not changed for a while."""
        last, since = [None], [time.time()]

        def same():
            now = self.desk.picture(*MODEL)
            pixels = vtk_to_numpy(now.GetPointData().GetScalars()).tobytes()
            if pixels != last[0]:
                last[0], since[0] = pixels, time.time()
            return now if time.time() - since[0] > 0.7 else None
        return until(same, "a picture at rest")


def arc(x, y, length, width, lean=0.0, count=40):
    """A narrow arch over a limb that points up at (x, y): up one side, over, down the other."""
    points = []
    for i in range(count + 1):
        t = 2.0 * i / count - 1.0
        points.append((x + width * math.copysign(min(1.0, abs(t) * 4), t) + lean * (1 - abs(t)), y - length * (1 - t * t)))
    return points


# On a window of 1200 x 800 with the dog as it opens.
TAIL = arc(200, 290, 120, 17, lean=8)
HEAD = [(545 + 3 * i, 232 - 30 * math.sin(math.pi * i / 20)) for i in range(21)]
NOSE = [(690 + 38 * math.sin(math.pi * i / 20), 278 + 2.6 * i) for i in range(21)]


@pytest.fixture
def sitting(tmp_path):
    made = Sitting(tmp_path / "home")
    yield made
    if made.studio and made.studio.process.poll() is None:
        made.studio.kill()


def test_a_sitting_with_a_crash_in_it(sitting, tmp_path):
    desk = sitting.desk
    sitting.start(DOG)
    first = sitting.shows(0)
    assert first == digest(mesh(DOG))
    opened = sitting.settled()

    # Turning the model with the middle button moves no vertex; w looks as at first.
    desk.drag([(400, 380), (420, 390), (460, 400), (500, 405)], button=2)
    turned = sitting.settled()
    assert compare.difference(opened, turned) > 1000
    assert sitting.shows(0) == first
    desk.key("w")
    assert compare.difference(opened, sitting.settled()) < 1

    # One stroke; undo and redo show the same bits again.
    desk.drag(TAIL)
    tail = sitting.shows(1)
    assert tail != first
    desk.key("ctrl+z")
    assert sitting.shows(0) == first
    desk.key("ctrl+shift+z")
    assert sitting.shows(1) == tail
    desk.key("ctrl+z")
    assert sitting.shows(0) == first
    desk.key("ctrl+y")
    assert sitting.shows(1) == tail

    # Two more; then the first one is switched off, on, and off by undo.
    desk.drag(HEAD)
    head = sitting.shows(2)
    desk.drag(NOSE)
    three = sitting.shows(3)
    assert len({first, tail, head, three}) == 4
    tick = sitting.tick_of_first_stroke()
    without = sitting.shows(3, other_than=three)
    assert without not in (first, tail, head, three)
    desk.click(*tick)
    assert sitting.shows(3, other_than=without) == three

    # Saved by the dialogue.
    saved = tmp_path / "dog.oversketch"
    desk.move(400, 600)
    desk.key("ctrl+s")
    until(lambda: len(desk.windows()) > 1, "the dialogue")
    desk.focus(desk.windows()[-1][0])
    desk.key("ctrl+a")
    desk.type(str(saved))
    desk.key("Return")
    until(saved.exists, "the file")
    with zipfile.ZipFile(saved) as file:
        document = json.loads(file.read("session.json"))
    assert document["result_md5"] == three and len(document["strokes"]) == 3

    # A fourth stroke is cut short by a crash: what was committed comes back.
    until(lambda: len(desk.windows()) == 1, "the dialogue is closed")
    desk.focus(desk.windows()[0][0])
    desk.drag(TAIL[:20], release=False)
    sitting.studio.kill()
    desk.release()
    sitting.start()
    until(lambda: len(desk.windows()) > 1, "the question")
    desk.focus(desk.windows()[-1][0])
    desk.key("Return")
    assert sitting.shows(3) == three

    # The command makes the same bits from the file.
    out = tmp_path / "replayed.vtp"
    environment = dict(os.environ, OVERSKETCH_OPENCL="off")
    replay = subprocess.run([os.environ["OVERSKETCH_COMMAND"], "replay", saved, "-o", out], env=environment,
                            capture_output=True, text=True)
    assert replay.returncode == 0 and "not bit for bit" not in replay.stderr, replay.stderr
    assert digest(mesh(out)) == three


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


def test_a_bad_file_is_told_and_nothing_is_lost(sitting, tmp_path):
    bad = tmp_path / "bad.ply"
    bad.write_text("ply\nno mesh")
    desk = sitting.desk
    sitting.start(DOG)
    sitting.shows(0)
    desk.drag(TAIL)
    tail = sitting.shows(1)
    desk.drop(bad, 400, 400)
    until(lambda: len(desk.windows()) > 1, "the message")
    desk.focus(desk.windows()[-1][0])
    desk.key("Return")
    until(lambda: len(desk.windows()) == 1, "the message is read")
    assert sitting.shows(1) == tail
    desk.focus(desk.windows()[0][0])
    desk.key("ctrl+z")
    assert sitting.shows(0, other_than=tail) == digest(mesh(DOG))


@pytest.mark.parametrize("arguments", [["a.ply", "b.ply"], ["--nothing"]])
def test_bad_use(sitting, arguments):
    sitting.start(*arguments)
    assert sitting.studio.ended() == 2
    assert (sitting.home / "log.txt").read_text().startswith("oversketch-studio: ")
    assert not (sitting.home / "state").exists()
