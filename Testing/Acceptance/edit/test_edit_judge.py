"""The judge of edits is judged: its measures on shapes with known answers; files of an edit that is right hold every bound, and each
defect put into them fails its own row."""
import json
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath

sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parent)]
import accept  # noqa: E402
import edit_judge  # noqa: E402
import meshes  # noqa: E402
import patch as patches  # noqa: E402
import picture  # noqa: E402
import rings  # noqa: E402
import saved  # noqa: E402
import stroke_files  # noqa: E402


def sheet(columns=20, rows=16):
    """A flat grid of unit squares, each split in two; its points, triangles and the number of a place."""
    x, y = np.meshgrid(np.arange(columns + 1.0), np.arange(rows + 1.0))
    points = np.c_[x.ravel(), y.ravel(), np.zeros(x.size)]
    at = lambda i, j: j * (columns + 1) + i
    i, j = (a.ravel() for a in np.meshgrid(np.arange(columns), np.arange(rows)))
    return points, np.vstack([np.c_[at(i, j), at(i + 1, j), at(i + 1, j + 1)], np.c_[at(i, j), at(i + 1, j + 1), at(i, j + 1)]]), at


def ball(levels=5):
    """A sphere of evenly divided triangles."""
    g = (1 + np.sqrt(5)) / 2
    points = np.array([(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1),
                       (-g, 0, -1), (-g, 0, 1)])
    triangles = np.array([(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
                          (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)])
    for _ in range(levels):
        edges, _, edge = meshes.edges_of(triangles)
        a, b, c = triangles.T
        ab, bc, ca = (len(points) + edge).T
        points = np.vstack([points, points[edges].mean(1)])
        triangles = np.vstack([np.c_[a, ab, ca], np.c_[ab, b, bc], np.c_[ca, bc, c], np.c_[ab, bc, ca]])
    return points / np.linalg.norm(points, axis=1, keepdims=True), triangles


def test_rings_round_tips_hold_one_end_of_a_spindle_and_the_line():
    points, triangles = ball(3)
    points = points * (1, 1, 4)
    made = list(rings.tip_pairs(points, triangles, np.array([0.0, 1.0, 0.0]), np.random.RandomState(1)))
    assert len(made) >= 2
    for line, ring, view in made[:2]:  # its two ends, which stick out most
        middle = ring.mean(0)
        reach = np.linalg.norm(ring - middle, axis=1)
        ends = view.display(points[[points[:, 2].argmin(), points[:, 2].argmax()]])[0]
        assert (np.linalg.norm(ends - middle, axis=1) < reach.min()).sum() == 1
        assert np.linalg.norm(line - middle, axis=1).max() < reach.min()


# ---------------------------------------------------------------------------------------------- measures

def enclosed_sheet():
    points, triangles, at = sheet()
    line = np.array([at(i, 8) for i in range(6, 15)])
    around = [(i, 2) for i in range(2, 18)] + [(18, j) for j in range(2, 14)] + [(i, 14) for i in range(18, 2, -1)] + [(2, j) for j in range(14, 2, -1)]
    ring = np.array([at(*place) for place in around + around[:1]])
    return points, triangles, line, ring, patches.enclosed(patches.Linked(triangles), line, ring)


def test_a_limb_is_what_the_line_reaches_within_the_ring():
    points, triangles, at = sheet()
    middle = points[triangles].mean(1)
    legs = triangles[~((middle[:, 0] > 9) & (middle[:, 0] < 11) & (middle[:, 1] > 4))]  # joined below
    line = np.array([at(i, 8) for i in range(3, 7)])
    ring = np.array([(1.5, 6.5), (18.5, 6.5), (18.5, 12.5), (1.5, 12.5)])
    found = lambda ring: points[edit_judge.limb(patches.Linked(legs), line, edit_judge.within(ring, points[:, :2]))]
    assert found(ring)[:, :, 0].max() <= 9.0 and found(ring)[:, :, 1].min() == 6.0
    assert found(ring - (0, 4))[:, :, 0].max() > 17.0  # this one holds what joins them
    assert edit_judge.within(ring, np.array([(2.0, 7.0), (1.0, 7.0), (2.0, 13.0)])).tolist() == [True, False, False]


def test_of_a_ring_that_leaps_what_the_line_does_not_reach_counts_where_it_is_long():
    points, triangles, at = sheet()
    line = np.array([at(i, 8) for i in range(3, 7)])
    facing = edit_judge.on_line_side(patches.Linked(triangles), line, points[:, :2] * np.where(points[:, :1] > 12.5, (-1, 1), (1, 1)))
    assert facing[points[:, 0] < 12].all() and not facing[points[:, 0] > 13.5].any()
    for long, depth, counts in ((25, 20, False), (35, 20, True), (25, 10, True)):  # px; the last leaps to none
        course = np.c_[np.arange(100.0 + long), np.zeros(100 + long)]
        under = np.zeros(len(course))
        under[60:60 + long] = -depth
        shown = np.where(under == 0, under, -np.inf)
        found = edit_judge.own_stretches(course, under, under, shown)
        assert found[under == 0].all() and (found[60:60 + long] == counts).all()


def test_a_plane_across_a_capped_limb_goes_round_it():
    points, triangles = ball(4)
    middle = points[triangles].mean(1)
    cap = triangles[middle[:, 2] > -0.5]  # the tip of a limb along z
    assert patches.goes_round(points, cap, np.array([1.0, 0.0, 0.03]), np.array([0.0, 0.0, 1.0]))
    assert not patches.goes_round(points, cap, np.array([0.03, 0.0, 1.0]), np.array([1.0, 0.0, 0.0]))  # lengthwise it ends at the ring


def test_a_ring_encloses_what_lies_within():
    points, _, line, ring, patch = enclosed_sheet()
    assert patch.inside.sum() == 2 * 16 * 12 and len(patch.interior) == 15 * 11 and len(patch.vertices) == 17 * 13
    assert patches.half_width(points[line], points[ring]) == 6.0
    # Beside a gap it leaks.
    assert patches.enclosed(patches.Linked(enclosed_sheet()[1]), line, ring[:-1]).inside.all()


def test_ways_and_slopes_on_a_sheet():
    points, _, line, ring, patch = enclosed_sheet()
    s = patches.shares(points, patch, line, ring)
    beside = np.abs(points[patch.vertices, 0] - 10) <= 3
    assert np.abs(s - np.abs(points[patch.vertices, 1] - 8) / 6)[beside].max() < 0.05
    height = 1 - np.abs(points[:, 1] - 8) / 6
    local = [np.searchsorted(patch.vertices, chain) for chain in (line, ring)]
    inner, _ = patches.slope_jumps(points[patch.vertices], patch.local, height[patch.vertices], *local)
    assert inner == pytest.approx(2.0)
    inner, _ = patches.slope_jumps(points[patch.vertices], patch.local, points[patch.vertices, 1], *local)
    assert inner == pytest.approx(0.0, abs=1e-12)


def test_the_plain_map_of_a_flat_disc_is_itself_and_of_a_limb_is_not_even():
    points, triangles = ball(4)
    cap = triangles[(points[triangles][:, :, 2] > 0).all(1)]
    flat = points * (1, 1, 0)
    ids, local = np.unique(cap, return_inverse=True)
    local = local.reshape(-1, 3)
    disc = patches.harmonic(flat[ids], local)
    assert (patches.turn_of(disc, local) > 0).all()
    rim = np.isin(np.arange(len(ids)), np.flatnonzero(points[ids, 2] < 0.12))
    assert patches.spread(flat[ids], disc, local, ~rim) < 1.8
    down = np.arccos(np.clip(points[:, 2], -1, 1))  # a finger: round at its end, then a tube
    limb = np.c_[points[:, :2] * (np.minimum(down / 0.4, 1) / np.maximum(np.sin(down), 1e-9))[:, None], -6 * np.maximum(down - 0.4, 0)]
    disc = patches.harmonic(limb[ids], local)
    assert (patches.turn_of(disc, local) > 0).all() and patches.spread(limb[ids], disc, local, ~rim) > 30


def test_a_plane_cuts_a_ball_in_a_circle():
    points, triangles = ball(4)
    segments = patches.cut(points, triangles, np.zeros(3), np.array([0.0, 0.6, 0.8]))
    assert np.abs(np.linalg.norm(segments, axis=2) - 1).max() < 0.01
    assert np.linalg.norm(segments[:, 1] - segments[:, 0], axis=1).sum() == pytest.approx(2 * np.pi, rel=0.01)
    assert patches.to_segments(np.array([[3.0, 0, 0], [0, 4, -3.0]]), segments) == pytest.approx([2.0, 4.0], abs=0.01)
    assert np.isinf(patches.to_segments(np.zeros((2, 3)), segments[:0])).all()  # a result that the plane does not cut any more


# ------------------------------------------------------------------------------------------- files and defects

@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The files of an edit of a ball: an arc's, drawn by a hand that strays."""
    folder = tmp_path_factory.mktemp("good")
    points, triangles = ball()
    view = picture.View.looking(points, (0.2, 0.3, 1), (0, 1, 0), True, 0.8)
    random = np.random.RandomState(5)
    line = rings.shape_of("arc", 60.0, random) + (400, 300)
    drawn = {"reference": rings.by_hand(line, random), "boundary": rings.by_hand(rings.ring_round(line, 100.0, 0.1), random, True)}
    strokes = {name: stroke_files.polydata(samples, view) for name, samples in drawn.items()}
    mesh = meshes.to_polydata(points, triangles)
    editor = accept.Editor(mesh, strokes["reference"], strokes["boundary"], "default", folder)
    assert accept.put_files(editor, mesh, strokes, "default", True) == {}, editor.messages
    (folder / "run.json").write_text(json.dumps({"mode": "default", "kind": "arc"}))
    return folder


@pytest.fixture
def spoiled(made, tmp_path):
    folder = tmp_path / "spoiled"
    shutil.copytree(made, folder)
    return folder


def rewrite(folder, name, points=None, triangles=None, **arrays):
    """A file of a mesh again, with other points, triangles or point arrays, everything else as it was."""
    old = meshes.read(folder / f"{name}.vtp")
    new = meshes.to_polydata(vtk_to_numpy(old.GetPoints().GetData()) if points is None else points,
                             meshes.arrays(old)[1] if triangles is None else triangles)
    for k in range(old.GetPointData().GetNumberOfArrays()):
        new.GetPointData().AddArray(old.GetPointData().GetArray(k))
    new.GetFieldData().ShallowCopy(old.GetFieldData())
    for array, values in arrays.items():
        data = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        data.SetName(array)
        new.GetPointData().AddArray(data)
    saved.write(new, folder / f"{name}.vtp")


def chain_file(folder, name, points, chain):
    """A curve along vertices."""
    curve = vtkPolyData()
    closed = chain[0] == chain[-1]
    ids = np.arange(len(chain) - closed)
    curve.SetPoints(meshes.to_polydata(points[chain[:len(ids)]], []).GetPoints())
    from vtkmodules.vtkCommonDataModel import vtkCellArray
    line = vtkCellArray()
    line.InsertNextCell(len(chain))
    for i in [*ids, *([0] if closed else [])]:
        line.InsertCellPoint(int(i))
    curve.SetLines(line)
    data = numpy_to_vtk(np.asarray(chain[:len(ids)], np.int64), deep=True)
    data.SetName("VertexId")
    curve.GetPointData().AddArray(data)
    saved.write(curve, folder / f"{name}.vtp")


def fails(folder):
    return edit_judge.judge(folder)["fails"]


def test_an_edit_that_is_right_holds_every_bound(made):
    result = edit_judge.judge(made)
    assert result["holds"], result
    assert {name for name, _, _ in edit_judge.BOUNDS} - set(result["asks"]) <= {"spread"}  # which is of limbs
    assert result["patch"] >= edit_judge.FEW


def region_by_pixels(folder):
    """What the ring holds in the picture moves, on the far side too."""
    case = edit_judge.Case(folder)
    _, samples, view, _ = stroke_files.read(folder / "boundary.vtp")
    xy, _ = view.display(case.rest.points)
    at = np.clip(np.floor(xy).astype(int), 0, (view.width - 1, view.height - 1))
    within = picture.inside_polygon(samples)[at[:, 1], at[:, 0]] & (view.display(case.rest.points)[1] < view.display(np.zeros((1, 3)))[1])
    move = case["off"].points[case.line[0]] - case.rest.points[case.line[0]]
    rewrite(folder, "region", EditRegion=np.where(within, 2, case.rest.point["EditRegion"]).astype(np.uint8))
    rewrite(folder, "off", case["off"].points + within[:, None] * move)
    return "region"


def falloff_by_a_ball(folder):
    """Weights go by the distance from the line's middle."""
    case = edit_judge.Case(folder)
    away = np.linalg.norm(case.rest.points - case.rest.points[case.line[len(case.line) // 2]], axis=1)
    b = np.clip(away / away[case.ring].max(), 0, 1)
    inside = np.isin(np.arange(len(away)), case.patch.interior)
    rewrite(folder, "region", EditWeight=np.where(inside, 1 - 3 * b ** 2 + 2 * b ** 3, 0.0))
    return "share"


def curve_on_the_nearest_vertices(folder):
    """Curves along edges that were there, from vertex to vertex."""
    case = edit_judge.Case(folder)
    points, triangles = case.input.points, case.input.triangles
    mesh, chains = meshes.to_polydata(points, triangles), {}
    nearest = lambda p: int(np.argmin(((points - p) ** 2).sum(1)))
    for name, curve in (("line", case.line), ("ring", case.ring)):
        stops = [nearest(p) for p in case.rest.points[curve[::4]]]
        stops += [stops[0]] if name == "ring" else []
        chain = [stops[0]]
        for a, b in zip(stops, stops[1:]):
            if a == b:
                continue
            way = vtkDijkstraGraphGeodesicPath()
            way.SetInputData(mesh)
            way.SetStartVertex(b)  # it goes from the end to the start
            way.SetEndVertex(a)
            way.Update()
            ids = way.GetIdList()
            chain += [ids.GetId(k) for k in range(1, ids.GetNumberOfIds())]
        chains[name] = np.array(chain)
        assert len(np.unique(chain)) >= len(chain) - (name == "ring")
    for file in folder.glob("*.vtp"):
        if file.stem not in ("input", "reference", "boundary", "region"):
            file.unlink()
    patch = patches.enclosed(patches.Linked(triangles), chains["line"], chains["ring"])
    of = np.array([int(np.argmin(((case.rest.points[case.patch.vertices] - p) ** 2).sum(1))) for p in points[patch.vertices]])
    taken = lambda name: case.rest.point[name][case.patch.vertices][of]
    arrays = {"EditRegion": np.zeros(len(points), np.uint8), "EditWeight": np.zeros(len(points)), "CurveParameter": np.zeros(len(points)),
              "DiscCoords": np.full((len(points), 2), -1.0)}
    for name, values in arrays.items():
        values[patch.vertices] = taken(name)
    arrays["EditRegion"][:] = 0
    arrays["EditRegion"][patch.interior] = 2
    arrays["EditWeight"][arrays["EditRegion"] < 2] = 0
    arrays["EditWeight"][chains["line"]] = 1
    shutil.copy(folder / "input.vtp", folder / "region.vtp")
    rewrite(folder, "region", **arrays)
    for name, chain in chains.items():
        chain_file(folder, name, points, chain)
    return "px"


def points_blended_linearly(folder):
    """Each vertex goes its share of the straight way."""
    case = edit_judge.Case(folder)
    weight, whole = case.rest.point["EditWeight"][:, None], case["turned"].points
    frame = case["handles"].point["Frame"][0].reshape(4, 4)
    axis, place = frame[:3, 0], frame[:3, 3]
    d, angle = case.rest.points - place, np.radians(edit_judge.TURN)
    full = place + d * np.cos(angle) + np.cross(axis, d) * np.sin(angle) + np.outer(d @ axis, axis) * (1 - np.cos(angle))
    assert np.abs((full - whole)[case.line]).max() < 1e-9  # where the weight is 1 both are one
    rewrite(folder, "turned", case.rest.points + weight * (full - case.rest.points))
    return "turned"


def profile_as_a_bump_of_its_height(folder):
    """The region rises by the height of what was drawn, whatever its shape."""
    case = edit_judge.Case(folder)
    matrix = case["profile"].field["ProfileMatrix"].reshape(4, 4)
    height = np.max((case["asked"].points - case["profile"].points)[:, 1]) * np.linalg.norm(matrix[:3, 1])
    up = matrix[:3, 1] / np.linalg.norm(matrix[:3, 1])
    shutil.copy(folder / "region.vtp", folder / "profiled.vtp")
    rewrite(folder, "profiled", case.rest.points + height * case.rest.point["EditWeight"][:, None] * up)
    for name in ("line", "ring"):
        shutil.copy(folder / f"{name}.vtp", folder / f"profiled_{name}.vtp")
    return "recut"


def flipped(faces, inside, points):
    """Triangles with as many pairs of those inside swapped as can be."""
    linked, result, used = patches.Linked(faces), faces.copy(), ~inside
    for t in np.flatnonzero(inside):
        for k in range(3):
            other = linked.beyond[t, k]
            if used[t] or other < 0 or used[other]:
                continue
            a, b, c = np.roll(faces[t], -k)
            d = faces[other].sum() - a - b
            result[t], result[other] = (a, d, c), (d, b, c)
            used[t] = used[other] = True
    return result


def region_remeshed_whole(folder):
    """New triangles all over the region, also where the edit did nothing."""
    mesh, patch = edit_judge.Case(folder).enclosed("part")
    rewrite(folder, "part", triangles=flipped(mesh.triangles, patch.inside, mesh.points))
    return "kept"


def unmoved_region_remeshed(folder):
    """And where nothing moved at all."""
    mesh = saved.read(folder / "zero.vtp")
    rewrite(folder, "zero", triangles=flipped(mesh.triangles, mesh.points[mesh.triangles][:, :, 2].mean(1) > 0.8, mesh.points))
    return "as it was"


def moved_outside_the_ring(folder):
    """A vertex far from the region is not where it was, by next to nothing."""
    points = saved.read(folder / "dragged.vtp").points.copy()
    points[np.argmin(points[:, 2])] += 1e-9
    rewrite(folder, "dragged", points)
    return "far"


def moved_beside_the_ring(folder):
    """One next to the ring is not."""
    case = edit_judge.Case(folder)
    beside = np.unique(case.rest.triangles[np.isin(case.rest.triangles, case.ring).any(1) & ~case.patch.inside])
    points = case["off"].points.copy()
    points[beside[~np.isin(beside, case.ring)][0]] += 1e-6
    rewrite(folder, "off", points)
    return "region"


def the_ring_too(folder):
    """The ring itself moves."""
    case = edit_judge.Case(folder)
    points = case["off"].points.copy()
    points[case.ring] += 1e-6
    rewrite(folder, "off", points)
    return "region"


def a_fold_of_the_disc(folder):
    case = edit_judge.Case(folder)
    disc = case.rest.point["DiscCoords"].copy()
    disc[case.patch.interior[50]] = disc[case.patch.interior[-1]]
    rewrite(folder, "region", DiscCoords=disc)
    return "flips"


def a_gap_in_the_ring(folder):
    case = edit_judge.Case(folder)
    chain = patches.chain(case["dragged_ring"])
    chain_file(folder, "dragged_ring", case["dragged"].points, np.r_[chain[:10], chain[11:]])
    return "curves"


def two_vertices_at_one_place(folder):
    mesh = saved.read(folder / "dragged.vtp")
    points, far = mesh.points.copy(), np.argsort(mesh.points[:, 2])[-2:]
    points[far[0]] = points[far[1]]
    rewrite(folder, "dragged", points)
    return "sound"


def three_triangles_at_an_edge(folder):
    mesh = saved.read(folder / "part.vtp")
    rewrite(folder, "part", triangles=np.vstack([mesh.triangles, [[*mesh.triangles[0, :2], mesh.triangles[-1, 0]]]]))
    return "sound"


def weights_fall_evenly(folder):
    case = edit_judge.Case(folder)
    s = np.ones(len(case.rest.points))
    s[case.patch.vertices] = patches.shares(case.rest.points, case.patch, case.line, case.ring)
    rewrite(folder, "region", EditWeight=1 - s)
    return "line slope"


def a_parameter_that_jumps(folder):
    case = edit_judge.Case(folder)
    rewrite(folder, "region", CurveParameter=np.where(case.rest.points[:, 1] > 0.1, 0.9, 0.1))
    return "tau step"


def moved_by_half_as_much(folder):
    case = edit_judge.Case(folder)
    rewrite(folder, "off", 0.5 * (case["off"].points + case.rest.points))
    return "drag"


def no_new_triangles(folder):
    """The edit's mesh as it was moved."""
    for name in ("line", "ring"):
        shutil.copy(folder / f"{name}.vtp", folder / f"dragged_{name}.vtp")
    shutil.copy(folder / "off.vtp", folder / "dragged.vtp")
    return "dihedral"


def crumpled(folder):
    """Many vertices of the region pushed through their neighbours."""
    mesh, patch = edit_judge.Case(folder).enclosed("dragged")
    points = mesh.points.copy()
    for v in patch.interior[::9]:
        points[v] *= 0.8
    rewrite(folder, "dragged", points)
    return "folds"


def needles_at_the_line(folder):
    """Curve vertices drawn together along the line."""
    case = edit_judge.Case(folder)
    points = case.rest.points.copy()
    for chain in (case.line, case.ring[:-1]):
        for i in range(1, len(chain) - 1, 2):
            points[chain[i]] = 0.03 * points[chain[i]] + 0.97 * points[chain[i - 1]]
    for name in ("off", "turned", "part_off"):
        rewrite(folder, name, saved.read(folder / f"{name}.vtp").points + points - case.rest.points)
    rewrite(folder, "region", points)
    return "curve angle"


def the_line_cut_short(folder):
    case = edit_judge.Case(folder)
    chain_file(folder, "line", case.rest.points, case.line[:len(case.line) * 2 // 3])
    return "covered"


def no_result_of_black(folder):
    (folder / "black.vtp").unlink()
    return "as it was"


DEFECTS = (region_by_pixels, falloff_by_a_ball, curve_on_the_nearest_vertices, points_blended_linearly, profile_as_a_bump_of_its_height,
           region_remeshed_whole, unmoved_region_remeshed, moved_outside_the_ring, moved_beside_the_ring, the_ring_too, a_fold_of_the_disc,
           a_gap_in_the_ring, two_vertices_at_one_place, three_triangles_at_an_edge, weights_fall_evenly, a_parameter_that_jumps,
           moved_by_half_as_much, no_new_triangles, crumpled, needles_at_the_line, the_line_cut_short, no_result_of_black)


@pytest.mark.parametrize("defect", DEFECTS, ids=lambda defect: defect.__name__)
def test_a_defect_fails_its_row(spoiled, defect):
    row = defect(spoiled)
    found = fails(spoiled)
    assert row in found, f"{row} is not among {found}"


def test_what_is_asked_depends_on_the_mode(made, spoiled):
    (spoiled / "run.json").write_text(json.dumps({"mode": "published", "kind": "arc"}))
    result = edit_judge.judge(spoiled)
    assert {"angle", "turned", "as it was", "spread"}.isdisjoint(result["asks"])
    assert {"line slope", "ring slope"} <= set(result["fails"])  # as published, weights fall evenly
    assert edit_judge.recut_bound(result) == 1.1


def test_enough_regions_have_to_stand():
    good, none = {"stands": True, "holds": True, "fails": []}, {"stands": False, "holds": False, "fails": ["stands"]}
    assert accept.enough({str(k): none if k < 17 else good for k in range(100)})
    assert not accept.enough({str(k): none if k < 18 else good for k in range(100)})
    missed = {**good, "holds": False, "fails": ["angle"]}
    assert accept.enough({str(k): missed if k < 5 else good for k in range(100)})
    assert not accept.enough({str(k): missed if k < 6 else good for k in range(100)})
    assert not accept.enough({"a": good, "b": {"holds": False, "fails": ["crash or hang"]}})
    half = {"half stands": False, "holds": False, "fails": ["half stands"]}
    assert not accept.enough({"a": good, "b": half})
