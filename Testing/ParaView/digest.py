"""The digest of a mesh, in any Python with VTK. No test of its own."""
import hashlib

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy


def digest(mesh):
    """Points and polygons, bit for bit."""
    sums = hashlib.md5(vtk_to_numpy(mesh.GetPoints().GetData()).tobytes())
    sums.update(vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).astype(numpy.int64).tobytes())
    return sums.hexdigest()
