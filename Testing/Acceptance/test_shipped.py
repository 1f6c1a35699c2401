"""The shipped strokes through the whole system, against the bounds of the specification (stage 12, first fact)."""
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))
import accept  # noqa: E402
import meshes  # noqa: E402

STROKES = sorted((meshes.DATA / "Strokes").glob("*.vtp"))


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


@pytest.mark.parametrize("name, measure", [("person_stretched_leg", "worst"), ("person_short_arm", "folds")])
def test_correcting_the_outline_pays(name, measure):
    # An instep that becomes the outline of the stretched leg; a thumb that folds in the shortened arm.
    stroke = Path(__file__).resolve().parent / "Strokes" / f"{name}.vtp"
    mesh = meshes.DATA / "Models" / "person.ply"
    without = accept.run(stroke, mesh, ["uncorrected"], "auto", None)["uncorrected"]
    result = accept.run(stroke, mesh, ["off"], "auto", None)["off"]
    print(f"{name}: {measure} {without[measure]:.2f} without, {result[measure]:.2f} with")
    assert result["holds"], result
    assert result[measure] < 0.7 * without[measure]
