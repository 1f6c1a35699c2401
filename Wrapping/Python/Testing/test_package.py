"""The package as a whole: every class is there, every parameter is seen by Python and printed by PrintSelf."""
import os
import pathlib
import re
import subprocess
import sys

import pytest

import oversketch

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
HEADERS = sorted(
    p
    for p in [*SOURCE.glob("Filters/*/vtkOversketch*.h"), *SOURCE.glob("Widgets/*/vtkOversketch*.h"),
              *SOURCE.glob("Applications/Session/Module/*.h")]
    if re.search(r"^class \w+_EXPORT vtk", p.read_text(), re.M)
)
CONCRETE = [h for h in HEADERS if f"static {h.stem}* New();" in h.read_text()]  # the others are bases


def parameters(header):
    """Names X for which the header has a SetX(bool, int, double, vtkIdType, const char*) or a macro that makes one."""
    text = header.read_text()
    names = re.findall(r"vtkSet(?:Clamp|String|FilePath|Vector\d)?Macro\(\s*(\w+)", text)
    names += re.findall(r"void Set(\w+)\(\s*(?:bool|int|double|vtkIdType|const char\*)\s+\w+\s*\)", text)
    base = re.search(rf"^class \w+ {header.stem} : public (vtkOversketch\w+)", text, re.M)
    if base:
        names += parameters(next(h for h in HEADERS if h.stem == base.group(1)))
    return sorted(set(names))


def test_there_are_headers():
    assert len(HEADERS) >= 12


@pytest.mark.parametrize("header", CONCRETE, ids=lambda h: h.stem)
def test_class_is_exported_and_parameters_are_seen_and_printed(header):
    instance = getattr(oversketch, header.stem)()
    printed = str(instance)
    for name in parameters(header):
        getter = getattr(instance, "Get" + name, None)
        assert getter is not None, f"{header.stem} has Set{name} but Python sees no Get{name}"
        value = getter()
        getattr(instance, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
        assert re.search(rf"^\s*{name}: ", printed, re.M), f"{header.stem}::PrintSelf does not print {name}"


# What must be there before these can be set.
NEEDED = {"Enabled": "an interactor", "ParallelProjection": "a camera", "Zoom": "a camera", "Spin": "a camera", "SectionFollows": "a section", "Model": "a scene of several"}


def others(value):
    """Values to set in a value's place; a setter may clamp some of them to what it is, or refuse a text."""
    if isinstance(value, tuple):
        return [tuple(others(each)[k] for each in value) for k in range(2)]
    if value is None or isinstance(value, str):
        return ["0.5", "move 0.5 n 1", "handle 0.3 0.5"]
    return [not value] if isinstance(value, bool) else [value + 1, value - 1] if isinstance(value, int) else [value + 0.5, value - 0.5]


@pytest.mark.parametrize("header", CONCRETE, ids=lambda h: h.stem)
def test_another_value_is_kept_and_printed(header):
    for name in parameters(header):
        instance = getattr(oversketch, header.stem)()
        before = getattr(instance, "Get" + name)()
        line = re.compile(rf"^\s*{name}: .*$", re.M)
        printed, modified = line.findall(str(instance)), instance.GetMTime()
        for value in others(before):
            getattr(instance, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
            if getattr(instance, "Get" + name)() != before:
                break
        if getattr(instance, "Get" + name)() == before:
            assert name in NEEDED, f"Set{name} of {header.stem} changes nothing"
            continue
        assert instance.GetMTime() > modified, f"Set{name} of {header.stem} does not say that it changed"
        assert line.findall(str(instance)) != printed, f"{header.stem}::PrintSelf prints {printed[0].strip()} whatever is set"


@pytest.mark.parametrize("header", CONCRETE, ids=lambda h: h.stem)
def test_setting_a_value_again_does_not_modify(header):
    instance = getattr(oversketch, header.stem)()
    for name in parameters(header):
        value = getattr(instance, "Get" + name)()
        before = instance.GetMTime()
        getattr(instance, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
        assert instance.GetMTime() == before, f"Set{name} with the value it has modifies {header.stem}"


def snippets(page):
    """The blocks of Python in a page that can be run by themselves."""
    return [text for text in re.findall(r"```python\n(.*?)```", page.read_text(), re.S) if text.startswith("import oversketch, vtk")]


SNIPPETS = snippets(SOURCE / "README.md")
FURTHER = [pytest.param(page, text, id=f"{page.stem}-{number}") for page in sorted(SOURCE.glob("Documentation/*.md"))
           for number, text in enumerate(snippets(page))]


def test_the_readme_has_a_snippet_for_each_system():
    assert [re.search(r"vtkOversketch\w+", text).group() for text in SNIPPETS] == ["vtkOversketchOneStroke", "vtkOversketchAugment", "vtkOversketchEdit", "vtkOversketchInflateDrawing"]


@pytest.mark.parametrize("snippet", SNIPPETS)
def test_the_snippets_of_the_readme_run_as_written(snippet, monkeypatch, capsys):
    assert len(snippet.strip().splitlines()) <= 10
    monkeypatch.chdir(SOURCE)
    exec(compile(snippet, "README.md", "exec"), {})
    said = capsys.readouterr().out
    assert int(said.split()[0]) > 1000
    assert "flipped" not in said or said.strip().endswith("flipped: 0")


@pytest.mark.parametrize("page, snippet", FURTHER)
def test_the_snippets_of_the_documentation_run_as_written(page, snippet, monkeypatch, tmp_path, capsys):
    """In a folder that has Data, as the source folder has, and takes what they write."""
    (tmp_path / "Data").symlink_to(SOURCE / "Data")
    monkeypatch.chdir(tmp_path)
    exec(compile(snippet, page.name, "exec"), {})
    said = capsys.readouterr().out
    assert said
    assert "flipped" not in said or said.strip().endswith("flipped: 0")


def test_version():
    version = re.search(r"VERSION (\d+\.\d+\.\d+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
    assert oversketch.__version__ == version


def python(program):
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


def test_importing_loads_no_rendering_until_a_widget_is_asked_for():
    show = "print(*(m for m in sys.modules if m.startswith('vtkmodules.vtk') or m == 'numpy'))\n"
    loaded = python("import sys, oversketch\noversketch.vtkOversketchOneStroke()\n" + show)
    assert "vtkmodules.vtkCommonExecutionModel" in loaded
    assert not [m for m in loaded if re.search("Rendering|Interaction|Imaging|IO|Views|numpy", m)], loaded
    loaded = python("import sys, oversketch\noversketch.vtkOversketchInteractorStyle()\n" + show)
    assert "vtkmodules.vtkRenderingCore" in loaded


def test_all_names_can_be_imported_and_others_cannot():
    names = python("from oversketch import *\nprint(*(n for n in dir() if not n.startswith('_')))")
    assert set(names) == {h.stem for h in HEADERS} | {"FilterError", "drawing", "show", "stroke", "strokes", "update"}
    assert python("import oversketch\nprint(hasattr(oversketch, 'vtkOversketchNothing'), hasattr(oversketch, 'all'))") == ["False"] * 2


@pytest.mark.parametrize("before, message", [
    ("import sys\nsys.modules['vtkmodules.vtkCommonExecutionModel'] = None\n", "on Debian install python3-vtk9"),
    ("class Other(vtkmodules.vtkCommonCore.vtkVersion):\n    GetVTKMinorVersion = lambda: 99\n"
     "vtkmodules.vtkCommonCore.vtkVersion = Other\n", "was built for VTK 9."),
    ], ids=["none", "other"])
def test_without_the_right_package_of_vtk_the_remedy_is_named(before, message):
    program = "import vtkmodules.vtkCommonCore\n" + before + "import oversketch\n"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 1
    last = done.stderr.strip().splitlines()[-1]
    assert last.startswith("ImportError: oversketch ") and message in last
