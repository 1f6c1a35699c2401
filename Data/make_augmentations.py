#!/usr/bin/python3
"""Makes the strokes that augment, Data/Strokes/<model>_<what>.vtp, and the height image Data/Terrain/valley.png.

    make_augmentations.py [--only NAME] [--to FOLDER]

Each stroke is drawn over its own view, as those of make_strokes.py, by the same pen, and says in the cell arrays Radius, Height [model
length] and Sharpness what it makes; those of a silhouette have no Height. Courses are lines over the model, most of them marked out by hand
as points in the view's picture plane.
Needs numpy and python3-vtk9, no display.
"""
import argparse
import os

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import erosion
from make_strokes import HERE, HEIGHT, WIDTH, View, outlines, pen, polydata, resample, section, smoothed

GRAY = 0.0008  # height of one unit of gray in valley.png; a sample is one unit wide


class Stroke:
    """A course, points in the world, over a view, and what is made of it."""

    def __init__(self, view, course, radius, height=None, sharpness=1.5):
        self.view, self.course, self.radius, self.height, self.sharpness = view, np.asarray(course, float), radius, height, sharpness


def rounded(points):
    """A curve through points (Catmull and Rom's), 20 steps to each."""
    p = np.vstack([2 * points[0] - points[1], points, 2 * points[-1] - points[-2]])
    t = np.arange(20)[:, None] / 20.0
    parts = [0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t ** 2 + (3 * b - a - 3 * c + d) * t ** 3)
             for a, b, c, d in zip(p, p[1:], p[2:], p[3:])]
    return np.vstack([*parts, points[-1:]])


def in_plane(view, places):
    """Points of the picture plane through the view's focus: (right, up) from it [model length]."""
    places = np.asarray(places, float)
    return view.focus + places @ view.view[:2, :3]


def model(name):
    reader = vtk.vtkPLYReader()
    reader.SetFileName(os.path.join(HERE, "Models", name + ".ply"))
    reader.Update()
    return reader.GetOutput()


def strips(source):
    """The lines that a filter puts out, joined: arrays of points."""
    strip, ids = vtk.vtkStripper(), vtk.vtkIdList()
    strip.SetInputConnection(source.GetOutputPort())
    strip.SetMaximumLength(10 ** 6)
    strip.Update()
    points, lines = vtk_to_numpy(strip.GetOutput().GetPoints().GetData()).astype(float), []
    for i in range(strip.GetOutput().GetNumberOfCells()):
        strip.GetOutput().GetCellPoints(i, ids)
        lines.append(points[[ids.GetId(j) for j in range(ids.GetNumberOfIds())]])
    return lines


def cut(mesh, origin, normal):
    """The loop nearest to `origin` that a plane cuts out of the mesh; its first point stands once."""
    plane, cutter = vtk.vtkPlane(), vtk.vtkCutter()
    plane.SetOrigin(*origin)
    plane.SetNormal(*normal)
    cutter.SetInputData(mesh)
    cutter.SetCutFunction(plane)
    return min((loop[:-1] for loop in strips(cutter)), key=lambda loop: np.linalg.norm(loop.mean(axis=0) - origin))


def level(image, gray, first, last):
    """The part of an image's contour between the points nearest to two places (x, y)."""
    contour = vtk.vtkContourFilter()
    contour.SetInputData(image)
    contour.SetValue(0, gray)
    away = lambda line, place: np.linalg.norm(line[:, :2] - place, axis=1)
    line = min(strips(contour), key=lambda line: away(line, first).min() + away(line, last).min())
    one, two = int(away(line, first).argmin()), int(away(line, last).argmin())
    return line[min(one, two):max(one, two) + 1, :2]


def veins():
    """Two trunks up the octopus's mantle, each with two branches: all alike, so that they meet level."""
    view = View((0.0, 5.2, 8.0), (0.0, 0.9, 0.0), scale=330)
    lines = (((-0.07, -0.19), (-0.14, -0.04), (-0.11, 0.12), (-0.19, 0.28), (-0.16, 0.43), (-0.21, 0.52)),
             ((-0.13, 0.00), (-0.23, 0.05), (-0.28, 0.15), (-0.35, 0.22)),
             ((-0.13, 0.17), (-0.05, 0.26), (-0.06, 0.39), (0.00, 0.50)),
             ((0.08, -0.20), (0.12, -0.05), (0.20, 0.08), (0.16, 0.26), (0.22, 0.42)),
             ((0.18, 0.03), (0.28, 0.08), (0.31, 0.20), (0.36, 0.26)),
             ((0.11, -0.08), (0.03, 0.00), (0.02, 0.10), (0.05, 0.19)))
    return [Stroke(view, in_plane(view, line), 0.040, 0.021, 1.0) for line in lines]


def collar():
    """A ring about the dog's neck: where a plane cuts it, drawn in four views, a quarter in each."""
    along = np.array([0.60, 0.80, 0.0])
    throat, side = np.array([0.80, -0.60, 0.0]), np.array([0.0, 0.0, 1.0])
    ring = cut(model("dog"), np.array([0.49, 1.05, 0.0]), along)
    middle = ring.mean(axis=0)
    angle = np.arctan2((ring - middle) @ side, (ring - middle) @ throat)
    order = np.argsort(angle)
    angle, ring = angle[order], ring[order]
    strokes = []
    for quarter in range(4):
        towards = quarter * np.pi / 2
        at = towards + np.linspace(-np.pi / 4, np.pi / 4, 61)
        course = np.column_stack([np.interp(at, angle, ring[:, k], period=2 * np.pi) for k in range(3)])
        view = View(middle + 10 * (np.cos(towards) * throat + np.sin(towards) * side), middle, up=along, scale=900)
        strokes.append(Stroke(view, course, 0.045, 0.030, 0.6))
    return strokes


def palm_lines():
    """The lines of a palm, and where the fingers bend, cut in."""
    view = View((0, 0.12, 10), (0, 0.12, 0), scale=200)
    lines = (((0.37, 0.02), (0.22, 0.02), (0.04, 0.06), (-0.10, 0.15), (-0.17, 0.23)),  # heart
             ((-0.33, 0.06), (-0.20, 0.01), (-0.02, -0.05), (0.14, -0.14), (0.25, -0.24)),  # head
             ((-0.33, 0.03), (-0.20, -0.06), (-0.10, -0.19), (-0.07, -0.33), (-0.12, -0.46)))  # life
    folds = (((-0.42, 0.29), (-0.34, 0.31), (-0.25, 0.33)), ((-0.52, 0.70), (-0.45, 0.71), (-0.37, 0.73)),
             ((-0.20, 0.40), (-0.11, 0.39), (-0.02, 0.40)), ((-0.24, 0.85), (-0.155, 0.84), (-0.07, 0.85)),
             ((0.05, 0.38), (0.13, 0.36), (0.21, 0.35)), ((0.10, 0.77), (0.18, 0.755), (0.26, 0.745)),
             ((0.29, 0.27), (0.36, 0.23), (0.42, 0.19)), ((0.41, 0.56), (0.475, 0.53), (0.54, 0.49)))
    return ([Stroke(view, in_plane(view, np.subtract(line, (0, 0.12))), 0.045, -0.024) for line in lines] +
            [Stroke(view, in_plane(view, np.subtract(line, (0, 0.12))), 0.032, -0.014) for line in folds])


def spines():
    """A row of spines down the dinosaur's back, each a short stroke, the largest in the middle, each seen from straight above it."""
    outline = cut(model("dinosaur"), np.array([0.0, 1.0, 0.0]), (0, 0, 1))
    first, last = (int(np.argmin(np.linalg.norm(outline - p, axis=1))) for p in ((1.33, 2.36, 0), (-1.75, 0.98, 0)))
    ways = [outline[(first + np.arange((last - first) % len(outline))) % len(outline)],
            outline[(first - np.arange((first - last) % len(outline))) % len(outline)]]
    back = max(ways, key=lambda way: way[len(way) // 2, 1])
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(back, axis=0), axis=1))])
    place = lambda at: np.array([np.interp(at, along, back[:, k]) for k in range(3)])
    strokes, at = [], 0.06
    while at < along[-1]:
        size = 0.045 + 0.055 * np.sin(np.pi * min(1.0, at / along[-1] * 1.05)) ** 1.5
        course = np.array([place(at + t * size) for t in np.linspace(-0.16, 0.16, 5)])
        tangent = (course[-1] - course[0]) / np.linalg.norm(course[-1] - course[0])
        above = np.cross(tangent, (0, 0, 1)) * np.sign(np.cross(tangent, (0, 0, 1))[1])
        view = View(course[2] + 10 * above, course[2], up=(0, 0, 1), scale=1800)
        strokes.append(Stroke(view, course, size, 2.0 * size, 1.1))
        at += 1.8 * size
    return strokes


def crest():
    """A crest over a person's head, seen from the side: a new silhouette."""
    view = View((10, 1.75, 0), (0, 1.75, 0), scale=900)
    mesh = model("person")
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    loop = outlines(view.display(vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)), triangles)[0]
    one, two = section(loop, view.display(in_plane(view, [(-0.10, 0.19), (0.19, 0.10)])), view.display(in_plane(view, [(0.03, 0.21)]))[0])
    head = smoothed(resample(np.vstack([one, two[-2::-1]]), np.linspace(0, 1, 120)), 4)
    along = np.gradient(head, axis=0)
    out = np.column_stack([-along[:, 1], along[:, 0]]) / np.linalg.norm(along, axis=1, keepdims=True)
    raised = head + 75.0 * (np.sin(np.pi * np.linspace(0, 1, 120) ** 0.8) ** 1.5)[:, None] * out
    return [Stroke(view, in_plane(view, (raised - (WIDTH / 2, HEIGHT / 2)) / view.scale), 0.085)]


def works():
    """A river cut into the valley's floor, a ridge raised on a spur, a road along a slope."""
    land = erosion.valley()
    view = View((96, -130, 290), (96, 90, 12), up=(0, 0, 1), angle=36)

    def over(places):
        p = np.asarray(places, float)
        x, y = np.minimum(p.astype(int), erosion.SIDE - 2).T
        u, v = p[:, 0] - x, p[:, 1] - y
        z = (1 - v) * ((1 - u) * land[y, x] + u * land[y, x + 1]) + v * ((1 - u) * land[y + 1, x] + u * land[y + 1, x + 1])
        return np.column_stack([p, z])

    river = smoothed(erosion.way_down(land, (40, 136)), 5)
    road = level(height_image(), 15.0 / GRAY, (118, 62), (158, 112))
    return [Stroke(view, over(resample(river, np.linspace(0, 1, 60))), 4.0, -3.0, 1.2),
            Stroke(view, over(rounded(np.array([(74, 110), (100, 119), (112, 129), (130, 140), (156, 151)], float))), 6.0, 5.0, 1.3),
            Stroke(view, over(resample(smoothed(road, 6), np.linspace(0, 1, 60))), 3.0, 1.5, 0.35)]


STROKES = {"octopus_veins": veins, "dog_collar": collar, "hand_palm_lines": palm_lines, "dinosaur_spines": spines, "person_crest": crest,
           "valley_river_ridge_road": works}


def make(name):
    """The strokes of a name, one polydata."""
    append = vtk.vtkAppendPolyData()
    for seed, stroke in enumerate(STROKES[name]()):
        course = stroke.course if len(stroke.course) > 30 else rounded(stroke.course)
        drawn = polydata(*pen(stroke.view.display(course), seed), stroke.view)
        for what, value in (("Radius", stroke.radius), ("Height", stroke.height), ("Sharpness", stroke.sharpness)):
            if value is not None:
                array = numpy_to_vtk(np.array([value], float), deep=True)
                array.SetName(what)
                drawn.GetCellData().AddArray(array)
        append.AddInputData(drawn)
    append.Update()
    return append.GetOutput()


def height_image():
    """The valley as an image of 16 bits."""
    image = vtk.vtkImageData()
    image.SetDimensions(erosion.SIDE, erosion.SIDE, 1)
    image.GetPointData().SetScalars(numpy_to_vtk((erosion.valley() / GRAY).round().astype(np.uint16).ravel(), deep=True))
    return image


def write(writer, folder, name, data):
    os.makedirs(folder, exist_ok=True)
    writer.SetFileName(os.path.join(folder, name))
    writer.SetInputData(data)
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description="Makes the strokes of Data/Strokes that augment, and Data/Terrain.")
    parser.add_argument("--only", choices=[*sorted(STROKES), "valley"], help="make one of them")
    parser.add_argument("--to", default=HERE, help="folder to write to")
    options = parser.parse_args()
    for name in [options.only] if options.only else [*STROKES, "valley"]:
        if name == "valley":
            write(vtk.vtkPNGWriter(), os.path.join(options.to, "Terrain"), "valley.png", height_image())
            continue
        strokes, writer = make(name), vtk.vtkXMLPolyDataWriter()
        writer.SetDataModeToBinary()
        write(writer, os.path.join(options.to, "Strokes"), name + ".vtp", strokes)
        print(f"{name}: {strokes.GetNumberOfCells()} strokes, {strokes.GetNumberOfPoints()} samples")


if __name__ == "__main__":
    main()
