#!/usr/bin/env python3
"""How much memory the Studio takes with a model of 1.7 million triangles: the shipped dog, each of its triangles made 64.

usage: memory.py [--tip]     needs a display, a session bus, and the environment of the tests (OVERSKETCH_STUDIO, OVERSKETCH_SOURCE,
                             OVERSKETCH_TEMPORARY)

Opens it, draws the tail longer, then a foreleg; with --tip the second stroke is over the tip of that tail, which moves some 30,000
vertices more. Prints a row for each: the highest resident size on the way, that at rest [MB = 1024 KiB x 1024], and the time that
processors worked [s]. The result's digest comes last: it is that of any other build which makes the same bits.
"""
import pathlib
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter  # noqa: E402
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter  # noqa: E402

from desk import until  # noqa: E402
from sitting import DOG, TAIL, Sitting, arc  # noqa: E402

FORELEG = arc(584, 535, -70, 34)  # on the dog as it opens
TIP = arc(193, 130, 90, 20, lean=8)


def make_model(path):
    reader, finer, writer = vtkPLYReader(), vtkLoopSubdivisionFilter(), vtkPLYWriter()
    reader.SetFileName(str(DOG))
    finer.SetInputConnection(reader.GetOutputPort())
    finer.SetNumberOfSubdivisions(3)
    writer.SetInputConnection(finer.GetOutputPort())
    writer.SetFileName(str(path))
    writer.SetFileTypeToBinary()
    writer.Write()
    return finer.GetOutput().GetNumberOfPolys()


def resident(process, key):
    """A line of its status [MB]."""
    for line in open(f"/proc/{process}/status"):
        if line.startswith(key + ":"):
            return int(line.split()[1]) / 1024
    raise KeyError(key)


def worked(process):
    """Seconds of processors."""
    fields = open(f"/proc/{process}/stat").read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / 100


def rest(process):
    """Waits until it has done nothing for three seconds."""
    last, still = worked(process), 0
    while still < 6:
        time.sleep(0.5)
        now = worked(process)
        still = still + 1 if now - last < 0.03 else 0
        last = now


def main():
    if sys.argv[1:] not in ([], ["--tip"]):
        sys.exit(__doc__)
    folder = pathlib.Path(tempfile.mkdtemp())
    model = folder / "dog_1700k.ply"
    print(f"{make_model(model):,} triangles\n")
    sitting = Sitting(folder / "home")
    sitting.start(model)
    process = sitting.studio.process.pid
    until(sitting.session, "the model", 600)
    print("| | highest | at rest | processors |\n|---|---|---|---|")

    def row(what):
        rest(process)
        print(f"| {what} | {resident(process, 'VmHWM'):,.0f} | {resident(process, 'VmRSS'):,.0f} | {worked(process):.1f} |", flush=True)
    row("opened")
    sitting.fit()
    sitting.alone()
    for count, stroke in enumerate([TAIL, TIP if sys.argv[1:] else FORELEG], 1):
        rest(process)
        sitting.draw(stroke)
        until(lambda: sitting.session() and len(sitting.session()["strokes"]) == count, "a stroke", 1200)
        row(f"stroke {count}")
    sitting.shot("memory")
    print("\n" + sitting.session()["result_md5"])
    sitting.studio.kill()


main()
