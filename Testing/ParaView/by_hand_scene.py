"""Run by ParaView's window at its start: opens the dog, then tells in a file what there is, whenever the view was drawn or something
was applied.

usage: paraview --script=by_hand_scene.py, with OVERSKETCH_STATE naming the file"""
import json
import os
import pathlib

from digest import digest
from hosts import DATA
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

STATE = pathlib.Path(os.environ["OVERSKETCH_STATE"])
FEW = 1000  # points; more are told by their digest only


def values(matrix):
    return [matrix.GetElement(i, j) for i in range(4) for j in range(4)]


def told(mesh):
    few = mesh.GetNumberOfPoints() < FEW
    cells = mesh.GetCellData()
    arrays = [cells.GetArray(i) for i in range(cells.GetNumberOfArrays())] if few else []
    return {
        "points": vtk_to_numpy(mesh.GetPoints().GetData()).tolist() if few else [],
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
        if output and output.GetNumberOfPoints():
            state["sources"][name] = told(output)
    part = STATE.with_suffix(".part")
    part.write_text(json.dumps(state))
    part.replace(STATE)


writing = False
view = simple.GetActiveViewOrCreate("RenderView")
simple.Show(simple.PLYReader(registrationName="dog", FileNames=[str(DATA / "Models" / "dog.ply")]), view)
view.SMProxy.AddObserver("EndEvent", write)
servermanager.ProxyManager().SMProxyManager.AddObserver("UpdateInformationEvent", write)
simple.ResetCamera(view)
simple.Render(view)
