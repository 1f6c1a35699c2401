"""The runs of sloppy.py: a model's well-made strokes, and what the system makes of each of them and of its variants."""
import json
import re
import sys
import time
from itertools import groupby
from pathlib import Path
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Tuple

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import accept  # noqa: E402
import frame  # noqa: E402
import hands  # noqa: E402
import meshes  # noqa: E402
import picture  # noqa: E402
import sloppy_judge  # noqa: E402
import stroke_files  # noqa: E402
import strokes  # noqa: E402
import torso  # noqa: E402

LARGE = 100_000  # triangles, above which a model has one stroke
PLACE = re.compile(r"\w+: In .*, line \d+\s+\w+ \(\w+\): ")  # that VTK puts before a message
AS_DRAWN = -1  # the number of the variant that is the well-made stroke itself


class Run(NamedTuple):
    stroke: str
    number: int  # of the variant
    mode: str  # default or published


def make(folder: Path, number: int, name: str, path: Path, up: str) -> List[Dict[str, str]]:
    """Writes a model's well-made strokes, those of its limbs and one along its torso; returns their entries."""
    mesh = meshes.read(path)
    few = mesh.GetNumberOfCells() > LARGE
    made = strokes.strokes_for(name, mesh, up, number, 1 if few else strokes.PER_MODEL)
    made += [] if few else torso.strokes_for(name, mesh, up, number)
    for stroke, note in made:
        stroke_files.write(stroke, folder / f"{note['name']}.vtp")
    return [{"name": note["name"], "model": name, "mesh": str(path), "part": "torso" if note["kind"] == "torso" else "limb"}
            for _, note in made]


def runs_of(entries: List[Dict[str, str]], variants: int, modes: List[str]) -> List[Run]:
    """All runs of some strokes, those of one mode and view together."""
    return [Run(entry["name"], number, mode) for mode in modes for entry in entries for number in range(AS_DRAWN, variants)]


class Scene:
    """A model in the view of one of its strokes."""

    def __init__(self, file: Path, mesh: Any):
        _, samples, self.view, note = stroke_files.read(file)
        self.section = np.array(note["section"])
        self.before = sloppy_judge.Seen(self.view, *meshes.weld(*meshes.arrays(mesh))[:2])
        loops = picture.outline(self.before.xy, self.before.triangles, 1.0)
        outer = max(loops, key=lambda l: float(np.sum(l[:-1, 0] * l[1:, 1] - l[1:, 0] * l[:-1, 1])))
        self.meant = hands.Meant(note["name"], samples, note["kind"] != "torso", *hands.parts_beside(outer, self.section),
                                 (self.view.width, self.view.height))

    def drawn(self, number: int) -> Tuple[str, Dict[str, object], np.ndarray]:
        return ("as drawn", {}, self.meant.samples) if number == AS_DRAWN else hands.variant(self.meant, number)


class System:
    """The filter on one model, and what it said of its last stroke."""

    def __init__(self, mode: str, mesh: Any):
        self.messages: List[str] = []
        self.filter = accept.system(mode, "auto")
        for event in ("ErrorEvent", "WarningEvent"):
            self.filter.AddObserver(event, frame.listener(self.messages))
        self.filter.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        self.filter.SetInputData(mesh)

    def run(self, stroke: Any) -> Tuple[str, float]:
        """(what was said, seconds)."""
        self.messages.clear()
        self.filter.SetStrokeData(stroke)
        start = time.perf_counter()
        self.filter.Update()
        seconds = time.perf_counter() - start
        remark = getattr(self.filter, "GetRemark", lambda: "")() or ""
        told = [PLACE.sub("", message).strip() for message in self.messages]
        return "; ".join(dict.fromkeys(told + [remark] * bool(remark))), seconds

    def pairs(self, view: picture.View) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Where the points of the mesh were and are now, and which were visible. Where it was remeshed they are those of the
        finer mesh that was deformed."""
        was, triangles = meshes.arrays(self.filter.GetInnerOutput("Stretch" if self.filter.GetRemeshed() else "RegionBorder"))
        now, _ = meshes.arrays(self.filter.GetInnerOutput("Deform"))
        return was, now, sloppy_judge.Seen(view, was, triangles).visible()

    def match(self, view: picture.View) -> np.ndarray:
        """The matched section in the picture."""
        found = self.filter.GetInnerOutput("Match")
        if found is None or found.GetNumberOfPoints() == 0:
            return np.empty((0, 2))
        return view.display(vtk_to_numpy(found.GetPoints().GetData()).astype(float))[0]


def result_of(system: System, scene: Scene, line: np.ndarray, said: str) -> Dict[str, Any]:
    """Measures, what was said and the verdict; of what is not as meant also how the matched section lies, and the cause."""
    output = system.filter.GetOutput()
    if output.GetNumberOfCells() == 0:
        result: Dict[str, Any] = {"fails": ["refused" if said else "empty without a word"]}
    else:
        after = meshes.weld(*meshes.arrays(output))[:2]
        result = sloppy_judge.judge_result(scene.before, after, system.pairs(scene.view), line, scene.section)
        result["remeshed"] = bool(system.filter.GetRemeshed())
    result.update(said=said, verdict=sloppy_judge.verdict(result, said))
    if result["verdict"] != "as meant":
        lies = sloppy_judge.matched(scene.section, system.match(scene.view)) if "mean" in result else {}
        result.update(lies, cause=sloppy_judge.cause(result, lies))
    return result


def results(folder: Path, entries: List[Dict[str, str]], runs: List[Run],
            pictures: Optional[Path] = None) -> Iterator[Dict[str, Any]]:
    """The result of each run over one model, in order. pictures: a folder for those of the wrecks."""
    mesh = meshes.read(entries[0]["mesh"])
    parts = {entry["name"]: entry["part"] for entry in entries}
    for mode, of_mode in groupby(runs, lambda run: run.mode):
        system = System(mode, mesh)
        for stroke, of_stroke in groupby(of_mode, lambda run: run.stroke):
            scene = Scene(folder / f"{stroke}.vtp", mesh)
            for run in of_stroke:
                hand, how, line = scene.drawn(run.number)
                said, seconds = system.run(stroke_files.polydata(line, scene.view))
                row = {**run._asdict(), "model": entries[0]["model"], "part": parts[stroke], "hand": hand, "how": how,
                       **result_of(system, scene, line, said), "seconds": round(seconds, 3)}
                if pictures and row["verdict"] == "wreck" and mode == "default":
                    picture.save(show(system, scene, line, mesh, row), pictures / f"{stroke}-{run.number}.png")
                yield row


def show(system: System, scene: Scene, line: np.ndarray, mesh: Any, row: Dict[str, Any]) -> np.ndarray:
    """Before with region and matched section, and after; the stroke in both."""
    before, output, border = meshes.arrays(mesh), system.filter.GetOutput(), system.filter.GetInnerOutput("RegionBorder")
    after = meshes.arrays(output) if output.GetNumberOfCells() else before
    region = accept.region_of(border, before[0]) if border.GetNumberOfPoints() else np.zeros(len(before[0]), bool)
    image = accept.show(scene.view, before, after, line, system.filter.GetInnerOutput("Match"), region)
    amounts = ", ".join(f"{name} {np.round(value, 2)}" for name, value in row["how"].items())
    picture.write_text(image, f"{row['stroke']} {row['number']}: {row['hand']} ({amounts})", 6, 6, 24)
    figures = f"mean {row.get('mean', np.nan):.1f} px, farthest {row.get('farthest', np.nan):.0f} px"
    picture.write_text(image, f"{row['cause']}  {figures}", 6, 34, 24, picture.RED)
    return picture.halve(image)


def work(folder: Path, entries: List[Dict[str, str]], runs: List[Run], pictures: Optional[Path] = None) -> None:
    """Prints each result as a line of JSON: what a process of its own does."""
    for row in results(folder, entries, runs, pictures):
        print("\n" + json.dumps(row), flush=True)
