#!/usr/bin/env python3
"""Keeps the pages of Testing/Facts true: which test proves which checkable fact of a system, and the figure it reached.

    facts.py BUILD            runs the tests of the facts in a release build with OVERSKETCH_ALL_TESTS and writes their tests and figures into the pages
    facts.py BUILD --check    exit code 1 when the pages do not list exactly the facts and tests that there are

A page is a system's, Facts/A.md that of system A; a row of its table says what holds and is written by hand, its last two
cells by this. A fact's test is named after system, stage and place, A3_2 for the second of stage 3 of system A, and reports its
figure in a line "FACT A3_2 | text". The check looks at facts and tests, not at figures: their last digits belong to a machine.
"""
import os
import pathlib
import re
import subprocess
import sys

PAGES = pathlib.Path(__file__).with_name("Facts")
FACT = r"[A-Z]\d+_\d+"
ROW = re.compile(rf"^\| ({FACT}) \| (.*?) \| (.*?) *\| (.*?) *\|$", re.M)


def order(name):
    return [int(n) for n in re.findall(r"\d+", name)]


class Page:
    """A system's facts: {name: what holds}, and what the page lists of each: {name: (tests, figure)}."""

    def __init__(self, path):
        self.path, self.text = path, path.read_text()
        rows = ROW.findall(self.text)
        self.facts = {name: holds for name, holds, _, _ in rows}
        self.listed = {name: (sorted(re.findall(r"`([^`]+)`", tests)), figure) for name, _, tests, figure in rows}
        if len(self.facts) != len(rows) or any(name[0] != path.stem for name in self.facts):
            sys.exit(f"{path.name} has a fact twice, or one of another system")

    def wrong(self, tests):
        """What of the page is not as the build has it."""
        for name, (names, figure) in self.listed.items():
            if name in tests and names != tests[name]:
                yield f"{self.path.name} lists other tests of {name} than there are; run facts.py"
            if not figure:
                yield f"{self.path.name} gives no figure of {name}; run facts.py"

    def write(self, tests, figures):
        """The page with its rows in order, tests and figures written anew."""
        rows = [
            f"| {name} | {self.facts[name]} | {', '.join('`' + t + '`' for t in tests[name])} | "
            f"{'; '.join(figures[name]).replace('|', '/')} |"
            for name in sorted(self.facts, key=order)
        ]
        head = self.text[: ROW.search(self.text).start()] if rows else self.text
        self.path.write_text(head + "\n".join(rows) + "\n")


def tests_of():
    """{fact: sorted test names} of the sources: C++ tests, and those of pytest that the build names after a fact."""
    found = {}
    for path in sorted(PAGES.parent.parent.glob("*/**/*")):
        if path.parts[len(PAGES.parent.parent.parts)] == "build" or "Toy" in path.parts:
            continue
        if path.suffix == ".cxx":
            names = [f"{a}.{b}" for a, b in re.findall(rf"^TEST\(({FACT}), (\w+)\)", path.read_text(), re.M)]
        elif path.name == "CMakeLists.txt":
            names = re.findall(rf"^ *oversketch_pytest\(({FACT}\.\w+) ", path.read_text(), re.M)
        else:
            continue
        for name in names:
            found.setdefault(name.split(".")[0], []).append(name)
    return {fact: sorted(names) for fact, names in found.items()}


def figures_of(build, tests):
    """{fact: figures in the order of the tests}."""
    names = sorted(sum(tests.values(), []), key=order)
    run = subprocess.run(["ctest", "-V", "-R", rf"_test(_[0-9])?$|^{FACT}[.]".replace(r"\d", "[0-9]")], cwd=build,
                         capture_output=True, text=True, env={**os.environ, "GTEST_FILTER": ":".join(names)})
    if run.returncode != 0:
        sys.exit("facts.py: a test of a fact fails:\n" + run.stdout[-4000:])
    found = {}
    for fact, figure in sorted(re.findall(rf"FACT ({FACT}) \| (.*)", run.stdout)):
        if figure.strip() not in found.setdefault(fact, []):
            found[fact].append(figure.strip())
    return found


def main():
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    tests = tests_of()
    pages = [Page(path) for path in sorted(PAGES.glob("?.md"))]
    facts = [name for page in pages for name in page.facts]
    wrong = [f"no test of {name}" for name in facts if name not in tests]
    wrong += [f"no page lists the fact of {', '.join(names)}" for name, names in tests.items() if name not in facts]
    if sys.argv[2:]:
        wrong += [each for page in pages for each in page.wrong(tests)]
    if wrong:
        sys.exit("\n".join(wrong))
    if not sys.argv[2:]:
        figures = figures_of(sys.argv[1], tests)
        silent = [name for name in facts if name not in figures]
        if silent:
            sys.exit("no figure reported of " + ", ".join(silent))
        for page in pages:
            page.write(tests, figures)
    print(f"{len(facts)} facts, {sum(len(tests[name]) for name in facts)} tests")


if __name__ == "__main__":
    main()
