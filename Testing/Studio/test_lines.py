"""Lines on a surface, drawn in the Studio by real mouse and keys, beside strokes over the outline: their width, height and profile are
changed, the program crashes, and what it shows is what the command makes of the same steps, bit for bit."""
import json
import os
import pathlib
import subprocess
import sys
import zipfile

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
sys.path[:0] = [str(SOURCE / "Testing" / "Studio"), str(SOURCE / "Testing" / "Pictures")]
from desk import until  # noqa: E402
from sitting import DOG, TAIL, digest, mesh, sitting  # noqa: E402, F401

# On the dog as it opens: along its flank, over its shoulder, and round a leg of it.
FLANK = [(300 + 4 * i, 345 + (i % 10) / 3) for i in range(31)]
SHOULDER = [(490 + i, 300 + 4 * i) for i in range(21)]
LEG = [(578 + 4.5 * i, 610 - 1.05 * i * i) for i in range(-10, 11)]


def values(sitting):
    """Of the last step."""
    return sitting.session()["steps"][-1]["values"]


def wheel(sitting, keys, up):
    sitting.desk.move(sitting.view.left + 700, sitting.view.top + 650)
    sitting.desk.hold(keys)
    sitting.desk.press(4 if up else 5)
    sitting.desk.release(4 if up else 5)
    sitting.desk.hold(keys, down=False)


def command(*arguments):
    done = subprocess.run([os.environ["OVERSKETCH_COMMAND"], *map(str, arguments)], env=dict(os.environ, OVERSKETCH_OPENCL="off"),
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done


def by_commands(folder, tmp_path):
    """The steps of a session, each by a command of its own."""
    document = json.loads((folder / "session.json").read_text())
    made = folder / document["mesh"]
    for i, step in enumerate(document["steps"]):
        given, out = next(iter(step["inputs"].values())), tmp_path / f"step{i}.vtp"
        words = {"Radius": "--radius", "Height": "--height", "Sharpness": "--sharpness", "Profile": "--profile",
                 "TargetEdgeLength": "--edge-length"}
        options = ["--adjust-normals"] if step["values"].get("AdjustNormals") else []
        for name, value in step["values"].items():
            if name in words and value != "":
                options += [words[name], value if isinstance(value, str) else repr(value)]
        command("augment" if step["system"] == "Augment" else "one-stroke", made, folder / given["lines"], "-o", out, *options)
        made = out
    return digest(mesh(made))


def test_a_line_is_shaped_and_outlives_a_crash(sitting, tmp_path):
    desk = sitting.desk
    sitting.start(DOG)
    first = sitting.shows(0)
    sitting.fit()
    sitting.alone()
    desk.key("b")
    sitting.draw(FLANK)
    drawn = sitting.shows(1)
    assert drawn != first
    before = values(sitting)
    assert before["Height"] > 0.0 and before["Radius"] > 0.0

    # Wheel with Shift: higher. With Ctrl: narrower. Either is one step of undo.
    wheel(sitting, "shift", up=True)
    high = sitting.shows(1, other_than=drawn)
    assert values(sitting)["Height"] > before["Height"] and values(sitting)["Radius"] == before["Radius"]
    wheel(sitting, "ctrl", up=False)
    narrow = sitting.shows(1, other_than=high)
    assert values(sitting)["Radius"] < before["Radius"]
    desk.key("ctrl+z")
    assert sitting.shows(1, other_than=narrow) == high
    desk.key("ctrl+z")
    assert sitting.shows(1, other_than=high) == drawn
    desk.key("ctrl+y")
    assert sitting.shows(1, other_than=drawn) == high

    # A point of the profile is dragged.
    curve = sitting.place("filler", "Profile across the line")
    middle, low = curve.left + curve.width // 2, curve.top + 10 + (curve.height - 20) * 2 // 3
    desk.drag([(middle, curve.top + 10 + i) for i in range(0, (low - curve.top - 10) // 2)])
    shaped = sitting.shows(1, other_than=high)
    assert values(sitting)["Profile"].startswith("0 0.")
    sitting.shot("profile")

    # Another line is cut short by a crash; the first one comes back as it was left, and the command makes the same.
    sitting.alone()
    desk.key("Return")
    sitting.draw(SHOULDER, release=False)
    sitting.studio.kill()
    desk.release()
    sitting.start()
    sitting.dialogue()
    desk.key("Return")
    assert sitting.shows(1) == shaped
    assert by_commands(sitting.autosave(), tmp_path) == shaped


def test_both_kinds_of_strokes_in_one_history(sitting, tmp_path):
    desk = sitting.desk
    sitting.start(DOG)
    sitting.shows(0)
    sitting.fit()
    sitting.alone()
    sitting.draw(LEG)
    sitting.shows(1)
    sitting.shot("longer_leg")
    for count, (key, line) in enumerate((("b", SHOULDER), ("d", TAIL), ("b", FLANK)), start=2):
        desk.move(sitting.view.left + 700, sitting.view.top + 650)
        desk.key("Return")
        desk.key(key)
        sitting.draw(line)
        before = sitting.shows(count)
    assert [step["system"] for step in sitting.session()["steps"]] == ["OneStroke", "Augment", "OneStroke", "Augment"]
    sitting.shot("both_kinds")

    # The first one is changed; what was drawn on it follows, with its lengths.
    lengths = [step["values"].get("Radius") for step in sitting.session()["steps"]]
    sitting.click("list", "Strokes")
    desk.key("Home")  # it may be scrolled away
    sitting.click("check box", "Details turn with the limb")
    after = sitting.shows(4, other_than=before)
    assert [step["values"].get("Radius") for step in sitting.session()["steps"]] == lengths

    # The window's mesh, the saved session replayed, and four commands: the same bits.
    saved = tmp_path / "chain.oversketch"
    desk.move(sitting.view.left + 700, sitting.view.top + 650)
    desk.key("ctrl+s")
    sitting.dialogue()
    desk.key("ctrl+a")
    desk.type(str(saved))
    desk.key("Return")
    until(saved.exists, "the file")
    replayed = tmp_path / "replayed.vtp"
    assert "not bit for bit" not in command("replay", saved, "-o", replayed).stderr
    assert digest(mesh(replayed)) == after
    with zipfile.ZipFile(saved) as file:
        file.extractall(tmp_path / "chain")
    assert by_commands(tmp_path / "chain", tmp_path) == after
