#!/usr/bin/env python3
"""Figure 17: models made from drawings: a picture and what was drawn over it, the model that wears it, its mesh. A fish, a mug, a heron drawn
with the magnetic pen, a leaf of quads, a padlock that is extruded, a gnome put together of three parts.

usage: models.py [PICTURE.png]
"""
import json
import numpy as np

import oversketch
from inflated import inked, netted, picture_of, plate, system_of, view_of, whole
from sheet import DATA, Sheet, textured


def moved(actor, shift):
    actor.SetPosition(*shift)
    return actor


def panels(parts, turn, crop, apart):
    """Drawings, the model, its mesh. A part is a system and where it goes; `apart` is where its drawing is shown."""
    models, nets = [], []
    for levels, actors in ((3, models), (2, nets)):
        for system, shift in parts:
            system.SetLevels(levels)
            mesh = oversketch.update(system)
            actors.append(moved(textured(mesh, picture_of(system)) if levels == 3 else netted(mesh, width=1.3), shift))
    front, side = view_of(parts[0][0]), view_of(parts[0][0], turn)
    plates = [moved(plate(picture_of(system)), shift) for (system, _), shift in zip(parts, apart)]
    lines = [(colour, width, line + shift[:2]) for (system, _), shift in zip(parts, apart) for colour, width, line in inked(system, 2.0)]
    low = np.min([shift[:2] for shift in apart], axis=0)
    high = np.max([np.add(shift[:2], picture_of(system).GetDimensions()[:2]) for (system, _), shift in zip(parts, apart)], axis=0)
    across = 1.2 * max(high[0] - low[0], 4 * (high[1] - low[1]) / 3)
    middle = (low + high) / 2
    sheet.panel(front, plates, lines, (middle[0] - across / 2, middle[1] - 0.375 * across, across, 0.75 * across))
    sheet.panel(side, models, crop=crop or whole(front, 1.1))
    sheet.panel(side, nets, crop=crop or whole(front, 1.1))


sheet = Sheet(columns=6, size=(320, 240))
here = [(0.0, 0.0, 0.0)]
for name, turn, parameters in (("fish", -35.0, {}), ("mug", 30.0, {}), ("heron", 35.0, {}), ("leaf", 45.0, {"Quads": True, "Height": 0.5}),
                               ("padlock", -40.0, {"ExtrudeDepth": 60.0})):
    panels([(system_of(name, **parameters), here[0])], turn, None, here)
placed = json.loads((DATA / "Drawings" / "figure.json").read_text())["parts"]
gnome = [(system_of(part["strokes"].removesuffix(".vtp")), [row[3] for row in part["placement"][:3]]) for part in placed]
panels(gnome, 30.0, (-510, -20, 1720, 1290), [(0.0, 0.0, 0.0), (680.0, 30.0, 0.0), (1230.0, 60.0, 0.0)])
sheet.save("models.png")
