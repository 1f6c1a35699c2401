#!/usr/bin/env python3
"""Figure 15: holes and tunnels. (a) a stroke within a boundary; (b) a hole is cut out before the surface is made, which comes down to its rim;
(c) a tunnel is cut through the finished surface; (d) a mug's handle, (e) a hole, (f) a tunnel.

usage: holes_and_tunnels.py [PICTURE.png]
"""
import oversketch
from inflated import inked, picture_of, plate, ring, system_of, view_of, whole
from sheet import Sheet, clay, textured

tyre = oversketch.vtkOversketchInflateDrawing()
tyre.SetInputData(0, oversketch.drawing([ring(320, 240, 200, 200), ring(320, 240, 80, 80)], (640, 480), True))
tyre.SetLevels(4)
sheet = Sheet(columns=3)
oversketch.update(tyre)
sheet.panel(view_of(tyre), [], inked(tyre))
for kind in ("Holes", "Tunnels"):
    tyre.SetHoles("")
    getattr(tyre, "Set" + kind)("1")
    sheet.panel(view_of(tyre, 42.0), [clay(oversketch.update(tyre), crease=50)])

mug = system_of("mug")
oversketch.update(mug)
front, picture = view_of(mug), picture_of(mug)
sheet.panel(front, [plate(picture)], inked(mug), whole(front, 1.05))
for kind in ("Holes", "Tunnels"):
    mug.SetHoles("")
    getattr(mug, "Set" + kind)("1")
    oversketch.update(mug)
    sheet.panel(view_of(mug, 25.0), [textured(mug.GetOutput(), picture)], crop=whole(front, 1.05))
sheet.save("holes_and_tunnels.png")
