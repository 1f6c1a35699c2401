#!/usr/bin/python3
"""Makes the strokes: Data/Strokes/<model>_<what>.vtp, two for each model of Data/Models but the bear.

    make_strokes.py [--only NAME] [--to FOLDER]

A stroke redraws a limb. The model's outline in the stroke's view is cut at the limb's two base points; the part round the
tip is taken as a centre line with a half width on either side, the centre line is bent and stretched, the width scaled,
and the new outline sampled like a pen's path. Points are display pixels (800 x 600, lower left corner, y up); the view
stands in the cell arrays ViewTransform, ProjectionTransform (4 x 4, row-major) and ViewportSize.
Needs numpy and python3-vtk9, no display.
"""
import argparse
import os

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

WIDTH, HEIGHT = 800, 600
HERE = os.path.dirname(os.path.abspath(__file__))


class View:
    """World to display; `eye` and `focus` in world space, `scale` px per unit, or `angle` (vertical, degrees)."""

    def __init__(self, eye, focus, up=(0, 1, 0), scale=None, angle=None):
        eye, focus, up = (np.asarray(v, float) for v in (eye, focus, up))
        self.eye, self.focus, self.up, self.scale, self.angle = eye, focus, up, scale, angle
        distance = np.linalg.norm(eye - focus)
        z = (eye - focus) / distance
        x = np.cross(up, z)
        x /= np.linalg.norm(x)
        self.view = np.eye(4)
        self.view[:3, :3] = [x, np.cross(z, x), z]
        self.view[:3, 3] = -self.view[:3, :3] @ eye
        near, far = 0.5 * distance, 2.0 * distance
        if angle is None:
            self.projection = np.diag([2.0 * scale / WIDTH, 2.0 * scale / HEIGHT, -2.0 / (far - near), 1.0])
            self.projection[2, 3] = -(far + near) / (far - near)
        else:
            f = 1.0 / np.tan(np.radians(angle) / 2.0)
            self.projection = np.diag([f * HEIGHT / WIDTH, f, -(far + near) / (far - near), 0.0])
            self.projection[2, 3] = -2.0 * far * near / (far - near)
            self.projection[3, 2] = -1.0

    def display(self, points):
        clip = np.column_stack([points, np.ones(len(points))]) @ (self.projection @ self.view).T
        return (clip[:, :2] / clip[:, 3:] + 1.0) * 0.5 * [WIDTH, HEIGHT]


def coverage(display, triangles, fine=3):
    """The share of each pixel that the triangles cover, from fine x fine samples a pixel."""
    mask = np.zeros((HEIGHT * fine, WIDTH * fine), bool)
    corners = display[triangles] * fine
    low = np.maximum(np.floor(corners.min(axis=1)).astype(int), 0)
    high = np.minimum(np.ceil(corners.max(axis=1)).astype(int) + 1, [WIDTH * fine, HEIGHT * fine])
    for (a, b, c), l, h in zip(corners, low, high):
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if area <= 0.0 or np.any(h <= l):  # turned away, or outside: the closed model's other triangles cover it
            continue
        x, y = np.arange(l[0], h[0]) + 0.5, (np.arange(l[1], h[1]) + 0.5)[:, None]
        inside = np.ones((len(y), len(x)), bool)
        for p, q in ((a, b), (b, c), (c, a)):
            inside &= (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]) >= 0.0
        mask[l[1]:h[1], l[0]:h[0]] |= inside
    return mask.reshape(HEIGHT, fine, WIDTH, fine).mean(axis=(1, 3))


def outlines(display, triangles):
    """The closed outlines of the covered pixels, as display points, the longest first."""
    image = vtk.vtkImageData()
    image.SetDimensions(WIDTH, HEIGHT, 1)
    image.SetOrigin(0.5, 0.5, 0.0)  # pixel centres
    image.GetPointData().SetScalars(numpy_to_vtk(coverage(display, triangles).ravel(), deep=True))
    contour = vtk.vtkContourFilter()
    contour.SetInputData(image)
    contour.SetValue(0, 0.5)
    strip = vtk.vtkStripper()
    strip.SetInputConnection(contour.GetOutputPort())
    strip.SetMaximumLength(10 ** 6)
    strip.Update()
    lines = strip.GetOutput()
    points = vtk_to_numpy(lines.GetPoints().GetData())[:, :2].astype(float)
    ids, loops = vtk.vtkIdList(), []
    for i in range(lines.GetNumberOfCells()):
        lines.GetCellPoints(i, ids)
        loops.append(points[[ids.GetId(j) for j in range(ids.GetNumberOfIds())]])
    length = [np.linalg.norm(np.diff(loop, axis=0), axis=1).sum() for loop in loops]
    return [loops[i] for i in np.argsort(length)[::-1]]


def resample(path, places):
    """Points of an open polyline at fractions of its length."""
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    return np.column_stack([np.interp(np.asarray(places) * along[-1], along, path[:, i]) for i in (0, 1)])


def smoothed(path, reach):
    """Gaussian mean over `reach` points; the ends stay."""
    window = np.exp(-0.5 * (np.arange(-3 * reach, 3 * reach + 1) / reach) ** 2)
    padded = np.vstack([2 * path[0] - path[3 * reach:0:-1], path, 2 * path[-1] - path[-2:-3 * reach - 2:-1]])
    return np.column_stack([np.convolve(padded[:, i], window / window.sum(), "valid") for i in (0, 1)])


def rise(t, start, end):
    t = np.clip((t - start) / (end - start), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def section(loop, base, tip):
    """The two sides of a limb on a closed outline, each from its base point to the tip."""
    loop = loop[:-1] if np.allclose(loop[0], loop[-1]) else loop
    first, second, end = (int(np.argmin(np.linalg.norm(loop - p, axis=1))) for p in (base[0], base[1], tip))
    n = len(loop)
    if (end - first) % n > (second - first) % n:  # the tip lies the other way round
        loop, first, second, end = loop[::-1], n - 1 - first, n - 1 - second, n - 1 - end
    one = loop[(first + np.arange((end - first) % n + 1)) % n]
    two = loop[(end + np.arange((second - end) % n + 1)) % n][::-1]
    return one, two


def redraw(one, two, turn=0.0, stretch=0.0, thicken=0.0, bends=(0.0, 0.8), grows=(0.1, 0.75), swells=(0.0, 0.3, 0.6, 0.9)):
    """The limb's new outline from base to base: bent by `turn` degrees over `bends` (fractions from base to tip, positive
    counter-clockwise), its centre line stretched by the share `stretch` over `grows`, its width by `thicken` over `swells`."""
    t = np.linspace(0.0, 1.0, 400)
    one, two = resample(one, t), resample(two, t)
    centre, half = 0.5 * (one + two), 0.5 * (one - two)
    angle = np.radians(turn) * rise(t, *bends)
    cos, sin = np.cos(angle), np.sin(angle)
    rotate = lambda v, c, s: np.column_stack([c * v[:, 0] - s * v[:, 1], s * v[:, 0] + c * v[:, 1]])
    middle = 0.5 * (t[1:] + t[:-1])
    ramp = 0.25 * (grows[1] - grows[0])
    longer = rise(middle, grows[0], grows[0] + ramp) * (1.0 - rise(middle, grows[1] - ramp, grows[1]))
    step = np.diff(centre, axis=0)
    longer *= stretch / (longer @ np.linalg.norm(step, axis=1)) * np.linalg.norm(step, axis=1).sum()
    step = rotate(step, 0.5 * (cos[1:] + cos[:-1]), 0.5 * (sin[1:] + sin[:-1])) * (1.0 + longer)[:, None]
    centre = np.vstack([centre[:1], centre[0] + np.cumsum(step, axis=0)])
    swell = 1.0 + thicken * rise(t, *swells[:2]) * (1.0 - rise(t, *swells[2:]))
    half = rotate(half, cos, sin) * swell[:, None]
    return np.vstack([centre + half, (centre - half)[-2::-1]])


def pen(path, seed):
    """A pen's samples along a path: points, time and pressure. Slower in curves, with a slow tremor of under 0.7 px."""
    length = np.linalg.norm(np.diff(path, axis=0), axis=1).sum()
    fine = smoothed(resample(path, np.linspace(0, 1, int(length) + 1)), 4)
    tangent = np.gradient(fine, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    curvature = np.linalg.norm(np.gradient(tangent, axis=0), axis=1)
    along = np.arange(len(fine))
    ends = rise(along, 0, 40) * (1.0 - rise(along, len(fine) - 40, len(fine) - 1))
    speed = (140.0 + 320.0 * ends) / (1.0 + 12.0 * np.convolve(curvature, np.ones(21) / 21, "same"))  # px/s
    random = np.random.RandomState(seed)
    tremor = sum(0.22 * np.sin(2 * np.pi * along / wave + 2 * np.pi * random.rand()) for wave in (37.0, 71.0, 113.0))
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    fine = fine + normal * (tremor * ends)[:, None]
    clock = np.concatenate([[0.0], np.cumsum(2.0 / (speed[1:] + speed[:-1]))])
    time = np.linspace(0.0, clock[-1], int(clock[-1] * 90) + 2)  # 90 samples a second
    points = np.column_stack([np.interp(time, clock, fine[:, i]) for i in (0, 1)])
    pressure = 0.25 + 0.5 * np.interp(time, clock, ends) + 0.04 * np.sin(3.0 * time)
    return points, time, pressure


def polydata(points, time, pressure, view):
    stroke = vtk.vtkPolyData()
    place = vtk.vtkPoints()
    place.SetData(numpy_to_vtk(np.column_stack([points, np.zeros(len(points))]), deep=True))
    stroke.SetPoints(place)
    lines = vtk.vtkCellArray()
    lines.InsertNextCell(len(points))
    for i in range(len(points)):
        lines.InsertCellPoint(i)
    stroke.SetLines(lines)
    for data, name, values in ((stroke.GetPointData(), "Time", time.astype(np.float64)),
                               (stroke.GetPointData(), "Pressure", pressure.astype(np.float32)),
                               (stroke.GetCellData(), "ViewTransform", view.view.reshape(1, 16)),
                               (stroke.GetCellData(), "ProjectionTransform", view.projection.reshape(1, 16)),
                               (stroke.GetCellData(), "ViewportSize", np.array([[WIDTH, HEIGHT]], np.int32))):
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        data.AddArray(array)
    return stroke


SIDE = View((0.05, 0.75, 10), (0.05, 0.75, 0), scale=235)
FRONT = View((0, 1.0, 10), (0, 1.0, 0), scale=260)

# Each stroke: the view; world points near the outline at the limb's two base points and its tip; how the limb is redrawn.
STROKES = {
    "dog_longer_leg": (SIDE, ((0.50, 0.50, 0.15), (0.33, 0.42, 0.15)), (0.70, 0.0, 0.15), dict(stretch=0.50, grows=(0.05, 0.6))),
    "dog_curled_tail": (SIDE, ((-0.55, 1.01, 0), (-0.63, 0.90, 0)), (-0.84, 1.66, 0), dict(turn=-75, stretch=0.15, bends=(0.15, 1.0))),
    "person_longer_arm": (FRONT, ((0.29, 1.40, 0), (0.28, 1.24, 0)), (0.84, 0.72, 0.05), dict(turn=20, stretch=0.28, grows=(0.1, 0.7))),
    "person_thicker_leg": (FRONT, ((0.21, 0.84, 0), (0.05, 0.78, 0)), (0.26, 0.0, 0.1), dict(thicken=0.55)),
    "hand_longer_finger": (View((0, 0.12, 10), (0, 0.12, 0), scale=180), ((-0.24, 0.54, 0), (-0.02, 0.54, 0)), (-0.17, 1.25, 0.2),
                           dict(stretch=0.35)),
    "hand_bent_thumb": (View((0.9, 0.7, 5.6), (0, 0.05, 0), angle=29), ((-0.30, -0.52, 0.05), (-0.38, 0.09, 0.05)), (-0.83, 0.52, 0.16),
                        dict(turn=32, bends=(0.1, 0.8))),
    "dinosaur_raised_neck": (View((-0.15, 1.35, 10), (-0.15, 1.35, 0), scale=165), ((0.45, 1.40, 0), (0.55, 1.05, 0)), (1.86, 2.21, 0),
                             dict(turn=26, bends=(0.0, 0.55))),
    "dinosaur_longer_tail": (View((-2.4, 2.4, 8.6), (-0.45, 1.10, 0), angle=26), ((-0.62, 1.13, 0), (-0.62, 0.72, 0)), (-2.12, 1.05, 0),
                             dict(turn=-25, stretch=0.20, bends=(0.1, 0.9))),
    "octopus_bent_arm": (View((0, 10, -0.12), (0, 0, -0.13), up=(0, 0, -1), scale=140), ((0.16, 0.15, -0.60), (0.34, 0.15, -0.60)), (0.84, 0.3, -1.53),
                         dict(turn=-55, bends=(0.2, 0.85))),
    "octopus_longer_arm": (View((0.6, 8.0, 2.4), (0, 0.2, 0.12), up=(0, 0, -1), angle=27), ((0.36, 0.15, 0.46), (0.07, 0.15, 0.57)),
                           (0.51, 0.3, 1.64), dict(turn=25, stretch=0.25)),
}


def make(name, models=os.path.join(HERE, "Models")):
    """The stroke as vtkPolyData, with what it was drawn over: the path redrawn and the outline's section."""
    view, base, tip, change = STROKES[name]
    reader = vtk.vtkPLYReader()
    reader.SetFileName(os.path.join(models, name.split("_")[0] + ".ply"))
    reader.Update()
    mesh = reader.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    loop = outlines(view.display(points), triangles)[0]
    hints = view.display(np.array([*base, tip], float))
    one, two = section(loop, hints[:2], hints[2])
    path = redraw(one, two, **change)
    return polydata(*pen(path, sorted(STROKES).index(name)), view), path, np.vstack([one, two[::-1]])


def main():
    parser = argparse.ArgumentParser(description="Makes the strokes of Data/Strokes.")
    parser.add_argument("--only", choices=sorted(STROKES), help="make one stroke")
    parser.add_argument("--to", default=os.path.join(HERE, "Strokes"), help="folder to write to")
    options = parser.parse_args()
    os.makedirs(options.to, exist_ok=True)
    for name in [options.only] if options.only else STROKES:
        stroke = make(name)[0]
        writer = vtk.vtkXMLPolyDataWriter()
        writer.SetFileName(os.path.join(options.to, name + ".vtp"))
        writer.SetInputData(stroke)
        writer.SetDataModeToBinary()
        writer.Write()
        low, high = np.array(stroke.GetBounds())[[0, 2]], np.array(stroke.GetBounds())[[1, 3]]
        print(f"{name}: {stroke.GetNumberOfPoints()} samples, from {low.round()} to {high.round()}")


if __name__ == "__main__":
    main()
