"""The limbed models of the acceptance run: where they are, and reading them to vtkPolyData and numpy arrays."""
import os
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

SOURCE = Path(os.environ.get("OVERSKETCH_SOURCE", Path(__file__).resolve().parents[2]))
DATA = SOURCE / "Data"
sys.path.insert(0, str(DATA))
import listing  # noqa: E402

SHARED = Path(os.environ.get("OVERSKETCH_DATA", SOURCE.parent / "shared" / "data"))

# Limbed models of the shared data, each with the axis (and sign) that points up in its file.
SHARED_MODELS = {
    "spot_5k9.obj": "+y", "spot_1k6.off": "+y", "spot_uv.obj": "+y", "armadillo_29k.obj": "+y", "man.ply": "+y",
    "human_parts_uv.obj": "+y", "cat.off": "+y", "cow_nc.stl": "+y", "koala.stl": "+y", "scorpion.ply": "+y",
    "penguin.obj": "+y", "hand_closed.obj": "+y", "hand_open_wrist.off": "+y", "bunny_5k.obj": "+y",
    "bunny_30k.ply": "+y", "fish_uv.obj": "+y", "capsule_figure.obj": "+z",
}

# The capsules that capsule_figure.obj is the union of: part, from, to, radius.
CAPSULES = (
    ("trunk", (0, 0, 0), (0, 0, 1.2), 0.4),
    ("head", (0, 0, 1.75), (0, 0, 1.95), 0.28),
    ("neck", (0, 0, 1.4), (0, 0, 1.75), 0.12),
    ("arm +x", (0.3, 0, 1.25), (1.35, 0, 1.25), 0.11),
    ("arm -x", (-0.3, 0, 1.25), (-1.35, 0, 1.25), 0.11),
    ("leg +x", (0.22, 0, -0.1), (0.22, 0, -1.5), 0.16),
    ("leg -x", (-0.22, 0, -0.1), (-0.22, 0, -1.5), 0.16),
    ("tail", (0, -0.3, -0.1), (0, -1.3, -0.45), 0.06),
)


def models():
    """(name, path, up) of every model that is here: the shipped ones with strokes, then the shared ones."""
    drawn = {name.split("_")[0] for name in listing.ONE_STROKE}
    found = [(path.stem, path, "+y") for path in sorted((DATA / "Models").glob("*.ply")) if path.stem in drawn]
    folder = SHARED / "meshes"
    found += [(Path(name).stem, folder / name, up) for name, up in SHARED_MODELS.items() if (folder / name).is_file()]
    return found


def read(path):
    """A mesh file as vtkPolyData, exactly as VTK's reader gives it (OFF, which VTK 9.1 cannot read, by hand)."""
    path = Path(path)
    if path.suffix == ".off":
        return _read_off(path)
    reader = {".obj": vtkOBJReader, ".ply": vtkPLYReader, ".stl": vtkSTLReader, ".vtp": vtkXMLPolyDataReader}[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    mesh = reader.GetOutput()
    if mesh.GetNumberOfPoints() == 0:
        raise RuntimeError(f"{path}: no points could be read")
    return mesh


def _read_off(path):
    words = path.read_text().split("OFF", 1)[1]
    numbers = " ".join(line.split("#")[0] for line in words.splitlines()).split()
    vertices, faces = int(numbers[0]), int(numbers[1])
    points = np.array(numbers[3:3 + 3 * vertices], dtype=float).reshape(-1, 3)
    triangles, at = [], 3 + 3 * vertices
    for _ in range(faces):
        corners = int(numbers[at])
        if corners != 3:
            raise RuntimeError(f"{path}: a face has {corners} corners, only triangles are taken")
        triangles.append([int(n) for n in numbers[at + 1:at + 4]])
        at += 4
    return to_polydata(points, np.array(triangles))


def to_polydata(points, triangles):
    mesh, vtk_points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    vtk_points.SetData(numpy_to_vtk(np.array(points, float).reshape(-1, 3), deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.array(triangles, np.int64).ravel(), deep=True))
    mesh.SetPoints(vtk_points)
    mesh.SetPolys(cells)
    return mesh


def arrays(mesh):
    """Points (n, 3) as double and triangles (m, 3) of a vtkPolyData."""
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    offsets = vtk_to_numpy(mesh.GetPolys().GetOffsetsArray())
    if np.any(np.diff(offsets) != 3):
        raise RuntimeError("the mesh has cells that are not triangles")
    return points, vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).astype(np.int64).reshape(-1, 3)


def distinct(rows):
    """Rows that differ, in lexicographic order, and of each row its number among them; -0 equals 0. As np.unique(axis=0), which takes
    five times as long."""
    order = np.lexsort(rows.T[::-1])
    rows, number, new = rows[order], np.empty(len(rows), int), np.ones(len(rows), bool)
    new[1:] = (rows[1:] != rows[:-1]).any(1)
    number[order] = np.cumsum(new) - 1
    return rows[new], number


def among(rows, others):
    """Which rows are, bit for bit, among others; -0 equals 0."""
    _, number = distinct(np.vstack([rows, others]))
    return np.isin(number[:len(rows)], number[len(rows):])


def weld(points, triangles):
    """The same surface with points of equal coordinates made one: (points, triangles, new id of each old point)."""
    different, index = distinct(points)
    return different + 0.0, index[triangles], index


def edges_of(triangles):
    """Every undirected edge once, how many triangles use it, and per triangle corner k the row of edge (k, k + 1)."""
    pairs = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    pairs.sort(axis=1)
    key = pairs[:, 0] * (int(triangles.max()) + 1) + pairs[:, 1]
    _, first, inverse, count = np.unique(key, return_index=True, return_inverse=True, return_counts=True)
    return pairs[first], count, inverse.reshape(-1, 3)
