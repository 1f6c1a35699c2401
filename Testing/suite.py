#!/usr/bin/env python3
"""Runs parts of the tests, prints one line each with its time, and in the end a table: parts, seconds, the ten longest tests.

usage: suite.py                the parts of each commit
       suite.py full           all parts; begun again where an earlier run of the same sources stopped
       suite.py PART...        these, whether they have passed before or not
       suite.py list           names them

The table is written to build/times.json and compared with the last one. A part's log is build/logs/PART.log. Exit code 1 where a part
fails: those of each commit stop there, a full run goes on with the next part.
"""
import datetime
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import time
import xml.etree.ElementTree as tree

ROOT = pathlib.Path(__file__).resolve().parents[1]
LOGS, TIMES, PASSED = (ROOT / "build" / name for name in ("logs", "times.json", "full.json"))
TODAY = int(os.environ.get("OVERSKETCH_SEED") or datetime.date.today().strftime("%Y%m%d"))
SANITIZER = {"ASAN_OPTIONS": "detect_leaks=0:allocator_may_return_null=1:use_sigaltstack=0", "UBSAN_OPTIONS": "print_stacktrace=1"}
ALL = "-DOVERSKETCH_ALL_TESTS="
JOBS = f"-j{os.cpu_count() + 1}"  # one more than there are processors, as a window waits now and then
DRAWN = {"LP_NUM_THREADS": "0"}  # Mesa's own threads would only take turns with the other tests
HOSTILE = ("random_chains_test", "hostile_drawings_test", "hostile_edit_test", "hostile_meshes_test")
# Tests that take longest and are left out for a commit, others each day.
LEFT_OUT = (("studio_drawings", "acceptance_judge_inflate", "data"), ("studio_parts", "studio_lines", "acceptance_judge_edit", "chain_test_1"),
            ("studio_edits", "studio_dense", "augment_pictures", "kernel_mixture_test"))[TODAY % 3]
LEFT_OUT += tuple(f"studio_reach_{i}" for i in range(6) if i != TODAY % 6)
# The share of each system's acceptance runs that holds all bounds, at least: in all of them, where it is not what the run itself asks
# for, and in a tenth, which has fewer to miss by.
LEAST = {"edit": (0.7, 0.5), "inflate": (None, 0.7), "one_stroke": (None, 0.85), "augment": (None, 0.85)}  # the longest first
ACCEPTED = {"PYTHONPATH": "build/release/lib/python3/dist-packages", "OVERSKETCH_COMMAND": "build/release/bin/oversketch"}
DATA = pathlib.Path(os.environ.get("OVERSKETCH_DATA", ROOT / ".." / "shared" / "data"))


def built(preset, targets="all tests", every="OFF"):
    return f"cmake --preset {preset} {ALL}{every} && cmake --build --preset {preset} --target {targets}"


def side_by_side(commands):
    """As many of them at once as there are processors; fails where one does."""
    return f"printf '%s\\n' {' '.join(map(shlex.quote, commands))} | xargs -d '\\n' -P {os.cpu_count()} -I {{}} bash -c {{}}"


def acceptance(tenth):
    """The runs whose pictures and models are there; the models that are shipped serve for three. For each commit two of the four, in turn."""
    systems = [name for number, name in enumerate(LEAST) if not tenth or number % 2 == TODAY % 2]
    systems = [name for name in systems if name != "inflate" or (DATA / "images").is_dir()]
    systems += [] if tenth else ["situations"]  # whose own test runs some for each commit
    return side_by_side(
        f"/usr/bin/python3 Testing/Acceptance/{name}/accept.py build/acceptance/{'tenth/' if tenth else ''}{name} --workers 1"
        + (f" --least {LEAST[name][tenth]}" if LEAST.get(name, (None, None))[tenth] else "")
        + (f" --tenth {TODAY} --modes default --no-pictures" if tenth else "") for name in systems)


# Leaks are not counted: VTK, PoCL and Mesa keep memory until the process ends. No stack for signals: LLVM puts its own into threads in
# which it compiles, and the sanitizer would end the process over it. Under tsan VTK's own threads: TBB's locks are in a library that the
# sanitizer does not see into.
SHORT = {
    "build": (built("release"), {}),
    "demo": ("env -u PYTHONPATH ./Applications/demo.sh", {}),
    "tests": (f"ctest --preset release -L home {JOBS} -E '^({'|'.join(LEFT_OUT)})$'", DRAWN),
    "acceptance": (acceptance(True), ACCEPTED),
    "asan-build": (built("asan", "tests"), {}),
    "asan-tests": (f"ctest --preset asan -L home {JOBS} -E '^hostile_.*_[{('12', '34')[TODAY % 2]}]$'", SANITIZER),  # two of four parts, in turn
}
FULL = {
    "all-build": (built("release", "all tests benchmarks", "ON"), {}),
    "all-tests": (f"ctest --preset release {JOBS}", DRAWN),
    "all-asan-build": (built("asan-full", "tests", "ON"), {}),
    "all-asan-tests": (f"ctest --preset asan-full {JOBS}", SANITIZER),
    "plain": ("cmake --preset plain && cmake --build --preset plain --target all tests", {}),
    "lto": ("cmake --preset lto && cmake --build --preset lto -- -k 0", {}),
    "paraview": ("Testing/ParaView/test.sh", {}),
    "packages-12": ("Testing/packages.sh bookworm build/roots", {}),
    "packages-13": ("Testing/packages.sh trixie build/roots", {}),
    "random": ("Testing/random.sh 1000", {}),
    "hostile": (f"{built('asan-full', ' '.join(HOSTILE), 'ON')} && {side_by_side(f'build/asan-full/bin/{name}' for name in HOSTILE)}",
                {**SANITIZER, "OVERSKETCH_CHAINS": "300", "OVERSKETCH_DRAWINGS": "1000", "OVERSKETCH_HOSTILE_VALUES": "all", "OVERSKETCH_EDITS": "40"}),
    "all-acceptance": (acceptance(False), ACCEPTED),
    "tidy": ("Testing/tidy.sh", {}),
    "tsan": (f"{built('tsan', 'tests')} && ctest --preset tsan -L home {JOBS}",
             {"VTK_SMP_BACKEND_IN_USE": "STDThread", "TSAN_OPTIONS": f"suppressions={ROOT}/Testing/tsan.supp"}),
    "oclgrind": ("Testing/oclgrind.sh", {}),
    "fuzz": ("Testing/fuzz.sh 600s", {}),
}
PARTS = {**SHORT, **FULL}


def sources():
    """A digest of the files of the tree: those that git knows, as they are, else all but what is built."""
    try:
        listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT, check=True, capture_output=True)
        names = listed.stdout.decode().split("\0")[:-1]
    except (OSError, subprocess.CalledProcessError):  # there is no git, or the tree is none of its
        names = [str(p.relative_to(ROOT)) for p in ROOT.rglob("*") if p.is_file() and p.relative_to(ROOT).parts[0] != "build"]
    digest = hashlib.sha256()
    for name in sorted(names):
        path = ROOT / name
        digest.update(name.encode() + b"\0" + (path.read_bytes() if path.is_file() else b"") + b"\0")
    return digest.hexdigest()


def seconds_of_tests(since):
    """{test: seconds} of what GoogleTest and pytest have written since then."""
    found = {}
    for file in ROOT.glob("build/*/Testing/times/*"):
        if file.stat().st_mtime < since:
            continue
        preset = file.parents[2].name
        try:
            if file.suffix == ".json":
                for suite in json.loads(file.read_text())["testsuites"]:
                    for test in suite["testsuite"]:
                        found[f"{preset} {test['classname']}.{test['name']}"] = float(test["time"].rstrip("s"))
            else:
                for test in tree.parse(file).iter("testcase"):
                    found[f"{preset} {file.stem} {test.get('name')}"] = float(test.get("time"))
        except (ValueError, KeyError, tree.ParseError):
            print(f"no times in {file.relative_to(ROOT)}", file=sys.stderr)
    return found


def run(name, full):
    """The exit code and the seconds of a part."""
    command, variables = PARTS[name]
    if full or (name in FULL and name != "paraview"):  # which is asked for by name for a commit
        variables = {"OVERSKETCH_FULL": "1", **variables}
    LOGS.mkdir(parents=True, exist_ok=True)
    log = LOGS / f"{name}.log"
    began = time.time()
    with log.open("w") as out:
        code = subprocess.run(["bash", "-c", command], cwd=ROOT, stdout=out, stderr=subprocess.STDOUT,
                              env={"OVERSKETCH_SEED": str(TODAY), **os.environ, **variables}).returncode
    took = time.time() - began
    text = log.read_text(errors="replace")
    told = re.findall(r"^\d+% tests passed, .*|^Total Test time.*", text, re.M)
    print(f"{name:15} {took:7.0f} s  {'passed' if code == 0 else 'FAILED'}  {told[0] if told else ''}", flush=True)
    if code != 0:
        causes = re.findall(r"^.*: Failure\n(?:.*\n){4}|^E  .*\n", text, re.M)  # GoogleTest's and pytest's
        print("".join(causes[:20]) + "\n".join(text.splitlines()[-60:]) + f"\nlog: {log.relative_to(ROOT)}", file=sys.stderr)
    return code, took


def table(parts, tests):
    """Prints the times beside the last ones, and keeps them."""
    last = json.loads(TIMES.read_text()) if TIMES.exists() else {"parts": {}, "tests": {}}

    def row(name, now, before):
        return f"  {name[:100]:100} {now:7.1f} s" + (f"  {now - before:+7.1f} s" if before is not None else "")
    print("\nParts, and the difference to the last run:")
    for name, took in parts.items():
        print(row(name, took, last["parts"].get(name)))
    print(row("together", sum(parts.values()), None))
    print("The ten longest tests:")
    for name, took in sorted(tests.items(), key=lambda each: -each[1])[:10]:
        print(row(name, took, last["tests"].get(name)))
    TIMES.write_text(json.dumps({"parts": {**last["parts"], **parts}, "tests": {**last["tests"], **tests}}, indent=1))


def main(asked):
    if asked == ["list"]:
        print("\n".join([*SHORT, "", *FULL]))
        return 0
    names = list(SHORT) if not asked else [n for n in PARTS if n not in ("tests", "acceptance", "asan-build", "asan-tests")] if asked == ["full"] else asked
    unknown = [name for name in names if name not in PARTS]
    if unknown:
        print(f"suite.py: there is no part {', '.join(unknown)}; parts: {', '.join(PARTS)}", file=sys.stderr)
        return 2
    state = {"sources": sources(), "passed": []}
    if asked == ["full"]:
        if PASSED.exists() and (known := json.loads(PASSED.read_text()))["sources"] == state["sources"]:
            state = known
    print(f"seed of the day: {TODAY}", flush=True)
    began, parts, failed = time.time(), {}, []
    for name in names:
        if name in state["passed"]:
            print(f"{name:15}            passed before", flush=True)
            continue
        code, parts[name] = run(name, asked == ["full"])
        if code != 0:
            failed.append(name)
            if asked != ["full"]:
                break
        elif asked == ["full"]:
            state["passed"].append(name)
            PASSED.write_text(json.dumps(state))
    table(parts, seconds_of_tests(began))
    if failed:
        print("failed: " + ", ".join(failed), file=sys.stderr)
    print(f"{len(parts) - len(failed)} passed, {len(failed)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
