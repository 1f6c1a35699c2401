"""The digests that were recorded, digests.json: by platform, as bits depend on compiler, libraries and processor."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional

import bits

PAGE = Path(__file__).with_name("digests.json")


class Digests(NamedTuple):
    """Of one run on one platform; mesh and arrays by back end."""

    input: str
    mesh: Dict[str, str]
    arrays: Dict[str, str]


class Figures(NamedTuple):
    """Of one run, what every platform must come near to."""

    points: int
    triangles: int
    bounds: List[float]
    moved: float


# How near. Bits of a platform move a border by a vertex, or make the remesher split one edge more.
COUNTS = 0.02  # of points and of triangles, of their number
BOUNDS = 0.01  # of the bounding box, of its diagonal
MOVED = 0.02  # of the share of points that moved
FEW = 0.05  # share of the runs that may be farther: where remeshing was a close decision, another platform decides otherwise


def apart(figures: Figures, made: bits.Row) -> List[str]:
    """In what a run is not near to the figures."""
    size = sum((b - a) ** 2 for a, b in zip(figures.bounds[::2], figures.bounds[1::2])) ** 0.5
    found = [f"{getattr(made, name)} {name}, recorded {getattr(figures, name)}" for name in ("points", "triangles")
             if abs(getattr(made, name) - getattr(figures, name)) > COUNTS * getattr(figures, name)]
    if max(abs(a - b) for a, b in zip(figures.bounds, made.bounds)) > BOUNDS * size:
        found.append(f"bounds {made.bounds}, recorded {figures.bounds}")
    if abs(figures.moved - made.moved) > MOVED:
        found.append(f"{made.moved} of the points moved, recorded {figures.moved}")
    return found


class Recorded:
    def __init__(self) -> None:
        told: Dict[str, Any] = json.loads(PAGE.read_text()) if PAGE.exists() else {"figures": {}, "platforms": []}
        self.figures = {name: Figures(*values) for name, values in told["figures"].items()}
        self.platforms = [(each["platform"], {name: Digests(*values) for name, values in each["rows"].items()})
                          for each in told["platforms"]]

    def on(self, platform: Dict[str, str]) -> Optional[Dict[str, Digests]]:
        return next((rows for known, rows in self.platforms if known == platform), None)

    def write(self) -> None:
        """One row a line, so that a change shows which."""
        def lines(rows: Dict[str, Any]) -> str:
            return "{\n" + ",\n".join(f"{json.dumps(name)}: {json.dumps(values)}" for name, values in sorted(rows.items())) + "\n}"

        platforms = ",\n".join(f'{{"platform": {json.dumps(platform)},\n"rows": {lines(rows)}}}' for platform, rows in self.platforms)
        PAGE.write_text(f'{{"figures": {lines(self.figures)},\n"platforms": [\n{platforms}\n]}}\n')
