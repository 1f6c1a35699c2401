#!/usr/bin/env python3
"""How long a person at the Studio waits, measured inside it: from a sample of the pen to the painted frame, from the end of a stroke or a
notch of the wheel to the new mesh on screen, beside a plain redraw.

usage: latency.py [--line] MODEL [MODEL...]     needs a display, a quiet machine, and in the environment OVERSKETCH_STUDIO, the program

Draws one arch over the top of each model, as it opens, ten times: over it, undone, over it again; with --line, a line on the middle of it
with the tool for that, and then gives its height 20 notches of the wheel, and its radius 20. Prints medians and 99th percentiles [ms], and
medians of the time that processors worked for it meanwhile, all threads together. The first stroke counts as well.
"""
import json
import pathlib
import sys
import tempfile
import time

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from desk import Desk, Studio, until  # noqa: E402

LEFT, TOP, RIGHT, BOTTOM = 90, 150, 825, 760  # the model's part of the window, below the strip and the axes over the view


def highest(desk):
    """The topmost pixel of the model on screen, which is brighter than what is behind it; None while there is none."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    picture = desk.picture(LEFT, TOP, RIGHT - LEFT, BOTTOM - TOP)
    pixels = vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(BOTTOM - TOP, RIGHT - LEFT, 3)[::-1].max(axis=2)
    rows = numpy.flatnonzero((pixels > 110).sum(axis=1) > 3)
    if not len(rows):
        return None
    y = rows[0]
    return LEFT + int(numpy.flatnonzero(pixels[y + 2] > 110).mean()), TOP + int(y)


def middle(desk):
    """A place on the model, well inside of what is seen of it."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    picture = desk.picture(LEFT, TOP, RIGHT - LEFT, BOTTOM - TOP)
    pixels = vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(BOTTOM - TOP, RIGHT - LEFT, 3)[::-1].max(axis=2)
    inside = pixels > 110
    if inside.sum() < 100:
        return None
    while inside.any():  # what is left last is farthest from the outline
        left, inside = inside, inside[1:-1, 1:-1] & inside[:-2, 1:-1] & inside[2:, 1:-1] & inside[1:-1, :-2] & inside[1:-1, 2:]
        inside = numpy.pad(inside, 1)
    y, x = numpy.argwhere(left)[0]
    return LEFT + int(x), TOP + int(y)


def notches(desk, key, count=20):
    desk.hold(key)
    for i in range(count):
        desk.press(4 if i % 4 < 2 else 5)
        desk.release(4 if i % 4 < 2 else 5)
        time.sleep(0.6)
    desk.hold(key, False)


def measure(model, line=False, strokes=10):
    home = pathlib.Path(tempfile.mkdtemp())
    times = home / "latency.json"
    desk = Desk()
    studio = Studio(home, "--latency", times, model)
    autosave = lambda: [json.loads(f.read_text()) for f in home.glob("state/oversketch/autosave/*/session.json")]
    done = lambda count: until(lambda: any(len(d.get("steps", d.get("strokes", []))) == count and d["result_md5"] for d in autosave()), f"{count} strokes", 300)
    done(0)
    time.sleep(1.0)
    x, y = until(lambda: (middle if line else highest)(desk), "the model on screen")
    if line:
        desk.focus(desk.windows()[-1][0])
        desk.key("b")
        time.sleep(1.0)
    for i in range(strokes):
        if line:
            desk.drag([(x + 3 * i, y + 6 * numpy.sin(0.2 * i)) for i in range(-15, 16)])
        else:
            desk.drag([(x + 3 * i, y + 20 - 45 * numpy.cos(0.08 * i)) for i in range(-15, 16)])
        done(1)
        if line and i == strokes - 1:
            time.sleep(0.5)
            notches(desk, "shift")
            notches(desk, "ctrl")
            break
        time.sleep(0.3)
        desk.key("ctrl+z")
        done(0)
        time.sleep(0.3)
    desk.key("ctrl+q")
    time.sleep(1.0)
    if studio.process.poll() is None:  # it asks whether to save
        desk.focus(desk.windows()[-1][0])
        desk.key("Tab")
        desk.key("space")
    studio.ended(30)
    return json.loads(times.read_text())


def main():
    line = "--line" in sys.argv[1:]
    models = [model for model in sys.argv[1:] if model != "--line"]
    missing = [model for model in models if not pathlib.Path(model).is_file()]
    if missing or not models:
        print(f"latency.py: no file {missing[0]}" if missing else __doc__, file=sys.stderr)
        sys.exit(2)
    columns = ["sample", "stroke", *(["radius", "height"] if line else []), "redraw"]
    titles = {"sample": "pen sample to painted frame", "stroke": "stroke end to new mesh", "radius": "notch of the radius to new mesh",
              "height": "of the height", "redraw": "plain redraw"}
    print("| model | " + " | ".join(titles[what] for what in columns) + " |")
    print("|---" * (1 + len(columns)) + "|")
    for model in models:
        times = {what: numpy.array(list(zip(*waited))) for what, waited in measure(pathlib.Path(model).resolve(), line).items()}
        print(f"| {pathlib.Path(model).stem} | " + " | ".join(
            f"{numpy.median(times[what][0]):.1f} / {numpy.percentile(times[what][0], 99):.1f}, {numpy.median(times[what][1]):.1f}"
            for what in columns) + " |")


if __name__ == "__main__":
    main()
