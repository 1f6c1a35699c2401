"""The judge is judged: analytic outlines, known displacements, meshes made to be folded, torn or degenerate."""
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path[:0] = [str(Path(__file__).resolve().parent), str(Path(__file__).resolve().parent / "one_stroke")]
import judge  # noqa: E402
import meshes  # noqa: E402
import picture  # noqa: E402
import stroke_files  # noqa: E402
import strokes  # noqa: E402


def sphere(rings=120):
    """A unit sphere of rings x 2 rings quads, split."""
    theta = np.linspace(0, np.pi, rings + 1)[1:-1]
    phi = np.linspace(0, 2 * np.pi, 2 * rings, endpoint=False)
    grid = np.stack([np.outer(np.sin(theta), np.cos(phi)), np.outer(np.sin(theta), np.sin(phi)),
                     np.repeat(np.cos(theta)[:, None], len(phi), 1)], -1).reshape(-1, 3)
    points = np.vstack([grid, [0, 0, 1], [0, 0, -1]])
    n, m = len(theta), len(phi)
    at = lambda i, j: i * m + j % m
    i, j = (a.ravel() for a in np.meshgrid(np.arange(n - 1), np.arange(m), indexing="ij"))
    triangles = np.vstack([np.c_[at(i, j), at(i + 1, j), at(i + 1, j + 1)], np.c_[at(i, j), at(i + 1, j + 1), at(i, j + 1)],
                           [[n * m, at(0, k), at(0, k + 1)] for k in range(m)],
                           [[n * m + 1, at(n - 1, k + 1), at(n - 1, k)] for k in range(m)]])
    return points, triangles


@pytest.mark.parametrize("perspective", [False, True])
def test_outline_of_a_sphere_is_a_circle(perspective):
    points, triangles = sphere()
    view = picture.View.looking(points, (0.3, 0.5, 0.8), (0, 1, 0), perspective, 0.7)
    loops = picture.outline(view.display(points)[0], triangles)
    assert len(loops) == 1
    centre, z = view.display(np.zeros((1, 3)))
    focal = view.projection[1, 1] * view.height / 2
    radius = focal / np.sqrt(z[0] ** 2 - 1) if perspective else focal
    gap = np.linalg.norm(loops[0] - centre, axis=1) - radius
    sagitta = radius * (1 - np.cos(np.pi / 240))  # the sphere is a polyhedron: its outline lies inside by at most this
    assert gap.max() < 0.01 and gap.min() > -2 * sagitta - 0.01
    assert np.abs(gap).max() < 0.15


def test_outline_has_the_hole_of_a_ring_and_is_exact_on_straight_sides():
    outer, inner = np.array([[10.3, 10.7], [90.6, 10.7], [90.6, 50.2], [10.3, 50.2]]), \
        np.array([[30.1, 20.4], [70.9, 20.4], [70.9, 40.8], [30.1, 40.8]])
    points = np.vstack([outer, inner])
    triangles = np.array([t for k in range(4) for t in ((k, (k + 1) % 4, 4 + k), ((k + 1) % 4, 4 + (k + 1) % 4, 4 + k))])
    loops = picture.outline(points, triangles)
    assert len(loops) == 2
    square = lambda p: np.vstack([p, p[:1]])
    for loop in loops:
        gap, _, _ = picture.distance_to(loop, [square(outer), square(inner)])
        assert gap.max() < 1e-9
    area = sorted(0.5 * np.sum(l[:-1, 0] * l[1:, 1] - l[1:, 0] * l[:-1, 1]) for l in loops)
    assert area[0] == pytest.approx(-40.8 * 20.4, abs=1) and area[1] == pytest.approx(80.3 * 39.5, abs=1)


@pytest.mark.parametrize("offset", [0.0, 0.8, 5.0])
def test_distance_of_a_displaced_arc(offset):
    points, triangles = sphere()
    view = picture.View.looking(points, (0, 0, 1), (0, 1, 0), False, 0.7)
    centre, _ = view.display(np.zeros((1, 3)))
    radius = view.projection[1, 1] * view.height / 2
    angle = np.radians(np.linspace(-60, 60, 200))
    stroke = centre + (radius + offset) * np.c_[np.cos(angle), np.sin(angle)]
    mean, worst, back = judge.outline_distances(view, points, triangles, stroke)
    assert mean == pytest.approx(offset, abs=0.06) and worst == pytest.approx(offset, abs=0.1)
    assert back == pytest.approx(offset, abs=0.1)


def test_way_back_sees_what_the_way_there_does_not():
    # A comb: the stroke runs along its back, but the outline between has a tooth 30 px deep.
    points = np.array([[100, 100], [300, 100], [300, 200], [205, 200], [200, 230], [195, 200], [100, 200]], float)
    triangles = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 5], [0, 5, 6], [3, 4, 5]])
    flat = picture.View(np.eye(4), np.diag([2 / 800, 2 / 600, -1, 1.0]))
    stroke = np.array([[110.0, 200], [290, 200]])
    world = np.c_[points - (400, 300), np.zeros(len(points))]
    mean, worst, back = judge.outline_distances(flat, world, triangles, stroke)
    assert worst < 5.1 and back == pytest.approx(30, abs=1.0)  # a sharp tip is cut by the grid


@pytest.mark.parametrize("perspective", [False, True])
def test_the_share_of_backs(perspective):
    points, triangles = sphere(40)
    view = picture.View.looking(points, (0.3, 0.5, 0.8), (0, 1, 0), perspective, 0.7)
    assert judge.back_share(view, points, triangles) == 0
    assert judge.back_share(view, points, triangles[:, ::-1]) == 1
    # A smaller one before it, turned inside out: a quarter of the area, more in perspective as it is nearer.
    near = points * 0.5 + 2 * np.linalg.inv(view.view)[:3, 2]
    both = np.vstack([points, near]), np.vstack([triangles, triangles[:, ::-1] + len(points)])
    share = judge.back_share(view, *both)
    away = -view.display(np.zeros((1, 3)))[1][0]
    expected = 0.25 * (away ** 2 - 1) / ((away - 2) ** 2 - 0.25) if perspective else 0.25  # spheres seen as circles
    assert share == pytest.approx(expected, rel=0.01)


def test_folded_edges_are_counted():
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0.5, 0]], float)
    triangles = np.array([[0, 1, 2], [0, 2, 3], [1, 4, 2]])
    assert judge.folded_edges(points, triangles) == 0
    folded = points.copy()
    folded[4] = (0.2, 0.5, 0.05)  # turned back over the first triangle
    assert judge.folded_edges(folded, triangles) == 1
    upright = points.copy()
    upright[4] = (1.0, 0.5, 1.0)  # 90 degrees is no fold
    assert judge.folded_edges(upright, triangles) == 0


def cube():
    points = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return points, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def test_roughness_of_a_cube_and_of_a_part_of_it():
    points, triangles = cube()
    angle, sharp = judge.roughness(points, triangles, np.ones(8, bool))
    assert angle == pytest.approx(90 * 12 / 18) and sharp == pytest.approx(12 / (12 + 6 * np.sqrt(2)))
    assert judge.roughness(points, triangles, np.zeros(8, bool)) == (0.0, 0.0)
    corner = np.arange(8) == 1  # three sharp edges end there, and diagonals
    assert judge.roughness(points, triangles, corner)[0] == pytest.approx(90 * 3 / (triangles == 1).any(1).sum())


def test_a_twisted_tube_is_rougher_than_a_smooth_one():
    def tube(around, twist):
        u, v = np.meshgrid(np.arange(around), np.arange(13), indexing="ij")
        angle = 2 * np.pi * (u + twist * (v % 2)) / around
        points = np.stack([np.cos(angle), np.sin(angle), v * 0.5], -1).reshape(-1, 3)
        at = lambda i, j: (i % around) * 13 + j
        i, j = (a.ravel() for a in np.meshgrid(np.arange(around), np.arange(12), indexing="ij"))
        return points, np.vstack([np.c_[at(i, j), at(i + 1, j), at(i + 1, j + 1)], np.c_[at(i, j), at(i + 1, j + 1), at(i, j + 1)]])

    def measured(around, twist=0.0):
        points, triangles = tube(around, twist)
        angle, sharp = judge.roughness(points, triangles, np.ones(len(points), bool))
        return {"angle": angle, "sharp": sharp, "mean": 0.0}

    smooth = measured(16)
    assert smooth["angle"] == pytest.approx(360 / 16 / 3, rel=0.1) and smooth["sharp"] == 0
    for other, rougher in ((measured(16), False), (measured(20), False), (measured(8), True), (measured(16, 1.5), True)):
        judge.compare(other, smooth)
        assert (other["rougher"] > 0) == rougher == (other["fails"] == ["rougher"]) != other["holds"]
    # Each of the two counts by itself.
    for other, by in (({"angle": 1.25 * smooth["angle"] + 3, "sharp": 0.0}, 2), ({"angle": 0.0, "sharp": 0.03}, 2)):
        judge.compare(other, smooth)
        assert other["rougher"] == pytest.approx(by) and other["fails"] == ["rougher"]


def test_topology_and_degenerate_triangles():
    points, triangles = sphere(12)
    assert judge.topology(triangles) == (0, 0, 0)
    assert judge.topology(triangles[1:])[0] == 3
    fin = np.vstack([triangles, [triangles[0, 0], triangles[0, 1], len(points)]])
    assert judge.topology(fin)[1] == 1
    twin = np.vstack([triangles, np.where(triangles == 0, 0, triangles + len(points))])  # joined in vertex 0 alone
    assert judge.topology(twin) == (0, 0, 1)
    assert judge.degenerate_triangles(points, triangles) == 0
    flat = points.copy()
    flat[triangles[0, 2]] = (flat[triangles[0, 0]] + flat[triangles[0, 1]]) / 2
    assert judge.degenerate_triangles(flat, triangles) >= 1
    assert judge.degenerate_triangles(points, np.vstack([triangles, [1, 1, 2]])) == 1


def bump(points, height):
    """The sphere with a smooth bump on +x, for strokes seen along z."""
    pull = height * np.clip((points[:, 0] - 0.6) / 0.4, 0, 1) ** 2
    moved = points.copy()
    moved[:, 0] += pull
    return moved, pull > 0


def test_judge_holds_for_a_true_result_and_names_what_fails():
    points, triangles = sphere(60)
    view = picture.View.looking(points, (0, 0, 1), (0, 1, 0), False, 0.5)
    moved, region = bump(points, 0.4)
    loop = picture.outline(view.display(moved)[0], triangles)[0]
    right = loop[loop[:, 0] > view.display(np.array([[0.62, 0, 0]]))[0][0, 0]]
    order = np.argsort(np.arctan2(right[:, 1] - 300, right[:, 0] - 400))
    stroke = right[order]
    good = judge.judge(judge.facts_of((points, triangles)), (moved, triangles), stroke, view, region)
    assert good["holds"] and good["mean"] < 0.05 and good["outside changed"] == 0
    assert good["mean before"] > 10

    nothing = judge.judge(judge.facts_of((points, triangles)), (points, triangles), stroke, view, region)
    assert {"mean", "worst"} <= set(nothing["fails"]) and nothing["untouched"] == pytest.approx(1)

    stray = moved.copy()
    stray[np.flatnonzero(~region)[0]] += 1e-12
    assert judge.judge(judge.facts_of((points, triangles)), (stray, triangles), stroke, view, region)["fails"] == ["outside changed"]

    torn = judge.judge(judge.facts_of((points, triangles)), (moved, triangles[:-1]), stroke, view, region)
    assert "closed" in torn["fails"]

    everything = judge.judge(judge.facts_of((points, triangles)), (moved * 1.0000001, triangles), stroke, view, np.ones(len(points)))
    assert everything["fails"] == ["untouched"]

    tips = {"other_tips": [[1.0, 0, 0], [-1.0, 0, 0]]}
    assert judge.judge(judge.facts_of((points, triangles)), (moved, triangles), stroke, view, region, tips)["other limbs moved"] == 1


def test_about_a_tip_is_its_own_limb_alone():
    # Two spheres a hundredth apart on x, joined behind by a long way round: what is about the pole of one is not the other's.
    points, triangles = sphere(24)
    two = np.vstack([points, points + (2.01, 0, 0)])
    both = np.vstack([triangles, triangles + len(points)])
    bridge = np.array([[np.argmin(points[:, 0]), np.argmax(two[:, 0]), np.argmax(points[:, 1])]])
    edges = meshes.edges_of(np.vstack([both, bridge]))[0]
    tip = points[np.argmax(points[:, 0])]
    found, away = judge.about(two, edges, tip, 0.3), np.linalg.norm(two - tip, axis=1)
    assert (found[:len(points)] == (away[:len(points)] < 0.3)).all() and found.sum() > 10
    assert not found[len(points):].any() and (away[len(points):] < 0.3).sum() > 10


def test_how_much_a_peak_sticks_out():
    """Two rows of points along peaks of 5, 9 and 6 with passes of 3 and 4 between, the second row a little lower; a point without triangles."""
    row = np.array([0, 5, 3, 9, 4, 6, 1.0])
    height = np.r_[row, row - 0.5, 20.0]
    triangles = np.array([t for k in range(6) for t in ((k, k + 1, 7 + k), (k + 1, 8 + k, 7 + k))])
    out = strokes.prominences(height, triangles)
    assert out[[1, 3, 5]].tolist() == [2.0, np.inf, 2.0] and not out[[0, 2, 4, 6, *range(7, 15)]].any()


def test_capsule_limb_is_the_leg():
    t = np.linspace(0, 1, 30)[:, None]
    leg = (1 - t) * np.array([0.22, 0.16, -0.3]) + t * np.array([0.22, 0.16, -1.4])
    arm = (1 - t) * np.array([0.6, 0.11, 1.25]) + t * np.array([1.3, 0.11, 1.25])
    points = np.vstack([leg, arm])
    triangles = np.array([[k, k + 1, k + 1] for k in range(59) if k != 29])
    mask, name = judge.capsule_limb(points, triangles, (0.22, 0, -1.66))
    assert name == "leg +x" and mask[:29].all() and not mask[29:].any()


def test_stroke_files_keep_every_bit(tmp_path):
    points, triangles = sphere(12)
    view = picture.View.looking(points, (1, 2, 3), (0, 1, 0), True, 0.6)
    samples = np.random.default_rng(1).uniform(0, 600, (30, 2))
    stroke_files.write(stroke_files.polydata(samples, view, {"name": "n"}), tmp_path / "s.vtp")
    _, back, seen, note = stroke_files.read(tmp_path / "s.vtp")
    assert (back == samples).all() and (seen.view == view.view).all() and (seen.projection == view.projection).all()
    assert note == {"name": "n"} and (seen.width, seen.height) == (800, 600)


def test_a_stroke_for_a_capsule_goes_from_base_to_base():
    # A ball with one rod: the only limb is the rod, and every stroke made holds what a stroke must hold.
    points, triangles = sphere(24)
    x = points[:, 0]
    rod = x > np.cos(np.radians(25))
    points = points.copy()
    points[rod, 0] += 1.5 * np.clip((x[rod] - np.cos(np.radians(25))) / (1 - np.cos(np.radians(20))), 0, 1)
    made = strokes.strokes_for("rod", meshes.to_polydata(points, triangles), "+y", count=2)
    assert len(made) == 2
    for polydata, note in made:
        assert note["tip"][0] > 2
        from vtkmodules.util.numpy_support import vtk_to_numpy
        samples = vtk_to_numpy(polydata.GetPoints().GetData())[:, :2]
        steps = np.linalg.norm(np.diff(samples, axis=0), axis=1)
        assert 2 < steps.min() and steps.max() < 6.5
        assert (samples > 0).all() and (samples < (800, 600)).all()
        section = np.array(note["section"])
        assert np.linalg.norm(samples[[0, -1]] - section[[0, -1]], axis=1).max() < 4
