"""Edits by the command: operations, profiles, layers, images, reports, pictures, a session of it, and what is refused."""
import json
import os
import zipfile

import numpy
import pytest
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

from scene import *  # noqa: F403

MIDDLE = numpy.array([WIDTH / 3 - 10, HEIGHT / 2])
TURN = numpy.linspace(0, 2 * numpy.pi, 90)
LINE = MIDDLE + numpy.column_stack([numpy.linspace(-18, 18, 30), 3 * numpy.sin(numpy.linspace(0, 5, 30))])
RING = MIDDLE + numpy.column_stack([38 * numpy.cos(TURN), 30 * numpy.sin(TURN)])
BULGE = MIDDLE + numpy.column_stack([44 * numpy.cos(TURN), 34 * numpy.sin(TURN)])[82:90]


def on_disc(places):
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    cells.InsertNextCell(len(places))
    for x, y in places:
        cells.InsertCellPoint(points.InsertNextPoint(x, y, 0.0))
    data.SetPoints(points)
    data.SetLines(cells)
    return data


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("edit")
    write(body(), folder / "body.vtp")
    write(stroke(LINE), folder / "line.vtp")
    write(stroke(RING), folder / "ring.vtp")
    write(stroke(outline(1.7)), folder / "longer.vtp")
    write(on_disc([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]), folder / "area.vtp")
    write(on_disc([(0, 0), (0.4, 0.45), (1, 0)]), folder / "profile.vtp")
    return folder


def command(folder, out, *options, mesh="body.vtp", line="line.vtp", ring="ring.vtp"):
    return ["edit", folder / mesh, "--reference", folder / line, "--boundary", folder / ring, "-o", out, *options]


def edit(folder, out, *options, **files):
    done = run(*command(folder, out, *options, **files))
    assert done.returncode == 0, done.stderr
    return read(out)


def painted(path, grey):
    image = vtkImageData()
    image.SetDimensions(grey.shape[1], grey.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(grey.ravel(), deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()
    return path


def test_lengths_are_the_models_or_shares_of_its_diagonal(folder, tmp_path):
    before = read(folder / "body.vtp")
    share = edit(folder, tmp_path / "share.vtp", "--move", "0.5,n,4%")
    length = edit(folder, tmp_path / "length.vtp", "--move", f"0.5,n,{0.04 * diagonal(before)!r}")
    assert numpy.abs(points_of(share) - points_of(length)).max() < 1e-12
    assert volume(share) > volume(before) > volume(edit(folder, tmp_path / "in.vtp", "--move", "0.5,n,-4%"))


def test_an_edit_that_moves_nothing_writes_its_input(folder, tmp_path):
    before = read(folder / "body.vtp")
    for more in ([], ["--move", "0.5,n,0"], ["--pin", "0.3", "--drag", "0,0"]):
        done = run(*command(folder, tmp_path / "same.vtp", "--report", tmp_path / "same.json", *more))
        assert done.returncode == 0 and "warning: nothing has moved" in done.stderr and "edit --help" in done.stderr
        # The report holds what was warned of, word by word.
        said = [line.split("warning: ", 1)[1] for line in done.stderr.splitlines() if "warning: " in line]
        assert json.loads((tmp_path / "same.json").read_text())["warnings"] == said
        assert digest(read(tmp_path / "same.vtp")) == digest(before)
    assert run(*command(folder, tmp_path / "o.vtp", "--move", "0.5,n,2%")).stderr == ""


def test_folds_are_told(folder, tmp_path):
    options = ["--rotate", "0.5,n,170", "--report", tmp_path / "r.json"]
    done = run(*command(folder, tmp_path / "o.vtp", *options))
    report = json.loads((tmp_path / "r.json").read_text())
    folds, crossings = report["edit"]["folded_edges"], report["edit"]["crossings"]
    assert done.returncode == 0 and folds > 1 and crossings > 1
    remark = (f"The edit makes the model pass through itself, in {crossings} pairs of triangles: drag less far, or draw the ring wider. "
              f"The edit folds the model along {folds} edges: drag less far, or draw the ring wider.")
    assert done.stderr.splitlines() == [f"oversketch: warning: {remark}"]
    assert report["warnings"] == [remark]


def test_a_drag_is_in_pixels_of_the_lines_view(folder, tmp_path):
    """In a parallel view all of the line goes by so many pixels' size, across the view and not along it."""
    edit(folder, tmp_path / "o.vtp", "--drag", "7,-14", "--rule", "off", "--inner", tmp_path / "inner")
    rest, moved = (points_of(read(tmp_path / "inner" / f"{name}.vtp")) for name in ("Distance", "Deform"))
    distance = vtk_to_numpy(read(tmp_path / "inner" / "Distance.vtp").GetPointData().GetArray("CurveDistance"))
    line = distance == 0.0
    assert line.sum() > 5
    assert numpy.abs((moved - rest)[line] - numpy.array([7, -14, 0]) / PIXELS).max() < 1e-6
    assert (moved == rest)[distance == 1.0].all()


def test_operations_act_at_once_in_whatever_order(folder, tmp_path):
    options = [["--move", "0.2,n,0.05"], ["--rotate", "0.5,t,15"], ["--scale", "0.8,w,1.2"], ["--pin", "0.9"], ["--move", "0.2,w,-0.02"]]
    one = edit(folder, tmp_path / "one.vtp", *sum(options, []), "--rule", "off", "--report", tmp_path / "r.json")
    two = edit(folder, tmp_path / "two.vtp", *sum(options[::-1], []), "--rule", "off")
    assert numpy.abs(points_of(one) - points_of(two)).max() < 1e-9
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["options"]["operations"] == "move 0.2 n 0.05; rotate 0.5 t 15; scale 0.8 w 1.2; pin 0.9; move 0.2 w -0.02"


def test_a_profile_is_a_file_or_its_places(folder, tmp_path):
    text = edit(folder, tmp_path / "text.vtp", "--profile", "0 0, 0.4 0.45, 1 0", "--report", tmp_path / "r.json")
    file = edit(folder, tmp_path / "file.vtp", "--profile", folder / "profile.vtp")
    assert digest(text) == digest(file)
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["profile"] == "0 0, 0.4 0.45, 1 0"
    assert volume(text) > volume(read(folder / "body.vtp"))
    assert digest(edit(folder, tmp_path / "at.vtp", "--profile", folder / "profile.vtp", "--at", "0.3")) != digest(text)
    assert digest(edit(folder, tmp_path / "grey.vtp", "--profile", folder / "profile.vtp", "--use-texture")) != digest(text)


def test_a_ring_is_redrawn_by_a_further_stroke(folder, tmp_path):
    append = vtkAppendPolyData()
    append.SetOutputPointsPrecision(1)
    for samples in (RING, BULGE):
        append.AddInputData(stroke(samples))
    append.Update()
    write(append.GetOutput(), tmp_path / "both.vtp")
    size = {}
    for name, ring in (("one", "ring.vtp"), ("two", tmp_path / "both.vtp")):
        edit(folder, tmp_path / f"{name}.vtp", "--move", "0.5,n,3%", "--report", tmp_path / f"{name}.json", ring=ring)
        size[name] = json.loads((tmp_path / f"{name}.json").read_text())["edit"]["moved_points"]
    assert size["two"] > size["one"]


def test_layers_are_a_file(folder, tmp_path):
    (tmp_path / "layers.json").write_text(json.dumps(
        {"levels": 7, "handles": [[0.5, 0.25]], "areas": [{"stroke": os.path.relpath(folder / "area.vtp", tmp_path), "levels": 9,
                                                             "handles": [[0.4, 0.8]]}]}))
    layered = edit(folder, tmp_path / "o.vtp", "--move", "0.5,n,4%", "--layers", tmp_path / "layers.json", "--report", tmp_path / "r.json")
    options = json.loads((tmp_path / "r.json").read_text())["options"]
    assert options["levels"] == 7
    assert options["layers"] == "handle 0.5 0.25; area 0 9; handle 0.4 0.8"
    assert digest(layered) != digest(edit(folder, tmp_path / "plain.vtp", "--move", "0.5,n,4%"))
    # Handles alone, which draw the layers in, move less.
    (tmp_path / "in.json").write_text('{"handles": [[0.5, 0.25]]}')
    smaller = edit(folder, tmp_path / "in.vtp", "--move", "0.5,n,4%", "--layers", tmp_path / "in.json", "--rule", "off")
    assert volume(smaller) < volume(edit(folder, tmp_path / "usual.vtp", "--move", "0.5,n,4%", "--rule", "off"))


@pytest.mark.parametrize("kind", ["grey", "deep", "alpha", "one"])
def test_an_image_says_what_follows(folder, tmp_path, kind):
    """A white blob on black: the vertices under it follow, no other."""
    grey = numpy.zeros((64, 64), numpy.uint8)
    grey[34:44, 34:44] = 255
    if kind == "deep":
        grey = grey.astype(numpy.uint16) * 257
    image = vtkImageData()
    if kind == "one":
        grey = numpy.full((1, 1), 255, numpy.uint8)
    if kind == "alpha":
        image.SetDimensions(64, 64, 1)
        opaque = numpy.full(grey.size, 255, numpy.uint8)
        image.GetPointData().SetScalars(numpy_to_vtk(numpy.column_stack([grey.ravel()] * 3 + [opaque]), deep=True))
        writer = vtkPNGWriter()
        writer.SetInputData(image)
        writer.SetFileName(str(tmp_path / "w.png"))
        writer.Write()
    else:
        painted(tmp_path / "w.png", grey)
    edit(folder, tmp_path / "o.vtp", "--move", "0.5,n,4%", "--rule", "off", "--weights", tmp_path / "w.png", "--inner", tmp_path / "inner")
    rest = read(tmp_path / "inner" / "Texture.vtp")
    moved = (points_of(rest) != points_of(read(tmp_path / "inner" / "Deform.vtp"))).any(axis=1)
    disc = vtk_to_numpy(rest.GetPointData().GetArray("DiscCoords"))
    inside = vtk_to_numpy(rest.GetPointData().GetArray("EditRegion")) == 2
    if kind == "one":
        assert moved[inside].all() and not moved[~inside].any()
        return
    under = inside & (disc * 64 > 34.5).all(axis=1) & (disc * 64 < 43.5).all(axis=1)
    beside = ~inside | (disc * 64 < 33.5).any(axis=1) | (disc * 64 > 44.5).any(axis=1)
    assert under.sum() > 3 and moved[under].all() and not moved[beside].any()


def test_the_report_and_the_inner_files(folder, tmp_path):
    edit(folder, tmp_path / "o.vtp", "--move", "0.5,n,4%", "--report", tmp_path / "r.json", "--inner", tmp_path / "inner")
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["command"] == "edit" and report["reference"].endswith("line.vtp")
    assert report["stage_milliseconds"]["Flatten"] > 0 and report["after"]["triangles"] > report["before"]["triangles"]
    said = report["edit"]
    assert said["bridges"] == 0 and said["moved_points"] > 20 and said["folded_edges"] == 0
    assert said["crossings"] == 0 and said["share_seen"] == 1
    for name in ("BoundaryInsert", "Distance", "Shading", "Deform", "Retriangulate"):
        assert read(tmp_path / "inner" / f"{name}.vtp").GetNumberOfPoints() > 0
    assert (tmp_path / "inner" / "Shading.vti").exists()


@pytest.mark.skipif("DISPLAY" not in os.environ, reason="there is no display")
def test_the_picture_shows_line_and_ring(folder, tmp_path):
    edit(folder, tmp_path / "o.vtp", "--move", "0.5,n,6%", "--picture", tmp_path / "p.png")
    assert (tmp_path / "p.png").stat().st_size > 1000


@pytest.mark.parametrize("more", [
    ["--move", "0.5,n"], ["--move", "0.5,x,1"], ["--move", "0.5,n,wide"], ["--move", "0.5,n,1,2"], ["--rotate", "0.5,t,3%"], ["--move"],
    ["--pin", "0.5,n"], ["--pin", ""], ["--drag", "1"], ["--drag", "nan,1"], ["--falloff", "steep"], ["--rule", "none"], ["--at", "x"],
    ["--levels", "2.5"], ["--layers", "layers.txt"], ["--profile", "0 0"], ["--profile", "0 0, 1"], ["--profile", "0 0 0, 1 0"],
    ["--profile", "0 0, x 1"], ["--profile", "0 0, nan 1, 1 0"], ["--operations", "move 0.5 n 1"], ["--use-texture=on"], ["extra.vtp"], ["--weights", ""],
])
def test_bad_use(folder, tmp_path, more):
    assert "--help" in refuse(2, *command(folder, tmp_path / "o.vtp", *more))
    assert os.listdir(tmp_path) == []


def test_line_and_ring_must_be_given(folder, tmp_path):
    said = refuse(2, "edit", folder / "body.vtp", "--reference", folder / "line.vtp", "-o", tmp_path / "o.vtp")
    assert "needs --boundary BOUNDARY.vtp" in said
    assert "needs --reference" in refuse(2, "edit", folder / "body.vtp", "-o", tmp_path / "o.vtp")


@pytest.mark.parametrize("more, words", [
    (["--move", "1.5,n,1"], "its place is not on the curve"), (["--scale", "0.5,n,0"], "Operation 1"), (["--rotate", "0.5,t,180"], "180"),
    (["--move", "0.5,n,1", "--profile", "0 0, 0.4 0.3, 1 0"], "A profile and operations cannot be in one edit"),
    (["--profile", "0.5 0.5, 0.5 0.5"], "profile"), (["--weights", "none.png"], "there is no such file"),
    (["--layers", "none.json"], "there is no such file"), (["--scale", "0.5,t,1e5"], "make a smaller edit"), (["--move", "0.5,n,1e300"], "smaller edit"),
    (["--scale", "0.5,n,-1"], "give a factor above 0"), (["--rotate", "0.5,t,1e6"], "less than 180 degrees"), (["--pin", "-1"], "not on the curve"),
])
def test_what_cannot_be_made_is_said_and_nothing_written(folder, tmp_path, more, words):
    said = refuse(1, *command(folder, tmp_path / "o.vtp", *more))
    assert words.lower() in said.lower()
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("text, words", [
    ("", "JSON"), ("[]", "is no object"), ('{"layers": 5}', "'layers' is no member of it; these are: levels, handles, areas"),
    ('{"levels": 1}', "'levels'"), ('{"levels": 5.5}', "'levels'"), ('{"handles": [0.5]}', "no pair [from, to]"),
    ('{"handles": [[0.5, 1e999]]}', ("no pair [from, to]", "it is no JSON: Line 1, Column 20")),
    ('{"handles": [[0.5, NaN]]}', "JSON"), ('{"levels": 1e18}', "'levels'"), ('{"levels": -1}', "'levels'"),
    ('{"levels": "7"}', "'levels'"), ('{"handles": [[0.5, 0.4], [0.5, 0.3]]}', "Layer handle 1"), ('{"handles": [[]]}', "no pair [from, to]"),
    ('{"areas": [{"levels": 3}]}', "area 0"), ('{"levels": 5', "JSON"), ('{"handles": [[0.5, "x"]]}', "no pair [from, to]"), ('{"handles": 3}', "no list"),
    ('{"areas": {}}', "no list of at most 64"), ('{"areas": [{}]}', "area 0"), ('{"areas": [7]}', "area 0"),
    ('{"areas": [{"stroke": "gone.vtp"}]}', "names 'gone.vtp': there is no such file"),
    ('{"areas": [{"stroke": "a\\u0000b"}]}', "is no path"),
    ('{"handles": [[2, 0.5]]}', "Layer handle 0"), ('{"areas": [{"stroke": "PATH", "levels": 300}]}', "'levels'"),
])
def test_layers_that_are_none(folder, tmp_path, text, words):
    layers = tmp_path / "layers.json"
    layers.write_text(text.replace("PATH", os.path.relpath(folder / "area.vtp", tmp_path)))
    said = refuse(1, *command(folder, tmp_path / "o.vtp", "--move", "0.5,n,1%", "--layers", layers))
    ways = words if isinstance(words, tuple) else (words,)  # as jsoncpp's version has it
    assert any(way.lower() in said.lower() for way in ways), said
    assert os.listdir(tmp_path) == ["layers.json"]


@pytest.mark.parametrize("files", [
    {"mesh": "gone.vtp"}, {"line": "gone.vtp"}, {"ring": "gone.vtp"}, {"mesh": "line.vtp"}, {"line": "body.vtp"}, {"ring": "body.vtp"},
    {"mesh": "half.vtp"}, {"line": "half.vtp"}, {"ring": "text.vtp"}, {"mesh": "text.vtp"},
])
def test_files_that_are_none_leave_nothing(folder, tmp_path, files):
    whole = (folder / "line.vtp").read_bytes()
    (folder / "half.vtp").write_bytes(whole[:len(whole) // 2])
    (folder / "text.vtp").write_text("no mesh")
    said = refuse(1, *command(folder, tmp_path / "o.vtp", "--move", "0.5,n,1%", "--report", tmp_path / "r.json", **files))
    assert next(iter(files.values())) in said or "curve" in said or "no triangles" in said, said
    assert os.listdir(tmp_path) == []


def test_what_was_there_stays_where_a_run_fails(folder, tmp_path):
    """Neither a result of a failed run nor a part of one takes the place of a file."""
    before = {name: f"{name} of earlier".encode() for name in ("o.vtp", "r.json")}
    for name, content in before.items():
        (tmp_path / name).write_bytes(content)
    options = ("--report", tmp_path / "r.json")
    refuse(1, *command(folder, tmp_path / "o.vtp", "--scale", "0.5,t,1e5", *options))
    refuse(1, *command(folder, tmp_path / "o.vtp", "--move", "0.5,n,1%", "--inner", tmp_path / "r.json"))
    refuse(1, *command(folder, tmp_path / "gone" / "o.vtp", "--move", "0.5,n,1%", *options))
    refuse(1, *command(folder, tmp_path / "o.vtp", "--move", "0.5,n,1%", "--report", tmp_path / "gone" / "r.json"))
    refuse(2, *command(folder, tmp_path / "o.vtp", "--move", "0.5,n", *options))
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


@pytest.mark.parametrize("line, ring, words", [
    (LINE + [500, 0], RING, "lies on the mesh"), (LINE + [60, 0], RING, ""), (LINE[:2], RING, ""), (LINE, RING[:2], ""),
    (LINE * [numpy.nan, 1], RING, ""), (RING, RING, ""), (LINE, LINE, ""), (numpy.repeat(LINE[:1], 20, axis=0), RING, ""),
    (LINE, MIDDLE + 400 * (RING - MIDDLE) / 30, ""),
])
def test_hostile_lines_are_refused_or_make_a_sound_mesh(folder, tmp_path, line, ring, words):
    for name, samples in (("l.vtp", line), ("r.vtp", ring)):
        write(stroke(samples), tmp_path / name)
    done = run(*command(folder, tmp_path / "o.vtp", "--move", "0.5,n,2%", line=tmp_path / "l.vtp", ring=tmp_path / "r.vtp"), timeout=60)
    if done.returncode == 0:
        assert not words
        mesh = read(tmp_path / "o.vtp")
        edges = numpy.sort(triangles_of(mesh)[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        assert (numpy.unique(edges, axis=0, return_counts=True)[1] == 2).all() and numpy.isfinite(points_of(mesh)).all()
    else:
        lines = done.stderr.splitlines()
        assert done.returncode == 1 and len(lines) == 1 and words in lines[0], done.stderr
        assert not (tmp_path / "o.vtp").exists()


def test_many_samples_and_small_and_far_models(folder, tmp_path):
    dense = numpy.column_stack([numpy.interp(numpy.linspace(0, 1, 100000), numpy.linspace(0, 1, len(LINE)), LINE[:, k]) for k in (0, 1)])
    write(stroke(dense), tmp_path / "dense.vtp")
    done = run(*command(folder, tmp_path / "o.vtp", "--move", "0.5,n,2%", line=tmp_path / "dense.vtp"), timeout=60)
    assert done.returncode == 0, done.stderr


def test_files_are_not_written_over_what_is_read(folder, tmp_path):
    write(stroke(LINE), tmp_path / "l.vtp")
    (tmp_path / "layers.json").write_text("{}")
    for more in (["--report", tmp_path / "layers.json", "--layers", tmp_path / "layers.json"],):
        assert "would replace the layers" in refuse(2, *command(folder, tmp_path / "o.vtp", *more))
    assert "would replace the reference" in refuse(2, *command(folder, tmp_path / "l.vtp", line=tmp_path / "l.vtp"))


def test_a_chain_with_other_kinds_replays_to_the_bits_of_its_commands(folder, tmp_path):
    mesh = folder / "body.vtp"
    done = run("one-stroke", mesh, folder / "longer.vtp", "-o", tmp_path / "0.vtp", *QUICK)
    assert done.returncode == 0, done.stderr
    edit(folder, tmp_path / "1.vtp", "--move", "0.5,n,0.1", mesh=tmp_path / "0.vtp")
    edit(folder, tmp_path / "2.vtp", "--profile", folder / "profile.vtp", mesh=tmp_path / "1.vtp")
    done = run("augment", tmp_path / "2.vtp", folder / "line.vtp", "-o", tmp_path / "3.vtp", "--radius", "0.1", "--height", "0.05")
    assert done.returncode == 0, done.stderr
    lines = {"Reference": {"lines": "strokes/line.vtp"}, "Boundary": {"lines": "strokes/ring.vtp"}}
    steps = [("OneStroke", {"Remesh": "off"}, {"Stroke": {"lines": "strokes/longer.vtp"}}),
             ("Edit", {"Operations": "move 0.5 n 0.1"}, lines),
             ("Edit", {}, {**lines, "Profile": {"lines": "strokes/profile.vtp"}}),
             ("Augment", {"Radius": 0.1, "Height": 0.05}, {"Strokes": {"lines": "strokes/line.vtp"}})]
    session = {"format": "oversketch-session", "format_version": 2, "mesh": "mesh/body.vtp", "mesh_name": "body.vtp", "backend": "embree",
               "made_by": {"version": "", "backend": "embree", "device": "", "processor": ""},
               "result_md5": digest(read(tmp_path / "3.vtp")),
               "steps": [{"id": i + 1, "name": system, "on": True, "system": system, "values": values, "inputs": inputs}
                         for i, (system, values, inputs) in enumerate(steps)]}
    with zipfile.ZipFile(tmp_path / "chain.oversketch", "w") as archive:
        archive.write(folder / "body.vtp", "mesh/body.vtp")
        for name in ("longer", "line", "ring", "profile"):
            archive.write(folder / f"{name}.vtp", f"strokes/{name}.vtp")
        archive.writestr("session.json", json.dumps(session))
    done = run("replay", tmp_path / "chain.oversketch", "-o", tmp_path / "replayed.vtp")
    assert done.returncode == 0 and "bit for bit" not in done.stderr, done.stderr
    assert digest(read(tmp_path / "replayed.vtp")) == digest(read(tmp_path / "3.vtp"))


LOOP = "0 0, 0.7 0.5, 0.3 0.5, 1 0"


def test_a_profile_that_no_section_can_be_is_refused(folder, tmp_path):
    """As places, as a file, in pixels, and a stroke of the model's view where one of the section's is wanted."""
    write(on_disc([tuple(map(float, place.split())) for place in LOOP.split(",")]), tmp_path / "loop.vtp")
    for given, says in ((LOOP, "The profile crosses itself near (0.5, 0.357); draw it from side to side without a loop"),
                        (tmp_path / "loop.vtp", "The profile crosses itself"),
                        ("0.2 0, 0.8 0, 0.8 0.5, 0.2 0", "The profile is closed, it ends where it begins, at (0.2, 0)"),
                        ("0 0, 150 90, 300 0", "The profile ends at (300, 0), 299 times the section's width away from it"),
                        (folder / "line.vtp", "The profile was drawn on the model, in the view of the line or of the ring")):
        assert says in refuse(1, *command(folder, tmp_path / "o.vtp", "--profile", given))
    assert "An area was drawn on the model" in refuse(
        1, *command(folder, tmp_path / "o.vtp", "--areas", folder / "line.vtp", "--move", "0.5,n,2%"))
