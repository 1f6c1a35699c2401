"""The type stubs: they hold what the headers declare, agree with the classes, and a checker uses them."""
import ast
import os
import pathlib
import re
import site
import subprocess
import sys

import pytest

import oversketch

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
PACKAGE = pathlib.Path(oversketch.__file__).parent
HEADERS = sorted(
    p
    for p in [*SOURCE.glob("Filters/*/vtkOversketch*.h"), *SOURCE.glob("Widgets/*/vtkOversketch*.h"),
              *SOURCE.glob("Applications/Session/Module/*.h")]
    if re.search(r"^class \w+_EXPORT vtk", p.read_text(), re.M)
)


def stubs():
    """Class name: its definition, over all stubs of the package."""
    found = {}
    for file in PACKAGE.glob("*.pyi"):
        tree = ast.parse(file.read_text(), str(file), type_comments=True)
        found.update((node.name, node) for node in tree.body if isinstance(node, ast.ClassDef))
    return found


def declared(header):
    """The public methods that a header declares: (name, the first words of its comment or None)."""
    text = header.read_text()
    body = re.search(r"^class \w+_EXPORT vtk\w+.*?^public:(.*?)^(?:protected|private):", text, re.M | re.S).group(1)
    methods = {}
    comment = None
    for part in re.finditer(r"/\*\*(.*?)\*/|^  (?:static |virtual )?[\w:<>*& ]*?[ *&](\w+)\([^)]*\)|^  vtk(\w+)Macro\(\s*(\w+)",
                            body, re.M | re.S):
        if part.group(2) and re.search(r"oversketch::|FigureList", part.group(0)):  # a type that Python has not
            comment = None
            continue
        documentation, method, macro, name = part.groups()
        if documentation:
            comment = " ".join(documentation.replace("*", " ").split())
            continue
        if macro in ("Type", "AbstractType"):
            continue
        names = [method] if method else [name + "On", name + "Off"] if macro == "Boolean" else [macro[:3] + name]
        for each in names:
            methods[each] = comment
        comment = None
    return methods


@pytest.mark.parametrize("header", HEADERS, ids=lambda h: h.stem)
def test_every_public_method_of_the_header_is_there_with_its_comment(header):
    class_ = stubs()[header.stem]
    written = {node.name: ast.get_docstring(node) for node in class_.body if isinstance(node, ast.FunctionDef)}
    methods = declared(header)
    assert methods or "vtkAbstractTypeMacro" in header.read_text()
    for name, comment in methods.items():
        if name in ("New", "PrintSelf"):  # Python's own constructor, print()
            continue
        assert name in written, f"{header.stem}: no stub of {name}"
        if comment:
            start = " ".join(comment.split()[:6])
            assert start in " ".join((written[name] or "").split()), f"{header.stem}.{name} lacks {start!r}"
    brief = re.search(r"@brief\s+(.*)", header.read_text()).group(1)
    assert " ".join(brief.split()[:5]) in " ".join(ast.get_docstring(class_).split())


def test_there_are_headers():
    assert len(HEADERS) >= 12


def test_the_package_names_every_class_and_helper():
    tree = ast.parse((PACKAGE / "__init__.pyi").read_text())
    named = {alias.asname for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert named == {h.stem for h in HEADERS} | {"FilterError", "drawing", "show", "stroke", "strokes", "update"}
    assert named <= set(dir(oversketch))
    assert (PACKAGE / "py.typed").exists()


def checker(*arguments):
    environment = dict(os.environ)
    if str(PACKAGE.parent) not in site.getsitepackages():  # else py.typed alone must do
        environment["MYPYPATH"] = str(PACKAGE.parent)
    return subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True, env=environment)


def test_stubs_and_classes_agree(tmp_path):
    known = tmp_path / "known"  # static methods, which VTK's wrappers make without Python's staticmethod
    known.write_text(r"oversketch\.(\w+\.)*(IsTypeOf|SafeDownCast|GetNumberOfGenerationsFromBaseType|GetBackendWord|GetSystems|Compose)")
    done = checker("mypy.stubtest", "oversketch", "--ignore-missing-stub", "--allowlist", str(known),
                   "--mypy-config-file", str(settings(tmp_path)))
    assert done.returncode == 0, done.stdout + done.stderr


def settings(folder):
    """VTK 9.1 comes without stubs, 9.3 with some that mypy has complaints of; neither is ours to check."""
    file = folder / "mypy.ini"
    file.write_text(f"[mypy]\ncache_dir = {folder}/cache\n[mypy-vtkmodules.*]\nignore_missing_imports = True\nfollow_imports = skip\n")
    return file


PROGRAM = """
import oversketch
system = oversketch.vtkOversketchOneStroke()
system.SetBackend(oversketch.vtkOversketchOneStroke.Host)
kept: bool = system.GetRemeshed()
try:
    oversketch.update(system, port=0)
except oversketch.FilterError as error:
    print(error.messages[0].upper(), error.code + 1)
"""
WRONG = {
    'system.SetBackend("host")\n': "arg-type",
    "count: int = system.GetInnerOutputName(0)\n": "assignment",
    "system.SetRemesh()\n": "call-arg",
    "oversketch.vtkOversketchTwoStrokes()\n": "attr-defined",
    'oversketch.stroke([[0, 0], [1, 1]], None, "large")\n': "arg-type",
}


def test_a_checker_accepts_a_right_program_and_refuses_wrong_ones(tmp_path):
    for k, (line, error) in enumerate([("", ""), *WRONG.items()]):
        program = tmp_path / f"program{k}.py"
        program.write_text(PROGRAM + line)
        done = checker("mypy", "--strict", "--config-file", str(settings(tmp_path)), str(program))
        assert (done.returncode == 0) == (not line), done.stdout + done.stderr
        assert f"[{error}]" in done.stdout or not line, done.stdout
