"""The bad hands over lines and rings: laws with known answers, and what three of them come to on a model of ours."""
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parent)]
import bad_hands  # noqa: E402
import picture  # noqa: E402
import rings  # noqa: E402

# A model that fills the left third of the picture but for its edges, a line on it and a ring round that.
DEPTH = np.full((600, 800), -np.inf)
DEPTH[100:500, 40:300] = 0.0
LINE = np.c_[np.linspace(120, 220, 26), np.full(26, 340.0)]
RING = rings.ring_round(LINE, 30.0, 0.0)


def by(hand, name="an entry"):
    return bad_hands.by(hand, name, LINE, RING, DEPTH)


def test_a_hand_draws_the_same_each_time_and_each_case_otherwise():
    for hand in bad_hands.HANDS:
        assert all(np.array_equal(one, other) for one, other in zip(by(hand), by(hand)))
    assert not np.array_equal(by("shaky")[0], by("shaky", "another")[0])


def test_hands_are_as_bad_as_they_say():
    line, ring = by("beside")
    ways = (line - LINE)[0], (ring - RING)[0]
    assert all(0.3 * 25 <= np.linalg.norm(way) <= 25 for way in ways) and not np.allclose(*ways), "each its own way"
    total = lambda stroke: picture.lengths(stroke)[-1]
    assert all(0.8 <= total(stroke) / total(drawn) < 0.95 for stroke, drawn in zip(by("too short"), (LINE, RING)))
    assert all(1.05 < total(stroke) / total(drawn) <= 1.2 for stroke, drawn in zip(by("too long"), (LINE, RING)))
    assert np.array_equal(by("backwards")[0], LINE[::-1]) and np.array_equal(by("as drawn")[1], RING)


def test_what_is_drawn_in_the_void_has_no_model_under_its_middle():
    line, ring = by("half in the void")
    assert np.allclose(ring - RING, (line - LINE)[0]), "both together"
    column, row = line.mean(0).astype(int)
    assert not np.isfinite(DEPTH[row, column]) and np.linalg.norm((line - LINE)[0]) < 250, "at the model's edge"
    assert by("in the void")[0].mean(0) == pytest.approx((0, 600))


def test_a_line_becomes_a_sound_mesh_or_is_refused_in_one_message(tmp_path):
    name = "dinosaur"
    [entry] = rings.make_all(tmp_path, [f"{name}-h0-c1"], 1)
    case = entry["cases"][0]
    found = bad_hands.run(str(tmp_path / f"{entry['name']}.vtp"), entry["mesh"], ["as drawn", "backwards", "in the void"], "auto", tmp_path, case)
    assert all(result["holds"] for result in found.values()), found
    assert found["as drawn"]["patch"] > 100 and "patch" in found["backwards"]
    assert "patch" not in found["in the void"] and len(found["in the void"]["messages"]) == 1
    assert len(list(tmp_path.glob("*.png"))) == 3
