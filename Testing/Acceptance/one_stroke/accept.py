"""The acceptance of one stroke deforming a mesh: runs every stroke of strokes.py through vtkOversketchOneStroke, with
remeshing off, by default and as published, judges the results, and prints one table.

    PYTHONPATH=build/release/lib/python3/dist-packages /usr/bin/python3 Testing/Acceptance/one_stroke/accept.py FOLDER
        [--strokes FOLDER] [--only PART-OF-NAME ...] [--modes off,default,on,published,uncorrected] [--workers 2]
        [--limit SECONDS] [--backend auto|opencl|host] [--no-pictures]

FOLDER receives table.md, results.json, a picture of every result and contact sheets. Models of the shared test data
are looked for in OVERSKETCH_DATA, else in ../shared/data beside the source tree; without it only Data/Models run.
Exit code 0 when at least 95 % of the strokes hold with remeshing off and by default, else 1.
"""
import sys
import time
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import frame  # noqa: E402
import judge  # noqa: E402
import meshes  # noqa: E402
import picture  # noqa: E402
import stroke_files  # noqa: E402
import strokes  # noqa: E402


def system(mode, backend):
    from oversketch import vtkOversketchOneStroke
    one_stroke = vtkOversketchOneStroke()
    if mode in ("off", "uncorrected"):
        one_stroke.SetRemeshToOff()
        one_stroke.SetCorrectOutline(mode == "off")
    elif mode == "on":
        one_stroke.SetRemeshToOn()
    elif mode == "published":
        one_stroke.AsPublishedOn()
    if backend == "opencl":
        one_stroke.SetBackendToOpenCL()
    elif backend == "host":
        one_stroke.SetBackendToHost()
    return one_stroke


def run(stroke_file, mesh_file, modes, backend, pictures, also=lambda result, mesh, output: None):
    """Runs one stroke in every mode and returns {mode: result}; writes pictures into a folder where one is given. `also` judges what else
    is asked of an output."""
    mesh = meshes.read(mesh_file)
    stroke, samples, view, note = stroke_files.read(stroke_file)
    before = meshes.arrays(mesh)
    known = judge.facts_of(before)
    results = {}
    for mode in modes:
        messages = []
        one_stroke = system(mode, backend)
        for event in ("ErrorEvent", "WarningEvent"):
            one_stroke.AddObserver(event, frame.listener(messages))
        one_stroke.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        one_stroke.SetInputData(mesh)
        one_stroke.SetStrokeData(stroke)
        start = time.perf_counter()
        one_stroke.Update()
        seconds = time.perf_counter() - start
        output = one_stroke.GetOutput()
        match, border = one_stroke.GetInnerOutput("Match"), one_stroke.GetInnerOutput("RegionBorder")
        region = region_of(border, before[0]) if border.GetNumberOfPoints() else np.zeros(len(before[0]), bool)
        if output.GetNumberOfCells() == 0:
            result = {"fails": ["no result"], "holds": False}
            after = before
        else:
            after = meshes.arrays(output)
            result = judge.judge(known, after, samples, view, region, note)
            result["remeshed"] = bool(one_stroke.GetRemeshed())
            also(result, mesh, output)
        result["seconds"], result["messages"] = seconds, messages
        results[mode] = result
        if mode in ("default", "on"):
            plain = results["off"] if "off" in results else run(stroke_file, mesh_file, ["off"], backend, None)["off"]
            judge.compare(result, plain)
        if pictures:
            image = show(view, before, after, samples, match, region)
            label = f"{Path(stroke_file).stem} {mode}"
            if "mean" in result:
                label += f"  {result['mean']:.2f} {result['worst']:.2f} {result['back']:.2f} folds {result['folds']}" \
                         f"  untouched {result['untouched']:.2f}{'  remeshed' if result['remeshed'] else ''}"
            picture.write_text(image, label, 6, 6, 15)
            if result["fails"]:
                picture.write_text(image, "FAILS " + ", ".join(result["fails"]), 6, 24, 15, picture.RED)
            picture.save(image, Path(pictures) / f"{Path(stroke_file).stem}-{mode}.png")
    return results


def region_of(border, points):
    """The final region as a byte per input point, found by position (the system computes on a welded mesh); no region
    at all is an error of the system, so it is not passed over here."""
    inner = meshes.arrays(border)[0]
    chosen = vtk_to_numpy(border.GetPointData().GetArray("Region")) != 0
    return meshes.among(points, inner[chosen])


def show(view, before, after, samples, match, region):
    """Before with the region orange, the matched section blue and the stroke red; after with the stroke red."""
    points, triangles, welded = meshes.weld(*before)
    colours = np.tile(picture.GREY, (len(points), 1))
    colours[welded[region]] = picture.ORANGE
    left = picture.shaded(view, points, triangles, colours, scale=1)
    if match is not None and match.GetNumberOfPoints() > 1:
        xy, _ = view.display(vtk_to_numpy(match.GetPoints().GetData()).astype(float))
        picture.draw(left, xy, picture.BLUE, 2.5)
    picture.draw(left, samples, picture.RED, 2.5)
    points, triangles, _ = meshes.weld(*after)
    right = picture.shaded(view, points, triangles, scale=1)
    picture.draw(right, samples, picture.RED, 1.2)
    return np.concatenate([left, right], axis=1)


ACCEPTANCE = frame.Run(
    script=__file__,
    title="Acceptance: one stroke deforms a mesh",
    units="px on an 800 x 600 picture: mean and worst distance of the stroke's middle 60 % to the result's outline, back: largest "
          "distance of the outline between to the stroke; folds: new edges with normals over 100 degrees apart; inside out: share of what is seen that newly shows its back; untouched: share "
          "of the area; overlap: intersection over union of the region and the stroked capsule; angle: mean degrees between "
          "neighbouring triangles of what moved; sharp: share of its edges' length over 40 degrees; rougher: how far these two "
          "are over their bound against remesh off, in degrees or hundredths.",
    modes={"off": "remesh off", "default": "default", "on": "remesh on", "published": "as published",
           "uncorrected": "remesh off, outline not corrected"},
    usual=("off", "default", "published"),
    counting=("off", "default"),
    bounds={"mean": "mean ≤ 1.0 px", "worst": "worst ≤ 2.5 px", "back": "back ≤ 3 px", "folds": "at most 10 new folds",
            "inside out": "no more than 0.2 % of what is seen turned inside out",
            "untouched": "half of the area untouched", "closed": "closed stays closed", "manifold": "manifold stays manifold",
            "degenerate": "no new degenerate triangle", "outside changed": "outside the region bit-identical",
            "other limbs moved": "other limbs untouched", "overlap": "region overlaps the capsule by 0.95",
            "rougher": "no rougher than with remesh off: mean angle ≤ 1.25 times + 1 degree, sharp length ≤ 0.01 more"},
    columns=("mean", "worst", "back", "folds", "inside out", "untouched", "overlap", "angle", "sharp", "rougher", "seconds"),
    make=lambda folder, day: strokes.make_all(folder, [name for name, *_ in frame.tenth(meshes.models(), day)] if day else ()),
    one=run,
)

if __name__ == "__main__":
    sys.exit(frame.main(ACCEPTANCE, __doc__))
