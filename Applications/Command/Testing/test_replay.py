"""`oversketch replay`: a session written by hand, after the page that describes the format, gives what its strokes give
one after the other."""
import hashlib
import json
import zipfile

import numpy
import pytest

from scene import *  # noqa: F403
from scene import outline, radius

NODE = {"on": True, "remesh": "off", "adjust_normals": False, "as_published": False}


def vtp(data):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(data)
    writer.WriteToOutputStringOn()
    assert writer.Write()
    text = writer.GetOutputString()
    return text if isinstance(text, bytes) else text.encode("latin-1")


def filed(path, document, mesh, drawn):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        file.writestr("session.json", json.dumps(document))
        file.writestr("mesh/a.vtp", vtp(mesh))
        for i, data in enumerate(drawn):
            file.writestr(f"strokes/{i}.vtp", vtp(data))
    return path


def session(path, mesh, drawn, **changes):
    document = {"format": "oversketch-session", "format_version": 1, "mesh": "mesh/a.vtp", "mesh_name": "body.vtp",
                "backend": "embree", "result_md5": "",
                "made_by": {"version": "", "backend": "embree", "device": "", "processor": ""},
                "strokes": [dict(NODE, name=f"stroke {i}", stroke=f"strokes/{i}.vtp") for i in range(len(drawn))]}
    return filed(path, dict(document, **changes), mesh, drawn)


def digest(mesh):
    """As the page about the format says."""
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    sums = hashlib.md5(numpy.int32(mesh.GetPoints().GetDataType()).tobytes() + points.tobytes())
    cells = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(numpy.int64)
    sums.update(numpy.hstack([numpy.full((len(cells), 1), 3, dtype=numpy.int64), cells]).tobytes())
    return sums.hexdigest()


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The body, two strokes, and what they give one after the other."""
    folder = tmp_path_factory.mktemp("replay")
    mesh, longer, shorter = body(), stroke(outline(1.7)), stroke(outline(1.5))
    write(mesh, folder / "body.vtp")
    write(longer, folder / "longer.vtp")
    write(shorter, folder / "shorter.vtp")
    assert run("one-stroke", folder / "body.vtp", folder / "longer.vtp", "-o", folder / "1.vtp", *QUICK).returncode == 0
    assert run("one-stroke", folder / "1.vtp", folder / "shorter.vtp", "-o", folder / "2.vtp", *QUICK).returncode == 0
    return folder, mesh, longer, shorter


def same(a, b):
    return (numpy.array_equal(vtk_to_numpy(a.GetPoints().GetData()), vtk_to_numpy(b.GetPoints().GetData())) and
            digest(a) == digest(b))


def test_replay_gives_what_the_strokes_give(made):
    folder, mesh, longer, shorter = made
    done = run("replay", session(folder / "s.oversketch", mesh, [longer, shorter]), "-o", folder / "out.vtp")
    assert done.returncode == 0, done.stderr
    assert same(read(folder / "out.vtp"), read(folder / "2.vtp"))
    assert not same(read(folder / "out.vtp"), read(folder / "1.vtp"))


def test_a_stroke_that_is_off_is_passed_by(made):
    folder, mesh, longer, shorter = made
    strokes = [dict(NODE, name="a", stroke="strokes/0.vtp"), dict(NODE, name="b", stroke="strokes/1.vtp", on=False)]
    path = session(folder / "off.oversketch", mesh, [longer, shorter], strokes=strokes)
    assert run("replay", path, "-o", folder / "off.vtp").returncode == 0
    assert same(read(folder / "off.vtp"), read(folder / "1.vtp"))


def test_says_whether_the_bits_are_those_that_were_saved(made):
    folder, mesh, longer, shorter = made
    good = session(folder / "good.oversketch", mesh, [longer, shorter], result_md5=digest(read(folder / "2.vtp")))
    done = run("replay", good, "-o", folder / "good.vtp")
    assert done.returncode == 0 and "bit for bit" not in done.stderr
    assert "the processor was none, here it is" in done.stderr and "the back end" not in done.stderr
    other = session(folder / "other.oversketch", mesh, [longer, shorter], result_md5=digest(read(folder / "1.vtp")))
    done = run("replay", other, "-o", folder / "other.vtp")
    assert done.returncode == 0 and "warning: the mesh is not bit for bit the one that was saved" in done.stderr


def test_a_stroke_that_fails_is_named(made):
    folder, mesh, longer, _ = made
    path = session(folder / "fails.oversketch", mesh, [stroke(outline(1.7)[:2]), longer])
    done = run("replay", path, "-o", folder / "fails.vtp")
    assert done.returncode == 0 and "'stroke 0' did nothing" in done.stderr
    assert same(read(folder / "fails.vtp"), read(folder / "1.vtp"))


def test_both_sides_of_a_mirror_plane(made):
    """The limb lies along x, so a stroke on its upper side moves the lower one exactly alike, across y = 0."""
    folder, mesh, _, _ = made
    angle = numpy.linspace(0.12, 0.5, 120)
    r = radius(angle, 1.4) + 0.15 * numpy.sin(numpy.pi * (angle - 0.12) / 0.38) ** 2
    samples = numpy.stack([WIDTH / 3 + PIXELS * r * numpy.cos(angle), HEIGHT / 2 + PIXELS * r * numpy.sin(angle)], axis=1)
    strokes = [dict(NODE, name="a", stroke="strokes/0.vtp", mirror={"axis": 1, "offset": 0.0})]
    path = session(folder / "mirror.oversketch", mesh, [stroke(samples)], strokes=strokes)
    done = run("replay", path, "-o", folder / "mirror.vtp")
    assert done.returncode == 0 and "did nothing" not in done.stderr, done.stderr
    before, after = (vtk_to_numpy(m.GetPoints().GetData()) for m in (mesh, read(folder / "mirror.vtp")))
    moved = numpy.abs(after - before).max(axis=1) > 0
    upper, lower = moved & (before[:, 1] > 1e-5), moved & (before[:, 1] < -1e-5)
    assert upper.sum() > 50
    flip = numpy.array([1, -1, 1])
    for i in numpy.flatnonzero(upper):
        partner = numpy.argmin(numpy.abs(before - before[i] * flip).sum(axis=1))
        assert lower[partner] and numpy.array_equal(after[partner], after[i] * flip)


def shipped(model, name):
    ply, vtp = vtkPLYReader(), vtkXMLPolyDataReader()
    ply.SetFileName(str(SOURCE / "Data" / "Models" / f"{model}.ply"))
    vtp.SetFileName(str(SOURCE / "Data" / "Strokes" / f"{model}_{name}.vtp"))
    for reader in (ply, vtp):
        reader.Update()
    return ply.GetOutput(), vtp.GetOutput()


def test_both_sides_of_a_model_whose_points_have_no_partners(tmp_path):
    """One arm is drawn longer and the other one gets as long, with new triangles on both; the trunk stays."""
    mesh, drawn = shipped("person", "longer_arm")
    for name, mirror in (("one", None), ("both", {"axis": 0, "offset": 0.0})):
        strokes = [dict(NODE, name="arm", stroke="strokes/0.vtp", remesh="on", **({"mirror": mirror} if mirror else {}))]
        path = session(tmp_path / f"{name}.oversketch", mesh, [drawn], strokes=strokes)
        done = run("replay", path, "-o", tmp_path / f"{name}.vtp")
        assert done.returncode == 0 and "did nothing" not in done.stderr, done.stderr
    before, one, both = (vtk_to_numpy(m.GetPoints().GetData()) for m in (mesh, read(tmp_path / "one.vtp"), read(tmp_path / "both.vtp")))
    assert one[:, 0].max() > before[:, 0].max() + 0.2 and one[:, 0].min() == before[:, 0].min()
    assert both[:, 0].max() == one[:, 0].max() and abs(both[:, 0].min() + both[:, 0].max()) < 1e-3
    assert len(both) > len(one) > len(before)
    trunk = {tuple(p) for p in before[abs(before[:, 0]) < 0.2].tolist()}
    assert trunk <= {tuple(p) for p in both.tolist()}


def test_a_failure_on_the_other_side_names_it(tmp_path):
    mesh, drawn = shipped("hand", "bent_thumb")
    strokes = [dict(NODE, name="thumb", stroke="strokes/0.vtp", mirror={"axis": 2, "offset": 4.5})]  # behind the eye
    done = run("replay", session(tmp_path / "s.oversketch", mesh, [drawn], strokes=strokes), "-o", tmp_path / "out.vtp")
    assert done.returncode == 0 and "'thumb' did nothing: mirrored to z > 4.5: No visible" in done.stderr, done.stderr
    assert same(read(tmp_path / "out.vtp"), mesh)


@pytest.mark.parametrize("arguments", [["replay"], ["replay", "s"], ["replay", "s", "t", "-o", "o.vtp"],
                                       ["replay", "s", "-o", "o.doc"], ["replay", "s", "-o", "o.vtp", "--remesh", "off"]])
def test_bad_use(arguments):
    assert "--help" in refuse(2, *arguments)


def test_failures_leave_no_file(made, tmp_path):
    folder, mesh, longer, _ = made
    out = tmp_path / "o.vtp"
    assert "there is no such file" in refuse(1, "replay", tmp_path / "none.oversketch", "-o", out)
    (tmp_path / "no.oversketch").write_bytes(b"PK no zip")
    assert "is no session" in refuse(1, "replay", tmp_path / "no.oversketch", "-o", out)
    path = session(tmp_path / "new.oversketch", mesh, [longer], format_version=7)
    assert "format version 7" in refuse(1, "replay", path, "-o", out)
    assert not out.exists()


def test_help():
    assert "replay" in run("--help").stdout
    text = run("replay", "--help")
    assert text.returncode == 0 and "bit for bit" in text.stdout


def scene(path, mesh, drawn, **changes):
    """Two models of the same mesh: the first rests with one stroke, the second is chosen and has another."""
    model = {"mesh": "mesh/a.vtp", "mesh_name": "body.vtp", "backend": "embree", "result_md5": "",
             "made_by": {"version": "", "backend": "embree", "device": "", "processor": ""}}
    steps = [{"id": 1, "name": f"stroke {i}", "on": True, "system": "OneStroke", "values": {"Remesh": "off", "AdjustNormals": False},
              "inputs": {"Stroke": {"lines": f"strokes/{i}.vtp"}}} for i in range(2)]
    document = dict(model, format="oversketch-session", format_version=2, steps=steps[1:], place=1, locked=True,
                    models=[dict(model, steps=steps[:1], shown=False)])
    return filed(path, dict(document, **changes), mesh, drawn)


def test_all_models_of_a_scene_or_the_one_asked_for(made):
    folder, mesh, longer, shorter = made
    path = scene(folder / "scene.oversketch", mesh, [longer, shorter])
    for number, drawn in ((1, longer), (2, shorter)):
        alone = session(folder / f"alone{number}.oversketch", mesh, [drawn])
        assert run("replay", alone, "-o", folder / f"alone{number}.vtp").returncode == 0
        done = run("replay", path, "-o", folder / f"model{number}.vtp", "--model", str(number))
        assert done.returncode == 0, done.stderr
        assert same(read(folder / f"model{number}.vtp"), read(folder / f"alone{number}.vtp"))
    done = run("replay", path, "-o", folder / "all.vtp")
    assert done.returncode == 0, done.stderr
    both = read(folder / "all.vtp")
    parts = [read(folder / f"model{number}.vtp") for number in (1, 2)]
    points = [vtk_to_numpy(part.GetPoints().GetData()).astype(numpy.float64) for part in parts]
    assert numpy.array_equal(vtk_to_numpy(both.GetPoints().GetData()), numpy.concatenate(points))
    ids = vtk_to_numpy(both.GetCellData().GetArray("PartId"))
    assert [int((ids == part).sum()) for part in (0, 1)] == [part.GetNumberOfPolys() for part in parts]
    done = run("replay", path, "-o", folder / "none.vtp", "--model", "3")
    assert done.returncode == 1 and "has 2 models, so there is no model 3" in done.stderr
    for bad in ("0", "1.5", "first"):
        assert run("replay", path, "-o", folder / "none.vtp", "--model", bad).returncode == 2


@pytest.mark.parametrize("change, words", [({"place": 2}, "place"), ({"models": [{}]}, "mesh_name"), ({"models": 1}, "models")])
def test_a_damaged_scene_is_refused(made, change, words):
    folder, mesh, longer, shorter = made
    done = run("replay", scene(folder / "bad.oversketch", mesh, [longer, shorter], **change), "-o", folder / "bad.vtp")
    assert done.returncode == 1 and words in done.stderr, done.stderr
