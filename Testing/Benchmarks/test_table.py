"""The table of the benchmarks: medians, ratios, what was to be reached and what was missed, from results made up here."""
import json
import os
import re
import subprocess
import sys

import pytest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import table


def repetitions(name, times, **figures):
    return [{"name": name, "run_type": "iteration", "real_time": ms, "threads": 2, **figures} for ms in times]


@pytest.fixture
def made(tmp_path):
    rows = []
    rows += repetitions("SDF Embree/180k/ours", [12, 10, 11, 300, 9])
    rows += repetitions("SDF Embree/180k/limit", [10, 10, 10, 10, 10])
    rows += repetitions("SDF Embree/180k/CGAL sdf_values", [440] * 5)
    rows += repetitions("SDF Embree/1M/ours", [11 * 1280 / 180 * 1.2] * 5)
    rows += repetitions("silhouette/30k/ours", [0.1] * 5)
    rows += repetitions("silhouette/30k/limit", [0.04] * 5)
    rows += repetitions("silhouette/30k/vtkPolyDataSilhouette", [20] * 5)
    rows += repetitions("first stroke/30k/ours", [1] * 5, Match_peak=10, Match_kept=5, process_gib=0.5)
    rows += repetitions("augment: new stroke/30k/ours", [25] * 5, limit_ms=30, snap_share=0.4)
    rows += repetitions("augment: new stroke/180k/ours", [150] * 5, limit_ms=120, snap_share=0.7)
    rows += repetitions("first augmentation/1M/ours", [900] * 5, process_gib=1.2)
    (tmp_path / "programs.json").write_text(json.dumps({"context": {}, "benchmarks": rows}))
    (tmp_path / "peers.json").write_text(json.dumps([{"name": "SDF Embree/180k/libigl", "real_time": 22.0, "threads": 2}]))
    rows = table.gather(table.read(str(tmp_path)))
    return rows, table.markdown(rows, "Commit 0123abc, 2026-01-02.")


def line(text, start):
    return next(row for row in text.splitlines() if row.startswith(start))


def test_medians_and_ratios(made):
    rows, text = made
    row = next(row for row in rows if (row["job"], row["size"]) == ("SDF Embree", "180k"))
    assert row["ours_ms"] == 11 and row["limit_ms"] == 10 and row["threads"] == 2
    assert row["peers"] == {"CGAL sdf_values": 440, "libigl": 22}
    assert "| libigl 22 | 10 | 0.50 | 1.10 |" in line(text, "| SDF Embree | 180k")


def test_says_what_was_missed(made):
    shape, silhouette = line(made[1], "| SDF Embree | 180k"), line(made[1], "| silhouette | 30k")
    assert "missed" not in shape and "CGAL 1/40" in shape
    assert "vtkPolyDataSilhouette 1/200 (at most 1/100)" in silhouette
    assert "limit 2.50 (at most 2.00) **missed**" in silhouette


def test_says_where_the_cost_is_not_linear(made):
    last = [row for row in made[1].splitlines() if row.startswith("| SDF Embree |")][-1]
    assert last.endswith("| 1.20 **missed** |")


def test_memory(made):
    assert "| Match | 10 / 5 |" in made[1] and "| whole process | 0.50 GiB |" in made[1]


def test_the_page_says_of_which_run_it_is(made):
    assert "\nCommit 0123abc, 2026-01-02.\nMachine: " in made[1]
    # The page that is committed is one that the program wrote: nothing stands before or between its tables that is not its own.
    with open(os.path.join(HERE, "RESULTS.md")) as file:
        page = file.read()
    run = re.search(r"^Commit \w+, \d{4}-\d\d-\d\d\.$", page, re.M).group()
    own = [each for each in made[1].replace("Commit 0123abc, 2026-01-02.", run).splitlines() if not each.startswith(("|", "Machine: "))]
    assert [each for each in page.splitlines() if not each.startswith(("|", "Machine: "))] == own


def test_an_empty_folder_is_refused(tmp_path):
    run = subprocess.run([sys.executable, os.path.join(HERE, "table.py"), str(tmp_path)], capture_output=True, text=True)
    assert run.returncode == 1 and "holds no results" in run.stderr


def test_augmentation(made):
    text = made[1]
    assert "missed" not in line(text, "| augment: new stroke | 30k |") and "limit 1.25 (at most 1.00) **missed**" in \
        line(text, "| augment: new stroke | 180k |")
    shares = [row for row in text.splitlines() if row.startswith("| snapping's share")]
    assert [row.endswith("| 0.6 |") for row in shares] == [True, False] and shares[1].endswith("0.70 | 0.6 **missed** |")
    assert line(text, "| memory of the whole process") == "| memory of the whole process [GiB] | 1M | 1.20 | 1.5 |"
