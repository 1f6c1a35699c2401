"""What is drawn in space, and the cameras that it is seen by. No test of its own."""
import math

# A line and a ring before the palm of the shipped hand.
LINE = [(0.14 - 0.02 * i, 0.12 - 0.03 * i, 0.6) for i in range(9)]
RING = [(0.06 + 0.25 * math.cos(math.pi * i / 20), 0.0 + 0.25 * math.sin(math.pi * i / 20), 0.6) for i in range(41)]
CAMERA = {"CameraPosition": [0.0, 0.0, 9.0], "CameraFocalPoint": [0.0, 0.0, 0.0], "CameraViewUp": [0.0, 1.0, 0.0],
          "CameraParallelProjection": 1, "CameraParallelScale": 1.0, "ViewSize": [800, 600]}

# A hand's clicks on the picture of the mug: its outline, the handle's inside and the lip; each with whether it is closed.
MUG = [([(x, y, 0.0) for x, y in points], closed) for points, closed in [
    ([(118, 518), (150, 543), (231, 558), (300, 559), (391, 556), (459, 539), (485, 517), (482, 488), (511, 482), (556, 480), (598, 448),
      (620, 395), (625, 338), (605, 283), (571, 242), (519, 208), (464, 190), (458, 148), (442, 111), (411, 96), (299, 85), (211, 93),
      (167, 103), (147, 140), (136, 198), (126, 318), (121, 440)], 1),
    ([(483, 426), (509, 431), (541, 428), (564, 398), (571, 360), (567, 313), (539, 278), (506, 252), (470, 243), (471, 318), (478, 380)],
      1),
    ([(133, 506), (152, 498), (214, 487), (301, 483), (391, 487), (449, 501), (470, 508)], 0),
]]
OVER_PICTURE = dict(CAMERA, CameraPosition=[360.0, 320.0, 1000.0], CameraFocalPoint=[360.0, 320.0, 0.0], CameraParallelScale=350.0)
