"""Pictures in the colours of the paper's figures: stroke red, silhouette blue, region orange, seen in the stroke's view."""
import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkActor2D,
    vtkCoordinate,
    vtkLight,
    vtkPolyDataMapper,
    vtkPolyDataMapper2D,
    vtkRenderer,
    vtkRenderWindow,
)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the rendering backend)

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Applications" / "Examples"))
from sheet import View, by_value, lines_of, rope, shown_in as image, snapped  # noqa: E402, F401

STROKE, SILHOUETTE, REGION, CLAY = (0.86, 0.13, 0.12), (0.10, 0.28, 0.80), (0.98, 0.62, 0.20), (0.80, 0.80, 0.82)


def surface(mesh, colour=CLAY):
    """The mesh as clay, smooth-shaded."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SplittingOff()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*colour)
    look.SetAmbient(0.12)
    look.SetDiffuse(0.85)
    look.SetSpecular(0.08)
    look.SetSpecularPower(20)
    return actor


def coloured(mesh, array, low, high, table):
    """The mesh in the colours of a point array."""
    actor = surface(mesh)
    mapper = actor.GetMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(array)
    mapper.SetScalarRange(low, high)
    mapper.SetLookupTable(table)
    mapper.SetColorModeToMapScalars()
    mapper.SetInterpolateScalarsBeforeMapping(True)
    mapper.ScalarVisibilityOn()
    return actor


def thickness_colours():
    """Thin is dark blue, thick is pale yellow."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i, rgb in enumerate(by_value(np.linspace(0.0, 1.0, 256))):
        table.SetTableValue(i, *rgb, 1.0)
    return table


def region_colours():
    table = vtkLookupTable()
    table.SetNumberOfTableValues(2)
    table.SetTableValue(0, *CLAY, 1.0)
    table.SetTableValue(1, *REGION, 1.0)
    return table


def pen(stroke, colour=STROKE, width=4.0):
    """A stroke, in display coordinates, over everything."""
    flat = vtkPolyData()
    flat.SetPoints(stroke.GetPoints())
    flat.SetLines(stroke.GetLines())
    mapper = vtkPolyDataMapper2D()
    mapper.SetInputData(flat)
    place = vtkCoordinate()
    place.SetCoordinateSystemToViewport()
    mapper.SetTransformCoordinate(place)
    actor = vtkActor2D()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetLineWidth(width)
    return actor


def projected(curves, view, colour=SILHOUETTE, width=4.0):
    """World-space curves, drawn over everything where the view shows them."""
    points, lines = vtkPoints(), vtkCellArray()
    if curves.GetNumberOfPoints():
        for x, y in view.pixels(vtk_to_numpy(curves.GetPoints().GetData())):
            points.InsertNextPoint(x, y, 0.0)
        visible = curves.GetCellData().GetArray("Visible")
        for cell in range(curves.GetNumberOfCells()):
            if visible is None or visible.GetComponent(cell, 0):
                lines.InsertNextCell(curves.GetCell(cell).GetPointIds())
    flat = vtkPolyData()
    flat.SetPoints(points)
    flat.SetLines(lines)
    return pen(flat, colour, width)


def window(view, actors, actors2d=(), samples=0):
    """A rendered window; samples 0, no antialiasing, for pictures that are compared."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for actor in actors:
        renderer.AddActor(actor)
    for actor in actors2d:
        renderer.AddActor2D(actor)
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOff()
    for position, strength in (((-0.6, 0.9, 1.0), 0.85), ((0.9, 0.2, 0.8), 0.30), ((0.0, -1.0, 0.3), 0.12)):
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*position)
        light.SetFocalPoint(0, 0, 0)
        light.SetIntensity(strength)
        renderer.AddLight(light)
    result = vtkRenderWindow()
    result.SetOffScreenRendering(1)
    result.SetMultiSamples(samples)
    result.SetSize(*(int(length) for length in view.size))
    result.AddRenderer(renderer)
    view.aim(renderer)
    result.Render()
    return result


def silhouette_scene(system, stroke):
    view = View(stroke)
    mesh = system.GetInputDataObject(0, 0)
    return window(view, [surface(mesh)], [projected(system.GetInnerOutput("Visibility"), view), pen(stroke)])


def thickness_scene(system, stroke):
    system.GetStep("ShapeDiameter").OnDemandOff()  # a stroke asks for a part of it
    system.Update()
    mesh = system.GetInnerOutput("ShapeDiameter")
    values = vtk_to_numpy(mesh.GetPointData().GetArray("ShapeDiameter"))
    low, high = np.percentile(values, [2, 98])
    return window(View(stroke), [coloured(mesh, "ShapeDiameter", low, high, thickness_colours())])


def region_scene(system, stroke):
    view = View(stroke)
    mesh = system.GetInnerOutput("RegionBorder")
    return window(
        view,
        [coloured(mesh, "Region", 0, 1, region_colours())],
        [projected(system.GetInnerOutput("Match"), view), pen(stroke)],
    )


def result_scene(system, stroke):
    return window(View(stroke), [surface(system.GetOutput())], [pen(stroke, width=2.0)])


SCENES = {
    "silhouette": silhouette_scene,
    "thickness": thickness_scene,
    "region": region_scene,
    "result": result_scene,
}


def generations(mesh):
    """The triangles of a 4-8 mesh, unlit, by their generation: dark for those of the base."""
    colours = by_value(np.minimum(vtk_to_numpy(mesh.GetCellData().GetArray("StellarGen")) / 8.0, 1.0))
    shown = vtkPolyData()
    shown.SetPoints(mesh.GetPoints())
    shown.SetPolys(mesh.GetPolys())
    shown.GetCellData().SetScalars(numpy_to_vtk((255 * colours).round().astype(np.uint8), deep=True))
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(shown)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def thin(mesh):
    return 0.0015 * mesh.GetLength()


def curve_scene(system, view):
    mesh = system.GetInputDataObject(0, 0)
    return window(view, [surface(mesh), *rope(lines_of(system.GetInnerOutput("Curves")), STROKE, thin(mesh))])


def refined_scene(system, view):
    mesh = system.GetInnerOutput("Refine")
    return window(view, [generations(mesh)])


def snapped_scene(system, view):
    mesh = system.GetInnerOutput("Snap")
    return window(view, [generations(mesh), *rope(snapped(mesh), SILHOUETTE, 0.5 * thin(mesh))])


def raised_scene(system, view):
    mesh = system.GetOutput()
    return window(view, [coloured(mesh, "Feature", 0.0, 1.0, feature_colours())])


def feature_colours():
    """From clay to orange by the share of the height."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i, share in enumerate(np.linspace(0.0, 1.0, 256)):
        table.SetTableValue(i, *((1.0 - share) * np.array(CLAY) + share * np.array(REGION)), 1.0)
    return table


AUGMENT_SCENES = {
    "curve": curve_scene,
    "refined": refined_scene,
    "snapped": snapped_scene,
    "raised": raised_scene,
}
