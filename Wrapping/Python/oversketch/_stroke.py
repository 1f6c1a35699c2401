"""stroke(points, camera, size): a stroke of an array; strokes(parts): several as one."""
from __future__ import annotations

import collections.abc
from typing import Any

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

__all__ = ["stroke", "strokes"]


def stroke(points: Any, camera: Any, size: collections.abc.Sequence[int]) -> vtkPolyData:
    """The stroke through these points, drawn over what this camera shows.

    points: array of shape (n, 2), n >= 2, in pixels from the lower left corner of the viewport, y up.
    camera: vtkCamera (PyVista: plotter.camera).
    size: width and height of the viewport in pixels (PyVista: plotter.window_size).

    Returns one polyline with the cell arrays ViewTransform, ProjectionTransform (16 values each, row-major) and ViewportSize,
    as the filters take it. Raises ValueError for points of another shape.
    """
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk

    places = numpy.asarray(points, dtype=float)
    if places.ndim != 2 or places.shape[1] != 2 or len(places) < 2:
        raise ValueError(f"points must have shape (n, 2) with n >= 2, not {places.shape}")
    width, height = (int(length) for length in size)
    if width < 1 or height < 1:
        raise ValueError(f"size must be two positive numbers of pixels, not {width} x {height}")

    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(numpy.column_stack([places, numpy.zeros(len(places))]), deep=True))
    line = vtkCellArray()
    line.InsertNextCell(len(places), range(len(places)))
    result = vtkPolyData()
    result.SetPoints(coordinates)
    result.SetLines(line)
    view, projection = camera.GetViewTransformMatrix(), camera.GetProjectionTransformMatrix(width / height, -1.0, 1.0)
    for name, values in (("ViewTransform", _rows(view)), ("ProjectionTransform", _rows(projection)),
                         ("ViewportSize", numpy.array([[width, height]], dtype=numpy.intc))):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        result.GetCellData().AddArray(array)
    return result


def _rows(matrix: Any) -> Any:
    import numpy

    return numpy.array([[matrix.GetElement(row, column) for row in range(4) for column in range(4)]])


def strokes(parts: collections.abc.Iterable[vtkPolyData]) -> vtkPolyData:
    """Several strokes as one polydata, for filters that take any number: each keeps its own view.

    Raises ValueError where there is none, or where some have a point or cell array (Radius, Pressure, ...) that others lack.
    """
    from vtkmodules.vtkFiltersCore import vtkAppendPolyData

    given = list(parts)
    if not given:
        raise ValueError("there is no stroke to join")
    for kind in ("Cell", "Point"):
        held = [_names(getattr(part, f"Get{kind}Data")()) for part in given]
        for index, names in enumerate(held):
            if names != held[0]:
                name = sorted(names ^ held[0])[0]
                raise ValueError(f"strokes 0 and {index}: only one has the {kind.lower()} array {name}; give it to all or to none")
    append = vtkAppendPolyData()
    append.SetOutputPointsPrecision(append.DOUBLE_PRECISION)
    for part in given:
        append.AddInputData(part)
    append.Update()
    return append.GetOutput()


def _names(data: Any) -> set[str]:
    return {data.GetArrayName(index) for index in range(data.GetNumberOfArrays())}
