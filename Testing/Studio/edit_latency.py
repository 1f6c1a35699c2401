#!/usr/bin/env python3
"""How long a person at the Studio waits at an edit, measured inside it: from a drag's event to the painted frame, for the line and for a
layer, and from the ring's release to the grey model, beside a plain redraw of the same model.

usage: edit_latency.py MODEL RADIUS [RINGS [PACE]]     needs a display, and in the environment OVERSKETCH_STUDIO, the program

Draws a line on the middle of the model, as it opens, and a ring of that radius [px] round it with the tool Shade, RINGS times (5), undone
between; then drags a layer and, with the tool Direct edit, the line, and turns the model. Prints how many vertices the ring holds, medians
and 99th percentiles [ms], and medians of the time that processors worked for it meanwhile, all threads together: of the whole, of its part
until points and normals are there (of a ring, greys: after that the step is made once more for the history, on a thread of its own, while
the frame is painted), and of drawing and painting the frame alone, which a plain redraw takes as well. The hand has an event each PACE
seconds (0.15): with less than 0.2 no frame is one after a rest, which draws edges smoothed; a busy machine needs more for a frame an event.
"""
import json
import pathlib
import sys
import tempfile
import time

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from desk import Desk, Studio, until  # noqa: E402
from latency import middle  # noqa: E402

EVENTS = 40
ROWS = {"drag": "drag of the line", "layer": "drag of a layer", "ring": "ring's release to the grey model", "redraw": "plain redraw"}


def sway(desk, x, y, width, pace, button=1):
    """Drags there and back upward from a place."""
    desk.drag([(x, y - width * numpy.sin(numpy.pi * i / EVENTS)) for i in range(EVENTS + 1)], button=button, pause=pace)


def layer_over(desk, x, y, radius):
    """The place right over another, on the model, where greys meet."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    picture = desk.picture(x - 3, y - radius, 7, radius)
    greys = vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(radius, 7, 3)[::-1].astype(float).mean(axis=(1, 2))
    inner = slice(radius // 6, radius - radius // 3)  # neither ring nor line
    return y - radius + inner.start + 2 + int(numpy.abs(greys[4:] - greys[:-4])[inner].argmax())


def measure(model, radius, rings, pace):
    home = pathlib.Path(tempfile.mkdtemp())
    times = home / "latency.json"
    desk = Desk()
    studio = Studio(home, "--latency", times, model)
    autosave = lambda: [json.loads(f.read_text()) for f in home.glob("state/oversketch/autosave/*/session.json")]
    done = lambda count: until(lambda: any(len(d.get("steps", [])) == count and d["result_md5"] for d in autosave()), f"{count} steps", 300)
    until(autosave, "the session", 300)
    time.sleep(2.0)
    x, y = until(lambda: middle(desk), "the model on screen")
    desk.focus(desk.windows()[-1][0])
    desk.key("s")
    time.sleep(1.0)
    round_it = numpy.linspace(0.0, 2.0 * numpy.pi, 61)
    for i in range(rings):
        if i > 0:
            desk.key("ctrl+z")
            desk.key("ctrl+z")
            time.sleep(2.0)
        desk.drag([(x + 0.3 * radius * s, y) for s in numpy.linspace(-1.0, 1.0, 31)])
        time.sleep(1.5)
        desk.drag([(x + radius * numpy.cos(a), y + radius * numpy.sin(a)) for a in round_it])
        done(1)
        time.sleep(3.0)
    sway(desk, x, layer_over(desk, x, y, radius), 0.2 * radius, pace)
    time.sleep(3.0)
    desk.key("e")
    time.sleep(2.0)
    sway(desk, x, y, 0.4 * radius, pace)
    time.sleep(4.0)
    sway(desk, x, y, 40.0, pace, button=2)
    time.sleep(1.0)
    desk.key("ctrl+q")
    until(lambda: len(desk.windows()) > 1, "the question whether to save")
    time.sleep(1.0)
    desk.focus(desk.windows()[-1][0])
    desk.key("Tab")
    desk.key("space")
    studio.ended(120)
    return json.loads(times.read_text())


def main():
    if len(sys.argv) not in (3, 4, 5) or not pathlib.Path(sys.argv[1]).is_file():
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    rings, pace = int(sys.argv[3]) if len(sys.argv) > 3 else 5, float(sys.argv[4]) if len(sys.argv) > 4 else 0.15
    waited = measure(pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2]), rings, pace)

    def figures(what):
        if what not in waited:
            return "–"
        wall, processors = numpy.array(waited[what]).T
        return f"{numpy.median(wall):.1f} / {numpy.percentile(wall, 99):.1f}, {numpy.median(processors):.1f}"
    print(f"{waited.get('region', 0):,} vertices within the ring")
    print("| | times | whole | until points and normals | frame |")
    print("|---|---|---|---|---|")
    for what, title in ROWS.items():
        print(f"| {title} | {len(waited.get(what, []))} | {figures(what)} | {figures(what + ' points')} | {figures(what + ' frame')} |")
    missing = [title for what, title in ROWS.items() if len(waited.get(what, [])) < (1 if what == "ring" else EVENTS // 2)]
    sys.exit(f"edit_latency.py: too few times of: {', '.join(missing)}" if missing else 0)


if __name__ == "__main__":
    main()
