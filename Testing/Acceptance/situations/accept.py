"""The acceptance of situations that hands and files from outside brought: strokes over thin horns, limbs welded by one line, sections deeper
than the limb, outlines drawn anew round tips, drawings that overshoot, terrains with samples missing. Each runs through the command; the file
that it writes is judged, and what it says.

    OVERSKETCH_COMMAND=build/release/bin/oversketch PYTHONPATH=build/release/lib/python3/dist-packages /usr/bin/python3
        Testing/Acceptance/situations/accept.py FOLDER [--only PART-OF-NAME ...] [--workers 2] [--limit SECONDS] [--no-pictures]

A result is as meant where it does what was drawn, or was refused in words that name a remedy; a wreck passes through itself, shows its back,
or is torn. FOLDER receives table.md, results.json, pictures and contact sheets. Exit code 0 when no wreck comes without a word and nine of
ten results are as meant.
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]
import frame  # noqa: E402
import judge as surface  # noqa: E402
import meshes  # noqa: E402
import picture  # noqa: E402
import situations  # noqa: E402
import stroke_files  # noqa: E402
import through  # noqa: E402

CROSSING, INSIDE_OUT = 10, 0.002  # edges that newly pass through faces; share of what is seen that newly shows its back
STRAY = 0.02  # of what changed, seen beside the ring by more than BESIDE px
BESIDE = 12.0
SUMMIT_SLOPE, NOTCH, EVEN = 0.4, 3.0, 18.0  # slope 40 px from a blob's summit, px, median of the least angles in degrees
KEPT = 0.97  # of the triangles of a terrain with samples missing
REMEDY = re.compile(r"\b(draw|drag|set|give|take|turn|pull|use|begin|end|choose|make|move|leave)\b", re.IGNORECASE)


def run(stroke_file, mesh_file, modes, backend, pictures):
    """Runs one situation and returns {mode: result}; writes a picture into a folder where one is given."""
    case_file = Path(stroke_file).with_suffix(".json")
    case, folder = json.loads(case_file.read_text()), case_file.parent
    with tempfile.TemporaryDirectory() as made:
        out = Path(made) / "out.ply"
        inputs = [mesh_file if word == "MESH" else str(folder / word) for word in case["inputs"]]
        options = [str(folder / word[1:]) if word.startswith("@") else word for word in case.get("options", [])]
        command = [os.environ["OVERSKETCH_COMMAND"], case["verb"], *inputs, "-o", str(out), *options]
        start = time.perf_counter()
        done = subprocess.run(command, capture_output=True, text=True, env=environment(backend))
        said = " ".join(line for line in done.stderr.splitlines() if line.strip())
        result = {"seconds": time.perf_counter() - start, "messages": [said] if said else [], "said": bool(said), "fails": []}
        if done.returncode < 0 or done.returncode > 2:
            result["fails"].append("crash")
        elif not out.is_file():
            result["refused"] = True
            if not REMEDY.search(said):
                result["fails"].append("no remedy")
            if not case.get("may refuse", True):
                result["fails"].append("refused")
        else:
            judge(case, folder, mesh_file, out, said, result)
        if pictures:
            show(case, folder, mesh_file, out, result, Path(pictures) / f"{case_file.stem}-{modes[0]}.png")
    result["fails"] += [f"says {text}" for text in case.get("must not say", []) if text in said]
    result["holds"] = not result["fails"]
    return {mode: result for mode in modes}


def environment(backend):
    return dict(os.environ, **({"OVERSKETCH_OPENCL": "off"} if backend == "host" else {}))


# ------------------------------------------------------------------------------------------------------- the judge

def judge(case, folder, mesh_file, out, said, result):
    """Whether what was made is a wreck, and whether it is as meant."""
    points, triangles, _ = meshes.weld(*meshes.arrays(meshes.read(out)))
    before = meshes.weld(*meshes.arrays(meshes.read(mesh_file)))[:2] if mesh_file else None
    changed = ~meshes.among(points[triangles].reshape(-1, 9), before[0][before[1]].reshape(-1, 9)) if before else np.ones(len(triangles), bool)
    result["crossing"] = through.crossing_edges(points, triangles, changed)
    borders, crowded, fans = surface.topology(triangles)
    was = surface.topology(before[1]) if before else (borders if case["verb"] == "terrain" else 0, 0, 0)
    if before and result["crossing"]:
        lost = ~meshes.among(before[0][before[1]].reshape(-1, 9), points[triangles].reshape(-1, 9))
        result["crossing"] = max(0, result["crossing"] - through.crossing_edges(*before, lost))
    wrecks = [name for name, bad in (("passes through itself", result["crossing"] > CROSSING), ("torn", borders > was[0]),
                                     ("crowded", crowded + fans > was[1] + was[2])) if bad]
    if "stroke" in case:
        _, samples, view, _ = stroke_files.read(folder / case["stroke"])
    else:
        name = next((word[1:] for word in case.get("options", []) if word.startswith("@")), case["inputs"][-1])
        view = stroke_files.read(folder / name)[2] if before else None
    if before:
        result["inside out"] = surface.back_share(view, points, triangles) - surface.back_share(view, *before)
        wrecks += ["inside out"] * (result["inside out"] > INSIDE_OUT)
    result["wreck"] = wrecks
    result["fails"] += wrecks + (["silent wreck"] if wrecks and not said else [])
    for name in ("near", "follows"):
        if name in case:
            result["worst"] = surface.outline_distances(view, points, triangles, samples)[1 if name == "near" else 0]
            result["fails"] += [name] * (result["worst"] > case[name] and not said) + [f"{name}, said"] * (result["worst"] > case[name] and bool(said))
    if "left_over" in case:
        result["left over"] = left_over(case, view, points, triangles, samples)
        result["fails"] += ["left over"] * (result["left over"] > case["left_over"])
    if "sharp" in case:
        result["sharp"] = sharp_length(points, triangles) / sharp_length(*before)
        result["fails"] += ["sharp"] * (result["sharp"] < 1.0)
    if "ring" in case:
        result["stray"] = stray(case, folder, view, before, points)
        result["fails"] += ["stray"] * (result["stray"] > STRAY)
    drawn(case, points, triangles, result)
    if "triangles" in case:
        result["kept"] = len(triangles) / case["triangles"]
        result["fails"] += ["kept"] * (result["kept"] < KEPT and not said)
    result["fails"] += ["not said"] * ("must say" in case and case["must say"] not in said)


def left_over(case, view, points, triangles, samples):
    """The share of a limb that is still seen beside the outline that was drawn for it."""
    limb = picture.inside_polygon(np.array(case["section"]))
    covered = picture.layers(view.display(points)[0], triangles) > 0
    grown = picture.inside_polygon(samples)
    for turn in ((2, 0), (-2, 0), (0, 2), (0, -2)):
        grown |= picture.inside_polygon(samples + turn)
    return float((limb & covered & ~grown).sum() / limb.sum())


def sharp_length(points, triangles, degrees=60.0):
    angle, ends = surface.turns(points, triangles)
    length = np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)
    return float(length[angle > degrees].sum())


def stray(case, folder, view, before, points):
    """Of the points that moved the share that lay beside the ring in its picture."""
    _, ring, _, _ = stroke_files.read(folder / case["ring"])
    gone = ~meshes.among(before[0], points)
    if not gone.any():
        return 0.0
    xy = view.display(before[0][gone])[0]
    at = np.clip(np.floor(xy).astype(int), 0, (view.width - 1, view.height - 1))
    inside = picture.inside_polygon(ring)[at[:, 1], at[:, 0]]
    apart = picture.distance_to(xy, [np.vstack([ring, ring[:1]])], np.inf)[0]
    return float((~inside & (apart > BESIDE)).mean())


def drawn(case, points, triangles, result):
    """A drawing's pieces, Euler number, outline, summit and angles."""
    if "pieces" not in case:
        return
    edges, used = meshes.edges_of(triangles)[0], np.unique(triangles)
    root = np.arange(len(points))
    while True:
        least = root.copy()
        np.minimum.at(least, edges[:, 0], root[edges[:, 1]])
        np.minimum.at(least, edges[:, 1], root[edges[:, 0]])
        least = least[least]
        if (least == root).all():
            break
        root = least
    result["pieces"], result["euler"] = len(np.unique(root[used])), len(used) - len(edges) + len(triangles)
    result["fails"] += [name for name in ("pieces", "euler") if result[name] != case[name]]
    low, high = points.min(0), points.max(0)
    corner = points[triangles]
    front = corner[:, :, 2].mean(1) > 0
    if "outline" in case:
        loop = np.array(case["outline"])
        size = (np.ptp(loop, axis=0) / (high - low)[:2]).mean()
        place = (points[:, :2] - (low + high)[:2] / 2) * size + (loop.min(0) + loop.max(0)) / 2
        xy = np.c_[place, points[:, 2] * size]
        loops = picture.outline(xy[:, :2], triangles, 1.0)
        result["worst"] = float(max(picture.distance_to(np.vstack([loop, loop[:1]]), loops)[0].max(), 0.0))
        result["fails"] += ["outline"] * (result["worst"] > NOTCH)
        if "summit" in case:
            top = xy[np.argmax(xy[:, 2])]
            ring = np.abs(np.linalg.norm(xy[:, :2] - top[:2], axis=1) - 40) < 12
            slope = (top[2] - xy[ring & (xy[:, 2] > 0), 2]) / np.linalg.norm(xy[ring & (xy[:, 2] > 0), :2] - top[:2], axis=1)
            result["slope"] = float(slope.mean())
            result["fails"] += ["summit"] * (result["slope"] > SUMMIT_SLOPE)
    if "even" in case:
        side = np.roll(corner, -1, axis=1) - corner
        length = np.linalg.norm(side, axis=2)
        cosine = -(side * np.roll(side, 1, axis=1)).sum(2) / np.maximum(length * np.roll(length, 1, axis=1), 1e-300)
        result["even"] = float(np.median(np.degrees(np.arccos(np.clip(cosine, -1, 1))).min(1)[front]))
        result["fails"] += ["even"] * (result["even"] < EVEN)


# ------------------------------------------------------------------------------------------------------- pictures

def show(case, folder, mesh_file, out, result, file):
    """Before and after in the stroke's view, after from its side; a drawing's model from the front and aside."""
    if not out.is_file() and not mesh_file:
        return
    points, triangles, _ = meshes.weld(*meshes.arrays(meshes.read(out if out.is_file() else mesh_file)))
    if mesh_file:
        names = [word.lstrip("@") for word in [*case["inputs"], *case.get("options", [])] if word.endswith(".vtp")]
        lines = [stroke_files.read(folder / name) for name in names]
        view = lines[0][2]
        images = [picture.shaded(view, *meshes.weld(*meshes.arrays(meshes.read(mesh_file)))[:2], scale=1)]
        for line in lines:
            picture.draw(images[0], line[1], picture.RED)
        across, up = view.view[0, :3], view.view[1, :3]
        views = [view, picture.View.looking(points, across + 0.3 * view.view[2, :3], up, False, 0.7)]
    else:
        images, views = [], [picture.View.looking(points, towards, (0, 1, 0), False, 0.85) for towards in ((0, 0, 1), (0.8, 0.3, 0.5), (1, 0, 0.1))]
    images += [picture.shaded(view, points, triangles, scale=1) for view in views]
    image = np.concatenate(images, axis=1)
    picture.write_text(image, f"{file.stem}" + (" FAILS " + ", ".join(result["fails"]) if result["fails"] else ""), 6, 6, 15)
    if result["said"]:
        picture.write_text(image, " ".join(result["messages"])[:260], 6, 26, 13, picture.RED)
    picture.save(image, file)


def enough(results):
    silent = [r for r in results.values() if "silent wreck" in r["fails"] or "crash" in r["fails"] or "crash or hang" in r["fails"]]
    return not silent and np.mean([r["holds"] for r in results.values()]) >= 0.9


ACCEPTANCE = frame.Run(
    script=__file__,
    title="Acceptance: situations from outside",
    units="crossing: edges that newly pass through faces; inside out: share of what is seen that newly shows its back; worst: px from the "
          "stroke to the outline; left over: share of a limb that is seen beside its new outline; sharp: length of the edges over 60 degrees, "
          "after by before; stray: of what moved, the share beside the ring; slope: 40 px from a summit; even: median of the least angles.",
    modes={"default": "default"},
    usual=("default",),
    counting=("default",),
    bounds={"silent wreck": "no wreck without a word", "passes through itself": f"at most {CROSSING} edges newly pass through faces",
            "inside out": "0.2 % of what is seen turned inside out", "torn": "no new border", "crowded": "manifold stays manifold",
            "no remedy": "refusals name a remedy"},
    columns=("crossing", "inside out", "worst", "left over", "sharp", "stray", "slope", "even", "kept", "seconds"),
    make=lambda folder, day: situations.make_all(folder, day),
    one=run,
    enough=enough,
    sheet=(1, 6),
)

if __name__ == "__main__":
    sys.exit(frame.main(ACCEPTANCE, __doc__))
