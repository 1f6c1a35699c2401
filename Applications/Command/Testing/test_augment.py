"""Lines on a mesh and terrains by the command: lengths, signs, files, reports, pictures, and chains with one-stroke."""
import json
import os
import shutil
import struct
import zipfile

import numpy
import pytest
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter, vtkTIFFWriter

from scene import *  # noqa: F403

LINE = numpy.column_stack([WIDTH / 3 - 30 + numpy.linspace(-20, 20, 30), HEIGHT / 2 + 12 * numpy.sin(numpy.linspace(0, 5, 30))])


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("augment")
    write(body(), folder / "body.vtp")
    write(stroke(LINE), folder / "line.vtp")
    write(stroke(outline(1.7)), folder / "longer.vtp")
    return folder


def augment(folder, out, *options, mesh="body.vtp", line="line.vtp"):
    done = run("augment", folder / mesh, folder / line, "-o", out, *options)
    assert done.returncode == 0, done.stderr
    return read(out)


def test_lengths_are_the_models_or_shares_of_its_diagonal(folder, tmp_path):
    before = read(folder / "body.vtp")
    share = augment(folder, tmp_path / "share.vtp", "--radius", "4%", "--height", "2%")
    size = diagonal(before)
    length = augment(folder, tmp_path / "length.vtp", "--radius", str(0.04 * size), "--height", str(0.02 * size))
    assert numpy.abs(points_of(share) - points_of(length)).max() < 1e-12
    assert share.GetNumberOfPolys() > before.GetNumberOfPolys() + 100
    raised = volume(share) - volume(before)
    carved = volume(augment(folder, tmp_path / "in.vtp", "--radius", "4%", "--height=-2%")) - volume(before)
    assert raised > 0 and carved == pytest.approx(-raised, rel=0.15)  # the surface is round
    assert volume(augment(folder, tmp_path / "also.vtp", "--radius", "4%", "--height", "-2%")) - volume(before) == carved
    # A stroke's own arrays go before the options.
    own = stroke(LINE)
    for name, value in (("Radius", 0.04 * size), ("Height", -0.02 * size)):
        array = numpy_to_vtk(numpy.array([value]), deep=True)
        array.SetName(name)
        own.GetCellData().AddArray(array)
    write(own, tmp_path / "own.vtp")
    done = run("augment", folder / "body.vtp", tmp_path / "own.vtp", "-o", tmp_path / "same.vtp", "--radius", "9%", "--sharpness", "1.5")
    assert volume(read(tmp_path / "same.vtp")) - volume(before) == pytest.approx(carved, rel=1e-9)
    said = done.stderr.splitlines()  # of the option that is not used alone
    assert len(said) == 1 and "warning: --radius is not used" in said[0] and "own.vtp" in said[0] and "cell array Radius" in said[0]


def test_a_profile_and_its_exponent(folder, tmp_path):
    sharp = augment(folder, tmp_path / "1.vtp", "--radius", "4%", "--height", "1%", "--sharpness", "1")
    line = augment(folder, tmp_path / "2.vtp", "--radius", "4%", "--height", "1%", "--profile", "0 1, 1 0")
    assert numpy.abs(points_of(sharp) - points_of(line)).max() < 1e-12


def test_the_report_tells_what_the_stages_met(folder, tmp_path):
    augment(folder, tmp_path / "o.vtp", "--radius", "4%", "--simplify", "off", "--report", tmp_path / "r.json", "--inner",
            tmp_path / "inner")
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["command"] == "augment" and report["options"]["simplify"] is False
    assert report["options"]["radius"] == pytest.approx(0.04 * diagonal(read(folder / "body.vtp")))
    faces = report["faces"]
    assert "Simplify" not in faces and faces["Base"] < faces["Refine"] <= faces["Snap"] == faces["Displace"]
    assert faces["Base"] == 2 * report["base"]["pairs"] + 3 * report["base"]["unpaired"]
    met = report["met"]
    assert met["crossings"] > 10 and met["residual"] == 0 and met["flipped_faces"] == 0
    assert 0.85 < met["crest_minimum"] <= met["crest_mean"] <= 1.0 + 1e-12
    assert 0 < met["longest_curve_segment"] < report["options"]["radius"] and met["smallest_angle"] > 4.0
    assert isinstance(met["self_intersecting_faces"], (int, float))
    for stage in ("Curves", "Refine", "Displace"):
        assert read(tmp_path / "inner" / f"{stage}.vtp").GetNumberOfPoints() > 0


@pytest.mark.parametrize("more", [
    ["--radius", "wide"], ["--radius", "%"], ["--sharpness", "3%"], ["--simplify"], ["--simplify", "maybe"], ["--sketch", "both"],
    ["--combine", "max"], ["--use-pressure=on"], ["--quads", "3"], ["--radius", "nan"],
])
def test_bad_use(folder, tmp_path, more):
    assert "--help" in refuse(2, "augment", folder / "body.vtp", folder / "line.vtp", "-o", tmp_path / "o.vtp", *more)


@pytest.mark.parametrize("more, words", [
    (["--radius", "0"], "Radius"), (["--sharpness", "-1"], "Sharpness"), (["--profile", "0 1, 0.5"], "Profile"),
    (["--profile", "0 1, 0.5 nan, 1 0"], "Point 1 of the profile is not two numbers"),
    (["--profile", "0 1, nan 0.5, 1 0"], "Point 1 of the profile is not two numbers"),
    (["--profile", "0 1, 0.5 inf, 1 0"], "Point 1 of the profile is not two numbers"),
    (["--profile", "0 1, 0.6 0.5, 0.4 0.2, 1 0"], "Point 2 of the profile has an x that is not above the one before"),
    (["--profile", "0 1, 0.5 0.5, 0.5 0.2, 1 0"], "Point 2 of the profile has an x that is not above the one before"),
    (["--profile", "0.1 1, 1 0"], "Point 0 of the profile is not at x = 0"),
    (["--edge-length", "1e-12"], "MaximumFaces"),
])
def test_what_cannot_be_made_is_said_and_nothing_written(folder, tmp_path, more, words):
    said = refuse(1, "augment", folder / "body.vtp", folder / "line.vtp", "-o", tmp_path / "o.vtp", *more)
    assert words.lower() in said.lower()
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("length", ["-1", "-2%"])
def test_edges_are_not_shorter_than_nothing(folder, tmp_path, length):
    said = refuse(2, "augment", folder / "body.vtp", folder / "line.vtp", "-o", tmp_path / "o.vtp", "--edge-length", length)
    assert f"--edge-length cannot be {length.replace('2%', '0.02')}; the nearest that it takes is 0" in said
    assert os.listdir(tmp_path) == []


def test_radii_that_are_none(folder, tmp_path):
    """Below 0 the default; one that reaches no point gives a mesh that is finer under the line and stays as high."""
    usual = augment(folder, tmp_path / "usual.vtp")
    for radius in ("-1", "-3%", "-1e300"):
        assert digest(augment(folder, tmp_path / "negative.vtp", "--radius", radius)) == digest(usual)
    before = read(folder / "body.vtp")
    tiny = augment(folder, tmp_path / "tiny.vtp", "--radius", "1e-300")
    assert tiny.GetNumberOfPolys() > before.GetNumberOfPolys() and numpy.isfinite(points_of(tiny)).all()
    assert volume(tiny) == pytest.approx(volume(before), rel=1e-5)
    # It is a 4-8 mesh that the next line goes on from; what that makes of triangles of no size is said.
    done = run("augment", tmp_path / "tiny.vtp", folder / "line.vtp", "-o", tmp_path / "next.vtp")
    assert done.returncode == 0 and "base" not in done.stderr and "triangles are turned over" in done.stderr, done.stderr


def spoil(mesh, what):
    """Changes a 4-8 mesh in its place."""
    def put(data, name, at, value):
        vtk_to_numpy(data.GetArray(name))[at] = value
    if what == "cells reordered":
        order = numpy.r_[1, 0, 2:mesh.GetNumberOfCells()]
        vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)[:] = triangles_of(mesh)[order]
        for name in ("StellarRoot", "StellarPath", "StellarGen"):
            put(mesh.GetCellData(), name, slice(None), vtk_to_numpy(mesh.GetCellData().GetArray(name))[order])
    elif what == "points cleaned":
        clean = vtkCleanPolyData()
        copy = vtkPolyData()
        copy.DeepCopy(mesh)
        clean.SetInputData(copy)
        clean.SetTolerance(0.01)
        clean.ConvertPolysToLinesOff()
        clean.ConvertLinesToPointsOff()
        clean.Update()
        mesh.ShallowCopy(clean.GetOutput())
    elif what == "digest":
        put(mesh.GetFieldData(), "CurveDigest", 0, 7)
    elif what == "parameter":
        snapped = numpy.flatnonzero(vtk_to_numpy(mesh.GetPointData().GetArray("CurveId")) >= 0)
        put(mesh.GetPointData(), "CurveParam", snapped[0], numpy.nan)
    else:
        put(mesh.GetCellData(), *what)


@pytest.fixture(scope="module")
def raised(folder, tmp_path_factory):
    """A 4-8 mesh as the command writes it, and one in the midst of its line."""
    inner = tmp_path_factory.mktemp("raised")
    augment(folder, inner / "raised.vtp", "--radius", "4%", "--inner", inner)
    return inner


@pytest.mark.parametrize("what, words", [
    (("StellarRoot", 5, 99), "StellarRoot of cell 5"), (("StellarPath", 7, 3000000001), "StellarPath of cell 7"),
    (("StellarGen", 3, 40), "StellarGen of cell 3"), ("cells reordered", "reordered"), ("points cleaned", "merged"),
])
def test_a_spoilt_4_8_mesh_becomes_a_base_and_one_is_told(folder, raised, tmp_path, what, words):
    mesh = read(raised / "raised.vtp")
    spoil(mesh, what)
    write(mesh, tmp_path / "spoilt.vtp")
    done = run("augment", tmp_path / "spoilt.vtp", folder / "line.vtp", "-o", tmp_path / "o.vtp")
    lines = [line for line in done.stderr.splitlines() if "note:" not in line]
    assert "new base" in lines[0] and words in lines[0], done.stderr
    if done.returncode:  # points that were merged may leave no manifold, whose defects are counted
        assert what == "points cleaned" and len(lines) == 2 and any(c.isdigit() for c in lines[1]), done.stderr
        assert not (tmp_path / "o.vtp").exists()
        return
    assert len(lines) == 1 and read(tmp_path / "o.vtp").GetNumberOfPolys() > mesh.GetNumberOfPolys()
    again = run("augment", tmp_path / "o.vtp", folder / "line.vtp", "-o", tmp_path / "again.vtp")
    assert again.returncode == 0 and "base" not in again.stderr, again.stderr


@pytest.mark.parametrize("what, words", [(None, "CurveDigest"), ("digest", "CurveDigest"), ("parameter", "CurveParam of point")])
def test_a_mesh_in_the_midst_of_another_line_is_refused_by_name(folder, raised, tmp_path, what, words):
    mesh = read(raised / "Snap.vtp")
    assert (vtk_to_numpy(mesh.GetPointData().GetArray("CurveId")) >= 0).any()
    if what:
        spoil(mesh, what)
    write(mesh, tmp_path / "midst.vtp")
    done = run("augment", tmp_path / "midst.vtp", folder / "line.vtp", "-o", tmp_path / "o.vtp")
    assert words in done.stderr and len(done.stderr.splitlines()) == 1, done.stderr
    assert (done.returncode == 1) != ("new base" in done.stderr), done.stderr


def test_a_line_in_the_void_is_refused(folder, tmp_path):
    write(stroke(numpy.array([[5.0, 5.0], [40.0, 8.0]])), tmp_path / "void.vtp")
    said = refuse(1, "augment", folder / "body.vtp", tmp_path / "void.vtp", "-o", tmp_path / "o.vtp")
    assert "stroke" in said.lower()
    assert sorted(os.listdir(tmp_path)) == ["void.vtp"]


def test_a_terrain_of_every_kind_of_file(tmp_path):
    heights = numpy.add.outer(numpy.arange(5) * 7, numpy.arange(9) * 100)  # rows from the bottom
    rows = heights[::-1]
    (tmp_path / "t.asc").write_text("ncols 9\nnrows 5\ncellsize 1\nNODATA_value -1\n" + "\n".join(" ".join(map(str, r)) for r in rows))
    (tmp_path / "t.pgm").write_bytes(b"P5 9 5 65535\n" + rows.astype(">u2").tobytes())
    image = vtkImageData()
    image.SetDimensions(9, 5, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(heights.astype(numpy.uint16).ravel(), deep=True))
    for name, writer in (("t.tif", vtkTIFFWriter()), ("t.png", vtkPNGWriter())):
        writer.SetInputData(image)
        writer.SetFileName(str(tmp_path / name))
        writer.Write()
    meshes = []
    for name in ("t.asc", "t.pgm", "t.tif", "t.png"):
        done = run("terrain", tmp_path / name, "-o", tmp_path / "o.vtp", "--quads", "8x4", "--scale", "0.5", "--offset", "3")
        assert done.returncode == 0 and done.stderr == "", done.stderr
        meshes.append(points_of(read(tmp_path / "o.vtp")))
        assert (meshes[0] == meshes[-1]).all() and len(meshes[0]) == 45
    x, y, z = meshes[0].T
    assert numpy.abs(z - (3 + 0.5 * (100 * x + 7 * y))).max() < 1e-9
    run("terrain", tmp_path / "t.pgm", "-o", tmp_path / "o.vtp", "--quads", "2", "--spacing", "10x20")
    assert points_of(read(tmp_path / "o.vtp")).max(axis=0)[:2].tolist() == [20.0, 20.0]
    text = run("terrain", "--help").stdout
    assert "--quads X[xY]" in text and "--columns" not in text
    for bad in (["--quads", "8y4"], ["--quads", "x4"], ["--quads", "8x4x2"], ["--spacing", "1.5.2"], ["--quads", "2.5"]):
        refuse(2, "terrain", tmp_path / "t.asc", "-o", tmp_path / "p.vtp", *bad)
    (tmp_path / "cut.asc").write_text((tmp_path / "t.asc").read_text()[:90])
    assert "row" in refuse(1, "terrain", tmp_path / "cut.asc", "-o", tmp_path / "p.vtp")
    assert "no grid of heights" in refuse(1, "terrain", SOURCE / "README.md", "-o", tmp_path / "p.vtp")
    assert not (tmp_path / "p.vtp").exists()


def geotiff(path, heights):
    """Real numbers from the lower left in cells of 0.25 x 0.5, the corner of the upper left one at (500000, 4600000), -9999 for none."""
    rows, columns = heights.shape
    data = heights[::-1].astype("<f4").tobytes()
    tags = [(256, 3, 1, columns), (257, 3, 1, rows), (258, 3, 1, 32), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, None), (277, 3, 1, 1),
            (278, 3, 1, rows), (279, 4, 1, len(data)), (339, 3, 1, 3), (33550, 12, 3, struct.pack("<3d", 0.25, 0.5, 0)),
            (33922, 12, 6, struct.pack("<6d", 0, 0, 0, 500000, 4600000, 0)), (42113, 2, 6, b"-9999\0")]
    after = 8 + 2 + 12 * len(tags) + 4
    entries, values = b"", b""
    for tag, kind, count, value in tags:
        if isinstance(value, bytes):
            value, values = after + len(data) + len(values), values + value
        entries += struct.pack("<HHII", tag, kind, count, after if value is None else value)
    path.write_bytes(struct.pack("<2sHIH", b"II", 42, 8, len(tags)) + entries + bytes(4) + data + values)


def test_a_geotiff_lies_on_its_map(tmp_path):
    """Cells of the map's size, a hole where nothing is known, single samples filled; what is made of it goes back onto the map."""
    x, y = numpy.meshgrid(numpy.arange(24), numpy.arange(20))
    heights = 1 + 0.125 * x + 0.25 * y
    heights[5:8, 6:9] = heights[12, 15] = -9999
    geotiff(tmp_path / "map.tif", heights)
    done = run("terrain", tmp_path / "map.tif", "-o", tmp_path / "map.vtp", "--quads", "23x19")
    assert done.returncode == 0, done.stderr
    assert "1 missing samples were filled" in done.stderr and "9 missing samples" in done.stderr and "16 of 437 quads" in done.stderr, done.stderr
    mesh = read(tmp_path / "map.vtp")
    points = points_of(mesh)
    assert points.max(axis=0)[:2].tolist() == [5.75, 9.5] and points.min(axis=0)[:2].tolist() == [0, 0]
    assert mesh.GetNumberOfPolys() == 2 * (23 * 19 - 16)
    assert numpy.abs(points[:, 2] - (1 + points[:, 0] / 2 + points[:, 1] / 2)).max() < 1e-9
    across = numpy.column_stack([WIDTH / 3 + PIXELS * numpy.linspace(1.5, 5, 40), numpy.full(40, HEIGHT / 2 + 1.7 * PIXELS)])
    write(stroke(across), tmp_path / "line.vtp")
    done = run("augment", tmp_path / "map.vtp", tmp_path / "line.vtp", "-o", tmp_path / "o.vtp", "--radius", "0.6", "--height", "0.3")
    assert done.returncode == 0, done.stderr
    for file in ("map.vtp", "o.vtp"):
        origin = vtk_to_numpy(read(tmp_path / file).GetFieldData().GetArray("MapOrigin"))
        assert origin.tolist() == [[500000.125, 4600000 - 0.5 * 19.5, 0]], file


def test_gdal_is_loaded_with_the_files_that_need_it(tmp_path):
    """What the program starts with has none of it, and says what is absent where its module cannot be loaded."""
    started = run("--version", env={**os.environ, "LD_TRACE_LOADED_OBJECTS": "1"}).stdout
    assert "libvtkCommonCore" in started and "gdal" not in started and "poppler" not in started
    geotiff(tmp_path / "map.tif", numpy.ones((3, 4)))
    (tmp_path / "t.pgm").write_bytes(b"P5 3 3 255\n" + bytes(9))
    (tmp_path / "liboversketch_raster.so").touch()  # which is found first, and is no library
    without = {**os.environ, "LD_LIBRARY_PATH": str(tmp_path)}
    assert run("terrain", tmp_path / "t.pgm", "-o", tmp_path / "o.vtp", env=without).returncode == 0
    said = refuse(1, "terrain", tmp_path / "map.tif", "-o", tmp_path / "p.vtp", env=without)
    assert "liboversketch_raster.so" in said and "GDAL" in said and not (tmp_path / "p.vtp").exists()


def test_heights_that_nothing_reads_are_not_written(tmp_path):
    (tmp_path / "t.asc").write_text("ncols 3\nnrows 3\ncellsize 1\n" + "1 2 3 " * 3)
    said = refuse(1, "terrain", tmp_path / "t.asc", "-o", tmp_path / "p.vtp", "--scale", "1e31")
    assert "reaches 3e+31" in said and not (tmp_path / "p.vtp").exists()


def test_odd_grids(tmp_path):
    """One row has no quads; equal heights are a plane that a line rises from; missing samples are holes with borders of their own."""
    hole = {9 * j + i for j in (3, 4, 5) for i in (3, 4, 5)}
    def terrain(columns, rows, values, *options):
        (tmp_path / "odd.asc").write_text(f"ncols {columns}\nnrows {rows}\ncellsize 1\nNODATA_value -9999\n" + " ".join(map(str, values)))
        return run("terrain", tmp_path / "odd.asc", "-o", tmp_path / "odd.vtp", *options)
    for columns, rows in ((9, 1), (1, 9)):
        done = terrain(columns, rows, range(9))
        assert done.returncode == 1 and f"{columns} x {rows} samples" in done.stderr and not (tmp_path / "odd.vtp").exists(), done.stderr
    done = terrain(9, 9, [-9999] * 81)
    assert done.returncode == 1 and not (tmp_path / "odd.vtp").exists()
    for values in ([5] * 81, [-9999 if i == 40 else 5 for i in range(81)], [-9999 if i in hole else 5 for i in range(81)]):
        done = terrain(9, 9, values, "--quads", "8")
        assert done.returncode == 0, done.stderr
        mesh = read(tmp_path / "odd.vtp")
        assert mesh.GetNumberOfPolys() == 2 * (64 if values.count(-9999) < 9 else 48) and set(points_of(mesh)[:, 2]) == {5.0}
        across = numpy.column_stack([WIDTH / 3 + PIXELS * numpy.linspace(1.5, 6.5, 20), numpy.full(20, HEIGHT / 2 + 1.7 * PIXELS)])
        write(stroke(across), tmp_path / "line.vtp")
        done = run("augment", tmp_path / "odd.vtp", tmp_path / "line.vtp", "-o", tmp_path / "o.vtp", "--radius", "0.9", "--height", "0.5")
        assert done.returncode == 0, done.stderr
        top = points_of(read(tmp_path / "o.vtp"))[:, 2]
        assert top.max() == pytest.approx(5.5, abs=1e-9) and top.min() == 5.0


@pytest.mark.skipif(shutil.which("xvfb-run") is None, reason="no virtual display")
def test_colours_of_the_picture(folder, tmp_path):
    from vtkmodules.vtkIOImage import vtkPNGReader

    def counts(*options):
        done = subprocess.run(["xvfb-run", "-a", COMMAND, "augment", folder / "body.vtp", folder / "line.vtp", "-o",
                               tmp_path / "o.vtp", "--picture", tmp_path / "p.png", *options], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        reader = vtkPNGReader()
        reader.SetFileName(str(tmp_path / "p.png"))
        reader.Update()
        image = reader.GetOutput()
        assert image.GetDimensions()[:2] == (WIDTH, HEIGHT)
        rgb = vtk_to_numpy(image.GetPointData().GetScalars()).astype(int)
        near = lambda colour: int((numpy.abs(rgb - colour).max(axis=1) < 30).sum())
        orange = int(((rgb[:, 0] > 180) & (rgb[:, 0] - rgb[:, 2] > 80) & (rgb[:, 1] - rgb[:, 2] > 30)).sum())
        return {"red": near((217, 26, 31)), "yellow": near((245, 204, 26)), "orange": orange}

    raised, carved = counts("--radius", "6%"), counts("--radius", "6%", "--height", "-1%")
    assert raised["red"] > 60 and raised["yellow"] < 10 and raised["orange"] > 200
    assert carved["yellow"] > 60 and carved["red"] < 10


def test_a_chain_of_both_kinds_replays_to_the_bits_of_its_commands(folder, tmp_path):
    write(stroke(LINE + [0.0, 20.0]), tmp_path / "second.vtp")
    steps = [("one-stroke", folder / "longer.vtp", QUICK), ("augment", folder / "line.vtp", ["--radius", "0.1", "--height", "0.05"]),
             ("one-stroke", tmp_path / "shorter.vtp", QUICK), ("augment", tmp_path / "second.vtp", ["--radius", "0.08", "--height", "-0.02"])]
    write(stroke(outline(1.55)), tmp_path / "shorter.vtp")
    mesh = folder / "body.vtp"
    for index, (verb, line, options) in enumerate(steps):
        done = run(verb, mesh, line, "-o", tmp_path / f"{index}.vtp", *options)
        assert done.returncode == 0, done.stderr
        mesh = tmp_path / f"{index}.vtp"
    values = {"one-stroke": {"Remesh": "off"}}
    session = {"format": "oversketch-session", "format_version": 2, "mesh": "mesh/body.vtp", "mesh_name": "body.vtp",
               "backend": "embree", "made_by": {"version": "", "backend": "embree", "device": "", "processor": ""},
               "result_md5": digest(read(mesh)), "steps": []}
    with zipfile.ZipFile(tmp_path / "chain.oversketch", "w") as archive:
        archive.write(folder / "body.vtp", "mesh/body.vtp")
        for index, (verb, line, options) in enumerate(steps):
            archive.write(line, f"strokes/{index}.vtp")
            one = verb == "one-stroke"
            numbers = dict(zip(("Radius", "Height"), map(float, options[1::2]))) if not one else values[verb]
            session["steps"].append({"id": index + 1, "name": verb, "on": True, "system": "OneStroke" if one else "Augment",
                                     "values": numbers, "inputs": {"Stroke" if one else "Strokes": {"lines": f"strokes/{index}.vtp"}}})
        archive.writestr("session.json", json.dumps(session))
    done = run("replay", tmp_path / "chain.oversketch", "-o", tmp_path / "replayed.vtp")
    assert done.returncode == 0 and "bit for bit" not in done.stderr, done.stderr
    assert digest(read(tmp_path / "replayed.vtp")) == digest(read(mesh))
