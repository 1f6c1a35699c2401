"""What the shipped lines and rings, and what goes with them, make of their models: a region that the ring encloses, nothing folded, from
Python the same as by the command; and that the script makes them."""
import json
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import vtk_to_numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

sys.path.insert(0, os.path.join(HERE, "..", "Applications", "Examples"))
import listing  # noqa: E402
import make_edits  # noqa: E402
import oversketch  # noqa: E402
from edited import beside  # noqa: E402


def read(path):
    reader = vtk.vtkPLYReader() if str(path).endswith(".ply") else vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def grey(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())


def operations(text):
    """As options of the command."""
    given = []
    for part in filter(None, text.split("; ")):
        what, *values = part.split()
        given += ["--" + what, ",".join(values)]
    return given


def options(name):
    """Those of the command that do what an edit is shipped for."""
    file, given = os.path.join(HERE, "Edits", name), operations(listing.EDIT[name])
    for option, end in (("--layers", ".json"), ("--weights", ".png"), ("--profile", "_profile.vtp")):
        given += [option, file + end] if os.path.exists(file + end) else []
    return given


def without(given, option):
    at = given.index(option)
    return given[:at] + given[at + 2:]


def edited(path, given, folder):
    """What the command makes of a shipped line and ring, and its report."""
    model, ring = os.path.join(HERE, "Models", path.stem.split("_")[0] + ".ply"), path.with_name(path.stem + "_ring.vtp")
    made, report = str(folder / "made.vtp"), folder / "report.json"
    subprocess.run([os.environ["OVERSKETCH_COMMAND"], "edit", model, "--reference", str(path), "--boundary", str(ring), "-o", made,
                    "--report", str(report), *given], check=True)
    return read(model), read(made), json.loads(report.read_text())["edit"]


@pytest.mark.parametrize("path", listing.edits(), ids=lambda path: path.stem)
def test_result(path, tmp_path):
    mesh, result, report = edited(path, options(path.stem), tmp_path)
    assert report["folded_edges"] == 0 and report["moved_points"] > 200
    assert mesh.GetNumberOfCells() < result.GetNumberOfCells() < 1.25 * mesh.GetNumberOfCells()
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(result)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    assert edges.GetOutput().GetNumberOfCells() == 0
    # It is to be seen: by a hundredth of the model at least.
    locator = vtk.vtkStaticPointLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    points = vtk_to_numpy(result.GetPoints().GetData())
    off = [np.linalg.norm(p - mesh.GetPoint(locator.FindClosestPoint(p))) for p in points]
    assert max(off) > 0.01 * mesh.GetLength()


@pytest.mark.parametrize("move", ["0.14", "0.15", "0.16", "0.17", "0.18", "0.19", "0.2"])
def test_new_triangles_fold_and_cross_nothing(move, tmp_path):
    """However far the crest goes, over small triangles that it stretches and bends to several times their size."""
    path = pathlib.Path(HERE) / "Strokes" / "dinosaur_crest.vtp"
    report = edited(path, ["--move", f"0.5,n,{move}"], tmp_path)[2]
    assert report["folded_edges"] == 0 and report["crossings"] == 0


@pytest.mark.parametrize("path", listing.edits(), ids=lambda path: path.stem)
def test_what_goes_with_it_matters(path, tmp_path):
    given = options(path.stem)
    files = [option for option in ("--layers", "--weights", "--profile") if option in given]
    assert len(files) == (0 if path.stem == "hand_palm" else 1)
    for option in files:
        (tmp_path / "with").mkdir()
        (tmp_path / "without").mkdir()
        made, plain = (vtk_to_numpy(edited(path, chosen, tmp_path / folder)[1].GetPoints().GetData())
                       for chosen, folder in ((given, "with"), (without(given, option), "without")))
        assert made.shape != plain.shape or np.abs(made - plain).max() > 0.005


KINDS = {"layers": ("--layers", ".json"), "painted": ("--weights", ".png"), "section": ("--profile", ".vtp")}


@pytest.mark.parametrize("name", listing.FURTHER)
def test_further_ones(name, tmp_path):
    """Layers, painted weights and cross-sections that go with the same lines and rings: nothing folds, and they are seen."""
    (edit, kind), file = name.rsplit("_", 1), os.path.join(HERE, "Edits", name)
    given, option = operations(listing.FURTHER[name]), [KINDS[kind][0], file + KINDS[kind][1]]
    path = pathlib.Path(HERE) / "Strokes" / (edit + ".vtp")
    mesh, made, report = edited(path, given + option, tmp_path)
    assert report["folded_edges"] == 0 and report["moved_points"] > 200
    plain = edited(path, given, tmp_path)[1] if given else mesh
    made = vtk_to_numpy(made.GetPoints().GetData())
    locator = vtk.vtkStaticPointLocator()
    locator.SetDataSet(plain)
    locator.BuildLocator()
    off = [np.linalg.norm(p - plain.GetPoint(locator.FindClosestPoint(p))) for p in made]
    assert max(off) > 0.005 * mesh.GetLength()
    if kind == "painted":
        reader = vtk.vtkPNGReader()
        reader.SetFileName(option[1])
        reader.Update()
        assert max(reader.GetOutput().GetDimensions()) <= 64


def test_each_model_has_all_kinds():
    kinds = {"_profile": "section", "_layers": "layers", "_painted": "painted", "_section": "section"}
    shipped = set()
    for file in os.listdir(os.path.join(HERE, "Edits")):
        name, end = os.path.splitext(file)
        tail = next((tail for tail in kinds if name.endswith(tail)), None)
        plain = {".json": "layers", ".png": "painted", ".vtp": "area"}[end]
        shipped.add((name.split("_")[0], kinds[tail] if tail else plain))
    models = {name.split("_")[0] for name in listing.EDIT}
    assert len(models) == 5 and all((model, kind) in shipped for model in models for kind in KINDS)


def alike(one, other):
    """Points, cells and arrays, bit for bit."""
    for data in ("GetPolys", "GetLines"):
        cells = [getattr(mesh, data)() for mesh in (one, other)]
        for part in ("GetOffsetsArray", "GetConnectivityArray"):
            if not np.array_equal(*(vtk_to_numpy(getattr(each, part)()) for each in cells)):
                return False
    pairs = [[mesh.GetPoints().GetData() for mesh in (one, other)]]
    for data in ("GetPointData", "GetCellData", "GetFieldData"):
        two = [getattr(mesh, data)() for mesh in (one, other)]
        names = [{each.GetAbstractArray(i).GetName() for i in range(each.GetNumberOfArrays())} for each in two]
        if names[0] != names[1]:
            return False
        pairs += [[each.GetAbstractArray(name) for each in two] for name in names[0]]
    real = (vtk.VTK_FLOAT, vtk.VTK_DOUBLE)
    return all(a.GetDataType() == b.GetDataType() and np.array_equal(*map(vtk_to_numpy, (a, b)), equal_nan=a.GetDataType() in real)
               for a, b in pairs)


@pytest.mark.parametrize("name", ["dog_back", "octopus_mantle", "person_belly"])  # a cross-section, painted weights, layers with an area
def test_python_makes_what_the_command_makes(name, tmp_path):
    """Of every step of the system, bit for bit."""
    path, given = pathlib.Path(HERE) / "Strokes" / (name + ".vtp"), options(name)
    model, made, _ = edited(path, given + ["--inner", str(tmp_path / "inner")], tmp_path)
    system = oversketch.vtkOversketchEdit()
    for port, data in enumerate((model, read(path), read(path.with_name(name + "_ring.vtp")))):
        system.SetInputData(port, data)
    for parameter, value in beside(name).items():
        getattr(system, "Set" + parameter)(value)
    assert alike(oversketch.update(system), made) and not alike(model, made)
    steps = sorted((tmp_path / "inner").glob("*.vtp"))
    assert len(steps) > 8
    for step in steps:
        assert alike(system.GetInnerOutput(step.stem), read(step)), step.stem


@pytest.mark.parametrize("path", listing.edits(), ids=lambda path: path.stem)
@pytest.mark.parametrize("end", ["", "_ring"])
def test_the_script_makes_what_is_shipped(path, end):
    made, shipped = make_edits.make(path.stem + end), read(path.with_name(path.stem + end + ".vtp"))
    places = [vtk_to_numpy(data.GetPoints().GetData()) for data in (made, shipped)]
    assert places[0].shape == places[1].shape and np.abs(places[0] - places[1]).max() < 1e-6
    if end:  # it closes where it began
        assert np.linalg.norm(places[1][0] - places[1][-1]) < 6.0


@pytest.mark.parametrize("name", make_edits.BESIDE)
def test_the_script_makes_what_goes_with_them(name, tmp_path):
    make_edits.keep(str(tmp_path), name, make_edits.make(name))
    made, shipped = tmp_path / "Edits" / name, os.path.join(HERE, "Edits", name)
    if name.endswith(".vtp"):
        places = [vtk_to_numpy(read(file).GetPoints().GetData()) for file in (made, shipped)]
        assert np.abs(places[0] - places[1]).max() < 1e-12
    elif name.endswith(".png"):
        assert np.array_equal(*(grey(file) for file in (made, shipped)))
    else:
        with open(shipped) as file:
            assert json.load(file) == json.loads(made.read_text())


def test_edits_are_listed():
    assert tuple(listing.EDIT) == tuple(sorted(make_edits.EDITS))
    assert sorted(os.listdir(os.path.join(HERE, "Edits"))) == sorted(make_edits.BESIDE)
    assert {name.split("_")[0] for name in listing.EDIT} == {name.split("_")[0] for name in listing.ONE_STROKE}
    for name in make_edits.BESIDE:
        assert os.path.getsize(os.path.join(HERE, "Edits", name)) < 1e4
