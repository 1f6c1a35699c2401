#!/usr/bin/env python3
"""How long a person at the Studio waits, measured inside it: from a sample of the pen to the painted frame, from the end of a stroke to the
deformed mesh on screen, beside a plain redraw.

usage: latency.py MODEL [MODEL...]     needs a display, a quiet machine, and in the environment OVERSKETCH_STUDIO, the program

Draws one arch over the top of each model, as it opens, ten times: over it, undone, over it again. Prints medians and 99th percentiles
[ms]. The first stroke counts as well.
"""
import json
import pathlib
import sys
import tempfile
import time

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from desk import Desk, Studio, until  # noqa: E402

LEFT, TOP, RIGHT, BOTTOM = 90, 70, 880, 760  # the model's part of the window


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


def measure(model, strokes=10):
    home = pathlib.Path(tempfile.mkdtemp())
    times = home / "latency.json"
    desk = Desk()
    studio = Studio(home, "--latency", times, model)
    autosave = lambda: [json.loads(f.read_text()) for f in home.glob("state/oversketch/autosave/*/session.json")]
    done = lambda count: until(lambda: any(len(d["strokes"]) == count and d["result_md5"] for d in autosave()), f"{count} strokes", 300)
    done(0)
    time.sleep(1.0)
    x, y = until(lambda: highest(desk), "the model on screen")
    for _ in range(strokes):
        desk.drag([(x + 3 * i, y + 20 - 45 * numpy.cos(0.08 * i)) for i in range(-15, 16)])
        done(1)
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
    missing = [model for model in sys.argv[1:] if not pathlib.Path(model).is_file()]
    if missing or len(sys.argv) < 2:
        print(f"latency.py: no file {missing[0]}" if missing else __doc__, file=sys.stderr)
        sys.exit(2)
    print("| model | pen sample to painted frame | stroke end to deformed mesh | plain redraw |")
    print("|---|---|---|---|")
    for model in sys.argv[1:]:
        times = measure(pathlib.Path(model).resolve())
        print(f"| {pathlib.Path(model).stem} | " + " | ".join(
            f"{numpy.median(times[what]):.1f} / {numpy.percentile(times[what], 99):.1f}" for what in ("sample", "stroke", "redraw")) + " |")


main()
