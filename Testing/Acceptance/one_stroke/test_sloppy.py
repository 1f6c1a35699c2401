"""The sloppy hands and their judge: laws with known answers, on strokes and meshes of a few points."""
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parent)]
import hands  # noqa: E402
import meshes  # noqa: E402  (finds what follows)
import listing  # noqa: E402
import picture  # noqa: E402
import sloppy  # noqa: E402
import sloppy_judge  # noqa: E402
import sloppy_runs  # noqa: E402
import stroke_files  # noqa: E402
import torso  # noqa: E402

FLAT = picture.View(np.eye(4), np.diag([2 / 800, 2 / 600, -1, 1.0]))  # world units are px, (0, 0) the picture's middle
OFF_GRID = (0.13, 0.17)  # px that keep straight outlines off the lines that the judge cuts them with


def limb(length=150.0, wide=40.0):
    """A stroke up one side of an upright limb, round its tip and down the other; the limb is on its left."""
    angle = np.linspace(0, np.pi, 40)
    tip = (400, 250 + length) + wide / 2 * np.c_[np.cos(angle), np.sin(angle)]
    return picture.resample(np.vstack([[(400 + wide / 2, 250)], tip, [(400 - wide / 2, 250)]]), 4.0)


def meant(name="limb-1", is_limb=True, line=None):
    aside = np.array([[460.0, 250], [470, 250]])
    return hands.Meant(name, limb() if line is None else line, is_limb, aside, aside - (130, 0), (800, 600))


total = lambda line: picture.lengths(line)[-1]


# ---------------------------------------------------------------------------------------------------- the hands

def test_a_shifted_stroke_is_the_stroke_shifted():
    assert np.array_equal(hands.shifted(limb(), (3, -4)), limb() + (3, -4))


@pytest.mark.parametrize("degrees", [-15, 7.5, 90])
def test_a_turned_stroke_keeps_every_step_and_turns_by_the_angle(degrees):
    line = limb()
    turned = hands.turned(line, degrees)
    assert np.linalg.norm(np.diff(turned, axis=0), axis=1) == pytest.approx(np.linalg.norm(np.diff(line, axis=0), axis=1))
    angles = [np.degrees(np.arctan2(*(a[5] - a[0])[::-1])) for a in (line, turned)]
    assert angles[1] - angles[0] == pytest.approx(degrees)
    middle = (line.min(0) + line.max(0)) / 2
    assert hands.turned(np.vstack([line, middle]), degrees)[-1] == pytest.approx(middle)


def test_trimming_loses_the_share_and_running_on_adds_it():
    line = limb()
    short, long = hands.trimmed(line, 0.05, 0.15), hands.run_on(line, 0.05, 0.15)
    assert total(short) == pytest.approx(0.8 * total(line)) and total(long) == pytest.approx(1.2 * total(line))
    assert picture.distance_to(short, [line])[0].max() < 1e-9
    assert long[-1] == pytest.approx(line[-1] - (0, 0.15 * total(line))), "straight on"
    assert long[0] == pytest.approx(line[0] - (0, 0.05 * total(line)))
    assert np.linalg.norm(np.diff(long, axis=0), axis=1).max() < 5
    assert np.array_equal(hands.run_on(line, 0, 0), line)


def test_a_wobble_is_as_high_as_it_should_be():
    line = limb()
    off = np.linalg.norm(hands.wobbled(line, 3.0, np.random.default_rng(1)) - line, axis=1)
    assert off.max() == pytest.approx(3.0) and 0.3 < off.mean() < 2.5


def test_inside_is_a_parallel_on_the_side_of_the_limb():
    line = limb()
    inner = hands.inside(line, 10.0)
    assert np.abs(picture.distance_to(inner, [line])[0] - 10).max() < 1
    assert np.abs(inner[:, 0] - 400).max() < 10.1 and inner[:, 1].max() == pytest.approx(line[:, 1].max() - 10, abs=1)
    assert hands.width(line) == pytest.approx(40, rel=0.12)
    straight = np.c_[np.linspace(200, 300, 26), np.full(26, 100.0)]
    assert hands.inside(straight, 30.0) == pytest.approx(straight + (0, 30))


@pytest.mark.parametrize("past", [-5.0, 0.0, 5.0])
def test_a_closed_stroke_comes_back_over_the_base(past):
    line = limb()
    loop = hands.closed(line, 0.5, past)
    assert np.linalg.norm(loop[-1] - loop[0]) == pytest.approx(abs(past), abs=1e-9)
    assert total(loop) == pytest.approx(total(line) + 40 + past) and loop[0] == pytest.approx((400, 250))


def test_elsewhere_goes_to_the_nearest_place_as_far_as_it_may():
    line = limb()
    places = np.array([[300.0, 250], [100, 250]])
    assert hands.elsewhere(line, places, 0.5, 0.9)[-1] == pytest.approx((300, 250))
    assert hands.elsewhere(line, places, 0.9, 0.9)[-1] == pytest.approx((100, 250))
    near = hands.elsewhere(line, places, 0.1, 0.9)
    assert near[-1] == pytest.approx((380 - 0.1 * total(line), 250)) and np.array_equal(near[:len(line)], line)
    assert np.array_equal(hands.elsewhere(line, np.empty((0, 2)), 0.1, 0.5), hands.run_on(line, 0, 0.1))


def test_places_of_another_limb_are_across_a_gap():
    # A body with two limbs upwards; the section goes round the left one, counterclockwise from its right side.
    corners = [(0, 0), (200, 0), (200, 200), (140, 200), (140, 60), (60, 60), (60, 200), (0, 200), (0, 0)]
    outer = picture.resample(np.array(corners, float) + 200, 2.0)
    section = np.array([[260.0, 262], [260, 400], [200, 400], [200, 262]])
    starts, ends = hands.parts_beside(outer, section)
    assert starts[:, 0].min() == pytest.approx(340, abs=1) and (starts[:, 1] > 260).all(), "the other limb, not the crotch"
    assert len(ends) and (np.linalg.norm(ends - section[-1], axis=1) >= hands.PART - 5).all()


def test_variants_are_the_same_at_every_run_and_keep_within_their_bounds():
    line = limb()
    for number in range(20):
        hand, how, drawn = hands.variant(meant(), number)
        again = hands.variant(meant(), number)
        assert hand == again[0] and how == again[1] and np.array_equal(drawn, again[2])
        assert hands.within(drawn, (800, 600))
        if hand == "shifted":
            assert 0 < np.linalg.norm(drawn - line, axis=1).max() <= hands.SHIFT
        if hand == "turned":
            assert 0 < abs(how["degrees"]) <= hands.TURN
        if hand in ("trimmed", "run on"):
            assert 0.04 < abs(total(drawn) / total(line) - 1) <= hands.SHARE + 1e-9
        if hand in ("begun elsewhere", "ended elsewhere"):  # what is meant is in the middle
            assert picture.distance_to(hands.trimmed(drawn, 0.2, 0.2), [line])[0].max() < 1e-9
    assert {hands.hand_of(meant(), n) for n in range(10)} == set(hands.HANDS)
    assert "closed" not in {hands.hand_of(meant(is_limb=False), n) for n in range(10)}
    assert hands.variant(meant("another"), 0)[1] != hands.variant(meant(), 0)[1]


def test_variants_stay_in_the_picture():
    corner = limb() - (limb().min(0) - 5)  # 5 px off two edges
    for number in range(10):
        assert hands.within(hands.variant(meant(line=corner), number)[2], (800, 600))


def test_a_raised_section_is_raised_outwards_between_its_ends():
    section = np.c_[np.linspace(500, 300, 101), np.full(101, 200.0)]  # along the top, the body below, on the left
    line = torso.raised(section, 20.0)
    assert line[:, 1].max() == pytest.approx(220) and line[[0, -1]] == pytest.approx(section[[0, -1]])
    assert torso.raised(section, -14.0)[:, 1].min() == pytest.approx(186)
    assert (line[:, 1] >= 200 - 1e-9).all()


# ---------------------------------------------------------------------------------------------------- the judge

def plate(columns=60, rows=40, step=10.0):
    """A flat grid of 600 x 400 px in the picture's middle."""
    x, y = np.meshgrid(np.arange(columns + 1) * step - 300, np.arange(rows + 1) * step - 200)
    points = np.c_[x.ravel() + OFF_GRID[0], y.ravel() + OFF_GRID[1], np.zeros(x.size)]
    at = np.arange(x.size).reshape(x.shape)
    a, b, c, d = (part.ravel() for part in (at[:-1, :-1], at[:-1, 1:], at[1:, 1:], at[1:, :-1]))
    return points, np.vstack([np.c_[a, b, c], np.c_[a, c, d]])


def judged(move, stroke, section=None):
    """The judge's result for the plate with its points moved by a function of their px."""
    points, triangles = plate()
    before = sloppy_judge.Seen(FLAT, points, triangles)
    now = points + np.c_[move(before.xy), np.zeros(len(points))]
    pairs = (points, now, before.visible())
    return sloppy_judge.judge_result(before, (now, triangles), pairs, stroke, stroke if section is None else section)


STROKE = OFF_GRID + np.c_[np.linspace(500, 300, 51), np.full(51, 500.0)]  # along the plate's upper edge
NOTHING = lambda xy: np.zeros_like(xy)


def push(centre, by, radius=14.0):
    return lambda xy: (np.linalg.norm(xy - centre, axis=1) < radius)[:, None] * np.array(by, float)


def test_nothing_changed_is_as_meant_where_the_stroke_lies_on_the_outline():
    result = judged(NOTHING, STROKE)
    assert result["fails"] == [] and result["mean"] == pytest.approx(0, abs=1e-6) and result["farthest"] == 0
    assert {sloppy_judge.verdict(result, said) for said in ("", "warned")} == {"as meant"}


@pytest.mark.parametrize("gap, fails", [(2.9, []), (3.1, ["outline"])])
def test_the_outline_is_held_to_three_px(gap, fails):
    result = judged(NOTHING, STROKE + (0, gap))
    assert result["fails"] == fails and result["mean"] == pytest.approx(gap)
    assert sloppy_judge.verdict(result, "") == ("wreck" if fails else "as meant")
    assert sloppy_judge.verdict(result, "the outline misses") == ("said" if fails else "as meant")


def test_a_point_moved_far_from_the_hull_is_found_and_one_near_it_is_not():
    far = judged(push((400, 450), (8, 0)), STROKE)  # 50 px below the stroke, up to 10 more by its radius
    assert far["fails"] == ["far inside"] and far["far points"] >= 1 and 40 <= far["farthest"] <= 60
    assert far["moved"] == pytest.approx(8) and far["far pixels"] == 0
    assert judged(push((400, 490), (8, 0)), STROKE)["fails"] == []
    assert judged(push((400, 450), (2.9, 0)), STROKE)["fails"] == [], "what nobody sees"


@pytest.mark.parametrize("x, fails", [(540, ["far in outline", "far inside"]), (515, [])])
def test_a_bump_in_the_outline_far_from_the_hull_is_found_and_one_near_it_is_not(x, fails):
    result = judged(push((x, 500), (0, 12), 4.0 if x == 540 else 6.0), STROKE)
    assert result["fails"] == fails and result["mean"] < 1
    if fails:  # what changed begins 10 px on either side of the bump
        assert result["far pixels"] > 20 and 40 <= result["farthest"] <= 50


def test_the_section_belongs_to_the_hull():
    low = STROKE - (0, 80)
    move = push((400, 430), (8, 0))
    assert judged(move, STROKE)["fails"] == ["far inside"] and judged(move, STROKE, low)["fails"] == []


def test_what_is_hidden_may_move():
    points, triangles = plate(20, 20)
    behind = points * (0.5, 0.5, 1) + (-100, -50, -0.5)  # a smaller plate behind the first one
    both, faces = np.vstack([points, behind]), np.vstack([triangles, triangles + len(points)])
    visible = sloppy_judge.Seen(FLAT, both, faces).visible()
    assert visible[:len(points)].all() and not visible[len(points):].any()


def test_a_hull_and_the_distance_to_it():
    square = np.array([[0, 0], [10, 0], [10, 10], [0, 10.0]])
    corners = sloppy_judge.hull(np.vstack([square, [[5, 5], [5, 0], [2, 8]]]))
    assert sorted(corners.tolist()) == sorted(square.tolist())
    assert sloppy_judge.off_hull(np.array([[5.0, 5], [13, 14], [5, -7], [0, 5]]), corners) == pytest.approx([0, 5, 7, 0])


def test_what_is_turned_inside_out_is_found():
    # A strip along the upper edge is laid over the plate, its back in front.
    points, triangles = plate()
    before = sloppy_judge.Seen(FLAT, points, triangles)
    assert before.back == 0
    xy = before.xy
    strip = (xy[:, 1] > xy[:, 1].max() - 60) & (np.abs(xy[:, 0] - xy[:, 0].mean()) < 60)
    now = points.copy()
    middle = points[strip].mean(0)
    now[strip] = middle + (points[strip] - middle) * (1, -1, 1) + (0, 0, 0.1)
    result = sloppy_judge.judge_result(before, (now, triangles), (points, now, before.visible()), STROKE, STROKE)
    assert result["inside out"] > 0.02 and "inside out" in result["fails"]
    assert "inside out" not in judged(NOTHING, STROKE)["fails"]


def test_thin_changes_are_none():
    rows = np.arange(20)[:, None] + np.zeros(20)
    assert not sloppy_judge.thick((rows > 5) & (rows < 8)).any() and sloppy_judge.thick((rows > 5) & (rows < 9)).sum() == 18


def test_causes():
    section = limb(200)
    wrong = {"fails": ["outline", "far inside"], "mean": 9.0}
    cause = lambda match, result=wrong: sloppy_judge.cause(result, sloppy_judge.matched(section, np.asarray(match, float)))
    assert cause(section) == "region too large, outline misses too"
    assert cause(section, {"fails": ["far inside"], "mean": 0.1}) == "region too large"
    assert cause(section, {"fails": ["outline"], "mean": 5.0}) == "outline misses the stroke, nothing else moved"
    assert cause(section[:20]) == "wrong section: a part of it"
    assert cause([(420, 250), (400, 240), (380, 200), (360, 150)]) == "wrong section: crotch or other limb"
    assert cause([(420, 250), (700, 250), (700, 20), (100, 20), (100, 250), (380, 250)]) == "wrong section: the long way"
    assert cause(np.vstack([section, [(380, 100)]])) == "section runs on elsewhere"
    assert cause([], {"fails": ["refused"]}) == "refused"


def row(number, verdict, said="", mode="default"):
    return {"stroke": f"s{number // 10}", "model": "m", "part": "limb", "number": number % 10, "mode": mode, "hand": "shifted",
            "how": {"by": [1.0, 2.0]}, "verdict": verdict, "said": said, "cause": "refused", "fails": [], "mean": 0.5}


def test_bounds_and_table():
    good = [row(n, "as meant") for n in range(17)] + [row(n, "said", "no | match\nhere") for n in range(17, 20)]
    assert sloppy.complaints(good, False) == [] and len(sloppy.complaints(good, True)) == 1
    assert len(sloppy.complaints(good + [row(20, "said", "no")], False)) == 1, "17 of 21"
    assert "nothing says so" in sloppy.complaints(good + [row(20, "as meant"), row(21, "wreck")], False)[0]
    text = sloppy.table(good + [row(n, "wreck", mode="published") for n in range(20)], ["default", "published"])
    assert "| **all** | 17 of 20 (85 %) | 3 | 0 | 0 | 0 of 20 (0 %) | 0 | 20 | 0 |" in text
    assert "no / match here" in text


# ----------------------------------------------------------------------------------------------------- the runs

def test_a_shipped_stroke_runs_and_one_in_the_void_is_refused():
    system = sloppy_runs.System("default", meshes.read(meshes.DATA / "Models" / "dog.ply"))
    stroke, _, view, _ = stroke_files.read(next(path for path in listing.one_stroke() if path.stem == "dog_longer_leg"))
    said, _ = system.run(stroke)
    assert said == ""
    was, now, seen = system.pairs(view)
    assert len(was) == len(now) == len(seen) and not np.array_equal(was, now)
    points = stroke.GetPoints()
    for i in range(points.GetNumberOfPoints()):
        points.SetPoint(i, 1.0 + 0.1 * i, 1.0, 0.0)
    points.Modified()
    stroke.Modified()
    said, _ = system.run(stroke)
    assert said != "" and system.filter.GetOutput().GetNumberOfCells() == 0
