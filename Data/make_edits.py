#!/usr/bin/python3
"""Makes the lines and rings that edit: Data/Strokes/<model>_<what>.vtp and <model>_<what>_ring.vtp, and what goes with them in Data/Edits.

    make_edits.py [--only NAME] [--to FOLDER]

A line is drawn over the model in its view, and the ring round it in the same one, by the pen of make_strokes.py; the ring closes
where it began. Courses are lines over the model. Of Data/Edits, <name>.json holds grey layers, <name>_area.vtp an area of the disc that has
layers of its own, <name>.png weights painted on the disc, <name>_profile.vtp a cross-section drawn anew.
Needs numpy and python3-vtk9, no display.
"""
import argparse
import json
import os

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

from make_augmentations import cut, in_plane, model, rounded, write
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


def along_the_back(name, middle, span, lowest, view):
    """From tail to head over an animal, between two x."""
    outline = cut(model(name), np.array([0.0, middle, 0.0]), (0, 0, 1))
    back = outline[(outline[:, 0] > span[0]) & (outline[:, 0] < span[1]) & (outline[:, 1] > lowest)]
    return view.display(back[np.argsort(back[:, 0])])


def marked(view, places):
    """Through places marked out by hand in the picture plane, (right, up) from the view's focus."""
    return view.display(rounded(in_plane(view, places)))


def dinosaur_crest():
    """Along the dinosaur's back, seen from above and the side."""
    view = View((0.0, 9.0, 4.0), (0.0, 1.3, 0.0), scale=330)
    return view, along_the_back("dinosaur", 1.0, (-0.42, 0.42), 1.0, view), 48.0


def dog_back():
    """Along the dog's back, seen alike; the ring goes out of sight on the other side."""
    view = View((-0.05, 7.0, 3.5), (-0.05, 0.95, 0.0), scale=480)
    return view, along_the_back("dog", 0.85, (-0.38, 0.22), 0.9, view), 66.0


def hand_palm():
    """Bent down the palm."""
    view = View((0.0, -0.2, 9.0), (0.0, -0.15, 0.0), scale=280)
    return view, marked(view, [(0.15, 0.14), (0.06, 0.08), (-0.01, -0.02), (-0.03, -0.14)]), 64.0


def octopus_mantle():
    """Down the mantle, between and above the eyes."""
    view = View((0.0, 4.6, 6.0), (0.0, 1.0, -0.1), scale=400)
    return view, marked(view, [(-0.02, 0.2), (0.0, 0.08), (0.02, -0.04)]), 105.0


def person_belly():
    """Across the belly, in perspective."""
    view = View((0.0, 1.1, 9.0), (0.0, 1.12, 0.0), angle=12)
    return view, marked(view, [(-0.04, 0.02), (0.0, 0.028), (0.04, 0.02)]), 43.0


# Of each edit the view, the line in the picture and how far round it the ring is [px]; "NAME_ring" is that ring.
EDITS = {edit.__name__: edit for edit in (dinosaur_crest, dog_back, hand_palm, octopus_mantle, person_belly)}


def layers(*handles, levels=5, **more):
    return {"levels": levels, "handles": [list(pair) for pair in handles], **more}


def circle(middle, radius):
    turns = np.linspace(0.0, 2.0 * np.pi, 60)
    return np.asarray(middle) + radius * np.column_stack([np.cos(turns), np.sin(turns)])


def flat(line):
    """A polyline in a plane, without a view: on the disc, or of a cross-section."""
    points, cells, data = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetDataTypeToDouble()
    cells.InsertNextCell(len(line))
    for x, y in line:
        cells.InsertCellPoint(points.InsertNextPoint(x, y, 0.0))
    data.SetPoints(points)
    data.SetLines(cells)
    return data


def warts(side=128, count=13):
    """Soft dots on the disc, in the order of a sunflower's seeds, the outer ones smaller: an image of 8 bits."""
    v, u = (np.mgrid[0:side, 0:side] + 0.5) * 2.0 / side - 1.0
    grey = np.zeros((side, side))
    for k in range(1, count + 1):
        far, turn = 0.74 * np.sqrt(k / count), k * np.pi * (3.0 - np.sqrt(5.0))
        off = np.hypot(u - far * np.cos(turn), v - far * np.sin(turn)) / (0.23 - 0.07 * far)
        grey = np.maximum(grey, np.clip(1.0 - off * off, 0.0, 1.0) ** 2)
    return image(grey)


def image(grey):
    """Of 8 bits, from what lies between 0 and 1."""
    made = vtk.vtkImageData()
    made.SetDimensions(grey.shape[1], grey.shape[0], 1)
    made.GetPointData().SetScalars(numpy_to_vtk((255.0 * grey).round().astype(np.uint8).ravel(), deep=True))
    return made


def painted(pattern, side=64):
    """A pattern of a place's way from the disc's middle and its turn, which fades towards the rim."""
    v, u = (np.mgrid[0:side, 0:side] + 0.5) * 2.0 / side - 1.0
    far = np.hypot(u, v)
    return image(np.clip(pattern(far, np.arctan2(v, u)), 0.0, 1.0) * np.clip(1.2 * (1.0 - far * far), 0.0, 1.0))


def rings(far, turn):
    return 0.5 + 0.5 * np.cos(4.0 * np.pi * far)


def petals(far, turn):
    return np.clip(2.0 * (0.75 + 0.2 * np.cos(5.0 * turn) - far), 0.0, 1.0)


def spiral(far, turn):
    return 0.5 + 0.5 * np.cos(turn - 4.0 * np.pi * far)


def waves(far, turn):
    return 0.5 - 0.5 * np.cos(3.0 * np.pi * far * np.cos(turn))


# What goes with an edit: file of Data/Edits, and its contents.
KEEL = [(0.0, 0.0), (0.09, 0.118), (0.21, 0.195), (0.34, 0.27), (0.44, 0.42), (0.50, 0.49), (0.56, 0.42), (0.66, 0.27), (0.79, 0.195),
        (0.91, 0.118), (1.0, 0.0)]
BESIDE = {
    "dinosaur_crest.json": lambda: layers((0.5, 0.34), levels=7),
    "dog_back_profile.vtp": lambda: flat(rounded(np.array(KEEL))),
    "octopus_mantle.png": warts,
    "person_belly.json": lambda: layers((0.4, 0.6), areas=[{"stroke": "person_belly_area.vtp", "levels": 3, "handles": [[0.45, 0.45]]}]),
    "person_belly_area.vtp": lambda: flat(circle((0.16, 0.34), 0.13)),
}

# Further ones on the same lines and rings, so that each of the five models has layers, painted weights and a cross-section. A section is
# places beside the middle, the same on both sides.
def section(*half):
    left = np.array(half)
    return flat(rounded(np.vstack([left, left[-2::-1] * [-1.0, 1.0] + [1.0, 0.0]])))


BESIDE.update({
    "dinosaur_crest_painted.png": lambda: painted(waves),
    "dinosaur_crest_section.vtp": lambda: section((0.0, 0.0), (0.1, 0.055), (0.22, 0.11), (0.31, 0.19), (0.37, 0.22), (0.43, 0.19), (0.5, 0.15)),
    "dog_back_layers.json": lambda: layers((0.5, 0.75), levels=6),
    "dog_back_painted.png": lambda: painted(petals),
    "hand_palm_layers.json": lambda: layers((0.3, 0.15), (0.7, 0.85)),
    "hand_palm_painted.png": lambda: painted(spiral),
    "hand_palm_section.vtp": lambda: section((0.0, 0.0), (0.15, 0.0), (0.28, -0.01), (0.38, -0.05), (0.45, -0.11), (0.5, -0.12)),
    "octopus_mantle_layers.json": lambda: layers((0.5, 0.25), levels=8),
    "octopus_mantle_section.vtp": lambda: section((0.0, 0.0), (0.1, 0.065), (0.22, 0.12), (0.34, 0.16), (0.43, 0.24), (0.5, 0.27)),
    "person_belly_painted.png": lambda: painted(rings),
    "person_belly_section.vtp": lambda: section((0.0, 0.0), (0.15, -0.02), (0.3, 0.0), (0.41, 0.08), (0.5, 0.11)),
})


def make(name):
    """The line, or the ring, of a name, or what stands in BESIDE."""
    if name in BESIDE:
        return BESIDE[name]()
    edit = name[:-len("_ring")] if name.endswith("_ring") else name
    view, line, reach = EDITS[edit]()
    seed = 2 * sorted(EDITS).index(edit)
    if edit == name:
        return polydata(*pen(line, seed), view)
    return polydata(*pen(ring_round(line, reach), seed + 1), view)


def keep(folder, name, data):
    """Writes what was made; a name without an ending is a stroke's."""
    if name.endswith(".json"):
        os.makedirs(os.path.join(folder, "Edits"), exist_ok=True)
        with open(os.path.join(folder, "Edits", name), "w") as file:
            json.dump(data, file)
            file.write("\n")
    elif name.endswith(".png"):
        write(vtk.vtkPNGWriter(), os.path.join(folder, "Edits"), name, data)
    else:
        writer = vtk.vtkXMLPolyDataWriter()
        writer.SetDataModeToBinary()
        write(writer, os.path.join(folder, "Edits" if name in BESIDE else "Strokes"), name if name in BESIDE else name + ".vtp", data)


def main():
    names = [name + end for name in EDITS for end in ("", "_ring")] + list(BESIDE)
    parser = argparse.ArgumentParser(description="Makes the lines and rings of Data/Strokes that edit, and Data/Edits.")
    parser.add_argument("--only", choices=sorted(names), help="make one of them")
    parser.add_argument("--to", default=HERE, help="folder to write to")
    options = parser.parse_args()
    for name in [options.only] if options.only else names:
        keep(options.to, name, make(name))
        print(name)


if __name__ == "__main__":
    main()
