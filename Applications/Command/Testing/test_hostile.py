"""Files that are damaged on purpose: each is refused with one message that names what is wrong in it, soon."""
import json
import os
import pathlib
import subprocess
import zipfile

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
    "stroke_sample_1e7.vtp": "farther beside the viewport", "stroke_view_1e308.vtp": "ViewTransform or ProjectionTransform",
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


def test_bytes_that_are_no_text_cannot_either(tmp_path):
    done = subprocess.run([COMMAND, "replay", os.fsencode(tmp_path) + b"/\x9b2J\xff\xe2\x80\xaegnp.oversketch", "-o",
                           tmp_path / "out.ply"], capture_output=True, timeout=60)
    assert done.returncode == 1 and b"there is no such file" in done.stderr
    assert not any(byte in done.stderr.replace(b"\n", b"") for byte in (b"\x9b", b"\xff", b"\xe2\x80\xae")), done.stderr


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
    ("nan.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 nan 0\nvertex 0 1 0\nendloop\nendfacet\n"
     "endsolid a\n", "triangle 0 has a corner that is not finite"),
    ("two.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid a\n",
     "the triangle before line 7 has not three corners"),
    ("short.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n",
     "ends without endsolid"),
    ("far.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "face 0 names the point 3, and there are 3"),
    ("many.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", "announces 4000000000"),
    ("word.off", "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", "holds 'x' where a number should be"),
    ("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "line 4 has a face of 2 corners"),
    ("word.obj", "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", "line 2 ends where a number should be"),
    ("types.vtp", "<VTKFile type='ImageData'/>", "is not an XML PolyData file"),
    ("broken.vtp", "<VTKFile type='PolyData'>\n<PolyData><Piece</VTKFile>", "is no XML from line 2"),
    ("doctype.vtp", "<!DOCTYPE a [<!ENTITY a 'b'>]><VTKFile type='PolyData'/>", "has a document type"),
    ("deep.gltf", "[" * 100000, "is not glTF"),
    ("types.gltf", json.dumps({"nodes": 3, "scenes": "none", "meshes": {"primitives": 1}}), "damaged"),
    ("empty.gltf", json.dumps({"asset": {"version": "2.0"}}), "holds no mesh")])
def test_made_files_are_refused(tmp_path, name, text, says):
    (tmp_path / name).write_text(text)
    path = write(stroke(outline(1.7)), tmp_path / "longer.vtp")
    message = refuse(1, "one-stroke", tmp_path / name, path, "-o", tmp_path / "out.ply", timeout=20)
    assert name in message and says in message, message


def zipped(path, document, entries):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        for name, content in {"session.json": json.dumps(document), **entries}.items():
            file.writestr(name, content)
    return path


def document(strokes):
    return {"format": "oversketch-session", "format_version": 1, "mesh": "m", "mesh_name": "a", "backend": "embree", "result_md5": "",
            "made_by": dict.fromkeys(("version", "backend", "device", "processor"), ""), "strokes": strokes}


def test_entries_are_parsed_once_and_those_without_a_name_not_at_all(tmp_path):
    mesh = write(body(), tmp_path / "m.vtp").read_bytes()
    drawn = write(stroke(outline(1.7)), tmp_path / "s.vtp").read_bytes()
    one = {"name": "a", "stroke": "s", "on": False, "remesh": "off", "adjust_normals": False, "as_published": False}
    path = zipped(tmp_path / "same.oversketch", document([one] * 9000), {"m": mesh, "s": drawn, "unnamed": b"\0" * 300_000_000})
    done = run("replay", path, "-o", tmp_path / "out.ply", timeout=20)  # 9000 strokes parsed one by one take longer
    assert done.returncode == 0, done.stderr
    assert read(tmp_path / "out.ply").GetNumberOfPoints() == body().GetNumberOfPoints()
    path = zipped(tmp_path / "large.oversketch", document([one]), {"m": mesh, "s": b"\0" * 300_000_000})
    assert "holds more than a file of its size can" in refuse(1, "replay", path, "-o", tmp_path / "o.ply", timeout=20)


def test_a_library_or_picture_that_is_no_file_is_not_waited_for(tmp_path):
    os.mkfifo(tmp_path / "a.mtl")
    (tmp_path / "b.mtl").write_text("newmtl b\nmap_Kd a.mtl\n")
    lines = ["mtllib a.mtl", "mtllib b.mtl", "usemtl b"] + ["v %.17g %.17g %.17g" % tuple(p) for p in points_of(body())]
    lines += ["vt 0 0"] + ["f " + " ".join(f"{v + 1}/1" for v in t) for t in triangles_of(body())]
    (tmp_path / "in.obj").write_text("\n".join(lines) + "\n")
    drawn = write(stroke(outline(1.7)), tmp_path / "s.vtp")
    done = run("one-stroke", tmp_path / "in.obj", drawn, "-o", tmp_path / "out.vtp", *QUICK, timeout=60)
    assert done.returncode == 0, done.stderr
    assert "the material library a.mtl cannot be read" in done.stderr and "the picture a.mtl is no PNG or JPEG" in done.stderr


@pytest.mark.parametrize("arguments, says", [
    (("one-stroke", "m.ply", "s.vtp", "--candidate", "0"), "--candidate cannot be 0; the nearest that it takes is 1"),
    (("one-stroke", "m.ply", "s.vtp", "--reach", "3"), "--reach cannot be 3; the nearest that it takes is 1"),
    (("edit", "m.ply", "--reference", "r.vtp", "--boundary", "b.vtp", "--at", "-0.5"), "the nearest that it takes is 0"),
    (("edit", "m.ply", "--reference", "r.vtp", "--boundary", "b.vtp", "--levels", "1"), "the nearest that it takes is 2"),
    (("inflate", "d.vtp", "--extrude", "-3"), "--extrude cannot be -3; the nearest that it takes is 0")])
def test_numbers_that_no_step_can_take_are_refused(tmp_path, arguments, says):
    assert says in refuse(2, *arguments, "-o", tmp_path / "out.ply")
