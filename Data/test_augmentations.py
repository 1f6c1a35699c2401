"""What the shipped strokes that augment make of their models: one curve each, a feature of full height, nothing turned over."""
import os
import sys

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import vtk_to_numpy

import oversketch

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import erosion  # noqa: E402
import listing  # noqa: E402
import make_augmentations  # noqa: E402


def volume(mesh):
    """What a closed mesh holds."""
    mass = vtk.vtkMassProperties()
    mass.SetInputData(mesh)
    return mass.GetVolume()


@pytest.mark.parametrize("path", listing.augment(), ids=lambda path: path.stem)
def test_result(path):
    strokes, model = vtk.vtkXMLPolyDataReader(), path.stem.split("_")[0]
    strokes.SetFileName(str(path))
    if model == "valley":
        image, mesh = vtk.vtkPNGReader(), oversketch.vtkOversketchTerrain()
        image.SetFileName(os.path.join(HERE, "Terrain", "valley.png"))
        mesh.SetInputConnection(image.GetOutputPort())
        mesh.SetScale(make_augmentations.GRAY)
    else:
        mesh = vtk.vtkPLYReader()
        mesh.SetFileName(os.path.join(HERE, "Models", model + ".ply"))
    system = oversketch.vtkOversketchAugment()
    system.SetInputConnection(0, mesh.GetOutputPort())
    system.SetInputConnection(1, strokes.GetOutputPort())
    silhouette = path.stem == "person_crest"
    system.SetSketchMode(silhouette)
    result = oversketch.update(system)

    assert system.GetInnerOutput("Sketch" if silhouette else "Curves").GetNumberOfCells() == strokes.GetOutput().GetNumberOfCells()
    assert system.GetFigure("met.flipped_faces") == 0
    assert result.GetPointData().GetArray("Feature").GetRange() == (0.0, 1.0)
    before, after = mesh.GetOutput().GetNumberOfCells(), result.GetNumberOfCells()
    print(f"{path.stem}: {before} triangles become {after}")
    assert before < after < 14 * before
    if model == "valley":  # finer, it lies on the image
        gray = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).reshape(erosion.SIDE, erosion.SIDE)
        x, y, z = vtk_to_numpy(system.GetInnerOutput("Refine").GetPoints().GetData()).T
        column, row = (np.minimum(v.astype(int), erosion.SIDE - 2) for v in (x, y))
        u, v = x - column, y - row
        below, above = ((1 - u) * gray[row + k, column] + u * gray[row + k, column + 1] for k in (0, 1))
        assert np.abs(z - make_augmentations.GRAY * ((1 - v) * below + v * above)).max() < 1e-9
    heights = strokes.GetOutput().GetCellData().GetArray("Height")
    if not silhouette:
        highest = max(abs(heights.GetValue(i)) for i in range(heights.GetNumberOfTuples()))
        assert result.GetPointData().GetArray("Displacement").GetRange(-1)[1] == pytest.approx(highest, rel=1e-9)
    if model != "valley":
        assert (volume(result) > volume(mesh.GetOutput())) == (silhouette or heights.GetValue(0) > 0.0)
