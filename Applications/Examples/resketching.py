#!/usr/bin/env python3
"""Figure 4.3: a part of the line drawn anew. (a) the line on the model, red, and a stroke beside a part of it, green; (b) what comes of
both: where the line was left it keeps its vertices, blue, and what is new, red, runs over into it; (c) the edit as the line was first
drawn, (d) as it is.

usage: resketching.py [PICTURE.png]
"""
import numpy as np

from edited import array, at_rest, edit, redrawn
from sheet import BLUE, GREEN, RED, Sheet, View, clay, curve, drawn, lines_of, load

NAME, MOVE, CROP = "dinosaur_crest", "move 0.5 n 0.12", (190, 195, 420, 315)
model, line = (reader.GetOutput() for reader in load(NAME))
ring, view, samples = drawn(NAME + "_ring").GetOutput(), View(line), lines_of(line)[0][:, :2]
part = samples[len(samples) * 4 // 10:len(samples) * 7 // 10]
bow = part - np.outer(2.0 + 20.0 * np.sin(np.pi * np.linspace(0.0, 1.0, len(part))), (0.0, 1.0))
before = edit(model, line, ring, Operations=MOVE)
after = edit(model, redrawn(line, bow), ring, Operations=MOVE)
blended = after.GetInnerOutput("Resketch")
kept, places = array(blended.GetPointData(), "VertexId") >= 0, lines_of(blended)[0]
cuts = np.flatnonzero(np.diff(kept)) + 1
old = [run for run, was in zip(np.split(places, cuts), np.split(kept, cuts)) if was[0]]
sheet = Sheet(columns=2, size=(520, 390))
sheet.panel(view, [clay(model)], curve([view.pixels(at_rest(before)[0])], RED) + curve([bow], GREEN), CROP)
sheet.panel(view, [clay(model)], curve([places], RED) + curve(old, BLUE, 3.4), CROP)
sheet.panel(view, [clay(before.GetOutput())], crop=CROP)
sheet.panel(view, [clay(after.GetOutput())], crop=CROP)
sheet.save("resketching.png")
