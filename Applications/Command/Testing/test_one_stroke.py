"""The command line itself: help, bad use, report, inner stages, picture, progress and interrupt."""
import json
import os
import pty
import re
import signal
import time

import numpy
import pytest

from scene import *  # noqa: F403


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("one_stroke")
    write(body(), folder / "body.vtp")
    write(stroke(outline(1.7)), folder / "longer.vtp")
    return folder


def test_help_and_version():
    text = run("--help")
    assert text.returncode == 0 and "one-stroke" in text.stdout and text.stderr == ""
    text = run("one-stroke", "--help")
    assert text.returncode == 0 and text.stderr == ""
    for option in ("--picture", "--turntable", "--report", "--backend", "--remesh", "--adjust-normals", "--as-published", "--inner", "--proxy-above"):
        assert option in text.stdout
    lines = run("--version").stdout.splitlines()
    assert [line.split()[0] for line in lines] == ["Oversketch", "VTK", "OpenCL", "Embree", "Build"]
    environment = dict(os.environ, OVERSKETCH_OPENCL="off")
    assert "no device" in run("--version", env=environment).stdout


@pytest.mark.parametrize("arguments", [
    [], ["two-strokes"], ["--nothing"], ["--version", "more"],
    ["one-stroke"], ["one-stroke", "a.obj"], ["one-stroke", "a.obj", "s.vtp"],
    ["one-stroke", "a.obj", "s.vtp", "-o"], ["one-stroke", "a.obj", "s.vtp", "b.vtp", "-o", "o.obj"],
    ["one-stroke", "a.obj", "s.vtp", "-o", "o.doc"], ["one-stroke", "a.obj", "s.vtp", "-o", "o"],
    ["one-stroke", "a.obj", "s.vtp", "-o", "o.obj", "-o", "p.obj"],
    ["one-stroke", "a.obj", "s.vtp", "-o", "o.obj", "--remesh", "maybe"],
    ["one-stroke", "a.obj", "s.vtp", "-o", "o.obj", "--backend", "cuda"],
    ["one-stroke", "a.obj", "s.vtp", "-o", "o.obj", "--proxy-above", "0"],
    ["one-stroke", "a.obj", "s.vtp", "-o", "o.obj", "--picture", "p.jpg"],
    ["one-stroke", "a.obj", "s.vtp", "-o", "o.obj", "--turntable", "t.mp4"],
    ["one-stroke", "a.obj", "s.vtp", "-o", "o.obj", "--report", "r.txt"],
    ["one-stroke", "a.obj", "s.vtp", "-o", "o.obj", "--adjust-normals=yes"],
    ["one-stroke", "a.obj", "s.vtp", "-o", "o.obj", "--fast"],
    ["one-stroke", "a.obj", "s.vtp", "-o", "o.obj", "--remesh"], ["one-stroke", "a.obj", "s.vtp", "-o", ""],
    ["one-stroke", "--help=all"], ["one-stroke", "a.obj", "--", "-o", "o.obj"],
])
def test_bad_use(arguments):
    assert "--help" in refuse(2, *arguments)


def test_report_and_inner_stages(folder, tmp_path):
    done = run("one-stroke", folder / "body.vtp", folder / "longer.vtp", "-o", tmp_path / "o.vtp", "--report",
               tmp_path / "r.json", "--inner", tmp_path / "inner" / "stages", *QUICK)
    assert done.returncode == 0, done.stderr
    report = json.loads((tmp_path / "r.json").read_text())
    assert report["backend_used"] == "embree" and report["remeshed"] is False
    assert report["before"] == report["after"]
    assert report["before"]["points"] == read(tmp_path / "o.vtp").GetNumberOfPoints()
    stages = report["stage_milliseconds"]
    assert stages["ShapeDiameter"] > 0 and sum(stages.values()) <= report["milliseconds"]["run"]
    # Field arrays of one value, which any system has.
    assert report["fields"]["Match"]["Distance"] > 1 and report["fields"]["Targets"]["SectionLength"] > 0
    assert report["command"] == "one-stroke" and report["mesh"].endswith("body.vtp") and report["stroke"].endswith("longer.vtp")
    assert report["options"] == {"backend": "embree", "remesh": "off", "adjust_normals": False, "as_published": False,
                                 "candidate": 1, "reach": 0.0, "allow_torn": False}
    effect = report["effect"]
    assert effect["outline_px"] < 3 and effect["outline_back_px"] < 3 and effect["new_folds"] <= 0
    assert 1 < effect["stretch"] < 8 and 0 < effect["moved_share"] < 0.5
    assert "DeformRemeshedCorrected" in stages
    inner = {path.stem: read(path) for path in (tmp_path / "inner" / "stages").iterdir()}
    for name in ("Stroke", "Silhouette", "Snake", "Visibility", "Outline", "Match", "Targets", "ShapeDiameter",
                 "MixtureRegion", "RegionBorder", "Deform"):
        assert inner[name].GetNumberOfPoints() > 0
    assert report["targets"]["handles"] == inner["Targets"].GetNumberOfPoints()
    assert report["match"]["points"] == inner["Match"].GetNumberOfPoints()
    assert report["faces"]["Deform"] == inner["Deform"].GetNumberOfPolys()
    region = vtk_to_numpy(inner["RegionBorder"].GetPointData().GetArray("Region"))
    assert report["region"]["vertices"] == (region != 0).sum()
    assert 0 < report["region"]["area_share"] < 0.6
    # The residual, measured again on what was written.
    targets, moved = inner["Targets"].GetPointData(), points_of(inner["Deform"])
    weights = vtk_to_numpy(targets.GetArray("MeshWeights"))
    reached = (weights[:, :, None] * moved[vtk_to_numpy(targets.GetArray("MeshVertices"))]).sum(axis=1)
    distances = numpy.linalg.norm(reached - vtk_to_numpy(targets.GetArray("Target")), axis=1)
    assert report["deformation"]["mean_handle_residual"] <= report["deformation"]["maximum_handle_residual"]
    assert report["deformation"]["maximum_handle_residual"] <= distances.max() * 1.001


def test_options_reach_the_system(folder, tmp_path):
    results = {}
    for name, options in {"plain": [], "on": ["--remesh", "on"], "adjust": ["--remesh", "off", "--adjust-normals"],
                          "published": ["--as-published"]}.items():
        done = run("one-stroke", folder / "body.vtp", folder / "longer.vtp", "-o", tmp_path / f"{name}.vtp", "--report",
                   tmp_path / "r.json", "--backend=embree", *(options or ["--remesh=off"]))
        assert done.returncode == 0, done.stderr
        results[name] = (json.loads((tmp_path / "r.json").read_text()), points_of(read(tmp_path / f"{name}.vtp")))
    assert results["on"][0]["remeshed"] and not results["plain"][0]["remeshed"]
    assert len(results["on"][1]) != len(results["plain"][1])
    assert results["adjust"][0]["options"]["adjust_normals"]
    assert numpy.abs(results["adjust"][1] - results["plain"][1]).max() > 1e-4
    assert results["published"][0]["options"]["as_published"]
    assert results["published"][0]["stage_milliseconds"]["Outline"] == 0


def test_a_large_mesh_is_moved_as_its_proxy_is(folder, tmp_path):
    write(body(around=150, along=200), tmp_path / "fine.vtp")
    before = read(tmp_path / "fine.vtp")
    done = run("one-stroke", tmp_path / "fine.vtp", folder / "longer.vtp", "-o", tmp_path / "o.vtp", "--report", tmp_path / "r.json",
               "--proxy-above", "12000", *QUICK)
    assert done.returncode == 0 and "proxy of" in done.stderr, done.stderr
    report = json.loads((tmp_path / "r.json").read_text())
    assert 0.7 * 12000 <= report["proxy"]["triangles"] <= 1.3 * 12000
    assert report["before"] == report["after"] == {"points": before.GetNumberOfPoints(), "triangles": before.GetNumberOfPolys()}
    run("one-stroke", tmp_path / "fine.vtp", folder / "longer.vtp", "-o", tmp_path / "itself.vtp", *QUICK)
    old, new, itself = (points_of(read(tmp_path / name)) for name in ("fine.vtp", "o.vtp", "itself.vtp"))
    assert abs(new[:, 0].max() - itself[:, 0].max()) < 0.03
    away = old[:, 0] < -0.4
    assert away.any() and (new[away] == old[away]).all()
    assert "too many for augment" in refuse(1, "augment", tmp_path / "fine.vtp", folder / "longer.vtp", "-o", tmp_path / "o.vtp", "--proxy-above", "12000")


def test_without_an_opencl_device_the_host_works_and_says_so(folder, tmp_path):
    environment = dict(os.environ, OVERSKETCH_OPENCL="off")
    done = run("one-stroke", folder / "body.vtp", folder / "longer.vtp", "-o", tmp_path / "a.vtp", "--backend", "opencl",
               "--remesh", "off", "--report", tmp_path / "r.json", env=environment)
    assert done.returncode == 0 and done.stderr.count("oversketch: warning: ") == 1, done.stderr
    assert json.loads((tmp_path / "r.json").read_text())["backend_used"] == "embree"
    run("one-stroke", folder / "body.vtp", folder / "longer.vtp", "-o", tmp_path / "b.vtp", *QUICK)
    assert (tmp_path / "a.vtp").read_bytes() == (tmp_path / "b.vtp").read_bytes()


def test_the_picture_shows_the_four_colours_from_the_strokes_view(folder, tmp_path):
    from vtkmodules.vtkIOImage import vtkPNGReader
    done = run("one-stroke", folder / "body.vtp", folder / "longer.vtp", "-o", tmp_path / "o.vtp", "--picture",
               tmp_path / "p.png", "--inner", tmp_path, *QUICK)
    assert done.returncode == 0, done.stderr
    reader = vtkPNGReader()
    reader.SetFileName(str(tmp_path / "p.png"))
    reader.Update()
    image = reader.GetOutput()
    assert image.GetDimensions() == (WIDTH, HEIGHT, 1)
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(HEIGHT, WIDTH, -1).astype(int)
    r, g, b = pixels[..., 0], pixels[..., 1], pixels[..., 2]
    red, blue = (r > 150) & (g < 70) & (b < 70), (b > 150) & (r < 80) & (g < 130)
    orange = (r > 110) & (r - b > 60) & (g > 0.45 * r) & (g < 0.85 * r)
    # Each sample of the stroke, and of the matched section, is under ink of its colour.
    samples = outline(1.7)
    assert red[numpy.round(samples[:, 1] - 0.5).astype(int), numpy.round(samples[:, 0] - 0.5).astype(int)].mean() > 0.95
    assert red.sum() < 6 * len(samples) * 2
    assert blue.sum() > 100
    # The model stands where its own points project to, orange in the region and grey elsewhere.
    mesh = read(tmp_path / "Deform.vtp")
    points = points_of(mesh)
    region = vtk_to_numpy(mesh.GetPointData().GetArray("Region")) != 0
    column = (WIDTH / 3 + PIXELS * points[:, 0]).astype(int)
    row = (HEIGHT / 2 + PIXELS * points[:, 1]).astype(int)
    facing = points[:, 2] > 0.15
    assert orange[row, column][facing & region].mean() > 0.7
    grey = (abs(r - g) < 12) & (abs(g - b) < 12) & (r < 225)
    assert grey[row, column][facing & ~region].mean() > 0.8


def mask_of(path):
    """Where a picture is no background, and how much of it is red as strokes are."""
    from vtkmodules.vtkIOImage import vtkPNGReader
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(HEIGHT, WIDTH, -1).astype(int)
    return pixels.min(2) < 225, ((pixels[..., 0] > 150) & (pixels[..., 1] < 70)).sum()


def test_the_turntable_goes_round_once(folder, tmp_path):
    done = run("one-stroke", folder / "body.vtp", folder / "longer.vtp", "-o", tmp_path / "o.vtp", "--turntable", tmp_path / "t.png", *QUICK)
    assert done.returncode == 0, done.stderr
    assert sorted(os.listdir(tmp_path)) == ["o.vtp"] + [f"t_{i:03d}.png" for i in range(1, 73)]
    bounds = read(tmp_path / "o.vtp").GetBounds()
    left, right = (WIDTH / 3 + PIXELS * x for x in bounds[:2])
    # The limb is at the right, from behind at the left, and in between the body alone is as wide as it is deep.
    for number, low, high in ((1, left, right), (37, left, right), (19, None, None)):
        mask, red = mask_of(tmp_path / f"t_{number:03d}.png")
        columns = numpy.flatnonzero(mask.any(0))
        assert red == 0, "a stroke, which is of one view"
        if low is not None:
            assert abs(columns[0] - low) < 3 and abs(columns[-1] - high) < 3, (number, columns[0], columns[-1], low, high)
            middle = int(0.5 * (low + high))
            thick = mask[:, :middle].sum() - mask[:, middle:].sum()
            assert (thick > 0) == (number == 1), "the body is thicker than the limb"
        else:
            assert columns[-1] - columns[0] < 0.8 * (right - left)


def test_a_film_is_one_file(folder, tmp_path):
    done = run("one-stroke", folder / "body.vtp", folder / "longer.vtp", "-o", tmp_path / "o.vtp", "--turntable", tmp_path / "t.ogv", *QUICK)
    assert done.returncode == 0, done.stderr
    assert sorted(os.listdir(tmp_path)) == ["o.vtp", "t.ogv"]
    film = (tmp_path / "t.ogv").read_bytes()
    assert film.startswith(b"OggS") and 6000 < len(film) < 72 * WIDTH * HEIGHT * 3


def test_a_film_replaces_nothing_that_is_read_or_written(folder, tmp_path):
    assert "would replace" in refuse(2, "one-stroke", folder / "body.vtp", folder / "longer.vtp", "-o", tmp_path / "o.vtp", "--picture",
                                     tmp_path / "t_072.png", "--turntable", tmp_path / "t.png")
    assert os.listdir(tmp_path) == []


def test_a_picture_without_a_display_is_refused_before_any_work(folder, tmp_path):
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    message = refuse(1, "one-stroke", folder / "body.vtp", folder / "longer.vtp", "-o", tmp_path / "o.vtp", "--picture",
                     tmp_path / "p.png", env=environment)
    assert "xvfb-run" in message
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("arguments", [
    ["one-stroke", SOURCE / "Data/Models/dinosaur.ply", SOURCE / "Data/Strokes/dinosaur_longer_tail.vtp"],
    ["inflate", SOURCE / "Data/Drawings/figure_body.vtp", "--image", SOURCE / "Data/Drawings/figure_body.png", "--levels", "6"]],
    ids=lambda words: words[0])
def test_progress_on_a_terminal_and_interrupt(tmp_path, arguments):
    # Each takes seconds, of which the interrupt needs a part, however loaded the machine is.
    leader, follower = pty.openpty()
    program = subprocess.Popen([COMMAND, *arguments, "-o", tmp_path / "o.ply"],
                               stderr=follower, stdout=subprocess.DEVNULL)
    os.close(follower)
    seen = b""
    deadline = time.monotonic() + 60
    while b"%" not in seen and time.monotonic() < deadline:
        seen += os.read(leader, 4096)
    program.send_signal(signal.SIGINT)
    try:
        while True:
            chunk = os.read(leader, 4096)
            if not chunk:
                break
            seen += chunk
    except OSError:
        pass  # the terminal is closed
    assert program.wait(60) == 1
    # The line starts over each time and names the step.
    assert re.search(rb"\r *\d+ %  [A-Z][A-Za-z]+", seen) and b"interrupted" in seen
    assert os.listdir(tmp_path) == []


def test_is_a_session_of_one_step(folder, tmp_path):
    """The same bits from the verb and from a session that tells the step, in either version of the format."""
    import zipfile
    done = run("one-stroke", folder / "body.vtp", folder / "longer.vtp", "-o", tmp_path / "verb.vtp", *QUICK, "--adjust-normals")
    assert done.returncode == 0, done.stderr
    text = {"format": "oversketch-session", "format_version": 2, "mesh": "a.vtp", "mesh_name": "body.vtp", "backend": "embree",
            "steps": [{"id": 5, "name": "longer", "on": True, "system": "OneStroke",
                       "values": {"Remesh": "off", "AdjustNormals": True}, "inputs": {"Stroke": {"lines": "b.vtp"}}}],
            "made_by": dict.fromkeys(("version", "backend", "device", "processor"), ""), "result_md5": ""}
    with zipfile.ZipFile(tmp_path / "step.oversketch", "w") as file:
        file.writestr("session.json", json.dumps(text))
        file.write(folder / "body.vtp", "a.vtp")
        file.write(folder / "longer.vtp", "b.vtp")
    done = run("replay", tmp_path / "step.oversketch", "-o", tmp_path / "session.vtp")
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert (tmp_path / "verb.vtp").read_bytes() == (tmp_path / "session.vtp").read_bytes()


def test_the_manual_page_names_every_option():
    page = pathlib.Path(COMMAND).parents[1] / "Applications" / "Packaging" / "oversketch.1"
    if not page.exists():
        pytest.skip(f"{page} is not built")
    text = page.read_text()
    assert ".\\\"" not in text and "@" not in text
    text = text.replace("\\-", "-")
    for arguments in (["--help"], ["one-stroke", "--help"], ["replay", "--help"]):
        options = set(re.findall(r"(?<![\w-])--?[a-z][a-z-]*", run(*arguments).stdout))
        assert options and all(option in text for option in options), arguments


def test_every_shipped_stroke_works(tmp_path):
    for name in ("dog_curled_tail", "dog_longer_leg"):
        done = run("one-stroke", SOURCE / "Data/Models/dog.ply", SOURCE / "Data/Strokes" / f"{name}.vtp", "-o", tmp_path / "o.glb")
        assert done.returncode == 0, done.stderr
