"""A newcomer's first day, followed to the letter: to a copy of the sources a filter with a kernel and a room of its own is added
(CONTRIBUTING.md, "Add a filter"), and a system over it that takes two strokes and a picture, with a tool whose hand
the mesh follows ("Add a system"); both are built
and run from the command, a session, Python, the window and in ParaView's description. What had to be touched outside the new
folders is printed: two files, the list of systems and the list of tools.

The build takes from the compiler cache what the build that is tested has compiled.
"""
import filecmp
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as tree
import zipfile

import pytest
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter  # noqa: F401 (the program of `made` takes all from here)
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
BUILD = pathlib.Path(os.environ["OVERSKETCH_BUILD"])
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / name) for name in ("Acceptance", "Bits", "Packages", "Studio")]
import bits  # noqa: E402
import picture  # noqa: E402
import reader  # noqa: E402
import stroke_files  # noqa: E402
from desk import Desk, Studio, until  # noqa: E402
from environment import compiled_anew  # noqa: E402

NAME = "PushBetween"
OWN = ("Kernels/Push/", "Filters/Push/", f"Filters/{NAME}/", "Applications/Studio/Tools/push_tool.")  # what is new and nobody else's
MODEL = SOURCE / "Data" / "Models" / "dog.ply"
LEFT_OUT = shutil.ignore_patterns("build*", ".git", "__pycache__", "demo", "Temporary")


def run(*command, code=0, **more):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **more)
    assert done.returncode == code, f"{command}: {done.returncode}\n{done.stdout[-6000:]}{done.stderr[-3000:]}"
    return done.stdout


# ------------------------------------------------------------------------------------------------ the newcomer's work

def parts(text, system, tool):
    """The parts of a list that belong to a system: from its #ifdef to the #endif, and the header of its tool."""
    return re.findall(rf'^#ifdef OVERSKETCH_WITH_{system}\n.*?^#endif\n|^#include "{tool}"\n', text, re.M | re.S)


def add_beside(listing, own):
    """Puts the toy's parts of a list after those of system A, which a newcomer copies."""
    text, added = listing.read_text(), parts(own.read_text(), "PUSHBETWEEN", "push_tool.h")
    known = parts(text, "ONESTROKE", "one_stroke_tool.h")
    assert len(known) == len(added) > 1, f"{listing} has {len(known)} parts of system A, the toy brings {len(added)}"
    for before, after in zip(known, added):
        text = text.replace(before, before + after, 1)
    listing.write_text(text)


def touched(copy):
    """The files of the copy that are new or another than in the sources."""
    for path in sorted(p for p in copy.rglob("*") if p.is_file()):
        original = SOURCE / path.relative_to(copy)
        if not original.is_file() or not filecmp.cmp(path, original, shallow=False):
            yield path.relative_to(copy).as_posix()


@pytest.fixture(scope="module")
def sources():
    copy = pathlib.Path(os.environ["OVERSKETCH_TEMPORARY"]) / "Toy" / "sources"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(SOURCE, copy, ignore=LEFT_OUT, symlinks=True)
    shutil.copytree(HERE / "tree", copy, dirs_exist_ok=True)
    add_beside(copy / "Applications" / "Session" / "Scene" / "systems.cxx", HERE / "rows.cxx.in")
    add_beside(copy / "Applications" / "Studio" / "Tools" / "tools.cxx", HERE / "tools.cxx.in")
    return copy


@pytest.fixture(scope="module")
def build(sources):
    folder = sources / "build" / "release"
    # The same paths, seen from the folder of the build, as those of the build that is tested.
    log = folder.with_suffix(".ccache")
    cache = dict(os.environ, CCACHE_BASEDIR=str(sources), CCACHE_STATSLOG=str(log))
    run("cmake", "--preset", "release", cwd=sources, env=cache)
    run("cmake", "--build", folder, "-j2", "--target", "oversketch", "oversketch-studio", "oversketch_python_stubs", "kernel_push_test",
        "filters_push_test", env=cache)
    # Nothing is compiled again but the toy's own, what names systems, the window's files that its tool is compiled together with, the header of
    # kernels' tests where those of the build that is tested were not compiled, and in a folder where no toy was built before, sources that
    # VTK's messages name by their whole path.
    allowed = (r"[Pp]ush|/(own_systems|systems|tools|figures|picture)\.cxx|oversketch_studio\.dir/Unity|mocs_compilation|^(Filters|Widgets)/.*/Unity/"
               r"|^Applications/Command/.*/Unity/|kernel_tests(\.dir/cmake_pch\.hxx)?\.cxx$")
    assert [source for source in compiled_anew(log) if not re.search(allowed, source)] == []
    return folder


def test_two_files_are_touched(sources):
    found = list(touched(sources))
    own = [name for name in found if name.startswith(OWN)]
    others = [name for name in found if name not in own]
    print(f"\nthe toy's own files: {', '.join(own)}\ntouched outside them: {', '.join(others)}")
    assert others == ["Applications/Session/Scene/systems.cxx", "Applications/Studio/Tools/tools.cxx"]


# ------------------------------------------------------------------------------------------------------- what it makes

def written(writer, data, path):
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    writer.Write()
    assert path.exists()
    return path


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


@pytest.fixture(scope="module")
def given(tmp_path_factory):
    """Files: two strokes round the dog's belly, in a view from the side, and a picture that is brighter to the right."""
    folder = tmp_path_factory.mktemp("given")
    dog = read(vtkPLYReader(), MODEL)
    low, high = dog.GetBounds()[::2], dog.GetBounds()[1::2]
    corners = [[pair[k >> axis & 1] for axis, pair in enumerate(zip(low, high))] for k in range(8)]
    view = picture.View.looking(stroke_files.np.array(corners), (0, 0, 1), (0, 1, 0), False, 0.8)
    lines = [[(x, y) for y in range(200, 401, 10)] for x in (350, 450)]
    files = [written(vtkXMLPolyDataWriter(), stroke_files.polydata(line, view), folder / f"{name}.vtp")
             for name, line in zip(("first", "second"), lines)]
    image = vtkImageData()
    image.SetDimensions(80, 60, 1)
    image.AllocateScalars(3, 3)
    for x in range(80):
        for y in range(60):
            for k in range(3):
                image.SetScalarComponentFromDouble(x, y, 0, k, 3 * x)
    return files + [written(vtkPNGWriter(), image, folder / "brightness.png")]


@pytest.fixture(scope="module")
def made(build, given):
    """The digest of what Python makes."""
    program = f"""
import sys
sys.path[:0] = {[path for path in sys.path if path.startswith(str(HERE.parent))]!r}  # not the package that is tested
import oversketch
from test_toy import *
system = oversketch.vtkOversketch{NAME}()
system.SetSenseToIn()
system.SetLength(0.1)
for port, data in enumerate([read(vtkPLYReader(), MODEL)] + [read(vtkXMLPolyDataReader(), path) for path in sys.argv[1:3]]
                            + [read(vtkPNGReader(), sys.argv[3])]):
    system.SetInputDataObject(port, data)
made = oversketch.update(system)
assert [system.GetStage(k) for k in range(system.GetNumberOfStages())] == ["FirstStroke", "SecondStroke", "Push"]
moved = sum(made.GetPoint(i) != system.GetInputDataObject(0, 0).GetPoint(i) for i in range(made.GetNumberOfPoints()))
print(bits.digest(made), moved)
"""
    package = build / "lib" / "python3" / "dist-packages"
    digest, moved = run(sys.executable, "-c", program, *given, env=dict(os.environ, PYTHONPATH=f"{package}:{HERE}")).split()
    assert int(moved) > 100
    return digest


def test_kernel_and_filter_keep_their_promises(build):
    for name in ("kernel_push_test", "filters_push_test"):
        assert "[  PASSED  ]" in run(build / "bin" / name)


def test_the_command_runs_it(build, given, made, tmp_path):
    command = build / "bin" / "oversketch"
    assert "push-between" in run(command, "--help")
    told = run(command, "push-between", "--help")
    assert "--length" in told and "--sense" in told and "out" in told
    out, report = tmp_path / "out.vtp", tmp_path / "report.json"
    run(command, "push-between", MODEL, *given, "-o", out, "--sense", "in", "--length", "0.1", "--report", report)
    assert bits.digest(read(vtkXMLPolyDataReader(), out)) == made
    assert {"FirstStroke", "SecondStroke", "Push"} <= set(re.findall(r"\w+", report.read_text()))


def session_file(path, given):
    """A session of one step, after the page that describes the format."""
    mesh = read(vtkPLYReader(), MODEL)
    step = {"id": 1, "name": "push", "on": True, "system": NAME, "values": {"Sense": "in", "Length": 0.1},
            "inputs": {"FirstStroke": {"lines": "lines/1.vtp"}, "SecondStroke": {"lines": "lines/2.vtp"},
                       "Brightness": {"image": "images/1.png", "image_name": "brightness.png"}}}
    document = {"format": "oversketch-session", "format_version": 2, "mesh": "mesh/dog.vtp", "mesh_name": "dog.ply", "backend": "auto",
                "steps": [step], "result_md5": "", "made_by": {"version": "", "backend": "embree", "device": "", "processor": ""}}
    with zipfile.ZipFile(path, "w") as package:
        package.writestr("session.json", json.dumps(document))
        package.write(written(vtkXMLPolyDataWriter(), mesh, path.with_suffix(".vtp")), "mesh/dog.vtp")
        for entry, file in zip(("lines/1.vtp", "lines/2.vtp", "images/1.png"), given):
            package.write(file, entry)
    return path


def test_a_session_replays_it(build, given, made, tmp_path):
    out = tmp_path / "out.vtp"
    run(build / "bin" / "oversketch", "replay", session_file(tmp_path / "push.oversketch", given), "-o", out)
    assert bits.digest(read(vtkXMLPolyDataReader(), out)) == made


class Window:
    """The toy's Studio, and what it keeps on the disk meanwhile."""

    def __init__(self, home, *arguments):
        self.home, self.desk, self.studio = home, Desk(), Studio(home, *arguments)

    def place(self, role, name):
        return reader.find(self.studio.process.pid, role, name)

    def kept(self):
        """The folder of the autosave and what it says, once its result is there."""
        assert self.studio.process.poll() is None, (self.home / "log.txt").read_text()
        for path in self.home.glob(f"state/oversketch/autosave/*-{self.studio.process.pid}/session.json"):
            document = json.loads(path.read_text())
            if document["result_md5"] and document.get("steps"):
                return path.parent, document
        return None


@pytest.fixture()
def window(build, tmp_path, monkeypatch):
    monkeypatch.setenv("OVERSKETCH_STUDIO", str(build / "bin" / "oversketch-studio"))
    opened = []

    def opens(*arguments):
        opened.append(Window(tmp_path / "home", *arguments))
        return opened[-1]
    yield opens
    for each in opened:
        each.studio.kill()


def test_the_window_opens_it(window, given, made, tmp_path):
    shown = window(session_file(tmp_path / "push.oversketch", given))
    _, document = until(shown.kept, "the result")
    assert document["result_md5"] == made
    until(lambda: reader.shown(shown.studio.process.pid, "list item", "push"), "the step in the history")


def test_the_window_s_tool_draws_it(window, build, given, tmp_path):
    shown = window(MODEL)
    view = shown.place("filler", "Model")
    shown.desk.focus(shown.desk.windows()[0][0])
    shown.desk.drop(given[2], *view.middle)
    until(lambda: reader.shown(shown.studio.process.pid, "list item", "brightness.png"), "the picture in the scene")
    shown.desk.key("p")
    for x in (-60, 60):
        middle = view.middle
        shown.desk.drag([(middle[0] + x, middle[1] + y) for y in range(-120, 121, 8)])
    _, drawn = until(shown.kept, "a step of two lines")
    (step,) = drawn["steps"]
    assert step["system"] == NAME and sorted(step["inputs"]) == ["Brightness", "FirstStroke", "SecondStroke"]
    # Its own hand: the wheel pushes further, and the step with it.
    shown.desk.hold("ctrl")
    shown.desk.click(*view.middle, button=4)
    shown.desk.hold("ctrl", False)

    def pushed():
        kept = shown.kept()
        return kept if kept and kept[1]["steps"][0].get("values", {}).get("Length", 0) > 0.05 else None
    folder, document = until(pushed, "a step that pushes further")
    assert abs(document["steps"][0]["values"]["Length"] - 0.055) < 1e-9
    assert document["result_md5"] != drawn["result_md5"]
    out = tmp_path / "out.vtp"
    run(build / "bin" / "oversketch", "replay", folder, "-o", out)
    assert bits.digest(read(vtkXMLPolyDataReader(), out)) == document["result_md5"]


def test_paraview_is_told_of_it(sources):
    headers = sorted(sources.glob("Filters/*/vtkOversketch*.h"))
    exported = [path for path in headers if re.search(r"^class [A-Z]+_EXPORT vtk", path.read_text(), re.M)]
    root = tree.fromstring(run(sys.executable, sources / "Applications" / "ParaView" / "Plugin" / "make_proxies.py", *exported))
    proxies = {proxy.get("name"): proxy for proxy in root.iter("SourceProxy")}
    assert "OversketchPush" in proxies
    system = proxies[f"Oversketch{NAME}"]
    assert [each.get("name") for each in system.findall("InputProperty")] == ["Input", "FirstStroke", "SecondStroke", "Brightness"]
    assert [kind.get("value") for kind in system.findall("InputProperty")[3].iter("DataType")] == ["vtkImageData"]
    said = {each.get("name"): each.get("default_values") for each in system if each.get("default_values")}
    assert said == {"Sense": "0", "Length": "0.05", "Backend": "0"}
