"""Run by ParaView's window at its start: opens a model or a picture, then tells in a file what there is, whenever the view was drawn or
something was applied.

usage: paraview --script=by_hand_scene.py, with OVERSKETCH_STATE naming the file and OVERSKETCH_OPEN what is opened"""
import json
import os
import pathlib

from digest import digest
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

STATE = pathlib.Path(os.environ["OVERSKETCH_STATE"])
OPENED = pathlib.Path(os.environ["OVERSKETCH_OPEN"])
FEW = 1000  # points; more are told by their digest only


def values(matrix):
    return [matrix.GetElement(i, j) for i in range(4) for j in range(4)]


def told(mesh):
    few = mesh.GetNumberOfPoints() < FEW
    cells, lines = mesh.GetCellData(), mesh.GetLines()
    arrays = [cells.GetArray(i) for i in range(cells.GetNumberOfArrays())] if few else []
    return {
        "points": vtk_to_numpy(mesh.GetPoints().GetData()).tolist() if few else [],
        "counts": [lines.GetCellSize(i) for i in range(lines.GetNumberOfCells())],  # points of each line
        "arrays": {array.GetName(): vtk_to_numpy(array).ravel().tolist() for array in arrays},
        "bounds": mesh.GetBounds(),
        "digest": digest(mesh),
    }


def write(*_):
    global writing
    if not writing:  # what is asked below is an event, too
        writing = True
        tell()
        writing = False


def tell():
    camera, (width, height) = view.GetActiveCamera(), view.ViewSize
    state = {
        "ViewTransform": values(camera.GetViewTransformMatrix()),
        "ProjectionTransform": values(camera.GetProjectionTransformMatrix(width / height, -1, 1)),
        "ViewportSize": [width, height],
        "active": "",
        "sources": {},
    }
    for (name, _), proxy in simple.GetSources().items():
        if proxy == simple.GetActiveSource():
            state["active"] = name
        if name.startswith("OversketchViewStroke") and list(proxy.CameraPosition) != [0.0, 0.0, 1.0]:
            proxy.UpdatePipeline()  # it is not shown, so nobody else asks for it
        output = proxy.SMProxy.GetClientSideObject().GetOutputDataObject(0)
        if isinstance(output, vtkPolyData) and output.GetNumberOfPoints():
            state["sources"][name] = told(output)
    part = STATE.with_suffix(".part")
    part.write_text(json.dumps(state))
    part.replace(STATE)


writing = False
view = simple.GetActiveViewOrCreate("RenderView")
reader = simple.PLYReader if OPENED.suffix == ".ply" else simple.PNGSeriesReader
shown = simple.Show(reader(registrationName=OPENED.stem, FileNames=[str(OPENED)]), view)
if OPENED.suffix == ".png":  # its own colours, and a mouse that does not turn it
    shown.MapScalars = 0
    view.InteractionMode = "2D"
view.SMProxy.AddObserver("EndEvent", write)
servermanager.ProxyManager().SMProxyManager.AddObserver("UpdateInformationEvent", write)
simple.ResetCamera(view)
simple.Render(view)
