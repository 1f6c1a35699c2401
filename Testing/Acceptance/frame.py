"""The frame of an acceptance run, the same for every system: runs each of its strokes in a process of its own, in several
modes, and makes one table and contact sheets of the results. A system says in a Run what is its own (one_stroke/accept.py).
"""
import argparse
import importlib.util
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Callable, NamedTuple

import numpy as np

import meshes
import picture
import sheets

REQUIRED = 0.95  # share of the strokes that must hold in each mode that counts


class Run(NamedTuple):
    """An acceptance run: what differs between systems."""

    script: str  # file of the system's own accept.py
    title: str
    units: str  # a sentence: what the measures are
    modes: dict  # name: how the table calls it
    usual: tuple  # modes that run unless others are asked for
    counting: tuple  # modes in which REQUIRED must be reached
    bounds: dict  # measure, or "grade: measure": its bound, as the table says it
    columns: tuple  # measures of the table
    make: Callable  # (folder, day or None) -> index: writes the strokes, or a day's tenth; names each with its mesh, model and projection
    one: Callable  # (stroke file, mesh file, modes, backend, folder for pictures or None[, case]) -> {mode: result}
    # Whether a mode's results, {name: result}, are enough.
    enough: Callable = lambda results: np.mean([result["holds"] for result in results.values()]) >= REQUIRED
    sheet: tuple = (2, 4)  # pictures across and down on a contact sheet
    halve: bool = True  # pictures are halved there


# Day of the seed. A full run has none, and so has a run without a seed: all strokes are meant.
DAY = None if "OVERSKETCH_FULL" in os.environ or "OVERSKETCH_SEED" not in os.environ else int(os.environ["OVERSKETCH_SEED"])


def tenth(items, day):
    """Those of a day, or all."""
    return list(items) if day is None else list(items)[day % 10::10]


def listener(messages):
    """Appends what an event says."""
    def hear(_object, _event, text):
        messages.append(text.strip())
    hear.CallDataType = "string0"
    return hear


def number(value, digits=2):
    if value is None:
        return "–"
    return f"{value:.{digits}f}" if isinstance(value, float) else str(value)


def share(values):
    return f"{sum(values)} of {len(values)} ({100 * sum(values) / max(1, len(values)):.0f} %)"


def table(run, index, results, modes):
    every = lambda mode: [results[e["name"]].get(mode, {"holds": False, "fails": ["not run"]}) for e in index]
    lines = [f"# {run.title}", "", f"{len(index)} strokes over {len({e['model'] for e in index})} models. {run.units}", "",
             "| | " + " | ".join(run.modes[m] for m in modes) + " |", "|---|" + "---|" * len(modes),
             "| **all bounds hold** | " + " | ".join(share([r["holds"] for r in every(m)]) for m in modes) + " |"]
    for name, text in run.bounds.items():
        known = [[r for r in every(mode) if name.split(": ")[-1] in r.get("asks", r)] for mode in modes]
        lines.append(f"| {text} | " + " | ".join(share([name not in r["fails"] for r in rows]) for rows in known) + " |")
    lines.append("| no result | " + " | ".join(str(sum(run.columns[0] not in r for r in every(m))) for m in modes) + " |")
    for name in run.columns:
        cells = []
        for mode in modes:
            known = [r[name] for r in every(mode) if r.get(name) is not None]
            cells.append(f"{number(float(np.median(known)))} ({number(float(np.percentile(known, 90)))})" if known else "–")
        lines.append(f"| median (90th percentile) of {name} | " + " | ".join(cells) + " |")
    for mode in modes:
        lines += ["", f"## {run.modes[mode]}", "", "| stroke | view | " + " | ".join(run.columns) + " | holds |",
                  "|---|---|" + "---|" * (len(run.columns) + 1)]
        for entry, result in zip(index, every(mode)):
            verdict = "yes" if result["holds"] else "**" + ", ".join(result["fails"]) + "**"
            cells = " | ".join(number(result.get(name)) for name in run.columns)
            lines.append(f"| {entry['name']} | {entry['projection'][:5]} | {cells} | {verdict} |")
    return "\n".join(lines) + "\n"


def in_a_process(run, options, modes, folder, entry):
    """The results of one stroke, in each of its cases where it has some, by name; one that crashes or hangs takes no other with it."""
    command = [sys.executable, run.script, str(options.folder), "--one", str(folder / f"{entry['name']}.vtp"), entry["mesh"],
               "--modes", options.modes, "--backend", options.backend] + ["--no-pictures"] * options.no_pictures
    cases = entry.get("cases", [])
    command += ["--cases", *cases] if cases else []
    names = case_names(entry)
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=options.limit * len(modes) * len(names))
        found = json.loads(done.stdout.strip().splitlines()[-1]) if done.returncode == 0 else None
        why = f"exit code {done.returncode}: {done.stderr.strip()[-400:]}"
    except subprocess.TimeoutExpired:
        found, why = None, f"over {options.limit:.0f} s a mode"
    found = found or [{mode: {"holds": False, "fails": ["crash or hang"], "messages": [why]} for mode in modes} for _ in names]
    for name, result in zip(names, found):
        print(name + ": " + "; ".join(
            f"{m} " + ("holds" if result[m]["holds"] else "FAILS " + ", ".join(result[m]["fails"])
                       + "".join(" | " + t for t in result[m]["messages"][:1])) for m in modes), flush=True)
    return dict(zip(names, found))


def case_names(entry):
    """The names of a stroke's results: its own, or one for each of its cases."""
    return [f"{entry['name']} {case}" for case in entry["cases"]] if entry.get("cases") else [entry["name"]]


def arguments(run, documentation):
    parser = argparse.ArgumentParser(description=documentation, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--strokes", type=Path, help="folder of strokes made before (default: FOLDER/strokes)")
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--tenth", type=int, help="of a day as a number, 20261127: some tenth of the strokes, which it chooses")
    parser.add_argument("--least", type=float, help="share of the results that must hold (default: what the run asks for)")
    parser.add_argument("--modes", default=",".join(run.usual))
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--limit", type=float, default=180)
    parser.add_argument("--backend", choices=("auto", "opencl", "host"), default="auto")
    parser.add_argument("--no-pictures", action="store_true")
    parser.add_argument("--continue", dest="goes_on", action="store_true", help="keep what FOLDER/results.json has, run the rest")
    parser.add_argument("--one", nargs=2, help=argparse.SUPPRESS)  # a worker: stroke file, mesh file
    parser.add_argument("--cases", nargs="*", default=[], help=argparse.SUPPRESS)  # and what else differs
    options = parser.parse_args()
    if not importlib.util.find_spec("oversketch"):
        parser.error("no Python package oversketch; a build has it in build/release/lib/python3/dist-packages, "
                     "which PYTHONPATH must name")
    return options


def main(run, documentation):
    """What a system's accept.py does; its exit code."""
    options = arguments(run, documentation)
    modes = options.modes.split(",")
    pictures = None if options.no_pictures else options.folder
    if options.one:
        one = lambda *case: run.one(*options.one, modes, options.backend, pictures, *case)
        print("\n" + json.dumps([one(case) for case in options.cases] or [one()]))
        return 0

    options.folder.mkdir(parents=True, exist_ok=True)
    if not (meshes.SHARED / "meshes").is_dir():
        print(f"no shared test data in {meshes.SHARED} (set OVERSKETCH_DATA): only the models of Data/Models run")
    folder = options.strokes or options.folder / ("strokes" if options.tenth is None else f"strokes-{options.tenth}")
    index = json.loads((folder / "index.json").read_text()) if (folder / "index.json").is_file() else run.make(folder, options.tenth)
    index = [e for e in index if not options.only or any(part in e["name"] for part in options.only)]
    kept = options.folder / "results.json"
    results = json.loads(kept.read_text()) if options.goes_on and kept.is_file() else {}
    known = lambda entry: all(mode in results.get(name, {}) for name in case_names(entry) for mode in modes)
    with ThreadPoolExecutor(options.workers) as pool:
        left = [entry for entry in index if not known(entry)]
        for part in pool.map(lambda entry: in_a_process(run, options, modes, folder, entry), left):
            results.update({name: {**results.get(name, {}), **found} for name, found in part.items()})
            kept.write_text(json.dumps(results, indent=1))
    index = [{**entry, "name": name} for entry in index for name in case_names(entry)]
    results = {entry["name"]: results[entry["name"]] for entry in index}
    text = table(run, index, results, modes)
    (options.folder / "table.md").write_text(text)
    print("\n" + text)
    for mode in modes if pictures else ():
        files = [pictures / f"{e['name']}-{mode}.png" for e in index]
        shown = [picture.load(f) for f in files if f.is_file()]
        sheets.write([picture.halve(f) for f in shown] if run.halve else shown, pictures / f"sheet-{mode}", *run.sheet)
    counting = [{name: result[mode] for name, result in results.items()} for mode in modes if mode in run.counting]
    enough = run.enough
    if options.least is not None:
        def enough(each):
            lost = any("crash or hang" in result["fails"] for result in each.values())
            return not lost and np.mean([result["holds"] for result in each.values()]) >= options.least
    return 0 if all(enough(each) for each in counting) else 1
