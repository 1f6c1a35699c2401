#!/usr/bin/env python3
"""Figure 12: what becomes of a drawing. (a) strokes over a picture: a boundary, red, closed features, blue, open ones, green; (b), (c) inflated,
its picture on it; (d) an outline with a keyhole and a shackle; (e), (f) extruded, the keyhole a tunnel, what the shackle spans a hole.

usage: inflation.py [PICTURE.png]
"""
import oversketch
from inflated import inked, picture_of, plate, system_of, view_of, whole
from sheet import Sheet, textured


def panels(sheet, system, turns):
    oversketch.update(system)
    front, picture = view_of(system), picture_of(system)
    sheet.panel(front, [plate(picture)], inked(system), whole(front))
    for turn in turns:
        sheet.panel(view_of(system, turn), [textured(system.GetOutput(), picture)], crop=whole(front))


page = Sheet(columns=3)
panels(page, system_of("fish"), (-40.0, 55.0))
panels(page, system_of("padlock", ExtrudeDepth=60.0), (-40.0, 30.0))
page.save("inflation.png")
