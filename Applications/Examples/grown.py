"""What the examples of augmentation share: grounds to draw on, strokes over a camera, the system's run, colours of its meshes."""
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkImageDataGeometryFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkPolyDataMapper

import oversketch

from sheet import CLAY, DATA, ORANGE, View, drawn

sys.path.insert(0, str(DATA))
from make_augmentations import GRAY, model, rounded  # noqa: E402, F401

SIZE = (800, 600)


def plane(quads, side=1.0):
    """A square in z = 0 about the origin, triangulated."""
    source, triangles = vtkPlaneSource(), vtkTriangleFilter()
    half = 0.5 * side
    source.SetOrigin(-half, -half, 0.0)
    source.SetPoint1(half, -half, 0.0)
    source.SetPoint2(-half, half, 0.0)
    source.SetResolution(quads, quads)
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def heights():
    """The shipped height image."""
    reader = vtkPNGReader()
    reader.SetFileName(str(DATA / "Terrain" / "valley.png"))
    reader.Update()
    return reader.GetOutput()


def plate(image):
    """A height image, lying in z = 0, for a panel; and the view of it."""
    flat, mapper, actor = vtkImageDataGeometryFilter(), vtkPolyDataMapper(), vtkActor()
    flat.SetInputData(image)
    flat.Update()
    shown = flat.GetOutput()
    gray = vtk_to_numpy(shown.GetPointData().GetScalars()) / 65535.0
    shown.GetPointData().SetScalars(numpy_to_vtk((255 * np.repeat(gray[:, None], 3, axis=1)).round().astype(np.uint8), deep=True))
    mapper.SetInputData(shown)
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    middle = 0.5 * np.array(image.GetBounds())[1::2]
    return seen(camera(middle, (0, 0, 1), 2.1 * middle[1])), [actor]


def terrain(columns=64):
    """The shipped height image as a 4-8 mesh of so many quads."""
    result = oversketch.vtkOversketchTerrain()
    result.SetInputData(heights())
    result.SetScale(GRAY)
    result.SetColumns(columns)
    result.Update()
    return result


def camera(focus, towards, height, up=(0, 1, 0)):
    """An orthographic camera that looks at a point from a direction, `height` of the world in the picture."""
    result = vtkCamera()
    result.ParallelProjectionOn()
    result.SetFocalPoint(*focus)
    result.SetPosition(*(np.asarray(focus, float) + 4.0 * height * np.asarray(towards, float) / np.linalg.norm(towards)))
    result.SetViewUp(*up)
    result.SetParallelScale(0.5 * height)
    return result


def seen(by):
    """The view of a camera."""
    return View(oversketch.stroke([(0, 0), (1, 1)], by, SIZE))


def strokes(lines, by, **values):
    """Strokes through points [px], drawn over a camera; values are cell arrays (Radius, Height, Sharpness), one number or one a line."""
    append = vtkAppendPolyData()
    for i, line in enumerate(lines):
        pen = oversketch.stroke(line, by, SIZE)
        for name, value in values.items():
            array = numpy_to_vtk(np.array([value[i] if np.ndim(value) else value], float), deep=True)
            array.SetName(name)
            pen.GetCellData().AddArray(array)
        append.AddInputData(pen)
    append.Update()
    return append.GetOutput()


def augmented(mesh, pens, **parameters):
    """The system, run over a mesh with strokes; parameters are its properties."""
    system = oversketch.vtkOversketchAugment()
    system.SetInputData(0, mesh)
    system.SetInputData(1, pens)
    for name, value in parameters.items():
        getattr(system, "Set" + name)(value)
    oversketch.update(system)
    return system


def shipped(name, **parameters):
    """The system, run over a shipped model or terrain with shipped strokes."""
    first = name.split("_")[0]
    return augmented(terrain().GetOutput() if first == "valley" else model(first), drawn(name).GetOutput(), **parameters)


def by_feature(mesh):
    """Colours of the points: orange where the feature is, the rest clay."""
    share = np.clip(2.0 * vtk_to_numpy(mesh.GetPointData().GetArray("Feature")), 0.0, 1.0)[:, None]
    return (1.0 - share) * np.array(CLAY) + share * np.array(ORANGE)
