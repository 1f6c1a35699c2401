#!/usr/bin/env python3
"""Figure 13: how far the rim is. (a) the distance to the boundary, the darker the farther; (b) its ridges, the skeleton; (c) how thick the
fish is, its distance at the ridges, smoothed over the inside: what heights are made of.

usage: distance_transform.py [PICTURE.png]
"""
import numpy as np

import oversketch
from inflated import on_paper, painted, pixels_of, plate, system_of, thicker, view_of, whole
from sheet import Sheet, by_value, lines_of

system = system_of("fish")
oversketch.update(system)
raster = system.GetStep("Distance").GetDistanceOutput()
away, ridge = (pixels_of(raster, name) for name in ("T", "Skeleton"))
thickness = pixels_of(system.GetStep("Inflate").GetHeightsOutput(), "LocalMaxSmooth")
inside = (away > 0)[..., None]
share = np.clip(thickness / thickness.max(), 0, 1)
pictures = (np.repeat(1.0 - away[..., None] / away.max(), 3, axis=2),
            np.where(thicker(thicker(ridge > 0))[..., None], (0.10, 0.10, 0.14), np.where(inside, (0.88, 0.90, 0.94), 1.0)),
            np.where(inside, by_value(share.ravel()).reshape(*share.shape, 3), 1.0))
view, sheet = view_of(system), Sheet(columns=3, size=(480, 360))
rim = [((0.35, 0.35, 0.40), 1.5, on_paper(lines_of(system.GetInnerOutput("Treatment"))[0]))]
for picture in pictures:
    sheet.panel(view, [plate(painted(raster, picture))], rim, whole(view, 1.05))
sheet.save("distance_transform.png")
