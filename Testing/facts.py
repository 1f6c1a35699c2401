#!/usr/bin/env python3
"""Keeps Testing/FACTS.md true: which test proves which checkable fact of system A, and the figure it reached.

    facts.py BUILD            runs the tests of the facts in a build folder and writes FACTS.md
    facts.py BUILD --check    exit code 1 when FACTS.md does not list exactly the facts and tests that the build has

A fact's test is named after stage and place, A3_2 for the second of stage 3, and reports its figure in a line
"FACT A3_2 | text". The check looks at facts and tests, not at figures: their last digits belong to a machine.
"""
import pathlib
import re
import subprocess
import sys

FACTS = {
    "A1_1": "Sphere, orthographic: one closed curve in the plane through the centre, radius within the longest edge's arc",
    "A1_2": "Sphere, perspective from D: every point in the plane at R^2/D, radius R sqrt(1 - R^2/D^2)",
    "A1_3": "Octahedron along a vertex axis: four vertex points, no edge points, one closed curve",
    "A1_4": "Torus: two closed curves; perspective on the axis: radii and heights of the two circles",
    "A1_5": "Open cylinder from the side: two straight open curves",
    "A2_1": "Snake: E_geo below epsilon, neighbours share a triangle, no three in one triangle",
    "A2_2": "Bumpy sphere: bending and length fall; epsilon towards 0 leaves edge points in place",
    "A2_3": "Smooth sphere: the curve hardly moves",
    "A3_1": "Convex mesh: no point hidden, either camera",
    "A3_2": "Torus: four image cusps of the inner contour exactly when r/R > cos^2 theta, none of the outer",
    "A3_3": "Torus: hidden share of the inner contour's length",
    "A3_4": "Torus without cusps: image lengths P + 2 pi r and P - 2 pi r",
    "A4_1": "Concentric stroke round the unit sphere: D = 0.2, section 20 to 80 degrees, k = 0.833",
    "A4_2": "Two spheres: the nearer silhouette wins, a hidden one never does, reversing changes nothing",
    "A5_1": "Merging function: f(0) = f(1) = 0, f(0.05) = f(0.95) = 0.5, f = 1 between 0.2 and 0.8",
    "A5_2": "Concentric stroke: radial moves of 0.2 f(r), none along the view-plane normal",
    "A5_3": "Stroke on the projected section: targets equal sources to 1e-9",
    "A6_1": "Long cylinder: mean ray length 2R for any cone and angle-only weights",
    "A6_2": "Sphere R (1 + cos beta), slab -h ln(cos beta) / (1 - cos beta): pins full against half angle",
    "A6_3": "Scaling by c scales the shape diameter by c; translation changes nothing",
    "A6_4": "Device hit lengths equal Embree's to 1e-4; exactly 32 rays a vertex",
    "A7_1": "After an M-step the mixture's mean and second moment are the samples'; weights sum to 1",
    "A7_2": "Log-likelihood never falls, in EM and from K to K + 1",
    "A7_3": "Two normals of 1024 draws each: means within 0.01, weights within 0.02",
    "A7_4": "Whole-model samples = min(2048, vertices); device equals host to 1e-5",
    "A8_1": "Seeds stay selected; each component of the region holds a seed",
    "A8_2": "Body with four equal limbs: at least 95 % of the stroked one, no vertex of the others",
    "A8_3": "The region does not grow with lambda; at the end no neighbour satisfies the inequality",
    "A9_1": "Border smoothing ends without convex or concave vertices; a second pass changes nothing",
    "A9_2": "A one-vertex hole fills, a spike goes, the whole open grid terminates",
    "A10_1": "Plain form: displacements perpendicular to the view-plane normal, linear in the targets, zero to zero, outside identical",
    "A10_2": "Adjusted normals: some vertex moves along the normal; x -> 1.1 x + t reproduced exactly",
    "A10_3": "Strip with a handle at mid-span: h(3s^2 - 2s^3) with border rows, h(3s - s^3)/2 without; residual below 2 %",
    "A11_1": "Mean region edge within 20 % of L k before and of L after; more vertices when k < 1",
    "A11_2": "Fewer narrow triangles than without; manifold, same Euler characteristic, outside unchanged",
    "A12_1": "End to end: outline to stroke, back, folded edges, area left untouched",
    "A12_2": "Same inputs, same output; changing only the stroke does not re-run the shape diameter",
}

PAGE = pathlib.Path(__file__).with_name("FACTS.md")
HEAD = """# Facts

What must hold of system A, the tests that prove it, and the figures that they reached. Written by `Testing/facts.py`,
which the test suite runs with `--check`.

| fact | what holds | test | figure reached |
|---|---|---|---|
"""


def order(name):
    return [int(n) for n in re.findall(r"\d+", name)[:2]]


def tests_of(build):
    """{fact: sorted test names} of a build."""
    listing = subprocess.run(["ctest", "-N"], cwd=build, capture_output=True, text=True, check=True).stdout
    found = {}
    for name in re.findall(r"Test\s+#\d+: (\S+)", listing):
        match = re.match(r"(A\d+_\d+)\.", name)
        if match:
            found.setdefault(match.group(1), []).append(name)
    return {fact: sorted(names) for fact, names in found.items()}


def figures_of(build):
    """{fact: figures in the order of the tests}."""
    run = subprocess.run(["ctest", "-V", "-R", r"^A[0-9]+_[0-9]+[.]"], cwd=build, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit("facts.py: a test of a fact fails:\n" + run.stdout[-4000:])
    found = {}
    for fact, figure in re.findall(r"FACT (A\d+_\d+) \| (.*)", run.stdout):
        if figure.strip() not in found.setdefault(fact, []):
            found[fact].append(figure.strip())
    return found


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    tests = tests_of(sys.argv[1])
    wrong = [f"no test of {fact}" for fact in FACTS if fact not in tests]
    wrong += [f"no such fact: {fact}" for fact in tests if fact not in FACTS]
    if "--check" in sys.argv:
        listed = {}
        for line in PAGE.read_text().splitlines():
            cells = [cell.strip() for cell in line.split("|")]
            if len(cells) > 5 and cells[1] in FACTS:
                listed[cells[1]] = (sorted(re.findall(r"`([^`]+)`", cells[3])), cells[4])
        for fact in FACTS:
            names, figure = listed.get(fact, ([], ""))
            if names != tests.get(fact, []):
                wrong.append(f"FACTS.md lists other tests of {fact} than the build has; run facts.py")
            if not figure:
                wrong.append(f"FACTS.md gives no figure of {fact}")
    if wrong:
        sys.exit("\n".join(wrong))
    if "--check" not in sys.argv:
        figures = figures_of(sys.argv[1])
        silent = [fact for fact in FACTS if fact not in figures]
        if silent:
            sys.exit("no figure reported of " + ", ".join(silent))
        rows = [
            f"| {fact} | {FACTS[fact].replace('|', '/')} | {', '.join('`' + t + '`' for t in tests[fact])} | "
            f"{'; '.join(figures[fact]).replace('|', '/')} |\n"
            for fact in sorted(FACTS, key=order)
        ]
        PAGE.write_text(HEAD + "".join(rows))
    print(f"{len(FACTS)} facts, {sum(len(t) for t in tests.values())} tests")


if __name__ == "__main__":
    main()
