"""show(mesh): the page of oversketch-web in a notebook's cell."""
from __future__ import annotations

import atexit
import importlib
import pathlib
import shutil
import subprocess
import sys
import tempfile
from typing import Any

from vtkmodules.vtkCommonDataModel import vtkPolyData

__all__ = ["show"]


def show(mesh: vtkPolyData, height: int = 600) -> Any:
    """The page of oversketch-web on this mesh, for a notebook's cell: draw on it, undo, save, export.

    mesh: vtkPolyData (PyVista: any PolyData); a copy is drawn on. height: of the cell [px].

    Returns an IPython.display.IFrame. Its server is this machine's own, and ends with this Python. Raises RuntimeError, in its
    words, where it does not start; it needs oversketch-web, which the Debian package has and the wheel has not.
    """
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

    folder = pathlib.Path(tempfile.mkdtemp(prefix="oversketch-show-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(folder / "mesh.vtp"))
    writer.SetInputData(mesh)
    writer.Write()
    server = subprocess.Popen([sys.executable, "-m", "oversketch_web", "--port", "0", str(folder / "mesh.vtp")],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert server.stdout is not None and server.stderr is not None
    link = server.stdout.readline().strip()
    if not link:
        raise RuntimeError(server.stderr.read().strip())
    atexit.register(server.terminate)
    return importlib.import_module("IPython.display").IFrame(link, "100%", height)
