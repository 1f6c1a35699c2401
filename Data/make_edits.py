#!/usr/bin/python3
"""Makes the lines and rings that edit: Data/Strokes/<model>_<what>.vtp and <model>_<what>_ring.vtp.

    make_edits.py [--only NAME] [--to FOLDER]

A line is drawn over the model in its view, and the ring round it in the same one, by the pen of make_strokes.py; the ring closes
where it began. Courses are lines over the model.
Needs numpy and python3-vtk9, no display.
"""
import argparse
import os

import numpy as np
import vtk

from make_augmentations import cut, model, write
from make_strokes import HERE, View, pen, polydata, resample, smoothed


def ring_round(line, reach, count=160):
    """The closed curve so far round a line in the picture: half circles at its ends, its sides beside it."""
    along = np.gradient(smoothed(resample(line, np.linspace(0, 1, count)), 4), axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    middle, side = resample(line, np.linspace(0, 1, count)), np.column_stack([-along[:, 1], along[:, 0]])
    turns = np.linspace(0.0, np.pi, 40)[1:-1, None]
    last = middle[-1] + reach * (np.cos(turns) * side[-1] + np.sin(turns) * along[-1])
    first = middle[0] - reach * (np.cos(turns) * side[0] + np.sin(turns) * along[0])
    loop = np.vstack([middle + reach * side, last, (middle - reach * side)[::-1], first])
    start = len(loop) // 5  # not where the line begins
    return np.vstack([loop[start:], loop[:start + 1]])


def dinosaur_crest():
    """Along the dinosaur's back, seen from above and the side: the line, and how far round it the ring is [px]."""
    outline = cut(model("dinosaur"), np.array([0.0, 1.0, 0.0]), (0, 0, 1))
    back = outline[(outline[:, 0] > -0.42) & (outline[:, 0] < 0.42) & (outline[:, 1] > 1.0)]
    view = View((0.0, 9.0, 4.0), (0.0, 1.3, 0.0), scale=330)
    return view, view.display(back[np.argsort(back[:, 0])]), 48.0


# Of each edit the view, the line in the picture and how far round it the ring is; "NAME_ring" is that ring.
EDITS = {"dinosaur_crest": dinosaur_crest}


def make(name):
    """The line, or the ring, of a name."""
    edit = name[:-len("_ring")] if name.endswith("_ring") else name
    view, line, reach = EDITS[edit]()
    seed = 2 * sorted(EDITS).index(edit)
    if edit == name:
        return polydata(*pen(line, seed), view)
    return polydata(*pen(ring_round(line, reach), seed + 1), view)


def main():
    names = [name + end for name in EDITS for end in ("", "_ring")]
    parser = argparse.ArgumentParser(description="Makes the lines and rings of Data/Strokes that edit.")
    parser.add_argument("--only", choices=sorted(names), help="make one of them")
    parser.add_argument("--to", default=HERE, help="folder to write to")
    options = parser.parse_args()
    for name in [options.only] if options.only else names:
        stroke, writer = make(name), vtk.vtkXMLPolyDataWriter()
        writer.SetDataModeToBinary()
        write(writer, os.path.join(options.to, "Strokes"), name + ".vtp", stroke)
        print(f"{name}: {stroke.GetNumberOfPoints()} samples")


if __name__ == "__main__":
    main()
