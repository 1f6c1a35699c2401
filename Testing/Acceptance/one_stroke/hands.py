"""Sloppy hands: what a person makes of a stroke that was meant well. Each hand takes display px samples and gives others; a
variant is one hand with an amount that the stroke's name and the variant's number decide, the same at every run.
"""
import sys
import zlib
from pathlib import Path
from typing import Callable, Dict, List, NamedTuple, Tuple

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import judge  # noqa: E402
import picture  # noqa: E402
import strokes  # noqa: E402

SHIFT, TURN, SHARE, WOBBLE, INSIDE = 25.0, 15.0, 0.20, 3.0, 30.0  # px, degrees, share of the length, px, px
ELSEWHERE = 0.25  # of a stroke's length at most to another limb: the middle 60 % of what is drawn are as meant
STEP = 4.0  # px between samples that a hand adds
MARGIN = 4.0  # px of the picture's edge that no stroke enters
PAST = 6.0  # px that the ends of a closed stroke miss each other by
PART = 40.0  # px along the outline from a section's ends where another part of the model begins

HANDS = ("shifted", "turned", "trimmed", "run on", "wobbled", "inside", "begun elsewhere", "ended elsewhere", "closed")


class Meant(NamedTuple):
    """A well-made stroke and what the hands know of its place."""

    name: str
    samples: np.ndarray  # (n, 2) px
    limb: bool  # from base to base round a tip; else along the torso
    starts: np.ndarray  # (k, 2) px, places of other limbs that the pen may begin on
    ends: np.ndarray  # and end on
    size: Tuple[int, int]  # of the picture


# ---------------------------------------------------------------------------------------------------- the hands

def shifted(line: np.ndarray, by) -> np.ndarray:
    return line + np.asarray(by, float)


def turned(line: np.ndarray, degrees: float) -> np.ndarray:
    """About the middle of the stroke's bounding box."""
    centre, angle = (line.min(0) + line.max(0)) / 2, np.radians(degrees)
    c, s = np.cos(angle), np.sin(angle)
    return centre + (line - centre) @ np.array([[c, s], [-s, c]])


def trimmed(line: np.ndarray, start: float, end: float) -> np.ndarray:
    """Without these shares of its length."""
    total = picture.lengths(line)[-1]
    return judge.part(line, start * total, (1 - end) * total)


def extended(line: np.ndarray, towards, length: float) -> np.ndarray:
    """Led on from its end straight towards a point, so far at most."""
    gap = np.asarray(towards, float) - line[-1]
    distance = float(np.linalg.norm(gap))
    if distance == 0.0 or length <= 0.0:
        return line
    more = picture.resample(np.array([line[-1], line[-1] + gap * min(1.0, length / distance)]), STEP)
    return np.vstack([line, more[1:]])


def run_on(line: np.ndarray, start: float, end: float) -> np.ndarray:
    """Led on by these shares of its length, in the direction that its ends have over 12 px."""
    total = picture.lengths(line)[-1]
    for share in (end, start):
        s = picture.lengths(line)
        before = np.array([np.interp(s[-1] - 12.0, s, line[:, k]) for k in range(2)])
        heading = (line[-1] - before) / max(float(np.linalg.norm(line[-1] - before)), 1e-9)
        line = extended(line, line[-1] + heading * 2 * total, share * total)[::-1]  # the other end comes next
    return line


def wobbled(line: np.ndarray, px: float, random: np.random.Generator) -> np.ndarray:
    """Waves of 30 to 90 px across the line; the largest is px high."""
    s = picture.lengths(line)
    wave = sum(np.sin(2 * np.pi * (s / random.uniform(30, 90) + random.random())) for _ in range(3))
    return line + left_of(line) * (wave * px / np.abs(wave).max())[:, None]


def left_of(line: np.ndarray) -> np.ndarray:
    tangent = np.gradient(line, axis=0)
    return np.c_[-tangent[:, 1], tangent[:, 0]] / np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-9)


def inside(line: np.ndarray, px: float) -> np.ndarray:
    """Beside itself, so far to the left, where the model is; what would come nearer than that to the line is left out."""
    even = picture.resample(line, 2.0)
    if len(even) > 40:
        even = strokes.smooth(even, 3.0)
    beside = even + left_of(even) * px
    beside = beside[picture.distance_to(beside, [even])[0] > 0.93 * px]
    return picture.resample(beside, STEP)


def width(line: np.ndarray) -> float:
    """Of the limb that a stroke goes round: length times width is the area that it encloses."""
    area = 0.5 * abs(float(np.sum(line[:, 0] * np.roll(line[:, 1], -1) - line[:, 1] * np.roll(line[:, 0], -1))))
    total = float(picture.lengths(line)[-1])
    wide = 0.0
    for _ in range(20):
        wide = 2 * area / max(total - wide, total / 2)
    return wide


def closed(line: np.ndarray, share: float, past: float) -> np.ndarray:
    """Round the tip and back over the limb's base: begun at a share of the way from its start to its end, ended so many px past
    that place (or short of it)."""
    across = line[0] - line[-1]
    start = line[0] - share * across
    end = start + past * across / max(float(np.linalg.norm(across)), 1e-9)
    return extended(extended(line, end, np.inf)[::-1], start, np.inf)[::-1]


def elsewhere(line: np.ndarray, places: np.ndarray, share: float, pick: float) -> np.ndarray:
    """Ended on one of the places that a share of its length reaches, picked by a number under 1; where it reaches none, on the
    way to the nearest."""
    if not len(places):
        return run_on(line, 0.0, share)
    reach, away = share * picture.lengths(line)[-1], np.linalg.norm(places - line[-1], axis=1)
    reached = np.flatnonzero(away <= reach)
    chosen = reached[int(pick * len(reached))] if len(reached) else away.argmin()
    return extended(line, places[chosen], reach)


def parts_beside(outer: np.ndarray, section: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Places of an outer outline (closed, in the section's direction) that are of other limbs, for a stroke's start and for its
    end: across the air from there. Where there are none, the outline that the section leaves."""
    body = picture.inside_polygon(outer)
    outer = picture.resample(outer, STEP)[:-1]
    first, last = (np.linalg.norm(outer - place, axis=1).argmin() for place in section[[0, -1]])
    rest = np.roll(outer, -int(last), axis=0)[:(int(first) - int(last)) % len(outer) + 1]
    along = STEP * np.arange(len(rest))
    away = (along > PART) & (along[::-1] > PART)
    found: List[np.ndarray] = []
    for place, way in ((section[0], along[::-1]), (section[-1], along)):
        between = place + np.linspace(0.1, 0.9, 9)[:, None, None] * (rest - place)
        column, row = np.moveaxis(np.clip(between.astype(int), 0, np.array(body.shape)[::-1] - 1), 2, 0)
        across = away & (way > 1.2 * np.linalg.norm(rest - place, axis=1)) & (body[row, column].mean(0) < 0.4)
        found.append(rest[across] if across.any() else rest[away])
    return found[0], found[1]


# --------------------------------------------------------------------------------------------------- the variants

def within(line: np.ndarray, size: Tuple[int, int]) -> bool:
    return bool((line >= MARGIN).all() and (line <= np.array(size) - MARGIN).all())


def hand_of(meant: Meant, number: int) -> str:
    """The hands in turn; the tenth is another shift, and a torso has no tip to go round."""
    hand = (HANDS + ("shifted",))[number % 10]
    return "turned" if hand == "closed" and not meant.limb else hand


def variant(meant: Meant, number: int) -> Tuple[str, Dict[str, object], np.ndarray]:
    """(hand, its amounts, samples). Amounts are halved until the stroke is inside the picture."""
    hand = hand_of(meant, number)
    seed = zlib.crc32(f"{meant.name}/{number}".encode())
    for halvings in range(8):
        how, line = drawn(meant, hand, np.random.default_rng(seed), 0.5 ** halvings)
        if within(line, meant.size):
            break
    return hand, how, line


def drawn(meant: Meant, hand: str, random: np.random.Generator, factor: float) -> Tuple[Dict[str, object], np.ndarray]:
    line = meant.samples
    amount = factor * random.uniform(0.3, 1.0)
    if hand == "shifted":
        angle = random.uniform(0, 2 * np.pi)
        by = SHIFT * amount * np.array([np.cos(angle), np.sin(angle)])
        return {"by": [float(v) for v in by]}, shifted(line, by)
    if hand == "turned":
        degrees = TURN * amount * random.choice([-1, 1])
        return {"degrees": float(degrees)}, turned(line, degrees)
    if hand in ("trimmed", "run on"):
        first = random.choice([0.0, 0.5, 1.0])  # at the end, at both, at the start
        start, end = float(SHARE * amount * first), float(SHARE * amount * (1 - first))
        make: Callable = trimmed if hand == "trimmed" else run_on
        return {"start": start, "end": end}, make(line, start, end)
    if hand == "wobbled":
        return {"px": WOBBLE * amount}, wobbled(line, WOBBLE * amount, random)
    if hand == "inside":  # a third of a limb's width at most: it has two sides
        px = min(INSIDE * amount, 0.33 * width(line)) if meant.limb else INSIDE * amount
        return {"px": float(px)}, inside(line, px)
    if hand == "closed":
        share, past = float(random.uniform(0.3, 0.7)), float(random.uniform(-PAST, PAST))
        return {"at": share, "past": past}, closed(line, share, past)
    share, pick = factor * ELSEWHERE, random.random()
    if hand == "begun elsewhere":
        line = elsewhere(line[::-1], meant.starts, share, pick)[::-1]
        return {"at": [float(v) for v in line[0]]}, line
    line = elsewhere(line, meant.ends, share, pick)
    return {"at": [float(v) for v in line[-1]]}, line
