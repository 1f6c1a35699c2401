"""A model of two parts in the Studio, by real mouse and keys: a picture is drawn over, a second one added, drawn over and put at its place by
the handles of its box, from the front and from aside; undone and redone, saved, killed, recovered: what it shows is what the command makes,
bit for bit."""
import os
import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(SOURCE / "Testing" / "Studio"), str(SOURCE / "Testing" / "Pictures"), str(SOURCE / "Applications" / "Command" / "Testing")]
from desk import until  # noqa: E402
from scene import is_skin  # noqa: E402
from sheet import Sheet, euler, places_of, recover, replayed, save, undone_and_redone  # noqa: E402
from sitting import digest, sitting  # noqa: E402, F401

BLUE, ORANGE = (77, 153, 255), (250, 158, 51)  # of the handles


def seen(sitting, colour):
    return places_of(sitting, "Model", colour)


def handles(sitting):
    """Where the depth's handle is, the box's upper right corner and its middle, seen from the front."""
    def both():
        box, depth = seen(sitting, BLUE), seen(sitting, ORANGE)
        return (box, depth) if len(box) > 100 and len(depth) > 40 else None
    box, depth = until(both, "the handles")
    low, high = box.min(axis=0), box.max(axis=0)
    return {"depth": depth.mean(axis=0), "corner": numpy.array([high[0] - 5, low[1] + 5]), "middle": 0.5 * (low + high)}


def part(sitting):
    """Box and depth of the second step."""
    place = sitting.session()["steps"][1]["part"]
    return numpy.array(place["box"]), place["depth"]


def pictures(mesh):
    """The bytes of each part's picture."""
    return [vtk_to_numpy(mesh.GetFieldData().GetArray(f"Part{i}.Texture")).tobytes() for i in range(2)]


def test_two_pictures_are_one_model(sitting, tmp_path):
    desk, body, head = sitting.desk, Sheet(sitting, "figure_body"), Sheet(sitting, "figure_head")
    body.open()
    body.draw(body.outline())
    alone = sitting.shows(1)

    # A second picture: nothing is drawn over it yet, and the model is as it was.
    desk.key("ctrl+shift+p")
    sitting.dialogue()
    desk.key("ctrl+a")
    desk.type(str(head.picture))
    desk.key("Return")
    assert sitting.shows(2) == alone
    sitting.alone()
    sitting.shot("second_picture")
    head.draw(head.outline())
    drawn = sitting.shows(2, other_than=alone)
    sitting.shot("two_parts")
    made = replayed(sitting.autosave(), tmp_path / "drawn.vtp")
    assert digest(made) == drawn and euler(made) == 4
    assert all(map(is_skin, pictures(made), (body.picture.read_bytes(), head.picture.read_bytes())))

    def pull(handle, by, shown):
        at = handles(sitting)[handle]
        desk.drag([at + numpy.array(by) * t for t in numpy.linspace(0.0, 1.0, 12)])
        return sitting.shows(2, other_than=shown)

    # Up, smaller, farther from the eye: each drag is one step of undo.
    (box, depth), digests = part(sitting), [drawn]
    digests.append(pull("middle", (0, -120), drawn))
    moved, same = part(sitting)
    assert same == depth and numpy.allclose(moved[[0, 2]], box[[0, 2]], atol=2.0) and moved[1] > box[1] + 20.0
    assert numpy.allclose(moved - box, [moved[0] - box[0], moved[1] - box[1]] * 2)
    digests.append(pull("corner", (-30, 30), digests[-1]))
    smaller, same = part(sitting)
    assert same == depth and numpy.array_equal(smaller[:2], moved[:2])
    share = (smaller - moved)[2:] / (moved[2:] - moved[:2])
    assert share[0] < -0.02 and abs(share[0] - share[1]) < 1e-9
    digests.append(pull("depth", (30, -30), digests[-1]))
    same, farther = part(sitting)
    assert farther < depth - 5.0 and numpy.array_equal(same, smaller)
    sitting.shot("placed_from_the_front")

    # From aside the depth is dragged along its own axis.
    front = handles(sitting)
    desk.drag([front["middle"] + (40 + 10 * i, 50) for i in range(16)])
    sitting.shot("turned")
    before = seen(sitting, ORANGE).mean(axis=0)
    toward = before - seen(sitting, BLUE).mean(axis=0)
    toward /= numpy.linalg.norm(toward)
    assert abs(toward - (front["depth"] - front["middle"]) / numpy.linalg.norm(front["depth"] - front["middle"])).max() > 0.2, "not turned"
    assert abs(toward[1]) < 0.5, "the axis does not lie across the screen"
    desk.drag([before + 4.0 * i * toward for i in range(12)])
    digests.append(sitting.shows(2, other_than=digests[-1]))
    same, nearer = part(sitting)
    assert nearer > farther + 5.0 and numpy.array_equal(same, smaller)
    sitting.shot("placed_from_aside")
    made = replayed(sitting.autosave(), tmp_path / "placed.vtp")
    assert digest(made) == digests[-1] and euler(made) == 4

    # Undone to the first place and redone.
    undone_and_redone(sitting, 2, digests)

    recover(sitting)
    assert sitting.shows(2) == digests[-1]

    sitting.alone()
    saved = tmp_path / "two.oversketch"
    save(sitting, saved)
    made = replayed(saved, tmp_path / "saved.vtp")
    assert digest(made) == digests[-1]
    assert all(map(is_skin, pictures(made), (body.picture.read_bytes(), head.picture.read_bytes())))
