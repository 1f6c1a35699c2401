"""A screen reader at the desk: finds what the window shows by its role and name (AT-SPI), wherever fonts have put it. Needs a session bus
(dbus-run-session)."""
import time

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, GLib  # noqa: E402


class Place:
    """A rectangle on the screen [px]. Qt tells it in pixels as it counts them."""

    def __init__(self, extents, scale):
        self.left, self.top, self.width, self.height = (
            scale * value for value in (extents.x, extents.y, extents.width, extents.height))

    @property
    def middle(self):
        return self.left + self.width // 2, self.top + self.height // 2


def things(process):
    """All that is shown by a program: pairs of role and name, with their accessible."""
    desktop = Atspi.get_desktop(0)
    desktop.clear_cache()
    found = []
    for i in range(desktop.get_child_count()):
        program = desktop.get_child_at_index(i)
        if program and program.get_process_id() == process:
            walk(program, found)
    return found


def role_of(thing):
    """Its role; AT-SPI before 2.53 calls a button a push button."""
    name = thing.get_role_name()
    return "button" if name == "push button" else name


def walk(thing, found):
    for i in range(thing.get_child_count()):
        child = thing.get_child_at_index(i)
        if child is None:
            continue
        if child.get_state_set().contains(Atspi.StateType.SHOWING):
            found.append((role_of(child), child.get_name(), child))
            walk(child, found)


def shown(process, role, name):
    """Whether there is such a thing."""
    try:
        return any(thing[:2] == (role, name) for thing in things(process))
    except GLib.Error:  # something went away meanwhile
        return True


def find(process, role, name, scale=1, seconds=60):
    """The place of the one thing of that role and name."""
    end, seen = time.time() + seconds, []
    while time.time() < end:
        try:
            seen = things(process)
            hits = [thing for its_role, its_name, thing in seen if (its_role, its_name) == (role, name)]
            if len(hits) == 1:
                return Place(hits[0].get_extents(Atspi.CoordType.SCREEN), scale)
        except GLib.Error:  # it went away meanwhile
            pass
        time.sleep(0.1)
    raise TimeoutError(f"no {role} {name!r} among {sorted({pair[:2] for pair in seen})}")
