"""What the command's tests share: a small body with one limb, strokes over it, and the running of the program."""
import hashlib
import os
import pathlib
import struct
import subprocess

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkMassProperties
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

COMMAND = os.environ["OVERSKETCH_COMMAND"]
SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
WIDTH, HEIGHT, PIXELS = 400, 300, 70.0
QUICK = ["--backend", "embree", "--remesh", "off"]


def run(*arguments, timeout=120, **more):
    done = subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=timeout, **more)
    assert done.returncode in (0, 1, 2), (done.returncode, done.stderr)
    return done


def refuse(code, *arguments, **more):
    """Runs; the program must end with this code and exactly one message, which is returned."""
    done = run(*arguments, **more)
    lines = done.stderr.splitlines()
    assert done.returncode == code, (done.returncode, done.stderr)
    assert len(lines) == 1 and lines[0].startswith("oversketch: "), done.stderr
    assert done.stdout == ""
    return lines[0]


def radius(angle, limb):
    return 0.8 + limb * numpy.exp(-((angle / 0.32) ** 2))


def body(limb=1.4, around=48, along=64):
    """A sphere with one limb along +x: polydata with texture coordinates and colours, closed."""
    points = [(radius(0.0, limb), 0.0, 0.0)]
    for i in range(1, along):
        angle = numpy.pi * (i / along) ** 1.3
        r = radius(angle, limb)
        for k in range(around):
            turn = 2 * numpy.pi * (k + 0.5 * (i % 2)) / around
            points.append((r * numpy.cos(angle), r * numpy.sin(angle) * numpy.cos(turn),
                           r * numpy.sin(angle) * numpy.sin(turn)))
    points.append((-radius(numpy.pi, limb), 0.0, 0.0))
    ring = lambda i, k: 1 + (i - 1) * around + k % around
    triangles = []
    for k in range(around):
        triangles.append((0, ring(1, k), ring(1, k + 1)))
        triangles.append((len(points) - 1, ring(along - 1, k + 1), ring(along - 1, k)))
        for i in range(1, along - 1):
            a, b, c, d = ring(i, k), ring(i, k + 1), ring(i + 1, k), ring(i + 1, k + 1)
            triangles += [(a, c, b), (b, c, d)] if i % 2 == 0 else [(a, c, d), (a, d, b)]
    points = numpy.array(points)
    mesh = polydata(points, numpy.array(triangles))
    unit = points / numpy.linalg.norm(points, axis=1)[:, None]
    textures = numpy_to_vtk((0.5 + 0.5 * unit[:, :2]).astype(numpy.float32), deep=True)
    textures.SetName("TCoords")
    mesh.GetPointData().SetTCoords(textures)
    colours = numpy_to_vtk((127 + 127 * unit).astype(numpy.uint8), deep=True)
    colours.SetName("RGB")
    mesh.GetPointData().SetScalars(colours)
    return mesh


def polydata(points, triangles):
    mesh = vtkPolyData()
    vertices = vtkPoints()
    vertices.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=float), deep=True))
    mesh.SetPoints(vertices)
    cells = vtkCellArray()
    for triangle in triangles:
        cells.InsertNextCell(3, [int(v) for v in triangle])
    mesh.SetPolys(cells)
    return mesh


def outline(limb, half_angle=0.55, count=160):
    """The body's outline round its limb, seen along -z, in pixels."""
    angle = numpy.linspace(-half_angle, half_angle, count)
    r = radius(angle, limb)
    return numpy.stack([WIDTH / 3 + PIXELS * r * numpy.cos(angle), HEIGHT / 2 + PIXELS * r * numpy.sin(angle)], axis=1)


def stroke(samples, drop=(), views=1):
    """A stroke with its orthographic view along -z; the world origin lies a third from the left."""
    view, projection = numpy.eye(4), numpy.eye(4)
    view[2, 3] = -10.0
    projection[0, 0], projection[1, 1], projection[2, 2] = 2 * PIXELS / WIDTH, 2 * PIXELS / HEIGHT, -0.1
    projection[0, 3] = -1.0 / 3.0
    data = vtkPolyData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    cells = vtkCellArray()
    for _ in range(views):
        cells.InsertNextCell(len(samples))
        for x, y in samples:
            cells.InsertCellPoint(points.InsertNextPoint(x, y, 0.0))
    data.SetPoints(points)
    data.SetLines(cells)
    for name, value in (("ViewTransform", view.ravel()), ("ProjectionTransform", projection.ravel()),
                        ("ViewportSize", numpy.array([WIDTH, HEIGHT], dtype=numpy.int32))):
        if name not in drop:
            rows = numpy.repeat(value[None, :], views, axis=0)
            if views > 1 and name == "ViewTransform":
                rows[1, 3] = 0.5
            array = numpy_to_vtk(rows, deep=True)
            array.SetName(name)
            data.GetCellData().AddArray(array)
    return data


def write(data, path, ascii=False):
    writer = vtkXMLPolyDataWriter()
    if ascii:
        writer.SetDataModeToAscii()
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    assert writer.Write()
    return path


def read(path):
    path = pathlib.Path(path)
    if path.suffix == ".off":
        lines = [line.split() for line in path.read_text().splitlines()]
        assert lines[0][0].endswith("OFF")
        n, f = int(lines[1][0]), int(lines[1][1])
        faces = numpy.array([line[:4] for line in lines[2 + n:2 + n + f]], dtype=int)
        assert (faces[:, 0] == 3).all()
        return polydata(numpy.array([line[:3] for line in lines[2:2 + n]], dtype=float), faces[:, 1:])
    reader = {".vtp": vtkXMLPolyDataReader, ".obj": vtkOBJReader, ".ply": vtkPLYReader, ".stl": vtkSTLReader,
              ".gltf": vtkGLTFReader, ".glb": vtkGLTFReader}[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutputDataObject(0)
    while not data.IsA("vtkPolyData"):
        data = data.GetBlock(0)
    return data


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def triangles_of(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def volume(mesh):
    mass = vtkMassProperties()
    mass.SetInputData(mesh)
    return mass.GetVolume()


def diagonal(mesh):
    points = points_of(mesh)
    return numpy.linalg.norm(points.max(axis=0) - points.min(axis=0))


def digest(mesh):
    """As Applications/Session/README.md has it."""
    data = mesh.GetPoints().GetData()
    bits = struct.pack("i", data.GetDataType()) + vtk_to_numpy(data).tobytes()
    triangles = triangles_of(mesh)
    bits += numpy.column_stack([numpy.full(len(triangles), 3), triangles]).astype(numpy.int64).tobytes()
    return hashlib.md5(bits).hexdigest()


def is_skin(worn, picture):
    """Whether a texture, the bytes of a PNG file, is a picture's, opaque: of its size, with its colours but where they are led on."""
    images = []
    for data in (worn, picture):
        reader = vtkPNGReader()
        reader.SetMemoryBuffer(data)
        reader.SetMemoryBufferLength(len(data))
        reader.Update()
        samples = reader.GetOutput().GetPointData().GetScalars()
        images.append((reader.GetOutput().GetDimensions(), vtk_to_numpy(samples).reshape(samples.GetNumberOfTuples(), -1)))
    (size, one), (asked, other) = images
    return size == asked and one.shape[1] in (1, 3) and (one == other[:, :one.shape[1]]).all(1).mean() > 0.25
