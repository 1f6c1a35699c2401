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
PROPERTIES = set(re.findall(r"PROPERTY\(\w+,\s*(\w*[a-z][A-Z]\w*)\)", (SOURCE / "Applications/Session/Scene/systems.cxx").read_text()))


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
    (["inflate", FISH, "--height", "1e13"], "no step takes coordinates beyond 1e+12"),
    (["augment", DOG, STROKES / "dog_curled_tail.vtp", "--height", "1e20"], "beyond 1e+12, the largest coordinate that is taken"),
    (["inflate", FISH, "--tunnel", "1 x"], '--tunnel is "1 x"; give numbers of strokes'),
    ([*EDIT, "--feather", "3", "--areas", DATA / "Edits" / "person_belly_area.vtp"], "--feather is not within 0 and 1"),
    ([*EDIT, "--move", "0.5,n,1000"], "make a smaller edit, or none of them anew (--rule off).")])
def test_messages_name_options(tmp_path, arguments, says):
    assert len(PROPERTIES) > 10
    message = refuse(1, *arguments, "-o", tmp_path / "out.ply", "--backend", "embree")
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


def test_a_stroke_that_cannot_be_used_is_said_to_be_the_lines_or_the_rings(tmp_path):
    void = write(stroke(numpy.array([(5.0, 5.0), (40.0, 8.0), (60.0, 20.0)])), tmp_path / "void.vtp")
    body_file = write(body(), tmp_path / "body.vtp")
    line = write(stroke(numpy.array([WIDTH / 3 - 10, HEIGHT / 2]) + numpy.column_stack([numpy.linspace(-18, 18, 30), numpy.zeros(30)])),
                 tmp_path / "line.vtp")
    for reference, boundary, whose in ((void, line, "reference"), (line, void, "boundary")):
        message = refuse(1, "edit", body_file, "--reference", reference, "--boundary", boundary, "-o", tmp_path / "o.vtp")
        assert f"Stroke 0 of the {whose} cannot be used: nothing of it lies on the mesh" in message


def test_several_strokes_where_one_deforms_are_counted(tmp_path):
    assert "holds 16 polylines, and one deforms the mesh: give them one after the other." in refuse(
        1, "one-stroke", DOG, FISH, "-o", tmp_path / "o.ply")


def test_a_name_that_is_none_is_bad_use(tmp_path):
    assert "one-stroke needs a stroke, and '' names no file" in refuse(2, "one-stroke", DOG, "", "-o", tmp_path / "o.ply")


def test_options_without_an_effect_are_told(tmp_path, crossing):
    done = run("inflate", crossing, "-o", tmp_path / "o.vtp", "--arrange", "--magnetic")
    assert done.returncode == 0
    assert done.stderr.splitlines() == ["oversketch: warning: --magnetic does nothing without --image"]
    done = run(*EDIT, "-o", tmp_path / "o.vtp", "--move", "0.5,n,2%", "--at", "0.3", "--use-texture", "--feather", "0.1")
    assert done.returncode == 0
    assert done.stderr.splitlines() == [f"oversketch: warning: --{option} does nothing without --{needs}" for option, needs in
                                        (("at", "profile"), ("use-texture", "profile"), ("feather", "areas"))]
