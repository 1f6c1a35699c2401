"""A drawing over a picture in the Studio, by real mouse and keys: a picture is dropped, an outline drawn by the magnetic pen, a part of it
anew, a hole made, all undone and redone, the model turned, a fin of it pulled, the outline changed once more, all undone and redone, all saved, the program killed amid a line:
what it shows is what the command makes, bit for bit."""
import os
import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(SOURCE / "Testing" / "Studio"), str(SOURCE / "Testing" / "Pictures")]
from desk import until  # noqa: E402
from sheet import Sheet, euler, pixels, places_of, recover, replayed, ring, save, undone_and_redone  # noqa: E402
from sitting import digest, mesh, sitting  # noqa: E402, F401

# What lines are on the pad, by their colours (vtkOversketchDrawingRepresentation).
BOUNDARY, OPEN_FEATURE, UNJUDGED = (217, 26, 26), (20, 145, 60), (20, 20, 20)


def lowest_fin(sitting):
    """Where the shown model is lowest on the screen: its colours are stronger than those behind it."""
    view, seen = pixels(sitting, "Model")
    rows, columns = numpy.nonzero(seen.max(axis=2) - seen.min(axis=2) > 60)
    return view.left + int(numpy.median(columns[rows == rows.max()])), view.top + int(rows.max())


def test_a_picture_becomes_a_model_and_outlives_a_crash(sitting, tmp_path):
    desk, fish = sitting.desk, Sheet(sitting, "fish")
    fish.open()
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
    undone_and_redone(sitting, 1, [whole, filled, hole, tunnel, anew])

    # The middle button turns the model and the right one pans it: no vertex moves, and w looks as at first.
    desk.key("d")
    until(lambda: sitting.place("filler", "Model"), "the model's view")
    facing = pixels(sitting, "Model")[1]
    looks = lambda: abs(pixels(sitting, "Model")[1] - facing).max(axis=2)
    at = sitting.place("filler", "Model").middle
    for button in (2, 3):
        desk.drag([(at[0] + 4 * t, at[1] + 2 * t) for t in range(15)], button=button)
        until(lambda: (looks() > 40).mean() > 0.01, "another view")
        assert sitting.shows(1) == anew
        desk.move(*at)
        desk.key("w")
        until(lambda: (looks() > 40).mean() < 0.001, "the view as at first")

    # A stroke over the outline pulls a fin of the model; a part of the drawing drawn anew then, and the fin follows.
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

    # All undone to the first line once more and redone, over both steps.
    undone_and_redone(sitting, [1, 1, 1, 1, 1, 2, 2], [whole, filled, hole, tunnel, anew, pulled, both])
    assert digest(replayed(sitting.autosave(), tmp_path / "redone.vtp")) == both

    # Killed amid a line: what was drawn before comes back.
    sitting.alone()
    desk.drag(fish.on_screen(ring(*(middle + [150, 0]), 20))[:20], release=False)
    recover(sitting)
    assert sitting.shows(2) == both
    sitting.shot("fish_after_a_crash")
    assert digest(replayed(sitting.autosave(), tmp_path / "recovered.vtp")) == both

    sitting.alone()
    saved = tmp_path / "fish.oversketch"
    save(sitting, saved)
    assert digest(replayed(saved, tmp_path / "saved.vtp")) == both


def test_lines_bound_together_cross_and_span(sitting, tmp_path):
    """An outline of two lines, each past the other's ends, and lines across all of it: nothing, until they may cross."""
    desk, fish = sitting.desk, Sheet(sitting, "fish")
    fish.open()
    desk.key("F4")  # lines stay where they are drawn
    x, y = 0.5 * fish.size
    along = lambda begin, end: numpy.array([(x + 300 * numpy.cos(a), y + 160 * numpy.sin(a)) for a in numpy.linspace(begin, end, 40)])
    fish.draw(along(-0.02, numpy.pi + 0.03))
    fish.draw(along(numpy.pi - 0.02, 2 * numpy.pi + 0.03))
    roles = lambda: {name: len(places_of(sitting, "Picture", colour)) for name, colour in
                     (("boundary", BOUNDARY), ("open feature", OPEN_FEATURE), ("unjudged", UNJUDGED))}
    until(lambda: roles()["unjudged"] > 300 and roles()["boundary"] == 0, "both are of no use")
    quads = sitting.place("check box", "Quads").middle
    for _ in range(2):  # the form is longer than its place
        desk.click(*quads, button=5)
    sitting.click("check box", "Strokes may cross")
    outline = sitting.shows(1)
    until(lambda: roles()["boundary"] > 300, "they are one outline")
    made = replayed(sitting.autosave(), tmp_path / "outline.vtp")
    assert digest(made) == outline and euler(made) == 2
    assert numpy.allclose(made.GetBounds()[:4], (x - 300, x + 300, y - 160, y + 160), atol=6.0)

    # One line from rim to rim and beyond, another one over it: four regions of one closed body.
    fish.draw([(x - 30 + 3 * t, y + 166 - 16.6 * t) for t in range(21)])
    halves = sitting.shows(1, other_than=outline)
    fish.draw([(x - 306 + 30.6 * t, y - 20 + 2 * t) for t in range(21)])
    quarters = sitting.shows(1, other_than=halves)
    until(lambda: roles()["open feature"] > 300 and roles()["boundary"] > 300, "lines inside are features")
    sitting.shot("lines_that_cross")
    made = replayed(sitting.autosave(), tmp_path / "quarters.vtp")
    assert digest(made) == quarters and euler(made) == 2
    assert len(numpy.unique(vtk_to_numpy(made.GetCellData().GetArray("RegionId")))) == 4
    assert len(numpy.unique(vtk_to_numpy(made.GetCellData().GetArray("ObjectId")))) == 1
    # What the pad shows is what the model has: all that is red lies on its rim, nothing green beyond it.
    on_pad = lambda colour: places_of(sitting, "Picture", colour)
    middle = numpy.array(fish.on_screen([(x, y)])[0])
    scale = numpy.array(fish.on_screen([(x + 1, y + 1)])[0]) - middle
    round_it = lambda colour: numpy.hypot(*((on_pad(colour) - middle) / scale / (300, 160)).T)
    assert abs(round_it(BOUNDARY) - 1.0).max() < 0.05
    assert round_it(OPEN_FEATURE).max() < 1.03

    # No longer allowed, the last good model stays and every line that meets another one is of no use.
    undone_and_redone(sitting, 1, [outline, halves, quarters])
    sitting.click("check box", "Strokes may cross")
    until(lambda: roles()["boundary"] == 0 and roles()["unjudged"] > 300, "they are of no use again")
    desk.key("ctrl+z")
    assert sitting.shows(1) == quarters
    until(lambda: roles()["boundary"] > 300, "they may cross again")
