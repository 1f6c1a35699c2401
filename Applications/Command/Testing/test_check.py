"""Checks for printing by the command: what is said of cubes with one fault each, colours, the report; and 3MF files as others read them."""
import json
import xml.etree.ElementTree as xml
import zipfile

import numpy
import pytest

from scene import *  # noqa: F403

CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
DOG = SOURCE / "Data" / "Models" / "dog.ply"
SIDES = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]


def box(x, y, z, at=(0, 0, 0)):
    corners = numpy.array([[(i & 1) * x, (i >> 1 & 1) * y, (i >> 2) * z] for i in range(8)], float)
    return corners + at


def checked(tmp_path, points, faces, *options):
    path = write(polydata(points, faces), tmp_path / "mesh.vtp")
    done = run("check", path, "--report", tmp_path / "check.json", *options)
    assert done.stderr == "", done.stderr
    report = json.loads((tmp_path / "check.json").read_text())
    assert report["command"] == "check" and report["check"]["words"] == done.stdout.splitlines()
    assert done.returncode == (0 if report["check"]["ready"] else 1)
    assert done.stdout.endswith("Ready to print.\n" if done.returncode == 0 else "Not ready to print.\n")
    return report["check"], done.stdout


def test_a_cube_is_ready_and_sizes_are_millimetres(tmp_path):
    cube = box(10, 10, 10)
    figures, words = checked(tmp_path, cube, SIDES, "--wall", "9.9")
    assert figures["least_wall"] == pytest.approx(10, abs=1e-9) and figures["bodies"][0]["volume"] == pytest.approx(1000)
    assert "Size: 10 x 10 x 10 mm." in words and "Thinnest wall: 10 mm." in words
    assert figures["open_edges"] == figures["turned_edges"] == figures["crowded_edges"] == figures["crossing_pairs"] == 0
    for unit, size in (("cm", 100), ("in", 254), ("0.5", 5)):
        figures, words = checked(tmp_path, cube, SIDES, "--unit", unit, "--wall", str(0.99 * size))
        assert figures["size"] == pytest.approx([size] * 3) and f"Size: {size} x {size} x {size} mm." in words
    assert checked(tmp_path, cube, SIDES, "--wall", "57%")[0]["ready"]  # a side is 57.7 % of the diagonal
    assert not checked(tmp_path, cube, SIDES, "--wall", "58%")[0]["ready"]


def test_each_fault_is_said_with_its_remedy(tmp_path):
    cube, other = box(10, 10, 10), box(10, 10, 10, (5, 3, 2))
    turned = [SIDES[0][::-1]] + SIDES[1:]
    second = [(a + 8, b + 8, c + 8) for a, b, c in SIDES]
    for points, faces, member, value, says in (
            (cube, SIDES[1:], "open_edges", 3, "Fill the holes."),
            (cube, turned, "turned_edges", 3, "Turn the faces on one side of them."),
            (cube, SIDES + SIDES[:1], "crowded_edges", 3, "Take faces away that are there twice"),
            (numpy.vstack([cube, other]), SIDES + second, "crossing_pairs", None, "Move the bodies apart or join them"),
            (cube, [face[::-1] for face in SIDES], "ready", False, "Bodies that are inside out: 1. Turn their faces.")):
        figures, words = checked(tmp_path, points, faces)
        assert not figures["ready"] and says in words, words
        assert figures[member] == value or (value is None and figures[member] > 0)


def test_thin_walls_are_red_and_faulty_faces_black(tmp_path):
    slab = box(10, 10, 0.4)
    figures, words = checked(tmp_path, slab, SIDES, "--wall", "0.8", "-o", tmp_path / "coloured.vtp")
    assert figures["thin_area"] == pytest.approx(200) and "Walls thinner than 0.8 mm" in words
    data = read(tmp_path / "coloured.vtp").GetCellData()
    colours, walls = vtk_to_numpy(data.GetArray("RGB")).astype(int), vtk_to_numpy(data.GetArray("Wall"))
    red = colours[:, 0] > 180
    assert numpy.array_equal(red & (colours[:, 2] < 120), walls < 0.8) and (walls < 0.8).sum() == 4
    assert (colours[walls > 0.8, 2] > 170).all()
    checked(tmp_path, box(10, 10, 10), SIDES[1:], "-o", tmp_path / "coloured.vtp")
    data = read(tmp_path / "coloured.vtp").GetCellData()
    black = vtk_to_numpy(data.GetArray("RGB")).max(axis=1) < 40
    assert numpy.array_equal(black, vtk_to_numpy(data.GetArray("Faulty")) == 1) and black.sum() == 3


@pytest.mark.parametrize("name", ["mesh.ply", "mesh.off", "mesh.stl"])
def test_formats_of_faces_keep_the_colours(tmp_path, name):
    mesh = write(polydata(box(10, 10, 0.4), SIDES), tmp_path / "slab.vtp")
    assert run("check", mesh, "--wall", "0.8", "-o", tmp_path / name).returncode == 1
    again = tmp_path / "again.vtp"
    assert run("transform", tmp_path / name, "-o", again).returncode == 0
    colours = vtk_to_numpy(read(again).GetCellData().GetArray("RGB")).astype(int)
    assert (colours[:4, 0] > 200).all() and (colours[:4, 2] < 120).all() and (colours[4:, 2] > 170).all()


def test_what_makes_no_sense_is_refused(tmp_path):
    for arguments in (["check"], ["check", DOG, DOG], ["check", DOG, "--wall", "-1"], ["check", DOG, "--wall", "thin"], ["check", DOG, "--unit", "0"],
                      ["check", DOG, "--unit", "ell"], ["check", DOG, "-o", tmp_path / "a.glb"], ["check", DOG, "-o", tmp_path / "a.3mf"]):
        refuse(2, *arguments)
    refuse(1, "check", tmp_path / "none.ply")
    assert "check MESH" in run("--help").stdout and "--wall" in run("check", "--help").stdout


def objects_of(path):
    """[(vertices, triangles)] of a 3MF file, after the laws of its container."""
    with zipfile.ZipFile(path) as package:
        assert package.testzip() is None
        kinds = xml.fromstring(package.read("[Content_Types].xml"))
        assert {kind.get("Extension"): kind.get("ContentType") for kind in kinds} == {
            "rels": "application/vnd.openxmlformats-package.relationships+xml",
            "model": "application/vnd.ms-package.3dmanufacturing-3dmodel+xml"}
        relation, = xml.fromstring(package.read("_rels/.rels"))
        assert relation.get("Type") == "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
        model = xml.fromstring(package.read(relation.get("Target").lstrip("/")))
    assert model.tag == CORE + "model" and model.get("unit") == "millimeter"
    found = []
    for one in model.iter(CORE + "object"):
        vertices = numpy.array([[float(v.get(k)) for k in "xyz"] for v in one.iter(CORE + "vertex")])
        triangles = numpy.array([[int(t.get(k)) for k in ("v1", "v2", "v3")] for t in one.iter(CORE + "triangle")])
        assert triangles.max() < len(vertices) and all(len(set(t)) == 3 for t in triangles.tolist())
        found.append((vertices, triangles))
    items = [item.get("objectid") for item in model.iter(CORE + "item")]
    assert items == [one.get("id") for one in model.iter(CORE + "object")]
    return found


def test_3mf_keeps_every_bit_and_is_closed_over_seams(tmp_path):
    numbers = numpy.random.default_rng(5)
    mesh = body()
    points = points_of(mesh) * numpy.pi + numbers.random(3)
    split = polydata(points[triangles_of(mesh)].reshape(-1, 3), numpy.arange(3 * mesh.GetNumberOfPolys()).reshape(-1, 3))
    write(split, tmp_path / "split.vtp")
    for copy in ("a.3mf", "b.3mf"):
        assert run("transform", tmp_path / "split.vtp", "-o", tmp_path / copy).returncode == 0
    assert (tmp_path / "a.3mf").read_bytes() == (tmp_path / "b.3mf").read_bytes()
    (vertices, triangles), = objects_of(tmp_path / "a.3mf")
    assert numpy.array_equal(vertices[triangles], points[triangles_of(mesh)])
    edges = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    assert (numpy.unique(edges, axis=0, return_counts=True)[1] == 2).all(), "torn along the seams"


def test_3mf_has_an_object_for_each_part(tmp_path):
    write(polydata(box(1, 1, 1), SIDES), tmp_path / "cube.vtp")
    (tmp_path / "parts.json").write_text(json.dumps({"parts": [{"mesh": "cube.vtp"}, {"mesh": "cube.vtp", "depth": 3}]}))
    done = run("assemble", tmp_path / "parts.json", "-o", tmp_path / "cubes.3mf")
    assert done.returncode == 0 and done.stderr == "", done.stderr
    first, second = objects_of(tmp_path / "cubes.3mf")
    assert numpy.array_equal(second[0] - first[0], numpy.tile([0, 0, 3], (8, 1))) and len(second[1]) == 12


def test_3mf_of_single_precision_has_short_numbers(tmp_path):
    done = run("transform", DOG, "-o", tmp_path / "dog.3mf")
    assert done.returncode == 0, done.stderr
    (vertices, triangles), = objects_of(tmp_path / "dog.3mf")
    mesh = read(DOG)
    assert numpy.array_equal(vertices.astype(numpy.float32)[triangles], points_of(mesh).astype(numpy.float32)[triangles_of(mesh)])
    lib3mf = pytest.importorskip("lib3mf")
    model = lib3mf.get_wrapper().CreateModel()
    reader = model.QueryReader("3mf")
    reader.SetStrictModeActive(True)
    reader.ReadFromFile(str(tmp_path / "dog.3mf"))
    meshes = model.GetMeshObjects()
    assert meshes.MoveNext() and meshes.GetCurrentMeshObject().IsManifoldAndOriented() and reader.GetWarningCount() == 0
