"""What judges the magnetic pen is right about lines that are known; the pen itself along the edges of pen.py, by one hand each."""
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path[:0] = [str(Path(__file__).resolve().parent)]
import pen  # noqa: E402


def ring(radius, count=200):
    angles = 2.0 * np.pi * np.arange(count) / count
    return np.column_stack([200 + radius * np.cos(angles), 150 + radius * np.sin(angles)])


SQUARE = np.array([(100.0, 100.0), (200, 100), (200, 200), (100, 200)])


def test_distances_are_those_of_rings():
    assert pen.distances(ring(100), True, ring(103)) == pytest.approx(3.0, abs=0.05)
    assert pen.distances(ring(100)[:50], False, ring(98)).max() == pytest.approx(2.0, abs=0.05)


def test_corners_are_counted_once_and_also_where_a_line_begins():
    for start in range(0, 400, 37):
        assert len(pen.corners(np.roll(pen.even(SQUARE, True, 5.0), start, axis=0), True)) == 4
    assert len(pen.corners(pen.even(SQUARE, False, 5.0), False)) == 2
    assert len(pen.corners(ring(100), True)) == 0
    found = pen.corners(pen.even(SQUARE, True, 5.0), True)
    assert pen.false_corners(found, SQUARE) == 0 and pen.false_corners(found, SQUARE[:3]) == 1 and pen.false_corners(found, SQUARE[:0]) == 4


def test_a_pen_that_is_not_magnetic_changes_nothing():
    image = pen.image_of(np.full((300, 400, 1), 90.0))
    drawn = ring(80, 60)
    assert np.allclose(pen.through(drawn, True, image, 0)[0], drawn, atol=1e-9)
    assert np.allclose(pen.through(drawn, True, image, 1)[0], drawn, atol=1e-9), "there is no edge"


@pytest.mark.skipif(not pen.outlines.IMAGES.is_dir(), reason=f"no images in {pen.outlines.IMAGES}")
def test_marked_edges_lie_where_pictures_change():
    """Across each the picture changes by more than along a line 12 px beside it."""
    for name, (image, closed, edge) in pen.marked().items():
        grey = pen.pixels(image).mean(axis=2, keepdims=True)
        places = pen.even(edge, closed)
        tangent = np.roll(places, -3, axis=0) - np.roll(places, 3, axis=0)
        normal = np.column_stack([-tangent[:, 1], tangent[:, 0]]) / np.maximum(np.linalg.norm(tangent, axis=1), 1e-9)[:, None]

        def change(beside):
            at = lambda by: pen.bilinear(grey, *((places + (beside + by) * normal) - 0.5).T)[:, 0]
            return np.median(np.abs(at(2.0) - at(-2.0)))
        assert change(0.0) > 2.0 * max(change(12.0), change(-12.0)), name
