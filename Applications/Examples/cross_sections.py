#!/usr/bin/env python3
"""Figure 14: cross-sections of one drawing. (a) circle; (b) linear, creased along the skeleton; (c) step, a plateau with round shoulders; (d) one
that is drawn; (e) circle of half the height; (f) inflated by a Poisson equation.

usage: cross_sections.py [PICTURE.png]
"""
import oversketch
from inflated import system_of, view_of
from sheet import Sheet, clay

system = system_of("heron")
sheet = Sheet(columns=3)
for profile, height, poisson in (("circle", 1.0, False), ("linear", 1.0, False), ("step", 1.0, False), ("0 0, 0.3 0.7, 0.6 0.75, 1 1", 1.0, False),
                                 ("circle", 0.5, False), ("circle", 1.0, True)):
    system.SetProfile(profile)
    system.SetHeight(height)
    system.SetPoisson(poisson)
    mesh = oversketch.update(system)
    sheet.panel(view_of(system, 50.0), [clay(mesh)], crop=(180, 320, 520, 390))
sheet.save("cross_sections.png")
