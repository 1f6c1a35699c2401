"""What the scripts that run inside ParaView share: the plugin, shipped models and strokes, a digest of a mesh. No test of its own."""
import hashlib
import os
import pathlib

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
PLUGIN = os.environ["OVERSKETCH_PLUGIN"]


def load_plugin(scope, remote=False):
    """Loads the plugin here and, where there is one, on the server; its functions go into scope (globals())."""
    if remote:
        simple.LoadPlugin(PLUGIN, remote=True, ns=scope)
    simple.LoadPlugin(PLUGIN, remote=False, ns=scope)


def model(name):
    return simple.PLYReader(FileNames=[str(DATA / "Models" / f"{name}.ply")])


def stroke(name):
    return simple.XMLPolyDataReader(FileName=[str(DATA / "Strokes" / f"{name}.vtp")])


def digest(mesh):
    """Points and polygons, bit for bit."""
    sums = hashlib.md5(vtk_to_numpy(mesh.GetPoints().GetData()).tobytes())
    sums.update(vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).astype(numpy.int64).tobytes())
    return sums.hexdigest()


def fetched(source):
    """The result of a pipeline, on this side."""
    from paraview import servermanager

    source.UpdatePipeline()
    return servermanager.Fetch(source)
