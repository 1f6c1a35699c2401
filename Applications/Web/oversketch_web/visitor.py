"""The process of one visitor: a session, a view of it, and messages from the page by a socket (front.Visitor)."""
import json
import os
import pathlib
import re
import resource
import select
import signal
import socket
import struct
import sys
import time

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGWriter

import oversketch

from . import strokes
from .view import View

models = (".ply", ".obj", ".off", ".stl", ".glb", ".gltf", ".vtp", ".oversketch")
pictures = (".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tif", ".tiff")
formats = ("ply", "obj", "glb", "stl", "off", "vtp", "3mf")
short = "There is not enough memory for that."
ahead = 2  # pictures that the page has not got yet, at most: one is on the way while the next one is made
still, rests = 0.15, 1.0  # s without a message, until the picture is made fine and the session is kept, or longer where that takes long
# The lines of each system's step, in the order in which they are drawn; a pose's course comes when its bone is seen.
lines = {"OneStroke": ["Stroke"], "Augment": ["Strokes"], "Relax": ["Strokes"], "Mask": ["Strokes"], "Pose": ["Bone", "Pose"],
         "Edit": ["Reference", "Boundary"]}
joint = 1 / 3  # of a bone's length: a line that begins so near to its joint is its course
hands = {f"{button}Button{what}Event" for button in ("Left", "Middle", "Right") for what in ("Press", "Release")} | {"MouseMoveEvent"}


class Refused(Exception):
    """Says to the visitor why something is not done."""


class Studio:
    """What a visitor does: a message of the page is a method's name with its arguments."""

    asked = {"hello", "bye", "ping", "size", "got", "hand", "zoom", "key", "look", "open", "canvas", "stroke", "drop", "select", "drag",
             "section", "profile", "change", "paper", "trace", "act", "sight", "cancel", "save", "export"}
    quiet = {"hello", "bye", "ping", "size", "got", "hand", "zoom", "profile"}  # leave what is said where it is

    def __init__(self, folder, shared, seconds, send):
        self.folder, self.shared, self.seconds, self.send = folder, shared, seconds, send
        self.files, self.kept = folder / "files", folder / "session.oversketch"
        self.files.mkdir(exist_ok=True)
        self.view, self.session = View(), oversketch.vtkOversketchSession()
        self.name, self.message, self.busy = "", "", False
        self.drawn = self.done = 0  # lines that have come, and of which the mesh is shown
        self.frame, self.shown, self.sharp, self.watched = 0, 0, False, False  # the last picture, and the last one that the page has
        self.moved = self.changed = self.began = 0.0
        self.rests = rests
        self.clear(None)

    def clear(self, picture):
        self.picture, self.pixels = picture, (0, 0)  # name of the file under the drawing, and its size, which the page knows
        self.selected, self.held = 0, []  # a step, and its lines on the model
        self.pending, self.of = [], None  # lines that wait for the next one, of a system and a step that is drawn anew
        self.before, self.mirrored = {}, set()  # meshes that edits were drawn on; steps that were drawn with a mirror
        self.fresh = True  # the next mesh is looked at anew
        self.after = ""  # a message that waits for what is being made

    # What the page asks for.

    def hello(self):
        self.watched = self.view.dirty = True
        self.shown = self.frame
        self.send(1, {"kind": "systems", "systems": json.loads(self.session.GetSystems()), "files": self.listed(), "formats": formats})
        self.tell() if self.name else self.restore()

    def bye(self):
        self.watched = False

    def ping(self):
        self.send(0, None)

    def size(self, width, height):
        self.view.resize(width, height)

    def got(self, frame):
        self.shown = max(self.shown, min(int(frame), self.frame))

    def hand(self, event, x, y, keys=()):
        if event in hands:
            self.view.hand(event, float(x), float(y), keys)
            self.moved = time.monotonic()

    def zoom(self, factor, x, y):
        self.view.style.ZoomAt(min(max(float(factor), 0.1), 10.0), *self.view.place(float(x), float(y)))
        self.view.dirty, self.moved = True, time.monotonic()

    def key(self, name, shift=False):
        if name in set("xyz123imjkrlhpnwc"):
            self.view.key(name, bool(shift))

    def look(self, side):
        self.view.look(side)

    def open(self, file=None, shared=None, name=""):
        """Opens a file that was sent or that the server offers; a picture becomes an empty drawing over it."""
        if shared is not None and shared not in self.listed():
            raise Refused(f"{shared} is not among the files here.")
        path = self.files / pathlib.PurePath(str(file)).name if shared is None else \
            self.shared / shared if self.shared.is_dir() else self.shared
        self.load(path, pathlib.PurePath(str(shared or name)).stem)
        if shared is None:
            path.unlink(missing_ok=True)

    def canvas(self, width, height):
        self.check(self.session.NewCanvas(*(min(max(float(length), 16.0), 8192.0) for length in (width, height))))
        self.begun("drawing", None)

    def stroke(self, number, system, points, values=None, mirror=None, redraw=0):
        """A line has been drawn: a step, one with others, or the new course of a bone."""
        self.drawn = max(self.drawn, int(number))
        if system not in lines or self.session.GetMesh() is None:
            raise Refused("There is no model to draw on." if system in lines else f"{system} is no system that takes lines.")
        line, chosen, again = strokes.stroke(points, self.view), self.step(self.selected), self.step(redraw)
        if system == "Pose" and not redraw and chosen is not None and chosen["system"] == "Pose" and self.isAtJoint(line):
            return self.replaced(chosen, {"Pose": line})
        names = lines[system][:1] if system == "Pose" else lines[system]
        if again is not None:
            system = again["system"]
            names = [name for name in lines.get(system, []) if strokes.isDrawn(self.session.GetStepInput(again["id"], name))]
        if self.of != (system, redraw):
            self.pending, self.of = [], (system, redraw)
        self.pending.append(line)
        if len(self.pending) < len(names):
            self.done = self.drawn
            self.held = [(names[0], places) for places in strokes.laid(line, self.session.GetMesh())]
            self.view.dirty = True
            return self.tell()
        inputs = dict(zip(names, self.pending))
        self.pending, self.of = [], None
        if again is not None:
            self.replaced(again, inputs)
        else:
            self.added(system, values or {}, inputs, mirror)

    def drop(self):
        """Escape: the line that waits for the next one goes; else the selected step is left."""
        self.select(self.selected if self.pending else 0)

    def select(self, id):
        """Shows the lines of a step on the model, to be taken hold of."""
        step, mesh = self.step(id), self.session.GetMesh()
        self.selected, self.pending, self.of, self.held = step["id"] if step else 0, [], None, []
        for name in lines.get(step["system"], []) if step and mesh is not None else []:
            line = self.source(step, name)
            if strokes.isDrawn(line):
                drags = re.findall(r"drag (\S+) ([^\s;]+)", step["values"].get("Operations", "")) if name == "Reference" else []
                by = numpy.array(drags, dtype=float).reshape(-1, 2).sum(axis=0)
                self.held += [(name, places) for places in strokes.laid(line, mesh, by)]
        self.view.dirty = True
        self.tell()

    def drag(self, number, start, end):
        """The line of the selected edit has been dragged."""
        self.drawn = max(self.drawn, int(number))
        step, places = self.edited()
        right, up = strokes.dragged(self.source(step, "Reference"), places[len(places) // 2], start, end, self.view)
        self.edit(step, "Profile" not in step["inputs"], {"Operations": f"drag {right:.3f} {up:.3f}"}, {})

    def section(self, number, points):
        """The cross-section of the selected edit has been drawn anew, in its own plane."""
        self.drawn = max(self.drawn, int(number))
        step, _ = self.edited()
        profile = oversketch.stroke(strokes.numbers(points, 2), self.view.camera, (2, 2))
        for name in strokes.views:
            profile.GetCellData().RemoveArray(name)
        self.edit(step, not step["values"].get("Operations"), {}, {"Profile": profile})

    def profile(self, id):
        """The cross-section of an edit, to be drawn anew."""
        edit = self.editor(self.step(id))
        if edit is not None and edit.Prepare():
            cut = edit.GetStep("Section")
            cut.Update()
            self.send(1, {"kind": "section", "id": id, "lines": [one[:, :2].round(4).tolist() for one in strokes.polylines(cut.GetOutput(0))]})

    def change(self, id, values):
        self.check(self.session.ChangeStep(int(id), json.dumps(values)))
        self.run()

    def paper(self, width, height):
        self.pixels = tuple(min(max(int(length), 1), 32768) for length in (width, height))
        self.tell()

    def trace(self, number, points, magnetic=True):
        """A line of the drawing; of one point, a click on what the picture shows."""
        self.drawn = max(self.drawn, int(number))
        step = self.drawing()
        if step is None:
            raise Refused("There is no drawing. Open a picture, or a new canvas.")
        if len(points) == 1:
            before, (x, y) = step["values"].get("Trace", ""), points[0][:2]
            place = f"{float(x) * self.pixels[0]:.1f},{(1.0 - float(y)) * self.pixels[1]:.1f}"
            return self.change(step["id"], {"Trace": f"{before} {place}".strip()})
        canvas = self.canvasOf(step)
        size = self.pixels if self.picture else [round(length) for length in canvas[2:]]
        self.check(self.session.AddStroke(step["id"], strokes.drawing(points, canvas, size, bool(magnetic and self.picture))))
        self.run()

    def act(self, what, arguments=()):
        """A method of the session that changes its steps."""
        if what not in ("Undo", "Redo", "SetStepOn", "RemoveStep"):
            raise Refused(f"{what} is nothing that can be asked for.")
        work = getattr(self.session, what)
        self.check(work(*arguments))
        if what.endswith("do") and any(step["id"] in self.mirrored and step["mirror"] is None for step in self.steps()):
            work()  # a step and its mirror are one
        self.run()

    def sight(self, id):
        """Looks from where a step was drawn."""
        step = self.step(id)
        for name in lines.get(step["system"], []) if step else []:
            if strokes.isDrawn(self.source(step, name)) and self.view.style.LookFrom(self.source(step, name)):
                break
        self.view.dirty = True

    def cancel(self):
        self.session.Cancel()
        self.done = self.drawn
        self.view.dirty = True
        self.tell()

    def save(self):
        self.session.SetLook(self.view.camera, *self.view.size)
        self.offer("oversketch", self.session.Save)

    def export(self, format):
        if format not in formats:
            raise Refused(f"{format} is no format of meshes; take one of {', '.join(formats)}.")
        self.offer(format, self.session.Export)

    # What these need.

    def listed(self):
        """Names of the files that the server offers."""
        found = self.shared.iterdir() if self.shared.is_dir() else [self.shared]
        return sorted(one.name for one in found if one.suffix.lower() in models + pictures and one.is_file())

    def check(self, worked):
        if not worked:
            why = self.session.GetMessage() or "That cannot be done."
            raise Refused(short if "bad_alloc" in why else why)
        return worked

    def steps(self):
        return json.loads(self.session.GetSteps() or "[]")

    def step(self, id):
        return next((step for step in self.steps() if step["id"] == id), None)

    def drawing(self):
        return next((step for step in self.steps() if step["system"] == "InflateDrawing"), None)

    def source(self, step, name):
        """The line of a step's input, or of the step whose line it takes on."""
        while step and "step" in step["inputs"].get(name, {}):
            step = self.step(step["inputs"][name]["step"])
        return self.session.GetStepInput(step["id"], name) if step else None

    def load(self, path, name):
        if path.suffix.lower() in pictures:
            self.check(self.session.NewDrawing(str(path)))
            kept = self.files / f"picture-{time.time_ns()}{path.suffix.lower()}"
            kept.write_bytes(path.read_bytes())
            self.begun(name, kept.name)
        else:
            self.check(self.session.Open(str(path)))
            self.begun(name, None)

    def begun(self, name, picture):
        """Another session is open."""
        for file in self.files.glob("picture-*"):
            if file.name != picture:
                file.unlink()
        self.name = name or "model"
        self.clear(picture)
        self.view.show([])
        self.run()

    def restore(self):
        """The session as it was kept, else what each visitor begins with. One whose opening ended the process is not tried again."""
        tried = self.kept.with_suffix(".tried.oversketch")
        if self.kept.exists():
            self.kept.rename(tried)
            try:
                picture = next((file.name for file in self.files.glob("picture-*")), None)
                self.check(self.session.Open(str(tried)))
                self.begun((self.folder / "name").read_text(), picture if self.drawing() else None)
                return tried.rename(self.kept)
            except (OSError, Refused):
                pass
        if not self.listed():
            raise Refused("There is nothing to begin with. Open a model, a session or a picture.")
        self.open(shared=self.listed()[0])

    def keep(self):
        """Writes the session where the next process finds it."""
        self.changed, began = 0.0, time.monotonic()
        new = self.folder / "new.oversketch"
        self.session.SetLook(self.view.camera, *self.view.size)
        if self.session.Save(str(new)):
            (self.folder / "name").write_text(self.name)
            new.rename(self.kept)
        self.rests = max(rests, 5.0 * (time.monotonic() - began))

    def offer(self, ending, write):
        """Writes a file for the browser to take."""
        for before in self.files.glob("given-*"):
            before.unlink()
        plain = re.sub(r"[^A-Za-z0-9_-]", "_", self.name)[:60]
        self.check(write(str(self.files / f"given-{plain}.{ending}")))
        self.message = self.session.GetMessage() or ""
        self.send(1, {"kind": "file", "file": f"given-{plain}.{ending}", "name": f"{plain}.{ending}"})

    def isAtJoint(self, line):
        bone = [places for name, places in self.held if name == "Bone"]
        if not bone:
            return False
        pixels = strokes.Eye(line).seen(bone[0])[:, :2]
        length = numpy.hypot(*numpy.diff(pixels, axis=0).T).sum()
        return numpy.hypot(*(numpy.array(line.GetPoint(0)[:2]) - pixels[0])) <= max(20.0, joint * length)

    def edited(self):
        step, places = self.step(self.selected), [places for name, places in self.held if name == "Reference"]
        if step is None or step["system"] != "Edit" or not places:
            raise Refused("Select an edit in the history, or draw a line and a ring round it.")
        return step, places[0]

    def edit(self, step, goesOn, values, inputs):
        """Changes an edit. A step has operations or a profile: the other one is a further step, where this one leaves line and ring."""
        if goesOn:
            before = step["values"].get("Operations", "")
            if before and values:
                values["Operations"] = f"{before}; {values['Operations']}"
            self.replaced(step, inputs, values)
        else:
            for port, name in enumerate(lines["Edit"]):
                self.session.SetInputStep(name, step["id"], port + 1)
            self.added("Edit", values, inputs)

    def editor(self, step):
        """The system of an edit that nothing is done by yet, on the mesh that it was drawn on; None where that is not known."""
        mesh = self.before.get(step["id"]) if step and step["system"] == "Edit" else None
        if mesh is None:
            return None
        edit, last = oversketch.vtkOversketchEdit(), step["inputs"]["Reference"].get("step")
        given = [self.source(step, name) for name in lines["Edit"]]
        if last:
            before = self.editor(self.step(last))
            if before is None:
                return None
            before.SetOperations(self.step(last)["values"].get("Operations", ""))
            before.Update()
            given = [before.GetReferenceOutput(), before.GetBoundaryOutput()]
        edit.SetInputData(mesh)
        edit.SetReferenceData(given[0])
        edit.SetBoundaryData(given[1])
        return edit

    def canvasOf(self, step):
        """Left, bottom, width and height of what is drawn on, in the world."""
        drawn = self.session.GetStepInput(step["id"], "Strokes")
        said = drawn.GetFieldData().GetArray("Canvas") if drawn is not None else None
        return vtk_to_numpy(said).ravel()[:4].tolist() if said is not None else [-0.5, -0.5, *map(float, self.pixels)]

    def replaced(self, step, inputs, values=None):
        for name, line in inputs.items():
            self.session.SetInput(name, line)
        self.check(self.session.ChangeStep(step["id"], json.dumps(values or {})))
        self.selected = step["id"]
        self.run()

    def added(self, system, values, inputs, mirror=None):
        mesh = self.session.GetMesh()
        for name, line in inputs.items():
            self.session.SetInput(name, line)
        self.selected = self.check(self.session.AddStep(system, json.dumps(values)))
        self.before[self.selected] = mesh if system == "Edit" else None
        if mirror in (0, 1, 2):
            low, high = mesh.GetBounds()[2 * mirror:2 * mirror + 2]
            middle = 0.5 * (low + high)  # as in the window: models are made about the origin
            self.mirrored.add(self.selected)
            self.check(self.session.SetMirror(self.selected, mirror, middle if abs(middle) > 0.1 * (high - low) else 0.0))
        self.run()

    def run(self):
        """Begins to make the model as the steps are by now."""
        self.began = self.changed = time.monotonic()
        self.session.Start()
        self.tell()

    def came(self):
        """A result has come."""
        pieces = [(self.session.GetPieceMesh(k), self.session.GetPiecePicture(k)) for k in range(self.session.GetNumberOfPieces())]
        self.view.show(pieces)
        if self.fresh and any(mesh.GetNumberOfPoints() for mesh, _ in pieces):
            self.fresh = False
            if not self.session.GetLook(self.view.camera):
                self.view.look("front")
            self.view.style.SaveFirstView()
        step = self.drawing()
        if step is not None and "Picture" in step["inputs"] and self.picture is None and pieces and pieces[0][1]:
            self.picture, writer = f"picture-{time.time_ns()}.png", vtkPNGWriter()  # of a session that was opened
            writer.SetFileName(str(self.files / self.picture))
            writer.SetInputData(pieces[0][1])
            writer.Write()
        self.done, self.moved = self.drawn, time.monotonic()  # the first picture of it may be a coarse one
        self.select(self.selected)

    def tell(self):
        """What the page shows beside the picture."""
        step, drawing, self.busy = self.drawing(), None, self.session.IsRunning()
        if step is not None:
            canvas, drawn = self.canvasOf(step), self.session.GetStepInput(step["id"], "Strokes")
            drawing = {"id": step["id"], "picture": self.picture, "canvas": canvas,
                       "lines": strokes.drawn(drawn, canvas) if strokes.isDrawn(drawn) and canvas[2] else []}
        self.send(1, {"kind": "state", "name": self.name, "steps": self.steps(), "selected": self.selected,
                      "undo": self.session.GetCanUndo(), "redo": self.session.GetCanRedo(), "busy": self.busy,
                      "stage": self.session.GetStage() or "", "message": self.message, "waits": self.of[0] if self.pending else "",
                      "drawing": drawing})

    def show(self):
        """Sends a picture, with what of the selected step lies on it."""
        moves = time.monotonic() - self.moved < still
        picture, eye, held = self.view.picture(moves), strokes.Eye.of(self.view), {}
        for name, places in self.held:
            pixels = (eye.seen(places)[:, :2] * [1.0, -1.0] + [0.0, self.view.size[1]]) / self.view.share
            held.setdefault(name, []).append(pixels.round(1).tolist())
        self.frame, self.sharp = self.frame + 1, not moves
        self.send(2, {"frame": self.frame, "done": self.done, "model": not self.fresh, "held": held}, picture)

    def hear(self, message):
        """Does what a message asks for, or says why not."""
        try:
            said = json.loads(message, parse_constant=int, parse_float=lambda text: max(-1e9, min(1e9, float(text))))  # no NaN
            work = said.pop("do")
            if work not in self.asked:
                raise Refused(f"{work} is nothing that can be asked for.")
            if work in ("save", "export") and self.session.IsRunning():
                self.after = message
                return
            self.message = self.message if work in self.quiet else ""
            getattr(self, work)(**said)
        except ConnectionError:
            raise
        except Exception as error:  # whatever a page may send
            self.message = str(error) or short
            self.done, self.view.dirty = self.drawn, True
            self.tell()

    def tick(self):
        """Does what needs no message. Returns how long nothing will be to do [s], None for ever."""
        now, running = time.monotonic(), self.session.IsRunning()
        if self.session.Poll():
            self.came()
        elif running and now - self.began > self.seconds:
            self.message = f"That took longer than {self.seconds} seconds, the most here, and is given up."
            self.cancel()
        if running and now - self.began > self.seconds + 2 * rests:
            os._exit(1)  # what cannot be given up, such as work that has found no memory
        if self.busy and not self.session.IsRunning():
            self.tell()  # it has been given up
        if self.after and not running:
            message, self.after = self.after, ""
            self.hear(message)
        if self.watched and self.frame - self.shown < ahead and (self.view.dirty or not self.sharp and now - self.moved >= still):
            self.show()
        if self.changed and not running and now - max(self.changed, self.moved) > self.rests:
            self.keep()
        return 0.008 if running else still if self.watched and not self.sharp else self.rests if self.changed else None


def main():
    number, folder, shared, memory, seconds = sys.argv[1:]
    resource.setrlimit(resource.RLIMIT_DATA, (int(memory) << 20,) * 2)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    line, heard = socket.socket(fileno=int(number)), b""
    signal.signal(signal.SIGTERM, lambda *_: line.shutdown(socket.SHUT_RD))

    def send(kind, said, picture=b""):
        text = b"" if said is None else json.dumps(said).encode()
        payload = struct.pack(">I", len(text)) + text + picture if kind == 2 else text
        line.sendall(struct.pack(">IB", len(payload), kind) + payload)

    studio = Studio(pathlib.Path(folder), pathlib.Path(shared), int(seconds), send)
    try:
        while True:
            if select.select([line], [], [], studio.tick())[0]:
                part = line.recv(1 << 20)
                if not part:
                    break
                heard += part
            while len(heard) >= 4 and len(heard) >= 4 + (length := struct.unpack_from(">I", heard)[0]):
                message, heard = heard[4:4 + length], heard[4 + length:]
                studio.hear(message)
    except ConnectionError:
        pass
    if studio.changed:
        studio.keep()
    os._exit(0)  # without the driver's leisurely end


if __name__ == "__main__":
    main()
