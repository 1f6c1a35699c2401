"""pip wheel . builds the package from source against the system's VTK; installed, it passes the Python tests outside the tree. Where the
system has scikit-build-core (Debian 13), no package index is needed."""
import os
import pathlib
import re
import shutil
import sys
import zipfile

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from environment import Environment, compiled_anew, run  # noqa: E402

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
VERSION = re.search(r"project\(Oversketch VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)


@pytest.fixture(scope="module")
def environment(tmp_path_factory):
    made = Environment(tmp_path_factory.mktemp("environment"))
    made.offline = ["--no-index", "--no-build-isolation"] if made.has("scikit_build_core") else []
    if not made.offline:
        made.require_index(tmp_path_factory.mktemp("index"))
    return made


@pytest.fixture(scope="module")
def wheel(environment, tmp_path_factory):
    folder = tmp_path_factory.mktemp("wheel")
    shutil.rmtree(SOURCE / "build" / "wheel", ignore_errors=True)  # from nothing, so that what is compiled is seen
    # The compiler by its plain name, as CMake finds it: by another name the compiler's cache takes it for another. What the build
    # that is tested has compiled is not compiled again.
    log = folder.with_suffix(".log")
    quick = {"CC": "cc", "CXX": "c++", "CCACHE_STATSLOG": str(log)}
    quick |= {f"CMAKE_{language}_COMPILER_LAUNCHER": "ccache" for language in ("C", "CXX")}
    environment.run("-m", "pip", "wheel", SOURCE, "--no-deps", *environment.offline, "-w", folder, variables=quick)
    assert compiled_anew(log) == []
    (made,) = folder.iterdir()
    return made


@pytest.fixture(scope="module")
def installed(environment, wheel):
    environment.run("-m", "pip", "install", "--no-index", "--no-deps", wheel)
    return pathlib.Path(environment.run("-c", "import oversketch; print(oversketch.__file__)").strip()).parent


def test_its_name_and_what_it_holds(wheel):
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    assert wheel.name.startswith(f"oversketch-{VERSION}-{python}-{python}-linux_")
    names = zipfile.ZipFile(wheel).namelist()
    libraries = [name for name in names if name.startswith("oversketch/lib/")]
    assert len(libraries) > 10 and all(re.fullmatch(r"oversketch/lib/lib[Oo]versketch\w+\.so", name) for name in libraries)
    stubs = {name.removesuffix(".pyi") for name in names if name.endswith(".pyi")}
    modules = {name.removesuffix(".so") for name in names if re.fullmatch(r"oversketch/Oversketch\w+\.so", name)}
    assert len(modules) > 5 and stubs == modules | {"oversketch/__init__"}
    assert all(name.startswith(("oversketch/", f"oversketch-{VERSION}.dist-info/")) for name in names)


def test_its_libraries_find_each_other(environment, installed):
    assert environment.python.parent.parent in installed.parents
    for file in [*installed.glob("*.so"), *installed.glob("lib/*.so")]:
        path = re.search(r"RUNPATH.*\[(.*)\]", run("readelf", "-d", file))
        assert path and path.group(1) and all(part.startswith("$ORIGIN") for part in path.group(1).split(":")), (file, path)
        loaded = run("ldd", file)
        assert "not found" not in loaded
        for library in re.findall(r"libOversketch\w+\.so => (\S+)", loaded):
            assert pathlib.Path(library).resolve().parent == (installed / "lib").resolve(), (file, library)


def test_it_makes_of_what_is_shipped_what_the_build_makes(environment, installed):
    """README's lines of Python."""
    arguments = [pathlib.Path(__file__).with_name("results.py"), SOURCE / "README.md", SOURCE / "Data"]
    made = environment.run(*arguments)
    assert made == run(sys.executable, *arguments)
    assert len(set(re.findall(r" ([0-9a-f]{32})$", made, re.M))) == 4


def test_the_python_tests_pass_outside_the_tree(environment, installed, tmp_path):
    tests = sorted((SOURCE / "Wrapping" / "Python" / "Testing").glob("test_*.py"))
    assert len(tests) >= 3
    for test in tests:
        shutil.copy(test, tmp_path)
    said = environment.run("-m", "pytest", "-q", "-p", "no:cacheprovider", tmp_path, cwd=tmp_path)
    assert int(re.search(r"(\d+) passed", said).group(1)) > 40 and "skipped" not in said
