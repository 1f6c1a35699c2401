#!/usr/bin/env python3
"""Compares the tests of two commits, or of one and the tree: C++ tests by suite and name, Python tests by file and name.

usage: kept.py BEFORE [AFTER]      exit code 1 where a test of BEFORE is nowhere in AFTER

A test of the same name in another file or suite is told as moved; one whose name has changed as gone and as new.
"""
import collections
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
CXX = re.compile(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST)\((\w+),\s*(\w+)\)", re.M)
PYTHON = re.compile(r"^(?:    )?def (test_\w+)\(", re.M)


def git(*command):
    return subprocess.run(["git", "-C", str(ROOT), *command], check=True, capture_output=True, text=True).stdout


def texts(commit):
    """(path, text) of the files that may hold tests."""
    if commit is None:
        listed = git("ls-files", "--cached", "--others", "--exclude-standard").splitlines()
        return [(n, (ROOT / n).read_text()) for n in listed if n.endswith((".cxx", ".py", ".h")) and (ROOT / n).is_file()]
    listed = [n for n in git("ls-tree", "-r", "--name-only", commit).splitlines() if n.endswith((".cxx", ".py", ".h"))]
    return [(n, git("show", f"{commit}:{n}")) for n in listed]


def tests(commit):
    """{test: files that it stands in}."""
    found = collections.defaultdict(list)
    for path, text in texts(commit):
        for suite, name in CXX.findall(text):
            found[f"{suite}.{name}"].append(path)
        if pathlib.Path(path).name.startswith("test_"):
            for name in PYTHON.findall(text):
                found[f"{pathlib.Path(path).stem}.{name}"].append(path)
    return found


def main(before, after=None):
    old, new = tests(before), tests(after)
    fewer = {name for name in old if len(new.get(name, [])) < len(old[name])}
    more = {name for name in new if len(old.get(name, [])) < len(new[name])}
    heirs = {name: next((other for other in sorted(more) if other.split(".")[1] == name.split(".")[1]), None) for name in fewer}
    gone = sorted(name for name in fewer if heirs[name] is None)
    for name in gone:
        print(f"gone   {name}: {', '.join(old[name])}")
    for name in sorted(more - set(heirs.values())):
        print(f"new    {name}: {', '.join(new[name])}")
    for name, heir in sorted((name, heir) for name, heir in heirs.items() if heir):
        print(f"moved  {name}: {', '.join(old[name])} -> {heir}: {', '.join(new[heir])}")
    for name in sorted(name for name in old if name in new and name not in fewer and not set(old[name]) <= set(new[name])):
        print(f"moved  {name}: {', '.join(old[name])} -> {', '.join(new[name])}")
    print(f"{sum(map(len, old.values()))} tests before, {sum(map(len, new.values()))} after; {len(gone)} gone")
    return 1 if gone else 0


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
