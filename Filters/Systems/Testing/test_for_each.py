"""Collections from Python: a stroke for each of two shipped models, and what is said of one that is refused."""
import os
import pathlib

import numpy as np
import pytest
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from oversketch import vtkOversketchForEach, vtkOversketchOneStroke

DATA = pathlib.Path(os.environ["OVERSKETCH_SOURCE"]) / "Data"


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


@pytest.fixture
def collection():
    models, strokes = vtk.vtkMultiBlockDataSet(), vtk.vtkMultiBlockDataSet()
    for i, (model, stroke) in enumerate([("dog", "dog_longer_leg"), ("hand", "hand_longer_finger")]):
        models.SetBlock(i, read(vtk.vtkPLYReader(), DATA / "Models" / f"{model}.ply"))
        strokes.SetBlock(i, read(vtk.vtkXMLPolyDataReader(), DATA / "Strokes" / f"{stroke}.vtp"))
    return models, strokes


def driven(models, strokes):
    system = vtkOversketchOneStroke()
    system.SetRemeshToOff()
    each = vtkOversketchForEach()
    each.SetFilter(system)
    each.SetInputDataObject(0, models)
    each.SetStrokeData(strokes)
    return each


def test_each_gets_what_the_filter_alone_makes(collection):
    models, strokes = collection
    each = driven(models, strokes)
    each.Update()
    for i in range(2):
        alone = vtkOversketchOneStroke()
        alone.SetRemeshToOff()
        alone.SetInputData(0, models.GetBlock(i))
        alone.SetStrokeData(strokes.GetBlock(i))
        alone.Update()
        ours = vtk_to_numpy(each.GetOutputDataObject(0).GetBlock(i).GetPoints().GetData())
        theirs = vtk_to_numpy(alone.GetOutput().GetPoints().GetData())
        before = vtk_to_numpy(models.GetBlock(i).GetPoints().GetData())
        assert np.array_equal(ours, theirs)
        assert not np.array_equal(ours, before)


def test_a_refused_model_is_named(collection):
    models, strokes = collection
    strokes.GetBlock(0).GetCellData().RemoveArray("ViewTransform")
    each = driven(models, strokes)
    messages = []

    def hear(caller, event, text):
        messages.append(text)

    hear.CallDataType = vtk.VTK_STRING
    each.AddObserver("ErrorEvent", hear)
    each.Update()
    assert len(messages) == 1 and "leaf 1: " in messages[0] and "ViewTransform" in messages[0]
    assert each.GetNumberOfFailures() == 1
    assert each.GetOutputDataObject(0).GetBlock(0).GetNumberOfPoints() == 0
    assert each.GetOutputDataObject(0).GetBlock(1).GetNumberOfPoints() > 0


def test_the_controller_can_be_taken_away():
    each = vtkOversketchForEach()
    each.SetController(None)
    assert each.GetController() is None
    controller = vtk.vtkDummyController()
    each.SetController(controller)
    assert each.GetController() is controller
