"""The judge of augmentations is judged: files of steps that are right hold every bound, and a defect seeded into one of them fails
its row. The model is a plane of quads, made here without Oversketch, with a line along its edges, refined by hand."""
import json
import sys
from pathlib import Path

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parent)]
import feature_judge  # noqa: E402
import forest  # noqa: E402
import measure  # noqa: E402
import saved  # noqa: E402

N, RADIUS, HEIGHT = 8, 1.6, 0.8  # quads a side of length 1


class Mesh:
    """A 4-8 mesh of paired quads in lists: split by the published rule, generation by generation, all over."""

    def __init__(self):
        self.points = np.array([(i, j, 0.0) for j in range(N + 1) for i in range(N + 1)])
        faces = []
        for j in range(N):
            for i in range(N):
                a = j * (N + 1) + i
                b, c, d = a + 1, a + N + 2, a + N + 1
                faces += [(b, c, a), (d, a, c)]
        self.triangles, self.root = np.array(faces), np.arange(len(faces))
        self.path, self.gen = np.ones(len(faces), np.uint64), np.zeros(len(faces), np.uint8)
        self.arrays = {}

    def split(self):
        p, a, c = self.triangles.T
        ends, inverse = np.unique(np.sort(np.c_[a, c], axis=1), axis=0, return_inverse=True)
        m = len(self.points) + inverse.ravel()
        self.points = np.vstack([self.points, self.points[ends].mean(1)])
        self.triangles = np.stack([np.c_[m, p, a], np.c_[m, c, p]], axis=1).reshape(-1, 3)
        self.root, self.gen = np.repeat(self.root, 2), np.repeat(self.gen + np.uint8(1), 2)
        two = np.uint64(2)
        self.path = np.stack([self.path * two, self.path * two + np.uint64(1)], axis=1).ravel()
        return self

    def copy(self):
        other = Mesh.__new__(Mesh)
        other.__dict__ = {name: value.copy() for name, value in self.__dict__.items()}
        return other

    def snap(self):
        """Those on the line y = N / 2 are snapped to it."""
        on = self.points[:, 1] == N / 2
        self.arrays = {"CurveId": np.where(on, 0, -1).astype(np.int32), "CurveParam": np.where(on, self.points[:, 0] - 0.5, 0.0)}
        return self


def share(points):
    """The profile over the distance to the line."""
    beyond = np.maximum(np.abs(points[:, 0] - N / 2) - (N / 2 - 0.5), 0.0)
    return np.maximum(1 - np.hypot(points[:, 1] - N / 2, beyond) / RADIUS, 0.0) ** 1.5


def polydata(points, triangles=(), line=(), cell=None, point=None):
    mesh, at = vtkPolyData(), vtkPoints()
    at.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    mesh.SetPoints(at)
    for ids, put in ((triangles, mesh.SetPolys), ([line] if len(line) else (), mesh.SetLines)):
        cells = vtkCellArray()
        for one in ids:
            cells.InsertNextCell(len(one), [int(i) for i in one])
        put(cells)
    for data, arrays in ((mesh.GetCellData(), cell or {}), (mesh.GetPointData(), point or {})):
        for name, values in arrays.items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            data.AddArray(array)
    return mesh


def write(mesh, path):
    cell = {"StellarRoot": mesh.root.astype(np.int32), "StellarPath": mesh.path, "StellarGen": mesh.gen}
    point = {"CurveId": np.full(len(mesh.points), -1, np.int32), "CurveParam": np.zeros(len(mesh.points)), **mesh.arrays}
    saved.write(polydata(mesh.points, mesh.triangles, cell=cell, point=point), path)


class Run:
    """The files of a run that is as it should be; a test spoils one before they are written."""

    def __init__(self):
        self.base = Mesh()
        self.input = self.base.copy()
        self.refined = self.base.copy()
        for _ in range(5):
            self.refined.split()
        self.snapped = self.refined.copy().snap()
        self.smoothed = self.snapped.copy()
        self.displaced = self.smoothed.copy()
        self.displaced.arrays = {}
        self.displaced.points[:, 2] = HEIGHT * share(self.smoothed.points)
        self.output = self.displaced.copy()
        self.curve = np.c_[np.linspace(0.5, N - 0.5, 60), np.full(60, N / 2), np.zeros(60)]
        self.facts = {"radius": RADIUS, "height": HEIGHT, "sharpness": 1.5, "sketched": False,
                      "seconds": {"Refine": 0.01, "Snap": 0.02, "Displace": 0.01}}

    def judged(self, folder, about=("terrain", "bunny", "time")):
        for name in feature_judge.FILES:
            if name != "curves":
                write(getattr(self, name), folder / f"{name}.vtp")
        saved.write(polydata(self.curve, line=range(len(self.curve))), folder / "curves.vtp")
        (folder / "run.json").write_text(json.dumps(self.facts))
        return feature_judge.judge(folder, about)

    def rise(self, shares):
        """Both last files with other shares of the height."""
        for mesh in (self.displaced, self.output):
            mesh.points[:, 2] = HEIGHT * shares


# What the plane, refined all over, cannot hold: it keeps no triangle whole.
ALWAYS = {"kept"}


def failing(run, folder, about=("terrain", "bunny", "time")):
    result = run.judged(folder, about)
    return set(result["fails"]) - ALWAYS, set(result["lacks"]), result


def test_a_run_as_it_should_be_holds(tmp_path):
    fails, lacks, result = failing(Run(), tmp_path)
    assert not fails and not lacks
    assert result["crest mean"] == pytest.approx(1) and result["peak"] == pytest.approx(1) and result["lateral"] < 1e-12
    assert result["angle ratio"] == pytest.approx(1) and 0.25 / 2 ** 0.5 / RADIUS < result["near edge"] < 0.25 / RADIUS
    assert result["residual"] == 0 and result["far moved"] == 0 and result["seconds"] == pytest.approx(0.04)


def change(mesh, where, by):
    mesh.points[where] += by


def at(mesh, x, y):
    return int(np.argmin(((mesh.points[:, :2] - (x, y)) ** 2).sum(1)))


def path_changed(run):
    run.displaced.path[7] += np.uint64(1)


def generation_changed(run):
    run.snapped.gen[3] += np.uint8(1)


def newest_not_first(run):
    run.refined.triangles[5] = np.roll(run.refined.triangles[5], 1)


def face_missing(run):
    for name in ("triangles", "root", "path", "gen"):
        setattr(run.output, name, np.delete(getattr(run.output, name), [0, 1], axis=0))


def base_point_moved(run):
    change(run.refined, 0, (1e-12, 0, 0))


@pytest.mark.parametrize("defect", [path_changed, generation_changed, newest_not_first, face_missing, base_point_moved])
def test_structure(tmp_path, defect):
    run = Run()
    defect(run)
    assert "structure" in failing(run, tmp_path)[0]


def test_a_hole_and_a_handle_change_the_topology(tmp_path):
    run = Run()
    whole = forest.topology(run.base.triangles)
    assert whole == (1, 1, 0)
    inside = np.flatnonzero((run.base.points[run.base.triangles].mean(1)[:, :2] - 4.5 < 0.3).all(1))[0]
    centre = np.flatnonzero((np.abs(run.base.points[run.base.triangles].mean(1)[:, :2] - 4.5) < 0.4).all(1))[:1]
    assert forest.topology(np.delete(run.base.triangles, centre, axis=0)) == (0, 2, 0)
    assert forest.topology(np.vstack([run.base.triangles, run.base.triangles[inside]]))[2] > 0


def test_angles_after_refining(tmp_path):
    run = Run()
    for mesh in (run.refined, run.snapped, run.smoothed, run.displaced, run.output):
        change(mesh, at(mesh, 1.25, 1.25), (0.17, 0.0, 0))
    fails, _, result = failing(run, tmp_path)
    assert {"angle ratio", "structure"} <= fails and result["angle ratio"] < 0.6


def test_edges_near_the_curve(tmp_path):
    run = Run()
    run.refined = run.base.copy()  # nothing was refined
    run.refined.split()
    assert "near edge" in failing(run, tmp_path)[0]


def test_a_degenerate_triangle(tmp_path):
    run = Run()
    a, b = at(run.snapped, 3.0, 3.0), at(run.snapped, 3.25, 3.0)
    run.snapped.points[a] = run.snapped.points[b]
    fails, lacks, _ = failing(run, tmp_path)
    assert "degenerate" in fails and "smallest angle" in lacks


def test_a_narrow_triangle_is_not_excellent(tmp_path):
    run = Run()
    change(run.snapped, at(run.snapped, 3.0, 3.0), (0.235, 0.0, 0.0))
    fails, lacks, result = failing(run, tmp_path)
    assert "smallest angle" in lacks and "degenerate" not in fails and 0.05 < result["smallest angle"] < 4.5


def test_a_flipped_triangle(tmp_path):
    run = Run()
    change(run.smoothed, at(run.smoothed, 3.0, 3.0), (0.4, 0.05, 0.0))
    assert "flipped" in failing(run, tmp_path)[0]


@pytest.mark.parametrize("count", [1, 0])
def test_residual(tmp_path, count):
    run = Run()
    run.curve[:, 1] += 0.05  # beside the edges that the vertices stand on
    loose = np.flatnonzero(run.snapped.arrays["CurveId"] >= 0)
    # Snapped ones go with the curve; of them `count` are left behind, unsnapped.
    for mesh in (run.snapped, run.smoothed):
        mesh.points[loose, 1] += 0.05
        mesh.arrays["CurveId"][loose[10:10 + count]] = -1
        mesh.points[loose[10:10 + count], 1] -= 0.05
    _, _, result = failing(run, tmp_path)
    assert (result["left"] > 0) == (count > 0) and result["crossings"] > 50
    assert ("residual" in result["fails"]) == (count > 0)


def test_added_faces(tmp_path):
    run = Run()
    for mesh in (run.snapped, run.smoothed):
        mesh.split()
        mesh.snap()
    run.displaced, run.output = run.smoothed.copy(), run.smoothed.copy()
    run.rise(share(run.smoothed.points))
    fails, lacks, _ = failing(run, tmp_path)
    assert "added" in fails and "added" in lacks


def test_a_nick_in_the_crest(tmp_path):
    run = Run()
    shares = share(run.smoothed.points)
    shares[at(run.smoothed, 4.0, 4.0)] = 0.8
    run.rise(shares)
    fails, lacks, result = failing(run, tmp_path)
    assert "crest min" in fails and {"crest min"} <= lacks and result["crest mean"] < 1
    shares[at(run.smoothed, 4.0, 4.0)] = 0.88
    run.rise(shares)
    fails, lacks, _ = failing(run, tmp_path)
    assert "crest min" not in fails and "crest min" in lacks


def test_a_crest_that_is_too_low_or_on_the_other_side(tmp_path):
    run = Run()
    run.rise(0.985 * share(run.smoothed.points))
    assert "crest mean" in failing(run, tmp_path)[0]
    run.rise(-share(run.smoothed.points))
    assert {"crest mean", "crest min", "profile"} <= failing(run, tmp_path)[0]


def test_edges_beside_the_curve(tmp_path):
    run = Run()
    run.curve[:, 1] += 0.03 * RADIUS
    fails, lacks, result = failing(run, tmp_path)
    assert "lateral" in fails and "lateral" in lacks and result["lateral"] == pytest.approx(0.03)
    run.curve[:, 1] -= 0.02 * RADIUS
    fails, lacks, _ = failing(run, tmp_path)
    assert "lateral" not in fails and "lateral" in lacks


def test_another_profile(tmp_path):
    run = Run()
    run.rise(share(run.smoothed.points) ** (1.0 / 1.5))
    fails, lacks, result = failing(run, tmp_path)
    assert "profile" in fails and "profile" in lacks and result["profile"] > 0.03


def test_a_peak_over_one(tmp_path):
    run = Run()
    shares = share(run.smoothed.points)
    shares[at(run.smoothed, 4.0, 4.0)] = 1.001
    run.rise(shares)
    fails, lacks, _ = failing(run, tmp_path)
    assert not fails and lacks == {"peak"}


def test_faces_that_the_feature_turns_over(tmp_path):
    run = Run()
    for mesh in (run.displaced, run.output):
        change(mesh, at(mesh, 4.0, 4.5), (0.9, 0.0, 0.0))
    fails, lacks, result = failing(run, tmp_path)
    assert result["turned"] > 0 and "terrain flipped" in lacks and ("terrain flipped" in fails) == (result["terrain flipped"] > 0.01)


def test_rough_flanks(tmp_path):
    run = Run()
    shares = share(run.smoothed.points)
    flank = (shares > 0) & (shares < 1)
    shares[flank] *= 1 + 0.5 * (np.arange(flank.sum()) % 2)
    run.rise(np.minimum(shares, 0.99))
    fails, lacks, result = failing(run, tmp_path)
    assert "dihedral" in fails and "dihedral" in lacks and result["dihedral"] > 20


def test_a_leap_of_the_curve(tmp_path):
    run = Run()
    run.curve = run.curve[[0, 1, 2, 30, 59]]
    fails, lacks, result = failing(run, tmp_path)
    assert "segment" in fails and "segment" in lacks and result["segment"] > 1


def test_slow_steps(tmp_path):
    run = Run()
    run.facts["seconds"]["Snap"] = 0.5
    fails, lacks, _ = failing(run, tmp_path)
    assert "seconds" in lacks and "seconds" not in fails
    run.facts["seconds"]["Snap"] = 1.5
    assert "seconds" in failing(run, tmp_path)[0]


def test_a_point_far_from_the_curve_that_moved(tmp_path):
    run = Run()
    run.rise(0.0)
    run.facts["radius"] = 0.2  # far is then beyond 0.2 + 3 times the longest base edge
    run.curve = np.c_[np.linspace(0.1, 0.9, 20), np.full(20, 0.4), np.zeros(20)]
    result = run.judged(tmp_path, ())
    assert result["far moved"] == 0
    change(run.output, at(run.input, 8, 8), (0, 0, 1e-12))
    assert run.judged(tmp_path, ())["far moved"] == 1


def test_triangles_that_are_still_there(tmp_path):
    run = Run()
    assert run.judged(tmp_path)["kept"] == 0
    run.output = run.base.copy()
    result = run.judged(tmp_path)
    assert result["kept"] == result["kept in place"] == 1 and "kept" not in result["fails"]
    change(run.output, 0, (0, 0, 1e-12))
    assert run.judged(tmp_path)["kept in place"] < 1


# ------------------------------------------------------------------------------------------ against plain loops

def test_pairs_and_distances_are_those_of_plain_loops():
    random = np.random.default_rng(3)
    a, b = random.uniform(-1, 1, (300, 3)), random.uniform(-1, 1, (200, 3))
    i, j = measure.near_pairs(a, b, 0.3)
    expected = np.argwhere(np.linalg.norm(a[:, None] - b, axis=2) <= 0.3)
    assert sorted(zip(i.tolist(), j.tolist())) == sorted(map(tuple, expected.tolist()))
    line = np.cumsum(random.normal(0, 0.2, (30, 3)), axis=0)
    pieces = measure.pieces(line, [np.arange(30)], 0.05)
    exact = np.full(len(a), np.inf)
    for p, q in zip(line[:-1], line[1:]):
        t = np.clip(((a - p) @ (q - p)) / ((q - p) @ (q - p)), 0, 1)
        exact = np.minimum(exact, np.linalg.norm(a - p - t[:, None] * (q - p), axis=1))
    found = measure.distance(a, pieces, 0.5)
    assert np.allclose(found[exact < 0.5], exact[exact < 0.5], atol=1e-12) and np.isinf(found[exact > 0.5]).all()


def test_nearest_place_on_triangles():
    a, b, c = np.array([[0.0, 0, 0]]), np.array([[1.0, 0, 0]]), np.array([[0.0, 1, 0]])
    for point, weights, square in (((0.25, 0.25, 2), (0.5, 0.25, 0.25), 4), ((-1, -1, 0), (1, 0, 0), 2), ((1, 1, 0), (0, 0.5, 0.5), 0.5)):
        found, away = measure.on_triangles(np.array([point], float), a, b, c)
        assert np.allclose(found, [weights]) and away == pytest.approx([square])
