"""Implicit modelling: parts (tubes along splines, ellipsoids) joined by smooth unions into one field, negative inside.

Written here because VTK's implicit functions have no smooth union and no tapered tube along a curve.
"""
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

FAR = 1e3  # the value of a field where none of its parts is near


def spline(points, per_span=8):
    """Centripetal Catmull-Rom curve through rows of any number of columns (positions first, then radius or more)."""
    p = np.asarray(points, float)
    if len(p) < 3:
        return np.vstack([p[0] + (p[-1] - p[0]) * t for t in np.linspace(0, 1, per_span + 1)])
    p = np.vstack([2 * p[0] - p[1], p, 2 * p[-1] - p[-2]])
    knots = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(p[:, :3], axis=0), axis=1) ** 0.5 + 1e-9)])
    out = []
    for i in range(1, len(p) - 2):
        k, q = knots[i - 1:i + 3], p[i - 1:i + 3]
        last = i == len(p) - 3
        for t in np.linspace(k[1], k[2], per_span + 1)[:None if last else -1]:
            level = [q[j] + (q[j + 1] - q[j]) * ((t - k[j]) / (k[j + 1] - k[j])) for j in range(3)]
            level = [level[j] + (level[j + 1] - level[j]) * ((t - k[j]) / (k[j + 2] - k[j])) for j in range(2)]
            out.append(level[0] + (level[1] - level[0]) * ((t - k[1]) / (k[2] - k[1])))
    return np.array(out)


class Tube:
    """Round tube along a spline through rows (x, y, z, radius). `flat` = (direction, factor) squashes its section."""

    def __init__(self, rows, flat=None, per_span=8):
        curve = spline(rows, per_span)
        self.low = (curve[:, :3] - curve[:, 3:]).min(axis=0)
        self.high = (curve[:, :3] + curve[:, 3:]).max(axis=0)
        self.stretch = None
        if flat is not None:
            n = np.asarray(flat[0], float)
            n /= np.linalg.norm(n)
            self.stretch = np.eye(3) + (1.0 / flat[1] - 1.0) * np.outer(n, n)
            curve[:, :3] = curve[:, :3] @ self.stretch
        self.curve = curve

    def __call__(self, p):
        if self.stretch is not None:
            p = p @ self.stretch
        best = np.full(len(p), FAR)
        for a, b in zip(self.curve[:-1], self.curve[1:]):
            d = b[:3] - a[:3]
            rel = p - a[:3]
            t = np.clip(rel @ d / max(d @ d, 1e-18), 0.0, 1.0)
            gap = rel - t[:, None] * d
            np.minimum(best, np.sqrt(np.einsum("ij,ij->i", gap, gap)) - (a[3] + t * (b[3] - a[3])), out=best)
        return best


class Ellipsoid:
    """Ellipsoid of three radii; `axes` = rows of its (orthogonal) axes, made unit here."""

    def __init__(self, centre, radii, axes=None):
        self.centre = np.asarray(centre, float)
        self.radii = np.broadcast_to(np.asarray(radii, float), (3,))
        axes = np.eye(3) if axes is None else np.asarray(axes, float)
        self.axes = axes / np.linalg.norm(axes, axis=1, keepdims=True)
        reach = np.sqrt(((self.axes * self.radii[:, None]) ** 2).sum(axis=0))
        self.low, self.high = self.centre - reach, self.centre + reach

    def __call__(self, p):
        local = (p - self.centre) @ self.axes.T / self.radii
        k0 = np.sqrt(np.einsum("ij,ij->i", local, local))
        k1 = np.linalg.norm(local / self.radii, axis=1)
        return np.where(k1 > 1e-12, k0 * (k0 - 1.0) / np.maximum(k1, 1e-12), -self.radii.min())


def smooth_min(a, b, width):
    """Cubic smooth minimum: differs from min(a, b) where |a - b| < width, twice differentiable there."""
    h = np.maximum(width - np.abs(a - b), 0.0) / width
    return np.minimum(a, b) - h ** 3 * width / 6.0


class Field:
    """Parts joined one after the other, each over its own blending width. A field can be a part of another."""

    def __init__(self):
        self.parts = []

    def add(self, part, blend=0.02):
        self.parts.append((part, blend, 1.0))
        return self

    def carve(self, part, blend=0.02):
        self.parts.append((part, blend, -1.0))
        return self

    @property
    def low(self):
        return np.min([p.low for p, _, sign in self.parts if sign > 0], axis=0)

    @property
    def high(self):
        return np.max([p.high for p, _, sign in self.parts if sign > 0], axis=0)

    def __call__(self, p):
        value = np.full(len(p), FAR)
        for part, blend, sign in self.parts:
            margin = 2.0 * blend + 0.05
            near = np.all((p > part.low - margin) & (p < part.high + margin), axis=1)
            if near.any():
                # sign -1: the smooth maximum with the part's complement
                value[near] = sign * smooth_min(sign * value[near], part(p[near]), blend)
        return value

    def gradient(self, p, step=1e-4):
        """Field and gradient at p, from four evaluations at the corners of a small tetrahedron."""
        corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
        values = [self(p + step * c) for c in corners]
        slope = sum(v[:, None] * c for v, c in zip(values, corners)) / (4.0 * step)
        return sum(values) / 4.0, slope

    def project(self, p, steps=1, reach=0.02):
        """Newton steps onto the surface, each at most `reach` long."""
        for _ in range(steps):
            value, slope = self.gradient(p)
            move = slope * (value / np.maximum(np.einsum("ij,ij->i", slope, slope), 1e-6))[:, None]
            length = np.linalg.norm(move, axis=1, keepdims=True)
            p = p - move * np.minimum(1.0, reach / np.maximum(length, 1e-12))
        return p

    def polygonise(self, step):
        """The zero surface on a grid of the given step: points and triangles, outward orientation."""
        low, high = self.low - 4 * step, self.high + 4 * step
        size = np.ceil((high - low) / step).astype(int) + 1
        value = np.full(size[::-1], FAR)
        for part, blend, sign in self.parts:
            margin = 2.0 * blend + 3 * step
            first = np.clip(np.floor((part.low - margin - low) / step).astype(int), 0, size - 1)
            last = np.clip(np.ceil((part.high + margin - low) / step).astype(int) + 1, 1, size)
            axes = [low[i] + step * np.arange(first[i], last[i]) for i in range(3)]
            z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
            block = tuple(slice(first[i], last[i]) for i in (2, 1, 0))
            there = part(np.column_stack([x.ravel(), y.ravel(), z.ravel()])).reshape(x.shape)
            value[block] = sign * smooth_min(sign * value[block], there, blend)
        image = vtk.vtkImageData()
        image.SetDimensions(*[int(n) for n in size])
        image.SetOrigin(*low)
        image.SetSpacing(step, step, step)
        image.GetPointData().SetScalars(numpy_to_vtk(np.clip(value, -FAR, 2 * step + 0.2).ravel(), deep=True))
        contour = vtk.vtkFlyingEdges3D()
        contour.SetInputData(image)
        contour.SetValue(0, 0.0)
        contour.ComputeNormalsOff()
        contour.ComputeGradientsOff()
        contour.ComputeScalarsOff()
        clean = vtk.vtkCleanPolyData()
        clean.SetInputConnection(contour.GetOutputPort())
        clean.ConvertPolysToLinesOff()
        clean.SetTolerance(0.0)
        clean.Update()
        mesh = clean.GetOutput()
        points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
        triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3).astype(np.int64)
        a, b, c = (points[triangles[:, i]] for i in range(3))
        if np.einsum("ij,ij->i", a, np.cross(b, c)).sum() < 0:
            triangles = triangles[:, ::-1].copy()
        return points, triangles
