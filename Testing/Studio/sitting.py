"""One sitting at the Studio: the program, and a person at its screen. What it shows is read from its autosave, which names the digest of
the shown mesh, from the pictures it saves and from what it tells a screen reader."""
import hashlib
import json
import math
import os
import pathlib
import sys
import time

import numpy
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(SOURCE / "Testing" / "Studio"), str(SOURCE / "Testing" / "Pictures")]
import reader  # noqa: E402
from desk import Desk, Studio, until  # noqa: E402

DOG = SOURCE / "Data" / "Models" / "dog.ply"
VIEW = (880, 700)  # size of the model's part of the window; strokes are told in it, from its upper left corner
SHOTS = pathlib.Path(os.environ["OVERSKETCH_TEMPORARY"]) / "Studio"  # what the screen showed, to look at
PAGES = {"stroke_1_of_3": "studio.png", "fish_with_a_tunnel": "studio_drawing.png"}  # pictures of README.md and Documentation/studio.md


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
        self.home, self.desk, self.studio, self.scale = home, Desk(), None, 1

    def start(self, *arguments, scale=1):
        self.studio, self.scale = Studio(self.home, *arguments, scale=scale), scale

    def place(self, role, name):
        return reader.find(self.studio.process.pid, role, name, self.scale)

    def click(self, role, name):
        self.desk.click(*self.place(role, name).middle)

    def fit(self, size=VIEW):
        """Makes the window so large that the view has that size, whatever the fonts are. Returns the view's place."""
        size = [self.scale * value for value in size]

        def fits():
            view, (window, shape) = self.place("filler", "Model"), self.desk.windows()[0]
            if (view.width, view.height) == tuple(size):
                return view
            window.configure(width=shape.width + size[0] - view.width, height=shape.height + size[1] - view.height)
            self.desk.display.sync()
            time.sleep(0.2)
            return None
        self.view = until(fits, "a view of that size")

    def draw(self, stroke, **more):
        self.desk.drag([(self.view.left + self.scale * x, self.view.top + self.scale * y) for x, y in stroke], **more)

    def autosave(self):
        """Where the running program keeps its session; None before it does."""
        folder = self.home / "state" / "oversketch" / "autosave"
        return next((f for f in folder.glob("*-%d" % self.studio.process.pid) if (f / "session.json").exists()), None)

    def session(self):
        """The autosave, once its result is there."""
        kept = self.autosave()
        if not kept:
            return None
        document = json.loads((kept / "session.json").read_text())
        return document if document["result_md5"] else None

    def shows(self, strokes, other_than=None):
        """Waits until that many strokes are done; returns the digest of the shown mesh."""
        def done():
            assert self.studio.process.poll() is None, (self.home / "log.txt").read_text()
            document = self.session()
            steps = document and (document["steps"] if "steps" in document else document["strokes"])
            good = document and len(steps) == strokes and document["result_md5"] != other_than
            return document["result_md5"] if good else None
        return until(done, f"{strokes} strokes")

    def dialogue(self):
        """The topmost window, once there is one over the first, with the keys."""
        until(lambda: len(self.desk.windows()) > 1, "a dialogue")
        self.desk.focus(self.desk.windows()[-1][0])

    def alone(self):
        """The first window, once it has no other over it, with the keys."""
        until(lambda: len(self.desk.windows()) == 1, "the dialogue is closed")
        self.desk.focus(self.desk.windows()[0][0])

    def picture(self, path, overlays=False):
        """What the program saves of the model; without overlays, which belong to the fonts. A quarter of the pixels of scale 1."""
        self.desk.key("shift+F12" if overlays else "F12")
        self.dialogue()
        self.desk.key("ctrl+a")
        self.desk.type(str(path))
        self.desk.key("Return")
        until(path.exists, "the picture")
        self.alone()
        image = vtkPNGReader()
        image.SetFileName(str(path))
        image.Update()
        size = image.GetOutput().GetDimensions()[:2]
        assert size == tuple(self.scale * value for value in VIEW), size
        half = vtkImageShrink3D()
        half.SetInputConnection(image.GetOutputPort())
        half.SetShrinkFactors(2 * self.scale, 2 * self.scale, 1)
        half.Update()
        return half.GetOutput()

    def shot(self, name):
        """Leaves the window's picture, once it is still; with OVERSKETCH_WRITE_BASELINES that of the page, too."""
        SHOTS.mkdir(parents=True, exist_ok=True)
        until(lambda: not reader.shown(self.studio.process.pid, "button", "Cancel"), "nothing is computed")
        shape, seen = self.desk.windows()[0][1], [None]

        def still():
            picture = self.desk.picture(0, 0, shape.width, shape.height)
            pixels, before = vtk_to_numpy(picture.GetPointData().GetScalars()).tobytes(), seen[0]
            seen[0] = pixels
            return picture if pixels == before else time.sleep(2.0)  # a busy machine paints late
        picture = until(still, "a window at rest")
        page = os.environ.get("OVERSKETCH_WRITE_BASELINES") and PAGES.get(name)
        for path in [SHOTS / (name + ".png")] + ([SOURCE / "Data" / "Pictures" / page] if page else []):
            writer = vtkPNGWriter()
            writer.SetFileName(str(path))
            writer.SetInputData(picture)
            writer.Write()


def arc(x, y, length, width, lean=0.0, count=40):
    """A narrow arch over a limb that points up at (x, y): up one side, over, down the other."""
    points = []
    for i in range(count + 1):
        t = 2.0 * i / count - 1.0
        points.append((x + width * math.copysign(min(1.0, abs(t) * 4), t) + lean * (1 - abs(t)), y - length * (1 - t * t)))
    return points


TAIL = arc(193, 225, 120, 17, lean=8)  # on the dog as it opens


@pytest.fixture
def sitting(tmp_path):
    made = Sitting(tmp_path / "home")
    yield made
    if made.studio and made.studio.process.poll() is None:
        made.studio.kill()
