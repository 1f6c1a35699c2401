#!/usr/bin/env python3
"""Makes the table of the benchmarks: every job and size, ours, the best peer, the limit, and what was to be reached.

usage: table.py FOLDER
FOLDER holds what the programs and peers.py wrote (*.json), and the commit and the day of the run (run.txt). Writes FOLDER/benchmarks.json
(a list of objects: job, size, threads, ours_ms, peers {name: ms}, limit_ms), FOLDER/benchmarks.md, the page RESULTS.md, and
FOLDER/benchmarks.png (cost against size).
"""
import glob
import json
import os
import platform
import statistics
import sys

# What is to be reached: job, against whom, ours at most this many times theirs, at these sizes (None: all).
REACH = [
    ("SDF Embree", "limit", 1.10, None),
    ("SDF Embree", "CGAL", 1 / 40, None),
    ("SDF OpenCL", "limit", 1.25, None),
    ("BVH build", "Embree", 2.0, ["180k"]),
    ("greedy EM", "scikit-learn", 1 / 50, None),
    ("greedy EM", "CGAL", 1 / 10, None),
    ("greedy EM", "limit", 2.5, None),
    ("silhouette", "vtkPolyDataSilhouette", 1 / 100, ["30k", "180k"]),
    ("silhouette", "limit", 2.0, ["30k", "180k"]),
    ("curves", "redraw", 1.0, ["30k", "180k"]),
    ("region and border", "limit", 1.0, ["180k"]),
    ("Laplacian factor", "Eigen", 0.8, None),
    ("Laplacian factor", "CHOLMOD", 0.8, None),
    ("Laplacian solve", "Eigen", 0.3, None),
    ("Laplacian solve", "libigl", 0.3, None),
    ("Laplacian solve", "CHOLMOD", 0.7, ["45k"]),
    ("Laplacian drag", "Eigen", 1 / 300, None),
    ("adjusted normals", "plain form", 4.0, None),
    ("handle's drag to points and normals", "limit", 1.0, None),
    ("layer drag", "limit", 1.0, None),
    ("grey model", "limit", 1.0, None),
    ("new triangles", "limit", 1.0, None),
    ("new triangles", "CGAL", 1 / 5, None),
    ("disc", "Eigen", 1.0, None),
    ("disc", "CGAL", 1.0, None),
    ("disc", "libigl", 1.0, None),
    ("distance", "CGAL", 1 / 3, None),
    ("distance", "potpourri3d", 1 / 3, None),
    ("cross-section, plane slid", "vtkPlaneCutter", 1 / 50, None),
    ("region's exponentials", "Eigen", 1 / 10, None),
    ("remeshing", "CGAL", 1 / 5, ["30k", "180k"]),
    ("joining", "CGAL", 1 / 3, ["180k"]),
    ("one stroke", "limit", 3.0, ["30k", "180k"]),
    ("next stroke", "limit", 3.0, ["30k", "180k"]),
    ("edge splits", "limit", 1.0, None),
    ("4-8 mesh from arrays", "limit", 1.0, None),
    ("4-8 mesh to arrays", "limit", 1.0, None),
    ("4-8 base", "limit", 1.0, None),
    ("augment: new stroke", "limit", 1.0, ["30k", "180k", "1M"]),
    ("augment: new radius", "limit", 1.0, ["30k", "180k"]),
    ("augment: new height", "limit", 1.0, ["30k", "180k"]),
    ("augment: crest under the pen", "limit", 1.0, None),
    ("path along edges", "OpenCV's map", 1 / 50, None),
    ("local maximum", "the distance", 1.0, None),
    ("grid factor", "Eigen", 1 / 2, None),
    ("refinement", "CGAL", 1.0, None),
    ("triangulation", "CGAL", 1.0, None),
    ("constrained triangulation", "CGAL", 1.0, None),
    ("drawing: new", "limit", 1.0, None),
    ("ten million: proxy", "limit", 1.0, None),
    ("ten million: first stroke on the proxy", "limit", 1.0, None),
    ("ten million: exact result", "limit", 1.0, None),
    ("drawing: another feature", "limit", 1.0, None),
]
# Jobs whose cost should grow with the model: from 180k to the million, per triangle, at most by this factor.
LINEAR = {"SDF Embree": 1.15, "SDF OpenCL": 1.15, "BVH build": 1.15, "silhouette": 1.15, "curves": 1.15,
          "region and border": 1.15, "remeshing": 1.15}
SNAP_SHARE = 0.6  # of refining, snapping and displacing, at most; the paper's own 0.8 to 0.96
SPLIT_BYTES, PEAK_GIB = 160, 1.5  # of an edge split, and of a process that augments the million
TRIANGLES = {"5k": 5000, "30k": 29996, "180k": 180000, "1M": 1280000}


def read(folder):
    """(job, size, who) -> {ms, threads, figures}, in the order of the files."""
    sides = {}
    for path in sorted(glob.glob(os.path.join(folder, "*.json"))):
        if os.path.basename(path) == "benchmarks.json":
            continue
        with open(path) as file:
            rows = json.load(file)
        runs = {}
        for row in rows["benchmarks"] if isinstance(rows, dict) else rows:
            if row.get("run_type", "iteration") == "iteration" and "real_time" in row:
                runs.setdefault(tuple(row["name"].split("/")[:3]), []).append(row)
        own = {"name", "run_name", "run_type", "real_time", "cpu_time", "iterations", "repetitions", "repetition_index",
               "threads", "time_unit", "family_index", "per_family_instance_index"}
        for side, repetitions in runs.items():
            figures = {key: value for key, value in repetitions[-1].items()
                       if key not in own and isinstance(value, (int, float))}
            sides[side] = {"ms": statistics.median(row["real_time"] for row in repetitions),
                           "threads": int(repetitions[-1].get("threads", 1)), "figures": figures}
    return sides


def gather(sides):
    rows = []
    for job, size, who in sides:
        if who != "ours":
            continue
        others = {w: s["ms"] for (j, z, w), s in sides.items() if (j, z) == (job, size) and w != "ours"}
        ours = sides[job, size, who]
        row = {"job": job, "size": size, "threads": ours["threads"], "ours_ms": ours["ms"],
               "peers": {w: ms for w, ms in others.items() if w != "limit" and not w.startswith("ours")},
               "limit_ms": others.get("limit", ours["figures"].get("limit_ms"))}
        row["variants"] = {w: ms for w, ms in others.items() if w.startswith("ours")}
        row["figures"] = {w: s["figures"] for (j, z, w), s in sides.items() if (j, z) == (job, size) and s["figures"]}
        rows.append(row)
    rows.sort(key=lambda row: (row["job"], order(row["size"])))
    stroke_limits(rows)
    return rows


def stroke_limits(rows):
    """A stroke's limit is the sum of its stages': what to reach of a stage where it was set against a peer, its measured
    limit where there is one, each for the part of the model that the stage works on."""
    by_name = {(row["job"], row["size"]): row for row in rows}

    def best(row, *names):
        return min((ms for who, ms in row["peers"].items() if who.startswith(names)), default=None)

    for row in rows:
        job, _, kind = row["job"].partition(",")
        if job not in ("one stroke", "next stroke"):
            continue
        counts, size, parts = row["figures"]["ours"], row["size"], {}
        remeshing, mixture = by_name.get(("remeshing", size)), by_name.get(("greedy EM", "2048"))
        region, curves = by_name.get(("region and border", size)), by_name.get(("curves", size))
        systems = [r for r in rows if r["job"] == "Laplacian factor"]
        if not kind:
            cgal = best(remeshing, "CGAL") if remeshing else None
            parts["remeshing"] = cgal and (cgal / 5 / TRIANGLES[size] *
                                           (counts["region_triangles"] + counts["stretched_triangles"]))
        if systems:
            unknowns = counts["stretched_triangles"] / 2 if not kind else counts["region_points"]
            nearest = min(systems, key=lambda r: abs(1000 * order(r["size"]) - unknowns))
            peer = best(nearest, "Eigen", "CHOLMOD")
            parts["deformation"] = peer and 0.8 * peer * unknowns / (1000 * order(nearest["size"]))
        parts["mixtures"] = mixture and mixture["limit_ms"]
        parts["region"] = region and region["limit_ms"]
        parts["outline of the result"] = curves and best(curves, "redraw")
        if job == "next stroke":
            for name, stage in (("shape diameter", "SDF Embree"), ("silhouette", "silhouette")):
                limit = by_name.get((stage, size))
                # The mesh before had most of its rays: only the others have to be cast.
                part = counts.get("new_rays", 1.0) if name == "shape diameter" else 1.0
                parts[name] = limit and limit["limit_ms"] * part
            parts["curves"] = parts["outline of the result"]
        row["limit_parts"] = parts
        if all(parts.values()):
            row["limit_ms"] = sum(parts.values())


def order(size):
    number = size.rstrip("kM")
    return TRIANGLES.get(size) or (float(number) if number.replace(".", "").isdigit() else 0)


def time(ms):
    return "–" if ms is None else f"{ms:.3g}" if ms < 1000 else f"{ms:,.0f}"


def ratio(value):
    """Ours over theirs; where ours is the smaller, how many times."""
    return f"{value:.2f}" if value > 0.2 else f"1/{1 / value:.0f}" if value < 0.1 else f"1/{1 / value:.1f}"


def reached(row):
    lines = []
    for job, other, factor, sizes in REACH:
        if job != row["job"] or (sizes and row["size"] not in sizes):
            continue
        names = ["limit"] if other == "limit" else [name for name in row["peers"] if name.startswith(other)]
        times = [row["limit_ms"] if name == "limit" else row["peers"][name] for name in names]
        times = [ms for ms in times if ms]
        if not times:
            lines.append((other, None, factor, False))
            continue
        value = row["ours_ms"] / min(times)
        lines.append((other, value, factor, value <= factor))
    return lines


def quality(row):
    """How good ours is, where it says so: what is off, in percent or px, and angles."""
    return [f"{name.replace('_percent', ' [%]').replace('_', ' ')} {time(value)}" for name, value in row["figures"].get("ours", {}).items()
            if name.endswith(("_percent", "_px")) or name.startswith(("angle_", "apart_"))]


def machine():
    model = platform.processor()
    with open("/proc/cpuinfo") as file:
        for line in file:
            if line.startswith("model name"):
                model = line.split(":")[1].strip()
    return f"{model}, {os.cpu_count()} cores, {platform.freedesktop_os_release().get('PRETTY_NAME', platform.platform())}"


def markdown(rows, run):
    lines = ["# Benchmarks", "", "Written by `Testing/Benchmarks/table.py` from what one run of `Testing/Benchmarks/run.sh` measured.",
             "[What was tried for speed and did not help](../../Documentation/tried.md) is a page of its own.", "",
             f"{run}", f"Machine: {machine()}.", "",
             "Times are medians of five runs or more [ms]; those of all sides of a job are taken in turn. Ratios hold within a run only.", "",
             "| job | size | ours | best peer | limit | ours / peer | ours / limit | to be reached |",
             "|---|---|---|---|---|---|---|---|"]
    for row in rows:
        peer = min(row["peers"].items(), key=lambda item: item[1], default=None)
        goals = "; ".join(f"{other} {'not run' if value is None else ratio(value)} "
                          f"(at most {ratio(factor)}){'' if held or value is None else ' **missed**'}"
                          for other, value, factor, held in reached(row))
        goals = "; ".join([goals] * bool(goals) + [f"{who}: {time(ms)}" for who, ms in row["variants"].items()] + quality(row))
        lines.append("| {} | {} | {} | {} | {} | {} | {} | {} |".format(
            row["job"], row["size"], time(row["ours_ms"]), f"{peer[0]} {time(peer[1])}" if peer else "–",
            time(row["limit_ms"]), ratio(row["ours_ms"] / peer[1]) if peer else "–",
            ratio(row["ours_ms"] / row["limit_ms"]) if row["limit_ms"] else "–", goals or "–"))
    lines += ["", "| job | ns a triangle at " + " | ".join(TRIANGLES) + " | 1M / 180k |", "|---" * (len(TRIANGLES) + 2) + "|"]
    for job in dict.fromkeys(row["job"] for row in rows):
        cost = {row["size"]: 1e6 * row["ours_ms"] / TRIANGLES[row["size"]] for row in rows
                if row["job"] == job and row["size"] in TRIANGLES}
        if len(cost) > 1:
            growth = cost["1M"] / cost["180k"] if "1M" in cost and "180k" in cost else None
            missed = " **missed**" if growth and growth > LINEAR.get(job, 1e9) else ""
            lines.append(f"| {job} | " + " | ".join(f"{cost[s]:.1f}" if s in cost else "–" for s in TRIANGLES) +
                         f" | {f'{growth:.2f}{missed}' if growth else '–'} |")
    memory = {row["size"]: row["figures"]["ours"] for row in rows if row["job"] == "first stroke"}
    stages = list(dict.fromkeys(key[:-5] for figures in memory.values() for key in figures if key.endswith("_peak")))
    if stages:
        lines += ["", "Memory of the first stroke, remeshed, bytes a triangle of the model: taken for a while / held after.", "",
                  "| stage | " + " | ".join(memory) + " |", "|---" * (len(memory) + 1) + "|"]
        for stage in stages:
            lines.append(f"| {stage} | " + " | ".join(f"{f[stage + '_peak']:.0f} / {f[stage + '_kept']:.0f}" if stage + "_peak" in f
                                                      else "–" for f in memory.values()) + " |")
        lines.append("| whole process | " + " | ".join(f"{f['process_gib']:.2f} GiB" for f in memory.values()) + " |")
    lines += augmentation(rows)
    return "\n".join(lines) + "\n"


def augmentation(rows):
    """What of system D is no time: shares, bytes, memory, each beside what was to be reached."""
    lines = []
    for job, figure, text, reach in (("augment: new stroke", "snap_share", "snapping's share of the three stages' time", SNAP_SHARE),
                                     ("edge splits", "bytes_a_split", "bytes of an edge split", SPLIT_BYTES),
                                     ("first augmentation", "process_gib", "memory of the whole process [GiB]", PEAK_GIB)):
        known = {row["size"]: row["figures"]["ours"][figure] for row in rows
                 if row["job"] == job and figure in row["figures"].get("ours", {})}
        for size, value in known.items():
            missed = " **missed**" if value > reach else ""
            lines.append(f"| {text} | {size} | {value:.2f} | {reach}{missed} |")
    return ["", "| augmentation | size | ours | at most |", "|---|---|---|---|"] + lines if lines else []


def picture(rows, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(11, 6))
    jobs = [job for job in dict.fromkeys(row["job"] for row in rows)
            if sum(row["job"] == job and row["size"] in TRIANGLES for row in rows) > 1]
    colours = pyplot.get_cmap("tab20")
    shade = lambda k: colours((2 * k + k // 10) % 20)  # the ten dark ones, then the pale, then again with squares
    for k, job in enumerate(jobs):
        mine = sorted((TRIANGLES[row["size"]], row["ours_ms"], row["limit_ms"] or min(row["peers"].values(), default=None))
                      for row in rows if row["job"] == job and row["size"] in TRIANGLES)
        axes.loglog([m[0] for m in mine], [m[1] for m in mine], "os"[k // 20 % 2] + "-", color=shade(k), label=job)
        bound = [(m[0], m[2]) for m in mine if m[2]]
        axes.loglog([b[0] for b in bound], [b[1] for b in bound], ":", color=shade(k), linewidth=1)
    axes.set_xlabel("triangles")
    axes.set_ylabel("milliseconds")
    axes.set_title("Cost against size (dotted: the limit, or the best peer where no limit was measured)", fontsize=10)
    axes.set_xticks(list(TRIANGLES.values()), list(TRIANGLES))
    axes.minorticks_off()
    axes.grid(True, which="major", alpha=0.3)
    axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5))
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = sys.argv[1]
    rows = gather(read(folder))
    if not rows:
        sys.exit(f"table.py: {folder} holds no results")
    with open(os.path.join(folder, "benchmarks.json"), "w") as file:
        json.dump(rows, file, indent=1)
    with open(os.path.join(folder, "run.txt")) as file:
        page = markdown(rows, file.read().strip())
    with open(os.path.join(folder, "benchmarks.md"), "w") as file:
        file.write(page)
    picture(rows, os.path.join(folder, "benchmarks.png"))
    print(page, end="")


if __name__ == "__main__":
    main()
