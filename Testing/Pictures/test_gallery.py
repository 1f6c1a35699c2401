"""The gallery in Applications/Examples: each script runs and draws the picture that is kept, and the page is what the scripts say."""
import os
import pathlib
import sys

import pytest
from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkIOImage import vtkPNGReader

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(SOURCE / "Testing" / "Pictures"), str(SOURCE / "Applications" / "Examples")]
import compare  # noqa: E402
import gallery  # noqa: E402


def picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def middle(image):
    """A twentieth of its rows: pictures that differ everywhere take long to compare."""
    width, height, _ = image.GetDimensions()
    voi = vtkExtractVOI()
    voi.SetInputData(image)
    voi.SetVOI(0, width - 1, height // 2 - height // 40, height // 2 + height // 40, 0, 0)
    voi.Update()
    return voi.GetOutput()


@pytest.mark.parametrize("name", gallery.EXAMPLES)
def test_picture(name, tmp_path):
    gallery.draw(name, tmp_path / "drawn.png")
    drawn, kept = picture(tmp_path / "drawn.png"), picture(gallery.HERE / "Pictures" / (name + ".png"))
    assert drawn.GetDimensions() == kept.GetDimensions()
    assert compare.difference(drawn, kept) < compare.LIMIT
    # The comparison can fail: without colours it does.
    grey = middle(drawn)
    pixels = grey.GetPointData().GetScalars()
    for component in (0, 1, 2):
        pixels.FillComponent(component, 128)
    assert compare.difference(grey, middle(kept)) > 10 * compare.LIMIT


def test_page():
    assert (gallery.HERE / "README.md").read_text() == gallery.page()


def test_every_script_is_in_it():
    scripts = {path.stem for path in gallery.HERE.glob("*.py")} - {"gallery", "sheet", "edited", "grown", "inflated"}
    assert scripts == set(gallery.EXAMPLES)
