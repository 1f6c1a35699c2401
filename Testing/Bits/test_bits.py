"""The meshes are those that were recorded, to the bit: shipped strokes, strokes of the acceptance run (for each commit a tenth), saved
sessions, a collection and shipped drawings, on both back ends, on one thread and on two, in filters that ran before and in fresh ones.

Bits depend on the processor, the compiler and the libraries. On a platform that nobody recorded (record.py does it) one
thread is compared with two, kept with fresh, and the figures of each mesh with those recorded, within recorded.py's
tolerances; the output says so. So are meshes that changed since a platform was recorded.
"""
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))
import bits  # noqa: E402  (finds what follows)
import frame  # noqa: E402
import recorded  # noqa: E402


@pytest.fixture(scope="module")
def made():
    """{back end: (rows on one thread, rows on two)}."""
    rows = {backend: [] for backend in bits.BACKENDS}
    for count, arguments in ((1, []), (2, ["--cold"])):
        running = [bits.Process(backend, count, *arguments) for backend in bits.BACKENDS]  # side by side
        for backend, process in zip(bits.BACKENDS, running):
            found, said = process.rows()
            rows[backend].append(found)
        print(said, end="")  # what is not here is not here for all of them
    return rows


@pytest.fixture(scope="module")
def known():
    return recorded.Recorded()


def test_threads_and_what_was_kept_change_nothing(made):
    for backend, (one, two) in made.items():
        assert len(one) > 20 and one.keys() == two.keys()
        assert [name for name in one if one[name] != two[name]] == [], backend


def test_all_that_was_recorded_was_run(made, known):
    here = {name for name, path, _ in bits.meshes.models()}
    drawn = [name for name, _ in bits.drawn_strokes()]
    asked = frame.tenth(drawn, frame.DAY)
    assert len(drawn) == 40 and len(asked) in (4, 40)
    acceptance = {name: name.split("/")[1] for name in known.figures if name.startswith("acceptance/")}
    absent = {name for name, stroke in acceptance.items() if stroke in asked and stroke.split("-")[0] not in here}
    beyond = {name for name in known.figures if name.startswith("each/")}  # of which only some are run
    beyond |= {name for name, stroke in acceptance.items() if stroke not in asked}
    rows = made["embree"][0]
    assert set(known.figures) - absent - beyond <= set(rows) <= set(known.figures)
    if not absent:
        groups = [sum(name.startswith(group) for name in rows) for group in bits.GROUPS]
        assert groups == [20, 2 * len(asked), 3, bits.SOME + 3, 7, 8]


def test_meshes_are_those_that_were_recorded(made, known):
    platform = bits.platform()
    print(f"\nplatform: {platform}")
    runs = [(name, backend, row) for backend, (one, _) in made.items() for name, row in one.items()]
    digests = known.on(platform)
    if digests is None:
        print("NOT RECORDED: no digests of this platform. Compared are one thread with two, kept with fresh, and points, triangles, "
              "bounds and the share that moved with those of another platform.")
        for other, there in known.platforms:
            same = sum(name in there and row.mesh == there[name].mesh[backend] for name, backend, row in runs)
            print(f"{same} of {len(runs)} meshes have the bits recorded on {other}")
        far = [f"{name}, {backend}: {', '.join(recorded.apart(known.figures[name], row))}" for name, backend, row in runs
               if recorded.apart(known.figures[name], row)]
        print("\n".join(far + [f"{len(runs) - len(far)} meshes near to those recorded"]))
        assert len(far) <= recorded.FEW * len(runs)
        return
    wrong = []
    for name, backend, row in runs:
        if name not in digests:  # it changed, and was recorded anew elsewhere
            wrong += [f"{name}, {backend}: {', '.join(far)}" for far in [recorded.apart(known.figures[name], row)] if far]
        elif row.input != digests[name].input:
            wrong.append(f"{name}: other mesh or stroke than was recorded")
        elif row.mesh != digests[name].mesh[backend]:
            wrong.append(f"{name}, {backend}: other points or polygons; {', '.join(recorded.apart(known.figures[name], row)) or 'near'}")
        elif row.arrays != digests[name].arrays[backend]:
            wrong.append(f"{name}, {backend}: other arrays")
    assert wrong == []
    print(f"{sum(name in digests for name, _, _ in runs)} of {len(runs)} meshes the same to the bit, the others near")


def test_the_figures_tell_one_mesh_from_another(known):
    for name, figures in known.figures.items():
        if name.startswith("shipped"):
            limb = recorded.Figures(figures.points, figures.triangles, figures.bounds, 0.0)
            assert recorded.apart(figures, bits.Row("", "", "", *limb)), name
