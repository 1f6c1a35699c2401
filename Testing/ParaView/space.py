"""A line and a ring in space before the palm of the shipped hand, and the camera that they are seen by. No test of its own."""
import math

LINE = [(0.14 - 0.02 * i, 0.12 - 0.03 * i, 0.6) for i in range(9)]
RING = [(0.06 + 0.25 * math.cos(math.pi * i / 20), 0.0 + 0.25 * math.sin(math.pi * i / 20), 0.6) for i in range(41)]
CAMERA = {"CameraPosition": [0.0, 0.0, 9.0], "CameraFocalPoint": [0.0, 0.0, 0.0], "CameraViewUp": [0.0, 1.0, 0.0],
          "CameraParallelProjection": 1, "CameraParallelScale": 1.0, "ViewSize": [800, 600]}
