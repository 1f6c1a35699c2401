"""The judge of situations on meshes with known answers, and four of the situations themselves."""
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path[:0] = [str(Path(__file__).resolve().parent)]
import accept  # noqa: E402
import situations  # noqa: E402
import through  # noqa: E402

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
FACES = np.array([[0, 1, 2], [0, 2, 3]])


def two_squares(lower):
    """A square, and one that stands upright over its middle, `lower` below it."""
    upright = SQUARE[:, [0, 2, 1]] * (0.5, 1, 1) + (0.25, 0.4, -lower)
    return np.vstack([SQUARE, upright]), np.vstack([FACES, FACES + 4])


def test_edges_that_pass_through_faces_are_counted_once():
    everything = np.ones(4, bool)
    assert through.crossing_edges(*two_squares(-0.1), everything) == 0
    # Its two upright edges and its diagonal go through the other one's faces; that one's diagonal through its own.
    assert through.crossing_edges(*two_squares(0.5), everything) == 4
    assert through.crossing_edges(*two_squares(0.5), np.array([True, True, False, False])) == 4
    assert through.crossing_edges(*two_squares(0.5), np.zeros(4, bool)) == 0


def test_parts_of_one_surface_do_not_pass_through_each_other():
    points, triangles = situations.boxes(2)
    assert through.crossing_edges(points, triangles, np.ones(len(triangles), bool)) == 0
    assert (np.bincount(situations.meshes.edges_of(triangles)[1]) > 0)[:3].tolist() == [False, False, True], "closed"
    assert accept.sharp_length(points, triangles) > 0


@pytest.mark.parametrize("name, which", [("two_tips", ("person", 0, "down", 0)), ("deep_section", ("hand", 0, "up", 1)),
                                         ("cross_hatching", ("bear", 0, "any", 0)), ("missing_samples", (5,))])
def test_a_situation_is_done_as_meant_or_refused_in_words(name, which, tmp_path):
    made = situations.make_all(tmp_path, only=[f"{name}-{'-'.join(map(str, which))}"])
    assert len(made) == 1
    result = accept.run(tmp_path / f"{made[0]['name']}.vtp", made[0]["mesh"], ["default"], "auto", None)["default"]
    print(result)
    assert result["holds"], result
