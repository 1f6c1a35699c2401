"""The pictures that the works of Data/Works are drawn over: a photograph of a toy, and paintings on an even ground.

Places are px of each picture, from its lower left corner.
"""
import numpy as np

from drawings import DRAWINGS
from painting import Picture, blurred, circle, mixed, spline, step, union
from photograph import photographed, rounded

GROUND = (0.76, 0.84, 0.92)
SCALE, BACK, BELLY, CREST = (0.36, 0.62, 0.50), (0.13, 0.39, 0.42), (0.96, 0.88, 0.66), (0.90, 0.42, 0.28)
EYE = (183, 532)  # of the dragon


def hide(p, skin, up, seed=3, light=0.55):
    """Paints a dragon's hide over a field: darker up the other field, with lighter spots, lit from above."""
    cover = p.cover(skin)
    p.paint(mixed(SCALE, BACK, step(up, -0.4, 1.0)), cover)
    spots = step(p.mottled(seed, 9.0), 0.9, 1.5) * step(up, -0.1, 0.5)
    p.paint((0.55, 0.76, 0.56), 0.55 * spots * cover)
    p.shade(light * p.relief(skin, 62.0, 5.0), cover)


def dragon():
    """A young dragon without legs and wings, seen from its left: a photograph of a toy on a table."""
    p = Picture(800, 640, BACK)
    torso = p.limb([(318, 262), (400, 244), (500, 246)], [88, 104, 88])
    tail = p.limb([(500, 246), (590, 204), (668, 194), (724, 232), (738, 296)], [86, 50, 31, 21, 12], steps=10)
    neck = p.limb([(310, 280), (258, 372), (232, 452), (222, 524)], [76, 52, 44, 50], steps=10)
    head = union(p.limb([(216, 528), (150, 510), (112, 502)], [62, 46, 38]), p.tube(circle((92, 516), 2), 26), blend=16.0)
    spade = p.inside(spline([(738, 282), (716, 318), (714, 350), (738, 388), (764, 352), (764, 318)], closed=True))
    body = union(union(torso, tail, blend=20.0), neck, head, blend=26.0)
    back = spline([(268, 574), (276, 520), (284, 450), (312, 386), (356, 352), (420, 348), (490, 346), (544, 320), (588, 276), (640, 238)],
                  steps=20)
    way = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(back, axis=0), axis=1)))
    fins = []
    for at, tall in zip(np.linspace(12, way[-1] - 24, 11), (22, 26, 29, 32, 36, 38, 38, 35, 30, 25, 20)):
        root, ahead = (np.array([np.interp(t, way, back[:, k]) for k in (0, 1)]) for t in (at, at + 4.0))
        along = (ahead - root) / np.linalg.norm(ahead - root)
        out = np.array([-along[1], along[0]])
        shape = [(-21, -26), (-19, 0), (-6, 0.72), (11, 1.0), (17, 0.52), (22, 0), (21, -26)]
        fins.append(p.inside(spline([root + u * along + (v * tall if 0 < v <= 1 else v) * out for u, v in shape], closed=True, steps=8)))
    fins = union(*fins)
    whole = union(body, spade, fins, blend=8.0)

    # Up, -1 to 1: away from throat and belly.
    throat = spline([(60, 470), (150, 468), (190, 440), (196, 380), (232, 296), (270, 190), (400, 128), (520, 150), (640, 160)])
    away = p.away(throat, 90) / 60.0
    up = np.clip(away - 0.55, -1.0, 1.0)
    hide(p, whole + 4.0, up, light=0.0)
    belly = p.inside(np.vstack([spline([(88, 480), (150, 476), (200, 452), (222, 392), (262, 306), (296, 218), (400, 168), (520, 168),
                                        (620, 164), (668, 166)]), [(660, 100), (200, 100), (60, 300), (60, 470)]]))
    under = p.cover(np.minimum(belly, whole + 4.0), 3.0)
    p.paint(BELLY, under)
    along = np.arctan2(p.y - 420, p.x - 560) * 22.0
    folds = step(np.cos(along * 2.0), 0.80, 0.98) * under * (p.y < 470)
    for field, inner in ((spade, step(spade, 0, 22)), (fins, step(-body, 30, 2))):
        field = field + 6.0  # clay that is pressed on has a foot
        tip = np.minimum(field, -body + 5.0)
        p.paint(mixed(CREST, (1.0, 0.78, 0.48), inner), p.cover(tip, 2.0) * p.cover(field + 1.0))
    # face
    p.paint((0.95, 0.55, 0.42), 0.5 * np.exp(-((p.x - 168) / 24.0) ** 2 - ((p.y - 490) / 16.0) ** 2) * p.cover(body))
    mouth = p.line(spline([(80, 496), (108, 488), (150, 484), (186, 490), (204, 504)]), 4.0, 1.0)
    p.paint((0.12, 0.22, 0.24), 0.85 * mouth)
    nostril = np.hypot((p.x - 92) / 1.5, p.y - 524)
    p.paint((0.10, 0.20, 0.22), 0.85 * p.cover(4.5 - nostril, 1.2))
    eye = np.hypot(p.x - EYE[0], (p.y - EYE[1]) * 0.92)
    p.paint((0.10, 0.24, 0.26), p.cover(30 - eye, 1.0))
    p.paint((0.99, 0.97, 0.90), p.cover(27 - eye, 0.8))
    iris = np.hypot(p.x - EYE[0] + 5, p.y - EYE[1])
    p.paint(mixed((0.98, 0.76, 0.20), (0.82, 0.40, 0.10), step(iris, 9, 19)), p.cover(20 - iris, 0.8) * p.cover(27 - eye))
    p.paint((0.05, 0.05, 0.07), p.cover(12 - np.hypot((p.x - EYE[0] + 5) * 1.25, p.y - EYE[1]), 0.8))
    p.paint((1, 1, 1), 0.95 * p.cover(5.5 - np.hypot(p.x - EYE[0] - 3, p.y - EYE[1] - 9), 0.9))
    plates = np.maximum(rounded(spade), np.where(fins > 0, np.minimum(0.9 * fins, 9.0), 0.0))
    dents = 3.0 * folds + 4.0 * mouth + 5.0 * p.cover(4.5 - nostril, 2.0) - 7.0 * np.sqrt(np.maximum(1.0 - (eye / 30.0) ** 2, 0.0))
    photographed(p, whole, np.maximum(rounded(body), plates) - dents + 0.5 * p.mottled(31, 7.0), table=136)
    return p, whole


def legs():
    """A fore leg, on the left, and a hind leg."""
    p = Picture(576, 448, GROUND)
    fore = union(p.limb([(170, 316), (172, 220), (156, 130), (150, 80)], [66, 52, 38, 36]), p.limb([(150, 66), (112, 56)], [38, 32]), blend=14.0)
    hind = union(p.limb([(410, 306), (400, 226)], [88, 70]), p.limb([(430, 236), (446, 140), (428, 80)], [58, 40, 36]),
                 p.limb([(428, 66), (386, 56)], [38, 32]), blend=18.0)
    hide(p, union(fore, hind), step(p.y, 40, 330) * 1.1 - 0.3, 5)
    for x in (90, 116, 142, 364, 390, 416):  # claws
        claw = p.inside(spline([(x - 13, 36), (x, 52), (x + 13, 36), (x, 25)], closed=True))
        p.paint((0.98, 0.93, 0.80), p.cover(np.minimum(claw, union(fore, hind)), 1.0))
        p.shade(0.4 * p.relief(claw, 10.0), p.cover(claw))
    return p, union(fore, hind)


def wing():
    """A wing, its root at the lower left."""
    p = Picture(576, 512, GROUND)
    tips = [(508, 300), (430, 176), (300, 108)]
    root, wrist = (92, 92), (212, 404)
    edge = [(64, 88), (76, 160), (110, 270), (168, 380), (206, 440), (250, 440), (350, 424), (440, 378), (524, 304), (476, 286), (438, 240),
            (446, 168), (388, 182), (334, 164), (314, 96), (256, 124), (190, 112), (120, 64)]
    field = blurred(p.inside(spline(edge, closed=True, steps=10)), 3.0)
    p.paint(mixed((1.0, 0.74, 0.44), CREST, step(np.hypot(p.x - 380, p.y - 180), 60, 330)), p.cover(field))
    for tip in tips:
        bone = spline([wrist, (0.5 * (wrist[0] + tip[0]) + 24, 0.5 * (wrist[1] + tip[1]) + 30), tip])
        p.paint((0.66, 0.24, 0.20), 0.7 * p.line(bone, 11.0, 3.0) * p.cover(field))
        p.paint((1.0, 0.66, 0.46), 0.6 * p.line(bone + (-2, 2), 4.0, 2.0) * p.cover(field))
    arm = np.minimum(p.limb([root, (140, 260), wrist, (250, 424)], [34, 28, 26, 18]), field + 4)
    p.paint(mixed(SCALE, BACK, step(p.y, 60, 420)), p.cover(arm, 1.5))
    p.shade(0.5 * p.relief(arm, 26.0), p.cover(arm))
    p.shade(0.25 * p.relief(field, 20.0), p.cover(field))
    return p, field


def horn():
    """A horn with rings, its root below."""
    p = Picture(256, 256, GROUND)
    field = p.limb([(60, 60), (92, 128), (150, 180), (214, 196)], [34, 28, 18, 8], steps=12)
    p.paint(mixed((1.0, 0.94, 0.78), CREST, step(np.hypot(p.x - 60, p.y - 50), 30, 230)), p.cover(field))
    p.shade(-0.18 * step(np.cos(np.hypot(p.x - 30, p.y - 10) * 0.27), 0.6, 0.95), p.cover(field))
    p.shade(0.5 * p.relief(field, 28.0), p.cover(field))
    return p, field


def hair():
    """The hair of the gnome's head, for its back; places are those of the head's picture."""
    p = Picture(512, 576, GROUND)
    head = p.inside(DRAWINGS["figure_head"]().lines[0].course[::2])
    lock = p.inside(spline([(88, 300), (120, 214), (150, 168), (186, 150), (222, 138), (256, 146), (292, 138), (328, 150), (362, 168),
                            (392, 214), (424, 300), (424, 700), (88, 700)], closed=True))
    field = blurred(np.minimum(head + 12.0, lock), 3.0)
    p.paint((0.86, 0.86, 0.85), p.cover(field))
    for k, x in enumerate(np.linspace(116, 396, 17)):
        strand = spline([(256 + 0.25 * (x - 256), 560), (x - 0.1 * (256 - x), 400), (x + 5 * (-1) ** k, 270), (256 + 0.86 * (x - 256), 130)])
        p.paint((0.52, 0.53, 0.58), 0.55 * p.line(strand, 4.0, 2.5) * p.cover(field - 2))
        p.paint((1.0, 1.0, 1.0), 0.6 * p.line(strand + (5, 0), 3.0, 2.5) * p.cover(field - 2))
    p.shade(0.5 * p.relief(field, 60.0, 5.0), p.cover(field))
    return p, field


def slab():
    """A slab of sandstone on which a shell is marked out."""
    p = Picture(768, 768, GROUND)
    x, y = np.abs(p.x - 384) - 284, np.abs(p.y - 384) - 284
    field = 44.0 - np.hypot(np.maximum(x, 0), np.maximum(y, 0)) - np.minimum(np.maximum(x, y), 0) * 1.0
    grain = 0.035 * p.mottled(11, 1.2) + 0.05 * p.mottled(12, 14.0) + 0.03 * p.mottled(13, 50.0)
    p.paint(np.clip(np.array((0.80, 0.70, 0.56)) + grain[..., None] * (1.0, 0.95, 0.85), 0, 1), p.cover(field))
    return p, field


PICTURES = {"dragon": dragon, "legs": legs, "wing": wing, "horn": horn, "hair": hair, "slab": slab}
