"""The camera in a real window: logs of events play, pictures are as they were."""
import os
import pathlib
import sys

import pytest

import oversketch

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path.insert(0, str(SOURCE / "Testing" / "Pictures"))
import compare  # noqa: E402
from window import Window  # noqa: E402


@pytest.mark.parametrize("log", ["camera_turn_model", "camera_views"])
def test_camera_picture(log):
    window = Window()
    window.play(log)
    if not compare.matches(window.picture(), log):
        return
    wrong = Window(colour=(0.2, 0.7, 0.3))
    wrong.play(log)
    assert compare.difference(wrong.picture(), compare.read(log)) > 10 * compare.LIMIT


def test_controls_picture():
    window = Window()
    controls = oversketch.vtkOversketchCameraWidget()
    controls.SetInteractor(window.interactor)
    controls.On()
    window.play("camera_controls")
    assert window.style.GetSpin() == pytest.approx(90.0)
    if compare.matches(window.picture(), "camera_controls"):
        controls.Off()
        window.window.Render()
        assert compare.difference(window.picture(), compare.read("camera_controls")) > 10 * compare.LIMIT


def test_key_list_comes_and_goes():
    window = Window()
    before = window.picture()
    window.style.ShowKeysOn()
    window.style.SetModeToDraw()
    window.window.Render()
    assert compare.difference(before, window.picture()) > 100 * compare.LIMIT  # a dark panel over most of the window
    window.style.ShowKeysOff()
    assert compare.difference(before, window.picture()) == 0
