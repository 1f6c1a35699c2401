"""Edits in the Studio by real mouse and keys: a line and a ring, a drag, a layer, a profile; the program is killed, and what it shows
after it is what it showed before, and what the command makes of the saved session, bit for bit."""
import math
import os
import pathlib
import sys

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(SOURCE / "Testing" / "Studio"), str(SOURCE / "Testing" / "Pictures")]
from desk import until  # noqa: E402
from sitting import DOG, digest, mesh, sitting  # noqa: E402, F401
from test_lines import command  # noqa: E402

MIDDLE = (400, 340)  # of the dog's flank, as it opens
LINE = [(MIDDLE[0] - 35 + 2 * i, MIDDLE[1]) for i in range(36)]


def ring(wide, high, begin=0.0, end=2.0 * math.pi, middle=MIDDLE, count=60):
    angles = [begin + (end - begin) * i / count for i in range(count + 1)]
    return [(middle[0] + wide * math.cos(a), middle[1] + high * math.sin(a)) for a in angles]


def straight(begin, end, count=15):
    return [(begin[0] + (end[0] - begin[0]) * i / count, begin[1] + (end[1] - begin[1]) * i / count) for i in range(count + 1)]


def dock(sitting, name, path, **more):
    """Drags over a dock's picture, by shares of its sides."""
    picture = sitting.place("filler", name)
    sitting.desk.drag([(picture.left + x * picture.width, picture.top + y * picture.height) for x, y in path], **more)


def test_an_edit_outlives_a_kill(sitting, tmp_path):
    desk = sitting.desk
    sitting.start(DOG)
    bare = sitting.shows(0)
    sitting.fit()
    sitting.alone()
    desk.key("e")
    sitting.draw(LINE)
    sitting.draw(ring(75, 42))
    assert sitting.shows(1) == bare, "a region alone moves something"
    sitting.draw(straight(MIDDLE, (MIDDLE[0], MIDDLE[1] - 25)))
    pulled = sitting.shows(1, other_than=bare)
    sitting.shot("edit_pulled")
    desk.key("s")
    dock(sitting, "Disc", straight((0.5, 0.8), (0.5, 0.6)))
    shaded = sitting.shows(1, other_than=pulled)
    sitting.shot("edit_shaded")
    desk.key("a")
    dock(sitting, "Profile", [(0.5 + 0.28 * math.cos(a), 0.5 - 0.3 * math.sin(a)) for a in [math.pi * (1 - i / 30) for i in range(31)]])
    drawn = sitting.shows(2, other_than=shaded)
    sitting.shot("edit_profile")
    desk.move(sitting.view.left + 20, sitting.view.top + 20)
    desk.key("ctrl+z")
    assert sitting.shows(1, other_than=drawn) == shaded
    desk.key("ctrl+y")
    assert sitting.shows(2, other_than=shaded) == drawn

    # Killed while a further stroke is on its way.
    dock(sitting, "Profile", straight((0.4, 0.3), (0.6, 0.3)), release=False)
    sitting.studio.kill()
    desk.release()
    sitting.start()
    sitting.dialogue()
    desk.key("Return")
    assert sitting.shows(2) == drawn

    saved, replayed = tmp_path / "edits.oversketch", tmp_path / "replayed.vtp"
    sitting.alone()
    desk.key("ctrl+s")
    sitting.dialogue()
    desk.key("ctrl+a")
    desk.type(str(saved))
    desk.key("Return")
    until(saved.exists, "the file")
    assert "not bit for bit" not in command("replay", saved, "-o", replayed).stderr
    assert digest(mesh(replayed)) == drawn
