"""The pictures of Data/Drawings and what is drawn over them. Places are display px of each picture, from its lower left corner."""
from typing import NamedTuple, Optional

import numpy as np

from painting import Picture, arc, blurred, circle, mixed, spline, step, union

HOLE, TUNNEL = 1, 2  # what a region becomes, as the cell array Treatment says it
SNAP_RADIUS = 10.0  # of magnetic strokes [image px]


class Line(NamedTuple):
    """A stroke: where the pen goes."""

    course: np.ndarray
    closed: bool = False
    treatment: int = 0
    edge: Optional[np.ndarray] = None  # of a magnetic stroke: the closed edge in the picture that it is to snap to


class Drawing(NamedTuple):
    picture: Picture
    lines: list


def started(loop, at):
    """A closed curve, begun at its point nearest to a place."""
    return np.roll(loop, -int(np.argmin(np.linalg.norm(loop - at, axis=1))), axis=0)


def outline(picture, field, at):
    """The closed stroke on a field's longest contour, begun near a place."""
    return Line(started(picture.contours(field)[0], at), closed=True)


def shadow(picture, field, offset, blur, depth):
    """A soft shadow on the ground, thrown down to the right."""
    cover = np.roll(picture.cover(field), offset, axis=(1, 0))
    picture.shade(-depth, blurred(cover, blur))


# ------------------------------------------------------------------------------------------------------------ fish

def fish():
    """A reef fish that looks to the left: gold below, blue above, scales, fins with rays."""
    p = Picture(1024, 640)
    p.toned((0.80, 0.92, 0.95), (0.93, 0.96, 0.90), (420, 400), 0.5)
    upper = [(118, 322), (150, 366), (212, 424), (300, 468), (410, 492), (520, 484), (620, 446), (710, 394), (780, 362), (822, 352)]
    lower = [(822, 296), (780, 288), (710, 258), (620, 206), (520, 168), (410, 152), (300, 166), (212, 214), (156, 268), (126, 298)]
    body = p.inside(spline(upper + lower, closed=True))
    tail = p.inside(spline([(800, 344), (850, 384), (900, 446), (962, 520), (972, 470), (944, 390), (926, 324), (942, 258), (974, 178),
                            (962, 128), (902, 198), (850, 264), (800, 304)], closed=True))
    dorsal = p.inside(spline([(284, 440), (300, 496), (336, 548), (386, 578), (430, 576), (470, 582), (520, 572), (556, 574), (610, 552),
                              (650, 540), (694, 496), (720, 462), (716, 424), (690, 380), (560, 430), (400, 450)], closed=True))
    anal = p.inside(spline([(520, 200), (545, 130), (590, 88), (640, 84), (690, 108), (722, 152), (724, 200), (704, 252), (620, 240)],
                           closed=True))
    pelvic = p.inside(spline([(318, 190), (326, 130), (352, 84), (392, 58), (420, 72), (434, 112), (440, 172), (380, 200)], closed=True))
    whole = union(body, tail, dorsal, anal, pelvic, blend=14.0)
    line = outline(p, whole, (212, 424))
    silhouette = p.inside(line.course[::2])

    # What lies where in the body: u along it, v across, -1 to 1.
    xs = np.arange(p.width) + 0.5
    high, low = (np.interp(xs, *np.array(sorted(side)).T) for side in (spline(upper).tolist(), spline(lower).tolist()))
    v = (p.y - (high + low) / 2) / np.maximum((high - low) / 2, 8.0)
    rays = lambda root, count, start: 0.5 + 0.5 * np.cos(count * np.arctan2(p.y - root[1], p.x - root[0]) + start)

    shadow(p, silhouette, (20, -26), 16, 0.12)
    # fins: coral, paler at their ends, rays darker
    for field, root, count, start in ((tail, (748, 324), 72, 0.6), (dorsal, (500, 210), 84, 0.0), (anal, (600, 380), 80, 0.4),
                                      (pelvic, (356, 250), 64, 0.0)):
        away = np.hypot(p.x - root[0], p.y - root[1])
        reach = away[field > 0]
        t = step(away, reach.min(), reach.max())
        colour = mixed((0.90, 0.36, 0.22), (1.0, 0.72, 0.34), t)
        colour = colour * (1.0 - 0.30 * (rays(root, count, start) ** 6) * (1.0 - 0.4 * t))[..., None]
        cover = p.cover(np.minimum(union(field, body, blend=14.0), silhouette)) * (field > body - 40)
        p.paint(colour, cover * p.cover(silhouette))
        p.paint((1.0, 0.86, 0.60), 0.8 * step(-field, -9, -1) * cover * (body < -3))
    # body: blue back, turquoise, gold belly
    share = np.clip(0.5 + 0.5 * v + 0.05 * np.sin(p.x / 46.0), 0, 1)
    colour = mixed((0.99, 0.86, 0.52), (0.18, 0.66, 0.68), step(share, 0.18, 0.58))
    colour = mixed(colour, (0.07, 0.27, 0.50), step(share, 0.56, 0.96))
    root = 1.0 - step(p.x, 762, 832)  # into the tail it fades
    skin = p.cover(np.minimum(body, silhouette) + 1.0, 2.0) * root
    p.paint(colour, skin)
    for at, width, dark in ((372, 40, 0.5), (520, 36, 0.42), (656, 30, 0.36)):  # bands, bent with the flank
        band = 1.0 - step(np.abs(p.x - at - 34 * (1 - v * v)), width * 0.45, width)
        p.paint((0.08, 0.24, 0.42), dark * band * step(v, -0.62, 0.10) * skin)
    gill = spline([(322, 462), (352, 420), (364, 362), (360, 300), (338, 240), (300, 200)])
    across, bent = (v * 7.6), (p.x - 12.0 * np.cos(v * 1.6)) / 22.0
    rim, at = p.scales(bent, across)
    behind = step(p.x - np.interp(p.y, gill[::-1, 1], gill[::-1, 0]), 2, 26) * step(body, 4, 20) * step(820 - p.x, 0, 60)
    p.shade(0.16 * at - 0.30 * rim + 0.10 * step(rim, 0.25, 0.5) * (rim < 0.5), behind * skin)
    side = spline([(366, 392), (450, 398), (560, 380), (680, 344), (800, 326)])
    p.paint((0.98, 0.92, 0.66), 0.45 * p.line(side, 4.0, 1.2) * skin)
    # head: gill cover, mouth, cheek
    p.paint((0.98, 0.78, 0.46), 0.55 * np.exp(-((p.x - 250) / 62.0) ** 2 - ((p.y - 268) / 58.0) ** 2) * skin)
    p.paint((0.06, 0.22, 0.36), 0.75 * p.line(gill, 5.0, 1.5) * skin)
    p.paint((1.0, 0.96, 0.80), 0.5 * p.line(gill - (6, 0), 3.0, 1.5) * skin)
    mouth = spline([(121, 314), (150, 306), (178, 292), (188, 280)])
    p.paint((0.36, 0.16, 0.14), 0.9 * p.line(mouth, 4.5, 1.0) * skin)
    # the light on all of it, then the eye and the fin at the breast
    p.shade(0.62 * p.relief(blurred(np.minimum(body, silhouette), 2.0), 88.0, 8.0), step(body, -2, 10) * root)
    p.shade(0.30 * p.relief(silhouette, 26.0, 3.0), (body < 2) * p.cover(silhouette))
    breast = p.inside(spline([(396, 296), (430, 318), (492, 318), (548, 292), (566, 258), (536, 236), (474, 234), (420, 256)], closed=True))
    shadow(p, breast, (7, -10), 7, 0.30)
    away = np.hypot(p.x - 372, p.y - 290)
    p.paint(mixed((0.92, 0.42, 0.24), (1.0, 0.78, 0.40), step(away, 30, 190)) * (1 - 0.28 * rays((372, 290), 84, 0.0) ** 6)[..., None],
            p.cover(breast))
    p.shade(0.25 * p.relief(breast, 24.0), p.cover(breast))
    eye = np.hypot(p.x - 236, p.y - 356)
    p.paint((0.05, 0.18, 0.28), p.cover(33 - eye, 1.0))
    p.paint(mixed((0.98, 0.80, 0.28), (0.90, 0.46, 0.12), step(eye, 14, 28)), p.cover(28 - eye, 0.8))
    p.paint((0.03, 0.04, 0.07), p.cover(17 - eye, 0.8))
    p.shade(0.5 * p.relief(30 - eye, 30.0, 2.0), p.cover(28 - eye))
    p.paint((1, 1, 1), 0.95 * p.cover(6.5 - np.hypot(p.x - 228, p.y - 364), 0.9))
    p.paint((1, 1, 1), 0.5 * p.cover(3.0 - np.hypot(p.x - 244, p.y - 346), 0.9))
    p.paint((0.10, 0.16, 0.24), 0.55 * p.line(np.vstack([line.course, line.course[:1]]), 2.6, 0.6))

    def ray(root, angle, first, last):
        way = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        return Line(np.linspace(np.array(root) + first * way, np.array(root) + last * way, 24))

    features = [Line(gill[6:-5]), Line(circle((236, 356), 32), closed=True), Line(mouth[10:]),
                Line(started(p.contours(breast)[0], (400, 296)), closed=True)]
    for sign in (1, -1):
        for way in (((836, 30), (884, 80), (938, 156)), ((838, 14), (880, 34), (918, 62))):
            features += [Line(spline([(x, 324 + sign * y) for x, y in way]))]
    features += [ray((500, 210), *where) for where in ((111, 308, 366), (91, 292, 350), (72, 286, 346), (58, 280, 328))]
    features += [ray((600, 380), *where) for where in ((-92, 208, 262), (-80, 206, 270), (-68, 206, 262))]
    return Drawing(p, [line, *features])


# ------------------------------------------------------------------------------------------------------------- mug

def mug():
    """A stoneware mug with a glazed band; its handle is a hole."""
    p = Picture(720, 640)
    p.toned((0.95, 0.93, 0.90), (0.86, 0.80, 0.73), (330, 420), 0.4)
    wall = p.inside(np.vstack([spline([(116, 520), (122, 400), (132, 260), (142, 150), (158, 110), (196, 92), (300, 84), (404, 92),
                                       (442, 110), (458, 150), (468, 260), (478, 400), (484, 520)])[::2], arc((300, 520), (184, 42), 2, 178)]))
    ring = p.limb([(456, 452), (540, 456), (590, 410), (596, 330), (560, 262), (500, 226), (448, 214)], [25, 26, 27, 26, 25, 25, 26])
    whole = union(wall, ring, blend=16.0)
    loops = p.contours(whole)
    silhouette = p.inside(loops[0][::2])
    gap = p.inside(loops[1][::2])
    shape = np.minimum(silhouette, -gap)

    ground = np.exp(-(np.maximum(np.hypot((p.x - 340) / 1.0, (p.y - 96) * 4.6) - 170, 0) / 70.0) ** 2)
    p.shade(-0.34, ground)
    cover = p.cover(shape)
    p.paint((0.83, 0.87, 0.86), cover)
    down = 42 * (1 - np.sqrt(np.clip(1 - ((p.x - 300) / 190.0) ** 2, 0, 1)))  # rings about the mug are ellipses
    level = p.y - down + 42
    speck = step(p.mottled(5, 1.1), 2.5, 3.1)
    p.paint((0.55, 0.48, 0.42), 0.75 * speck * cover)
    # the band: indigo, with ochre leaves between two lines
    on_wall = p.cover(np.minimum(wall, shape), 0.8)
    band = p.cover(np.minimum(level - 226, 410 - level), 1.0) * on_wall
    p.paint((0.13, 0.25, 0.45), band)
    around = 300 + 184 * np.arcsin(np.clip((p.x - 300) / 186.0, -1, 1))  # how far round the mug
    for k in range(-4, 5):
        for sign in (-1, 1):
            turned = np.radians(62 * sign)
            dx, dy = around - (300 + 66 * k) - 17 * sign, level - 320
            a, b = np.cos(turned) * dx + np.sin(turned) * dy, -np.sin(turned) * dx + np.cos(turned) * dy
            p.paint((0.93, 0.70, 0.30), p.cover(13 * (1 - (a / 36.0) ** 2) - np.abs(b), 1.0) * (np.abs(a) < 38) * band)
        p.paint((0.95, 0.93, 0.88), p.cover(8 - np.hypot(around - 300 - 66 * k - 33, level - 318), 1.0) * band)
    for height in (240, 396):
        p.paint((0.96, 0.94, 0.90), p.cover(3.2 - np.abs(level - height), 1.0) * on_wall)
    p.paint((0.42, 0.31, 0.25), p.cover(116 - level, 2.0) * on_wall)  # the foot is bare clay
    # light, and the inside
    bent = np.clip((p.x - 300) / 186.0, -1, 1)
    p.shade(0.42 * np.exp(-((bent + 0.52) / 0.16) ** 2) - 0.62 * step(bent, 0.1, 1.0) - 0.30 * step(-bent, 0.62, 1.0), on_wall)
    on_ring = cover * (1 - p.cover(wall, 0.8))
    p.shade(0.75 * p.relief(ring, 26.0, 2.0), on_ring)
    p.shade(-0.22 * step(-wall, -12, 0) * step(wall, -26, 0), on_ring)
    mouth = np.hypot((p.x - 300) / 184.0, (p.y - 520) / 42.0)
    inner = np.hypot((p.x - 300) / 170.0, (p.y - 518) / 34.0)
    p.paint((0.90, 0.92, 0.90), p.cover((1 - mouth) * 42, 0.8))
    p.paint(mixed((0.66, 0.67, 0.65), (0.80, 0.81, 0.79), step(p.x, 180, 440)), p.cover((1 - inner) * 34, 0.8))
    coffee = np.hypot((p.x - 300) / 158.0, (p.y - 507) / 25.0)
    p.paint(mixed((0.30, 0.17, 0.10), (0.45, 0.28, 0.17), np.clip(coffee, 0, 1) ** 6),
            p.cover(np.minimum((1 - coffee) * 25, (1 - inner) * 34), 0.8))
    p.shade(0.5 * np.exp(-((p.x - 238) / 44.0) ** 2 - ((p.y - 512) / 6.0) ** 2), p.cover((1 - coffee) * 25, 1.0))
    p.paint((0.25, 0.22, 0.22), 0.5 * cover * step(-shape, -2.6, -0.4))

    lines = [Line(started(loops[0], (116, 400)), closed=True), Line(started(loops[1], (520, 430)), closed=True, treatment=HOLE)]
    ellipse = lambda height: np.column_stack([x := np.linspace(154, 446, 60), height - 42 + 42 * (1 - np.sqrt(1 - ((x - 300) / 190.0) ** 2))])
    lines += [Line(arc((300, 520), (166, 42), 194, 346)), Line(ellipse(396)), Line(ellipse(240))]
    return Drawing(p, lines)


# --------------------------------------------------------------------------------------------------------- padlock

def padlock():
    """A brass padlock: the shackle closes a hole, the keyhole goes through."""
    p = Picture(576, 768)
    p.toned((0.90, 0.92, 0.94), (0.78, 0.80, 0.83), (250, 420), 0.5)

    def box(centre, half, corner):
        dx, dy = np.abs(p.x - centre[0]) - half[0] + corner, np.abs(p.y - centre[1]) - half[1] + corner
        return corner - np.hypot(np.maximum(dx, 0), np.maximum(dy, 0)) - np.minimum(np.maximum(dx, dy), 0)

    case = box((288, 262), (206, 186), 54)
    shackle = p.tube(np.vstack([[(164, 400)], arc((288, 556), 124, 180, 0, 40), [(412, 400)]]), 34)
    whole = union(case, shackle)
    loops = p.contours(whole)
    shape = np.minimum(p.inside(loops[0][::2]), -p.inside(loops[1][::2]))
    keyhole = union(31 - np.hypot(p.x - 288, p.y - 286), p.inside(np.array([(274, 290), (302, 290), (314, 186), (262, 186)], float)))

    shadow(p, whole, (18, -18), 14, 0.28)
    steel = p.cover(np.minimum(shackle, shape))
    p.paint((0.66, 0.69, 0.73), steel)
    p.shade(1.15 * p.relief(shackle, 34.0, 2.0), steel)
    p.shade(0.35 * np.exp(-((shackle - 21) / 4.0) ** 2) * step(p.y - p.x, 80, 360), steel)
    p.shade(-0.5 * step(452 - p.y, -36, 2), steel)
    brass = p.cover(case)
    grain = blurred(np.repeat(np.random.RandomState(3).standard_normal((p.height, 1)), p.width, axis=1), 0.8)
    p.paint(mixed((0.80, 0.58, 0.22), (0.95, 0.79, 0.42), step(p.y + 0.45 * (288 - p.x), 90, 460)), brass)
    p.shade(0.035 * grain + 0.10 * np.exp(-((p.y + 0.5 * p.x - 500) / 60.0) ** 2), brass)
    p.shade(0.95 * p.relief(case, 22.0, 2.5), brass)
    inset = case - 34
    p.shade(-0.42 * np.exp(-(inset / 2.4) ** 2) + 0.34 * np.exp(-((inset + 5.0) / 2.2) ** 2), brass)
    for x in (132, 444):
        for y in (108, 416):
            rivet = np.hypot(p.x - x, p.y - y)
            p.paint((0.72, 0.52, 0.20), p.cover(11 - rivet))
            p.shade(0.9 * p.relief(11 - rivet, 11.0, 1.0), p.cover(11 - rivet))
    plate = union(78 - np.hypot(p.x - 288, p.y - 286), box((288, 232), (54, 88), 40), blend=20.0)
    p.shade(-0.30, np.roll(p.cover(plate, 4.0), (4, -5), axis=(1, 0)) * (1 - p.cover(plate)))
    p.paint((0.74, 0.76, 0.78), p.cover(plate))
    p.shade(0.75 * p.relief(plate, 10.0, 1.6) + 0.02 * grain, p.cover(plate))
    p.paint(mixed((0.06, 0.05, 0.05), (0.16, 0.14, 0.12), step(p.y, 180, 320)), p.cover(keyhole))
    p.shade(-0.4 * np.exp(-((keyhole + 2.2) / 2.0) ** 2), keyhole < 0)
    p.paint((0.22, 0.18, 0.14), 0.5 * p.cover(shape) * step(-shape, -2.6, -0.4))
    return Drawing(p, [Line(started(loops[0], (82, 262)), closed=True),
                       Line(started(loops[1], (288, 640)), closed=True, treatment=HOLE),
                       Line(started(p.contours(keyhole)[0], (288, 317)), closed=True, treatment=TUNNEL)])


# ----------------------------------------------------------------------------------------------------------- heron

def heron():
    """A grey heron on thin legs; drawn loosely beside its edges, for the pen that finds them."""
    p = Picture(768, 1024)
    p.toned((0.90, 0.93, 0.93), (0.95, 0.94, 0.89), (330, 640), 0.2)
    body = p.inside(spline([(318, 616), (340, 660), (400, 678), (470, 656), (546, 604), (612, 536), (664, 468), (700, 412), (660, 408),
                            (604, 428), (540, 432), (470, 430), (404, 446), (350, 492), (318, 556)], closed=True))
    neck = p.limb([(378, 610), (330, 640), (300, 690), (322, 744), (366, 786), (388, 832), (368, 876), (330, 900)],
                  [50, 42, 31, 24, 20, 20, 22, 24])
    head = p.limb([(356, 898), (316, 908), (280, 902)], [20, 25, 17])
    bill = p.tube([(284, 904), (206, 890), (130, 872)], [12, 8.5, 5.5])
    plume = p.limb([(336, 922), (386, 928), (432, 908), (468, 874)], [8, 7, 5.5, 4])
    near = union(p.limb([(452, 470), (448, 400), (440, 346)], [38, 22, 10]),
                 p.limb([(440, 346), (436, 300), (430, 200), (424, 92)], [8.5, 11, 7, 7]),
                 p.tube([(424, 92), (352, 70)], [7, 5]), p.tube([(424, 92), (410, 46)], [7, 5]), p.tube([(424, 92), (466, 70)], [7, 5]),
                 blend=8.0)
    far = union(p.limb([(540, 460), (546, 400), (552, 350)], [34, 20, 10]),
                p.limb([(552, 350), (556, 306), (566, 210), (572, 108)], [8, 10.5, 6.5, 6.5]),
                p.tube([(572, 108), (512, 88)], [6.5, 5]), p.tube([(572, 108), (562, 62)], [6.5, 5]),
                p.tube([(572, 108), (616, 86)], [6.5, 5]), blend=8.0)
    whole = union(union(body, neck, blend=26.0), head, near, far, blend=10.0)
    whole = union(whole, bill, plume, blend=4.0)
    edge = p.contours(whole)[0]
    shape = p.inside(edge[::2])
    cover = p.cover(shape)

    # legs, then the body over them
    p.paint((0.47, 0.40, 0.26), cover)
    p.paint((0.38, 0.33, 0.23), cover * (far > near))
    thigh = step(p.y, 352, 400)
    slate = mixed((0.33, 0.39, 0.47), (0.47, 0.54, 0.62), step(p.y - 0.5 * p.x, 150, 480))
    p.paint(slate, cover * thigh)
    stem = p.cover(union(neck, head, blend=10.0), 6.0) * cover
    p.paint(mixed((0.62, 0.60, 0.60), (0.55, 0.47, 0.44), step(p.y, 640, 860)), stem * (1 - step(body, 12, 70) * (p.x > 330)))
    # flecks down the front of the neck, the breast's long feathers
    front = spline([(318, 872), (352, 838), (352, 800), (314, 760), (282, 712), (288, 650), (326, 590)])
    for k in range(6, 92, 5):
        a = front[k] + (12 if k % 2 else 5, 0)
        p.paint((0.16, 0.16, 0.20), 0.85 * p.cover(p.tube([a, a + (3, -13)], [3.2, 1.2])) * cover)
    for k in range(7):
        start = np.array((322 + 9 * k, 606 - 5 * k))
        p.paint((0.74, 0.74, 0.75), 0.8 * p.line(spline([start, start + (6, -44), start + (24, -98)]), 4.5, 1.2) * cover * step(shape, 8, 16))
    # the wing: coverts as rows of scales, long dark quills behind
    wing = p.inside(spline([(366, 600), (404, 634), (470, 622), (546, 572), (606, 512), (644, 458), (590, 466), (520, 472), (446, 484),
                            (392, 526)], closed=True))
    p.paint(mixed((0.42, 0.50, 0.60), (0.56, 0.63, 0.71), step(p.y, 450, 640)), p.cover(wing, 0.8))
    turned = np.radians(-38)
    x, y = p.x - 380, p.y - 600
    u, v = (np.cos(turned) * x + np.sin(turned) * y) / 30.0, (-np.sin(turned) * x + np.cos(turned) * y) / 21.0
    rim, at = p.scales(u, v)
    p.shade(0.12 * at - 0.34 * rim, p.cover(wing - 3, 2.0) * (1 - step(u, 5.2, 6.6)))
    quills = step(u, 4.0, 5.4) * p.cover(wing - 3, 2.0)
    p.paint((0.24, 0.30, 0.40), 0.8 * quills)
    for t in np.linspace(0, 1, 8):
        first, last = (1 - t) * np.array((500, 606)) + t * np.array((430, 492)), (1 - t) * np.array((652, 452)) + t * np.array((548, 462))
        quill = spline([first, 0.5 * (first + last) + (14, 12), last])
        p.paint((0.10, 0.13, 0.19), 0.8 * p.line(quill, 3.4, 1.2) * quills)
        p.paint((0.62, 0.68, 0.76), 0.45 * p.line(quill + (3, 3), 2.2, 1.2) * quills)
    p.shade(-0.36 * step(wing, -24, 0), (wing < 0) * cover * (p.y < 640))
    # head: black brow into the plume, yellow eye, ochre bill
    p.paint((0.10, 0.12, 0.17), p.cover(union(plume, p.limb([(282, 914), (312, 920), (344, 922)], [5, 8, 8]), blend=6.0)) * cover)
    p.paint(mixed((0.80, 0.62, 0.20), (0.60, 0.42, 0.16), step(p.x, 130, 280)),
            p.cover(np.minimum(bill, shape)) * (1 - step(p.x + 0.8 * np.abs(p.y - 904), 276, 296)))
    p.paint((0.36, 0.24, 0.10), 0.8 * p.line(spline([(136, 873), (206, 889), (286, 900)]), 2.2, 0.8) * cover)
    p.shade(0.55 * p.relief(blurred(shape, 1.0), 60.0, 4.0), cover * np.maximum(step(p.y, 380, 440), 0.0))
    p.shade(0.40 * p.relief(shape, 8.0, 1.0), cover * (1 - step(p.y, 380, 440)))
    eye = np.hypot(p.x - 300, p.y - 907)
    p.paint((0.08, 0.08, 0.10), p.cover(8.5 - eye))
    p.paint((0.96, 0.80, 0.22), p.cover(7.0 - eye))
    p.paint((0.04, 0.04, 0.05), p.cover(3.8 - eye))
    p.paint((1, 1, 1), p.cover(1.5 - np.hypot(p.x - 298, p.y - 909)))
    p.paint((0.10, 0.11, 0.14), 0.55 * cover * step(-shape, -2.4, -0.4))

    # The hand keeps 3 to 6 px outside the edge.
    beside = 4.5 + np.clip(0.6 * p.mottled(11, 45), -1.2, 1.2)
    return Drawing(p, [Line(started(p.contours(shape + beside)[0], (590, 560)), closed=True, edge=edge),
                       Line(started(p.contours(wing + beside)[0], (366, 600)), closed=True, edge=p.contours(wing)[0])])


# ------------------------------------------------------------------------------------------------------------ leaf

def leaf():
    """An oak leaf in autumn: lobes along a bent rib, veins into each."""
    p = Picture(960, 640)
    p.toned((0.96, 0.95, 0.92), (0.92, 0.90, 0.85), (460, 330), 0.25)
    rib = spline([(86, 196), (170, 226), (300, 270), (460, 318), (620, 362), (770, 402), (890, 430)], steps=60)
    along = np.linspace(0, 1, len(rib))
    tangent = np.gradient(rib, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])

    def side(t, sign):
        """Half the width at a share of the rib, and how far forward its margin leans."""
        t0 = 0.16
        s = np.clip((t - t0) / (1 - t0), 0, 1)
        envelope = 205 * np.sin(np.pi * np.clip(s, 0, 1) ** 0.92) ** 0.62 * (0.62 + 0.5 * s)
        wave = 0.5 - 0.5 * np.cos(2 * np.pi * (4.0 * s - 0.62 - 0.10 * sign))  # 1 in a bay
        lobes = 1.0 - 0.56 * wave ** 2.4
        return np.where(t < t0, 0.0, envelope * lobes)

    at = lambda t: np.column_stack([np.interp(t, along, rib[:, k]) for k in (0, 1)])
    across = lambda t: np.column_stack([np.interp(t, along, normal[:, k]) for k in (0, 1)])
    forward = lambda t: np.column_stack([np.interp(t, along, tangent[:, k]) for k in (0, 1)])

    def margin(sign):
        t = np.linspace(0.16, 1.0, 260)
        w = side(t, sign)
        return at(t) + sign * across(t) * w[:, None] + forward(t) * (0.42 * w * (1 - t) ** 0.5)[:, None]

    blade = p.inside(np.vstack([margin(1), margin(-1)[::-1]]))
    stalk = p.tube(rib[::6][:18], np.linspace(11, 7.5, 18))
    whole = union(blurred(blade, 2.0), stalk, blend=16.0)
    line = outline(p, whole, (480, 520))
    shape = p.inside(line.course[::2])
    cover = p.cover(shape)

    shadow(p, shape, (12, -16), 12, 0.22)
    ribs = p.away(rib, 90)
    mottle = p.mottled(8, 26)
    warm = step(shape + 14 * mottle, 4, 90)
    p.paint(mixed((0.72, 0.22, 0.10), (0.93, 0.56, 0.14), warm), cover)
    p.paint((0.90, 0.74, 0.26), 0.75 * (1 - step(ribs + 10 * mottle, 4, 66)) * cover)
    p.paint((0.56, 0.56, 0.18), 0.35 * step(mottle, 0.7, 1.8) * cover)
    veins = []
    for sign in (1, -1):
        for k in range(4):
            s = (k + 0.62 + 0.10 * sign) / 4.0
            root, tip = 0.16 + 0.84 * max(s - 0.105 - 0.02 * k, 0.03), 0.16 + 0.84 * s
            if tip > 0.97:
                continue
            w = side(np.array([tip]), sign)
            end = at([tip]) + sign * across([tip]) * w[:, None] + forward([tip]) * (0.42 * w * (1 - tip) ** 0.5)[:, None]
            start = at([root])
            middle = 0.5 * (start + end) - 0.06 * sign * across([root]) * w[:, None] + 6 * forward([root])
            veins.append(spline(np.vstack([start, middle, end])))
    for vein in veins:
        for k in (5, 9, 14, 19, 24):  # twigs of the veins
            way = (vein[k + 1] - vein[k]) / np.linalg.norm(vein[k + 1] - vein[k])
            for turn in (0.75, -0.75):
                out = np.array([np.cos(turn) * way[0] - np.sin(turn) * way[1], np.sin(turn) * way[0] + np.cos(turn) * way[1]])
                p.paint((0.97, 0.82, 0.42), 0.35 * p.line(spline([vein[k], vein[k] + 20 * out, vein[k] + 36 * out + 10 * way]), 1.8, 0.9)
                        * cover)
        p.shade(-0.25, p.line(vein - (2, 3), 5.0, 2.0) * cover)
        p.paint((0.98, 0.86, 0.48), 0.85 * p.line(vein[:26], 4.2, 1.0) * cover)
        p.paint((0.98, 0.86, 0.48), 0.6 * p.line(vein[25:30], 2.6, 1.0) * cover)
    p.shade(-0.30, p.line(rib - (2, 5), 9.0, 3.0) * cover)
    p.paint((0.96, 0.82, 0.44), 0.95 * p.cover(p.tube(rib[::10], np.linspace(8.0, 1.6, len(rib[::10])))) * cover)
    p.paint((0.45, 0.24, 0.12), 0.7 * cover * (1 - step(p.x, 90, 240)))
    p.shade(0.55 * p.relief(blurred(shape, 2.0), 50.0, 6.0), cover)
    p.paint((0.36, 0.12, 0.06), 0.6 * cover * step(-shape, -3.0, -0.4))

    # The rib and its veins as the pen draws them: short of the edge, and of each other.
    drawn = [Line(rib[int(0.17 * len(rib)):int(0.93 * len(rib))])] + [Line(vein[5:27]) for vein in veins]
    return Drawing(p, [line, *drawn])


# ---------------------------------------------------------------------------------------------------------- figure

def figure_body():
    """A gnome from the shoulders down: coat, belt, mittens, boots."""
    p = Picture(640, 640)
    p.toned((0.93, 0.95, 0.91), (0.88, 0.90, 0.84), (320, 340), 0.3)
    coat = p.inside(spline([(320, 598), (392, 582), (430, 520), (446, 420), (468, 300), (492, 204), (470, 168), (400, 148), (320, 142),
                            (240, 148), (170, 168), (148, 204), (172, 300), (194, 420), (210, 520), (248, 582)], closed=True))
    parts, boots, sleeves, mittens = [coat], [], [], []
    for sign in (-1, 1):
        x = lambda value: 320 + sign * value
        boots.append(union(p.limb([(x(86), 170), (x(88), 110), (x(92), 76)], [48, 46, 44]), p.limb([(x(100), 72), (x(150), 66)], [40, 34]),
                           blend=14.0))
        sleeves.append(p.limb([(x(76), 530), (x(136), 470), (x(196), 396), (x(222), 352)], [46, 46, 43, 41]))
        mittens.append(union(p.limb([(x(226), 344), (x(244), 300)], [34, 37]), p.limb([(x(212), 322), (x(186), 292)], [17, 15]), blend=10.0))
        parts += [boots[-1], sleeves[-1], mittens[-1]]
    whole = union(*parts, blend=10.0)
    line = outline(p, whole, (210, 520))
    shape = p.inside(line.course[::2])
    cover = p.cover(shape)

    shadow(p, shape, (12, -14), 14, 0.22)
    p.paint((0.34, 0.20, 0.12), cover)
    for boot in boots:
        p.paint((0.42, 0.25, 0.14), p.cover(np.minimum(boot, shape)))
        p.shade(0.75 * p.relief(boot, 40.0, 3.0), p.cover(boot))
        p.paint((0.18, 0.11, 0.08), p.cover(np.minimum(np.minimum(boot, shape), 48 - p.y), 1.0))
    blue = mixed((0.10, 0.24, 0.44), (0.20, 0.42, 0.64), step(p.y, 150, 560))
    p.paint(blue, np.maximum(p.cover(np.minimum(coat + 2, shape), 1.0), cover * step(p.y, 380, 420)))
    fold = np.sin((p.x - 320) / (30.0 + 0.10 * (600 - p.y)) * 2.4)
    p.shade(0.07 * fold * step(300 - p.y, -30, 60), p.cover(coat))
    p.shade(0.72 * p.relief(blurred(coat, 2.0), 86.0, 6.0), p.cover(coat))
    hem = coat - 15
    p.paint((0.95, 0.90, 0.78), p.cover(-hem, 1.5) * p.cover(np.minimum(coat, shape)) * (1 - step(p.y, 196, 226)))
    p.paint((0.88, 0.70, 0.28), p.cover(3.0 - np.abs(p.x - 320), 1.0) * p.cover(coat - 14) * (p.y > 150))
    sag = 300 + 0.00026 * (p.x - 320) ** 2
    belt = np.minimum(26 - np.abs(p.y - sag), coat)
    p.paint((0.24, 0.13, 0.08), p.cover(belt))
    p.shade(0.30 * np.exp(-((p.y - sag - 17) / 5.0) ** 2) - 0.45 * step(sag - p.y, 6, 26), p.cover(belt))
    p.shade(0.6 * p.relief(blurred(coat, 2.0), 86.0, 6.0), p.cover(belt))
    square = lambda half: half - np.maximum(np.abs(p.x - 320), np.abs(p.y - sag))
    p.paint((0.93, 0.76, 0.32), p.cover(np.minimum(square(38), 14 - square(38))))
    p.shade(0.6 * p.relief(np.minimum(square(38), 14 - square(38)), 7.0, 1.0), p.cover(np.minimum(square(38), 14 - square(38))))
    for y in (380, 440, 500):
        button = 13 - np.hypot(p.x - 320, p.y - y)
        p.paint((0.90, 0.72, 0.30), p.cover(button))
        p.shade(0.9 * p.relief(button, 13.0, 1.0), p.cover(button))
    for sleeve, mitten, sign in zip(sleeves, mittens, (-1, 1)):
        p.shade(-0.45 * np.exp(-((np.minimum(sleeve, 0)) / 9.0) ** 2) * (sleeve < 0), p.cover(coat) * (1 - step(p.y, 470, 530)))
        above = 1 - step(p.y, 480, 560)  # at the shoulder it is one with the coat
        p.paint((0.19, 0.40, 0.62), p.cover(np.minimum(sleeve, shape)) * above)
        p.shade(0.75 * p.relief(sleeve, 42.0, 4.0), p.cover(sleeve) * above)
        down = (p.x - 320 - sign * 221) * sign * 0.42 - (p.y - 357) * 0.90
        p.paint((0.86, 0.32, 0.20), p.cover(np.minimum(np.minimum(mitten, shape), down)))
        p.shade(0.75 * p.relief(mitten, 34.0, 3.0), p.cover(np.minimum(mitten, down)))
        cuff = np.minimum(15 - np.abs(down), np.minimum(shape, 56 - np.hypot(p.x - 320 - sign * 221, p.y - 357)))
        p.paint((0.96, 0.92, 0.82), p.cover(cuff))
        p.shade(0.7 * p.relief(cuff, 14.0, 2.0), p.cover(cuff))
    p.paint((0.12, 0.10, 0.12), 0.55 * cover * step(-shape, -2.8, -0.4))
    x = np.linspace(194, 446, 50)
    return Drawing(p, [line, Line(np.column_stack([x, 326 + 0.00026 * (x - 320) ** 2])),
                       Line(np.column_stack([x, 274 + 0.00026 * (x - 320) ** 2]))])


def figure_head():
    """His head: round nose, cheeks, a white beard."""
    p = Picture(512, 576)
    p.toned((0.93, 0.95, 0.91), (0.88, 0.90, 0.84), (256, 320), 0.3)
    face = p.inside(circle((256, 372), (140, 132)))
    ears = [p.inside(circle((256 + sign * 146, 362), (34, 46))) for sign in (-1, 1)]
    beard = p.inside(spline([(108, 366), (122, 392), (150, 372), (186, 334), (256, 318), (326, 334), (362, 372), (390, 392), (404, 366),
                             (410, 296), (394, 232), (366, 188), (342, 140), (300, 92), (262, 48), (236, 76), (198, 126), (158, 176), (122, 226),
                             (104, 296)], closed=True))
    whole = union(face, *ears, beard, blend=10.0)
    line = outline(p, whole, (110, 296))
    shape = p.inside(line.course[::2])
    cover = p.cover(shape)
    shadow(p, shape, (12, -14), 14, 0.20)
    for ear in ears:
        p.paint((0.90, 0.62, 0.48), p.cover(np.minimum(ear, shape)))
        p.shade(0.6 * p.relief(ear, 24.0, 3.0) - 0.25 * step(ear, 10, 22), p.cover(ear))
    p.paint((0.96, 0.75, 0.60), p.cover(np.minimum(face, shape)))
    p.shade(0.55 * p.relief(face, 88.0, 6.0), p.cover(face))
    for sign in (-1, 1):
        p.paint((0.92, 0.45, 0.36), 0.55 * np.exp(-(np.hypot(p.x - 256 - sign * 82, p.y - 366) / 32.0) ** 2) * cover)
    # beard: strands from the chin, in locks
    turn = np.arctan2(p.x - 256, 640 - p.y)
    wave = sum(w * np.sin(k * turn + 1.7 * np.sin(p.y / 31.0 + k) + k) for k, w in ((46, 0.4), (83, 0.35), (147, 0.35)))
    strands = np.clip(0.5 + 0.5 * wave, 0, 1)
    p.shade(-0.30 * np.exp(-(np.minimum(np.roll(beard, (4, -9), axis=(1, 0)), 0) / 8.0) ** 2), p.cover(face) * (beard < 0))
    p.paint(mixed((0.97, 0.97, 0.96), (0.76, 0.79, 0.84), strands ** 2 * step(beard, 0, 14)), p.cover(np.minimum(beard, shape)))
    p.shade(0.55 * p.relief(blurred(beard, 3.0), 70.0, 5.0), p.cover(beard))
    # moustache, mouth, nose, eyes, brows
    for sign in (-1, 1):
        lip = p.limb([(256 + sign * 8, 318), (256 + sign * 52, 316), (256 + sign * 98, 298), (256 + sign * 128, 316)], [19, 23, 17, 6])
        p.shade(-0.35 * np.exp(-(np.minimum(np.roll(lip, -8, axis=0), 0) / 8.0) ** 2) * (lip < 0), p.cover(shape) * (p.y < 330))
        p.paint((0.99, 0.98, 0.96), p.cover(lip))
        p.shade(0.6 * p.relief(lip, 20.0, 2.0) - 0.10 * (0.5 + 0.5 * np.sin((p.y + sign * 0.4 * p.x) / 3.0)), p.cover(lip))
        eye = np.hypot((p.x - 256 - sign * 54) / 1.0, (p.y - 418) / 1.15)
        p.paint((0.99, 0.98, 0.96), p.cover(20 - eye))
        p.paint((0.36, 0.24, 0.14), 0.9 * p.cover(2.0 - np.abs(20 - eye), 0.8) * (p.y > 414))
        iris = np.hypot(p.x - 256 - sign * 50, p.y - 416)
        p.paint((0.22, 0.46, 0.62), p.cover(12.5 - iris))
        p.paint((0.04, 0.05, 0.08), p.cover(7 - iris))
        p.paint((1, 1, 1), p.cover(3.2 - np.hypot(p.x - 254 - sign * 50 + 3, p.y - 422)))
        brow = p.limb([(256 + sign * 26, 458), (256 + sign * 58, 466), (256 + sign * 92, 446)], [9, 13, 6])
        p.paint((0.96, 0.96, 0.95), p.cover(brow))
        p.shade(0.6 * p.relief(brow, 12.0, 2.0), p.cover(brow))
    nose = p.inside(circle((256, 362), (38, 35)))
    p.shade(-0.40 * np.exp(-(np.minimum(np.roll(nose, (4, -9), axis=(1, 0)), 0) / 7.0) ** 2) * (nose < 0), cover)
    p.paint((0.94, 0.56, 0.42), p.cover(nose))
    p.shade(0.75 * p.relief(nose, 36.0, 3.0), p.cover(nose))
    p.paint((1, 1, 1), 0.6 * np.exp(-(np.hypot(p.x - 244, p.y - 376) / 8.0) ** 2) * p.cover(nose))
    p.paint((0.30, 0.26, 0.26), 0.5 * cover * step(-shape, -2.8, -0.4))
    return Drawing(p, [line, Line(circle((256, 362), (38, 35)), closed=True),
                       Line(spline([(138, 374), (160, 354), (192, 326), (214, 318)])),
                       Line(spline([(374, 374), (352, 354), (320, 326), (298, 318)]))])


def figure_hat():
    """His hat: red felt, its tip bent over, a brim and a band."""
    p = Picture(512, 512)
    p.toned((0.93, 0.95, 0.91), (0.88, 0.90, 0.84), (256, 220), 0.3)
    cone = p.limb([(256, 110), (256, 150), (250, 230), (256, 316), (292, 392), (344, 428), (398, 420)], [164, 140, 106, 72, 46, 32, 23],
                  steps=14)
    cone = np.minimum(cone, p.y - 84)
    brim = p.inside(spline([(36, 104), (60, 130), (150, 150), (256, 156), (362, 150), (452, 130), (476, 104), (450, 74), (362, 52),
                            (256, 46), (150, 52), (62, 74)], closed=True))
    bobble = 36 - np.hypot(p.x - 424, p.y - 398)
    whole = union(cone, brim, bobble, blend=8.0)
    line = outline(p, whole, (180, 300))
    shape = p.inside(line.course[::2])
    cover = p.cover(shape)
    shadow(p, shape, (12, -14), 14, 0.20)
    p.paint(mixed((0.62, 0.09, 0.10), (0.84, 0.17, 0.15), step(p.y + 0.4 * (256 - p.x), 90, 400)), cover)
    folds = np.sin((p.y - 0.25 * p.x) / 15.0) * np.exp(-((p.y - 330 - 0.3 * (p.x - 256)) / 70.0) ** 2)
    p.shade(0.10 * folds, p.cover(cone))
    p.shade(0.75 * p.relief(blurred(cone, 2.0), 84.0, 5.0), p.cover(cone))
    sag = 164 - 26 * np.sqrt(np.clip(1 - ((p.x - 256) / 190.0) ** 2, 0, 1))
    band = np.minimum(np.minimum(p.y - sag, sag + 46 - p.y), cone)
    p.paint((0.16, 0.34, 0.24), p.cover(band))
    p.shade(0.70 * p.relief(blurred(cone, 2.0), 84.0, 5.0), p.cover(band))
    for k in range(-3, 4):
        x = 256 + 128 * np.sin(0.36 * k)
        y = 164 - 26 * np.sqrt(1 - ((x - 256) / 190.0) ** 2) + 23
        p.paint((0.95, 0.78, 0.34), p.cover(10 - np.abs(p.x - x) / np.cos(0.36 * k) - np.abs(p.y - y)) * p.cover(band))
    p.shade(-0.45 * np.exp(-(np.minimum(brim, 0) / 10.0) ** 2) * (brim < 0), p.cover(cone))
    p.paint((0.74, 0.13, 0.13), p.cover(np.minimum(brim, shape)))
    p.shade(0.70 * p.relief(blurred(brim, 2.0), 46.0, 4.0), p.cover(brim))
    p.shade(-0.40 * np.exp(-(np.minimum(bobble, 0) / 6.0) ** 2) * (bobble < 0), p.cover(cone))
    p.paint((0.98, 0.96, 0.90), p.cover(np.minimum(bobble, shape)))
    p.shade(0.75 * p.relief(bobble, 36.0, 2.0) - 0.10 * np.clip(p.mottled(4, 2.2), -1, 1), p.cover(bobble))
    p.paint((0.28, 0.05, 0.08), 0.6 * cover * step(-shape, -2.8, -0.4))
    x = np.linspace(124, 388, 50)
    low = 164 - 26 * np.sqrt(1 - ((x - 256) / 190.0) ** 2)
    return Drawing(p, [line, Line(np.column_stack([x, low + 8])[2:-2]), Line(np.column_stack([x, low + 46])[8:-8])])


DRAWINGS = {"fish": fish, "mug": mug, "padlock": padlock, "heron": heron, "leaf": leaf,
            "figure_body": figure_body, "figure_head": figure_head, "figure_hat": figure_hat}
