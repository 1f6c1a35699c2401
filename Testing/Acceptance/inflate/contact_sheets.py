"""Contact sheets of inflated drawings, to be looked at: the fourteen outlines, drawn by a hand that wobbles by 1 px, and the six shipped
drawings; from the front, the side and three quarters, smooth-shaded without their picture, by default and as published.

    OVERSKETCH_COMMAND=build/release/bin/oversketch /usr/bin/python3 Testing/Acceptance/inflate/contact_sheets.py FOLDER [PART-OF-NAME ...]

FOLDER receives sheet-1.png, sheet-2.png, …: a row each, three views by default and three as published. Where there is no result its
place says why.
"""
import json
import os
import subprocess
import sys
import textwrap
from pathlib import Path

import numpy as np
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parent)]
import meshes  # noqa: E402
import outlines  # noqa: E402
import picture  # noqa: E402
import sheets  # noqa: E402
import stroke_files  # noqa: E402

SHIPPED = {"fish": [], "mug": [], "padlock": ["--extrude", "60"], "heron": ["--magnetic"], "leaf": ["--quads"], "figure": None}
VIEWS = ((0, 0, 1), (1, 0, 0), (0.75, 0.35, 0.6))
ROWS = 5  # a page
MODES = {"default": [], "as published": ["--as-published"]}


def figure(folder, published):
    """The parts of the shipped figure, by default or as published, as a file of the command."""
    parts = json.loads((meshes.DATA / "Drawings" / "figure.json").read_text())
    for part in parts["parts"]:
        for name in ("picture", "strokes"):
            part[name] = str(meshes.DATA / "Drawings" / part[name])
        part["parameters"] = {"as-published": True} if published else {}
    path = folder / f"figure-{int(published)}.json"
    path.write_text(json.dumps(parts))
    return path


def command(name, folder, mode):
    """What makes a mesh of an outline or a shipped drawing, but for where to."""
    if name == "figure":
        return ["assemble", str(figure(folder, mode != "default"))]
    if name in SHIPPED:
        drawing = meshes.DATA / "Drawings" / f"{name}.vtp"
        return ["inflate", str(drawing), "--image", str(drawing.with_suffix(".png")), *SHIPPED[name], *MODES[mode]]
    drawing = folder / f"{name}.vtp"
    stroke_files.write(outlines.drawing(name, 1, 0), drawing)
    return ["inflate", str(drawing), *MODES[mode]]


def views(name, folder, mode):
    """The three pictures of a mode, beside each other."""
    out = folder / f"{name}-{mode.replace(' ', '-')}.vtp"
    out.unlink(missing_ok=True)
    done = subprocess.run([os.environ["OVERSKETCH_COMMAND"], *command(name, folder, mode), "-o", str(out)], capture_output=True, text=True)
    if not out.is_file():
        image = np.ones((picture.HEIGHT, picture.WIDTH * len(VIEWS), 3))
        for line, text in enumerate(textwrap.wrap(done.stderr.strip(), 90)[:4]):
            picture.write_text(image, text, 200, picture.HEIGHT // 2 - 40 * line, 30)
    else:
        triangles = vtkTriangleFilter()
        triangles.SetInputData(meshes.read(out))
        triangles.Update()
        mesh = meshes.arrays(triangles.GetOutput())
        image = np.concatenate([picture.shaded(picture.View.looking(mesh[0], towards, (0, 1, 0), False, 0.9), *mesh, scale=1)
                                for towards in VIEWS], axis=1)
    picture.write_text(image, f"{name}, {mode}", 12, 12, 34)
    return picture.halve(image)


def main(folder, only):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    names = [*(outlines.OUTLINES if outlines.IMAGES.is_dir() else ()), *SHIPPED]
    rows = [np.concatenate([views(name, folder, mode) for mode in MODES], axis=1)
            for name in names if not only or any(part in name for part in only)]
    sheets.write(rows, folder / "sheet", 1, ROWS)


if __name__ == "__main__":
    if len(sys.argv) < 2 or "OVERSKETCH_COMMAND" not in os.environ:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
