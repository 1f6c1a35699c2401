#!/usr/bin/python3
"""Makes the works, sessions of the window: Works/<name>.oversketch.

    OVERSKETCH_STUDIO=PROGRAM xvfb-run -s "-screen 0 1200x800x24 -noreset" dbus-run-session -- make_works.py [--only NAME] [--to FOLDER]

A hand drives oversketch-studio from nothing, by the events that a mouse and a keyboard send; what it sees is read from the screen and from what
the window tells a screen reader. Its actions are counted as Testing/Studio/TASKS.md does. The pictures that it draws over are painted by
works.py and drawings.py. Needs numpy, python3-vtk9, python3-xlib, python3-gi and gir1.2-atspi-2.0.
"""
import argparse
import os
import pathlib
import shutil
import sys
import tempfile
import time

import numpy as np
import vtk

HERE = pathlib.Path(__file__).resolve().parent
os.environ.setdefault("OVERSKETCH_SOURCE", str(HERE.parent))
os.environ.setdefault("OVERSKETCH_TEMPORARY", tempfile.gettempdir())
sys.path[:0] = [str(HERE), str(HERE.parent / "Testing" / "Studio")]
import reader  # noqa: E402
from desk import until  # noqa: E402
from drawings import DRAWINGS  # noqa: E402
from painting import circle, spline  # noqa: E402
from sheet import MARGIN, places_of  # noqa: E402
from sitting import DOG, Sitting  # noqa: E402
from works import EYE, PICTURES  # noqa: E402

BLUE, ORANGE, HANDLE = (77, 153, 255), (250, 158, 51), 5  # of a part's box: colours, half a handle's width [px]
RING_X, RING_Z = (219, 50, 47), (50, 110, 240)  # of a gizmo: colours
FRONT, RIGHT, TOP, BACK = "ctrl+1", "ctrl+2", "ctrl+3", "ctrl+4"


class Hand:
    def __init__(self, folder):
        self.folder, self.actions, self.shake = folder, 0, np.random.RandomState(7)
        self.sitting = Sitting(folder / "home")
        self.sitting.start(DOG)
        self.desk = self.sitting.desk
        self.sitting.shows(0)
        self.desk.focus(self.desk.windows()[-1][0])

    # What it does

    def key(self, keys):
        self.actions += 1
        self.desk.key(keys)
        self.rest()

    def click(self, at):
        self.actions += 1
        self.desk.click(*at)
        self.rest()

    def twice(self, at):
        self.actions += 1
        self.desk.click(*at)
        self.desk.click(*at)
        self.rest()

    def drag(self, path):
        """A line by a hand that trembles a little, pressed and let go of at its very ends."""
        self.actions += 1
        path = np.asarray(path, float)
        if len(path) == 2:
            path = path[0] + np.linspace(0.0, 1.0, 16)[:, None] * (path[1] - path[0])
        else:
            path[1:-1] += 0.5 * self.shake.standard_normal((len(path) - 2, 2))
        self.desk.drag([tuple(place) for place in path], pause=0.015)
        self.rest()

    def file(self, keys, path):
        self.actions += 3
        self.desk.key(keys)
        self.sitting.dialogue()
        time.sleep(0.3)  # for the folder to be read
        self.desk.key("ctrl+a")
        self.desk.type(str(path))
        self.desk.key("Return")
        self.sitting.alone()
        self.rest()

    def take(self, role, name):
        """A click on a thing of the window, by its name; on the uppermost one of that name."""
        found = until(lambda: [reader.Place(thing.get_extents(reader.Atspi.CoordType.SCREEN), 1) for its_role, its_name, thing in
                               reader.things(self.sitting.studio.process.pid) if (its_role, its_name) == (role, name)], f"{role} {name}")
        self.click(min(found, key=lambda place: place.top).middle)

    def type(self, role, name, text):
        """A field's value: a click into it, the text."""
        self.take(role, name)
        self.actions += 1
        self.desk.key("ctrl+a")
        self.desk.type(text)
        self.desk.key("Return")
        self.rest()

    def choose(self, name, row, rows):
        """Opens a choice by its value, takes another of its rows."""
        self.take("combo box", name)
        until(lambda: len(self.desk.windows()) > 1, "the choices")
        time.sleep(0.5)  # a click as quick as a double click would be the first one's
        shape = self.desk.windows()[-1][1]
        self.click((shape.x + shape.width // 3, shape.y + shape.height * (2 * row + 1) // (2 * rows)))

    def rest(self):
        """Until nothing is computed."""
        time.sleep(0.4)
        until(lambda: not reader.shown(self.sitting.studio.process.pid, "button", "Cancel"), "nothing is computed")
        time.sleep(0.3)

    # What it sees

    def turn_model(self, right, down):
        """Turns all of the model, seen from the front, by a drag of the middle button."""
        self.look(FRONT)
        self.actions += 1
        at = np.array(self.on_view(600, 640))
        self.desk.drag([tuple(at + t * np.array([right, down])) for t in np.linspace(0.0, 1.0, 16)], button=2)
        self.rest()

    def look(self, side):
        """All of the model from a side."""
        self.key(side)
        self.key("Home")
        time.sleep(0.5)

    def picture(self, name, over="ctrl+n"):
        """A picture to draw over."""
        painted = PICTURES[name]()[0] if name in PICTURES else DRAWINGS[name]().picture
        folder = self.folder / ".pictures"  # hidden: no list of its files pops up over the dialogue
        folder.mkdir(exist_ok=True)
        writer = vtk.vtkPNGWriter()
        writer.SetFileName(str(folder / f"{name}.png"))
        writer.SetInputData(painted.image())
        writer.Write()
        self.size = np.array([painted.width, painted.height])
        self.file(over, folder / f"{name}.png")
        self.pad = until(lambda: self.sitting.place("filler", "Picture"), "the picture")

    def on_pad(self, places):
        """Where places of the picture are, which fits its view."""
        pixel = MARGIN * max(self.size / (self.pad.width, self.pad.height))
        away = (np.asarray(places, float) - 0.5 * self.size) / pixel
        return np.array([self.pad.left + 0.5 * self.pad.width, self.pad.top + 0.5 * self.pad.height]) + away * [1, -1]

    def trace(self, name):
        """The lines of a shipped drawing, drawn by hand."""
        for line in DRAWINGS[name]().lines:
            self.drag(self.on_pad(np.vstack([line.course[::4], line.course[:2] if line.closed else line.course[-1:]])))

    def on_view(self, x, y):
        view = self.sitting.place("filler", "Model")
        return view.left + x, view.top + y

    def on_body(self, places, scale, side=FRONT):
        """Where places of a dragon's picture are on its body, all of which is seen, from the front or the back; the scale [px in a view that
        is 728 px wide] is greater where the body is nearer to the eye."""
        view = self.sitting.place("filler", "Model")
        away = scale * view.width / 728 * (np.asarray(places, float) - (416, 365)) * [1 if side == FRONT else -1, -1]
        return np.array([view.left + 0.5 * view.width, view.top + 0.5 * view.height]) + away

    def step(self):
        """The last one."""
        return until(self.sitting.session, "a result")["steps"][-1]

    def takes_effect(self, act):
        """Until the last step is another one, or has changed: what comes while the window computes may do nothing."""
        before = self.step()
        for _ in range(3):
            act()
            end = time.time() + 10.0
            while time.time() < end:
                if self.step() != before:
                    return self.rest()
                time.sleep(0.2)
        raise TimeoutError("nothing changes")

    def handles(self):
        """Of a part's box: its lower left and upper right corner and the depth's handle."""
        def both():
            box, depth = (places_of(self.sitting, "Model", colour) for colour in (BLUE, ORANGE))
            return (box, depth) if len(box) > 100 and len(depth) > 40 else None
        box, depth = until(both, "the handles")
        low, high = box.min(axis=0) + HANDLE, box.max(axis=0) - HANDLE
        return np.array([low[0], high[1]]), np.array([high[0], low[1]]), depth.mean(axis=0)

    def place(self, left, low, width, depth):
        """Puts the part that was drawn last elsewhere, by its box."""
        root, corner, _ = self.handles()
        box = self.step()["part"]["box"]
        pixel = (corner - root)[0] / (box[2] - box[0])
        if abs(width / (box[2] - box[0]) - 1.0) > 0.02:
            self.takes_effect(lambda: self.drag([corner, root + (corner - root) * width / (box[2] - box[0])]))
            root, corner, _ = self.handles()
        box = self.step()["part"]["box"]
        middle = 0.5 * (root + corner)
        self.takes_effect(lambda: self.drag([middle, middle + pixel * np.array([left - box[0], box[1] - low])]))
        self.look(TOP)
        root, corner, handle = self.handles()
        box = self.step()["part"]["box"]
        pixel = (corner - root)[0] / (box[2] - box[0])
        self.drag([handle, handle + (0, pixel * (depth - self.step()["part"]["depth"]))])
        self.look(FRONT)

    def turn(self, degrees, colour=RING_X):
        """Drags the ring that faces the eye from its lower right on, counter-clockwise."""
        ring = places_of(self.sitting, "Model", colour)
        low, high = ring.min(axis=0), ring.max(axis=0)
        angle = np.radians(np.linspace(-40.0, degrees - 40.0, 20))
        self.drag(0.5 * (low + high) + 0.5 * (high - low - 3) * np.column_stack([np.cos(angle), -np.sin(angle)]))

    def twin(self, at):
        """A twin of what is there, on the other side of the picture's plane."""
        self.takes_effect(lambda: self.twice(at))
        self.take("list item", self.step()["name"])
        self.choose("x", 2, 3)
        self.type("spin button", "Mirror at", "0")


def lines(hand, radius, height, *courses):
    """Lines of that radius and height."""
    hand.type("spin button", "Radius", str(radius))
    hand.type("spin button", "Height", str(height))
    for course in courses:
        hand.drag(course)
        hand.key("Return")  # what is set next is the next line's


def face(hand):
    """An eye's rim, raised, and a nostril, carved, on a dragon's left and on its right."""
    rim = spline(circle(EYE, (31, 32), 14), closed=True, steps=3)
    nostril = spline([(86, 522), (92, 526), (99, 523)], steps=4)
    hand.key("b")
    hand.look(FRONT)
    lines(hand, 16, 5, hand.on_body(rim, 0.77))
    hand.look(BACK)
    hand.drag(hand.on_body(rim, 0.77, BACK))
    hand.key("Return")
    hand.choose("Raise", 1, 2)
    lines(hand, 9, 4, hand.on_body(nostril, 0.75, BACK))
    hand.look(FRONT)
    hand.drag(hand.on_body(nostril, 0.75))


def dragon(hand):
    hand.picture("dragon")
    hand.click(hand.on_pad((400, 250)))
    face(hand)
    # A longer flame at the tail's tip, and the tail swung aside.
    hand.key("d")
    hand.drag(hand.on_body(spline([(716, 318), (707, 350), (716, 392), (744, 434), (770, 392), (774, 350), (764, 318)], steps=6), 0.737))
    hand.key("6")
    hand.look(TOP)
    middle = 0.5 * hand.sitting.place("filler", "Model").height
    hand.drag([hand.on_view(x, middle) for x in np.linspace(451, 606, 20)])
    hand.drag([hand.on_view(x, middle + y) for x, y in spline([(451, 0), (508, 4), (559, 24), (592, 60)], steps=6)])
    hand.key("Return")
    hand.look(FRONT)
    for name, inside, place in (("legs", ((170, 250), (420, 280)), (190, 10, 432, 58)), ("wing", ((300, 300),), (285, 290, 380, 100)),
                                ("horn", ((90, 120),), (225, 560, 110, 26))):
        hand.picture(name, "ctrl+shift+p")
        for at in inside:
            hand.click(hand.on_pad(at))
        if name == "wing":  # a thin one
            slider = hand.sitting.place("slider", "Height")
            hand.drag([(slider.left + 0.22 * slider.width, slider.middle[1]), (slider.left + 0.05 * slider.width, slider.middle[1])])
            hand.type("spin button", "Levels", "2")
        hand.place(*place)
    # The wing stands off; wing, legs and horn come twice.
    hand.key("7")
    hand.click(hand.on_view(375, 250))
    hand.look(RIGHT)
    hand.turn(34)
    hand.look(FRONT)
    for at in ((400, 250), (286, 422), (258, 160)):
        hand.twin(hand.on_view(*at))


def gnome(hand):
    hand.picture("figure_body")
    hand.trace("figure_body")
    for name, place in (("figure_head", (64, 370, 512, 70)), ("hair", (64, 370, 512, 24)), ("figure_hat", (64, 740, 512, 58))):
        hand.picture(name, "ctrl+shift+p")
        if name == "hair":
            hand.click(hand.on_pad((256, 380)))
        else:
            hand.trace(name)
        hand.place(*place)
    # The hat sits aslant.
    hand.key("7")
    hand.click(hand.on_view(360, 110))
    hand.turn(-9, RING_Z)
    # Nose and moustache stand out.
    hand.key("b")
    on_view = lambda *places: np.array([hand.on_view(*place) for place in places])
    lines(hand, 46, 26, on_view(*((x, 290) for x in np.linspace(364, 380, 12))))
    lines(hand, 24, 8, *(on_view(*spline([(372 + s * x, y) for x, y in ((18, 314), (36, 324), (55, 323), (66, 315))])) for s in (-1, 1)))
    # One body, to be printed.
    hand.take("button", "Join")
    hand.type("spin button", "Seam", "13")


def shell(hand):
    hand.picture("slab")
    hand.click(hand.on_pad((384, 384)))
    slider = hand.sitting.place("slider", "Extruded by")
    hand.drag([(slider.left + 7, slider.middle[1]), (slider.left + 17, slider.middle[1])])
    # The shell's body: a line and a ring round it, and the section between drawn anew.
    hand.key("a")
    hand.look(FRONT)
    on = lambda places: np.array([hand.on_view(373 + 0.753 * (x - 384), 352.5 - 0.753 * (y - 384)) for x, y in places])
    half = [(384, 566), (484, 552), (570, 500), (620, 416), (616, 340), (560, 276), (478, 222), (384, 190)]
    ring = spline(half + [(768 - x, y) for x, y in half[-2:0:-1]], closed=True, steps=5)
    hand.drag(on(spline([(384, 500), (384, 400), (384, 260)])))
    hand.drag(on(np.vstack([ring, ring[:1]])))
    dock = hand.sitting.place("filler", "Profile")
    t = np.linspace(0.0, 1.0, 30)
    hand.drag(np.column_stack([dock.left + 108 + 128 * t, dock.top + 63.5 - 18 * np.sin(np.pi * t) ** 0.75]))
    hand.key("Return")
    # Ribs from the hinge, the two ears beside it, a frame with a stud in each corner; growth lines carved.
    hand.key("b")
    hinge, ribs = np.array([384, 214]), []
    for angle in np.radians((-57, -38, -19, 0, 19, 38, 57)):
        far = 318 - 100 * np.sin(angle) ** 2
        ribs.append(on([hinge + k * np.array([np.sin(angle), np.cos(angle)]) for k in np.linspace(112, far, 12)]))
    lines(hand, 26, 10, *ribs)
    studs = [on([(384 + s * 276 + x, 384 + t * 276) for x in np.linspace(-11, 11, 16)]) for s in (-1, 1) for t in (-1, 1)]
    lines(hand, 26, 12, *(on(spline([(384 + s * 40, 158), (384 + s * 76, 152), (384 + s * 112, 162)])) for s in (-1, 1)), *studs)
    hand.choose("Raise", 1, 2)
    sides = [((152, 108), (616, 108)), ((660, 152), (660, 616)), ((616, 660), (152, 660)), ((108, 616), (108, 152))]
    lines(hand, 18, 8, *(on(np.linspace(*side, 24)) for side in sides))


WORKS = {"creature": dragon, "figure": gnome, "relief": shell}
SEEN = {"creature": (120, 36), "figure": (-90, 20), "relief": (70, 60)}  # how far each is turned as it is saved [px]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", choices=WORKS)
    parser.add_argument("--to", type=pathlib.Path, default=HERE / "Works")
    options = parser.parse_args()
    options.to.mkdir(exist_ok=True)
    for name in [options.only] if options.only else WORKS:
        with tempfile.TemporaryDirectory() as folder:
            hand = Hand(pathlib.Path(folder))
            WORKS[name](hand)
            hand.turn_model(*SEEN[name])
            saved = hand.folder / ".pictures" / f"{name}.oversketch"
            hand.file("ctrl+s", saved)
            until(saved.exists, "the file")
            shutil.copy(saved, options.to)
            print(name, hand.actions, "actions")
            hand.sitting.studio.kill()


if __name__ == "__main__":
    main()
