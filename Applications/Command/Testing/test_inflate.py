"""Drawings made models by the command: formats, reports, steps, what is refused, and a limb pulled afterwards."""
import json

import numpy
import oversketch
import pytest

from scene import *  # noqa: F403
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter

DRAWINGS = SOURCE / "Data" / "Drawings"


def inflate(name, out, *options, picture=True):
    image = ("--image", DRAWINGS / (name + ".png")) if picture else ()
    done = run("inflate", DRAWINGS / (name + ".vtp"), *image, "-o", out, *options)
    assert done.returncode == 0, done.stderr
    return done


def edges_of(mesh):
    """{edge: how often it is passed} over all faces, in their directions."""
    counts = {}
    ids = vtkIdList()
    for face in range(mesh.GetNumberOfPolys()):
        mesh.GetPolys().GetCellAtId(face, ids)
        corners = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
        for edge in zip(corners, corners[1:] + corners[:1]):
            counts[edge] = counts.get(edge, 0) + 1
    return counts


def euler(mesh):
    """Euler's number of a mesh whose every edge is passed once in either direction."""
    edges = edges_of(mesh)
    assert all(count == 1 and (b, a) in edges for (a, b), count in edges.items())
    return len({a for a, _ in edges}) - len(edges) // 2 + mesh.GetNumberOfPolys()


def test_a_picture_becomes_a_textured_model(tmp_path):
    done = inflate("fish", tmp_path / "fish.vtp", "--report", tmp_path / "fish.json", "--inner", tmp_path / "steps")
    mesh = read(tmp_path / "fish.vtp")
    assert euler(mesh) == 2
    texture = mesh.GetFieldData().GetAbstractArray("Texture")
    assert is_skin(vtk_to_numpy(texture).tobytes(), (DRAWINGS / "fish.png").read_bytes())
    report = json.loads((tmp_path / "fish.json").read_text())
    assert report["strokes"].count("boundary") == 1 and report["strokes"].count("closed feature") == 2
    assert len(report["strokes"]) == 16 and report["after"]["triangles"] == mesh.GetNumberOfPolys()
    assert report["faces"]["Refine"] * 2 == mesh.GetNumberOfPolys()
    assert report["warnings"] == [] and report["rebuilds"] in range(25) and report["levels"] == 3
    steps = report["stage_milliseconds"]
    ran = {"Canvas", "MagneticSnap", "Resample", "Classify", "Treatment", "Distance", "Polyline", "Darts", "CoarseMesh", "Refine", "Inflate",
           "Tunnel", "ProjectTexture"}
    assert {step for step, time in steps.items() if time > 0} == ran and set(steps) == ran | {"Trace", "Arrange", "QuadMerge", "Extrude", "Layers"}
    assert sum(steps.values()) <= report["milliseconds"]["run"]
    assert {"Distance.vti", "Distance.vtp", "Refine.vtp", "Inflate.vti"} <= {p.name for p in (tmp_path / "steps").iterdir()}
    assert done.stdout == ""


@pytest.mark.parametrize("extension", ["obj", "glb", "gltf", "ply", "off", "stl"])
def test_quads_reach_every_format(tmp_path, extension):
    inflate("leaf", tmp_path / "quads.vtp", "--quads")
    quads = vtkXMLPolyDataReader()
    quads.SetFileName(str(tmp_path / "quads.vtp"))
    quads.Update()
    faces = quads.GetOutput().GetNumberOfPolys()
    assert quads.GetOutput().GetPolys().GetNumberOfConnectivityIds() == 4 * faces
    out = tmp_path / ("leaf." + extension)
    done = inflate("leaf", out, "--quads")
    assert ("cut in two" in done.stderr) == (extension in ("glb", "gltf", "stl"))
    assert out.stat().st_size > 10 ** 5
    if extension == "obj":
        assert is_skin((tmp_path / "leaf.png").read_bytes(), (DRAWINGS / "leaf.png").read_bytes())
    assert faces > 5000


def test_holes_tunnels_and_slabs(tmp_path):
    inflate("mug", tmp_path / "mug.vtp")  # its drawing says that the handle is one
    assert euler(read(tmp_path / "mug.vtp")) == 0
    inflate("padlock", tmp_path / "padlock.vtp", "--extrude", "40")
    padlock = read(tmp_path / "padlock.vtp")
    assert euler(padlock) == -2
    assert padlock.GetBounds()[4:] == (-40.0, 40.0)
    inflate("fish", tmp_path / "eye.vtp", "--hole", "2", picture=False)
    assert euler(read(tmp_path / "eye.vtp")) == 0
    inflate("fish", tmp_path / "low.vtp", "--hole", "2", "--height", "0.5", picture=False)
    assert numpy.allclose(points_of(read(tmp_path / "low.vtp"))[:, 2], 0.5 * points_of(read(tmp_path / "eye.vtp"))[:, 2], atol=1e-9)


def rings_in(folder):
    """A file of a ring and two smaller ones in it."""
    turn, append = numpy.linspace(0, 2 * numpy.pi, 80), vtkAppendPolyData()
    append.SetOutputPointsPrecision(1)
    for x, r in ((200, 120), (150, 25), (250, 25)):
        append.AddInputData(stroke(numpy.column_stack([x + r * numpy.cos(turn), 150 + r * numpy.sin(turn)])))
    append.Update()
    return write(append.GetOutput(), folder / "rings.vtp")


def test_closed_lines_lie_in_front_and_behind(tmp_path):
    rings = rings_in(tmp_path)
    for options, bodies in ((["--in-front", "1", "--behind", "2"], 3), (["--both-sides", "1 2"], 5), (["--in-front", "1", "--in-front", "2"], 3)):
        done = run("inflate", rings, "-o", tmp_path / "out.vtp", *options, "--report", tmp_path / "report.json")
        assert done.returncode == 0 and done.stderr == "", done.stderr
        mesh = read(tmp_path / "out.vtp")
        assert euler(mesh) == 2 * bodies
        assert sorted(set(vtk_to_numpy(mesh.GetCellData().GetArray("LayerId")))) == [0, 1, 2]
        assert json.loads((tmp_path / "report.json").read_text())["strokes"] == ["boundary"] * 3
    done = run("inflate", rings, "-o", tmp_path / "no.vtp", "--behind", "3")
    assert done.returncode == 1 and "--behind names stroke 3" in done.stderr, done.stderr


def test_what_cannot_be_is_said(tmp_path):
    for options, words in ((("--hole", "99"), "99"), (("--hole", "1"), "1"), (("--profile", "0 0, 1 nan"), "rofile"), (("--image", __file__), "PNG, JPEG")):
        done = run("inflate", DRAWINGS / "fish.vtp", "-o", tmp_path / "no.vtp", *options)
        assert done.returncode == 1 and words in done.stderr, done.stderr
        assert not (tmp_path / "no.vtp").exists()
    done = run("inflate", tmp_path / "absent.vtp", "-o", tmp_path / "no.vtp")
    assert done.returncode == 1 and "absent.vtp" in done.stderr
    done = run("inflate", DRAWINGS / "fish.vtp")
    assert done.returncode == 2


def drawn(path, *lines):
    """Lines in pixels as a drawing; what a single stroke has is repeated for each."""
    whole, points, cells = stroke(lines[0], views=len(lines)), vtkPoints(), vtkCellArray()
    views = vtk_to_numpy(whole.GetCellData().GetArray("ViewTransform"))
    views[:] = views[0]
    points.SetDataTypeToDouble()
    for line in lines:
        cells.InsertNextCell(len(line))
        for x, y in line:
            cells.InsertCellPoint(points.InsertNextPoint(x, y, 0.0))
    whole.SetPoints(points)
    whole.SetLines(cells)
    return write(whole, path)


def ring(x, y, size, waves=0, depth=0.0):
    angles = numpy.linspace(0, 2 * numpy.pi, 401)
    radii = size * (1 + depth * numpy.cos(waves * angles))
    return numpy.column_stack([x + radii * numpy.cos(angles), y + radii * numpy.sin(angles)])


def test_the_report_tells_rejections_and_rebuilds(tmp_path):
    # The second line comes within 1.2 px of the first: there the strokes are followed more closely; not as published.
    lines = [ring(200, 150, 120), ring(200, 150, 110, 9, 0.08)]
    speck = ring(200, 150, 0.2)
    for more, options in (([speck], []), ([], ["--as-published"])):
        drawing = drawn(tmp_path / "narrow.vtp", *lines, *more)
        done = run("inflate", drawing, "-o", tmp_path / "narrow.ply", "--levels", "1", "--report", tmp_path / "narrow.json", *options)
        assert done.returncode == 0, done.stderr
        report = json.loads((tmp_path / "narrow.json").read_text())
        assert report["strokes"] == ["boundary", "closed feature"] + ["rejected"] * len(more)
        assert len(report["warnings"]) == len(more) and all(warning in done.stderr for warning in report["warnings"])
        assert not more or "troke 2 is closed round less than 9 px" in report["warnings"][0]
        assert report["rebuilds"] == 0 if options else 0 < report["rebuilds"] <= 24


def test_options_do_what_they_say(tmp_path):
    """What each option changes, by what it is for."""
    drawing = drawn(tmp_path / "disc.vtp", ring(200, 150, 120, 3, 0.3))
    size = lambda mesh: mesh.GetBounds()[5]

    def made(*options):
        done = run("inflate", drawing, "-o", tmp_path / "made.vtp", "--report", tmp_path / "made.json", *options)
        assert done.returncode == 0, done.stderr
        mesh = read(tmp_path / "made.vtp")
        assert euler(mesh) == 2
        return mesh, json.loads((tmp_path / "made.json").read_text())

    plain, report = made()
    assert report["levels"] == 4 and not report["options"]["poisson"] and not report["options"]["as_published"]
    # Each level makes four triangles of one; faces as large as the disc's are refined once more, not as published.
    for levels, made_of in ((0, 0), (2, 3)):
        mesh, report = made("--levels", str(levels))
        assert report["levels"] == made_of and mesh.GetNumberOfPolys() == 2 * report["faces"]["CoarseMesh"] * 4 ** made_of
    half, _ = made("--height", "0.5")
    assert numpy.allclose(points_of(half), points_of(plain) * [1, 1, 0.5], atol=1e-9)
    # Poisson's equation: the same outline, another height.
    poisson, report = made("--poisson")
    assert report["options"]["poisson"] and size(poisson) > 1.05 * size(plain)
    assert numpy.allclose(poisson.GetBounds()[:4], plain.GetBounds()[:4], atol=1e-6)
    # As published: thickness and profile are not smoothed, so other heights.
    published, report = made("--as-published")
    assert report["options"]["as_published"] and report["levels"] == 3
    assert abs(size(published) - size(plain)) > 0.01 * size(plain)


def test_a_limb_of_it_is_pulled_and_it_keeps_its_picture(tmp_path):
    inflate("heron", tmp_path / "heron.vtp")
    model = read(tmp_path / "heron.vtp")
    bill = numpy.array([(220, 903), (160, 890), (100, 872), (85, 862), (100, 860), (160, 872), (220, 882)], float)
    along = numpy.linspace(0, 6, 60)
    bill = numpy.column_stack([numpy.interp(along, range(7), bill[:, k]) for k in (0, 1)])
    drawing = vtkXMLPolyDataReader()
    drawing.SetFileName(str(DRAWINGS / "heron.vtp"))
    drawing.Update()
    one = stroke(bill)
    for name in ("ViewTransform", "ProjectionTransform", "ViewportSize"):
        source, target = drawing.GetOutput().GetCellData().GetArray(name), one.GetCellData().GetArray(name)
        target.SetTuple(0, source.GetTuple(0))
    write(one, tmp_path / "bill.vtp")
    done = run("one-stroke", tmp_path / "heron.vtp", tmp_path / "bill.vtp", "-o", tmp_path / "longer.vtp", "--allow-torn")
    assert done.returncode == 0, done.stderr
    longer = read(tmp_path / "longer.vtp")
    assert euler(longer) == euler(model) == 2
    assert longer.GetBounds()[0] < model.GetBounds()[0] - 15  # the bill's tip
    assert longer.GetPointData().GetTCoords() is not None
    assert is_skin(vtk_to_numpy(longer.GetFieldData().GetAbstractArray("Texture")).tobytes(), (DRAWINGS / "heron.png").read_bytes())


def rings_and_disc(path):
    """A picture of 400 x 300 px with alpha: a ring of 100 and 40 px about (130, 150), a disc of 60 px about (310, 150)."""
    x, y = numpy.meshgrid(numpy.arange(400), numpy.arange(300))
    ring, disc = numpy.hypot(x - 130, y - 150), numpy.hypot(x - 310, y - 150)
    inside = ((ring < 100) & (ring > 40)) | (disc < 60)
    pixels = numpy.zeros((300, 400, 4), numpy.uint8)
    pixels[inside] = 60, 120, 200, 255
    image, writer = vtkImageData(), vtkPNGWriter()
    image.SetDimensions(400, 300, 1)
    scalars = numpy_to_vtk(pixels.reshape(-1, 4), deep=True)
    image.GetPointData().SetScalars(scalars)
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()
    return path


def test_outlines_are_traced_in_a_picture(tmp_path):
    image, out = rings_and_disc(tmp_path / "image.png"), tmp_path / "out.vtp"
    done = run("inflate", "--trace", "auto", "--image", image, "-o", out, "--report", tmp_path / "out.json")
    assert done.returncode == 0, done.stderr
    mesh = read(out)
    assert euler(mesh) == 0, "a ring with a tunnel"
    assert numpy.allclose(mesh.GetBounds()[:4], (30, 230, 50, 250), atol=3)
    report = json.loads((tmp_path / "out.json").read_text())
    assert report["strokes"] == ["boundary", "closed feature"] and report["stage_milliseconds"]["Trace"] > 0
    done = run("inflate", "--trace", "310,150", "--trace=auto", "--image", image, "-o", out)
    assert done.returncode == 0, done.stderr
    assert euler(read(out)) == 2, "a disc, and the ring"
    # Strokes that were drawn come after the outlines.
    eye = write(oversketch.drawing([ring(310, 150, 20)[:-1]], (400, 300), closed=True), tmp_path / "eye.vtp")
    done = run("inflate", eye, "--trace", "310,150", "--image", image, "-o", out, "--hole", "1")
    assert done.returncode == 0, done.stderr
    assert euler(read(out)) == 0


def test_what_cannot_be_traced_is_said(tmp_path):
    image, out = rings_and_disc(tmp_path / "image.png"), tmp_path / "no.vtp"
    assert "needs a drawing" in refuse(2, "inflate", "--image", image, "-o", out)
    assert "--trace finds outlines in a picture" in refuse(1, "inflate", "--trace", "auto", "-o", out)
    assert "--trace is" in refuse(1, "inflate", "--trace", "somewhere", "--image", image, "-o", out)
    assert "beyond the picture" in refuse(1, "inflate", "--trace", "500,10", "--image", image, "-o", out)
    assert "one file too many" in refuse(2, "inflate", DRAWINGS / "fish.vtp", DRAWINGS / "leaf.vtp", "--trace", "auto", "-o", out)
    assert not out.exists()


def test_options_add_up_or_stand_once(tmp_path):
    """A list grows with each time that its option is given; whatever else is given twice is bad use, whatever its kind."""
    out = tmp_path / "out.vtp"
    rings = rings_in(tmp_path)
    holes = []
    for options in (["--hole", "1 2"], ["--hole", "1", "--hole", "2"], ["--hole=2", "--hole=1"], ["--hole", "1"], ["--tunnel", "1", "--tunnel", "2"],
                    ["--hole", "1", "--tunnel", "2"]):
        done = run("inflate", rings, "-o", out, *options)
        assert done.returncode == 0, done.stderr
        holes.append((2 - euler(read(out))) // 2)
    assert holes == [2, 2, 2, 1, 2, 2], holes
    for twice in (["--levels", "2", "--levels", "3"], ["--levels=2", "--levels=2"], ["--quads", "--quads"], ["--backend", "embree", "--backend", "embree"],
                  ["-o", out], ["--output", out], ["--report", tmp_path / "a.json", "--report", tmp_path / "b.json"], ["--profile", "linear", "--profile", "step"],
                  ["--image", DRAWINGS / "fish.png", "--image", DRAWINGS / "leaf.png"]):
        out.unlink(missing_ok=True)
        assert "is given twice; give it once" in refuse(2, "inflate", rings, "-o", out, *twice)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["rings.vtp"]
    assert "is given twice" in refuse(2, "terrain", rings, "-o", out, "--quads", "8", "--quads", "4x4")
    assert "is given twice" in refuse(2, "replay", rings, "-o", out, "--model", "1", "--model", "2")
    assert "is given twice" in refuse(2, "assemble", rings, "-o", out, "--report", "a.json", "--report", "b.json")
