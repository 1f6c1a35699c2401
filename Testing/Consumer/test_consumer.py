"""Installed, the libraries are found by a project outside the tree, which runs system A in a window of its own."""
import os
import pathlib
import subprocess
import sys

import pytest
from vtkmodules.vtkIOImage import vtkPNGReader

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
BUILD = pathlib.Path(os.environ["OVERSKETCH_BUILD"])
HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(SOURCE / "Testing" / "Pictures"))
import compare  # noqa: E402


def run(*command, code=0, **more):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **more)
    assert done.returncode == code, (command, done.returncode, done.stdout[-2000:] + done.stderr[-4000:])
    return done


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    folder = tmp_path_factory.mktemp("installed") / "prefix"
    run("cmake", "--install", BUILD, "--prefix", folder)
    return folder


@pytest.fixture(scope="module")
def consumer(prefix, tmp_path_factory):
    folder = tmp_path_factory.mktemp("consumer")
    assert len((HERE / "CMakeLists.txt").read_text().splitlines()) < 20
    run("cmake", "-G", "Ninja", "-S", HERE, "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release")
    run("cmake", "--build", folder)
    libraries = run("ldd", folder / "consumer").stdout
    assert str(prefix) in libraries and str(BUILD) not in libraries and "not found" not in libraries
    return folder / "consumer"


def show(consumer, folder, stroke):
    picture = folder / (stroke + ".png")
    done = run(consumer, SOURCE / "Data" / "Models" / "dinosaur.ply", SOURCE / "Data" / "Strokes" / (stroke + ".vtp"), picture,
               timeout=300)
    reader = vtkPNGReader()
    reader.SetFileName(str(picture))
    reader.Update()
    return done.stdout.split(), reader.GetOutput()


def test_its_window_shows_the_deformed_model(consumer, tmp_path):
    (moved, furthest), picture = show(consumer, tmp_path, "dinosaur_raised_neck")
    assert int(moved) > 1000 and 0.1 < float(furthest) < 4.0
    if compare.matches(picture, "consumer_window"):
        other = show(consumer, tmp_path, "dinosaur_longer_tail")[1]  # the comparison can fail
        assert compare.difference(other, compare.read("consumer_window")) > 10 * compare.LIMIT


def test_a_lost_stroke_is_a_failed_run(consumer, tmp_path):
    done = run(consumer, SOURCE / "Data" / "Models" / "dinosaur.ply", tmp_path / "lost.vtp", tmp_path / "no.png", code=1)
    assert "lost.vtp" in done.stderr
    assert not (tmp_path / "no.png").exists()


def configure(prefix, folder, lines, code=0):
    folder.mkdir()
    (folder / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(Asking LANGUAGES C CXX)\n" + lines)
    done = run("cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={prefix}", code=code)
    return " ".join((done.stdout + done.stderr).split())


def test_what_is_found_are_the_components(prefix, tmp_path):
    everything = configure(prefix, tmp_path / "all", """
find_package(Oversketch REQUIRED)
get_property(targets DIRECTORY PROPERTY IMPORTED_TARGETS)
list(FILTER targets INCLUDE REGEX "^Oversketch::")
list(SORT targets)
message(STATUS "has ${targets};")
""")
    names = everything.partition("has ")[2].split("; ")[0].split(";")
    assert {"Oversketch::FiltersOneStroke", "Oversketch::WidgetsPen", "Oversketch::KernelsRay"} <= set(names)
    message = configure(prefix, tmp_path / "unknown", "find_package(Oversketch REQUIRED COMPONENTS FiltersMagic WidgetsPen)\n", code=1)
    listed = ", ".join(name.partition("::")[2] for name in names)
    assert "Oversketch has no component FiltersMagic. The installed one has: " + listed in message
    optional = "find_package(Oversketch REQUIRED COMPONENTS WidgetsPen OPTIONAL_COMPONENTS FiltersMagic)\n"
    configure(prefix, tmp_path / "optional", optional + "if (NOT Oversketch_WidgetsPen_FOUND OR Oversketch_FiltersMagic_FOUND)\n"
              "message(FATAL_ERROR wrong)\nendif ()\n")


@pytest.mark.parametrize("component, has, lacks", [
    ("KernelsSparse", "OpenCL_FOUND", "VTK_FOUND"),
    ("FiltersOneStroke", "VTK_CommonExecutionModel_FOUND", "VTK_RenderingCore_FOUND"),
    ("WidgetsOneStroke", "VTK_RenderingCore_FOUND", "VTK_GUISupportQt_FOUND"),
    ("Session", "VTK_RenderingCore_FOUND", "VTK_GUISupportQt_FOUND"),
])
def test_only_what_a_component_needs_is_looked_for(prefix, tmp_path, component, has, lacks):
    configure(prefix, tmp_path / component, f"""
find_package(Oversketch REQUIRED COMPONENTS {component})
if (NOT {has} OR {lacks} OR NOT TARGET Oversketch::{component})
  message(FATAL_ERROR "{has}: ${{{has}}}, {lacks}: ${{{lacks}}}")
endif ()
""")
