"""What the shipped lines and rings make of their models: a region that the ring encloses, nothing folded, and that the script makes them."""
import os
import sys

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import vtk_to_numpy

import oversketch

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import listing  # noqa: E402
import make_edits  # noqa: E402


def read(path):
    reader = vtk.vtkPLYReader() if str(path).endswith(".ply") else vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


@pytest.mark.parametrize("path", listing.edits(), ids=lambda path: path.stem)
def test_result(path):
    mesh = read(os.path.join(HERE, "Models", path.stem.split("_")[0] + ".ply"))
    system = oversketch.vtkOversketchEdit()
    for port, data in enumerate((mesh, read(path), read(path.with_name(path.stem + "_ring.vtp")))):
        system.SetInputData(port, data)
    system.SetOperations(f"move 0.5 n {0.02 * mesh.GetLength()!r}")
    result = oversketch.update(system)
    assert system.GetFoldedEdges() == 0 and system.GetMovedPoints() > 200
    assert mesh.GetNumberOfCells() < result.GetNumberOfCells() < 2 * mesh.GetNumberOfCells()
    line = vtk_to_numpy(system.GetReferenceOutput().GetPoints().GetData())
    assert np.isfinite(line).all() and len(line) > 10


@pytest.mark.parametrize("path", listing.edits(), ids=lambda path: path.stem)
@pytest.mark.parametrize("end", ["", "_ring"])
def test_the_script_makes_what_is_shipped(path, end):
    made, shipped = make_edits.make(path.stem + end), read(path.with_name(path.stem + end + ".vtp"))
    places = [vtk_to_numpy(data.GetPoints().GetData()) for data in (made, shipped)]
    assert places[0].shape == places[1].shape and np.abs(places[0] - places[1]).max() < 1e-6
    if end:  # it closes where it began
        assert np.linalg.norm(places[1][0] - places[1][-1]) < 6.0
