#!/usr/bin/env python3
"""How long the hand waits: from a sample of the pen to its drawn pixel, and from the end of a stroke to the deformed mesh on screen, or,
over a picture, to the snapped line and the colours of the strokes' roles.

usage: pen_latency.py [STROKES]     (default 5 strokes on each model; needs a display, PYTHONPATH with the built package, a quiet machine)

Prints one row for each size of the shipped dog, each triangle split into four again and again, in a window of 800 x 600 px: median
and 99th percentile in ms, beside the time of a plain redraw. The stroke is the shipped dog_longer_leg. The mesh follows on the sizes up to
DEFORMED triangles; its first stroke, which computes the thickness, counts as well.

A second table has a row for each shipped drawing with a picture, in a window of 1024 x 768 px: every stroke of it is drawn magnetically
after those before it, and released; what is measured ends with the last pixel. In brackets time of the processor, all threads, which
another load of the machine hardly moves. To be reached: RELEASE ms in the median.
"""
import pathlib
import sys
import time

import numpy as np
import vtk

import oversketch

DATA = pathlib.Path(__file__).parents[2] / "Data"
DEFORMED = 200_000
RELEASE = 30.0  # ms


def milliseconds(window, work):
    """Of some work, up to the last pixel."""
    start = time.perf_counter()
    work()
    window.WaitForCompletion()
    return 1000.0 * (time.perf_counter() - start)


def both(window, work):
    """Of some work, up to the last pixel: (milliseconds, those of the processor)."""
    processor = time.process_time()
    return milliseconds(window, work), 1000.0 * (time.process_time() - processor)


def measure(splits, strokes):
    """{what: list of milliseconds} for the dog split that often, and its triangles."""
    reader, drawn, split = vtk.vtkPLYReader(), vtk.vtkXMLPolyDataReader(), vtk.vtkLinearSubdivisionFilter()
    reader.SetFileName(str(DATA / "Models" / "dog.ply"))
    drawn.SetFileName(str(DATA / "Strokes" / "dog_longer_leg.vtp"))
    drawn.Update()
    samples = [drawn.GetOutput().GetPoint(i)[:2] for i in range(drawn.GetOutput().GetNumberOfPoints())]
    split.SetInputConnection(reader.GetOutputPort())
    split.SetNumberOfSubdivisions(splits)
    split.Update()
    mesh = split.GetOutput() if splits else reader.GetOutput()

    mapper, actor, renderer = vtk.vtkPolyDataMapper(), vtk.vtkActor(), vtk.vtkRenderer()
    mapper.SetInputData(mesh)
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    window, interactor = vtk.vtkRenderWindow(), vtk.vtkRenderWindowInteractor()
    window.SetMultiSamples(0)
    window.SetSize(800, 600)
    window.AddRenderer(renderer)
    interactor.SetRenderWindow(window)
    camera = renderer.GetActiveCamera()  # the stroke's view
    camera.SetFocalPoint(0.05, 0.75, 0.0)
    camera.SetPosition(0.05, 0.75, 10.0)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(60.0 / 47.0)
    renderer.ResetCameraClippingRange()
    interactor.Initialize()
    window.Render()
    pen = oversketch.vtkOversketchStrokeWidget()
    pen.SetInteractor(interactor)
    pen.On()
    system = oversketch.vtkOversketchOneStroke()
    system.SetInputData(0, mesh)
    system.SetInputConnection(1, pen.GetOutputPort())

    times = {"redraw": [milliseconds(window, window.Render) for _ in range(5)], "pen down": [], "sample": [], "mesh": []}
    for _ in range(strokes):
        mapper.SetInputData(mesh)
        window.Render()
        times["pen down"].append(milliseconds(window, lambda: pen.BeginStroke(*samples[0])))
        times["sample"] += [milliseconds(window, lambda: pen.AddSample(*at)) for at in samples[1:]]
        if mesh.GetNumberOfPolys() > DEFORMED:
            pen.CancelStroke()
            continue

        def follow():
            pen.EndStroke()
            system.Update()
            mapper.SetInputData(system.GetOutput())
            window.Render()

        times["mesh"].append(milliseconds(window, follow))
        assert system.GetErrorCode() == 0
    return mesh.GetNumberOfPolys(), times


def release(picture, drawing, rounds):
    """From the pen's release to the roles on screen, [(milliseconds, those of the processor)], all strokes of the drawing; so many redraws."""
    reader, drawn = vtk.vtkPNGReader(), vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(picture))
    reader.Update()
    drawn.SetFileName(str(drawing))
    drawn.Update()
    canvas = oversketch.vtkOversketchCanvas()
    canvas.SetInputData(0, drawn.GetOutput())
    canvas.SetInputData(1, reader.GetOutput())
    curves = oversketch.update(canvas)
    renderer, window, interactor = vtk.vtkRenderer(), vtk.vtkRenderWindow(), vtk.vtkRenderWindowInteractor()
    window.SetMultiSamples(0)
    window.SetSize(1024, 768)
    window.AddRenderer(renderer)
    interactor.SetRenderWindow(window)
    sheet = oversketch.vtkOversketchDrawingWidget()
    sheet.SetInteractor(interactor)
    sheet.On()
    sheet.SetPicture(reader.GetOutput())
    interactor.Initialize()
    window.Render()

    def place(point):  # px of the window
        renderer.SetWorldPoint(*curves.GetPoint(point), 1.0)
        renderer.WorldToDisplay()
        return renderer.GetDisplayPoint()[:2]

    times, redraws = [], []
    for _ in range(rounds):
        sheet.SetDrawing(None)
        for cell in range(curves.GetNumberOfCells()):
            ids = curves.GetCell(cell).GetPointIds()
            samples = [place(ids.GetId(i)) for i in range(ids.GetNumberOfIds())]
            if curves.GetCellData().GetArray("Closed").GetTuple1(cell):
                samples.append(samples[0])
            interactor.EnableRenderOff()  # of the way there nothing is measured
            sheet.GetPen().BeginStroke(*samples[0])
            for at in samples[1:]:
                sheet.GetPen().AddSample(*at)
            interactor.EnableRenderOn()
            window.Render()
            redraws.append(both(window, window.Render))
            times.append(both(window, sheet.GetPen().EndStroke))  # the widget redraws
        roles = sheet.GetCurves().GetCellData().GetArray("Role")
        assert roles.GetNumberOfTuples() == curves.GetNumberOfCells() and roles.GetRange()[0] > 0, sheet.GetText()
    return times, redraws


def released(rounds):
    print("\n| drawing | strokes | redraw | release to roles: median, worst | to be reached |")
    print("|---|---|---|---|---|")
    for drawing in sorted((DATA / "Drawings").glob("*.vtp")):
        picture = drawing.with_suffix(".png")
        if not picture.exists():
            continue
        times, redraws = (np.array(column) for column in release(picture, drawing, rounds))
        (redraw, redraw_processor), (median, processor) = np.median(redraws, axis=0), np.median(times, axis=0)
        verdict = f"{RELEASE:.0f} ms" + ("" if median <= RELEASE else " **missed**")
        print(f"| {drawing.stem} | {len(times) // rounds} | {redraw:.1f} ({redraw_processor:.1f}) ms | "
              f"{median:.1f}, {times[:, 0].max():.1f} ({processor:.1f}, {times[:, 1].max():.1f}) ms | {verdict} |", flush=True)


def main():
    strokes = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    columns = ("redraw", "pen down", "sample", "mesh")
    print("| triangles | " + " | ".join(f"{name}: median, 99 %" for name in columns) + " |")
    print("|---" * (1 + len(columns)) + "|")
    for splits in range(4):
        triangles, times = measure(splits, strokes)
        cells = [
            f"{np.median(times[name]):.1f}, {np.percentile(times[name], 99):.1f} ms" if times[name] else "" for name in columns
        ]
        print(f"| {triangles:,} | " + " | ".join(cells) + " |", flush=True)
    released(strokes)


if __name__ == "__main__":
    main()
