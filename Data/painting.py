"""Painting with fields in numpy: curves, signed distances [px] that are positive inside, soft edges, a light from above on the left.

A field is an array of a picture's height and width, row 0 at the bottom; places are display px from the lower left corner, so that the pixel
in column i and row j lies round (i + 0.5, j + 0.5).
"""
import numpy as np
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
import vtk

LIGHT = np.array([-0.42, 0.58, 0.70])
REACH = 90  # px: no field of a shape tells more


def spline(points, closed=False, steps=16):
    """A curve through points (Catmull and Rom's); a closed one ends before its first point comes again."""
    p = np.asarray(points, float)
    p = np.vstack([p[-1:], p, p[:2]]) if closed else np.vstack([2 * p[0] - p[1], p, 2 * p[-1] - p[-2]])
    t = np.arange(steps)[:, None] / steps
    parts = [0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t ** 2 + (3 * b - a - 3 * c + d) * t ** 3)
             for a, b, c, d in zip(p, p[1:], p[2:], p[3:])]
    return np.vstack(parts if closed else [*parts, p[-2:-1]])


def circle(centre, radius, count=96):
    """An ellipse where two radii are given."""
    angle = 2 * np.pi * np.arange(count) / count
    return np.asarray(centre) + np.broadcast_to(radius, 2) * np.column_stack([np.cos(angle), np.sin(angle)])


def arc(centre, radius, first, last, count=48):
    """Of a circle or an ellipse, between two angles [degrees]."""
    angle = np.radians(np.linspace(first, last, count))
    return np.asarray(centre) + np.broadcast_to(radius, 2) * np.column_stack([np.cos(angle), np.sin(angle)])


def step(field, start, end):
    """0 below the start, 1 above the end, smooth between."""
    t = np.clip((field - start) / (end - start), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def mixed(first, second, share):
    """Colours, or fields of colours, blended by a field."""
    return np.asarray(first) * (1.0 - share)[..., None] + np.asarray(second) * share[..., None]


def union(*fields, blend=0.0):
    """The greatest of fields; over `blend` px the creases between them are filled."""
    whole = fields[0]
    for field in fields[1:]:
        h = np.maximum(blend - np.abs(whole - field), 0.0) / blend if blend else 0.0
        whole = np.maximum(whole, field) + h * h * blend / 4.0
    return whole


def blurred(field, sigma):
    """Gaussian mean; the border's values go on beyond it."""
    reach = int(np.ceil(3 * sigma))
    weights = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    weights /= weights.sum()
    for axis in (0, 1):
        size = field.shape[axis]
        padded = np.pad(field, [(reach, reach) if k == axis else (0, 0) for k in (0, 1)], mode="edge")
        field = sum(w * np.take(padded, np.arange(k, k + size), axis=axis) for k, w in enumerate(weights))
    return field


class Picture:
    """A picture being painted: colours in [0, 1]."""

    def __init__(self, width, height, colour=(1, 1, 1)):
        self.width, self.height = width, height
        self.x, self.y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
        self.rgb = np.ones((height, width, 3)) * np.asarray(colour, float)

    def paint(self, colour, cover):
        """Lays a colour, or a field of colours, over what is there, as densely as the field says."""
        self.rgb = mixed(self.rgb, colour, np.clip(cover, 0.0, 1.0))

    def shade(self, light, cover):
        """Lightens (above 0) and darkens (below 0) what is there, where the field covers."""
        light = light * np.clip(cover, 0.0, 1.0)
        self.rgb = mixed(self.rgb, (1, 1, 1), np.clip(light, 0, 1)) * (1.0 - np.clip(-light, 0, 1))[..., None]

    def toned(self, top, bottom, centre, falloff=0.12):
        """A background: one colour into another from the top down, lighter about a centre."""
        away = np.hypot(self.x - centre[0], self.y - centre[1]) / max(self.width, self.height)
        self.rgb = mixed(bottom, top, self.y / self.height) * (1.0 - falloff * away ** 2)[..., None]

    def tube(self, points, radii):
        """Field of the capsules along a curve whose radii run from point to point; -REACH far outside."""
        points, radii = np.asarray(points, float), np.broadcast_to(np.asarray(radii, float), len(points))
        field = np.full((self.height, self.width), -float(REACH))
        for a, b, r, s in zip(points, points[1:], radii, radii[1:]):
            window, gap, t = self._capsule(a, b, REACH + max(r, s))
            np.maximum(field[window], r + (s - r) * t - gap, out=field[window])
        return field

    def limb(self, points, radii, steps=6):
        """As a tube, through a few points with a radius each."""
        rows = spline(np.column_stack([points, radii]), steps=steps)
        return self.tube(rows[:, :2], rows[:, 2])

    def inside(self, curve):
        """Field of a closed curve: the distance from it, exact near it, at most REACH inside and outside."""
        return np.where(self._enclosed(curve), 1.0, -1.0) * self.away(np.vstack([curve, curve[:1]]))

    def away(self, curve, reach=REACH, near=8):
        """The distance from a curve, at most `reach` px: exact within `near` px, beyond them from the curve with fewer points."""
        length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
        few = np.unique(np.append(np.searchsorted(length, np.arange(0.0, length[-1], 6.0)), len(curve) - 1))
        gaps = []
        for points, limit in ((curve, min(near, reach)), (curve[few], reach)):
            gap = np.full((self.height, self.width), float(limit))
            for a, b in zip(points, points[1:]):
                window, value, _ = self._capsule(a, b, limit)
                np.minimum(gap[window], value, out=gap[window])
            gaps.append(gap)
        return np.where(gaps[0] < near, gaps[0], np.maximum(gaps[1], min(near, reach)))

    def _capsule(self, a, b, reach):
        """The pixels within `reach` of a segment, and some more: their window, distance and share of the way along it."""
        low, high = np.minimum(a, b) - reach, np.maximum(a, b) + reach
        i, j = np.maximum(low, 0).astype(int)
        k, m = np.clip(np.ceil(high), 0, (self.width, self.height)).astype(int)
        window = (slice(j, max(j, m)), slice(i, max(i, k)))
        along = np.asarray(b, float) - a
        x, y = self.x[window] - a[0], self.y[window] - a[1]
        t = np.clip((x * along[0] + y * along[1]) / max(along @ along, 1e-12), 0, 1)
        return window, np.hypot(x - t * along[0], y - t * along[1]), t

    def line(self, curve, width, soft=0.5):
        """Cover of a line of ink along a curve."""
        return np.clip((width / 2.0 - self.away(np.asarray(curve, float), int(width + 2 * soft + 4))) / (2 * soft) + 0.5, 0.0, 1.0)

    def cover(self, field, soft=0.5):
        """Cover of a field's inside: over 2 * soft px, 1 px unless said, it fades to nothing."""
        return np.clip(field / (2 * soft) + 0.5, 0.0, 1.0)

    def relief(self, field, radius, smooth=3.0):
        """How a light falls on a field's inside, rounded over `radius` px from its edge: above 0 lit, below 0 in shadow."""
        depth = np.clip(field, 0.0, radius)
        height = blurred(np.sqrt(depth * (2.0 * radius - depth)), smooth)
        slope_y, slope_x = np.gradient(height)
        normal = np.stack([-slope_x, -slope_y, np.ones_like(height)], axis=-1)
        return normal @ LIGHT / np.linalg.norm(normal, axis=-1) - LIGHT[2]

    def mottled(self, seed, size):
        """Smooth noise about 0, its mean square 1."""
        noise = blurred(np.random.RandomState(seed).standard_normal((self.height, self.width)), size)
        return noise / noise.std()

    def scales(self, u, v, radius=0.78):
        """Cover and shade of overlapping scales on the unit grid of (u, v): (1 at a scale's rim, where its own surface stands)."""
        rim, at = np.zeros_like(u), np.zeros_like(u)
        column = np.floor(u)
        done = np.zeros(u.shape, bool)
        for k in (-1, 0, 1):  # the scale farthest ahead lies on top
            c = column + k
            centre = np.round(v - 0.5 * (c % 2)) + 0.5 * (c % 2)
            away = np.hypot(u - c, v - centre) / radius
            own = ~done & (away < 1.0)
            rim[own], at[own] = away[own], (u - c)[own]
            done |= own
        return step(rim, 0.72, 1.0), at

    def _enclosed(self, curve):
        a, b = np.asarray(curve, float), np.roll(curve, -1, axis=0)
        inside = np.zeros((self.height, self.width), bool)
        for (ax, ay), (bx, by) in zip(a, b):
            low, high = np.clip(np.ceil(np.array([min(ay, by), max(ay, by)]) - 0.5), 0, self.height).astype(int)
            if low < high:
                x = ax + (self.y[low:high, :1] - ay) / (by - ay) * (bx - ax)
                inside[low:high] ^= self.x[low:high] > x
        return inside

    def contours(self, field, level=0.0):
        """The closed curves on which a field has a value, the longest first; a curve's first point stands once."""
        image = vtk.vtkImageData()
        image.SetDimensions(self.width, self.height, 1)
        image.SetOrigin(0.5, 0.5, 0.0)
        image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(field, float).ravel(), deep=True))
        contour, strip, ids = vtk.vtkContourFilter(), vtk.vtkStripper(), vtk.vtkIdList()
        contour.SetInputData(image)
        contour.SetValue(0, level)
        strip.SetInputConnection(contour.GetOutputPort())
        strip.SetMaximumLength(10 ** 6)
        strip.Update()
        points, loops = vtk_to_numpy(strip.GetOutput().GetPoints().GetData())[:, :2].astype(float), []
        for i in range(strip.GetOutput().GetNumberOfCells()):
            strip.GetOutput().GetCellPoints(i, ids)
            loops.append(points[[ids.GetId(j) for j in range(ids.GetNumberOfIds() - 1)]])
        return sorted(loops, key=lambda loop: -np.linalg.norm(np.diff(loop, axis=0), axis=1).sum())

    def image(self):
        """As bytes, for a file."""
        image = vtk.vtkImageData()
        image.SetDimensions(self.width, self.height, 1)
        values = np.round(255.0 * np.clip(self.rgb, 0.0, 1.0)).astype(np.uint8)
        image.GetPointData().SetScalars(numpy_to_vtk(values.reshape(-1, 3), deep=True))
        return image
