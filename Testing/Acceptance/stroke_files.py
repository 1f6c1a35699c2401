"""Strokes as files: display px samples with the view that they were drawn in, and what their maker knows of them."""
import json

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import picture

CORRELATED = 20.0  # px along a stroke over which a hand strays alike
VIEW_ARRAYS = ("ViewTransform", "ProjectionTransform", "ViewportSize")


def polydata(samples, view, note=None):
    """Display px samples and their view as the polydata that the filters read; the note goes into field data."""
    stroke, points, line = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    line.InsertNextCell(len(samples))
    for x, y in samples:
        line.InsertCellPoint(points.InsertNextPoint(x, y, 0.0))
    stroke.SetPoints(points)
    stroke.SetLines(line)
    for name, value in zip(VIEW_ARRAYS, (view.view, view.projection, np.array([view.width, view.height], np.int32))):
        array = numpy_to_vtk(np.ascontiguousarray(value.reshape(1, -1)), deep=True)
        array.SetName(name)
        stroke.GetCellData().AddArray(array)
    if note is not None:
        text = vtkStringArray()
        text.SetName("Note")
        text.InsertNextValue(json.dumps(note))
        stroke.GetFieldData().AddArray(text)
    return stroke


def write(stroke, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(stroke)
    writer.Write()


def read(path):
    """A stroke file: (polydata, samples in px, view, note or None)."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    stroke = reader.GetOutput()
    data = stroke.GetCellData()
    values = [vtk_to_numpy(data.GetArray(name))[0] for name in VIEW_ARRAYS]
    note = stroke.GetFieldData().GetAbstractArray("Note")
    view = picture.View(values[0].reshape(4, 4), values[1].reshape(4, 4), *values[2])
    points = vtk_to_numpy(stroke.GetPoints().GetData())
    return stroke, points[:, :2].astype(float), view, json.loads(note.GetValue(0)) if note else None


def noise(count, random):
    """How a hand strays round a closed curve of points 1 px apart: mean square 1, correlated over CORRELATED px."""
    sigma = CORRELATED / 2  # Gaussian means of white noise correlate by exp(-(d / 2 sigma)^2)
    weights = np.exp(-0.5 * (np.minimum(np.arange(count), count - np.arange(count)) / sigma) ** 2)
    values = np.fft.irfft(np.fft.rfft(random.standard_normal(count)) * np.fft.rfft(weights), count)
    values -= values.mean()
    return values / np.sqrt((values ** 2).mean())
