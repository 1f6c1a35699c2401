"""Records what Testing/Bits/test_bits.py compares with.

    record.py [--group NAME]   digests of what the build makes on this platform (some minutes)
    record.py --anew           the same after what is made has changed: figures, too, and rows that have changed here are dropped
                               of other platforms
    record.py --strokes        strokes.vtp: some of the strokes that the acceptance run draws, spread over its models

With PYTHONPATH and OVERSKETCH_COMMAND naming a build, as ctest does: a build of the sources whose bits are to be kept, not
of changed ones. A platform that is known already is recorded anew.
"""
from __future__ import annotations

import argparse
import sys
from typing import Dict, List

from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import bits
from recorded import Digests, Figures, Recorded

sys.path.insert(0, str(bits.HERE.parent / "Acceptance" / "one_stroke"))
import meshes  # noqa: E402
import strokes  # noqa: E402

COUNT = 40
LARGE = 20000  # triangles; of such a model one stroke will do


def choose() -> None:
    """Two strokes a model, the first and the third, so that both projections and all kinds occur; COUNT in all."""
    together, names = vtkAppendPolyData(), vtkStringArray()
    names.SetName("Name")
    for number, (name, path, up) in enumerate(meshes.models()):
        mesh = meshes.read(path)
        made = strokes.strokes_for(name, mesh, up, number)
        for stroke, note in made[:1] if mesh.GetNumberOfPolys() > LARGE and path.parent != meshes.DATA / "Models" else made[::2]:
            if names.GetNumberOfValues() < COUNT:
                stroke.GetFieldData().Initialize()
                together.AddInputData(stroke)
                names.InsertNextValue(note["name"])
    together.Update()
    together.GetOutput().GetCellData().AddArray(names)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(bits.HERE / "strokes.vtp"))
    writer.SetInputData(together.GetOutput())
    writer.Write()
    print(names.GetNumberOfValues(), "strokes:", *(names.GetValue(k) for k in range(names.GetNumberOfValues())))


def record(arguments: List[str], anew: bool) -> int:
    rows: Dict[str, Dict[str, bits.Row]] = {}
    for backend in bits.BACKENDS:
        runs = [bits.Process(backend, 1, "--all", *arguments), bits.Process(backend, 2, "--all", "--cold", *arguments)]
        (one, said), (two, _) = [each.rows() for each in runs]
        print(said, end="")
        differ = [name for name in one if one[name] != two[name]]
        if differ:
            print(f"{backend}: other bits on two threads, or in a filter that ran before: {', '.join(differ)}")
            return 1
        rows[backend] = one
    recorded, platform = Recorded(), bits.platform()
    if anew:
        recorded.figures = {}
    known = recorded.on(platform)
    if known is None:
        known = {}
        recorded.platforms.append((platform, known))
    for name, made in rows["embree"].items():
        recorded.figures.setdefault(name, Figures(made.points, made.triangles, made.bounds, made.moved))
        by = {backend: rows[backend][name] for backend in bits.BACKENDS}
        digests = Digests(made.input, {b: each.mesh for b, each in by.items()}, {b: each.arrays for b, each in by.items()})
        if anew and known.get(name) != digests:
            for _, there in recorded.platforms:
                there.pop(name, None)
        known[name] = digests
    recorded.platforms = [(other, there) for other, there in recorded.platforms if there]
    recorded.write()
    print(f"{len(rows['embree'])} rows recorded of {platform}")
    return 0


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--strokes", action="store_true")
    what = arguments.add_mutually_exclusive_group()
    what.add_argument("--group", choices=bits.GROUPS)
    what.add_argument("--anew", action="store_true")
    options = arguments.parse_args()
    if options.strokes:
        choose()
        return 0
    return record(["--group", options.group] if options.group else [], options.anew)


if __name__ == "__main__":
    sys.exit(main())
