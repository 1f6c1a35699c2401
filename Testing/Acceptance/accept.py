"""The acceptance of one stroke deforming a mesh: runs every stroke of strokes.py through vtkOversketchOneStroke, with
remeshing off, by default and as published, judges the results, and prints one table.

    PYTHONPATH=build/release/lib/python3/dist-packages /usr/bin/python3 Testing/Acceptance/accept.py FOLDER
        [--strokes FOLDER] [--only PART-OF-NAME ...] [--modes off,default,published,uncorrected] [--workers 2]
        [--limit SECONDS] [--backend auto|opencl|host] [--no-pictures]

FOLDER receives table.md, results.json, a picture of every result and contact sheets. Models of the shared test data
are looked for in OVERSKETCH_DATA, else in ../shared/data beside the source tree; without it only Data/Models run.
Exit code 0 when at least 95 % of the strokes hold with remeshing off and by default, else 1.
"""
import argparse
import importlib.util
import json
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import judge
import meshes
import picture
import sheets
import strokes

MODES = {"off": "remesh off", "default": "default", "published": "as published",
         "uncorrected": "remesh off, outline not corrected"}
REQUIRED = 0.95  # share of the strokes that must hold, remesh off and default


def system(mode, backend):
    from oversketch import vtkOversketchOneStroke
    one_stroke = vtkOversketchOneStroke()
    if mode in ("off", "uncorrected"):
        one_stroke.SetRemeshToOff()
        one_stroke.SetCorrectOutline(mode == "off")
    elif mode == "published":
        one_stroke.AsPublishedOn()
    if backend == "opencl":
        one_stroke.SetBackendToOpenCL()
    elif backend == "host":
        one_stroke.SetBackendToHost()
    return one_stroke


def run(stroke_file, mesh_file, modes, backend, pictures):
    """Runs one stroke in every mode and returns {mode: result}; writes pictures into a folder where one is given."""
    mesh = meshes.read(mesh_file)
    stroke, samples, view, note = strokes.read(stroke_file)
    before = meshes.arrays(mesh)
    known = judge.facts_of(before)
    results = {}
    for mode in modes:
        messages = []
        one_stroke = system(mode, backend)
        for event in ("ErrorEvent", "WarningEvent"):
            one_stroke.AddObserver(event, listener(messages))
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
        result["seconds"], result["messages"] = seconds, messages
        results[mode] = result
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
    return judge.surviving(points, inner[chosen])


def listener(messages):
    def hear(_object, _event, text):
        messages.append(text.strip())
    hear.CallDataType = "string0"
    return hear


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


# --------------------------------------------------------------------------------------------------- the table

COLUMNS = ("mean", "worst", "back", "folds", "untouched", "overlap", "seconds")


def number(value, digits=2):
    if value is None:
        return "–"
    return f"{value:.{digits}f}" if isinstance(value, float) else str(value)


def table(index, results, modes):
    lines = ["# Acceptance: one stroke deforms a mesh", "",
             f"{len(index)} strokes over {len({e['model'] for e in index})} models. px on an 800 x 600 picture: mean and worst "
             "distance of the stroke's middle 60 % to the result's outline, back: largest distance of the outline between "
             "to the stroke; folds: new edges with normals over 100 degrees apart; untouched: share of the area; overlap: "
             "intersection over union of the region and the stroked capsule.", ""]
    lines += ["| | " + " | ".join(MODES[m] for m in modes) + " |", "|---|" + "---|" * len(modes)]
    every = lambda mode: [results[e["name"]].get(mode, {"holds": False, "fails": ["not run"]}) for e in index]
    share = lambda values: f"{sum(values)} of {len(values)} ({100 * sum(values) / max(1, len(values)):.0f} %)"
    lines.append("| **all bounds hold** | " + " | ".join(share([r["holds"] for r in every(m)]) for m in modes) + " |")
    bounds = {"mean": "mean ≤ 1.0 px", "worst": "worst ≤ 2.5 px", "back": "back ≤ 3 px", "folds": "at most 10 new folds",
              "untouched": "half of the area untouched", "closed": "closed stays closed", "manifold": "manifold stays manifold",
              "degenerate": "no new degenerate triangle", "outside changed": "outside the region bit-identical",
              "other limbs moved": "other limbs untouched", "overlap": "region overlaps the capsule by 0.95"}
    for name, text in bounds.items():
        cells = []
        for mode in modes:
            known = [r for r in every(mode) if name in r]
            cells.append(share([name not in r["fails"] for r in known]))
        lines.append(f"| {text} | " + " | ".join(cells) + " |")
    lines.append("| no result | " + " | ".join(str(sum("mean" not in r for r in every(m))) for m in modes) + " |")
    for name in COLUMNS:
        cells = []
        for mode in modes:
            known = [r[name] for r in every(mode) if name in r]
            cells.append(f"{number(float(np.median(known)))} ({number(float(np.percentile(known, 90)))})" if known else "–")
        lines.append(f"| median (90th percentile) of {name} | " + " | ".join(cells) + " |")
    for mode in modes:
        lines += ["", f"## {MODES[mode]}", "", "| stroke | view | " + " | ".join(COLUMNS) + " | holds |",
                  "|---|---|" + "---|" * (len(COLUMNS) + 1)]
        for entry, result in zip(index, every(mode)):
            verdict = "yes" if result["holds"] else "**" + ", ".join(result["fails"]) + "**"
            cells = " | ".join(number(result.get(name)) for name in COLUMNS)
            lines.append(f"| {entry['name']} | {entry['projection'][:5]} | {cells} | {verdict} |")
    return "\n".join(lines) + "\n"


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--strokes", type=Path, help="folder of strokes made before (default: FOLDER/strokes)")
    arguments.add_argument("--only", nargs="*", default=[])
    arguments.add_argument("--modes", default="off,default,published")
    arguments.add_argument("--workers", type=int, default=2)
    arguments.add_argument("--limit", type=float, default=180)
    arguments.add_argument("--backend", choices=("auto", "opencl", "host"), default="auto")
    arguments.add_argument("--no-pictures", action="store_true")
    arguments.add_argument("--one", nargs=2, help=argparse.SUPPRESS)  # a worker: stroke file, mesh file
    options = arguments.parse_args()
    if not importlib.util.find_spec("oversketch"):
        arguments.error("no Python package oversketch; a build has it in build/release/lib/python3/dist-packages, "
                        "which PYTHONPATH must name")
    modes = options.modes.split(",")
    pictures = None if options.no_pictures else options.folder
    if options.one:
        print("\n" + json.dumps(run(*options.one, modes, options.backend, pictures)))
        return 0

    options.folder.mkdir(parents=True, exist_ok=True)
    if not (meshes.SHARED / "meshes").is_dir():
        print(f"no shared test data in {meshes.SHARED} (set OVERSKETCH_DATA): only the models of Data/Models run")
    folder = options.strokes or options.folder / "strokes"
    index = json.loads((folder / "index.json").read_text()) if (folder / "index.json").is_file() else strokes.make_all(folder)
    index = [e for e in index if not options.only or any(part in e["name"] for part in options.only)]

    def work(entry):
        command = [sys.executable, __file__, str(options.folder), "--one", str(folder / f"{entry['name']}.vtp"), entry["mesh"],
                   "--modes", options.modes, "--backend", options.backend] + ["--no-pictures"] * options.no_pictures
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=options.limit * len(modes))
            found = json.loads(done.stdout.strip().splitlines()[-1]) if done.returncode == 0 else None
            why = f"exit code {done.returncode}: {done.stderr.strip()[-400:]}"
        except subprocess.TimeoutExpired:
            found, why = None, f"over {options.limit:.0f} s a mode"
        found = found or {mode: {"holds": False, "fails": ["crash or hang"], "messages": [why]} for mode in modes}
        print(entry["name"] + ": " + "; ".join(
            f"{m} " + ("holds" if found[m]["holds"] else "FAILS " + ", ".join(found[m]["fails"])
                       + "".join(" | " + t for t in found[m]["messages"][:1])) for m in modes), flush=True)
        return entry["name"], found

    with ThreadPoolExecutor(options.workers) as pool:
        results = dict(pool.map(work, index))
    (options.folder / "results.json").write_text(json.dumps(results, indent=1))
    text = table(index, results, modes)
    (options.folder / "table.md").write_text(text)
    print("\n" + text)
    if pictures:
        for mode in modes:
            files = [pictures / f"{e['name']}-{mode}.png" for e in index]
            sheets.write([picture.halve(picture.load(f)) for f in files if f.is_file()],
                         pictures / f"sheet-{mode}", columns=2, rows=4)
    shares = [np.mean([results[e["name"]][mode]["holds"] for e in index]) for mode in modes if mode in ("off", "default")]
    return 0 if all(share >= REQUIRED for share in shares) else 1


if __name__ == "__main__":
    sys.exit(main())
