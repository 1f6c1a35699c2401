"""A shipped picture in the Studio and a hand that draws over it what is shipped with it; what comes of that."""
import os
import pathlib
import struct
import subprocess

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from desk import until
from sitting import DOG, mesh

DRAWINGS = pathlib.Path(os.environ["OVERSKETCH_SOURCE"]) / "Data" / "Drawings"
MARGIN = 1.1  # about a picture, in its view


class Sheet:
    def __init__(self, sitting, name):
        self.sitting, self.picture = sitting, DRAWINGS / (name + ".png")
        self.size = numpy.array(struct.unpack(">II", self.picture.read_bytes()[16:24]))

    def outline(self, step=6):
        """As shipped, in the picture's pixels from its lower left corner; its first place last once more."""
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.picture.with_suffix(".vtp")))
        reader.Update()
        places = vtk_to_numpy(reader.GetOutput().GetCell(0).GetPoints().GetData())[::step, :2]
        return numpy.vstack([places, places[:1]])

    def on_screen(self, places):
        """Where places of the picture are, which fits its view."""
        pad = self.sitting.place("filler", "Picture")
        pixel = MARGIN * max(self.size[1] / pad.height, self.size[0] / pad.width)
        away = (numpy.asarray(places, float) - 0.5 * self.size) / pixel
        middle = numpy.array([pad.left + 0.5 * pad.width, pad.top + 0.5 * pad.height])
        return [tuple(place) for place in middle + away * [1, -1]]

    def open(self):
        """Starts the program and drops the picture on it, the tool Image to model in the hand."""
        sitting = self.sitting
        sitting.start(DOG)
        sitting.shows(0)
        sitting.fit()
        sitting.alone()
        sitting.desk.key("g")
        sitting.desk.drop(self.picture, sitting.view.left + 300, sitting.view.top + 300)
        until(lambda: (sitting.session() or sitting.autosave()) and sitting.place("filler", "Picture"), "the picture")
        sitting.alone()

    def draw(self, places, **more):
        self.sitting.desk.drag(self.on_screen(places), **more)


def ring(x, y, radius, count=40):
    angles = numpy.linspace(0.0, 2.0 * numpy.pi, count + 1)
    return numpy.column_stack([x + radius * numpy.cos(angles), y + radius * numpy.sin(angles)])


def pixels(sitting, name):
    """What a view shows, "Model" or "Picture": its place and its colours, row by row from above."""
    view = sitting.place("filler", name)
    picture = sitting.desk.picture(view.left, view.top, view.width, view.height)
    return view, vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(view.height, view.width, 3)[::-1].astype(int)


def places_of(sitting, name, colour):
    """The places of a view that have a colour, as (x, y) on the screen."""
    view, seen = pixels(sitting, name)
    rows, columns = numpy.nonzero(abs(seen - colour).max(axis=2) <= 3)
    return numpy.column_stack([columns + view.left, rows + view.top])


def undone_and_redone(sitting, steps, digests):
    """Ctrl+Z back to the first of them and Ctrl+Y to the last. How many steps there are then: one number, or that of each."""
    states = list(zip(steps if isinstance(steps, list) else [steps] * len(digests), digests))
    for (_, now), (count, earlier) in zip(states[:0:-1], states[-2::-1]):
        sitting.desk.key("ctrl+z")
        assert sitting.shows(count, other_than=now) == earlier
    for (_, now), (count, later) in zip(states, states[1:]):
        sitting.desk.key("ctrl+y")
        assert sitting.shows(count, other_than=now) == later


def save(sitting, path):
    sitting.desk.key("ctrl+s")
    sitting.dialogue()
    sitting.desk.key("ctrl+a")
    sitting.desk.type(str(path))
    sitting.desk.key("Return")
    until(path.exists, "the file")


def recover(sitting):
    """Kills the program, starts it again and takes what it offers."""
    sitting.studio.kill()
    sitting.desk.release()
    sitting.start()
    sitting.dialogue()
    sitting.desk.key("Return")


def euler(mesh):
    faces = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    edges = numpy.unique(numpy.sort(numpy.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1), axis=0)
    return len(numpy.unique(faces)) - len(edges) + len(faces)


def replayed(session, path):
    """What the command makes of a session, which must be what it says."""
    done = subprocess.run([os.environ["OVERSKETCH_COMMAND"], "replay", session, "-o", path],
                          env=dict(os.environ, OVERSKETCH_OPENCL="off"), capture_output=True, text=True)
    assert done.returncode == 0 and "not bit for bit" not in done.stderr, done.stderr
    return mesh(path)
