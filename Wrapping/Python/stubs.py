#!/usr/bin/python3
"""Writes the type stubs of the package `oversketch`, with the headers' comments, from what VTK's wrappers say of themselves.

    stubs.py FOLDER     FOLDER is the package's; each Oversketch*.so gets its .pyi there, and the package its __init__.pyi
"""
import importlib
import inspect
import keyword
import pathlib
import pkgutil
import re
import sys
import textwrap

import vtkmodules

PLAIN = {"None", "bool", "bytes", "float", "int", "str"}


def signatures(name, text):
    """The Python signatures and the comment of a method's documentation."""
    lines = (text or "").splitlines()
    found, comment, k = [], [], 0
    while k < len(lines):
        if lines[k].startswith((name + "(", "C++: ")):  # a long one goes on in indented lines
            whole = lines[k]
            while k + 1 < len(lines) and lines[k + 1].startswith("    "):
                k += 1
                whole += " " + lines[k].strip()
            if not whole.startswith("C++: "):
                found.append(whole)
        else:
            comment.append(lines[k])
        k += 1
    return found, "\n".join(comment).strip()


class Module:
    """The stub of one extension module."""

    def __init__(self, module):
        self.module, self.imports, self.typing = module, set(), set()
        self.classes = [c for _, c in sorted(vars(module).items()) if inspect.isclass(c) and c.__module__ == module.__name__]

    def type(self, written, returned):
        """A type as the wrappers write it, as an annotation."""
        written = written.strip()
        if written[0] in "([":
            parts = [self.type(part, returned) for part in written[1:-1].split(",")]
            if not returned:
                name = "Sequence" if written[0] == "(" else "MutableSequence"
                self.typing.add(name)
                return f"{name}[{parts[0]}]"
            name = "Tuple" if written[0] == "(" else "List"
            self.typing.add(name)
            return f"{name}[{', '.join(parts if name == 'Tuple' else parts[:1])}]"
        if written in PLAIN or written in (c.__name__ for c in self.classes):
            return written
        if re.fullmatch(r"vtk\w+", written):
            self.imports.add(written)
            return written
        if written == "callable":
            self.typing.update(("Any", "Callable"))
            return "Callable[..., Any]"
        raise ValueError(f"{self.module.__name__}: no annotation for the type {written!r}")

    def method(self, name, text):
        found, comment = signatures(name, text)
        if not found:
            raise ValueError(f"{self.module.__name__}: no signature of {name} in {text!r}")
        for signature in found:
            arguments, returned = re.fullmatch(r"\w+\((.*)\) -> (.*)", signature).groups()
            written, static = [], True
            for argument in re.split(r",\s*(?![^(\[]*[)\]])", arguments) if arguments else []:
                if argument == "self":
                    static = False
                    written.append(argument)
                    continue
                known, _, type_ = argument.partition(":")
                type_, _, default = type_.partition("=")
                known = known + "_" if keyword.iskeyword(known) else known
                written.append(f"{known}: {self.type(type_, False)}" + (" = ..." if default else ""))
            if len(written) > (not static):  # wrapped methods take their arguments by place alone
                written.append("/")
            if len(found) > 1:
                self.typing.add("overload")
                yield "@overload"
            if static:
                yield "@staticmethod"
            yield f"def {name}({', '.join(written)}) -> {self.type(returned, True)}:"
            yield from documented(comment)

    def class_(self, class_):
        base = class_.__bases__[0]
        if base not in self.classes:
            self.imports.add(base.__name__)
        yield f"class {class_.__name__}({base.__name__}):"
        yield from documented(class_.__doc__, ended=False)
        for name, value in vars(class_).items():
            if inspect.isclass(value) and issubclass(value, int):
                self.typing.add("final")
                yield "    @final"
                yield f"    class {name}(int): ..."
            elif inspect.isroutine(value) and not name.startswith("__"):
                yield from ("    " + line for line in self.method(name, value.__doc__))
            elif isinstance(value, int):
                yield f"    {name}: {type(value).__name__}"
        yield ""

    def text(self, homes):
        body = [line.rstrip() for class_ in self.classes for line in self.class_(class_)]
        head = [f"from typing import {', '.join(sorted(self.typing))}"] if self.typing else []
        head += sorted(f"from {homes(name)} import {name}" for name in self.imports)
        return "\n".join(head + [""] + body)


def documented(text, ended=True):
    """The body of a definition that has this comment."""
    text = (text or "").replace("\\", "\\\\").replace('"""', "'''").strip()
    if text:
        yield from textwrap.indent(f'"""{text}\n"""' if "\n" in text or text.endswith('"') else f'"""{text}"""', "    ").splitlines()
    if ended or not text:
        yield "    ..."


class Homes:
    """Where a class is imported from, seen from inside the package."""

    def __init__(self, modules):
        self.known = {}
        for module in [m for m in sys.modules.values() if m.__name__.startswith("vtkmodules.vtk")]:
            self.add(module, module.__name__)
        for module in modules:
            self.add(module, "." + module.__name__.partition(".")[2])
        self.waiting = [f"vtkmodules.{m.name}" for m in pkgutil.iter_modules(vtkmodules.__path__) if m.name.startswith("vtk")]

    def add(self, module, name):
        self.known.update((each, name) for each in vars(module) if each.startswith("vtk"))

    def __call__(self, name):
        while name not in self.known and self.waiting:  # VTK's modules are loaded only until it is found
            try:
                module = importlib.import_module(self.waiting.pop(0))
            except ImportError:  # needs what is not installed, such as mpi4py
                continue
            self.add(module, module.__name__)
        if name not in self.known:
            raise ValueError(f"{name} is in no module of the package vtkmodules")
        return self.known[name]


def main(folder):
    sys.path.insert(0, str(folder.parent))
    modules = [importlib.import_module(f"oversketch.{file.name.partition('.')[0]}") for file in sorted(folder.glob("Oversketch*.so"))]
    homes = Homes(modules)
    package = ["from ._show import show as show",
               "from ._stroke import drawing as drawing, stroke as stroke, strokes as strokes",
               "from ._update import FilterError as FilterError, update as update"]
    for module in modules:
        stub = Module(module)
        name = module.__name__.partition(".")[2]
        (folder / f"{name}.pyi").write_text(stub.text(homes))
        package += [f"from .{name} import {c.__name__} as {c.__name__}" for c in stub.classes]
    (folder / "__init__.pyi").write_text("\n".join(sorted(package) + ["", "__version__: str", ""]))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
