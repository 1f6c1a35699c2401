"""Edits in the Studio by real mouse and keys: a line and a ring, a drag, an axis, the ring redrawn in part, a layer gone and back, a lasso,
a profile, its plane slid, the profile redrawn, all undone and redone; the program is killed, and what it shows after it is what it showed
before, and what the command makes of the saved session, bit for bit."""
import math
import os
import pathlib
import sys

import numpy

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(SOURCE / "Testing" / "Studio"), str(SOURCE / "Testing" / "Pictures")]
from desk import until  # noqa: E402
from sheet import places_of, recover, replayed, save  # noqa: E402
from sitting import DOG, digest, sitting  # noqa: E402, F401

MIDDLE = (400, 340)  # of the dog's flank, as it opens
LINE = [(MIDDLE[0] - 35 + 2 * i, MIDDLE[1]) for i in range(36)]
GREEN = (20, 145, 60)  # the handle's axis across the line (Widgets/Edit/edit_overlay.h)


def ring(wide, high, begin=0.0, end=2.0 * math.pi, middle=MIDDLE, count=60):
    angles = [begin + (end - begin) * i / count for i in range(count + 1)]
    return [(middle[0] + wide * math.cos(a), middle[1] + high * math.sin(a)) for a in angles]


def straight(begin, end, count=15):
    return [(begin[0] + (end[0] - begin[0]) * i / count, begin[1] + (end[1] - begin[1]) * i / count) for i in range(count + 1)]


def off(x, y):
    """A place so far from the line's middle."""
    return MIDDLE[0] + x, MIDDLE[1] + y


def dock(sitting, name, path, **more):
    """Drags over a dock's picture, by shares of its sides."""
    picture = sitting.place("filler", name)
    sitting.desk.drag([(picture.left + x * picture.width, picture.top + y * picture.height) for x, y in path], **more)


def step(sitting, row):
    """What the session says of a step, once its result is there."""
    return until(sitting.session, "the session's result")["steps"][row]


def on_an_axis(sitting):
    """The middle of the green axis, which scales, and a way along it outward; on the screen."""
    def seen():
        places = places_of(sitting, "Model", GREEN).astype(float)
        return [places] if len(places) > 60 else None
    places, = until(seen, "the handle's axes")
    along = numpy.linalg.svd(places - places.mean(0))[2][0]
    shares = places @ along
    ends = [places[shares.argmin()], places[shares.argmax()]]
    root = numpy.array([sitting.view.left, sitting.view.top]) + off(0, -25)
    ends.sort(key=lambda end: numpy.linalg.norm(end - root))
    return 0.5 * (ends[0] + ends[1]), (ends[1] - ends[0]) / numpy.linalg.norm(ends[1] - ends[0])


class Told:
    """What the window showed after each step of undo: how many steps the session has, and the mesh's digest."""

    def __init__(self, sitting, *first):
        self.sitting, self.states = sitting, [first]

    def another(self, steps=1, shot=None):
        """After a step that changes the mesh."""
        made = self.sitting.shows(steps, other_than=self.states[-1][1])
        self.states.append((steps, made))
        if shot:
            self.sitting.shot("edit_" + shot)
        return made

    def shown(self, steps, made):
        until(lambda: self.sitting.shows(steps) == made, f"{steps} steps, and their mesh")

    def undone_and_redone(self):
        """To the model alone, and back."""
        for key, states in (("ctrl+z", self.states[-2::-1]), ("ctrl+y", self.states[1:])):
            for state in states:
                self.sitting.desk.key(key)
                self.shown(*state)


def test_all_of_an_edit_is_undone_and_redone_and_outlives_a_kill(sitting, tmp_path):
    desk = sitting.desk
    sitting.start(DOG)
    bare = sitting.shows(0)
    sitting.fit()
    sitting.alone()
    desk.key("e")
    sitting.draw(LINE)
    sitting.draw(ring(75, 42))
    assert sitting.shows(1) == bare, "a region alone moves something"
    told = Told(sitting, 0, bare)
    told.states.append((1, bare))
    sitting.draw(straight(MIDDLE, off(0, -25)))
    told.another(shot="pulled")

    # An axis of the handle that the drag has left there.
    at, way = on_an_axis(sitting)
    desk.drag(straight(at, at + 15 * way))
    told.another()
    assert "scale" in step(sitting, 0)["values"]["Operations"]

    # The ring redrawn in part, with Shift: its right.
    desk.key("Escape")
    desk.hold("shift")
    sitting.draw(ring(88, 48, -0.2 * math.pi, 0.2 * math.pi))
    desk.hold("shift", down=False)
    whole = told.another(shot="ring_redrawn")

    # A layer of the disc goes into the line, and comes back.
    desk.key("s")
    dock(sitting, "Disc", straight((0.5, 0.8), (0.5, 0.5)))
    told.another()
    dock(sitting, "Disc", straight((0.5, 0.5), (0.5, 0.8)))
    assert told.another() == whole, "the layer is not back where it was"

    # A part of the region by the lasso has layers of its own.
    sitting.click("check box", "Lasso")
    sitting.draw(ring(20, 14, middle=off(30, 10)))
    until(lambda: "Areas" in step(sitting, 0)["inputs"], "the lasso's area")
    told.states.append((1, sitting.shows(1)))
    sitting.draw(straight(off(30, 14), off(30, 22)))
    told.another(shot="shaded")
    assert "area 0" in step(sitting, 0)["values"]["Layers"]

    # The cross-section: a step of its own. Its plane is slid along the line, and a part of it drawn anew.
    desk.key("a")
    dock(sitting, "Profile", [(0.5 + 0.28 * math.cos(a), 0.5 - 0.3 * math.sin(a)) for a in [math.pi * (1 - i / 30) for i in range(31)]])
    told.another(steps=2)
    sitting.draw(straight(off(0, 15), off(22, 15)))
    told.another(steps=2)
    assert step(sitting, 1)["values"]["ProfileAt"] > 0.55
    dock(sitting, "Profile", straight((0.4, 0.3), (0.6, 0.3)))
    drawn = told.another(steps=2, shot="profile")

    # All undone to the start, and all redone.
    desk.move(sitting.view.left + 20, sitting.view.top + 20)
    told.undone_and_redone()
    assert sitting.shows(2) == drawn

    # Killed while a further stroke is on its way.
    dock(sitting, "Profile", straight((0.4, 0.3), (0.6, 0.3)), release=False)
    recover(sitting)
    assert sitting.shows(2) == drawn

    saved = tmp_path / "edits.oversketch"
    sitting.alone()
    save(sitting, saved)
    assert digest(replayed(saved, tmp_path / "replayed.vtp")) == drawn
