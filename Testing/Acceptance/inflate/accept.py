"""The acceptance of drawings that are inflated: fourteen outlines, drawn by five hands that wobble by 0, 1 and 2 px, by default, without darts
and smoothing (c = 0), and as published; and ten outlines of our own whose ridges meet, by three hands. The command runs, for c = 0 the system in Python, and the file alone is judged.

    OVERSKETCH_COMMAND=build/release/bin/oversketch PYTHONPATH=build/release/lib/python3/dist-packages /usr/bin/python3
        Testing/Acceptance/inflate/accept.py FOLDER [--strokes FOLDER] [--only PART-OF-NAME ...] [--modes default,plain,published] [--workers 2]
        [--limit SECONDS] [--no-pictures]

A drawing is named OUTLINE-WOBBLEpx-HAND: `--only crane`, `--only 1px`, `--only horse-2px-0`. FOLDER receives table.md, results.json, a
picture of every result and contact sheets; the images are those of the shared test data, looked for in OVERSKETCH_DATA, else in
../shared/data beside the source tree. Exit code 0 when by default every result is sound and without pits, whatever the wobble, and all bounds hold
in 66 of 70 drawings of 1 px of the images.
"""
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parent)]
import frame  # noqa: E402
import inflate_judge  # noqa: E402
import meshes  # noqa: E402
import outlines  # noqa: E402
import picture  # noqa: E402
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter  # noqa: E402

COUNTED, REQUIRED = "-1px-", 66 / 70  # the drawings of which that share must reach all bounds
OPTIONS = {"default": [], "published": ["--as-published"]}


def command(drawing_file, out, mode):
    """What a user would type."""
    return [os.environ["OVERSKETCH_COMMAND"], "inflate", str(drawing_file), "-o", str(out), *OPTIONS[mode]]


def made(drawing_file, out, mode, environment):
    """Writes the mesh of a mode where there is one; what was said."""
    if mode != "plain":
        done = subprocess.run(command(drawing_file, out, mode), capture_output=True, text=True, env=environment)
        messages = [line for line in done.stderr.splitlines() if line.strip()]
        return messages or ([f"exit code {done.returncode}"] if done.returncode else [])
    from oversketch import vtkOversketchInflateDrawing
    reader, writer, system, messages = vtkXMLPolyDataReader(), vtkXMLPolyDataWriter(), vtkOversketchInflateDrawing(), []
    for event in ("ErrorEvent", "WarningEvent"):
        system.AddObserver(event, frame.listener(messages))
    system.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    system.GetStep("Darts").SetDartModeToOff()
    system.GetStep("CoarseMesh").RelaxOff()
    system.GetStep("Inflate").SetUnstretchedRims(False)
    system.GetStep("Inflate").SetLocalMaxSmoothing(0.0)
    system.GetStep("Inflate").SetProfileSmoothing(0.0)
    reader.SetFileName(str(drawing_file))
    system.SetInputConnection(0, reader.GetOutputPort())
    system.Update()
    if system.GetOutput().GetNumberOfCells():
        writer.SetFileName(str(out))
        writer.SetInputData(system.GetOutput())
        writer.Write()
    return messages


def run(drawing_file, outline, modes, backend, pictures):
    """Runs one drawing in every mode and returns {mode: result}; writes pictures into a folder where one is given."""
    results, environment = {}, dict(os.environ, **({"OVERSKETCH_OPENCL": "off"} if backend == "host" else {}))
    for mode in modes:
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "mesh.vtp"
            start = time.perf_counter()
            messages = made(drawing_file, out, mode, environment)
            seconds = time.perf_counter() - start
            if out.is_file():
                result = inflate_judge.judge(drawing_file, out, outline, mode == "plain")
            else:
                result = {"fails": ["no result"], "holds": False}
            result.update(messages=messages, seconds=seconds)
            results[mode] = result
            if pictures:
                image = show(out, drawing_file)
                picture.write_text(image, f"{Path(drawing_file).stem} {mode}", 8, 8, 22)
                if result["fails"]:
                    picture.write_text(image, "FAILS " + ", ".join(result["fails"]), 8, 36, 22, picture.RED)
                picture.save(image, Path(pictures) / f"{Path(drawing_file).stem}-{mode}.png")
    return results


def show(mesh_file, drawing_file):
    """The result from the front and from a quarter to the right, above; where there is none the drawing twice."""
    drawing = inflate_judge.Drawing(drawing_file)
    rim = [np.c_[loop, np.zeros(len(loop))] for loop in drawing.loops]
    points, triangles = None, ()
    if mesh_file.is_file():
        world, triangles = meshes.arrays(meshes.read(mesh_file))
        points = drawing.place(world)
    images = []
    for towards in ((0, 0, 1), (0.75, 0.35, 0.6)):
        view = picture.View.looking(points if len(triangles) else np.vstack([*rim, rim[0] + (0, 0, 1)]), towards, (0, 1, 0), False, 0.9)
        if len(triangles):
            images.append(picture.shaded(view, points, triangles, scale=1))
            continue
        image = np.ones((picture.HEIGHT, picture.WIDTH, 3))
        for loop in rim:
            picture.draw(image, view.display(np.vstack([loop, loop[:1]]))[0], picture.RED)
        images.append(image)
    return np.concatenate(images, axis=1)


def enough(results):
    """Of one mode: nothing unsound, no pit, and of the drawings that are counted nearly all reach all bounds."""
    never = {*inflate_judge.SOUND, "pit", "no result", "crash or hang"}
    sound = not any(never & set(result["fails"]) for result in results.values())
    counted = [result["holds"] for name, result in results.items() if COUNTED in name and name.split("-")[0] in outlines.OUTLINES]
    return sound and (not counted or np.mean(counted) >= REQUIRED)


ACCEPTANCE = frame.Run(
    script=__file__,
    title="Acceptance: a drawing is inflated",
    units="Lengths are px, angles degrees. worst: stroke sample to rim; dihedral: 95th percentile where T is 8 px or more; pit: what closing "
          "the front by a disc of 10 px fills where T is 12 or more, off the row of triangles at the rim; rim pit: in that row; limb low, "
          "limb: 5th percentile and median of z / T at skeleton pixels of T 4 to 15, where there are 400; angle low, angle: 5th percentile and median of the triangles' smallest angles in the plane; keel: the mean angle between faces across the rim over that beside it. For c = 0 the bounds in brackets "
          "count.",
    modes={"default": "default", "plain": "c = 0, darts off", "published": "as published"},
    usual=("default", "plain", "published"),
    counting=("default",),
    bounds={
        "closed": "closed manifold, wound alike", "outward": "wound outward", "inverted": "no triangle turned over",
        "chi": "Euler characteristic 2, 0 with a hole",
        "iou": "rim and strokes overlap ≥ 0.993, lobster and dinosaur 0.984 [0.985 and 0.975]",
        "worst": "stroke sample to rim ≤ 4, kettle 7 [10]", "dihedral": "dihedral ≤ 12 [65, capybara 90]", "pit": "pit ≤ 2.5 [none]",
        "limb low": "limb, 5th percentile ≥ 0.93 [0.90]", "limb": "limb, median 0.95 to 1.3, seahorse 1.5 [0.9 to 1.3]",
        "angle low": "planar angle, 5th percentile ≥ 10, lobster and dinosaur 5 [2]",
        "angle": "planar angle, median ≥ 34, lobster and dinosaur 30 [18]"},
    columns=("triangles", "iou", "worst", "dihedral", "pit", "rim pit", "limb low", "limb", "angle low", "angle", "keel", "inverted", "closed",
             "chi", "seconds"),
    make=outlines.make_all,
    one=run,
    enough=enough,
    sheet=(2, 7),
)

if __name__ == "__main__":
    if not outlines.IMAGES.is_dir():
        sys.exit(f"no images in {outlines.IMAGES}: set OVERSKETCH_DATA")
    if "OVERSKETCH_COMMAND" not in os.environ:
        sys.exit("OVERSKETCH_COMMAND does not name the command; a build has it in build/release/bin/oversketch")
    sys.exit(frame.main(ACCEPTANCE, __doc__))
