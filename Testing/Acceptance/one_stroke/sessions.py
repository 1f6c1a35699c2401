"""Pictures of saved sessions: what the published method makes of the stroke, and what ours does.

usage: xvfb-run -a sessions.py FOLDER [SESSION...]   the sessions of the shared data unless some are named

Writes FOLDER/NAME.png, the two side by side, and prints what was said of each stroke. Sessions are of one stroke on one model.
"""
import json
import os
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

COMMAND = os.environ["OVERSKETCH_COMMAND"]
DATA = Path(os.environ.get("OVERSKETCH_DATA", Path(__file__).resolve().parents[4] / "shared/data"))


def run(mesh, stroke, out, *options):
    """A picture of the result, of the model where the stroke is refused; and what was said."""
    picture = out.with_suffix(".png")
    done = subprocess.run([COMMAND, "one-stroke", mesh, stroke, "-o", out, "--picture", picture, *options], capture_output=True, text=True)
    return picture if done.returncode == 0 else None, done.stderr.strip()


def beside(pictures, path):
    append = vtkImageAppend()
    readers = []
    for picture in pictures:
        reader = vtkPNGReader()
        reader.SetFileName(str(picture))
        readers.append(reader)
        append.AddInputConnection(reader.GetOutputPort())
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(append.GetOutputPort())
    writer.Write()


def show(session, folder):
    with zipfile.ZipFile(session) as package, tempfile.TemporaryDirectory() as place:
        package.extractall(place)
        place = Path(place)
        told = json.loads((place / "session.json").read_text())
        mesh, stroke = place / told["mesh"], place / told["strokes"][-1]["stroke"]
        as_published, _ = run(mesh, stroke, place / "published.ply", "--as-published")
        ours, said = run(mesh, stroke, place / "ours.ply")
        pictures = [picture for picture in (as_published, ours) if picture]
        if pictures:
            beside(pictures, folder / f"{session.stem}.png")
        print(f"{session.stem}: {said.splitlines()[-1] if said else 'as drawn'}{'' if ours else ' (refused)'}")


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for session in [Path(name) for name in sys.argv[2:]] or sorted((DATA / "sessions").glob("*.oversketch")):
        show(session, folder)


if __name__ == "__main__":
    main()
