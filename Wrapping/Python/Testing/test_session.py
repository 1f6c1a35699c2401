"""Sessions: what a session makes is what its filters make, what it keeps the command replays to the bit, and what is wrong is said and
changes nothing."""
import hashlib
import json
import os
import pathlib
import struct
import subprocess
import time
import zipfile

import numpy
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkCamera

import oversketch

COMMAND = os.environ["OVERSKETCH_COMMAND"]
DATA = pathlib.Path(os.environ["OVERSKETCH_SOURCE"]) / "Data"
FISH = DATA / "Drawings" / "fish.png"


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def lines(name, folder="Strokes"):
    return read(vtkXMLPolyDataReader(), DATA / folder / f"{name}.vtp")


def points(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData())


def digest(mesh):
    """As the page of the session's file tells it."""
    places, polygons = mesh.GetPoints().GetData(), mesh.GetPolys()
    ids = vtk_to_numpy(polygons.GetConnectivityArray()).astype("<i8")
    corners = vtk_to_numpy(polygons.GetOffsetsArray()).astype("<i8")
    made = hashlib.md5(struct.pack("<i", places.GetDataType()) + vtk_to_numpy(places).tobytes())
    for first, last in zip(corners, corners[1:]):
        made.update(struct.pack("<q", last - first) + ids[first:last].tobytes())
    return made.hexdigest()


def done(session, answer):
    """The answer of a call that must have done its work."""
    assert answer, session.GetMessage()
    return answer


def refused(session, answer):
    assert not answer and session.GetMessage()
    return session.GetMessage()


def steps(session):
    return json.loads(session.GetSteps())


def add(session, system, values=None, **inputs):
    for name, given in inputs.items():
        session.SetInput(name, given)
    return done(session, session.AddStep(system, json.dumps(values or {})))


def updated(session):
    done(session, session.Update())
    assert session.GetDigest() == digest(session.GetMesh())
    return session.GetDigest()


def opened(model="dog"):
    session = oversketch.vtkOversketchSession()
    done(session, session.Open(str(DATA / "Models" / f"{model}.ply")))
    return session


def replayed(session, folder):
    """What the command makes of the saved session."""
    path, out = folder / "saved.oversketch", folder / "out.vtp"
    done(session, session.Save(str(path)))
    run = subprocess.run([COMMAND, "replay", str(path), "-o", str(out)], capture_output=True, text=True)
    assert run.returncode == 0 and "bit for bit" not in run.stderr, run.stderr
    with zipfile.ZipFile(path) as package:
        return json.loads(package.read("session.json")), read(vtkXMLPolyDataReader(), out)


def test_steps_make_what_their_filters_make_and_the_command_replays_them(tmp_path):
    session = opened()
    assert session.GetMesh().GetNumberOfPoints() > 1000 and session.GetSaved() and not session.GetCanUndo()
    leg = lines("dog_longer_leg")
    first = add(session, "OneStroke", {"Remesh": "off"}, Stroke=leg)
    updated(session)
    system = oversketch.vtkOversketchOneStroke()
    system.SetRemeshToOff()
    system.SetInputDataObject(0, read(vtkPLYReader(), DATA / "Models" / "dog.ply"))
    system.SetStrokeData(leg)
    assert numpy.array_equal(points(session.GetMesh()), points(oversketch.update(system)))

    second = add(session, "Augment", {"Height": 0.05}, Strokes=lines("dog_collar"))
    edit = add(session, "Edit", {"Operations": "move 0.5 n 0.1"}, Reference=lines("dog_back"), Boundary=lines("dog_back_ring"))
    before = updated(session)
    assert [each["system"] for each in steps(session)] == ["OneStroke", "Augment", "Edit"] and [first, second, edit] == [1, 2, 3]
    assert all(each["failure"] == "" for each in steps(session))
    assert steps(session)[0]["section"]["length"] > 0.0
    done(session, session.ChangeStep(edit, '{"Operations": "move 0.5 n 0.2"}'))
    assert updated(session) != before
    assert set(steps(session)[2]["inputs"]) == {"Reference", "Boundary"}

    document, made = replayed(session, tmp_path)
    assert session.GetSaved() and document["result_md5"] == session.GetDigest()
    assert numpy.array_equal(points(made), points(session.GetMesh())) and digest(made) == session.GetDigest()
    again = oversketch.vtkOversketchSession()
    done(again, again.Open(str(tmp_path / "saved.oversketch")))
    assert updated(again) == session.GetDigest() and steps(again) == steps(session)


def test_an_edit_takes_the_curves_of_an_earlier_one():
    session = opened("dinosaur")
    first = add(session, "Edit", {"Operations": "move 0.5 n 0.1"}, Reference=lines("dinosaur_crest"), Boundary=lines("dinosaur_crest_ring"))
    for port, name in ((1, "Reference"), (2, "Boundary")):
        session.SetInputStep(name, first, port)
    done(session, session.AddStep("Edit", '{"Operations": "move 0.5 n 0.2"}'))
    updated(session)
    assert steps(session)[1]["inputs"] == {"Reference": {"step": 1, "port": 1}, "Boundary": {"step": 1, "port": 2}}
    assert "step 2 would stand before step 1" in refused(session, session.MoveStep(2, 0))


def test_undo_redo_off_on_and_away_are_one_step_each():
    session = opened()
    states = [(session.GetDigest(), [])]

    def state():
        updated(session)
        return session.GetDigest(), [(each["id"], each["on"]) for each in steps(session)]

    leg = add(session, "OneStroke", {"Remesh": "off"}, Stroke=lines("dog_longer_leg"))
    states.append(state())
    tail = add(session, "OneStroke", {"Remesh": "off"}, Stroke=lines("dog_curled_tail"))
    states.append(state())
    for change in (lambda: session.SetStepOn(leg, False), lambda: session.SetStepOn(leg, True), lambda: session.MoveStep(tail, 0),
                   lambda: session.SetMirror(leg, 0, 0.0), lambda: session.ClearMirror(leg), lambda: session.RemoveStep(tail)):
        done(session, change())
        states.append(state())
    assert [held for _, held in states[2:6]] == [[(1, True), (2, True)], [(1, False), (2, True)], [(1, True), (2, True)], [(2, True), (1, True)]]
    made = [made for made, _ in states]
    assert made[4] == made[2] and made[7] == made[5] and made[8] == made[1]
    assert len({made[0], made[1], made[2], made[3], made[6]}) == 5  # mirrored, it moves more
    done(session, session.SetStepOn(leg, True))  # it is
    for expected in states[-2::-1]:
        done(session, session.Undo())
        assert state() == expected
    assert session.GetSaved() and "nothing to undo" in refused(session, session.Undo())
    for expected in states[1:]:
        done(session, session.Redo())
        assert state() == expected
    assert not session.GetCanRedo() and "nothing to redo" in refused(session, session.Redo())


def test_a_stroke_is_drawn_anew():
    session = opened()
    leg, tail = lines("dog_longer_leg"), lines("dog_curled_tail")
    step = add(session, "OneStroke", {"Remesh": "off"}, Stroke=leg)
    first = updated(session)
    assert numpy.array_equal(points(session.GetStepInput(step, "Stroke")), points(leg))
    assert session.GetStepInput(step, "Lines") is None and session.GetStepInput(7, "Stroke") is None
    section = steps(session)[0]["section"]
    session.SetInput("Stroke", tail)
    done(session, session.ChangeStep(step, "{}"))
    assert steps(session)[0]["section"] is None  # it takes hold anew
    assert updated(session) != first and steps(session)[0]["section"] != section
    assert steps(session)[0]["values"]["Remesh"] == "off"


def test_a_drawing_wears_its_picture(tmp_path):
    session = oversketch.vtkOversketchSession()
    done(session, session.NewDrawing(str(FISH)))
    assert "did nothing" in refused(session, session.Update())  # it is empty
    assert session.GetMesh() is None and session.GetNumberOfPieces() == 0 and session.GetDigest() == ""
    drawing = lines("fish", "Drawings")
    done(session, session.AddStroke(1, drawing))
    whole = updated(session)
    system = oversketch.vtkOversketchInflateDrawing()
    system.SetInputDataObject(0, drawing)
    system.SetInputDataObject(1, read(vtkPNGReader(), FISH))
    assert numpy.array_equal(points(session.GetMesh()), points(oversketch.update(system)))
    assert session.GetNumberOfPieces() == 1 and session.GetPieceMesh(1) is None and session.GetPiecePicture(-1) is None
    piece, picture = session.GetPieceMesh(0), session.GetPiecePicture(0)
    assert piece.GetPointData().GetTCoords() and piece.GetPointData().GetNormals()
    assert picture.GetDimensions() == read(vtkPNGReader(), FISH).GetDimensions()
    done(session, session.ChangeStep(1, '{"Height": 2.0}'))
    assert updated(session) != whole
    done(session, session.Undo())
    assert updated(session) == whole
    _, made = replayed(session, tmp_path)
    assert digest(made) == whole


def test_a_drawing_on_an_empty_canvas_grows_line_by_line():
    session = oversketch.vtkOversketchSession()
    done(session, session.NewCanvas(400, 300))
    turn = numpy.linspace(0.0, 2.0 * numpy.pi, 60)
    ring = oversketch.drawing([numpy.column_stack([200 + 100 * numpy.cos(turn), 150 + 100 * numpy.sin(turn)])], (400, 300))
    done(session, session.AddStroke(1, ring))
    updated(session)
    low, high = session.GetMesh().GetBounds()[:2]
    assert high - low == pytest.approx(200.0, abs=3.0)
    smooth = session.GetDigest()
    done(session, session.AddStroke(1, oversketch.drawing([[(150, 150), (200, 155), (250, 150)]], (400, 300))))
    assert session.GetStepInput(1, "Strokes").GetNumberOfLines() == 2
    assert updated(session) != smooth  # a feature inside
    done(session, session.Undo())
    assert updated(session) == smooth
    for wrong in ((0, 300), (400, float("nan"))):
        assert "width and a height" in refused(session, session.NewCanvas(*wrong))


def test_what_is_wrong_is_said_and_changes_nothing(tmp_path, capfd):
    session = opened()
    leg = lines("dog_longer_leg")
    step = add(session, "OneStroke", {"Remesh": "off"}, Stroke=leg)
    updated(session)

    def seen():
        return session.GetSteps(), session.GetDigest(), session.GetCanRedo(), session.GetSaved(), session.GetNumberOfModels()

    held = seen()

    def add_with(system="OneStroke", values="{}", **inputs):
        for name, given in inputs.items():
            session.SetInput(name, given)
        return session.AddStep(system, values)

    none = vtkPolyData()
    unsound = vtkPolyData()
    unsound.DeepCopy(leg)
    unsound.GetPoints().SetPoint(1, float("nan"), 0.0, 0.0)
    hostile = tmp_path / "hostile.oversketch"
    done(session, session.Save(str(hostile)))
    session.Undo(), session.Redo()
    with zipfile.ZipFile(hostile) as package:
        entries = {name: package.read(name) for name in package.namelist()}
    document = json.loads(entries["session.json"])
    held = seen()

    def hostile_with(**changes):
        with zipfile.ZipFile(hostile, "w") as package:
            for name, content in {**entries, "session.json": json.dumps({**document, **changes})}.items():
                package.writestr(name, content)
        return session.Open(str(hostile))

    def file(name, content):
        (tmp_path / name).write_bytes(content)
        return str(tmp_path / name)

    def with_file(name, path, system="InflateDrawing"):
        session.SetInputFile(name, path)
        return session.AddStep(system, "{}")

    def with_step(name, number, port):
        session.SetInputStep(name, number, port)
        return session.AddStep("OneStroke", "{}")

    for call, said in (
            (lambda: add_with("TwoStrokes"), "'TwoStrokes' is no system that this version has; it has: OneStroke, "),
            (lambda: add_with(None), "is no system"),
            (lambda: add_with(), "OneStroke needs its input Stroke"),
            (lambda: add_with(Strike=leg), "'Strike' is no input of OneStroke; it has: Mesh, Stroke"),
            (lambda: add_with(Mesh=leg), "Mesh of OneStroke is the mesh of the step before"),
            (lambda: add_with(Stroke=none), "Stroke of OneStroke: holds no polyline"),
            (lambda: add_with(Stroke=unsound), "Stroke of OneStroke: "),
            (lambda: with_file("Stroke", str(FISH), "OneStroke"), "is lines; give them by SetInput"),
            (lambda: add_with("InflateDrawing", Picture=leg), "is a file; give it by SetInputFile"),
            (lambda: with_file("Picture", str(tmp_path / "lost.png")), "lost.png: there is no such file"),
            (lambda: with_file("Picture", file("text.png", b"no picture")), "text.png: is no PNG"),
            (lambda: with_step("Stroke", 9, 1), "output 1 of step 9, which is not there"),
            (lambda: add_with(values='{"Remsh": "off"}', Stroke=leg), "'Remsh' is no parameter of OneStroke; it has: Remesh, "),
            (lambda: add_with(values='{"Remesh": "never"}', Stroke=leg), "'Remesh' is 'never'"),
            (lambda: add_with(values='{"Reach": "far"}', Stroke=leg), "'Reach' is not a number"),
            (lambda: add_with(values='{"Reach": ', Stroke=leg), "no JSON"),
            (lambda: add_with(values="[]", Stroke=leg), "no object"),
            (lambda: add_with("Transform", '{"Move": [1, 2]}'), "'Move' of Transform has a value that it cannot have"),
            (lambda: session.ChangeStep(9, "{}"), "there is no step 9"),
            (lambda: session.ChangeStep(step, '{"Candidate": true}'), "'Candidate' is not"),
            (lambda: session.AddStroke(step, leg), f"step {step} is no drawing"),
            (lambda: session.AddStroke(step, None), "there is no line"),
            (lambda: session.SetStepOn(9, True), "there is no step 9"),
            (lambda: session.RemoveStep(0), "there is no step 0"),
            (lambda: session.MoveStep(step, 1), "its places are 0 to 0"),
            (lambda: session.MoveStep(step, -1), "its places are 0 to 0"),
            (lambda: session.SetMirror(step, 3, 0.0), "an axis, 0, 1 or 2"),
            (lambda: session.SetModel(1), "there is no such model"),
            (lambda: session.SetMesh(None, "none"), "there is no mesh"),
            (lambda: session.SetMesh(none, "none"), "the mesh: holds no points"),
            (lambda: session.Save(str(tmp_path / "session.zip")), "ends in .oversketch"),
            (lambda: session.Save(str(tmp_path / "lost" / "a.oversketch")), "lost"),
            (lambda: session.Export(str(tmp_path / "a.docx")), "a.docx"),
            (lambda: session.NewDrawing(str(DATA / "README.md")), "README.md: is no PNG"),
            (lambda: session.Open(None), "there is no such file"),
            (lambda: session.Open(file("cut.ply", (DATA / "Models" / "dog.ply").read_bytes()[:5000])), "cut.ply: "),
            (lambda: session.Open(file("cut.oversketch", hostile.read_bytes()[:5000])), "cut.oversketch: "),
            (lambda: hostile_with(format_version=9), "9"),
            (lambda: hostile_with(mesh="../../etc/passwd"), "lacks its entry ../../etc/passwd"),
            (lambda: hostile_with(strokes=[{**document["strokes"][0], "remesh": "never"}]), "'remesh' is 'never'"),
            (lambda: hostile_with(strokes={}), "'strokes'"),
    ):
        message = refused(session, call())
        assert said in message, message
        assert seen() == held, message
    assert capfd.readouterr() == ("", "")
    assert add(session, "OneStroke", {"Remesh": "off"}, Stroke=leg) == step + 1  # nothing of what was refused is left


def test_a_step_that_fails_is_held_and_says_why():
    session = opened()
    beside = oversketch.stroke([[1.0, 1.0], [5.0, 1.0], [9.0, 2.0]], vtkCamera(), (400, 300))
    step = add(session, "OneStroke", Stroke=beside)
    message = refused(session, session.Update())
    (held,) = steps(session)
    assert held["id"] == step and held["failure"] and message == f"'{held['name']}' did nothing: {held['failure']}"
    assert session.GetDigest() == digest(opened().GetMesh())
    session.SetInput("Stroke", lines("dog_longer_leg"))
    done(session, session.ChangeStep(step, "{}"))
    assert steps(session)[0]["failure"] == ""  # not known yet
    updated(session)


def test_the_background_runs_and_can_be_cancelled():
    session = opened()
    assert not session.Poll() and not session.IsRunning() and session.GetProgress() == 1.0 and session.GetStage() == ""
    add(session, "OneStroke", Stroke=lines("dog_longer_leg"))
    start = session.GetDigest()

    def wait():
        """The stages, and whether a result came."""
        stages, shares = set(), []
        while session.IsRunning():
            stages.add(session.GetStage())
            shares.append(session.GetProgress())
            assert not session.Poll() or not session.IsRunning()
            time.sleep(0.001)
        assert all(0.0 <= share <= 1.0 for share in shares)
        return stages, session.Poll()

    session.Start()
    session.Cancel()
    assert wait()[1] is False and session.GetDigest() == start and session.GetCanUndo()
    session.Start()
    stages, came = wait()
    assert came and any(stage.startswith("Stroke 1: ") for stage in stages)
    assert not session.Poll() and session.GetStage() == ""
    alone = session.GetDigest()
    assert alone == digest(session.GetMesh()) != start
    add(session, "OneStroke", Stroke=lines("dog_curled_tail"))
    session.Start()
    add(session, "Augment", {"Height": 0.05}, Strokes=lines("dog_collar"))
    session.Start()  # instead of what runs
    while session.IsRunning():
        time.sleep(0.001)
    assert session.Poll() and not session.Poll()
    both = session.GetDigest()
    assert updated(session) == both != alone
    session.Start()
    del session  # ends what runs


def test_another_session_takes_no_result_of_the_one_before():
    session = opened()
    add(session, "OneStroke", Stroke=lines("dog_longer_leg"))
    session.Start()
    while session.IsRunning():
        time.sleep(0.001)
    done(session, session.Open(str(DATA / "Models" / "hand.ply")))
    assert not session.Poll() and steps(session) == [] and session.GetDigest() == opened("hand").GetDigest()


def test_a_mesh_of_python_s_begins_a_session_and_stays_its_own():
    sphere = vtkSphereSource()
    sphere.Update()
    given = sphere.GetOutput()
    session = oversketch.vtkOversketchSession()
    done(session, session.SetMesh(given, "ball"))
    before = session.GetDigest()
    assert before == digest(given)
    vtk_to_numpy(given.GetPoints().GetData())[:] = 0.0
    vtk_to_numpy(session.GetMesh().GetPoints().GetData())[:] = 0.0  # what is handed out is a copy
    done(session, session.AddStep("Transform", '{"Move": [1, 2, 3]}'))
    updated(session)
    assert session.GetMesh().GetCenter() == pytest.approx((1.0, 2.0, 3.0), abs=0.01)
    done(session, session.RemoveStep(1))
    assert updated(session) == before


def test_export_and_look(tmp_path):
    session = oversketch.vtkOversketchSession()
    assert "no mesh yet" in refused(session, session.Export(str(tmp_path / "none.ply")))
    session = opened()
    camera, seen = vtkCamera(), vtkCamera()
    assert not session.GetLook(camera)
    camera.SetPosition(1.0, 2.0, 9.0)
    camera.SetFocalPoint(0.2, 0.1, 0.0)
    camera.SetViewAngle(40.0)
    camera.SetParallelProjection(True)
    camera.SetParallelScale(3.0)
    camera.SetWindowCenter(0.1, -0.2)
    session.SetLook(camera, 800, 600)
    add(session, "Transform", {"Move": [1, 0, 0]})
    updated(session)
    document, _ = replayed(session, tmp_path)
    assert document["look"]["size"] == [800, 600]
    done(session, session.Open(str(tmp_path / "saved.oversketch")))
    assert session.GetLook(seen)
    for name in ("Position", "FocalPoint", "ViewUp", "ViewAngle", "ParallelProjection", "ParallelScale", "WindowCenter"):
        assert getattr(seen, "Get" + name)() == getattr(camera, "Get" + name)(), name
    updated(session)
    done(session, session.Export(str(tmp_path / "dog.ply")))
    assert numpy.allclose(points(read(vtkPLYReader(), tmp_path / "dog.ply")), points(session.GetMesh()))
    done(session, session.Export(str(tmp_path / "dog.stl")))


def test_heights_begin_with_a_terrain():
    session = oversketch.vtkOversketchSession()
    heights = sorted((DATA / "Terrain").iterdir())[0]
    done(session, session.Open(str(heights)))
    assert [each["system"] for each in steps(session)] == ["Terrain"]
    updated(session)
    assert session.GetMesh().GetNumberOfPoints() > 100


def test_models_of_a_scene_are_worked_on_one_at_a_time(tmp_path):
    entries, documents, digests = {}, [], []
    for model in ("dog", "hand"):
        session = opened(model)
        add(session, "Transform", {"Move": [1, 0, 0]})
        digests.append(updated(session))
        done(session, session.Save(str(tmp_path / "one.oversketch")))
        with zipfile.ZipFile(tmp_path / "one.oversketch") as package:
            entries.update((name, package.read(name)) for name in package.namelist())
        documents.append(json.loads(entries["session.json"]))
    members = ("mesh", "mesh_name", "backend", "steps", "made_by", "result_md5")
    scene = {**documents[0], "models": [{name: documents[1][name] for name in members}], "place": 0}
    with zipfile.ZipFile(tmp_path / "both.oversketch", "w") as package:
        for name, content in {**entries, "session.json": json.dumps(scene)}.items():
            package.writestr(name, content)
    done(session, session.Open(str(tmp_path / "both.oversketch")))
    assert session.GetNumberOfModels() == 2 and session.GetModel() == 0
    done(session, session.SetModel(1))
    assert session.GetModel() == 1 and session.GetDigest() == digests[1]  # as it rested
    assert updated(session) == digests[1]
    add(session, "Transform", {"Move": [0, 1, 0]})
    done(session, session.SetModel(0))
    assert session.GetDigest() == digests[0] and updated(session) == digests[0]
    document, _ = replayed(session, tmp_path)
    assert document["models"][0]["result_md5"] not in ("", digests[1])
    done(session, session.Undo())  # of the step on the other one, which is worked on again by that
    assert session.GetModel() == 1 and updated(session) == digests[1]


def test_the_systems_are_told_as_they_are():
    told = {row["name"]: row for row in json.loads(oversketch.vtkOversketchSession.GetSystems())}
    assert {"OneStroke", "Augment", "Edit", "InflateDrawing"} <= set(told)
    for name, row in told.items():
        system = getattr(oversketch, f"vtkOversketch{name}")()
        for parameter in row["parameters"]:
            getter = getattr(system, "Get" + parameter["property"], None)
            if getter is None:
                continue  # of a step of the system
            value = getter()
            default = parameter["default"]
            if parameter["kind"] == "choice":
                value = parameter["choices"][value]["word"]
            elif parameter["kind"] == "numbers":
                value = list(value)
            elif parameter["kind"] == "text":
                value = value or ""
            assert value == default and type(value) is type(default), (name, parameter["property"])
        assert all(each["kind"] in ("mesh", "stroke", "curves", "picture", "heights") for each in row["inputs"])
