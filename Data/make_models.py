#!/usr/bin/python3
"""Makes the models: Data/Models/<name>.ply from the implicit figures of figures.py.

    make_models.py [--only NAME] [--coarser FACTOR] [--to FOLDER]

Needs numpy and python3-vtk9. The same machine writes the same bytes each time; about a minute a model.
"""
import argparse
import os

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

import figures
import remesh


def polydata(points, triangles):
    mesh = vtk.vtkPolyData()
    place = vtk.vtkPoints()
    place.SetData(numpy_to_vtk(points.astype(np.float32), deep=True))
    mesh.SetPoints(place)
    cells = vtk.vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles, np.int64).ravel(), deep=True))
    mesh.SetPolys(cells)
    return mesh


def make(name, coarser=1.0):
    """The model as vtkPolyData; `coarser` scales its edge length."""
    figure, edge, finer = figures.FIGURES[name]
    triangulate = remesh.symmetric if name in figures.SYMMETRIC else remesh.even
    return polydata(*triangulate(figure(), coarser * edge, finer))


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description="Makes the models of Data/Models.")
    parser.add_argument("--only", choices=sorted(figures.FIGURES), help="make one model")
    parser.add_argument("--coarser", type=float, default=1.0, help="factor on the edge length")
    parser.add_argument("--to", default=os.path.join(here, "Models"), help="folder to write to")
    options = parser.parse_args()
    os.makedirs(options.to, exist_ok=True)
    for name in [options.only] if options.only else figures.FIGURES:
        mesh = make(name, options.coarser)
        writer = vtk.vtkPLYWriter()
        writer.SetFileName(os.path.join(options.to, name + ".ply"))
        writer.SetInputData(mesh)
        writer.SetFileTypeToBinary()
        writer.Write()
        print(f"{name}: {mesh.GetNumberOfPoints()} points, {mesh.GetNumberOfCells()} triangles")


if __name__ == "__main__":
    main()
