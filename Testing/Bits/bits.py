"""The runs whose meshes Testing/Bits keeps, and their digests: what one process makes on one back end.

    bits.py BACKEND [--cold] [--all] [--group NAME]    prints a row of JSON for each run

BACKEND is embree or opencl; threads are set by the environment (see threads()). --cold: every run in a filter of its
own; else one filter a model, which keeps between runs what they share. --all: also the runs that are too many for the
test suite. Testing/Bits/test_bits.py starts this and compares; Testing/Bits/record.py starts it and records.
"""
from __future__ import annotations

import argparse
import functools
import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path
from typing import Any, Dict, Iterator, List, NamedTuple, Tuple

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "Acceptance"), str(HERE.parent / "ParaView")]
import frame  # noqa: E402
import meshes  # noqa: E402  (finds what follows)
import listing  # noqa: E402
import picture  # noqa: E402
import stroke_files  # noqa: E402
import variants  # noqa: E402

BACKENDS = ("embree", "opencl")
GROUPS = ("shipped", "acceptance", "sessions", "each", "lines", "drawings")
SOME = 20  # models of the collection that the test suite runs, and the bad ones
ALL = 200
SHORT = 12  # digits kept of the digests that are nobody else's


class Row(NamedTuple):
    """What a run made: digests of its input, of the mesh, of its arrays, and what can be compared where bits cannot."""

    input: str
    mesh: str  # as result_md5 of a session file
    arrays: str
    points: int
    triangles: int
    bounds: List[float]
    moved: float  # share of the input's points that are gone or elsewhere


# ------------------------------------------------------------------------------------------------------- digests

def digest(mesh: vtkPolyData) -> str:
    """Points and polygons, as digestOf in Applications/Session has it."""
    sums = hashlib.md5()
    if mesh.GetPoints():
        data = mesh.GetPoints().GetData()
        sums.update(np.int32(data.GetDataType()).tobytes() + vtk_to_numpy(data).tobytes())
    if mesh.GetNumberOfPolys():
        starts = vtk_to_numpy(mesh.GetPolys().GetOffsetsArray()).astype(np.int64)
        ids = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).astype(np.int64)
        sums.update(np.insert(ids, starts[:-1], np.diff(starts)).tobytes())  # each polygon's size before its points
    return sums.hexdigest()


def digest_of_arrays(mesh: vtkPolyData) -> str:
    """Arrays of points and of cells, by name."""
    sums = hashlib.md5()
    for data in (mesh.GetPointData(), mesh.GetCellData()):
        arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
        for array in sorted((a for a in arrays if a), key=lambda a: a.GetName()):
            shape = (array.GetName(), array.GetDataType(), array.GetNumberOfComponents(), array.GetNumberOfTuples())
            sums.update(repr(shape).encode() + vtk_to_numpy(array).tobytes())
    return sums.hexdigest()


def row(made: vtkPolyData, mesh: vtkPolyData, drawn: Any) -> Row:
    """drawn: the stroke, or the bytes of what else went in."""
    source = hashlib.md5(digest(mesh).encode())
    source.update(drawn if isinstance(drawn, bytes) else vtk_to_numpy(drawn.GetPoints().GetData()).tobytes())
    bounds, moved = [0.0] * 6, 1.0
    if made.GetNumberOfPoints():
        bounds = [float(f"{b:.6g}") for b in made.GetBounds()]
        before, after = (vtk_to_numpy(m.GetPoints().GetData()).astype(float) for m in (mesh, made))
        moved = round(1.0 - float(meshes.among(before, after).mean()), 4)
    counts = made.GetNumberOfPoints(), made.GetNumberOfPolys()
    return Row(source.hexdigest()[:SHORT], digest(made), digest_of_arrays(made)[:SHORT], *counts, bounds, moved)


# ---------------------------------------------------------------------------------------------------------- runs

def silent(algorithm: Any) -> Any:
    """An algorithm that prints no errors: what it refuses comes out empty, and that has a digest too."""
    for what in (algorithm, algorithm.GetExecutive()):
        what.AddObserver("ErrorEvent", lambda *_: None)
    return algorithm


def system(backend: str) -> Any:
    from oversketch import vtkOversketchOneStroke

    made = silent(vtkOversketchOneStroke())
    (made.SetBackendToHost if backend == "embree" else made.SetBackendToOpenCL)()
    return made


def require(one_stroke: Any, backend: str) -> None:
    """The host stands in where there is no device; that would be compared with itself."""
    used = "opencl" if one_stroke.GetBackendUsed() == one_stroke.OpenCL else "embree"
    if used != backend:
        raise RuntimeError(f"asked for {backend}, ran on {used}")


def drawn_strokes() -> List[Tuple[str, vtkPolyData]]:
    """The strokes of the acceptance run in strokes.vtp, each by itself: model-number-kind, polyline with its view."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(HERE / "strokes.vtp"))
    reader.Update()
    together = reader.GetOutput()
    data, names = together.GetCellData(), together.GetCellData().GetAbstractArray("Name")
    points = vtk_to_numpy(together.GetPoints().GetData())
    starts = vtk_to_numpy(together.GetLines().GetOffsetsArray())
    ids = vtk_to_numpy(together.GetLines().GetConnectivityArray())
    found = []
    for k in range(together.GetNumberOfLines()):
        values = [vtk_to_numpy(data.GetArray(name))[k] for name in stroke_files.VIEW_ARRAYS]
        view = picture.View(values[0].reshape(4, 4), values[1].reshape(4, 4), *values[2])
        found.append((names.GetValue(k), stroke_files.polydata(points[ids[starts[k]:starts[k + 1]], :2], view)))
    return found


def single_strokes(group: str) -> Iterator[Tuple[str, Path, vtkPolyData]]:
    """Name, mesh file and stroke of every run of one stroke."""
    if group == "shipped":
        for path in listing.one_stroke():
            yield path.stem, meshes.DATA / "Models" / f"{path.stem.split('_')[0]}.ply", stroke_files.read(path)[0]
        return
    known = {name: path for name, path, _ in meshes.models()}
    for name, stroke in frame.tenth(drawn_strokes(), frame.DAY):
        model = name.split("-")[0]
        if model in known:
            yield name, known[model], stroke
        else:
            say(f"{name} not run: no model {model} in {meshes.SHARED}")


def run_single(group: str, backend: str, cold: bool) -> Iterator[Tuple[str, Row]]:
    read = functools.lru_cache(maxsize=1)(meshes.read)
    kept: Dict[Path, Any] = {}
    for name, path, stroke in single_strokes(group):
        mesh = read(path)
        for remesh in ("off", "default"):
            if cold or path not in kept:
                kept = {path: system(backend)}
            one_stroke = kept[path]
            (one_stroke.SetRemeshToOff if remesh == "off" else one_stroke.SetRemeshToAuto)()
            one_stroke.SetInputData(mesh)
            one_stroke.SetStrokeData(stroke)
            one_stroke.Update()
            require(one_stroke, backend)
            yield f"{group}/{name}/{remesh}", row(one_stroke.GetOutput(), mesh, stroke)


def run_sessions(backend: str) -> Iterator[Tuple[str, Row]]:
    """Saved sessions, by the command; each was saved on one back end and is replayed on the one asked for."""
    command = os.environ.get("OVERSKETCH_COMMAND")
    if not command:
        say("sessions not run: OVERSKETCH_COMMAND does not name the command")
        return
    for path in sorted((HERE / "Sessions").glob("*.oversketch")):
        with tempfile.TemporaryDirectory() as folder:
            session, made = Path(folder) / path.name, Path(folder) / "made.vtp"
            with zipfile.ZipFile(path) as package, zipfile.ZipFile(session, "w") as copy:
                document = json.loads(package.read("session.json"))
                document["made_by"]["backend"] = backend
                for entry in package.namelist():
                    copy.writestr(entry, json.dumps(document) if entry == "session.json" else package.read(entry))
                mesh = package.extract(document["mesh"], folder)
            done = subprocess.run([command, "replay", str(session), "-o", str(made)], capture_output=True, text=True)
            if done.returncode != 0:
                raise RuntimeError(f"{path.name}: {done.stderr}")
            yield f"sessions/{path.stem}", row(meshes.read(made), meshes.read(mesh), path.read_bytes())


def run_each(backend: str, everything: bool) -> Iterator[Tuple[str, Row]]:
    """A collection of models, a stroke for each, bad ones in their midst."""
    from oversketch import vtkOversketchForEach

    wrong = [int(share * (ALL + len(variants.BAD))) for share in variants.BAD.values()]
    chosen = [(k, *pair) for k, pair in enumerate(variants.pairs(ALL)) if everything or k < SOME or k in wrong]
    models, lines = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
    for at, (_, mesh, stroke) in enumerate(chosen):
        models.SetBlock(at, mesh)
        lines.SetBlock(at, stroke)
    each, one_stroke = silent(vtkOversketchForEach()), system(backend)
    each.SetFilter(one_stroke)
    each.SetInputData(models)
    each.SetStrokeData(lines)
    each.Update()
    require(one_stroke, backend)
    made = each.GetOutputDataObject(0)
    for at, (k, mesh, stroke) in enumerate(chosen):
        yield f"each/{k:03}", row(made.GetBlock(at), mesh, stroke)


def run_lines(backend: str, cold: bool) -> Iterator[Tuple[str, Row]]:
    """The shipped strokes that augment, on their models and the terrain; and a vein on a deformed model, deformed again."""
    from oversketch import vtkOversketchAugment, vtkOversketchTerrain

    def augment() -> Any:
        made = silent(vtkOversketchAugment())
        (made.SetBackendToHost if backend == "embree" else made.SetBackendToOpenCL)()
        return made

    def ran(filter: Any, mesh: vtkPolyData, stroke: vtkPolyData) -> vtkPolyData:
        filter.SetInputData(0, mesh)
        filter.SetInputData(1, stroke)
        filter.Update()
        result = vtkPolyData()
        result.ShallowCopy(filter.GetOutput())
        return result

    kept = augment()
    for path in listing.augment():
        filter, strokes, model = augment() if cold else kept, meshes.read(path), path.stem.split("_")[0]
        if model == "valley":
            image = vtkPNGReader()
            image.SetFileName(str(meshes.DATA / "Terrain" / "valley.png"))
            terrain = vtkOversketchTerrain()
            terrain.SetInputConnection(image.GetOutputPort())
            terrain.SetScale(0.0008)
            terrain.Update()
            mesh = terrain.GetOutput()
        else:
            mesh = meshes.read(meshes.DATA / "Models" / f"{model}.ply")
        filter.SetSketchMode(path.stem == "person_crest")
        yield f"lines/{path.stem}", row(ran(filter, mesh, strokes), mesh, strokes)
    dog, parts = meshes.read(meshes.DATA / "Models" / "dog.ply"), []
    for name in ("dog_longer_leg", "dog_collar", "dog_curled_tail"):
        filter = augment() if name == "dog_collar" else system(backend)
        drawn = meshes.read(meshes.DATA / "Strokes" / f"{name}.vtp")
        parts.append(ran(filter, parts[-1] if parts else dog, drawn))
    yield "lines/chain", row(parts[-1], dog, drawn)


def run_drawings(cold: bool) -> Iterator[Tuple[str, Row]]:
    """The shipped drawings over their pictures. Nothing of them is computed on a back end."""
    from oversketch import vtkOversketchInflateDrawing

    kept = silent(vtkOversketchInflateDrawing())
    for path in listing.drawings():
        filter = silent(vtkOversketchInflateDrawing()) if cold else kept
        drawing, image = meshes.read(path), vtkPNGReader()
        image.SetFileName(str(path.with_suffix(".png")))
        filter.SetInputData(0, drawing)
        filter.SetInputConnection(1, image.GetOutputPort())
        filter.Update()
        yield f"drawings/{path.stem}", row(filter.GetOutput(), drawing, path.read_bytes() + path.with_suffix(".png").read_bytes())


def run(group: str, backend: str, cold: bool, everything: bool) -> Iterator[Tuple[str, Row]]:
    if group == "sessions":
        return run_sessions(backend)
    if group == "each":
        return run_each(backend, everything)
    if group == "lines":
        return run_lines(backend, cold)
    if group == "drawings":
        return run_drawings(cold)
    return run_single(group, backend, cold)


# ----------------------------------------------------------------------------------------------------- processes

def say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def threads(count: int) -> Dict[str, str]:
    """The environment of a process whose VTK and PoCL take that many threads."""
    names = ("VTK_SMP_MAX_THREADS", "POCL_MAX_PTHREAD_COUNT", "POCL_CPU_MAX_CU_COUNT")
    return dict(os.environ, **{name: str(count) for name in names})


class Process:
    """bits.py at work in a process of its own."""

    def __init__(self, backend: str, count: int, *arguments: str) -> None:
        self.what = f"{backend}, {count} thread{'s' * (count > 1)}"
        self.process = subprocess.Popen([sys.executable, __file__, backend, *arguments], env=threads(count), text=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def rows(self) -> Tuple[Dict[str, Row], str]:
        """What it made by name, and what it had to say."""
        told, said = self.process.communicate()
        if self.process.returncode != 0:
            raise RuntimeError(f"bits.py, {self.what}: exit code {self.process.returncode}\n{said}")
        return {name: Row(*values) for name, values in json.loads(told.splitlines()[-1]).items()}, said


def platform() -> Dict[str, str]:
    """What the bits depend on besides the sources: processor, compiler, libraries."""
    import oversketch

    library = Path(oversketch.__file__).parents[3] / "libOversketchKernelsMesh.so"
    comment = subprocess.run(["readelf", "-p", ".comment", str(library)], capture_output=True, text=True, check=True).stdout
    command = os.environ.get("OVERSKETCH_COMMAND", "oversketch")
    told = dict(re.findall(r"^(\w+) +(.*)$", subprocess.run([command, "--version"], capture_output=True, text=True,
                                                            check=True).stdout, re.M))
    flags = re.search(r"^flags\s*: (.*)$", Path("/proc/cpuinfo").read_text(), re.M)
    vectors = sorted(set(flags.group(1).split()) & {"sse4_2", "fma", "avx", "avx2", "avx512f", "avx512dq", "avx512vl"}) if flags else []
    return {
        "processor": " ".join(vectors),
        "compiler": ", ".join(sorted(set(re.findall(r"\] +(.*)", comment)))),
        "C library": os.confstr("CS_GNU_LIBC_VERSION") or "unknown",
        "VTK": vtkVersion.GetVTKVersion(),
        "Embree": told["Embree"],
        "OpenCL": told["OpenCL"],
    }


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("backend", choices=BACKENDS)
    arguments.add_argument("--cold", action="store_true")
    arguments.add_argument("--all", action="store_true")
    arguments.add_argument("--group", choices=GROUPS)
    options = arguments.parse_args()
    groups = [options.group] if options.group else GROUPS
    made = {name: each for group in groups for name, each in run(group, options.backend, options.cold, options.all)}
    print(json.dumps(made))
    return 0


if __name__ == "__main__":
    sys.exit(main())
