"""stroke(points, camera, size): a stroke of an array; strokes(parts): several as one; drawing(lines, image): those over a picture."""
from __future__ import annotations

import collections.abc
from typing import Any

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData

__all__ = ["drawing", "stroke", "strokes"]


def stroke(points: Any, camera: Any, size: collections.abc.Sequence[int]) -> vtkPolyData:
    """The stroke through these points, drawn over what this camera shows.

    points: array of shape (n, 2), n >= 2, in pixels from the lower left corner of the viewport, y up.
    camera: vtkCamera (PyVista: plotter.camera).
    size: width and height of the viewport in pixels (PyVista: plotter.window_size).

    Returns one polyline with the cell arrays ViewTransform, ProjectionTransform (16 values each, row-major) and ViewportSize,
    as the filters take it. Raises ValueError for points of another shape.
    """
    places = _places(points, "points")
    width, height = _size(size)
    view, projection = camera.GetViewTransformMatrix(), camera.GetProjectionTransformMatrix(width / height, -1.0, 1.0)
    result = _polylines([places], [False])
    _add_view(result, _rows(view), _rows(projection), (width, height))
    return result


def drawing(lines: collections.abc.Iterable[Any], image: Any,
            closed: bool | collections.abc.Iterable[bool | None] | None = None,
            depth: collections.abc.Iterable[int] | None = None, height: collections.abc.Iterable[float] | None = None,
            cross_section: collections.abc.Iterable[int] | None = None) -> vtkPolyData:
    """The strokes of a drawing over a picture, as vtkOversketchCanvas and what follows it take them.

    lines: arrays of shape (n, 2), n >= 2, one for each stroke, in pixels of the picture from its lower left corner, y up: the
    middle of the first pixel is at (0.5, 0.5).
    image: vtkImageData of one slice (PyVista: ImageData), or width and height of a picture whose first pixel's middle is the
    world's origin and whose pixels are one unit wide.
    closed: of all strokes, or of each, whether it is closed; None where that is for its ends to tell, which close it when they
    are at most 0.02 of the picture's longest side apart.
    depth, height, cross_section: of each stroke cell array Depth, Height, CrossSection (see vtkOversketchInflateDrawing).

    Returns one polyline for each stroke, a closed one with its first point id repeated at the end, with the cell arrays of the
    view (see stroke), which looks at the picture from above and shows exactly that, and the field array Canvas, the picture's
    rectangle. Raises ValueError for lines or pictures that are none, and for values that are not of each line.
    """
    import numpy

    places = [_places(line, f"line {number}") for number, line in enumerate(lines)]
    if not places:
        raise ValueError("there is no line to draw")
    each = [closed] * len(places) if closed is None or isinstance(closed, bool) else list(closed)
    if len(each) != len(places):
        raise ValueError(f"closed must say of each of {len(places)} lines, not of {len(each)}, whether it is closed")
    (x, y), (across, up), pixels = _rectangle(image)
    view, projection = numpy.identity(4), numpy.identity(4)
    view[:3, 3] = -(x + across / 2), -(y + up / 2), -1.0
    projection[range(3), range(3)] = 2.0 / across, 2.0 / up, -1.0
    result = _polylines(places, [said is True for said in each])
    _add_view(result, numpy.tile(view.reshape(1, 16), (len(places), 1)), numpy.tile(projection.reshape(1, 16), (len(places), 1)),
              pixels)
    if closed is not None:
        _add(result.GetCellData(), "Closed", numpy.array([-1 if said is None else int(said) for said in each], dtype=numpy.intc))
    for name, values, kind in (("Depth", depth, numpy.intc), ("Height", height, float), ("CrossSection", cross_section, numpy.intc)):
        if values is not None:
            given = numpy.array(list(values), dtype=kind)
            if given.shape != (len(places),):
                raise ValueError(f"{name} must be one number of each of {len(places)} lines, not {given.shape}")
            _add(result.GetCellData(), name, given)
    _add(result.GetFieldData(), "Canvas", numpy.array([[x, y, across, up]], dtype=float))
    return result


def _places(points: Any, name: str) -> Any:
    import numpy

    places = numpy.asarray(points, dtype=float)
    if places.ndim != 2 or places.shape[1] != 2 or len(places) < 2:
        raise ValueError(f"{name} must have shape (n, 2) with n >= 2, not {places.shape}")
    return places


def _size(size: collections.abc.Sequence[int]) -> tuple[int, int]:
    width, height = (int(length) for length in size)
    if width < 1 or height < 1:
        raise ValueError(f"size must be two positive numbers of pixels, not {width} x {height}")
    return width, height


def _rectangle(image: Any) -> Any:
    """Lower left corner and size in the world, and size in pixels, of a picture or of what only its size is known of."""
    if not isinstance(image, vtkImageData):
        width, height = _size(image)
        return (-0.5, -0.5), (float(width), float(height)), (width, height)
    columns, rows, slices = image.GetDimensions()
    spacing, origin, extent = image.GetSpacing(), image.GetOrigin(), image.GetExtent()
    if image.GetNumberOfPoints() == 0 or slices > 1:
        raise ValueError(f"the picture must be one slice across z, not {columns} x {rows} x {slices} samples")
    if spacing[0] <= 0.0 or spacing[1] <= 0.0 or not image.GetDirectionMatrix().IsIdentity():
        raise ValueError("the picture's spacing must be positive and its direction matrix the identity; resample it along the axes")
    corner = tuple(origin[k] + (extent[2 * k] - 0.5) * spacing[k] for k in range(2))
    return corner, (columns * spacing[0], rows * spacing[1]), (columns, rows)


def _polylines(lines: Any, closed: collections.abc.Sequence[bool]) -> vtkPolyData:
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk

    places = numpy.concatenate(lines)
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(numpy.column_stack([places, numpy.zeros(len(places))]), deep=True))
    cells = vtkCellArray()
    first = 0
    for line, ring in zip(lines, closed):
        ids = [*range(first, first + len(line)), *([first] if ring else [])]
        cells.InsertNextCell(len(ids), ids)
        first += len(line)
    result = vtkPolyData()
    result.SetPoints(coordinates)
    result.SetLines(cells)
    return result


def _add(data: Any, name: str, values: Any) -> None:
    from vtkmodules.util.numpy_support import numpy_to_vtk

    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.AddArray(array)


def _rows(matrix: Any) -> Any:
    import numpy

    return numpy.array([[matrix.GetElement(row, column) for row in range(4) for column in range(4)]])


def _add_view(strokes: vtkPolyData, view: Any, projection: Any, size: tuple[int, int]) -> None:
    import numpy

    sizes = numpy.tile(numpy.array([size], dtype=numpy.intc), (len(view), 1))
    for name, values in (("ViewTransform", view), ("ProjectionTransform", projection), ("ViewportSize", sizes)):
        _add(strokes.GetCellData(), name, values)


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
