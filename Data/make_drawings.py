#!/usr/bin/python3
"""Makes the drawings over pictures: Data/Drawings/<name>.png and <name>.vtp, and figure.json, which puts three of them together.

    make_drawings.py [--only NAME] [--to FOLDER]

The pictures are painted by drawings.py, which knows where their edges are; along them, or a little beside, goes the pen of make_strokes.py.
A file holds several polylines in display px of the picture's own view: the camera looks along -z at exactly the picture's rectangle, whose
samples lie at (i, j, 0), so that display px are the picture's px from its lower left corner. A closed stroke repeats its first point id at the
end. Cell arrays Treatment (0 fill, 1 hole, 2 tunnel), Magnetic (0, 1) and SnapRadius [image px] are there where they say something.
Needs numpy and python3-vtk9, no display.
"""
import argparse
import json
import os

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

from drawings import DRAWINGS, SNAP_RADIUS
from make_strokes import HERE, pen

# The parts of figure.json: where their pictures stand, in px of the first; y up, z towards the viewer.
FIGURE = {"figure_body": (0.0, 0.0, 0.0), "figure_head": (64.0, 370.0, 110.0), "figure_hat": (64.0, 740.0, 105.0)}


def view(width, height):
    """World to camera, camera to clip: a picture's own view."""
    far = 2.0 * max(width, height)
    camera = np.eye(4)
    camera[:3, 3] = -(width - 1) / 2, -(height - 1) / 2, -far / 2
    clip = np.diag([2.0 / width, 2.0 / height, -2.0 / far, 1.0])
    clip[2, 3] = -1.0
    return camera, clip


def polydata(strokes, size, cells, points):
    """Strokes in the own view of a picture of that size: of each the samples and whether it is closed; arrays of cells and of points."""
    lines, whole, place, first = vtk.vtkCellArray(), vtk.vtkPolyData(), vtk.vtkPoints(), 0
    for samples, closed in strokes:
        ids = [*range(first, first + len(samples)), *[first] * closed]
        lines.InsertNextCell(len(ids), ids)
        first += len(samples)
    place.SetData(numpy_to_vtk(np.pad(np.vstack([samples for samples, _ in strokes]), [(0, 0), (0, 1)]), deep=True))
    whole.SetPoints(place)
    whole.SetLines(lines)
    camera, clip = view(*size)
    each = {"ViewTransform": camera.ravel(), "ProjectionTransform": clip.ravel(), "ViewportSize": np.array(size, np.int32)}
    cells = {**{name: np.tile(value, (len(strokes), 1)) for name, value in each.items()}, **cells}
    for data, arrays in ((whole.GetPointData(), points), (whole.GetCellData(), cells)):
        for name, values in arrays.items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            data.AddArray(array)
    return whole


def drawn(drawing):
    """The drawing's lines as the pen draws them."""
    strokes, time, pressure = [], [], []
    for seed, line in enumerate(drawing.lines):
        path = np.vstack([line.course, line.course[:1]]) if line.closed else line.course
        samples = [values[:-1] if line.closed else values for values in pen(path, seed)]
        strokes.append((samples[0], line.closed))
        time.append(samples[1])
        pressure.append(samples[2])
    magnetic = np.array([line.edge is not None for line in drawing.lines], np.int32)
    treatment = np.array([line.treatment for line in drawing.lines], np.int32)
    cells = {"Treatment": treatment} if treatment.any() else {}
    if magnetic.any():
        cells.update({"Magnetic": magnetic, "SnapRadius": np.full(len(magnetic), SNAP_RADIUS)})
    return polydata(strokes, (drawing.picture.width, drawing.picture.height), cells,
                    {"Time": np.concatenate(time), "Pressure": np.concatenate(pressure).astype(np.float32)})


def figure():
    """What `oversketch assemble` reads: files beside it, what the system is given, a matrix by rows."""
    place = lambda shift: [[1.0, 0.0, 0.0, shift[0]], [0.0, 1.0, 0.0, shift[1]], [0.0, 0.0, 1.0, shift[2]], [0.0, 0.0, 0.0, 1.0]]
    return {"parts": [{"picture": name + ".png", "strokes": name + ".vtp", "parameters": {}, "placement": place(shift)}
                      for name, shift in FIGURE.items()]}


def write(writer, folder, name, data):
    writer.SetFileName(os.path.join(folder, name))
    writer.SetInputData(data)
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description="Makes the pictures of Data/Drawings and what is drawn over them.")
    parser.add_argument("--only", choices=[*sorted(DRAWINGS), "figure"], help="make one of them")
    parser.add_argument("--to", default=os.path.join(HERE, "Drawings"), help="folder to write to")
    options = parser.parse_args()
    os.makedirs(options.to, exist_ok=True)
    for name in [options.only] if options.only else [*DRAWINGS, "figure"]:
        if name == "figure":
            with open(os.path.join(options.to, "figure.json"), "w", encoding="utf-8") as file:
                json.dump(figure(), file, indent=1)
                file.write("\n")
            continue
        drawing, picture, lines = DRAWINGS[name](), vtk.vtkPNGWriter(), vtk.vtkXMLPolyDataWriter()
        picture.SetCompressionLevel(9)
        lines.SetDataModeToBinary()
        strokes = drawn(drawing)
        write(picture, options.to, name + ".png", drawing.picture.image())
        write(lines, options.to, name + ".vtp", strokes)
        print(f"{name}: {strokes.GetNumberOfCells()} strokes, {strokes.GetNumberOfPoints()} samples")


if __name__ == "__main__":
    main()
