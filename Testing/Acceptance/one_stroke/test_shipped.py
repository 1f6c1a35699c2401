"""The shipped strokes through the whole system, against the bounds of the specification (stage 12, first fact)."""
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))
import accept  # noqa: E402
import meshes  # noqa: E402  (finds what follows)
import listing  # noqa: E402
import stroke_files  # noqa: E402

STROKES = listing.one_stroke()


@pytest.fixture(scope="module")
def reached():
    """Results of all strokes; reports the worst figure of each bound at the end."""
    results = []
    yield results
    worst = {key: max(r[key] for r in results) for key in ("mean", "worst", "back", "folds")}
    print(
        f"\nFACT A12_1 | {len(results)} runs of shipped strokes, remesh off and auto: mean at most {worst['mean']:.2f} px, worst "
        f"{worst['worst']:.2f} px, back {worst['back']:.2f} px, new folds {worst['folds']}, untouched at least "
        f"{min(r['untouched'] for r in results):.2f}"
    )


def test_every_model_has_strokes():
    assert len(STROKES) == 10 and len({path.stem.split("_")[0] for path in STROKES}) == 5


@pytest.mark.parametrize("stroke", STROKES, ids=lambda path: path.stem)
def test_result_holds_every_bound(stroke, reached):
    mesh = meshes.DATA / "Models" / f"{stroke.stem.split('_')[0]}.ply"
    results = accept.run(stroke, mesh, ["off", "default"], "auto", None)
    for mode, result in results.items():
        assert result["mean before"] > 2, "the stroke asks for a change that can be seen"
        assert result["holds"], (mode, result)
        reached.append(result)


@pytest.mark.parametrize("name, measure, reach_ends", [("person_stretched_leg", "worst", True), ("person_short_arm", "folds", False)])
def test_correcting_the_outline_pays(name, measure, reach_ends, monkeypatch):
    # An instep that becomes the outline of the stretched leg; a thumb that folds in the shortened arm when the region ends
    # short of the stroke.
    def system(mode, backend, made=accept.system):
        one_stroke = made(mode, backend)
        one_stroke.GetStep("MixtureRegion").SetReachEnds(reach_ends)
        one_stroke.AllowTornOn()  # a thumb that folds in passes through the arm
        return one_stroke

    monkeypatch.setattr(accept, "system", system)
    stroke = Path(__file__).resolve().parent / "Strokes" / f"{name}.vtp"
    mesh = meshes.DATA / "Models" / "person.ply"
    without = accept.run(stroke, mesh, ["uncorrected"], "auto", None)["uncorrected"]
    result = accept.run(stroke, mesh, ["off"], "auto", None)["off"]
    print(f"{name}: {measure} {without[measure]:.2f} without, {result[measure]:.2f} with")
    assert result["holds"], result
    assert result[measure] < 0.7 * without[measure]


def step_at_the_border(stroke, reach_ends=True):
    """The largest strain of an edge of which one end moved and the other did not: 1 is as far as the edge is long."""
    system = accept.system("off", "auto")
    system.GetStep("MixtureRegion").SetReachEnds(reach_ends)
    mesh = meshes.read(meshes.DATA / "Models" / f"{stroke.stem.split('_')[0]}.ply")
    system.SetInputData(mesh)
    system.SetStrokeData(stroke_files.read(stroke)[0])
    system.Update()
    before, triangles = meshes.arrays(mesh)
    moved = meshes.arrays(system.GetOutput())[0] - before
    edges = meshes.edges_of(triangles)[0]
    edges = edges[(moved[edges] != 0).any(2).sum(1) == 1]
    a, b = edges.T
    return (np.linalg.norm(moved[a] - moved[b], axis=1) / np.linalg.norm(before[a] - before[b], axis=1)).max()


@pytest.mark.parametrize("stroke", STROKES, ids=lambda path: path.stem)
def test_no_step_where_the_region_ends(stroke):
    assert step_at_the_border(stroke) < 0.8


def test_a_region_that_stops_short_of_the_stroke_leaves_a_step():
    stroke = meshes.DATA / "Strokes" / "person_thicker_leg.vtp"
    assert step_at_the_border(stroke, False) > 1.5
    assert step_at_the_border(stroke) < 0.3
