"""Files that are damaged on purpose: each is refused with one message that names what is wrong in it, soon."""
import json
import os
import pathlib

import pytest

from scene import *  # noqa: F403

DATA = pathlib.Path(os.environ.get("OVERSKETCH_DATA") or SOURCE / ".." / "shared" / "data") / "hostile"
COLLECTED = {
    "index_100000000.ply": "face 2 names the vertex 100000000", "index_65536.ply": "face 2 names the vertex 65536",
    "vt_5000.obj": "line 9 names the texture coordinate 5000", "vt_9.obj": "line 9 names the texture coordinate 9",
    "vt_missing.obj": "names the texture coordinate 227", "off_1e40.off": "Point 88 of the mesh lies beyond",
    "count_1e9.gltf": "accessors 0: announces 1000000000", "cycle.gltf": "nodes 0 is its own ancestor",
    "image_fifo.gltf": "picture fifo.png", "indices_out_of_range.gltf": "99 of its accessors",
    "no_accessors.gltf": "1 of its accessors", "stroke_array_twice.vtp": "CellData holds two arrays ViewTransform",
    "stroke_sample_1e7.vtp": "px long", "stroke_view_1e308.vtp": "ViewTransform or ProjectionTransform",
    "refs_20000.oversketch": "'strokes' has 20000 entries"}


@pytest.mark.parametrize("name", COLLECTED)
def test_collected_files_are_refused(tmp_path, name):
    if not DATA.is_dir():
        pytest.skip(f"there is no folder {DATA}; set OVERSKETCH_DATA")
    for file in [*DATA.iterdir(), *(DATA / "base").iterdir()]:
        if file.is_file():
            (tmp_path / file.name).write_bytes(file.read_bytes())
    os.mkfifo(tmp_path / "fifo.png")
    if name.endswith(".oversketch"):
        arguments = ["replay", tmp_path / name]
    elif name.startswith("stroke"):
        arguments = ["one-stroke", tmp_path / "b.ply", tmp_path / name]
    else:
        arguments = ["one-stroke", tmp_path / name, tmp_path / ("s2.vtp" if name.endswith(".gltf") else "s.vtp")]
    assert COLLECTED[name] in refuse(1, *arguments, "-o", tmp_path / "out.ply", timeout=20)
    assert not (tmp_path / "out.ply").exists()


def test_a_name_cannot_steer_the_terminal(tmp_path):
    name = "\x1b[2J\x1b[31m\x9b2J.ply"
    done = run("one-stroke", tmp_path / name, tmp_path / "s.vtp", "-o", tmp_path / "out.ply")
    assert done.returncode == 1 and "there is no such file" in done.stderr
    assert not any(ord(c) < 32 and c != "\n" or 127 <= ord(c) < 160 for c in done.stderr)


PLY = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" \
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"


@pytest.mark.parametrize("name, text, says", [
    ("far.ply", PLY + "3 0 2 1\n3 0 1 4\n3 1 2 3\n3 0 3 2\n", "face 1 names the vertex 4, and there are 4"),
    ("minus.ply", PLY + "3 0 2 1\n3 0 1 -1\n3 1 2 3\n3 0 3 2\n", "face 1 names the vertex -1"),
    ("short.ply", PLY + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3\n", "ends before"),
    ("words.ply", PLY + "3 0 2 one\n3 0 1 3\n3 1 2 3\n3 0 3 2\n", "where a number should be"),
    ("twice.ply", PLY.replace("element face", "element vertex"), "the element 'vertex' twice"),
    ("list.ply", PLY + "4000000000 0 2 1\n", "ends before"),
    ("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4 names the vertex 4, and there are 3"),
    ("zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "line 4 names the vertex 0"),
    ("back.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n", "line 4 names the vertex -4"),
    ("normal.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//1\n", "line 4 names the normal 1, and there are 0"),
    ("deep.gltf", "[" * 100000, "is not glTF"),
    ("types.gltf", json.dumps({"nodes": 3, "scenes": "none", "meshes": {"primitives": 1}}), "damaged"),
    ("empty.gltf", json.dumps({"asset": {"version": "2.0"}}), "holds no mesh")])
def test_made_files_are_refused(tmp_path, name, text, says):
    (tmp_path / name).write_text(text)
    path = write(stroke(outline(1.7)), tmp_path / "longer.vtp")
    message = refuse(1, "one-stroke", tmp_path / name, path, "-o", tmp_path / "out.ply", timeout=20)
    assert name in message and says in message, message
