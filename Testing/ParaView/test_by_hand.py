"""By hand in ParaView's window, as Applications/ParaView/README.md tells it: a line drawn with the mouse, the view's camera taken by the
button, the leg longer; lines drawn over a picture, a model of them. Testing/ParaView/test.sh gives it a display and a bus for what a
screen reader hears."""
import json
import os
import pathlib
import subprocess
import sys
import time

import numpy
import pytest
import vtk_build
from vtkmodules.vtkIOImage import vtkPNGWriter

HERE = pathlib.Path(__file__).resolve().parent
DATA = HERE.parents[1] / "Data"
DOG, FISH = DATA / "Models" / "dog.ply", DATA / "Drawings" / "fish.png"
PLUGIN = pathlib.Path(os.environ["OVERSKETCH_PLUGIN"])
sys.path.append(str(HERE.parent / "Studio"))
import reader  # noqa: E402
from desk import Desk, until  # noqa: E402

# The outline of a longer hind leg [world, at the depth of the leg].
LEG = [(x, y, 0.3) for x, y in ((-0.83, 0.4), (-0.86, -0.08), (-0.838, -0.307), (-0.62, -0.32), (-0.63, -0.24), (-0.728, -0.174),
                                (-0.706, 0.246))]
# Places on the picture of the fish [px from its lower left corner]: the outline, the gill cover and the breast fin; whether each is closed.
DRAWING = [
    ([(118, 317), (277, 458), (395, 577), (648, 541), (722, 408), (795, 359), (965, 515), (928, 322), (966, 130), (794, 288), (716, 140),
      (600, 90), (535, 160), (396, 60), (316, 162)], True),
    ([(318, 459), (360, 330), (302, 202)], False),
    ([(398, 290), (470, 318), (566, 262), (480, 236)], True),
]
if not os.environ.get("OVERSKETCH_FULL"):  # for each commit half of the outline's places, without the fin
    DRAWING = [(DRAWING[0][0][::2], True), DRAWING[1]]
SECONDS = 300  # for one step on a busy machine


def projected(camera, points):
    """Where a camera shows points: pixels from the lower left corner."""
    both = numpy.array(camera["ProjectionTransform"]).reshape(4, 4) @ numpy.array(camera["ViewTransform"]).reshape(4, 4)
    clip = numpy.hstack([points, numpy.ones((len(points), 1))]) @ both.T
    return 0.5 * (clip[:, :2] / clip[:, 3:] + 1.0) * camera["ViewportSize"]


def same_view(a, b):
    """Near and far planes, the third row of the projection, mean nothing."""
    rows = [0, 1, 3]
    return (a["ViewportSize"] == b["ViewportSize"] and numpy.allclose(a["ViewTransform"], b["ViewTransform"], rtol=0, atol=1e-9)
            and numpy.allclose(numpy.reshape(a["ProjectionTransform"], (4, 4))[rows], numpy.reshape(b["ProjectionTransform"], (4, 4))[rows],
                               rtol=0, atol=1e-9))


class Window:
    """ParaView's, with a home of its own and a file open."""

    def __init__(self, home, opened):
        self.desk, self.file = Desk(), home / "state.json"
        (home / "run").mkdir(mode=0o700)
        environment = dict(
            os.environ, HOME=str(home), XDG_CONFIG_HOME=str(home / "config"), XDG_RUNTIME_DIR=str(home / "run"),
            OVERSKETCH_STATE=str(self.file), OVERSKETCH_OPEN=str(opened), PYTHONPATH=f"{HERE}:{os.environ['PYTHONPATH']}",
            PYTHONDONTWRITEBYTECODE="1", QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", LC_ALL="C.UTF-8")
        self.log = open(home / "log.txt", "w")
        # --dr: without what was kept, nor a welcome.
        self.process = subprocess.Popen(
            ["paraview", "--dr", f"--plugin-search-paths={PLUGIN.parent}", "--plugins=Oversketch",
             f"--script={HERE / 'by_hand_scene.py'}", "-geometry", "1280x1400+0+0"],
            env=environment, stdout=self.log, stderr=self.log)
        self.wait(self.file.exists, f"{opened.stem} in a window")
        self.panel(opened.stem)

    def wait(self, condition, what):
        def met():
            assert self.process.poll() is None, "ParaView ended\n" + self.said()
            return condition()
        return until(met, what, SECONDS)

    def said(self):
        return pathlib.Path(self.log.name).read_text()

    def state(self):
        return json.loads(self.file.read_text())

    def output(self, name):
        return self.state()["sources"].get(name)

    def things(self):
        try:
            return reader.things(self.process.pid)
        except reader.GLib.Error:  # something went away meanwhile
            return []

    def place(self, role, name):
        """Of the one thing of that role and name, once it can be used."""
        def usable():
            hits = [thing for its, named, thing in self.things() if its == role and named == name]
            if len(hits) == 1 and hits[0].get_state_set().contains(reader.Atspi.StateType.ENABLED):
                return reader.Place(hits[0].get_extents(reader.Atspi.CoordType.SCREEN), 1)
        return self.wait(usable, f"{role} {name}")

    def push(self, name):
        self.desk.click(*self.place("button", name).middle)

    def panel(self, name):
        """Waits for the properties of that source."""
        self.place("label", f"Properties ({name})")

    def named(self, title):
        """The window of that title, with the keys."""
        window = self.wait(lambda: next((w for w, _ in self.desk.windows() if title in (w.get_wm_name() or "")), None), title)
        self.desk.focus(window)

    def launch(self, name):
        """A source or filter by its name, as with the menu."""
        self.desk.move(900, 1300)  # over the view, where no hint comes up
        self.wait(lambda: len(self.desk.windows()) == 1, "ParaView's window alone")
        self.named("ParaView")
        self.desk.key("ctrl+space")
        self.wait(lambda: len(self.desk.windows()) == 2, "the field for names")
        self.desk.focus(self.desk.windows()[-1][0])
        self.desk.type(name)
        self.place("button", name)
        self.desk.key("Return")

    def on_screen(self, points):
        """Where the view shows points of the world on the screen."""
        camera = self.state()
        width, height = camera["ViewportSize"]

        def view():
            shapes = [(t.get_extents(reader.Atspi.CoordType.SCREEN)) for _, _, t in self.things()]
            return min((s for s in shapes if 0 <= s.width - width < 20 and 0 <= s.height - height < 20), default=None,
                       key=lambda s: s.width * s.height)
        shape = self.wait(view, "the view")
        left, bottom = shape.x + (shape.width - width) / 2, shape.y + (shape.height + height) / 2
        return [(left + x, bottom - y) for x, y in projected(camera, points)]

    def table(self):
        """The cells with the line's points; also what is scrolled out of sight."""
        tables = [thing for role, _, thing in self.things() if role == "table"]
        children = [tables[0].get_child_at_index(i) for i in range(tables[0].get_child_count())] if len(tables) == 1 else []
        return [child for child in children if child and child.get_role_name() == "table cell"]

    def cells(self):
        try:
            return [cell.get_name() for cell in self.table()]
        except reader.GLib.Error:  # something went away meanwhile
            return []

    def drag(self, start, end):
        """Takes the line's point at a place elsewhere; returns when the table tells it."""
        before = self.wait(self.cells, "the line's table")
        middle = [(a + b) / 2 for a, b in zip(start, end)]
        self.desk.drag([start, start, middle, end, end], pause=0.1)
        self.wait(lambda: len(self.cells()) == len(before) and self.cells() != before, "the point at its place")

    def add(self, place):
        """A point on the line there."""
        count = len(self.wait(self.cells, "the line's table"))
        self.desk.move(*place)
        self.desk.hold("ctrl")
        self.desk.press()
        self.desk.release()
        self.desk.hold("ctrl", False)
        self.wait(lambda: len(self.cells()) == count + 3, "one more point")

    def draw(self, points):
        """A new line through points: its two ends are taken to theirs, then points are added and taken to their places."""
        places = self.on_screen(points)
        ends = self.wait(lambda: self.cells() if len(self.cells()) == 6 else None, "the line's two points")
        ends = self.on_screen(numpy.reshape([float(value) for value in ends], (2, 3)))
        self.drag(ends[0], places[0])
        self.drag(ends[1], places[-1])
        for before, place in zip(places, places[1:-1]):
            added = [(a + b) / 2 for a, b in zip(before, places[-1])]
            self.add(added)
            self.drag(added, place)

    def choose(self, names):
        """Sources that lie one below the other in the browser, whose rows no screen reader hears: looked for from its top down."""
        browser, places = self.place("frame", "Pipeline Browser"), []
        x = browser.left + 90
        for wait in (1.5, 5.0, 15.0):  # a busy machine answers after the hand has gone on
            places, y = [], browser.top + 30
            while len(places) < len(names) and y < browser.top + browser.height:
                self.desk.click(x, y)
                try:
                    until(lambda: self.state()["active"] == names[len(places)], "that row", wait)
                    places.append((x, y + 7))
                except TimeoutError:
                    pass  # not there yet
                y += 7
            if len(places) == len(names):
                break
        assert len(places) == len(names), places
        for index, place in enumerate(places):
            self.desk.hold("ctrl", index > 0)
            self.desk.click(*place)
            time.sleep(0.5)
        self.desk.hold("ctrl", False)

    def picture(self, path):
        writer = vtkPNGWriter()
        writer.SetInputData(self.desk.picture())
        writer.SetFileName(str(path))
        writer.Write()


@pytest.fixture()
def window(tmp_path, request):
    opened = Window(tmp_path, request.param)
    yield opened
    opened.picture(tmp_path / "screen.png")
    opened.process.kill()
    opened.process.wait()


def redrawn(window, over):
    """The digest of what the VTK build makes of the strokes that the window told."""
    command = ["/usr/bin/python3", HERE / "redrawn.py", window.file, "OversketchViewStroke1", over]
    environment = vtk_build.environment() if vtk_build.PRESENT else os.environ
    return subprocess.run(command, env=environment, check=True, capture_output=True, text=True).stdout.strip()


@pytest.mark.parametrize("window", [DOG], indirect=True, ids=["dog"])
def test_a_line_drawn_in_the_view_makes_the_leg_longer(window):
    window.launch("Poly Line Source")
    window.panel("PolyLineSource1")
    window.draw(LEG)
    window.push("Apply")
    drawn = window.wait(lambda: window.output("PolyLineSource1"), "the line")["points"]
    assert len(drawn) == len(LEG)
    assert numpy.linalg.norm(projected(window.state(), drawn) - projected(window.state(), LEG), axis=1).max() < 4.0  # px

    # A new stroke takes the camera by itself.
    name = "OversketchViewStroke1"
    window.launch("Oversketch View Stroke")
    window.panel(name)
    window.push("Apply")
    stroke = window.wait(lambda: window.output(name), "the stroke")
    first = window.state()
    assert same_view(stroke["arrays"], first)
    assert numpy.allclose(numpy.array(stroke["points"])[:, :2], projected(first, drawn), atol=1e-3)

    # The model is turned: the stroke stays, until the button is pressed.
    corner = window.on_screen([(0.0, 1.6, 0.0)])[0]
    window.desk.drag([corner, (corner[0] + 20, corner[1]), (corner[0] + 80, corner[1] + 20)], pause=0.1)
    window.wait(lambda: not same_view(window.state(), first), "the model turned")
    assert same_view(window.output(name)["arrays"], first)
    window.push("Take the camera of the view")
    window.push("Apply")
    window.wait(lambda: not same_view(window.output(name)["arrays"], first), "a camera that was taken")
    turned, stroke = window.state(), window.output(name)
    assert same_view(stroke["arrays"], turned) and not same_view(turned, first)
    assert numpy.allclose(numpy.array(stroke["points"])[:, :2], projected(turned, drawn), atol=1e-3)

    # Back again, where the line lies over the leg.
    window.push("Camera Undo")
    window.wait(lambda: same_view(window.state(), first), "the first camera")
    window.push("Take the camera of the view")
    window.push("Apply")
    window.wait(lambda: same_view(window.output(name)["arrays"], first), "the first camera in the stroke")
    stroke = window.output(name)

    # The dog is chosen in the browser, whose rows no screen reader hears, then the stroke in the dialogue.
    window.desk.click(*window.place("frame", "Pipeline Browser").middle)
    for key in ["Up"] * 5 + ["Down"]:
        window.desk.key(key)
    window.wait(lambda: window.state()["active"] == "dog", "the dog chosen")
    window.launch("Oversketch One Stroke")
    radio, ok = window.place("radio button", "Stroke"), window.place("button", "OK")
    window.named("Change Input")
    window.desk.click(*radio.middle)
    window.desk.click(ok.left, ok.top - ok.height)
    for key in ["Down"] * 5:
        window.desk.key(key)
    window.desk.click(*ok.middle)
    window.panel("OversketchOneStroke1")
    window.named("ParaView")
    window.push("Apply")
    made, dog = window.wait(lambda: window.output("OversketchOneStroke1"), "the mesh"), window.output("dog")
    lowest = min(y for _, y, _ in LEG)
    assert abs(dog["bounds"][2]) < 0.01 and abs(made["bounds"][2] - lowest) < 0.06, made["bounds"]
    assert made["digest"] == redrawn(window, DOG) != dog["digest"]
    assert "ERR|" not in window.said() and "Traceback" not in window.said(), window.said()


@pytest.mark.parametrize("window", [FISH], indirect=True, ids=["fish"])
def test_lines_drawn_over_a_picture_become_a_model(window):
    middle = window.on_screen([(512.0, 320.0, 0.0)])[0]
    for _ in range(2):
        window.desk.click(*middle, button=5)  # further away: a new line lies in the picture's corner
    lines = []
    for points, closed in DRAWING:
        window.launch("Poly Line Source")
        lines.append(f"PolyLineSource{len(lines) + 1}")
        window.panel(lines[-1])
        window.draw([(x, y, 0.0) for x, y in points])
        if closed:
            window.desk.click(*window.place("check box", "Closed").middle)
        window.push("Apply")
        window.wait(lambda: window.output(lines[-1]), "the line")

    # Together they are a drawing, over the view of the picture.
    window.choose(lines)
    window.launch("Append Geometry")
    window.panel("AppendGeometry1")
    window.push("Apply")
    window.wait(lambda: window.output("AppendGeometry1"), "the lines together")
    window.launch("Oversketch View Stroke")
    window.panel("OversketchViewStroke1")
    window.push("Apply")
    stroke = window.wait(lambda: window.output("OversketchViewStroke1"), "the strokes")
    assert stroke["counts"] == [len(points) + closed for points, closed in DRAWING]
    drawn = numpy.vstack([points + points[:1] * closed for points, closed in DRAWING])
    places = projected(window.state(), numpy.hstack([drawn, numpy.zeros((len(drawn), 1))]))
    assert all(numpy.linalg.norm(places - place, axis=1).min() < 4.0 for place in numpy.array(stroke["points"])[:, :2])  # px

    # A model, whose canvas is the view; then the picture's, and it is the VTK build's.
    window.launch("Oversketch Inflate Drawing")
    window.panel("OversketchInflateDrawing1")
    window.push("Apply")
    without = window.wait(lambda: window.output("OversketchInflateDrawing1"), "the model")
    window.desk.click(*window.place("menu item", "Edit").middle)
    window.desk.click(*window.place("menu item", "Change Input...").middle)
    radio, ok = window.place("radio button", "Picture"), window.place("button", "OK")
    window.named("Change Input")
    window.desk.click(*radio.middle)
    window.desk.click(ok.left, ok.top - ok.height)
    for _ in range(9):
        window.desk.key("Up")
    window.desk.click(*ok.middle)
    window.wait(lambda: window.output("OversketchInflateDrawing1")["digest"] != without["digest"], "the picture's canvas")
    assert window.output("OversketchInflateDrawing1")["digest"] == redrawn(window, FISH)
    assert "ERR|" not in window.said() and "Traceback" not in window.said(), window.said()
