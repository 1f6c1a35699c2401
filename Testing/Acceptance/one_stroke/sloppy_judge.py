"""Judges what a sloppy stroke did: whether the outline follows what was drawn, whether anything changed in the picture far from
there or was turned inside out, whether that was said; and where neither holds, which step went wrong."""
import sys
from pathlib import Path
from typing import Dict, List, Tuple

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import judge  # noqa: E402
import picture  # noqa: E402

MEAN = 3.0  # px, mean distance of the stroke's middle 60 % to the outline
FAR = 30.0  # px from the hull of stroke and section, beyond which nothing may change
MOVED = 3.0  # px that a visible point may move there all the same
NEAR = 12.0  # px within which the matched section runs along the meant one


class Seen:
    """A mesh in a view: what it covers, and where its points are in the picture."""

    def __init__(self, view: picture.View, points: np.ndarray, triangles: np.ndarray):
        self.view, self.points, self.triangles = view, points, triangles
        self.xy, self.depth = view.display(points)
        self.pixel, self.triangle = picture.fragments(self.xy, triangles, view.width, view.height)
        covered = np.zeros(view.width * view.height, bool)
        covered[self.pixel] = True
        self.covered = covered.reshape(view.height, view.width)
        self.back = judge.back_share(view, points, triangles)

    def visible(self) -> np.ndarray:
        """Points that nothing is in front of, by more than 1 % of the mesh's depth."""
        near = np.full(self.covered.size, -np.inf)  # of each pixel the front triangle's farthest corner
        np.maximum.at(near, self.pixel, self.depth[self.triangles].min(1)[self.triangle])
        column, row = np.floor(self.xy).astype(int).T
        within = (column >= 0) & (column < self.view.width) & (row >= 0) & (row < self.view.height)
        seen = np.zeros(len(self.xy), bool)
        front = near[row[within] * self.view.width + column[within]]
        seen[within] = self.depth[within] >= front - 0.01 * np.ptp(self.depth)
        return seen


def hull(places: np.ndarray) -> np.ndarray:
    """The corners of the convex hull, counterclockwise."""
    ordered = np.unique(places, axis=0)

    def half(run: np.ndarray) -> List[np.ndarray]:
        chain: List[np.ndarray] = []
        for p in run:
            while len(chain) > 1 and ((chain[-1][0] - chain[-2][0]) * (p[1] - chain[-2][1])
                                      <= (chain[-1][1] - chain[-2][1]) * (p[0] - chain[-2][0])):
                chain.pop()
            chain.append(p)
        return chain[:-1]

    return np.array(half(ordered) + half(ordered[::-1]))


def off_hull(places: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Px from each place to a convex polygon; zero inside."""
    best = np.full(len(places), np.inf)
    inside = np.ones(len(places), bool)
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        along, to = b - a, places - a
        share = np.clip(to @ along / max(float(along @ along), 1e-12), 0, 1)
        best = np.minimum(best, np.linalg.norm(to - share[:, None] * along, axis=1))
        inside &= along[0] * to[:, 1] - along[1] * to[:, 0] >= 0
    return np.where(inside, 0.0, best)


def thick(mask: np.ndarray) -> np.ndarray:
    """The pixels whose eight neighbours belong to the mask as well: what is thinner than 3 px is gone."""
    core = np.pad(mask, 1)
    core = core[:, :-2] & core[:, 1:-1] & core[:, 2:]
    return core[:-2] & core[1:-1] & core[2:]


def changes(before: Seen, after: Seen, corners: np.ndarray) -> Dict[str, float]:
    """far pixels: covered before and not after or the other way, in patches at least 3 px thick, beyond FAR from the hull;
    farthest: px of the farthest change."""
    changed = thick(before.covered & ~after.covered) | thick(after.covered & ~before.covered)
    row, column = np.nonzero(changed)
    off = off_hull(np.c_[column, row] + 0.5, corners)
    return {"far pixels": int((off > FAR).sum()), "farthest": float(off.max()) if len(off) else 0.0}


def movements(view: picture.View, was: np.ndarray, now: np.ndarray, visible: np.ndarray, corners: np.ndarray) -> Dict[str, float]:
    """far points: visible ones that moved by more than MOVED px and are, or were, beyond FAR from the hull; moved: px that the
    one of them that moved most did; farthest: px of the farthest."""
    a, b = view.display(was[visible])[0], view.display(now[visible])[0]
    moved = np.linalg.norm(b - a, axis=1)
    a, b, moved = a[moved > MOVED], b[moved > MOVED], moved[moved > MOVED]
    off = np.maximum(off_hull(a, corners), off_hull(b, corners))
    far = off > FAR
    return {"far points": int(far.sum()), "moved": float(moved[far].max()) if far.any() else 0.0,
            "farthest": float(off.max()) if len(off) else 0.0}


def judge_result(before: Seen, after: Tuple[np.ndarray, np.ndarray], pairs: Tuple[np.ndarray, np.ndarray, np.ndarray],
                 stroke: np.ndarray, section: np.ndarray) -> Dict[str, object]:
    """Measures of a result, and `fails`. after: points and triangles; pairs: where points were and are now, and which of them
    are visible before; section: what the stroke was meant to be drawn over."""
    if not np.isfinite(after[0]).all():
        return {"fails": ["not finite"]}
    corners = hull(np.vstack([stroke, section]))
    mean, worst, back = judge.outline_distances(before.view, *after, stroke)
    seen = Seen(before.view, *after)
    edge = changes(before, seen, corners)
    inner = movements(before.view, *pairs, corners)
    result: Dict[str, object] = {"mean": mean, "worst": worst, "back": back, "far pixels": edge["far pixels"],
                                 "far points": inner["far points"], "moved": inner["moved"], "inside out": seen.back - before.back,
                                 "farthest": max(edge["farthest"], inner["farthest"])}
    fails = {"outline": mean > MEAN, "far in outline": edge["far pixels"] > 0, "far inside": inner["far points"] > 0,
             "inside out": seen.back - before.back > judge.INSIDE_OUT}
    result["fails"] = [name for name, failed in fails.items() if failed]
    return result


def verdict(result: Dict[str, object], said: str) -> str:
    """as meant, said (refused or warned), or wreck."""
    return "as meant" if not result["fails"] else "said" if said else "wreck"


def matched(section: np.ndarray, match: np.ndarray) -> Dict[str, float]:
    """How the matched section lies to the meant one, in px of the picture: covered, the share of the meant one's middle 60 % that
    it runs along; strays, the share of its length that it does not; longer, its length as a multiple."""
    if len(match) < 2:
        return {"covered": 0.0, "strays": 0.0, "longer": 0.0}
    total, length = picture.lengths(section)[-1], picture.lengths(match)[-1]
    middle = picture.resample(judge.part(section, 0.2 * total, 0.8 * total), 2.0)
    along = picture.resample(match, 2.0)
    return {"covered": float((picture.distance_to(middle, [match])[0] < NEAR).mean()),
            "strays": float((picture.distance_to(along, [section])[0] > NEAR).mean()), "longer": float(length / total)}


def cause(result: Dict[str, object], lies: Dict[str, float]) -> str:
    """Which step of a wreck went wrong."""
    fails = list(result["fails"])  # type: ignore[call-overload]
    if "mean" not in result:
        return ", ".join(fails)
    if lies["covered"] < 0.5:
        if lies["longer"] > 1.8:
            return "wrong section: the long way"
        return "wrong section: crotch or other limb" if lies["strays"] > 0.5 else "wrong section: a part of it"
    if lies["strays"] > 0.2:
        return "section runs on elsewhere"
    if fails == ["inside out"]:
        return "turned inside out, as drawn otherwise"
    if fails == ["outline"]:
        return "outline misses the stroke, nothing else moved"
    return "region too large" + (", outline misses too" if "outline" in fails else "")
