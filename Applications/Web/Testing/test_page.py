"""A visitor's first minute: an outline with the pen, undo, save; the command makes the same bits of it."""
import math
import sys
import pathlib

import oversketch
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from browser import MODELS, browser, replayed, serve  # noqa: E402, F401
from oversketch_web.strokes import laid  # noqa: E402

# Round the dog's foot, in shares of the view; the pen is pressed hardest in the middle.
ARCH = [(0.207 + 0.054 * (1 - math.cos(a)), 0.753 + 0.106 * math.sin(a), 0.3 + 0.6 * math.sin(a)) for a in [math.pi * k / 24 for k in range(25)]]


def test_an_outline_by_pen_is_undone_saved_and_replayed_to_the_same_bits(browser, serve, tmp_path):  # noqa: F811
    page = browser.page(serve(MODELS / "dog.ply").link).ready()
    page.draw(ARCH)
    page.done(1)
    assert page.rows == ["Stroke 1"]
    page.click("#undo")
    page.until("document.querySelectorAll('#steps li').length === 0")
    page.click("#redo")
    page.until("document.querySelectorAll('#steps li').length === 1")
    page.rests()
    file = page.download(lambda: page.click("#save"), tmp_path / "session")
    mesh = page.download(lambda: page.choose("#export", "ply"), tmp_path / "mesh")
    assert mesh.read_bytes() == replayed(file, tmp_path / "replayed.ply")

    session = oversketch.vtkOversketchSession()
    assert session.Open(str(file)), session.GetMessage()
    stroke = session.GetStepInput(1, "Stroke")
    forces = vtk_to_numpy(stroke.GetPointData().GetArray("Pressure"))
    places = vtk_to_numpy(stroke.GetPoints().GetData())
    _, _, width, height = page.box("#pen")
    assert len(forces) == len(ARCH)
    for (x, y, force), said, place in zip(ARCH, forces, places):
        assert abs(said - force) < 1e-6
        assert math.hypot(place[0] - x * width, place[1] - (1 - y) * height) < 1.0
    start = session.GetDigest()
    assert session.Update() and session.GetDigest() != start


def test_a_line_lies_in_front_though_its_view_begins_within_the_model():
    session = oversketch.vtkOversketchSession()
    assert session.Open(str(MODELS.parent / "Works" / "relief.oversketch")), session.GetMessage()
    assert all(session.SetStepOn(step, False) for step in range(2, 20)) and session.Update()
    ring, = laid(session.GetStepInput(2, "Boundary"), session.GetMesh())
    assert abs(ring[:, 2] - 45.0).max() < 0.1  # on a slab's face
