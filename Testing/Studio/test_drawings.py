"""A drawing over a picture in the Studio, by real mouse and keys: a picture is dropped, an outline drawn by the magnetic pen, a part of it
anew, a hole made, all undone and redone, a fin of the model pulled, the outline changed once more, all saved, the program killed amid a line:
what it shows is what the command makes, bit for bit."""
import os
import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(SOURCE / "Testing" / "Studio"), str(SOURCE / "Testing" / "Pictures")]
from desk import until  # noqa: E402
from sheet import Sheet, euler, replayed, ring  # noqa: E402
from sitting import DOG, digest, mesh, sitting  # noqa: E402, F401

def lowest_fin(sitting):
    """Where the shown model is lowest on the screen: its colours are stronger than those behind it."""
    view = sitting.place("filler", "Model")
    picture = sitting.desk.picture(view.left, view.top, view.width, view.height)
    pixels = vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(view.height, view.width, 3)[::-1].astype(int)
    rows, columns = numpy.nonzero(pixels.max(axis=2) - pixels.min(axis=2) > 60)
    return view.left + int(numpy.median(columns[rows == rows.max()])), view.top + int(rows.max())


def test_a_picture_becomes_a_model_and_outlives_a_crash(sitting, tmp_path):
    desk, fish = sitting.desk, Sheet(sitting, "fish")
    sitting.start(DOG)
    sitting.shows(0)
    sitting.fit()
    sitting.alone()
    desk.key("g")
    desk.drop(fish.picture, sitting.view.left + 300, sitting.view.top + 300)
    until(lambda: (sitting.session() or sitting.autosave()) and sitting.place("filler", "Picture"), "the picture")
    sitting.alone()

    fish.draw(fish.outline())
    whole = sitting.shows(1)
    sitting.shot("drawn_fish")
    solid = replayed(sitting.autosave(), tmp_path / "whole.vtp")
    assert digest(solid) == whole and euler(solid) == 2
    assert solid.GetPointData().GetTCoords() is not None

    # A ring in its middle, by a pen that keeps to no edge, is filled; a click makes it a hole, another one a tunnel.
    desk.key("F4")
    middle = fish.outline().mean(axis=0) + [40, 0]
    fish.draw(ring(*middle, 45))
    filled = sitting.shows(1, other_than=whole)
    desk.click(*fish.on_screen([middle])[0])
    hole = sitting.shows(1, other_than=filled)
    assert euler(replayed(sitting.autosave(), tmp_path / "hole.vtp")) == 0
    desk.click(*fish.on_screen([middle])[0])
    tunnel = sitting.shows(1, other_than=hole)
    assert euler(replayed(sitting.autosave(), tmp_path / "tunnel.vtp")) == 0
    sitting.shot("fish_with_a_tunnel")

    # A part of the outline is drawn anew with Shift: a bump on the side where the shipped line is lowest.
    line = fish.outline()
    low = int(line[:, 1].argmin())
    part = numpy.array([line[(low + k) % (len(line) - 1)] for k in range(-8, 9)])
    part[:, 1] -= 25.0 * numpy.sin(numpy.linspace(0.0, numpy.pi, len(part)))
    desk.hold("shift")
    fish.draw(part)
    desk.hold("shift", down=False)
    anew = sitting.shows(1, other_than=tunnel)

    # A line in the void makes nothing, and the model stays.
    fish.draw([(20, 620), (60, 622), (90, 618)])
    desk.key("ctrl+z")
    assert sitting.shows(1) == anew

    # Undone to the first line and redone.
    for digest_before, now in ((anew, tunnel), (tunnel, hole), (hole, filled), (filled, whole)):
        desk.key("ctrl+z")
        assert sitting.shows(1, other_than=digest_before) == now
    for digest_before, now in ((whole, filled), (filled, hole), (hole, tunnel), (tunnel, anew)):
        desk.key("ctrl+y")
        assert sitting.shows(1, other_than=digest_before) == now

    # A stroke over the outline pulls a fin of the model; a part of the drawing drawn anew then, and the fin follows.
    desk.key("d")
    until(lambda: sitting.place("filler", "Model"), "the model's view")
    sitting.shot("fish_before_the_pull")
    x, y = lowest_fin(sitting)
    desk.drag([(x + 22 * t, y - 28 + 55 * (1 - t * t)) for t in numpy.linspace(-1.0, 1.0, 41)])
    pulled = sitting.shows(2)
    assert [step["system"] for step in sitting.session()["steps"]] == ["InflateDrawing", "OneStroke"]
    longer = replayed(sitting.autosave(), tmp_path / "pulled.vtp")
    assert digest(longer) == pulled and euler(longer) == 0 and longer.GetPointData().GetTCoords() is not None
    assert longer.GetBounds()[2] < mesh(tmp_path / "tunnel.vtp").GetBounds()[2] - 5.0  # the fin is lower
    sitting.shot("fish_with_a_longer_fin")
    desk.key("g")
    high = int(line[:, 1].argmax())
    part = numpy.array([line[(high + k) % (len(line) - 1)] for k in range(-8, 9)])
    part[:, 1] += 15.0 * numpy.sin(numpy.linspace(0.0, numpy.pi, len(part)))
    until(lambda: sitting.place("filler", "Picture"), "the picture's view")
    desk.hold("shift")
    fish.draw(part)
    desk.hold("shift", down=False)
    both = sitting.shows(2, other_than=pulled)
    assert digest(replayed(sitting.autosave(), tmp_path / "both.vtp")) == both

    saved = tmp_path / "fish.oversketch"
    desk.key("ctrl+s")
    sitting.dialogue()
    desk.key("ctrl+a")
    desk.type(str(saved))
    desk.key("Return")
    until(saved.exists, "the file")
    assert digest(replayed(saved, tmp_path / "saved.vtp")) == both

    # Killed amid a line: what was drawn before comes back.
    sitting.alone()
    desk.drag(fish.on_screen(ring(*(middle + [150, 0]), 20))[:20], release=False)
    sitting.studio.kill()
    desk.release()
    sitting.start()
    sitting.dialogue()
    desk.key("Return")
    assert sitting.shows(2) == both
    sitting.shot("fish_after_a_crash")
    assert digest(replayed(sitting.autosave(), tmp_path / "recovered.vtp")) == both
