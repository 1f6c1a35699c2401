"""Sloppy strokes: every well-made stroke of strokes.py and torso.py, shifted, turned, trimmed, run on, wobbled, drawn inside,
begun or ended on another limb, closed round its tip (hands.py), through vtkOversketchOneStroke by default and, if asked, as
published. Each result is as meant, said to be bad (refused, or with a warning), or a wreck (sloppy_judge.py).

    PYTHONPATH=build/release/lib/python3/dist-packages /usr/bin/python3 Testing/Acceptance/one_stroke/sloppy.py --out FOLDER
        [--only PART-OF-STROKE'S-NAME ...] [--variants 10] [--as-published] [--jobs 2] [--sheets] [--limit SECONDS]

FOLDER receives the strokes, results.json, table.md and, with --sheets, a picture of every wreck by default and sheets of them.
Models of the shared test data are looked for in OVERSKETCH_DATA, else in ../shared/data beside the source tree. Exit code 0
when by default at least 85 % of the sloppy strokes do as meant and none is a wreck, and, where all ran, they were 600 at least.
"""
import argparse
import importlib.util
import json
import subprocess
import sys
import threading
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Dict, List

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import frame  # noqa: E402
import hands  # noqa: E402
import meshes  # noqa: E402
import picture  # noqa: E402
import sheets  # noqa: E402
import sloppy_runs  # noqa: E402

REQUIRED = 0.85  # share of the sloppy strokes that must do as meant
STROKES, LEAST_WELL_MADE, LEAST_MODELS = 600, 60, 15  # that a full run must have
MODES = {"default": "default", "published": "as published"}
Row = Dict[str, Any]


# ------------------------------------------------------------------------------------------------------ the runs

def make_all(folder: Path, jobs: int) -> List[Dict[str, str]]:
    """The index of the well-made strokes, which are made unless they are there."""
    index = folder / "index.json"
    if not index.is_file():
        folder.mkdir(parents=True, exist_ok=True)
        with ThreadPoolExecutor(jobs) as pool:
            lists = pool.map(lambda job: child(folder, ["--make", str(job[0])]), enumerate(meshes.models()))
        index.write_text(json.dumps([entry for entries in lists for entry in entries], indent=1))
    return json.loads(index.read_text())


def child(folder: Path, arguments: List[str]) -> Any:
    """What another process of this script printed last."""
    done = subprocess.run([sys.executable, __file__, "--out", str(folder.parent), *arguments], stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout.splitlines()[-1])


def one_model(options: argparse.Namespace, entries: List[Dict[str, str]]) -> List[Row]:
    """The results of a model's runs, in a process of its own; a run that crashes or hangs is a wreck, and the others go on."""
    runs = sloppy_runs.runs_of(entries, options.variants, modes_of(options))
    rows: List[Row] = []
    while len(rows) < len(runs):
        command = [sys.executable, __file__, *sys.argv[1:], "--model", entries[0]["model"], "--skip", str(len(rows))]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as worker:
            while line := next_result(worker, options.limit):
                rows.append(json.loads(line))
        if len(rows) < len(runs):
            parts = {entry["name"]: entry["part"] for entry in entries}
            run, why = runs[len(rows)], f"crash or hang: {worker.returncode}"
            rows.append({**run._asdict(), "model": entries[0]["model"], "part": parts[run.stroke], "hand": "?", "how": {},
                         "said": "", "fails": ["crash or hang"], "cause": why, "verdict": "wreck"})
    total = Counter(row["verdict"] for row in rows)
    print(f"{entries[0]['model']}: " + ", ".join(f"{total[verdict]} {verdict}" for verdict in sorted(total)), flush=True)
    return rows


def next_result(worker: subprocess.Popen, limit: float) -> str:
    """The next line of JSON that a process prints, which is ended when that takes too long; none at its end."""
    clock = threading.Timer(limit, worker.kill)
    clock.start()
    try:
        return next((text for text in worker.stdout or () if text.startswith("{")), "")
    finally:
        clock.cancel()


def modes_of(options: argparse.Namespace) -> List[str]:
    return ["default"] + ["published"] * options.as_published


# ----------------------------------------------------------------------------------------------------- the table

def sloppy_rows(rows: List[Row], mode: str) -> List[Row]:
    return [row for row in rows if row["mode"] == mode and row["number"] != sloppy_runs.AS_DRAWN]


def counts(name: str, rows: List[Row], modes: List[str]) -> str:
    cells = [name]
    for mode in modes:
        own = [row for row in rows if row["mode"] == mode]
        cells.append(frame.share([row["verdict"] == "as meant" for row in own]))
        cells += [str(sum(row["verdict"] == verdict for row in own)) for verdict in ("said", "wreck")]
        cells.append(str(sum(row["verdict"] == "as meant" and bool(row["said"]) for row in own)))
    return "| " + " | ".join(cells) + " |"


def table(rows: List[Row], modes: List[str]) -> str:
    sloppy = [row for mode in modes for row in sloppy_rows(rows, mode)]
    names = {row["stroke"] for row in sloppy}
    heads = [f"{MODES[m]}: as meant | said | wreck | as meant, yet warned" for m in modes]
    models = len({row["model"] for row in sloppy})
    lines = ["# Sloppy strokes", "",
             f"{len(sloppy_rows(rows, 'default'))} sloppy strokes of {len(names)} well-made ones on {models} models, pictures of "
             "800 x 600 px. As meant: the outline lies within 3 px of the stroke's middle 60 %, in the mean, and nothing in the "
             "picture changed farther than 30 px from the hull of stroke and section, nor was turned inside out.", "",
             "| strokes | " + " | ".join(heads) + " |", "|---|" + "---|" * 4 * len(modes), counts("**all**", sloppy, modes)]
    lines += [counts(f"of a {part}", [r for r in sloppy if r["part"] == part], modes) for part in ("limb", "torso")]
    for hand in (*hands.HANDS, "?"):
        own = [row for row in sloppy if row["hand"] == hand]
        lines += [counts(hand, own, modes)] if own else []
    for part in ("limb", "torso"):
        drawn = [row for row in rows if row["number"] == sloppy_runs.AS_DRAWN and row["part"] == part]
        lines += [counts(f"a {part} as drawn, not counted", drawn, modes)] if drawn else []
    lines += ["", "Medians and 90th percentiles of the mean distance of stroke and outline: " + "; ".join(
                  f"{MODES[m]} {np.median(d):.2f} and {np.percentile(d, 90):.2f} px" for m in modes
                  for d in [[row["mean"] for row in sloppy_rows(rows, m) if "mean" in row]] if d) + "."]
    for mode in modes:
        bad = [row for row in sloppy_rows(rows, mode) if row["verdict"] != "as meant"]
        lines += ["", f"## {MODES[mode]}: what went wrong", "", "| cause | wrecks | said | of torsos |", "|---|---|---|---|"]
        for cause, _ in Counter(row["cause"] for row in bad).most_common():
            own = [row for row in bad if row["cause"] == cause]
            wrecks = sum(row["verdict"] == "wreck" for row in own)
            lines.append(f"| {cause} | {wrecks} | {len(own) - wrecks} | {sum(row['part'] == 'torso' for row in own)} |")
        for verdict in ("wreck", "said"):
            lines += ["", f"## {MODES[mode]}: {verdict}", "", "| stroke | variant | mean | worst | far pixels | far points | "
                      "farthest | section covered | strays | longer | cause | said |", "|---|" + "---|" * 11]
            lines += [listed(row) for row in bad if row["verdict"] == verdict]
    return "\n".join(lines) + "\n"


def listed(row: Row) -> str:
    amounts = ", ".join(f"{name} {np.round(value, 2)}" for name, value in row["how"].items())
    figures = [frame.number(row.get(n), 1 if n == "farthest" else 2) for n in
               ("mean", "worst", "far pixels", "far points", "farthest", "covered", "strays", "longer")]
    return f"| {row['stroke']} | {row['number']} {row['hand']} ({amounts}) | " + " | ".join(
        [*figures, row["cause"], row["said"].replace("|", "/").replace("\n", " ")[:120]]) + " |"


def complaints(rows: List[Row], whole: bool) -> List[str]:
    """What does not hold."""
    own = sloppy_rows(rows, "default")
    wrecks, share = sum(row["verdict"] == "wreck" for row in own), np.mean([row["verdict"] == "as meant" for row in own])
    made, models = len({row["stroke"] for row in own}), len({row["model"] for row in own})
    found = [f"{wrecks} strokes are wrecks and nothing says so"] if wrecks else []
    found += [f"{100 * share:.1f} % of the strokes do as meant, not {100 * REQUIRED:.0f} %"] if share < REQUIRED else []
    if whole and (len(own) < STROKES or made < LEAST_WELL_MADE or models < LEAST_MODELS):
        found.append(f"only {len(own)} strokes of {made} well-made ones on {models} models")
    return found


# ------------------------------------------------------------------------------------------------------- the whole

def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--variants", type=int, default=10)
    parser.add_argument("--as-published", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--sheets", action="store_true")
    parser.add_argument("--limit", type=float, default=180)
    parser.add_argument("--make", type=int, help=argparse.SUPPRESS)  # a worker: number of the model
    parser.add_argument("--model", help=argparse.SUPPRESS)  # another: name of the model
    parser.add_argument("--skip", type=int, default=0, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if not importlib.util.find_spec("oversketch"):
        parser.error("no Python package oversketch; a build has it in build/release/lib/python3/dist-packages, "
                     "which PYTHONPATH must name")
    return options


def main() -> int:
    options = arguments()
    folder, pictures = options.out / "strokes", options.out / "wrecks"
    if options.make is not None:
        print(json.dumps(sloppy_runs.make(folder, options.make, *meshes.models()[options.make])))
        return 0
    index = make_all(folder, options.jobs)
    index = [entry for entry in index if not options.only or any(part in entry["name"] for part in options.only)]
    by_model = {model: [e for e in index if e["model"] == model] for model in dict.fromkeys(e["model"] for e in index)}
    if options.sheets:
        pictures.mkdir(parents=True, exist_ok=True)
    if options.model:
        entries = by_model[options.model]
        runs = sloppy_runs.runs_of(entries, options.variants, modes_of(options))[options.skip:]
        sloppy_runs.work(folder, entries, runs, pictures if options.sheets else None)
        return 0

    with ThreadPoolExecutor(options.jobs) as pool:
        rows = [row for rows in pool.map(lambda entries: one_model(options, entries), by_model.values()) for row in rows]
    (options.out / "results.json").write_text(json.dumps(rows, indent=1))
    text = table(rows, modes_of(options))
    (options.out / "table.md").write_text(text)
    print("\n" + text)
    if options.sheets:
        wrecks = [pictures / f"{row['stroke']}-{row['number']}.png" for row in rows
                  if row["mode"] == "default" and row["verdict"] == "wreck"]
        sheets.write([picture.load(file) for file in wrecks if file.is_file()], options.out / "sheet-wrecks", columns=2, rows=5)
    failed = complaints(rows, not options.only)
    print("\n".join(f"FAILS: {text}" for text in failed) or "all bounds hold")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
