"""Lines of the page as strokes of a session, and back: their pixels, the view that these are of, and places on the model."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkIdList
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

import oversketch

samples = 80  # of a line that is shown on the model
views = ("ViewTransform", "ProjectionTransform", "ViewportSize")


def add(data, name, values, kind):
    array = numpy_to_vtk(numpy.asarray(values, dtype=kind), deep=True)
    array.SetName(name)
    data.AddArray(array)


def numbers(points, each):
    """The points that a page has sent. Raises ValueError for what are none."""
    given = numpy.asarray(points, dtype=float)
    if given.ndim != 2 or given.shape[1] != each or not numpy.isfinite(given).all():
        raise ValueError(f"A line's points must be {each} numbers each.")
    given = given[numpy.append(True, numpy.abs(numpy.diff(given[:, :2], axis=0)).sum(axis=1) > 0.0)]
    if len(given) < 2:
        raise ValueError("The line is a point; draw a longer one.")
    return given


def stroke(points, view):
    """A stroke of x and y in pixels of the canvas, from its upper left corner, and the pen's pressure."""
    given = numbers(points, 3)
    line = oversketch.stroke(numpy.column_stack(view.place(given[:, 0], given[:, 1])), view.camera, view.size)
    add(line.GetPointData(), "Pressure", given[:, 2].clip(0.0, 1.0), numpy.float32)
    return line


class Eye:
    """How a polyline's pixels lie in the world."""

    def __init__(self, lines, cell=0):
        view, projection, self.size = (vtk_to_numpy(lines.GetCellData().GetArray(name))[cell].astype(float) for name in views)
        self.matrix = projection.reshape(4, 4) @ view.reshape(4, 4)

    @classmethod
    def of(cls, view):
        return cls(oversketch.stroke([(0, 0), (1, 1)], view.camera, view.size))

    def world(self, pixels, depth):
        """The places under pixels at a depth, from -1 near to 1 far."""
        across = 2.0 * numpy.asarray(pixels, dtype=float)[:, :2] / self.size - 1.0
        full = numpy.column_stack([across, numpy.broadcast_to(depth, len(across)), numpy.ones(len(across))])
        places = full @ numpy.linalg.inv(self.matrix).T
        return places[:, :3] / places[:, 3:]

    def seen(self, places):
        """Pixels, and the depth, of places."""
        full = numpy.column_stack([places, numpy.ones(len(places))]) @ self.matrix.T
        full = full[:, :3] / full[:, 3:]
        return numpy.column_stack([0.5 * (full[:, :2] + 1.0) * self.size, full[:, 2]])


def polylines(lines):
    """The points of each polyline."""
    ids, result = vtkIdList(), []
    for cell in range(lines.GetNumberOfCells()):
        lines.GetCellPoints(cell, ids)
        result.append(numpy.array([lines.GetPoint(ids.GetId(k)) for k in range(ids.GetNumberOfIds())]))
    return result


def isDrawn(lines):
    return lines is not None and lines.GetCellData().HasArray(views[0])


def laid(lines, mesh, by=(0.0, 0.0)):
    """Places of strokes on the model, moved by so many pixels; beside it as deep as it is where they are next to it."""
    locator, result = vtkStaticCellLocator(), []
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    t, x, inner, sub = reference(0.0), [0.0] * 3, [0.0] * 3, reference(0)
    for cell, pixels in enumerate(polylines(lines)):
        pixels = pixels[numpy.unique(numpy.linspace(0, len(pixels) - 1, samples).round().astype(int)), :2] + by
        eye = Eye(lines, cell)
        depths = numpy.full(len(pixels), numpy.nan)
        # From next to the eye on: a view's near plane may cut the model, as that of the window's strokes does.
        for k, (near, far) in enumerate(zip(eye.world(pixels, -1e3), eye.world(pixels, 1.0))):
            if locator.IntersectWithLine(near, far, 0.0, t, x, inner, sub):
                depths[k] = eye.seen([x])[0, 2]
        hit = numpy.flatnonzero(~numpy.isnan(depths))
        depths = numpy.interp(numpy.arange(len(depths)), hit, depths[hit]) if len(hit) else eye.seen([mesh.GetCenter()])[0, 2]
        result.append(eye.world(pixels, depths))
    return result


def dragged(lines, place, start, end, view):
    """How far a drag over the present view takes a place, in pixels of the stroke's own view."""
    here, own = Eye.of(view), Eye(lines)
    before, after = own.seen(here.world([view.place(*start), view.place(*end)], here.seen([place])[0, 2]))[:, :2]
    return after - before


def drawing(points, canvas, pixels, magnetic):
    """A line over a picture or a canvas: shares of its width and height from the upper left corner."""
    given = numbers(points, 3)
    x, y, width, height = canvas
    line = oversketch.drawing([numpy.column_stack([given[:, 0], 1.0 - given[:, 1]]) * pixels], pixels)
    view, projection = (vtk_to_numpy(line.GetCellData().GetArray(name)) for name in views[:2])
    view[0, [3, 7]] = -(x + width / 2.0), -(y + height / 2.0)  # wherever it lies, and however large it is
    projection[0, [0, 5]] = 2.0 / width, 2.0 / height
    for name, value, kind in (("Magnetic", magnetic, numpy.intc), ("SnapRadius", 10.0, float), ("Treatment", 0, numpy.intc)):
        add(line.GetCellData(), name, [value], kind)
    add(line.GetPointData(), "Pressure", numpy.ones(len(given)), numpy.float32)
    return line


def drawn(lines, canvas):
    """A drawing's lines as shares of its canvas from the upper left corner."""
    x, y, width, height = canvas
    result = []
    for cell, pixels in enumerate(polylines(lines)):
        near, far = (Eye(lines, cell).world(pixels, depth) for depth in (-1.0, 1.0))
        places = near + near[:, 2:] / (near[:, 2:] - far[:, 2:]) * (far - near)  # on z = 0
        result.append(numpy.column_stack([(places[:, 0] - x) / width, 1.0 - (places[:, 1] - y) / height]).round(5).tolist())
    return result
