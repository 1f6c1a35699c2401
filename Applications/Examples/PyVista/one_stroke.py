"""A leg drawn longer, in PyVista.

usage: one_stroke.py FOLDER      writes before.png, region.png and after.png there

The cells (# %%) run one by one in an editor that knows them; PyVista up to 0.46 runs on VTK 9.1 and later. Without a display run it
under xvfb-run -a.
"""
# %% The dog, and a camera beside it
import pathlib
import sys

import numpy
import pyvista

import oversketch

folder = pathlib.Path(sys.argv[1])
dog = pyvista.read(pathlib.Path(__file__).resolve().parents[3] / "Data" / "Models" / "dog.ply")


def plotter():
    shown = pyvista.Plotter(off_screen=True, window_size=(800, 600))
    shown.disable_anti_aliasing()
    shown.camera_position = [(0.05, 0.75, 10.0), (0.05, 0.75, 0.0), (0.0, 1.0, 0.0)]
    shown.camera.enable_parallel_projection()
    shown.camera.parallel_scale = 1.2766
    return shown


# %% A stroke in that camera's pixels, y up: down from the chest, round the paw, further down than it is, and up again
path = [(503, 239), (516, 217), (548, 168), (574, 115), (603, 85), (585, 69), (553, 88), (531, 138), (496, 186), (470, 218)]
pixels = pyvista.Spline([(x, y, 0.0) for x, y in path], 100).points[:, :2]
stroke = oversketch.stroke(pixels, plotter().camera, (800, 600))


def save(mesh, name, **look):
    """The mesh with the stroke over it, as a line in front of the model."""
    shown = plotter()
    shown.add_mesh(mesh, smooth_shading=True, **look)
    line = shown.camera.parallel_scale / 300 * (pixels - [400, 300]) + shown.camera.focal_point[:2]
    shown.add_mesh(pyvista.lines_from_points(numpy.column_stack([line, numpy.full(len(line), 3.0)])), color="crimson", line_width=4)
    shown.screenshot(folder / (name + ".png"))
    shown.close()


save(dog, "before", color="gainsboro")

# %% The system: the mesh and the stroke in, a mesh out
system = oversketch.vtkOversketchOneStroke()
system.SetInputData(dog)
system.SetStrokeData(stroke)
longer = pyvista.wrap(oversketch.update(system))
print(longer.n_points, "points, the paw", round(dog.bounds[2] - longer.bounds[2], 3), "lower than before")
save(longer, "after", color="gainsboro")

# %% The region that was meant by the stroke, and moved
region = pyvista.wrap(system.GetInnerOutput("RegionBorder"))
save(region, "region", scalars="Region", cmap=["gainsboro", "orange"], show_scalar_bar=False)
