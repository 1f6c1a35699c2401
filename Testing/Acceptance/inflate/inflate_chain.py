"""Drawings that are inflated, then pulled: a limb of each of the fourteen outlines by one stroke of system A, from the front, the side and
askew.

    OVERSKETCH_COMMAND=build/release/bin/oversketch PYTHONPATH=build/release/lib/python3/dist-packages /usr/bin/python3
        Testing/Acceptance/inflate/inflate_chain.py FOLDER [--strokes FOLDER] [--only PART-OF-NAME ...] [--workers 2] [--no-pictures]

A model is what the command makes of an outline drawn by a hand that wobbles by 1 px, as a file. Strokes are made by the rule of
one_stroke/strokes.py, results judged by the bounds of system A; besides, they must be closed, and texture coordinates stay at all points
that did and within the picture elsewhere. FOLDER receives table.md, results.json, pictures and contact sheets. Exit code 0 when all of it
holds for 95 % of at least 20 limbs over at least 8 outlines.
"""
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "one_stroke"), str(HERE.parent)]
import accept  # noqa: E402  system A's
import frame  # noqa: E402
import meshes  # noqa: E402
import picture  # noqa: E402
import stroke_files  # noqa: E402
import strokes  # noqa: E402
sys.path.append(str(HERE))
import outlines  # noqa: E402

LIMBS, MODELS = 20, 8  # at least so many, over so many outlines
SIDES = {"front": ((0, 0), (180, 0)), "side": ((90, 0), (270, 0)), "askew": ((45, 18), (135, -14), (22, 18), (315, -14))}  # azimuth, elevation


def views_from(side):
    """The views of a side, as strokes.views_of gives all; orthographic and perspective in turn."""
    def views(points, _up):
        for number, (azimuth, elevation) in enumerate(SIDES[side]):
            a, e = np.radians((azimuth, elevation))
            towards = (np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a))
            for perspective in (False, True):
                yield number, perspective, picture.View.looking(points, towards, (0, 1, 0), perspective, 0.62)
    return views


def inflated(outline, folder):
    """The file of an outline's model; made where it is not there."""
    drawing, out = folder / f"{outline}-drawing.vtp", folder / f"{outline}-model.vtp"
    if not out.is_file():
        stroke_files.write(outlines.drawing(outline, 1, 0), drawing)
        subprocess.run([os.environ["OVERSKETCH_COMMAND"], "inflate", str(drawing), "-o", str(out)], check=True)
    return out


def strokes_over(outline, folder, sides=tuple(SIDES)):
    """Writes a stroke for each side from which a limb can be drawn; their entries in the index."""
    entries, path = [], inflated(outline, folder)
    mesh, number = meshes.read(path), sorted(outlines.OUTLINES).index(outline)
    for turn, side in enumerate(sides):
        for stroke, note in strokes.strokes_for(f"{outline}-{side}", mesh, "+y", number + turn, 1, views_from(side)):
            stroke_files.write(stroke, folder / f"{note['name']}.vtp")
            entries.append({"name": note["name"], "model": outline, "mesh": str(path), "kind": note["kind"], "projection": side})
    return entries


def make_all(folder, day=None):
    """The strokes of every outline, or of those of a day, and the index; none where the images are not here."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(2) as pool:
        lists = list(pool.map(lambda outline: in_a_process(outline, folder),
                              frame.tenth(outlines.OUTLINES, day) if outlines.IMAGES.is_dir() else ()))
    index = [entry for entries in lists for entry in entries]
    (folder / "index.json").write_text(json.dumps(index, indent=1))
    return index


def in_a_process(outline, folder):
    """The same of one outline, in a process of its own."""
    done = subprocess.run([sys.executable, __file__, "--strokes-over", outline, str(folder)], capture_output=True, text=True, check=True)
    print(f"{outline}: {done.stdout.count('projection')} strokes", flush=True)
    return json.loads(done.stdout.splitlines()[-1])


def textured(result, mesh, output):
    """Counts the points whose texture coordinates are not what they were, or, of new and moved points, outside what they were."""
    before, after = (m.GetPointData().GetArray("TCoords") for m in (mesh, output))
    if after is None or after.GetNumberOfTuples() != output.GetNumberOfPoints():
        result["texture"] = output.GetNumberOfPoints()
    else:
        old, new = vtk_to_numpy(before), vtk_to_numpy(after)
        known = {place.tobytes(): t for place, t in zip(vtk_to_numpy(mesh.GetPoints().GetData()).astype(float), old)}
        kept = [known.get(place.tobytes()) for place in vtk_to_numpy(output.GetPoints().GetData()).astype(float)]
        same = np.array([t is None or np.array_equal(t, now) for t, now in zip(kept, new)])
        inside = ((new >= old.min(0) - 1e-6) & (new <= old.max(0) + 1e-6)).all(1)
        result["texture"] = int((~(same & inside)).sum())
    if result["texture"]:
        result["fails"].append("texture")
        result["holds"] = False


def run(stroke_file, mesh_file, modes, backend, pictures):
    return accept.run(stroke_file, mesh_file, modes, backend, pictures, textured)


def enough(results):
    """Of one mode: enough limbs, of enough outlines, and nearly all hold."""
    models = {name.split("-")[0] for name in results}
    return len(results) >= LIMBS and len(models) >= MODELS and np.mean([r["holds"] for r in results.values()]) >= frame.REQUIRED


ACCEPTANCE = accept.ACCEPTANCE._replace(
    script=__file__,
    title="Acceptance: a limb of an inflated drawing is pulled",
    modes={"default": "default"},
    usual=("default",),
    counting=("default",),
    bounds={**accept.ACCEPTANCE.bounds, "texture": "texture coordinates kept"},
    columns=(*accept.ACCEPTANCE.columns, "texture"),
    make=make_all,
    one=run,
    enough=enough,
)

if __name__ == "__main__":
    if "OVERSKETCH_COMMAND" not in os.environ:
        sys.exit("OVERSKETCH_COMMAND does not name the command; a build has it in build/release/bin/oversketch")
    if sys.argv[1:2] == ["--strokes-over"]:
        print(json.dumps(strokes_over(sys.argv[2], Path(sys.argv[3]))))
        sys.exit(0)
    if not outlines.IMAGES.is_dir():
        sys.exit(f"no images in {outlines.IMAGES}: set OVERSKETCH_DATA")
    sys.exit(frame.main(ACCEPTANCE, __doc__))
