"""A collection of models for vtkOversketchForEach: the shipped ones slightly deformed, each with its stroke, and three in
their midst that are not good: one with a point that is not a number, one without points, one whose stroke has lost its
view. Each carries its number as field array ModelId. No test of its own."""
import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
sys.path.insert(0, str(DATA))
import listing  # noqa: E402

BAD = {"not a number": 0.25, "no points": 0.5, "no view": 0.75}  # where in the collection


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetOutput().GetNumberOfPoints() > 0, path
    return reader.GetOutput()


def moved(data, points):
    """A copy with other points, of the same precision."""
    copy = vtkPolyData()
    copy.ShallowCopy(data)
    array = numpy_to_vtk(points.astype(vtk_to_numpy(data.GetPoints().GetData()).dtype), deep=True)
    copy.SetPoints(vtkPoints())
    copy.GetPoints().SetData(array)
    return copy


def variant(mesh, drawn, seed):
    """Another animal of the kind: scaled by up to 2 % along each axis and waved by half a percent of its size; the stroke of
    another hand: up to 1.5 px away."""
    random = numpy.random.default_rng(seed)
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    centre, size = points.mean(axis=0), numpy.linalg.norm(numpy.ptp(points, axis=0))
    scaled = (points - centre) * random.uniform(0.98, 1.02, 3)
    phase = 2.0 * numpy.pi * (scaled @ random.normal(size=3) / size + random.random())
    waved = scaled + 0.005 * size * numpy.sin(phase)[:, None] * random.normal(size=3) / numpy.sqrt(3.0)
    samples = vtk_to_numpy(drawn.GetPoints().GetData()).astype(float)
    samples[:, :2] += random.uniform(-1.5, 1.5, 2)
    return moved(mesh, waved + centre), moved(drawn, samples)


def named(mesh, index):
    ident = vtkIntArray()
    ident.SetName("ModelId")
    ident.InsertNextValue(index)
    mesh.GetFieldData().AddArray(ident)
    return mesh


def pairs(count):
    shipped = []
    for path in listing.one_stroke():
        mesh = read(vtkPLYReader(), DATA / "Models" / (path.stem.split("_")[0] + ".ply"))
        shipped.append((mesh, read(vtkXMLPolyDataReader(), path)))
    total = count + len(BAD)
    wrong = {int(share * total): what for what, share in BAD.items()}
    for index in range(total):
        mesh, drawn = variant(*shipped[index % len(shipped)], seed=index)
        if wrong.get(index) == "not a number":
            mesh.GetPoints().SetPoint(7, float("nan"), 0.0, 0.0)
        elif wrong.get(index) == "no points":
            mesh = vtkPolyData()
        elif wrong.get(index) == "no view":
            drawn.GetCellData().RemoveArray("ViewTransform")
        yield named(mesh, index), drawn
