"""What the scripts that run inside ParaView share: the plugin, shipped models and strokes. No test of its own."""
import os
import pathlib

from paraview import simple

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


def fetched(source):
    """The result of a pipeline, on this side."""
    from paraview import servermanager

    source.UpdatePipeline()
    return servermanager.Fetch(source)
