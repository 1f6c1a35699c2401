"""The six figures as implicit fields. Units are arbitrary; y is up; animals look along +x, the person and the bear along +z."""
import numpy as np

from implicit import Ellipsoid, Field, Tube


def finer_near(places):
    """Factor on the edge length: for each (centre, inner radius, outer radius, factor), `factor` within the inner one."""

    def scale(p):
        result = np.ones(len(p))
        for centre, inner, outer, factor in places:
            t = np.clip((np.linalg.norm(p - np.asarray(centre), axis=1) - inner) / (outer - inner), 0.0, 1.0)
            np.minimum(result, factor + (1.0 - factor) * t * t * (3.0 - 2.0 * t), out=result)
        return result

    return scale


def dog():
    """A young hound in mid-stride: each leg stands alone when seen from the side."""
    f = Field()
    f.add(Ellipsoid((0.30, 0.80, 0), (0.31, 0.275, 0.215), [(1, 0.12, 0), (-0.12, 1, 0), (0, 0, 1)]))
    f.add(Tube([(0.32, 0.84, 0, 0.22), (0.02, 0.85, 0, 0.195), (-0.28, 0.88, 0, 0.18), (-0.46, 0.86, 0, 0.175)]), 0.12)
    f.add(Ellipsoid((-0.44, 0.84, 0), (0.20, 0.20, 0.19)), 0.10)
    # neck and head
    f.add(Tube([(0.38, 0.93, 0, 0.19), (0.53, 1.10, 0, 0.155), (0.63, 1.26, 0, 0.135)]), 0.14)
    head = Field()
    head.add(Ellipsoid((0.68, 1.36, 0), (0.215, 0.195, 0.19)))
    head.add(Tube([(0.76, 1.31, 0, 0.125), (0.92, 1.275, 0, 0.105), (1.06, 1.265, 0, 0.083)], flat=((0, 0, 1), 0.95)), 0.09)
    head.add(Tube([(0.80, 1.23, 0, 0.075), (0.93, 1.185, 0, 0.058), (1.01, 1.185, 0, 0.045)]), 0.03)
    head.add(Ellipsoid((1.118, 1.305, 0), (0.040, 0.034, 0.050)), 0.03)  # nose
    for side in (-1, 1):
        head.add(Tube([(0.76, 1.475, 0.075 * side, 0.06), (0.83, 1.455, 0.095 * side, 0.045)]), 0.06)  # brow
        head.add(Ellipsoid((0.862, 1.400, 0.100 * side), (0.036, 0.042, 0.034)), 0.008)  # eye
        head.add(Tube([(0.65, 1.51, 0.09 * side, 0.060), (0.60, 1.47, 0.175 * side, 0.075), (0.58, 1.35, 0.205 * side, 0.090),
                       (0.590, 1.21, 0.205 * side, 0.090), (0.63, 1.11, 0.215 * side, 0.055)],
                      flat=((0.1, 0.1, side), 0.42)), 0.03)  # ear
    f.add(head, 0.07)
    # tail, carried high
    f.add(Tube([(-0.54, 0.93, 0, 0.085), (-0.70, 1.03, 0, 0.060), (-0.84, 1.20, 0, 0.052), (-0.90, 1.42, 0, 0.045),
                (-0.84, 1.62, 0, 0.032)]), 0.08)

    def paw(leg, x, y, z, size=1.0):
        leg.add(Ellipsoid((x + 0.045 * size, y + 0.055, z), (0.105 * size, 0.058, 0.078 * size)), 0.05)
        for across in (-0.047, 0.0, 0.047):
            forward = 0.118 if across == 0.0 else 0.100
            leg.add(Ellipsoid((x + forward * size, y + 0.040, z + across * size), (0.045, 0.040, 0.030)), 0.014)

    # fore legs: (shoulder) elbow, wrist, paw
    for side, elbow, wrist, foot in ((1, (0.39, 0.50), (0.56, 0.24), (0.62, 0.0)), (-1, (0.24, 0.50), (0.17, 0.25), (0.10, 0.0))):
        leg = Field()
        z = 0.135 * side
        leg.add(Tube([(0.34, 0.76, z, 0.125), (elbow[0], elbow[1], 1.08 * z, 0.088), (wrist[0], wrist[1], 1.1 * z, 0.062),
                      (foot[0], 0.09, 1.1 * z, 0.060)]))
        paw(leg, foot[0], foot[1], 1.1 * z)
        f.add(leg, 0.07)
    # hind legs: hip, knee, hock, paw
    for side, knee, hock, foot in ((1, (-0.52, 0.53), (-0.80, 0.33), (-0.81, 0.0)), (-1, (-0.24, 0.53), (-0.37, 0.29), (-0.29, 0.0))):
        leg = Field()
        z = 0.125 * side
        leg.add(Tube([(-0.43, 0.80, 0.9 * z, 0.165), (0.5 * (knee[0] - 0.43), 0.67, 1.05 * z, 0.14), (knee[0], knee[1], 1.1 * z, 0.102),
                      (hock[0], hock[1], 1.1 * z, 0.060), (foot[0], 0.085, 1.1 * z, 0.056)]))
        paw(leg, foot[0], foot[1], 1.1 * z)
        f.add(leg, 0.06)
    return f


def hand():
    """A right hand, palm towards +z, fingers spread and a little curled, cut and rounded at the wrist."""
    f = Field()
    # wrist and palm: one ray for each finger, flattened
    f.add(Tube([(0.0, -1.05, 0.0, 0.27), (0.0, -0.75, 0.0, 0.245), (0.0, -0.45, 0.0, 0.26)], flat=((0, 0, 1), 0.78)))
    f.add(Ellipsoid((0.0, -0.06, 0.0), (0.40, 0.47, 0.155)), 0.20)
    for x, y in ((-0.31, 0.24), (-0.105, 0.31), (0.105, 0.28), (0.29, 0.17)):
        f.add(Tube([(0.35 * x, -0.50, -0.02, 0.12), (0.85 * x, 0.0, -0.01, 0.135), (x, y, 0.0, 0.118)]), 0.10)
    f.add(Ellipsoid((-0.24, -0.22, 0.10), (0.17, 0.27, 0.14), [(0.85, 0.5, 0), (-0.5, 0.85, 0), (0, 0, 1)]), 0.12)  # ball of the thumb
    f.add(Ellipsoid((0.24, -0.18, 0.07), (0.13, 0.27, 0.12)), 0.12)

    def finger(base, lengths, radius, lean, curl):
        """A finger from its knuckle: three bones, leaning sideways by `lean`, each bending by `curl` towards the palm."""
        finger, at, bend = Field(), np.array(base, float), 0.10
        rows = [(*at, 1.06 * radius)]
        for i, length in enumerate(lengths):
            bend += curl
            step = np.array([np.sin(lean) * np.cos(bend), np.cos(lean) * np.cos(bend), np.sin(bend)])
            rows.append((*(at + 0.5 * length * step), (0.97, 0.92, 0.86)[i] * radius))
            at = at + length * step
            rows.append((*at, (1.0, 0.93, 0.76)[i] * radius))
        finger.add(Tube(rows))
        back = np.array([0.0, 0.0, 1.0]) * np.cos(bend) - np.array([np.sin(lean), np.cos(lean), 0]) * np.sin(bend)
        nail = at - 0.03 * step - 0.62 * radius * back
        finger.add(Ellipsoid(nail, (0.62 * radius, 0.95 * radius, 0.28 * radius), [np.cross(step, back), step, back]), 0.012)
        return finger

    f.add(finger((-0.32, 0.24, 0.0), (0.42, 0.25, 0.18), 0.116, -0.27, 0.07), 0.05)
    f.add(finger((-0.11, 0.32, 0.0), (0.47, 0.29, 0.19), 0.120, -0.07, 0.05), 0.05)
    f.add(finger((0.11, 0.29, 0.0), (0.44, 0.27, 0.18), 0.114, 0.14, 0.07), 0.05)
    f.add(finger((0.31, 0.18, 0.0), (0.34, 0.20, 0.16), 0.098, 0.40, 0.09), 0.05)
    f.add(Tube([(-0.20, -0.38, 0.06, 0.17), (-0.42, -0.14, 0.13, 0.155), (-0.60, 0.06, 0.17, 0.122), (-0.70, 0.20, 0.18, 0.128),
                (-0.78, 0.36, 0.17, 0.112), (-0.80, 0.44, 0.165, 0.090)]), 0.10)
    return f


def person():
    """A young person standing with the arms held away from the body."""
    f = Field()
    # trunk: pelvis, waist, chest, shoulders
    f.add(Tube([(0, 0.93, 0.0, 0.160), (0, 1.06, 0.0, 0.145), (0, 1.22, 0.005, 0.150), (0, 1.35, 0.0, 0.150)],
               flat=((0, 0, 1), 0.80)))
    f.add(Ellipsoid((0, 0.94, -0.01), (0.182, 0.120, 0.138)), 0.08)
    f.add(Ellipsoid((0, 1.32, 0.005), (0.205, 0.160, 0.140)), 0.08)
    f.add(Tube([(-0.19, 1.425, -0.01, 0.065), (0, 1.46, -0.01, 0.075), (0.19, 1.425, -0.01, 0.065)]), 0.08)
    # neck and head
    f.add(Tube([(0, 1.44, -0.01, 0.075), (0, 1.56, 0.0, 0.066)]), 0.06)
    head = Field()
    head.add(Ellipsoid((0, 1.77, 0.0), (0.150, 0.170, 0.160)))
    head.add(Ellipsoid((0, 1.665, 0.040), (0.105, 0.085, 0.100)), 0.09)  # jaw
    head.add(Ellipsoid((0, 1.70, 0.168), (0.026, 0.030, 0.030)), 0.035)  # nose
    for side in (-1, 1):
        head.add(Ellipsoid((0.152 * side, 1.715, -0.005), (0.022, 0.046, 0.034)), 0.02)  # ear
        head.add(Ellipsoid((0.058 * side, 1.745, 0.140), (0.026, 0.034, 0.020)), 0.012)  # eye
    head.add(Tube([(-0.052, 1.648, 0.122, 0.014), (0.0, 1.632, 0.134, 0.022), (0.052, 1.648, 0.122, 0.014)]), 0.03)  # smile
    # hair: a cap with a parting and a tuft
    hair = Field()
    hair.add(Ellipsoid((0, 1.80, -0.030), (0.168, 0.165, 0.168)))
    hair.add(Ellipsoid((0, 1.70, -0.080), (0.145, 0.13, 0.105)), 0.05)
    hair.carve(Ellipsoid((0, 1.66, 0.150), (0.135, 0.175, 0.160)), 0.03)
    hair.add(Tube([(0.06, 1.90, 0.02, 0.060), (-0.02, 1.895, 0.11, 0.045), (-0.10, 1.845, 0.135, 0.028)]), 0.04)
    head.add(hair, 0.014)
    f.add(head, 0.04)
    for side in (-1, 1):
        # arm: shoulder, elbow, wrist, mitten and thumb
        arm = Field()
        arm.add(Tube([(0.20 * side, 1.415, -0.01, 0.086), (0.33 * side, 1.305, -0.015, 0.074), (0.475 * side, 1.155, -0.02, 0.062),
                      (0.585 * side, 1.04, 0.0, 0.059), (0.69 * side, 0.925, 0.03, 0.044)]))
        along = np.array([0.62 * side, -0.75, 0.20])
        across = np.array([0.1 * side, 0.30, 0.95])
        wrist = np.array([0.69 * side, 0.925, 0.03])
        arm.add(Tube([(*wrist, 0.046), (*(wrist + 0.08 * along + 0.005 * across), 0.070), (*(wrist + 0.16 * along), 0.070),
                      (*(wrist + 0.225 * along), 0.050)], flat=(np.cross(along, across), 0.62)), 0.03)
        arm.add(Tube([(*(wrist + 0.02 * along + 0.02 * across), 0.036), (*(wrist + 0.085 * along + 0.095 * across), 0.031),
                      (*(wrist + 0.145 * along + 0.115 * across), 0.027)]), 0.025)
        f.add(arm, 0.05)
        # leg: hip, knee, ankle, foot
        leg = Field()
        leg.add(Tube([(0.098 * side, 0.91, -0.01, 0.112), (0.138 * side, 0.72, 0.0, 0.100), (0.172 * side, 0.50, 0.010, 0.078),
                      (0.193 * side, 0.34, -0.012, 0.077), (0.218 * side, 0.12, -0.02, 0.054), (0.220 * side, 0.07, -0.02, 0.054)]))
        leg.add(Tube([(0.218 * side, 0.055, -0.045, 0.058), (0.232 * side, 0.055, 0.06, 0.064), (0.252 * side, 0.042, 0.165, 0.056)],
                     flat=((0, 1, 0), 0.80)), 0.05)
        f.add(leg, 0.04)
    return f


def dinosaur():
    """A long-necked sauropod in mid-stride, tail off the ground."""
    f = Field()
    f.add(Ellipsoid((0.02, 0.98, 0), (0.53, 0.36, 0.33), [(1, 0.10, 0), (-0.10, 1, 0), (0, 0, 1)]))
    f.add(Tube([(0.34, 1.08, 0, 0.27), (0.0, 1.06, 0, 0.30), (-0.40, 0.98, 0, 0.25)]), 0.15)
    # neck, rising in one long curve, and head
    f.add(Tube([(0.30, 1.10, 0, 0.27), (0.60, 1.30, 0, 0.185), (0.85, 1.58, 0, 0.135), (1.05, 1.90, 0, 0.112),
                (1.24, 2.16, 0, 0.102), (1.42, 2.28, 0, 0.105)]), 0.12)
    head = Field()
    head.add(Ellipsoid((1.50, 2.30, 0), (0.165, 0.130, 0.125), [(1, -0.15, 0), (0.15, 1, 0), (0, 0, 1)]))
    head.add(Tube([(1.56, 2.275, 0, 0.105), (1.70, 2.235, 0, 0.092), (1.79, 2.215, 0, 0.080)]), 0.07)
    head.add(Tube([(1.52, 2.20, 0, 0.070), (1.64, 2.155, 0, 0.060), (1.74, 2.140, 0, 0.052)]), 0.045)  # jaw
    head.add(Ellipsoid((1.60, 2.375, 0), (0.075, 0.050, 0.060)), 0.05)  # crest
    for side in (-1, 1):
        head.add(Ellipsoid((1.575, 2.350, 0.098 * side), (0.040, 0.040, 0.034)), 0.012)  # eye
        head.add(Ellipsoid((1.80, 2.275, 0.036 * side), (0.026, 0.022, 0.020)), 0.02)  # nostril
    f.add(head, 0.05)
    # tail
    f.add(Tube([(-0.38, 0.98, 0, 0.25), (-0.72, 0.92, 0, 0.175), (-1.05, 0.84, 0, 0.125), (-1.40, 0.80, 0, 0.088),
                (-1.75, 0.86, 0, 0.058), (-2.10, 1.03, 0, 0.034)]), 0.12)

    def toes(leg, x, z, radius):
        leg.add(Ellipsoid((x + 0.02, 0.055, z), (1.22 * radius, 0.060, 1.15 * radius)), 0.04)
        for turn in (-0.75, 0.0, 0.75):
            leg.add(Ellipsoid((x + 0.02 + 1.08 * radius * np.cos(turn), 0.038, z + 1.05 * radius * np.sin(turn)), (0.055, 0.040, 0.042)),
                    0.025)

    for side, elbow, foot in ((1, (0.42, 0.55), 0.56), (-1, (0.20, 0.55), 0.10)):
        leg, z = Field(), 0.185 * side
        leg.add(Tube([(0.28, 0.98, z, 0.185), (elbow[0], elbow[1], 1.08 * z, 0.125), (foot, 0.25, 1.08 * z, 0.098), (foot, 0.08, 1.08 * z, 0.105)]))
        toes(leg, foot, 1.08 * z, 0.105)
        f.add(leg, 0.08)
    for side, knee, foot in ((-1, (-0.22, 0.58), -0.28), (1, (-0.50, 0.56), -0.74)):
        leg, z = Field(), 0.185 * side
        leg.add(Tube([(-0.34, 0.95, z, 0.21), (knee[0], knee[1], 1.08 * z, 0.150), (foot, 0.26, 1.08 * z, 0.104), (foot, 0.08, 1.08 * z, 0.112)]))
        toes(leg, foot, 1.08 * z, 0.112)
        f.add(leg, 0.08)
    return f


def octopus():
    """An octopus resting on eight spread arms, their tips curling up."""
    f = Field()
    f.add(Tube([(0, 0.52, 0.0, 0.29), (0, 0.74, -0.04, 0.35), (0, 0.98, -0.16, 0.43), (0, 1.14, -0.30, 0.39), (0, 1.20, -0.44, 0.26)]))
    f.add(Ellipsoid((0, 0.34, 0.0), (0.37, 0.25, 0.36)), 0.22)
    for side in (-1, 1):
        f.add(Ellipsoid((0.235 * side, 0.690, 0.215), (0.140, 0.150, 0.125)), 0.08)  # socket and lid
        f.add(Ellipsoid((0.262 * side, 0.665, 0.285), (0.098, 0.098, 0.082)), 0.014)  # eye
    for i in range(8):
        turn = np.pi * (2 * i + 1) / 8
        bow = (0.22, -0.18, 0.20, -0.24)[i % 4] * (1 if i < 4 else -1)
        rows = []
        for reach, sideways, height, radius in ((0.18, 0.0, 0.32, 0.165), (0.46, 0.05, 0.17, 0.135), (0.80, 0.35, 0.10, 0.105),
                                                (1.12, 0.70, 0.09, 0.084), (1.42, 0.55, 0.11, 0.067), (1.64, 0.0, 0.19, 0.055),
                                                (1.72, -0.50, 0.30, 0.045)):
            angle = turn + bow * sideways
            rows.append((reach * np.cos(angle), height, reach * np.sin(angle), radius))
        f.add(Tube(rows), 0.07)
    return f


def bear():
    """A standing teddy bear, the same on both sides of x = 0 to the bit."""
    f = Field()
    f.add(Ellipsoid((0, 0.70, 0), (0.36, 0.42, 0.31)))
    f.add(Ellipsoid((0, 0.62, 0.10), (0.29, 0.31, 0.26)), 0.08)
    head = Field()
    head.add(Ellipsoid((0, 1.36, 0.02), (0.315, 0.285, 0.275)))
    head.add(Ellipsoid((0, 1.285, 0.245), (0.130, 0.105, 0.110)), 0.05)  # muzzle
    head.add(Ellipsoid((0, 1.335, 0.345), (0.042, 0.030, 0.028)), 0.015)  # nose
    for side in (-1, 1):
        head.add(Ellipsoid((0.245 * side, 1.60, 0.0), (0.118, 0.118, 0.060)), 0.05)  # ear
        head.add(Ellipsoid((0.105 * side, 1.415, 0.262), (0.030, 0.036, 0.026)), 0.012)  # eye
    f.add(head, 0.10)
    for side in (-1, 1):
        f.add(Tube([(0.24 * side, 0.96, 0.0, 0.135), (0.46 * side, 0.90, 0.02, 0.122), (0.70 * side, 0.80, 0.05, 0.118),
                    (0.84 * side, 0.74, 0.07, 0.112)]), 0.07)
        leg = Field()
        leg.add(Tube([(0.17 * side, 0.42, 0.0, 0.165), (0.235 * side, 0.22, 0.02, 0.150), (0.27 * side, 0.14, 0.06, 0.140)]))
        leg.add(Ellipsoid((0.28 * side, 0.095, 0.12), (0.135, 0.095, 0.190)), 0.06)
        f.add(leg, 0.06)
    return f


# What makes each model: the figure, its edge length in its own unit, and where that is scaled down for detail.
FIGURES = {
    "dog": (dog, 0.021, finer_near([((0.97, 1.36, 0.0), 0.16, 0.40, 0.62)])),
    "person": (person, 0.019, finer_near([((0.0, 1.72, 0.10), 0.12, 0.36, 0.60)])),
    "hand": (hand, 0.025, None),
    "dinosaur": (dinosaur, 0.032, finer_near([((1.62, 2.27, 0.0), 0.20, 0.70, 0.55), ((-2.1, 1.03, 0.0), 0.1, 0.7, 0.65)])),
    "octopus": (octopus, 0.031, finer_near([((0.0, 0.68, 0.30), 0.25, 0.60, 0.60)])),
    "bear": (bear, 0.035, None),
}
# Those whose points come in pairs, exactly in each other's mirrored places about x = 0, as their triangles do.
SYMMETRIC = {"bear"}
