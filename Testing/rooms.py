#!/usr/bin/env python3
"""Asks of the sources what no compiler asks: that the guard of each header is its room and file name, so that no two are the same, and
that a room includes headers only of rooms that it is linked to.

    rooms.py            exit code 1 where a guard or an include is not right, each named
    rooms.py --write    writes the guards
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PLACES = ("Applications", "Filters", "Kernels", "Testing", "Widgets", "Wrapping")
GUARD = re.compile(r"#ifndef (\w+)\n#define \1\b")


def sources(folder, ends):
    return sorted(p for end in ends for p in folder.rglob("*" + end))


def guard_of(path):
    """That of a class of VTK is its name, as VTK has it: such names are their own."""
    if path.stem.startswith("vtkOversketch"):
        return path.stem + "_h"
    parts = path.relative_to(ROOT).with_suffix("").parts
    if "tree" in parts:  # the toy system's, which is copied into a tree
        parts = parts[parts.index("tree") + 1:]
    return "_".join(["oversketch", *(re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", part).lower() for part in parts), "h"])


def guards(write):
    """The headers whose guard is another; mended where asked."""
    wrong = []
    for place in PLACES:
        for path in sources(ROOT / place, [".h"]):
            text, due = path.read_text(), guard_of(path)
            found = GUARD.search(text)
            if found and found.group(1) == due:
                continue
            if write and found:
                path.write_text(text[:found.start()] + f"#ifndef {due}\n#define {due}" + text[found.end():])
            else:
                wrong.append(f"{path.relative_to(ROOT)}: the guard is to be {due}")
    return wrong


def words(text, key):
    """What stands after a keyword of CMake, up to the next one or the end of the call."""
    return [word for part in re.findall(rf"\b{key}\s+((?:[\w:./${{}}]+\s*)*)", text)
            for word in re.split(r"\b[A-Z]+_?[A-Z]+\b(?!:)", part)[0].split()]


class Links:
    """What rooms are linked to, by the build's own files: name of a target to those of its interface, and to all."""

    def __init__(self):
        self.public, self.every, self.folder = {}, {}, {}
        for file in ROOT.glob("Kernels/*/CMakeLists.txt"):
            call = re.search(r"oversketch_kernel\(.*?\)", file.read_text(), re.S).group()
            self.add("Oversketch::Kernels" + file.parent.name, file.parent, words(call, "PUBLIC"), words(call, "PRIVATE"))
        for file in [*ROOT.glob("Filters/*/vtk.module"), *ROOT.glob("Widgets/*/vtk.module")]:
            text, build = file.read_text(), (file.parent / "CMakeLists.txt").read_text()
            public = words(text, r"(?<!_)DEPENDS") + words(build, "PUBLIC")
            private = words(text, "PRIVATE_DEPENDS") + words(build, "KERNELS") + words(build, "PRIVATE")
            self.add(words(text, "NAME")[0], file.parent, public, private)

    def add(self, name, folder, public, private):
        self.public[name], self.every[name], self.folder[name] = set(public), set(public) | set(private), folder

    def interface(self, names):
        """These and all that comes with them."""
        seen, left = set(), list(names)
        while left:
            name = left.pop()
            if name not in seen:
                seen.add(name)
                left += self.public.get(name, ())
        return seen


def rooms_of_headers(links):
    """{header as it is included: its room}."""
    found = {}
    for name, folder in links.folder.items():
        for path in folder.glob("*.h"):
            found[f"{folder.name}/{path.name}" if "::Kernels" in name else path.name] = name
    return found


def includes(path, homes):
    """(line, room) of each header of a room."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        found = re.match(r'#include "(\S+)"', line)
        if found and found.group(1) in homes:
            yield number, homes[found.group(1)]


def unlinked():
    """The includes of rooms that are not linked."""
    links, wrong = Links(), []
    homes = rooms_of_headers(links)

    def look(path, allowed):
        for number, room in includes(path, homes):
            if room not in allowed:
                wrong.append(f"{path.relative_to(ROOT)}:{number}: {room} is included and not linked")

    for name, folder in links.folder.items():
        for path in folder.glob("*.h"):
            look(path, links.interface([name, *links.every[name]]))
        tests = links.interface(re.findall(r"Oversketch::\w+", "".join(
            file.read_text() for file in (folder / "CMakeLists.txt", folder / "Testing" / "CMakeLists.txt") if file.exists())) + [name])
        for path in [*folder.glob("*.cxx"), *folder.glob("Testing/*.cxx"), *folder.glob("Testing/*.h")]:
            look(path, tests if path.stem.endswith("_test") or path.parent.name == "Testing"
                 else links.interface([name, *links.every[name]]))
    # The applications: what a folder's build file names, and what the libraries that it links bring.
    applications = {"oversketch_files": "Files", "oversketch_session": "Session"}
    for folder in sorted(p.parent for p in (ROOT / "Applications").glob("*/CMakeLists.txt")):
        text = (folder / "CMakeLists.txt").read_text()
        for library, place in applications.items():
            if library in text:
                text += (ROOT / "Applications" / place / "CMakeLists.txt").read_text()
        allowed = links.interface(re.findall(r"Oversketch::\w+", text))
        if "oversketch_name_systems" in text:  # whose headers those files see that name systems
            allowed |= {name for name, every in links.every.items() if "Oversketch::FiltersSystems" in every}
        for path in sources(folder, [".cxx", ".h"]):
            look(path, allowed)
    return wrong


if __name__ == "__main__":
    if sys.argv[1:] not in ([], ["--write"]):
        sys.exit(__doc__)
    faults = guards(bool(sys.argv[1:])) + unlinked()
    print("\n".join(faults) or "Guards are rooms and file names; what is included is linked.")
    sys.exit(1 if faults else 0)
