"""Views, exact outlines and pictures of triangle meshes, in numpy alone (no graphics context is needed)."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

WIDTH, HEIGHT = 800, 600


class View:
    """World -> camera -> clip, as a stroke carries it: display px from the lower left corner, y up."""

    def __init__(self, view, projection, width=WIDTH, height=HEIGHT):
        self.view, self.projection = np.asarray(view, float), np.asarray(projection, float)
        self.width, self.height = int(width), int(height)
        self.perspective = bool(np.any(self.projection[3, :3] != 0.0))

    @classmethod
    def looking(cls, points, towards_viewer, up, perspective, fill):
        """A view on all points from a direction, the model filling a share of the picture's height or width."""
        z = np.asarray(towards_viewer, float) / np.linalg.norm(towards_viewer)
        x = np.cross(up, z)
        x /= np.linalg.norm(x)
        rotation = np.array([x, np.cross(z, x), z])
        low, high = (points @ rotation.T).min(0), (points @ rotation.T).max(0)
        centre, size = (low + high) / 2, high - low
        half = max(size[1], size[0] * HEIGHT / WIDTH) / 2 / fill  # half the picture's height, in world units
        view, projection = np.eye(4), np.zeros((4, 4))
        view[:3, :3], view[:3, 3] = rotation, -centre
        if perspective:
            cotangent = 1 / np.tan(np.radians(15))  # an opening of 30 degrees
            distance = half * cotangent + size[2] / 2
            view[2, 3] -= distance
            near, far = distance * 0.1, distance * 4
            projection[0, 0], projection[1, 1] = cotangent * HEIGHT / WIDTH, cotangent
            projection[2, 2], projection[2, 3] = -(far + near) / (far - near), -2 * far * near / (far - near)
            projection[3, 2] = -1
        else:
            depth = size[2] * 4
            view[2, 3] -= depth
            projection[0, 0], projection[1, 1] = HEIGHT / WIDTH / half, 1 / half
            projection[2, 2], projection[2, 3], projection[3, 3] = -1 / depth, -1, 1
        return cls(view, projection)

    def display(self, points):
        """(n, 2) display px and (n,) camera z, which grows towards the viewer."""
        camera = np.c_[points, np.ones(len(points))] @ self.view.T
        clip = camera @ self.projection.T
        half = np.array([self.width, self.height]) / 2
        return (clip[:, :2] / clip[:, 3:] + 1) * half, camera[:, 2]


def magnified(view, middle, zoom, size=(WIDTH, HEIGHT)):
    """The part of a view about a place [px], so many times as large, and what takes px of the view to px of that."""
    window = np.eye(4)  # clip coordinates of the part: those of the view, moved and magnified
    for k, whole in enumerate((view.width, view.height)):
        window[k, k] = zoom * whole / size[k]
        window[k, 3] = window[k, k] * (1 - 2 * middle[k] / whole)
    return View(view.view, window @ view.projection, *size), lambda line: (line - middle) * zoom + np.array(size) / 2


def _spans(xy, triangles, low, step, count):
    """Where the lines y = low + k * step (0 <= k < count) cross each triangle: (triangle, k, x from, x to)."""
    corners = xy[triangles]
    order = np.lexsort((corners[:, :, 0], corners[:, :, 1]), axis=1)  # by y, then x: an edge is cut alike from both sides
    a, b, c = np.moveaxis(np.take_along_axis(corners, order[:, :, None], 1), 1, 0)
    first = np.clip(np.ceil((a[:, 1] - low) / step), 0, count).astype(np.int64)
    last = np.clip(np.ceil((c[:, 1] - low) / step), 0, count).astype(np.int64)  # half open: [first, last)
    number = np.maximum(last - first, 0)
    t = np.repeat(np.arange(len(triangles)), number)
    k = np.arange(len(t)) - np.repeat(np.cumsum(number) - number, number) + first[t]
    y = low + k * step

    def cut(p, q):
        with np.errstate(divide="ignore", invalid="ignore"):
            return p[t, 0] + (q[t, 0] - p[t, 0]) * ((y - p[t, 1]) / (q[t, 1] - p[t, 1]))

    long_side = cut(a, c)
    short_side = np.where(y < b[t, 1], cut(a, b), cut(b, c))
    short_side = np.where(np.isfinite(short_side), short_side, b[t, 0])
    return t, k, np.minimum(long_side, short_side), np.maximum(long_side, short_side)


def fragments(xy, triangles, width=WIDTH, height=HEIGHT, scale=1):
    """Every (pixel, triangle) whose centre the triangle covers, all layers: pixel = row * width * scale + column."""
    t, row, x0, x1 = _spans(xy * scale, triangles, 0.5, 1.0, height * scale)
    first = np.clip(np.ceil(x0 - 0.5), 0, width * scale).astype(np.int64)
    last = np.clip(np.ceil(x1 - 0.5), 0, width * scale).astype(np.int64)
    number = np.maximum(last - first, 0)
    at = np.repeat(np.arange(len(t)), number)
    column = np.arange(len(at)) - np.repeat(np.cumsum(number) - number, number) + first[at]
    return row[at] * width * scale + column, t[at]


def layers(xy, triangles, width=WIDTH, height=HEIGHT):
    """How many triangles cover each pixel centre: 2 where a closed mesh is entered and left once."""
    pixel, _ = fragments(xy, triangles, width, height)
    return np.bincount(pixel, minlength=width * height).reshape(height, width)


def _union(row, x0, x1):
    """The union of intervals on each row: (row, from, to), sorted."""
    order = np.lexsort((x0, row))
    row, x0, x1 = row[order], x0[order], x1[order]
    span = x1.max() - x0.min() + 1
    reach = np.maximum.accumulate(x1 + row * span) - row * span  # rows never reach into the next
    new = np.ones(len(row), bool)
    new[1:] = (row[1:] != row[:-1]) | (x0[1:] > reach[:-1] + 1e-9)
    start = np.flatnonzero(new)
    return row[start], x0[start], reach[np.r_[start[1:], len(row)] - 1]


def outline(xy, triangles, step=0.5):
    """The boundary loops of the area that the triangles cover, as closed (n, 2) px polylines (last = first) with the
    area on their left. The points are exact: where the area's border crosses the lines of a grid of the given step."""
    low = np.floor(xy[triangles].reshape(-1, 2).min(0)) - 2 * step
    columns, rows = (np.ceil((xy[triangles].reshape(-1, 2).max(0) - low) / step) + 3).astype(int)
    inside = np.zeros((rows, columns), bool)
    across = np.full((rows, columns), np.nan)  # x where the border crosses from node (j, i) to (j, i + 1)
    along = np.full((rows, columns), np.nan)  # y where it crosses from node (j, i) to (j + 1, i)
    for swap, crossing in ((False, across), (True, along)):
        p, origin = (xy[:, ::-1], low[::-1]) if swap else (xy, low)
        _, k, x0, x1 = _spans(p, triangles, origin[1], step, columns if swap else rows)
        k, x0, x1 = _union(k, x0, x1)
        i0 = np.ceil((x0 - origin[0]) / step).astype(int)
        i1 = np.floor((x1 - origin[0]) / step).astype(int)
        keep = i1 >= i0
        k, x0, x1, i0, i1 = k[keep], x0[keep], x1[keep], i0[keep], i1[keep]
        target = crossing.T if swap else crossing
        target[k, i0 - 1] = x0
        target[k, i1] = x1
        if not swap:
            count = lambda column: np.bincount(k * (columns + 1) + column, minlength=rows * (columns + 1))
            change = (count(i0) - count(i1 + 1)).reshape(rows, columns + 1)
            inside = np.cumsum(change, axis=1)[:, :columns] > 0
    nodes_x, nodes_y = low[0] + step * np.arange(columns), low[1] + step * np.arange(rows)
    between = lambda value, node: np.clip(np.where(np.isfinite(value), value, node + step / 2), node, node + step)
    across, along = between(across, nodes_x[None, :]), between(along, nodes_y[:, None])

    # Marching squares. Grid edges are numbered: horizontal ones first, then vertical ones.
    size = rows * columns
    a, b = inside[:-1, :-1], inside[:-1, 1:]
    d, c = inside[1:, :-1], inside[1:, 1:]
    case = (a * 1 + b * 2 + c * 4 + d * 8).astype(int)
    j, i = np.nonzero((case > 0) & (case < 15))
    bottom, top = j * columns + i, (j + 1) * columns + i
    left, right = size + j * columns + i, size + j * columns + i + 1
    # case: pairs (from, to) with the inside on the left; 0 bottom, 1 right, 2 top, 3 left. Saddles join the inside.
    table = {1: [(0, 3)], 2: [(1, 0)], 3: [(1, 3)], 4: [(2, 1)], 5: [(0, 1), (2, 3)], 6: [(2, 0)], 7: [(2, 3)],
             8: [(3, 2)], 9: [(0, 2)], 10: [(3, 0), (1, 2)], 11: [(1, 2)], 12: [(3, 1)], 13: [(0, 1)], 14: [(3, 0)]}
    sides = np.stack([bottom, right, top, left])
    following = {}
    for number, pairs in table.items():
        cells = np.flatnonzero(case[j, i] == number)
        for start, end in pairs:
            following.update(zip(sides[start, cells].tolist(), sides[end, cells].tolist()))
    loops = []
    while following:
        first, at = next(iter(following.items()))
        loop = [first]
        del following[first]
        while at != first:
            loop.append(at)
            at = following.pop(at)
        ids = np.array(loop + [first])
        flat = ids % size
        horizontal = ids < size
        x = np.where(horizontal, across.ravel()[flat], nodes_x[flat % columns])
        y = np.where(horizontal, nodes_y[flat // columns], along.ravel()[flat])
        loops.append(np.c_[x, y])
    return loops


def lengths(line):
    return np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))]


def resample(line, spacing):
    """Points at even arc length, about spacing apart, the ends kept."""
    s = lengths(line)
    at = np.linspace(0, s[-1], max(2, int(round(s[-1] / spacing)) + 1))
    return np.c_[np.interp(at, s, line[:, 0]), np.interp(at, s, line[:, 1])]


def distance_to(points, lines, within=60.0):
    """For each point the distance to the nearest of the polylines, that polyline's number and the arc length on it.
    Parts farther off than `within` are looked at only when a point has nothing nearer."""
    best = np.full(len(points), np.inf)
    which, where = np.zeros(len(points), int), np.zeros(len(points))
    axes = range(points.shape[1])  # one after the other: sums over so short an axis of an array are slow
    for number, line in enumerate(lines):
        all_along, all_s = np.diff(line, axis=0), lengths(line)[:-1]
        least, most = np.minimum(line[:-1], line[1:]), np.maximum(line[:-1], line[1:])
        for start in range(0, len(points), 256):
            p = points[start:start + 256]
            near = ((most >= p.min(0) - within) & (least <= p.max(0) + within)).all(1)
            if not near.any():
                continue
            a, along, s = line[:-1][near], all_along[near], all_s[near]
            square = np.maximum((along ** 2).sum(1), 1e-300)
            beyond = [p[:, None, k] - a[:, k] for k in axes]
            t = np.clip(sum(beyond[k] * along[:, k] for k in axes) / square, 0, 1)
            gap = sum((beyond[k] - t * along[:, k]) ** 2 for k in axes)
            nearest = gap.argmin(1)
            rows = np.arange(len(p))
            distance = np.sqrt(gap[rows, nearest])
            better = distance < best[start:start + 256]
            at = np.flatnonzero(better) + start
            best[at], which[at] = distance[better], number
            where[at] = (s[nearest] + t[rows, nearest] * np.sqrt(square[nearest]))[better]
    if best.max() > within and np.isfinite(within):
        return distance_to(points, lines, np.inf)
    return best, which, where


def inside_polygon(polygon, width=WIDTH, height=HEIGHT):
    """The pixels whose centre a closed polygon encloses (even-odd), as a (height, width) mask."""
    a, b = polygon, np.roll(polygon, -1, axis=0)
    low, high = np.minimum(a[:, 1], b[:, 1]), np.maximum(a[:, 1], b[:, 1])
    first = np.clip(np.ceil(low - 0.5), 0, height).astype(np.int64)
    number = np.clip(np.ceil(high - 0.5), 0, height).astype(np.int64) - first
    edge = np.repeat(np.arange(len(a)), number)
    row = np.arange(len(edge)) - np.repeat(np.cumsum(number) - number, number) + first[edge]
    x = a[edge, 0] + (row + 0.5 - a[edge, 1]) / (b[edge, 1] - a[edge, 1]) * (b[edge, 0] - a[edge, 0])
    column = np.clip(np.ceil(x - 0.5), 0, width).astype(np.int64)
    flips = np.bincount(row * (width + 1) + column, minlength=height * (width + 1)).reshape(height, width + 1)
    mask = np.zeros((height, width), bool)
    if len(row):
        rows = slice(row.min(), row.max() + 1)
        mask[rows] = np.cumsum(flips[rows], axis=1)[:, :width] % 2 == 1
    return mask


# ---------------------------------------------------------------------------------------------------- pictures

BLUE, RED, ORANGE, GREY = (0.10, 0.25, 0.95), (0.90, 0.05, 0.05), (1.0, 0.62, 0.15), (0.74, 0.76, 0.80)


def front(view, points, triangles, scale=1):
    """Of each covered pixel, what is seen of it: (pixel, triangle, weights of the triangle's corners)."""
    xy, z = view.display(points)
    pixel, t = fragments(xy, triangles, view.width, view.height, scale)
    centre = np.c_[pixel % (view.width * scale) + 0.5, pixel // (view.width * scale) + 0.5] / scale
    a, b, c = (xy[triangles[t, k]] for k in range(3))
    cross = lambda p, q: p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    whole = cross(b - a, c - a)
    whole = np.where(np.abs(whole) < 1e-12, 1e-12, whole)
    wa, wb = cross(b - centre, c - centre) / whole, cross(c - centre, a - centre) / whole
    weights = np.clip(np.c_[wa, wb, 1 - wa - wb], 0, 1)
    depth = (weights * (-1 / z if view.perspective else z)[triangles[t]]).sum(1)
    order = np.lexsort((depth, pixel))
    chosen = order[np.r_[np.flatnonzero(np.diff(pixel[order])), len(order) - 1]] if len(order) else order
    return pixel[chosen], t[chosen], weights[chosen]


def depths(view, points, triangles):
    """Camera z of what is seen in each pixel [px, measured in the middle of the model], -inf beside the model; and world units a px."""
    z = view.display(points)[1]
    size = 2 * (-z.mean() if view.perspective else 1.0) / (view.projection[1, 1] * view.height)
    pixel, t, weights = front(view, points, triangles)
    image = np.full(view.width * view.height, -np.inf)
    inverse = (weights * (-1 / z if view.perspective else z)[triangles[t]]).sum(1)
    image[pixel] = (-1 / inverse if view.perspective else inverse) / size
    return image.reshape(view.height, view.width), size


def shaded(view, points, triangles, colours=None, scale=2, wire=0.0):
    """A smooth-shaded picture (height, width, 3) in [0, 1], row 0 at the bottom; colours per point, or grey; wire: how dark the
    edges of triangles are drawn."""
    pixel, t, weights = front(view, points, triangles, scale)

    facet = np.cross(points[triangles[:, 1]] - points[triangles[:, 0]], points[triangles[:, 2]] - points[triangles[:, 0]])
    normals = np.zeros_like(points)
    for k in range(3):
        np.add.at(normals, triangles[:, k], facet)
    normals = normals @ view.view[:3, :3].T
    n = (weights[:, :, None] * normals[triangles[t]]).sum(1)
    n /= np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300)
    light = np.array([-0.35, 0.5, 0.8]) / np.linalg.norm([-0.35, 0.5, 0.8])
    shade = 0.35 + 0.65 * np.clip(n @ light, 0, 1)
    colour = np.broadcast_to(GREY, points.shape) if colours is None else colours
    image = np.ones((view.height * scale * view.width * scale, 3))
    image[pixel] = shade[:, None] * (weights[:, :, None] * colour[triangles[t]]).sum(1)
    if wire:
        corner = view.display(points)[0][triangles[t]]
        side = np.roll(corner, -1, axis=1) - np.roll(corner, 1, axis=1)  # across from each corner
        twice = np.abs(side[:, 0, 0] * side[:, 1, 1] - side[:, 0, 1] * side[:, 1, 0])
        away = (weights * twice[:, None] / np.maximum(np.linalg.norm(side, axis=2), 1e-9)).min(1) * scale
        image[pixel] *= 1 - wire * np.clip(1.1 - away, 0, 1)[:, None]
    return image.reshape(view.height, scale, view.width, scale, 3).mean((1, 3))


def draw(image, line, colour, width=2.0):
    """Draws a polyline into a picture, with soft edges."""
    height, columns = image.shape[:2]
    points = resample(line, 0.5)
    reach = int(np.ceil(width)) + 1
    offset = np.stack(np.meshgrid(np.arange(-reach, reach + 1), np.arange(-reach, reach + 1)), -1).reshape(-1, 2)
    node = (np.floor(points)[:, None] + offset).astype(int)
    cover = np.clip(width / 2 + 0.5 - np.linalg.norm(node + 0.5 - points[:, None], axis=2), 0, 1)
    ok = (node[..., 0] >= 0) & (node[..., 0] < columns) & (node[..., 1] >= 0) & (node[..., 1] < height)
    alpha = np.zeros((height, columns))
    np.maximum.at(alpha, (node[ok][:, 1], node[ok][:, 0]), cover[ok])
    image[:] = image * (1 - alpha[..., None]) + np.array(colour) * alpha[..., None]


def write_text(image, text, x, y, size=14, colour=(0, 0, 0)):
    """Writes a line of text with its lower left corner at (x, y)."""
    from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer
    import vtkmodules.vtkRenderingFreeType  # noqa: F401  registers the text renderer
    style = vtkTextProperty()
    style.SetFontSize(size)
    style.SetColor(1, 1, 1)
    stamp, used = vtkImageData(), [0, 0]
    if not vtkTextRenderer.GetInstance().RenderString(style, text, stamp, used, 72):
        return
    columns, rows, _ = stamp.GetDimensions()
    alpha = vtk_to_numpy(stamp.GetPointData().GetScalars()).reshape(rows, columns, -1)[:used[1], :used[0], 3] / 255.0
    alpha = alpha[:max(0, image.shape[0] - y), :max(0, image.shape[1] - x)]
    part = image[y:y + alpha.shape[0], x:x + alpha.shape[1]]
    part[:] = part * (1 - alpha[..., None]) + np.array(colour) * alpha[..., None]


def save(image, path):
    """Writes a picture as PNG."""
    height, width = image.shape[:2]
    data = vtkImageData()
    data.SetDimensions(width, height, 1)
    pixels = (np.clip(image, 0, 1) * 255 + 0.5).astype(np.uint8).reshape(-1, 3)
    data.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    writer.Write()


def halve(image):
    height, width = image.shape[0] // 2 * 2, image.shape[1] // 2 * 2
    return image[:height, :width].reshape(height // 2, 2, width // 2, 2, 3).mean((1, 3))


def load(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    columns, rows, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(rows, columns, -1)[:, :, :3] / 255.0
