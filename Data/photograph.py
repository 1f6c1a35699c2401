"""A photograph of a toy of modelling clay on a table, rendered: a lamp, shadows, and a lens that is sharp in the toy's plane alone.

Places are (x, y, z): px of the picture, and px towards the eye from the plane through the toy's middle. The toy is as thick behind that plane.
"""
import numpy as np

from painting import LIGHT, blurred, mixed, step

TILT = np.radians(15.0)  # the eye looks down by so much
LAMP = LIGHT / np.linalg.norm(LIGHT)
UP = np.array([0.0, np.cos(TILT), np.sin(TILT)])  # away from the table
CLOTH, STRIPE, WALL = (0.48, 0.39, 0.54), (0.56, 0.48, 0.62), (0.47, 0.45, 0.58)
DIM = 0.6  # share of the room's light that comes off the toy where this hides the room
EDGE = 262  # px up the picture, where the table ends


def linear(colour):
    return np.clip(colour, 0.0, 1.0) ** 2.2


def soft(colours, sigma):
    return np.stack([blurred(colours[..., k], sigma) for k in range(3)], axis=-1)


def rounded(field):
    """The thickness of a field's inside, as of a tube: its square u, with u = 0 at the edge, solves Laplace u = -2."""
    inside = field > 0.0
    u = np.zeros_like(field[::16, ::16])
    for size in (16, 8, 4, 2, 1):
        here = inside[::size, ::size]
        u = np.where(here, np.repeat(np.repeat(u, 2, 0), 2, 1)[:here.shape[0], :here.shape[1]] if size < 16 else u, 0.0)
        for _ in range(160 if size > 2 else 40):
            u = here * (0.25 * (np.roll(u, 1, 0) + np.roll(u, -1, 0) + np.roll(u, 1, 1) + np.roll(u, -1, 1)) + 0.5 * size ** 2)
    return np.sqrt(u)


def open_to(way, places, height, reach, steps):
    """Whether the toy hides nothing of what is that way from places."""
    x, y, z = (np.float32(each) for each in places)
    clear = np.ones(x.shape, bool)
    for t in reach * (np.arange(1, steps + 1) / steps) ** 2:
        i, j = (np.clip(at + t * along, 0, size - 1).astype(np.int32) for at, along, size in zip((x, y), way, height.shape[::-1]))
        clear &= np.abs(z + t * way[2]) > height[j, i] - 1.5
    return clear


def light(places, normals, height, floor):
    """The light that falls on places: the lamp's, which is wide, and the room's with what the table gives back."""
    direct, room, turns = 0.0, 0.0, 2.4 * np.arange(32)  # the golden angle, nearly
    for k in range(8):
        way = LAMP + 0.2 * np.array([np.cos(turns[k]), 0.5 * np.sin(turns[k]), np.sin(turns[k])]) * np.sqrt((k + 0.5) / 8)
        direct = direct + open_to(way, places, height, 560.0, 36) / 8
    direct = direct * np.maximum(normals @ LAMP, 0.0)
    for k, rise in enumerate((np.arange(32) + 0.5) / 16 - 1.0):
        flat = np.sqrt(1.0 - rise ** 2)
        way = np.array([flat * np.cos(turns[k]), rise, flat * np.sin(turns[k])])
        falls = np.maximum(normals @ way, 0.0) * np.where(open_to(way, places, height, 170.0, 14), 1.0, DIM) / 8
        room = room + falls[..., None] * (np.array([0.92, 0.97, 1.08]) if way @ UP > 0 else 0.5 * floor)
    return direct, room


def photographed(toy, whole, height, table):
    """Makes a picture of a toy's own colours one of the toy, of that thickness, on a table that its middle plane meets at that height [px]."""
    x, y, away = toy.x, toy.y, np.hypot(toy.x - 150, toy.y - toy.height)  # from where the wall is lightest
    height = np.float32(np.where(whole > 0.0, height, 0.0))
    floor = linear(CLOTH)
    # Table and wall, the toy's shadow on them; the farther from the toy, the less sharp.
    depth = (table - y) / np.tan(TILT)
    shrinks = 1.0 - depth / 2400.0
    u, v = (x - 0.5 * toy.width) * shrinks, depth * shrinks
    stripes = 0.5 * step(np.abs((u + 40) % 150 - 75), 60, 64) + 0.5 * step(np.abs((v + 30) % 150 - 75), 60, 64)
    weave = 1.0 + 0.05 * toy.mottled(21, 0.9) + 0.04 * toy.mottled(22, 24.0)
    below = y < EDGE + 40
    places = [each[below] for each in (x, y, depth)]
    lit, room = np.ones(x.shape), np.ones(x.shape + (3,))
    lit[below], room[below] = light(places, np.broadcast_to(UP, (below.sum(), 3)), height, floor)
    cloth = linear(mixed(CLOTH, STRIPE, stripes)) * weave[..., None] * (blurred(lit, 2.0)[..., None] + 0.7 * soft(room, 5.0))
    wall = linear(WALL) * (0.95 * np.exp(-(away / 620.0) ** 2) + 0.16)[..., None]
    scene = mixed(cloth, wall, step(y, EDGE - 1, EDGE + 1))
    sharp = np.abs(depth) / 36.0
    for sigma in (2.0, 4.0, 8.0):
        scene = mixed(scene, soft(scene, sigma), step(sharp, 0.4 * sigma, 1.2 * sigma))
    # The toy: clay, dull, with a broad highlight.
    on = whole > -2.0
    slope_y, slope_x = np.gradient(blurred(height, 1.2))
    normals = np.stack([-slope_x, -slope_y, np.full(x.shape, 0.9)], axis=-1)[on]
    normals /= np.linalg.norm(normals, axis=-1)[:, None]
    direct, room = light([x[on], y[on], height[on]], normals, height, floor)
    half = LAMP + (0.0, 0.0, 1.0)
    gloss = np.maximum(normals @ (half / np.linalg.norm(half)), 0.0) ** 22
    clay = np.zeros(x.shape + (3,))
    clay[on] = linear(toy.rgb[on]) * (1.3 * direct[:, None] + 0.6 * room) + (0.11 * gloss * np.minimum(2 * direct, 1.0))[:, None]
    scene = mixed(scene, clay, toy.cover(whole))
    # The lens and the film.
    corner = np.hypot(x / toy.width - 0.5, y / toy.height - 0.5) ** 2
    scene = soft(scene, 0.7) * (1.0 - 0.65 * corner)[..., None] * (1.04, 1.0, 0.95)
    scene = 1.06 * scene / (1.0 + 0.06 * scene)
    toy.rgb = np.clip(scene, 0.0, 1.0) ** (1.0 / 2.2) + 0.0032 * toy.mottled(23, 1.1)[..., None]
