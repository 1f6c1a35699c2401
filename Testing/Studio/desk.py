"""A person at the screen: real X events (XTEST) for mouse and keys, pictures of the screen, drag and drop from another window."""
import os
import signal
import subprocess
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from Xlib import X, XK, Xatom, display, protocol
from Xlib.ext import xtest


class Desk:
    def __init__(self):
        self.display = display.Display()
        self.root = self.display.screen().root
        self.at = (0, 0)

    # Mouse

    def move(self, x, y):
        xtest.fake_input(self.display, X.MotionNotify, x=int(round(x)), y=int(round(y)))
        self.display.sync()
        self.at = (x, y)

    def press(self, button=1):
        xtest.fake_input(self.display, X.ButtonPress, button)
        self.display.sync()

    def release(self, button=1):
        xtest.fake_input(self.display, X.ButtonRelease, button)
        self.display.sync()

    def click(self, x, y, button=1):
        self.move(x, y)
        time.sleep(0.05)
        self.press(button)
        self.release(button)

    def drag(self, path, button=1, pause=0.01, release=True):
        self.move(*path[0])
        self.press(button)
        for point in path[1:]:
            time.sleep(pause)
            self.move(*point)
        if release:
            self.release(button)

    # Keys: "ctrl+shift+z", "Return", "a"

    def codes(self, keys):
        names = {"ctrl": "Control_L", "shift": "Shift_L", "alt": "Alt_L"}
        return [self.display.keysym_to_keycode(XK.string_to_keysym(names.get(k, k))) for k in keys.split("+")]

    def hold(self, keys, down=True):
        for code in self.codes(keys):
            xtest.fake_input(self.display, X.KeyPress if down else X.KeyRelease, code)
        self.display.sync()

    def key(self, keys):
        codes = self.codes(keys)
        for code in codes:
            xtest.fake_input(self.display, X.KeyPress, code)
        for code in reversed(codes):
            xtest.fake_input(self.display, X.KeyRelease, code)
        self.display.sync()

    def type(self, text):
        named = {"/": "slash", ".": "period", "-": "minus", "_": "underscore", " ": "space"}
        for character in text:
            shifted = character.isupper() or character == "_"
            name = named.get(character, character)
            self.key(("shift+" if shifted else "") + (name.lower() if character.isupper() else name))
            time.sleep(0.005)

    # Windows

    def windows(self):
        """Mapped top windows with their size, the topmost last."""
        found = []
        for window in self.root.query_tree().children:
            try:
                attributes, shape = window.get_attributes(), window.get_geometry()
            except Exception:  # gone meanwhile
                continue
            if attributes.map_state == X.IsViewable and shape.width > 20:
                found.append((window, shape))
        return found

    def focus(self, window):
        window.set_input_focus(X.RevertToPointerRoot, X.CurrentTime)
        self.display.sync()

    def picture(self, left=0, top=0, width=None, height=None):
        shape = self.root.get_geometry()
        width, height = width or shape.width, height or shape.height
        data = self.root.get_image(left, top, width, height, X.ZPixmap, 0xFFFFFFFF).data
        pixels = numpy.frombuffer(data, dtype=numpy.uint8).reshape(height, width, 4)[::-1, :, 2::-1]
        image = vtkImageData()
        image.SetDimensions(width, height, 1)
        array = numpy_to_vtk(numpy.ascontiguousarray(pixels).reshape(-1, 3), deep=True)
        array.SetName("PNGImage")
        image.GetPointData().SetScalars(array)
        return image

    # Drag and drop of files, as a file manager does it (XDND 5).

    def drop(self, path, x, y):
        atom = self.display.intern_atom
        source = self.root.create_window(0, 0, 10, 10, 0, self.display.screen().root_depth, event_mask=X.PropertyChangeMask)
        source.map()
        uris = ("file://" + str(path) + "\r\n").encode()
        selection, uri_list = atom("XdndSelection"), atom("text/uri-list")
        source.set_selection_owner(selection, X.CurrentTime)
        source.change_property(atom("XdndTypeList"), Xatom.ATOM, 32, [uri_list])
        self.move(x, y)
        target = self.aware(x, y)
        send = lambda name, words: (target.send_event(protocol.event.ClientMessage(
            window=target, client_type=atom(name), data=(32, words)), event_mask=0), self.display.sync())
        send("XdndEnter", [source.id, 5 << 24, uri_list, 0, 0])
        send("XdndPosition", [source.id, 0, (int(x) << 16) | int(y), X.CurrentTime, atom("XdndActionCopy")])
        dropped, end = False, time.time() + 10
        while time.time() < end:
            if not self.display.pending_events():
                time.sleep(0.02)
                continue
            event = self.display.next_event()
            if event.type == X.SelectionRequest:
                event.requestor.change_property(event.property, event.target, 8, uris)
                event.requestor.send_event(protocol.event.SelectionNotify(
                    time=event.time, requestor=event.requestor, selection=event.selection, target=event.target,
                    property=event.property))
                self.display.sync()
            elif event.type == X.ClientMessage and event.client_type == atom("XdndStatus") and not dropped:
                assert event.data[1][1] & 1, "the window does not take the file"
                send("XdndDrop", [source.id, 0, X.CurrentTime, 0, 0])
                dropped = True
            elif event.type == X.ClientMessage and event.client_type == atom("XdndFinished"):
                source.destroy()
                self.display.sync()
                return
        raise TimeoutError("the drop was not taken")

    def aware(self, x, y):
        """The window under a place that takes drops."""
        atom = self.display.intern_atom("XdndAware")
        window, found = self.root, None
        while window:
            if window.get_full_property(atom, X.AnyPropertyType):
                found = window
            window = window.query_pointer().child or None
        assert found, "no window takes drops there"
        return found


class Studio:
    """The program, with a home of its own."""

    def __init__(self, home, *arguments, scale=1):
        (home / "run").mkdir(parents=True, exist_ok=True, mode=0o700)
        environment = dict(os.environ, HOME=str(home), XDG_STATE_HOME=str(home / "state"), XDG_CONFIG_HOME=str(home / "config"),
                           XDG_RUNTIME_DIR=str(home / "run"), OVERSKETCH_OPENCL="off", LC_ALL="C.UTF-8", QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1",
                           QT_SCALE_FACTOR=str(scale))
        self.log = open(home / "log.txt", "ab")
        self.process = subprocess.Popen([os.environ["OVERSKETCH_STUDIO"], *map(str, arguments)], env=environment,
                                        stdout=self.log, stderr=self.log)

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()

    def ended(self, seconds=20):
        return self.process.wait(timeout=seconds)


def until(condition, what, seconds=60):
    end = time.time() + seconds
    while time.time() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.05)
    raise TimeoutError(what)
