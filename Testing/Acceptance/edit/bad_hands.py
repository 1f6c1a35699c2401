"""Lines and rings of a bad hand: those of rings.py over all models in two cameras, beside the mark, turned, too short, too long, shaky,
backwards, half beside the model and in the void. Each becomes a sound mesh, of which only what the ring encloses has changed, or is
refused in one message.

    PYTHONPATH=build/release/lib/python3/dist-packages /usr/bin/python3 Testing/Acceptance/edit/bad_hands.py FOLDER
        [--only PART-OF-NAME ...] [--modes HAND,...] [--workers 2] [--limit SECONDS] [--no-pictures] [--continue]

Entries and FOLDER are as of accept.py, with a column for each hand. Exit code 0 when all bounds hold in every case.
"""
import json
import sys
import tempfile
import time
import zlib
from pathlib import Path

import numpy as np

sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parent)]
import accept  # noqa: E402
import edit_judge  # noqa: E402
import frame  # noqa: E402
import meshes  # noqa: E402
import picture  # noqa: E402
import rings  # noqa: E402  also finds what follows
import hands  # noqa: E402
import stroke_files  # noqa: E402

CAMERAS = (1, 4)  # one orthographic, one in perspective
SECONDS = 60.0  # in which an answer is there
DRAG = 0.25  # half widths that the line is moved by
FOLDS = 0.02  # of the region's edges


# ---------------------------------------------------------------------------------------------------- the hands

def ends_of(share, random):
    """A share of a length at the end, at both, or at the start."""
    first = random.choice([0.0, 0.5, 1.0])
    return share * first, share * (1 - first)


def beyond(depth, line):
    """From the line's middle away from that of the model to where the picture has nothing of it, or to the picture's edge."""
    size = np.array(depth.shape[::-1])
    rows, columns = np.nonzero(np.isfinite(depth))
    way = line.mean(0) - (columns.mean(), rows.mean())
    way = way / np.linalg.norm(way) if np.linalg.norm(way) > 1.0 else np.array([1.0, 0.0])
    for length in np.arange(0.0, size.sum(), 2.0):
        column, row = (line.mean(0) + length * way).astype(int)
        if not (0 <= column < size[0] and 0 <= row < size[1]) or not np.isfinite(depth[row, column]):
            return length * way
    return np.zeros(2)


def shifted(line, _ring, _depth, amount, random):
    angle = random.uniform(0, 2 * np.pi)
    return hands.shifted(line, hands.SHIFT * amount * np.array([np.cos(angle), np.sin(angle)]))


def moved(by):
    """Line and ring moved together."""
    return lambda stroke, line, depth, *_: hands.shifted(stroke, by(line, depth))


def corner(line, depth):
    """To the picture's nearest corner."""
    size = np.array(depth.shape[::-1], float)
    return np.where(line.mean(0) > size / 2, size, 0.0) - line.mean(0)


# How each draws a stroke, line or ring: (stroke, line, depth of the picture, share of its worst, random) -> stroke.
HANDS = {
    "as drawn": lambda stroke, *_: stroke,
    "beside": shifted,
    "turned": lambda stroke, _l, _d, amount, random: hands.turned(stroke, hands.TURN * amount * random.choice([-1, 1])),
    "too short": lambda stroke, _l, _d, amount, random: hands.trimmed(stroke, *ends_of(hands.SHARE * amount, random)),
    "too long": lambda stroke, _l, _d, amount, random: hands.run_on(stroke, *ends_of(hands.SHARE * amount, random)),
    "shaky": lambda stroke, _l, _d, amount, random: hands.wobbled(stroke, hands.WOBBLE * amount, random),
    "backwards": lambda stroke, *_: stroke[::-1],
    "half in the void": moved(lambda line, depth: beyond(depth, line)),
    "in the void": moved(corner),
}


def by(hand, name, line, ring, depth):
    """Line and ring as a hand draws them; name and hand decide how badly."""
    random = np.random.default_rng(zlib.crc32(f"{name}/{hand}".encode()))
    return [HANDS[hand](stroke, line, depth, random.uniform(0.3, 1.0), random) for stroke in (line, ring)]


# ----------------------------------------------------------------------------------------------------- the runs

def make(folder):
    names = [f"{name}-h0-c{camera}" for name, _, _ in rings.models() for camera in CAMERAS]
    return rings.make_all(folder, names)


def folded(case):
    """How many edges of the region are folded, that were not."""
    mesh, patch = case.enclosed("dragged")
    now, rest = (edit_judge.bends(*shape) for shape in ((mesh.points, patch.faces), (case.rest.points, case.patch.faces)))
    return max(0, int((now > 120).sum()) - int((rest > 120).sum()))


def one(mesh, drawn, folder):
    """What became of a line and a ring, the messages last; pictures are made of the folder's files."""
    strokes_of = {name: stroke[0] for name, stroke in drawn.items()}
    editor, start = accept.Editor(mesh, strokes_of["reference"], strokes_of["boundary"], "default", folder), time.perf_counter()
    result = {"fails": [], "asks": ["told", "in time"]}
    try:
        half = accept.put_rest(editor, mesh, strokes_of)
        for name, new_triangles in (("off", False), ("dragged", True)):
            editor.run(f"move 0.5 n {DRAG * half!r}", new_triangles)
            editor.put(name, curves=new_triangles)
    except accept.Refused:
        refusals = [message for message in editor.messages if not message.startswith("Warning")]
        result["fails"] += ["told"] * (len(refusals) != 1)
    result["seconds"] = time.perf_counter() - start
    if result["seconds"] > SECONDS:
        result["fails"].append("in time")
    if (folder / "dragged.vtp").is_file():
        (folder / "run.json").write_text(json.dumps({"mode": "default", "kind": "line"}))
        case = edit_judge.Case(folder)
        edit_judge.soundness(case, result)
        edit_judge.region(case, result)
        edit_judge.dragged(case, result)
        result["folded"] = folded(case)
        result["far"] = edit_judge.far(case, "dragged")
        wrong = {"sound": result["sound"] or result["curves"], "region": result["region"] or result["disc"] != 1, "far": result["far"],
                 "folds": result["folds"] > FOLDS}
        result["asks"] += list(wrong)
        result["fails"] += [name for name, why in wrong.items() if why]
    return {**result, "holds": not result["fails"], "messages": editor.messages}


def run(stroke_file, mesh_file, modes, _backend, pictures, case):
    """{hand: result} of one line and ring; writes pictures into a folder where one is given."""
    entry = Path(stroke_file).with_suffix("")
    mesh = meshes.read(mesh_file)
    (_, line, view, _), (_, ring, _, _) = (stroke_files.read(f"{entry}-{case}-{what}.vtp") for what in ("line", "ring"))
    depth, _ = picture.depths(view, *meshes.weld(*meshes.arrays(mesh))[:2])
    results = {}
    for hand in modes:
        samples = by(hand, f"{entry.name} {case}", line, ring, depth)
        drawn = {name: (stroke_files.polydata(stroke, view), stroke, view) for name, stroke in zip(("reference", "boundary"), samples)}
        with tempfile.TemporaryDirectory() as folder:
            results[hand] = result = one(mesh, drawn, Path(folder))
            if pictures:
                image = accept.show(Path(folder), drawn) if (Path(folder) / "region.vtp").is_file() else accept.blank(mesh, drawn)
        if pictures:
            picture.write_text(image, f"{entry.name} {case} {hand}: " + "; ".join(result["messages"])[-150:], 8, 8, 20)
            if result["fails"]:
                picture.write_text(image, "FAILS " + ", ".join(result["fails"]), 8, 34, 20, picture.RED)
            picture.save(image, Path(pictures) / f"{entry.name} {case}-{hand}.png")
    return results


BAD_HANDS = frame.Run(
    script=__file__,
    title="Lines and rings of a bad hand",
    units=f"Each hand draws both badly: up to {hands.SHIFT:.0f} px beside the mark, each its own way, turned by up to {hands.TURN:.0f} "
          f"degrees, up to {hands.SHARE:.0%} too short or too long, shaky by up to {hands.WOBBLE:.0f} px, backwards; moved together until "
          "the line's middle is beside the model, or into the picture's corner. Then the line is moved by a quarter of a half width.",
    modes={hand: hand for hand in HANDS},
    usual=tuple(HANDS),
    counting=tuple(HANDS),
    bounds={
        "told": "a result, or one message why there is none", "in time": f"in {SECONDS:.0f} s",
        "sound": "mesh and curves sound, Euler number as before",
        "region": "the region is a disc, what the ring encloses, and nothing else moved",
        "far": "beyond the ring and two edges bit-identical", "folds": f"drag by a quarter of a half width: folds ≤ {FOLDS:.0%} of edges",
    },
    columns=("patch", "folded", "angle", "seconds"),
    make=make,
    one=run,
    enough=lambda results: all(result["holds"] for result in results.values()),
    sheet=(1, 6),
)

if __name__ == "__main__":
    sys.exit(frame.main(BAD_HANDS, __doc__))
