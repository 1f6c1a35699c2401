"""What is said of wrong uses: in the command's own words, on the file that is wrong, and nothing is silent."""
import json
import re

import numpy
import pytest
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

from scene import *  # noqa: F403

DATA = SOURCE / "Data"
DOG, STROKES, FISH = DATA / "Models" / "dog.ply", DATA / "Strokes", DATA / "Drawings" / "fish.vtp"
EDIT = ["edit", DOG, "--reference", STROKES / "dog_back.vtp", "--boundary", STROKES / "dog_back_ring.vtp"]
PROPERTIES = set(re.findall(r'parameter<System>\(\s*"(\w*[a-z][A-Z]\w*)"', (SOURCE / "Applications/Session/systems.cxx").read_text()))


def circle(x, y, radius):
    turn = numpy.linspace(0, 2 * numpy.pi, 100)
    return numpy.array([x, y]) + radius * numpy.column_stack([numpy.cos(turn), numpy.sin(turn)])


@pytest.fixture(scope="module")
def crossing(tmp_path_factory):
    """A drawing of two outlines that cross."""
    append = vtkAppendPolyData()
    append.SetOutputPointsPrecision(1)
    for x in (0.4, 0.6):
        append.AddInputData(stroke(circle(x * WIDTH, HEIGHT / 2, HEIGHT / 4)))
    append.Update()
    return write(append.GetOutput(), tmp_path_factory.mktemp("words") / "crossing.vtp")


@pytest.mark.parametrize("arguments, says", [
    (["one-stroke", DOG, STROKES / "dog_back_ring.vtp"], "or, if that is meant, give --allow-torn."),
    (["one-stroke", DOG, STROKES / "dog_curled_tail.vtp", "--candidate", "50"], "there is no number 50. Lower --candidate."),
    (["augment", DOG, STROKES / "dog_curled_tail.vtp", "--radius", "0"], "The --radius must be a positive number."),
    (["augment", DOG, STROKES / "dog_curled_tail.vtp", "--edge-length", "0.001%"],
     "longer edges (--edge-length) or a larger tolerance, a smaller --radius"),
    (["inflate", FISH, "--hole", "99"], "--hole names stroke 99, but there are"),
    (["inflate", FISH, "--tunnel", "1 x"], '--tunnel is "1 x"; give numbers of strokes'),
    ([*EDIT, "--feather", "3"], "--feather is not within 0 and 1"),
    ([*EDIT, "--move", "0.5,n,1000"], "make a smaller edit, or none of them anew (--rule off).")])
def test_messages_name_options(tmp_path, arguments, says):
    assert len(PROPERTIES) > 10
    message = refuse(1, *arguments, "-o", tmp_path / "out.ply")
    assert says in message
    assert not PROPERTIES & set(re.findall(r"\w+", message)), message


def test_crossing_strokes_are_told_how_they_may(tmp_path, crossing):
    assert "Or let strokes cross: give --arrange." in refuse(1, "inflate", crossing, "-o", tmp_path / "out.vtp")
    done = run("inflate", crossing, "-o", tmp_path / "out.vtp", "--arrange")
    assert done.returncode == 0 and done.stderr == "", done.stderr


def test_a_file_of_parts_is_told_its_members(tmp_path, crossing):
    def parts(**parameters):
        (tmp_path / "parts.json").write_text(json.dumps({"parts": [{"strokes": str(crossing), "parameters": parameters}]}))
        return ["assemble", tmp_path / "parts.json", "-o", tmp_path / "out.vtp"]

    assert "Or let strokes cross: set 'arrange' to true." in refuse(1, *parts())
    assert "part 0: 'hole' names stroke 9" in refuse(1, *parts(arrange=True, hole="9"))
    assert run(*parts(arrange=True)).returncode == 0
