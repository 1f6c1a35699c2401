"""The acceptance of edits: lines and rings over eighteen models, drawn by three hands in six cameras, rings round the tips of limbs and
half beside a sphere, by default and as published. Every step's output goes into files, which alone are judged.

    PYTHONPATH=build/release/lib/python3/dist-packages /usr/bin/python3 Testing/Acceptance/edit/accept.py FOLDER
        [--strokes FOLDER] [--only PART-OF-NAME ...] [--modes default,published] [--workers 2] [--limit SECONDS] [--no-pictures] [--continue]

An entry is named MODEL-hHAND-cCAMERA, its cases line, S and arc; MODEL-hHAND-tips; icosphere_20k-hHAND-half: `--only spot_`, `--only h0`,
`--only cat-h1-c3`. FOLDER receives table.md, results.json, a picture of every result and contact sheets; with --continue what results.json
has is not run again. The models are those of Data/Models and of the shared test data, looked for in OVERSKETCH_DATA, else in ../shared/data
beside the source tree. Exit code 0 when in each mode so many regions stand as the specification asks and all bounds hold in 95 % of those.
"""
import json
import sys
import tempfile
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData

sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parent)]
import edit_judge  # noqa: E402
import frame  # noqa: E402
import meshes  # noqa: E402
import patch as patches  # noqa: E402
import picture  # noqa: E402
import rings  # noqa: E402
import saved  # noqa: E402
import stroke_files  # noqa: E402

HEIGHT = 0.4  # half widths by which a profile is raised
STANDS = {"stands": {"default": 0.83, "published": 0.55}, "sphere stands": {"default": 1.0, "published": 0.0},
          "tip stands": {"default": 0.45, "published": 0.0}, "half stands": {"default": 1.0, "published": 8 / 12}}


class Refused(Exception):
    """The system made nothing; what it said."""


class Editor:
    """The system over one mesh, line and ring, and the folder that what it makes is written to."""

    def __init__(self, mesh, line, ring, mode, folder):
        from oversketch import vtkOversketchEdit
        self.system, self.folder, self.messages = vtkOversketchEdit(), Path(folder), []
        for event in ("ErrorEvent", "WarningEvent"):
            self.system.AddObserver(event, frame.listener(self.messages))
        self.system.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        for port, data in enumerate((mesh, line, ring)):
            self.system.SetInputData(port, data)
        if mode == "published":
            self.system.AsPublishedOn()

    def run(self, operations="", new_triangles=True):
        self.system.SetOperations(operations)
        self.system.SetRule(0 if new_triangles else 2)
        self.system.Update()
        if self.system.GetOutput().GetNumberOfCells() == 0:
            raise Refused(self.messages[-1] if self.messages else "no result")

    def put(self, name, curves=False):
        saved.write(self.system.GetOutput(), self.folder / f"{name}.vtp")
        if curves:
            saved.write(self.system.GetReferenceOutput(), self.folder / f"{name}_line.vtp")
            saved.write(self.system.GetBoundaryOutput(), self.folder / f"{name}_ring.vtp")

    def put_inner(self, name, step, port=0):
        data = self.system.GetStep(step).GetOutputDataObject(port)
        saved.write(data, self.folder / f"{name}.vtp")


def asked_profile(profile, half, aslant):
    """The section, raised by HEIGHT half widths times (1 - l^2)^2, outward or somewhat to the side too."""
    points = vtk_to_numpy(profile.GetPoints().GetData()).astype(float)
    side = vtk_to_numpy(profile.GetPointData().GetArray("SideDistance")).astype(float)
    matrix = vtk_to_numpy(profile.GetFieldData().GetArray("ProfileMatrix"))[0].reshape(4, 4)
    height = HEIGHT * half / np.linalg.norm(matrix[:3, 1]) * np.clip(1 - side ** 2, 0, 1) ** 2
    moved = points + height[:, None] * np.array([0.6 if aslant else 0.0, 1.0, 0.0])
    result, places, line = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetDataTypeToDouble()
    line.InsertNextCell(len(moved))
    for p in moved:
        line.InsertCellPoint(places.InsertNextPoint(*p))
    result.SetPoints(places)
    result.SetLines(line)
    return result


def black():
    image = vtkImageData()
    image.SetDimensions(8, 8, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.zeros(64, np.uint8), deep=True))
    return image


def put_rest(editor, mesh, strokes_of):
    """What went in and the mesh at rest with its region and curves; how far line and ring are apart."""
    folder = editor.folder
    saved.write(mesh, folder / "input.vtp")
    for name, stroke in strokes_of.items():
        stroke_files.write(stroke, folder / f"{name}.vtp")
    editor.run("", True)
    editor.put_inner("region", "Shading")
    editor.put_inner("line", "BoundaryInsert", 2)
    editor.put_inner("ring", "BoundaryInsert", 1)
    rest, line, ring = (saved.read(folder / f"{name}.vtp") for name in ("region", "line", "ring"))
    of = lambda curve: rest.points[patches.chain(curve)]
    return patches.half_width(of(line), of(ring))


def put_files(editor, mesh, strokes_of, mode, aslant):
    """Everything that the judge reads; what was refused on the way, by name."""
    folder, refused = editor.folder, {}
    half = put_rest(editor, mesh, strokes_of)

    def attempt(name, *arguments, **options):
        try:
            editor.run(*arguments)
        except Refused as why:
            refused[name] = str(why)
            return False
        editor.put(name, **options)
        return True

    attempt("dragged", f"move 0.5 n {half!r}", True, curves=True)
    if not attempt("off", f"move 0.5 n {half!r}", False) and (folder / "dragged.vtp").is_file():
        (folder / "dragged.vtp").unlink()
    if mode == "default":
        if attempt("turned", f"rotate 0.5 t {edit_judge.TURN}", False):
            editor.put_inner("handles", "Handles")
        part = f"move 0.25 n {0.5 * half!r}; pin 0.5"
        if attempt("part_off", part, False):
            attempt("part", part, True, curves=True)
        attempt("zero", "move 0.5 n 0; rotate 0.3 t 0; scale 0.7 w 1", True)
        editor.system.SetWeightsData(black())
        attempt("black", f"move 0.5 n {half!r}", True)
        editor.system.SetWeightsData(None)
    # The section is cut as soon as there is a profile; the first one only asks for it.
    profile = section(editor, refused)
    if profile is not None:
        saved.write(profile, folder / "profile.vtp")
        if mode == "default":
            editor.system.SetProfileData(profile)
            attempt("same", "", True)
        asked = asked_profile(profile, half, aslant)
        saved.write(asked, folder / "asked.vtp")
        editor.system.SetProfileData(asked)
        attempt("profiled", "", True, curves=True)
    return refused


def section(editor, refused):
    """The section of the region at the middle of the line, or None."""
    from oversketch import vtkOversketchCrossSection, vtkOversketchProfilePlanes
    planes, cut = vtkOversketchProfilePlanes(), vtkOversketchCrossSection()
    messages = []
    for step in (planes, cut):
        for event in ("ErrorEvent", "WarningEvent"):
            step.AddObserver(event, frame.listener(messages))
    system = editor.system
    region = system.GetStep("Distance").GetOutputDataObject(0)
    planes.SetFrame(system.GetStep("Planes").GetFrame())
    planes.SetInputData(0, region)
    planes.SetReferenceData(system.GetStep("BoundaryInsert").GetOutputDataObject(2))
    cut.SetEnds(system.GetStep("Section").GetEnds())
    cut.SetWalk(system.GetStep("Section").GetWalk())
    cut.SetInputData(0, region)
    cut.SetBoundaryData(system.GetStep("BoundaryInsert").GetOutputDataObject(1))
    cut.SetPlanesConnection(planes.GetOutputPort())
    cut.Update()
    if cut.GetOutput().GetNumberOfPoints() < 2:
        refused["profile"] = messages[-1] if messages else "no section"
        return None
    return cut.GetOutput()


def run(stroke_file, mesh_file, modes, _backend, pictures, case):
    """Runs one line and ring in every mode and returns {mode: result}; writes pictures into a folder where one is given."""
    entry = Path(stroke_file).with_suffix("")
    mesh = meshes.read(mesh_file)
    drawn = {name: stroke_files.read(f"{entry}-{case}-{what}.vtp") for name, what in (("reference", "line"), ("boundary", "ring"))}
    strokes_of = {name: stroke[0] for name, stroke in drawn.items()}
    kind = case if case in rings.KINDS else "half" if entry.name.endswith("-half") else "tip"
    stands = {"tip": "tip stands", "half": "half stands"}.get(kind, "stands")
    names = [stands] + ["sphere stands"] * (entry.name.startswith(rings.SPHERE) and kind in rings.KINDS)
    results = {}
    for mode in modes:
        with tempfile.TemporaryDirectory() as folder:
            editor = Editor(mesh, strokes_of["reference"], strokes_of["boundary"], mode, folder)
            try:
                refused = put_files(editor, mesh, strokes_of, mode, drawn["reference"][2].perspective)
                (Path(folder) / "run.json").write_text(json.dumps({"mode": mode, "kind": kind}))
                result = edit_judge.judge(folder)
                result["asks"] += names
                result.update({name: True for name in names}, messages=[f"{what}: {text}" for what, text in refused.items()])
                # A plane across a limb does not meet a ring round its tip, so there is no section to draw anew.
                result["fails"] += [f"{what} refused" for what in refused if what != "profile" or not edit_judge.goes_round(folder)]
                if pictures:
                    image = show(Path(folder), drawn)
            except Refused as why:
                result = {**{name: False for name in names}, "asks": names, "fails": list(names), "messages": [str(why)]}
                image = blank(mesh, drawn) if pictures else None
        result["holds"] = not result["fails"]
        results[mode] = result
        if pictures:
            picture.write_text(image, f"{entry.name} {case} {mode}", 8, 8, 20)
            if result["fails"]:
                picture.write_text(image, "FAILS " + ", ".join(result["fails"]), 8, 34, 20, picture.RED)
            picture.save(image, Path(pictures) / f"{entry.name} {case}-{mode}.png")
    return results


# ------------------------------------------------------------------------------------------------ pictures

def window(view, drawn):
    """The part of a view about the ring, as large as a picture, and what takes px to it."""
    ring = drawn["boundary"][1]
    low, high = ring.min(0) - 60, ring.max(0) + 60
    zoom = min(picture.WIDTH / (high[0] - low[0]), picture.HEIGHT / (high[1] - low[1]))
    return picture.magnified(view, (low + high) / 2, zoom)


def blank(mesh, drawn):
    """Line and ring over the model, where nothing came of them."""
    points, triangles, _ = meshes.weld(*meshes.arrays(mesh))
    view, placed = window(drawn["boundary"][2], drawn)
    left = picture.shaded(view, points, triangles, scale=1)
    for name, colour in (("reference", picture.RED), ("boundary", picture.BLUE)):
        picture.draw(left, placed(drawn[name][1]), colour)
    return np.concatenate([left, np.ones_like(left), np.ones_like(left)], axis=1)


def show(folder, drawn):
    """Weights and curves with the mesh's edges at rest; the region dragged, or where that was refused profiled, with its edges."""
    (view, placed), images = window(drawn["boundary"][2], drawn), []
    rest = saved.read(folder / "region.vtp")
    grey = np.tile(picture.GREY, (len(rest.points), 1))
    weight = rest.point["EditWeight"].astype(float)[:, None]
    images.append(wired(view, rest, np.where(rest.point["EditRegion"][:, None] == 2, 0.55 * grey + 0.45 * np.array(picture.ORANGE), grey)
                        * (0.75 + 0.25 * weight)))
    for name, colour in (("reference", picture.RED), ("boundary", picture.BLUE)):
        picture.draw(images[0], placed(drawn[name][1]), colour)
    for name in ("dragged", "profiled"):
        if (folder / f"{name}.vtp").is_file():
            mesh = saved.read(folder / f"{name}.vtp")
            images.append(wired(view, mesh, np.tile(picture.GREY, (len(mesh.points), 1))))
    images += [np.ones_like(images[0])] * (3 - len(images))
    return np.concatenate(images, axis=1)


def wired(view, mesh, colours):
    """Shaded, with what is seen of the edges."""
    triangles = mesh.triangles
    xy, _ = view.display(mesh.points)
    shown = ((xy[triangles].max(1) > 0) & (xy[triangles].min(1) < (view.width, view.height))).all(1)
    return picture.shaded(view, mesh.points, triangles[shown], colours, scale=1, wire=0.45)


def enough(results):
    """Of one mode: as many regions stand as are asked for, and of those nearly all reach all bounds."""
    mode = "published" if any(r.get("published") for r in results.values()) else "default"
    for name, shares in STANDS.items():
        known = [r[name] for r in results.values() if name in r]
        if known and np.mean(known) < shares[mode]:
            return False
    made = [r["holds"] for r in results.values() if any(r.get(name) for name in STANDS)]
    return not any("crash or hang" in r["fails"] for r in results.values()) and bool(made) and np.mean(made) >= frame.REQUIRED


ACCEPTANCE = frame.Run(
    script=__file__,
    title="Acceptance: a line, a ring, and what lies between",
    units="Lengths are mean edges of the input, but px; angles degrees. published bounds in brackets; coarse: up to 2,000 triangles; patch: "
          "vertices that the ring encloses. px: root mean square off the strokes, where curves are seen; share: mean of the weight less that of "
          "d / (d + e); spread: p95 / p5 of the shares of surface and disc, plain: of a plain map; recut: what was drawn to where its plane "
          "cuts the result, worst of a straight line, mean of an S or arc; angle: of the dragged region, p5, off: without new triangles. As "
          "published each sample of a ring becomes a vertex: one that lands on another limb cuts triangles beyond the ring, where no point moves.",
    modes={"default": "default", "published": "as published"},
    usual=("default", "published"),
    counting=("default", "published"),
    bounds={
        "stands": "regions that stand ≥ 83 % [55 %]", "sphere stands": "on a sphere all", "tip stands": "round tips ≥ 45 % [errors]",
        "half stands": "half beside a sphere all [8 of 12]",
        "region": "region: what the ring encloses, and nothing else moved", "disc": "and that is a disc", "curves": "curves simple, mesh edges",
        "sound": "Euler number, two triangles an edge, a vertex a place", "flips": "no flip on the disc",
        "curve angle": "angles at the curves, p5 ≥ 12, coarse 9", "px": "rms off the stroke ≤ 1.2 px",
        "worst px": "worst off the stroke ≤ 4 px, coarse 7", "covered": "line and ring are as long as they were drawn, the ring on the line's limb",
        "line slope": "slope jump at the line ≤ 1.1, patch ≥ 4,000 ≤ 0.4 [≥ 1.8], patch ≥ 1,000",
        "ring slope": "slope jump at the ring ≤ 0.3, patch ≥ 4,000 ≤ 0.15 [≥ 0.85], patch ≥ 1,000",
        "ends": "weight 1 on the line, 0 outside", "share": "weights go by the way from line to ring, 0.06 in the mean",
        "tau step": "τ step ≤ 0.4, patch ≥ 1,000", "spread": "disc: a fifth of the plain spread where that is over 30",
        "recut": "recut ≤ 0.15 straight, 0.4 S and arc, 0.8 on a limb [0.25, 1.1]", "drag": "the line goes as far as it is moved",
        "folds": "drag by a half width: folds ≤ 2 % of edges", "angle": "angles p5 ≥ 24, coarse 19", "dihedral": "dihedral p95 falls",
        "turned": "turns by a share of the angle, not along a chord", "kept": "triangles that the edit leaves stay",
        "far": "beyond the ring and two edges bit-identical", "as it was": "zero amounts, same profile, black weights: the input",
    },
    columns=("triangles", "patch", "half width", "curve angle", "px", "worst px", "covered", "line slope", "ring slope", "share", "tau step",
             "plain spread", "spread", "recut mean", "recut worst", "folds", "angle", "angle off", "dihedral", "dihedral off", "faces", "kept"),
    make=lambda folder, day: rings.make_all(folder, rings.of_the_day(day)),
    one=run,
    enough=enough,
    sheet=(1, 6),
)

if __name__ == "__main__":
    sys.exit(frame.main(ACCEPTANCE, __doc__))
