#!/usr/bin/python3
"""Draws the pictures of the guide: Guide/<work>_<stage>.jpg, of the works that are sessions under File > Examples.

    PYTHONPATH=build/release/lib/python3/dist-packages xvfb-run -a /usr/bin/python3 Documentation/make_guide.py [--only WORK] [--to FOLDER]

A stage is some of a session's steps. Its picture is the session with all later steps off, and in red what was drawn in it: over the model, of a
drawing over its picture, on the left.
"""
import argparse
import json
import pathlib
import tempfile
import zipfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkImageActor, vtkPolyDataMapper, vtkRenderer

import oversketch
from oversketch_web.strokes import Eye, laid, polylines
from oversketch_web.view import View

HERE = pathlib.Path(__file__).resolve().parent
WORKS = HERE.parent / "Data" / "Works"
SIZE, RED, PAD = (640, 480), (0.88, 0.08, 0.10), 0.42  # px; of lines; the width's share that a drawing's picture gets


class Stage:
    """The steps after those of the stage before, up to one; how far the eye goes round from the session's look [degrees]; whether lines are
    looked at closely; whether the model is seen without its pictures."""

    def __init__(self, last, right=0.0, up=0.0, close=None, clay=False):
        self.last, self.right, self.up, self.close, self.clay = last, right, up, close, clay


STAGES = {
    "creature": [Stage(1), Stage(5, 6, close=2.6), Stage(6, 10), Stage(7, 33, 62), Stage(8), Stage(9), Stage(10), Stage(14, -6, 6)],
    "figure": [Stage(1), Stage(2), Stage(3), Stage(4), Stage(5), Stage(8, -14, -2, close=2.2), Stage(9, -10, 4, clay=True), Stage(9, -10, 4)],
    "relief": [Stage(1, -18, 16), Stage(2, -18, 16), Stage(9, -18, 16), Stage(11, -18, 16), Stage(15, -18, 16), Stage(19, -18, 16)],
}


def red(courses):
    """Polylines of places as red lines."""
    append, mapper, actor = vtkAppendPolyData(), vtkPolyDataMapper(), vtkActor()
    for course in courses:
        points, cells, line = vtkPoints(), vtkCellArray(), vtkPolyData()
        points.SetData(numpy_to_vtk(np.ascontiguousarray(course), deep=True))
        cells.InsertNextCell(len(course), range(len(course)))
        line.SetPoints(points)
        line.SetLines(cells)
        append.AddInputData(line)
    mapper.SetInputConnection(append.GetOutputPort())
    actor.SetMapper(mapper)
    surface = actor.GetProperty()
    surface.SetColor(*RED)
    surface.LightingOff()
    surface.SetLineWidth(3.0)
    return actor


def pad(work, step, lines):
    """The picture that a drawing lies over, with its lines, as the left of a view."""
    with zipfile.ZipFile(WORKS / f"{work}.oversketch") as file, tempfile.TemporaryDirectory() as folder:
        steps = json.loads(file.read("session.json"))["steps"]
        entry = next(each for each in steps if each["id"] == step)["inputs"]["Picture"]["image"]
        reader = vtkPNGReader()
        reader.SetFileName(file.extract(entry, folder))
        reader.Update()
    renderer, picture = vtkRenderer(), vtkImageActor()
    picture.SetInputData(reader.GetOutput())
    renderer.AddActor(picture)
    renderer.AddActor(red(Eye(lines, k).world(course, 0.0) * (1, 1, 0) + (0, 0, 1) for k, course in enumerate(polylines(lines))))
    renderer.SetBackground(0.30, 0.31, 0.33)
    renderer.SetViewport(0.0, 0.0, PAD, 1.0)
    width, height, _ = reader.GetOutput().GetDimensions()
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    renderer.ResetCamera()
    camera.SetParallelScale(0.52 * max(height, width * SIZE[1] / (PAD * SIZE[0])))
    return renderer


def picture(session, work, stage, steps):
    """The session as it is, with the lines of these steps, as the bytes of a JPEG picture."""
    view, mesh = View(), session.GetMesh()
    view.resize(*SIZE)
    view.show([(session.GetPieceMesh(k), None if stage.clay else session.GetPiecePicture(k)) for k in range(session.GetNumberOfPieces())])
    courses = []
    for step in steps:
        for name in step["inputs"]:
            lines = session.GetStepInput(step["id"], name)
            if step["system"] == "InflateDrawing" and name == "Strokes":
                view.window.AddRenderer(pad(work, step["id"], lines))
                view.renderer.SetViewport(PAD, 0.0, 1.0, 1.0)
            elif name not in ("Picture", "Profile"):  # a profile is drawn in a plane of its own
                courses += laid(lines, mesh)
    session.GetLook(view.camera)
    view.camera.Azimuth(stage.right)
    view.camera.Elevation(stage.up)
    view.camera.OrthogonalizeViewUp()
    middle = np.mean(np.vstack(courses), axis=0) if stage.close else np.array(mesh.GetCenter())
    shape = SIZE[0] / SIZE[1] * (1.0 - view.renderer.GetViewport()[0])
    half = np.arctan(np.tan(np.radians(view.camera.GetViewAngle()) / 2.0) * min(1.0, shape))
    away = -0.5 * mesh.GetLength() / np.sin(half) * np.array(view.camera.GetDirectionOfProjection())  # all of it is seen
    view.camera.SetFocalPoint(*middle)
    view.camera.SetPosition(*(middle + away))
    view.camera.Zoom(stage.close or 1.15)
    if courses:  # a little before the surface that they lie on
        eye = np.array(view.camera.GetPosition())
        view.renderer.AddActor(red(course + 0.01 * (eye - course) for course in courses))
    return view.picture(False)


def pictures(work, only=None):
    """The number, from 1, and the picture of each stage of a work, or of that one alone."""
    session = oversketch.vtkOversketchSession()
    if not session.Open(str(WORKS / f"{work}.oversketch")):
        raise RuntimeError(session.GetMessage())
    steps, first = json.loads(session.GetSteps()), 0
    for number, stage in enumerate(STAGES[work], 1):
        if only in (None, number):
            for step in steps:
                session.SetStepOn(step["id"], step["id"] <= stage.last)
            if not session.Update():
                raise RuntimeError(session.GetMessage())
            yield number, picture(session, work, stage, [step for step in steps if first < step["id"] <= stage.last])
        first = stage.last


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", choices=STAGES)
    parser.add_argument("--to", type=pathlib.Path, default=HERE / "Guide")
    options = parser.parse_args()
    options.to.mkdir(exist_ok=True)
    for work in [options.only] if options.only else STAGES:
        for number, drawn in pictures(work):
            (options.to / f"{work}_{number}.jpg").write_bytes(drawn)
            print(work, number, len(drawn), "bytes", flush=True)


if __name__ == "__main__":
    main()
