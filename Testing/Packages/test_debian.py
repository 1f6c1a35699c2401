"""The Debian packages of this release: made, looked into, and run from the folder that they are unpacked to. Testing/packages.sh
installs them on bare systems."""
import gzip
import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from environment import compiled_anew  # noqa: E402
from gpl import gpl_alone, gpl_parts  # noqa: E402

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
COMMAND = os.environ["OVERSKETCH_COMMAND"]
BUILD = SOURCE / "build" / "package"
RESULTS = pathlib.Path(__file__).with_name("results.py")
MODEL = SOURCE / "Data" / "Models" / "hand.ply"
STROKE = SOURCE / "Data" / "Strokes" / "hand_longer_finger.vtp"
VERSION = re.search(r"project\(Oversketch VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
NAMES = ["liboversketch", "liboversketch-dev", "oversketch", "python3-oversketch"]


def run(*command, code=0, **more):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **more)
    assert done.returncode == code, (command, done.returncode, done.stdout[-2000:] + done.stderr[-4000:])
    return done.stdout


@pytest.fixture(scope="module")
def build(tmp_path_factory):
    """Of what the build that is tested has compiled: from nothing, so that this is seen."""
    shutil.rmtree(BUILD, ignore_errors=True)
    log = tmp_path_factory.mktemp("build") / "ccache.log"
    run("cmake", "--preset", "package", cwd=SOURCE)
    run("cmake", "--build", "--preset", "package", "-j2", cwd=SOURCE, env={**os.environ, "CCACHE_STATSLOG": str(log)})
    assert compiled_anew(log) == []
    return BUILD


@pytest.fixture(scope="module")
def debs(build, tmp_path_factory):
    folder = tmp_path_factory.mktemp("debs")
    run("cpack", "--config", build / "CPackConfig.cmake", "-B", folder, cwd=folder)
    found = {file.name.partition("_")[0]: file for file in folder.glob("*.deb")}
    assert sorted(found) == NAMES
    return found


@pytest.fixture(scope="module")
def root(debs, tmp_path_factory):
    """All four, unpacked into one folder."""
    folder = tmp_path_factory.mktemp("root")
    for deb in debs.values():
        run("dpkg-deb", "-x", deb, folder)
    return folder


@pytest.fixture(scope="module")
def environment(root):
    libraries = next((root / "usr" / "lib").glob("*/libOversketchKernelsMesh.so.*")).parent
    return {**os.environ, "LD_LIBRARY_PATH": str(libraries), "PATH": f"{root}/usr/bin:{os.environ['PATH']}",
            "PYTHONPATH": f"{root}/usr/lib/python3/dist-packages", "XDG_DATA_DIRS": f"{root}/usr/share"}


def field(deb, name):
    return run("dpkg-deb", "-f", deb, name).strip()


def files(deb):
    lines = run("dpkg-deb", "-c", deb).splitlines()
    return {line.split()[5][1:] for line in lines if not line.startswith("d")}


@pytest.mark.parametrize("name", NAMES)
def test_control(debs, name):
    assert field(debs[name], "Version") == VERSION
    assert field(debs[name], "Architecture") == run("dpkg", "--print-architecture").strip()
    summary, *more = field(debs[name], "Description").splitlines()
    assert 20 < len(summary) < 80 and len(more) > 3
    needs = field(debs[name], "Depends")
    assert name == "liboversketch" or f"liboversketch (= {VERSION})" in needs
    expected = {
        "liboversketch": [r"libvtk9\.\d", r"libembree\d", r"libc6 \(>=", r"libarchive13\w* \(>=", r"libgdal\d"],
        "liboversketch-dev": ["libvtk9-dev", "libeigen3-dev", "ocl-icd-opencl-dev"],
        "oversketch": [r"libqt5widgets5\w* \(>=", r"libarchive13\w* \(>=", r"libvtk9\.\d\w*-qt"],
        "python3-oversketch": ["python3-vtk9", "python3-numpy", r"python3 \(>= 3\.\d+\), python3 \(<< 3\.\d+\)", r"libvtk9\.\d"],
    }
    for need in expected[name]:
        assert re.search(need, needs), (need, needs)


def test_each_file_is_in_one_package_and_the_right_one(debs):
    owners = {}
    for name, deb in debs.items():
        for file in files(deb):
            assert file not in owners, (file, name, owners[file])
            owners[file] = name
    wanted = {
        "/usr/bin/oversketch": "oversketch",
        "/usr/bin/oversketch-studio": "oversketch",
        "/usr/share/applications/oversketch-studio.desktop": "oversketch",
        "/usr/share/icons/hicolor/scalable/apps/oversketch-studio.svg": "oversketch",
        "/usr/share/mime/packages/oversketch.xml": "oversketch",
        "/usr/share/man/man1/oversketch.1.gz": "oversketch",
        "/usr/share/man/man1/oversketch-studio.1.gz": "oversketch",
        "/usr/share/oversketch/Models/dog.ply": "oversketch",
        "/usr/include/oversketch/vtkOversketchOneStroke.h": "liboversketch-dev",
        "/usr/include/oversketch/Kernels/Mesh/mesh.h": "liboversketch-dev",
        "/usr/bin/oversketch-web": "python3-oversketch",
        "/usr/share/man/man1/oversketch-web.1.gz": "python3-oversketch",
        "/usr/lib/python3/dist-packages/oversketch_web/page/index.html": "python3-oversketch",
        "/usr/lib/python3/dist-packages/oversketch/__init__.py": "python3-oversketch",
        "/usr/lib/python3/dist-packages/oversketch/__init__.pyi": "python3-oversketch",
        "/usr/lib/python3/dist-packages/oversketch/py.typed": "python3-oversketch",
    }
    for name in NAMES:
        wanted[f"/usr/share/doc/{name}/copyright"] = name
    for file, name in wanted.items():
        assert owners.get(file) == name, file
    for file, name in owners.items():
        if re.search(r"\.so\.\d|/liboversketch_raster\.so$", file):
            assert name == "liboversketch", file
        elif file.endswith((".h", ".cmake", ".so")) and "python3" not in file:
            assert name == "liboversketch-dev", file
        assert not file.endswith((".pyc", ".a")), file


def test_no_path_of_this_machine_is_inside(root):
    for file in root.rglob("*"):
        if not file.is_file() or file.is_symlink():
            continue
        data = file.read_bytes()
        if data.startswith(b"\x7fELF"):
            assert "RPATH" not in (dynamic := run("readelf", "-d", file)) and "RUNPATH" not in dynamic, file
            assert not re.search(r"\.debug_info", run("readelf", "-SW", file)), file
        else:
            assert str(SOURCE).encode() not in data, file
            assert str(pathlib.Path(COMMAND).parent.parent).encode() not in data, file


def test_models_strokes_drawings_and_edits_are_all_inside(root):
    shipped = 0
    for folder in ("Drawings", "Edits", "Models", "Strokes", "Terrain", "Works"):
        here, there = SOURCE / "Data" / folder, root / "usr" / "share" / "oversketch" / folder
        assert sorted(file.name for file in there.iterdir()) == sorted(file.name for file in here.iterdir()), folder
        for file in here.iterdir():
            assert file.read_bytes() == (there / file.name).read_bytes(), file
            shipped += 1
    assert shipped > 50


def test_the_unpacked_command_and_python_package_make_of_what_is_shipped_what_the_build_makes(root, environment):
    """README's lines of each, from the unpacked files alone."""
    there = run(sys.executable, RESULTS, SOURCE / "README.md", root / "usr" / "share" / "oversketch", root / "usr" / "bin" / "oversketch", env=environment)
    assert there == run(sys.executable, RESULTS, SOURCE / "README.md", SOURCE / "Data", COMMAND)
    made = re.findall(r"^(\S+) [0-9a-f]{32}$", there, re.M)
    assert made == ["vtkOversketchOneStroke", "vtkOversketchAugment", "vtkOversketchEdit", "vtkOversketchInflateDrawing",
                    "one-stroke", "augment", "edit", "inflate", "assemble"]


@pytest.mark.parametrize("program", ["oversketch", "oversketch-studio"])
def test_the_unpacked_programs_start(program, root, environment):
    assert VERSION in run(root / "usr" / "bin" / program, "--version", env=environment)


def test_the_unpacked_python_package_is_loaded(root, environment, tmp_path):
    program = f"""
import oversketch
assert oversketch.__file__.startswith({str(root)!r}) and oversketch.__version__ == {VERSION!r}
oversketch.vtkOversketchStrokeWidget()
session = oversketch.vtkOversketchSession()
assert session.Open({str(MODEL)!r}) and session.Update(), session.GetMessage()
"""
    run(sys.executable, "-c", program, env=environment, cwd=tmp_path)


def test_the_unpacked_development_files_build_the_consumer(root, environment, tmp_path):
    run("cmake", "-G", "Ninja", "-S", SOURCE / "Testing" / "Consumer", "-B", tmp_path, f"-DCMAKE_PREFIX_PATH={root}/usr",
        "-DCMAKE_BUILD_TYPE=Release", env=environment)
    run("cmake", "--build", tmp_path, env=environment)
    assert str(root) in run("ldd", tmp_path / "consumer", env=environment)
    moved, furthest = run(tmp_path / "consumer", MODEL, STROKE, tmp_path / "hand.png", env=environment).split()
    assert int(moved) > 100 and 0.05 < float(furthest) < 4.0


def test_man_pages_name_every_command_and_option(root, environment):
    folder = root / "usr" / "share" / "man" / "man1"
    summary = run(root / "usr" / "bin" / "oversketch", "--help", env=environment)
    verbs = sorted(set(re.findall(r"^  oversketch ([a-z][a-z-]+) ", summary, re.M)))
    assert verbs == ["assemble", "augment", "check", "edit", "inflate", "join", "mask", "one-stroke", "pose", "relax", "replay", "terrain", "transform"]
    for program, helps in (("oversketch", [["--help"], *([verb, "--help"] for verb in verbs)]), ("oversketch-studio", [["--help"]]),
                           ("oversketch-web", [["--help"]])):
        page = gzip.open(folder / (program + ".1.gz"), "rt").read()
        assert f"Oversketch {VERSION}" in page and "@" not in page
        text = page.replace("\\-", "-")
        for arguments in helps:
            shown = run(root / "usr" / "bin" / program, *arguments, env=environment)
            options = set(re.findall(r"(?<![\w-])--?[a-z][a-z-]*", shown))
            part = text
            if len(arguments) > 1:  # in the synopsis, then what it does, then its options
                assert len(re.findall(rf"^(?:\.B |\.SS |\\fB)oversketch {arguments[0]}(?:$|\\fR)", text, re.M)) == 3, arguments
                part = re.search(rf"^\.SS oversketch {arguments[0]}$(.*?)^\.S[SH]", text, re.M | re.S).group(1)
            assert options and all(option in part for option in options), (program, arguments, options)


def test_desktop_files(root):
    share = root / "usr" / "share"
    entry = dict(line.split("=", 1) for line in (share / "applications" / "oversketch-studio.desktop").read_text().splitlines() if "=" in line)
    assert (root / "usr" / "bin" / entry["Exec"].split()[0]).exists()
    assert (share / "icons" / "hicolor" / "scalable" / "apps" / (entry["Icon"] + ".svg")).exists()
    types = xml.etree.ElementTree.parse(share / "mime" / "packages" / "oversketch.xml").getroot()
    space = "{http://www.freedesktop.org/standards/shared-mime-info}"
    assert [t.get("type") for t in types] == entry["MimeType"].strip(";").split(";")
    assert types.find(f"{space}mime-type/{space}glob").get("pattern") == "*.oversketch"
    icon = xml.etree.ElementTree.parse(share / "icons" / "hicolor" / "scalable" / "apps" / "oversketch-studio.svg").getroot()
    assert icon.tag == "{http://www.w3.org/2000/svg}svg"


def test_nothing_in_them_is_under_the_gpl(build):
    assert gpl_alone("/usr/include/CGAL/Polygon_mesh_processing/remesh.h")  # the question can be answered with yes
    cache = (build / "CMakeCache.txt").read_text()
    assert "OVERSKETCH_GPL:UNINITIALIZED=OFF" in cache or "OVERSKETCH_GPL:BOOL=OFF" in cache
    assert gpl_parts(build) == []
