"""Strokes along a torso, made by rule: a part of the outline in a view that belongs to no limb, raised or lowered smoothly."""
import sys
from pathlib import Path
from typing import Dict, List, Tuple

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import meshes  # noqa: E402
import picture  # noqa: E402
import stroke_files  # noqa: E402
import strokes  # noqa: E402

AMOUNTS = (20.0, -14.0, 14.0, -10.0)  # px, outwards first
LENGTHS = (180.0, 150.0, 120.0)  # px along the outline
DEPTH = 45.0  # px of model behind each place
STRAIGHT = 0.9  # least share of its length that is between its ends
VIEWS = 12  # that are looked at


def raised(section: np.ndarray, amount: float) -> np.ndarray:
    """The section moved outwards, to its right, most in the middle and not at its ends."""
    section = strokes.smooth(section, 3.0)
    tangent = np.gradient(section, axis=0)
    normal = np.c_[tangent[:, 1], -tangent[:, 0]] / np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-9)
    share = np.linspace(0, 1, len(section))
    size = amount * strokes.ramp(np.minimum(share, 1 - share) / 0.4)
    return section + strokes.smooth(normal, 6.0) * size[:, None]


def sections_in(limbs: List[Dict], twice: np.ndarray) -> List[np.ndarray]:
    """Nearly straight parts of the outer outline that are far from every limb, with nothing but a thick body behind them, the
    longest first. twice: where the surface lies twice, once entered and once left."""
    outer = limbs[0]["outer"]
    n = len(outer)
    free = np.ones(n, bool)
    for limb in limbs:
        free[np.concatenate([limb["ids"], limb["ids"][0] - np.arange(1, 8), limb["ids"][-1] + np.arange(1, 8)]) % n] = False
    tangent = np.roll(outer, -3, axis=0) - np.roll(outer, 3, axis=0)
    inward = np.c_[-tangent[:, 1], tangent[:, 0]] / np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-9)
    for depth in np.linspace(6, DEPTH, 10):
        at = np.clip((outer + depth * inward).astype(int), 0, (picture.WIDTH - 1, picture.HEIGHT - 1))
        free &= twice[at[:, 1], at[:, 0]]
    found = []
    for length in LENGTHS:
        count = int(length / strokes.SPACING)
        for a in range(0, n, 8):
            ids = np.arange(a, a + count) % n
            section = outer[ids]
            if free[ids].all() and np.linalg.norm(section[-1] - section[0]) >= STRAIGHT * length:
                found.append(section)
    return found


def drawable(section: np.ndarray, line: np.ndarray, outer: np.ndarray) -> bool:
    """Whether a person could draw this: inside the picture, not over itself, clear of the rest of the outline."""
    if (line < 10).any() or (line > (picture.WIDTH - 10, picture.HEIGHT - 10)).any() or strokes.crosses_itself(line):
        return False
    others = outer[picture.distance_to(outer, [section])[0] > 1.0]
    gap = np.linalg.norm(line[:, None] - others, axis=2).min(1)
    return bool(gap[len(gap) // 5:-len(gap) // 5].min() > 15)


def strokes_for(name: str, mesh, up: str, number: int = 0, count: int = 1) -> List[Tuple[object, Dict]]:
    """A model's strokes along its torso: (stroke polydata, its note), each in a view of its own."""
    points, triangles, _ = meshes.weld(*meshes.arrays(mesh))
    made: List[Tuple[object, Dict]] = []
    for view_number, perspective, view in strokes.views_of(points, up):
        if (view_number % 2 == 0) == perspective:
            continue
        if len(made) == count or view_number >= VIEWS:
            break
        limbs, xy, _, _ = strokes.limbs_in(view, points, triangles)
        sections = sections_in(limbs, picture.layers(xy, triangles) == 2) if limbs else []
        amounts = np.roll(AMOUNTS, -(number + len(made)) % 2)
        choices = ((section, float(amount)) for section in sections for amount in amounts)
        chosen = next((c for c in choices if drawable(c[0], raised(*c), limbs[0]["outer"])), None)
        if chosen is not None:
            section, amount = chosen
            note = {"name": f"{name}-torso{len(made) + 1}-{'raise' if amount > 0 else 'lower'}", "model": name, "kind": "torso",
                    "amount": amount, "projection": "perspective" if perspective else "orthographic",
                    "section": np.round(section, 2).tolist()}
            made.append((stroke_files.polydata(strokes.pen(raised(section, amount), len(made)), view, note), note))
    return made
