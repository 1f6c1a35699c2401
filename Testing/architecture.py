#!/usr/bin/env python3
"""Keeps the picture in ARCHITECTURE.md true: libraries and programs of a build folder, with what they are linked to.

    architecture.py BUILD            writes the picture
    architecture.py BUILD --check    exit code 1 when it is not that of the build
"""
import pathlib
import re
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parents[1] / "ARCHITECTURE.md"
BEGIN, END = "<!-- written by Testing/architecture.py -->\n", "<!-- end -->"
ROOMS = {"Applications": r"oversketch|Session", "Widgets": r"Widgets", "Filters": r"Filters", "Kernels": r"Kernels"}


def needed(path):
    """The names of our libraries that a library or program is linked to."""
    dynamic = subprocess.run(["readelf", "-d", str(path)], check=True, capture_output=True, text=True).stdout
    return set(re.findall(r"\(NEEDED\).*\[libOversketch(\w+)\.so", dynamic))


def graph(build):
    files = {path.name[len("libOversketch"):-len(".so")]: path for path in (build / "lib").glob("libOversketch*.so")}
    files.update({name: build / "bin" / name for name in ("oversketch", "oversketch-studio")})
    direct = {name: needed(path) for name, path in sorted(files.items())}

    def reach(name):
        return direct[name].union(*(reach(other) for other in direct[name]))

    # Without the arrows that another path says too.
    return {name: {n for n in others if not any(n in reach(o) for o in others - {n})} for name, others in direct.items()}


def picture(arrows):
    lines = ["```mermaid", "graph TD"]
    for room, pattern in ROOMS.items():
        lines.append(f"  subgraph room_{room} [{room}]")
        lines += [f"    {name.replace('-', '_')}[{name}]" for name in arrows if re.match(pattern, name)]
        lines.append("  end")
    for name, others in arrows.items():
        lines += [f"  {name.replace('-', '_')} --> {other}" for other in sorted(others)]
    return "\n".join(lines + ["```", ""])


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    text = PAGE.read_text()
    head, rest = text.split(BEGIN)
    made = head + BEGIN + picture(graph(pathlib.Path(sys.argv[1]))) + END + rest.split(END, 1)[1]
    if sys.argv[2:]:
        if made != text:
            sys.exit("ARCHITECTURE.md shows other libraries than the build has: run Testing/architecture.py BUILD")
    else:
        PAGE.write_text(made)
