"""Textures and colours: what comes in with a mesh goes out with it, to the bit, and what cannot is named."""
import base64
import json
import re
import struct

import numpy
import pytest
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkBMPWriter, vtkJPEGReader, vtkJPEGWriter, vtkPNGReader, vtkPNGWriter, vtkTIFFWriter

from scene import *  # noqa: F403


def picture(path, seed=1):
    """A picture of random pixels as a PNG or JPEG file; its bytes."""
    image = vtkImageData()
    image.SetDimensions(16, 8, 1)
    pixels = numpy.random.default_rng(seed).integers(0, 256, (16 * 8, 3), dtype=numpy.uint8)
    array = numpy_to_vtk(pixels, deep=True)
    array.SetName("pixels")
    image.GetPointData().SetScalars(array)
    writer = vtkPNGWriter() if path.suffix == ".png" else vtkJPEGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()
    return path.read_bytes()


def pixels(path):
    reader = vtkPNGReader() if path.suffix == ".png" else vtkJPEGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())


def coordinates():
    """Of the body's points, v from the top, as glTF counts."""
    return vtk_to_numpy(body().GetPointData().GetTCoords())


def gltf(path, image, parts=1, images=None, **material):
    """The body as glTF, made here by hand: image is what goes into "images", or bytes for the buffer."""
    mesh = body()
    blocks = [points_of(mesh).astype(numpy.float32), coordinates(),
              numpy.hstack([vtk_to_numpy(mesh.GetPointData().GetArray("RGB")),
                            numpy.full((mesh.GetNumberOfPoints(), 1), 255, numpy.uint8)]),
              triangles_of(mesh).astype(numpy.uint32)]
    data, views = b"", []
    for block in [block.tobytes() for block in blocks] + ([image] if isinstance(image, bytes) else []):
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(block)})
        data += block + b"\0" * (-len(block) % 4)
    accessor = lambda view, kind, form, block, **more: dict(
        bufferView=view, componentType=kind, type=form, count=block.size if form == "SCALAR" else len(block), **more)
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(parts))}],
        "nodes": [{"mesh": i} for i in range(parts)],
        "accessors": [accessor(0, 5126, "VEC3", blocks[0], min=blocks[0].min(axis=0).tolist(), max=blocks[0].max(axis=0).tolist()),
                      accessor(1, 5126, "VEC2", blocks[1]), accessor(2, 5121, "VEC4", blocks[2], normalized=True),
                      accessor(3, 5125, "SCALAR", blocks[3])],
        "bufferViews": views, "textures": [{"source": 0}, {"source": 1}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}, **material} for i in range(2)],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "COLOR_0": 2}, "indices": 3, "material": i}]}
                   for i in range(parts)],
        "images": images or [{"bufferView": 4, "mimeType": "image/png" if image[:1] == b"\x89" else "image/jpeg"} if isinstance(image, bytes) else image] * 2,
        "buffers": [{"byteLength": len(data)}]}
    if path.suffix == ".gltf":
        document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
        path.write_text(json.dumps(document))
    else:
        text = json.dumps(document).encode()
        text += b" " * (-len(text) % 4)
        path.write_bytes(b"glTF" + struct.pack("<II", 2, 12 + 8 + len(text) + 8 + len(data)) + struct.pack("<I", len(text))
                         + b"JSON" + text + struct.pack("<I", len(data)) + b"BIN\0" + data)
    return path


def taken_apart(path):
    """A glTF that was written: the document and its buffer."""
    data = path.read_bytes()
    if path.suffix == ".gltf":
        document = json.loads(data)
        return document, base64.b64decode(document["buffers"][0]["uri"].split(",")[1])
    length = struct.unpack("<I", data[12:16])[0]
    return json.loads(data[20:20 + length]), data[28 + length:]


def part(document, data, view):
    view = document["bufferViews"][view]
    return data[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]


def attribute(document, data, name, kind, components):
    number = document["meshes"][0]["primitives"][0]["attributes"][name]
    return numpy.frombuffer(part(document, data, document["accessors"][number]["bufferView"]), kind).reshape(-1, components)


@pytest.fixture
def longer(tmp_path):
    return write(stroke(outline(1.7)), tmp_path / "longer.vtp")


def drawn(source, longer, out):
    done = run("one-stroke", source, longer, "-o", out, *QUICK)
    assert done.returncode == 0, done.stderr
    return done.stderr


@pytest.mark.parametrize("out", ["out.glb", "out.gltf"])
@pytest.mark.parametrize("source", ["in.glb", "in.gltf"])
@pytest.mark.parametrize("kind", [".png", ".jpg"])
def test_gltf_keeps_texture_coordinates_and_colours(tmp_path, longer, source, out, kind):
    image = picture(tmp_path / ("skin" + kind))
    notes = drawn(gltf(tmp_path / source, image), longer, tmp_path / out)
    assert "not kept" not in notes and "does not keep" not in notes, notes
    document, data = taken_apart(tmp_path / out)
    material = document["materials"][document["meshes"][0]["primitives"][0]["material"]]
    texture = document["textures"][material["pbrMetallicRoughness"]["baseColorTexture"]["index"]]
    stored = document["images"][texture["source"]]
    assert stored["mimeType"] == ("image/png" if kind == ".png" else "image/jpeg")
    again = tmp_path / ("again" + kind)
    again.write_bytes(part(document, data, stored["bufferView"]))
    assert (pixels(again) == pixels(tmp_path / ("skin" + kind))).all() and again.read_bytes() == image
    assert numpy.abs(attribute(document, data, "TEXCOORD_0", numpy.float32, 2) - coordinates()).max() < 1e-6
    colours = attribute(document, data, "COLOR_0", numpy.uint8, 4)
    assert (colours[:, :3] == vtk_to_numpy(body().GetPointData().GetArray("RGB"))).all() and (colours[:, 3] == 255).all()
    moved = attribute(document, data, "POSITION", numpy.float32, 3)
    assert moved[:, 0].max() == pytest.approx(2.5, abs=0.05)


@pytest.mark.parametrize("how", ["a file beside it", "one with a space in its name", "in the text"])
def test_gltf_names_its_picture(tmp_path, longer, how):
    image = picture(tmp_path / ("my skin.png" if "space" in how else "skin.png"))
    uri = {"a file beside it": "skin.png", "one with a space in its name": "my%20skin.png"}.get(
        how, "data:image/png;base64," + base64.b64encode(image).decode())
    notes = drawn(gltf(tmp_path / "in.gltf", {"uri": uri}), longer, tmp_path / "out.glb")
    assert "not kept" not in notes
    document, data = taken_apart(tmp_path / "out.glb")
    assert part(document, data, document["images"][0]["bufferView"]) == image


def test_what_gltf_holds_besides_is_named(tmp_path, longer):
    image = picture(tmp_path / "skin.png")
    source = gltf(tmp_path / "in.glb", image, normalTexture={"index": 0}, doubleSided=True)
    said = drawn(source, longer, tmp_path / "out.glb")
    assert f"{source}: not kept: that its faces are seen from both sides, the pictures of small bumps (normal maps)\n" in said


def test_primitives_with_pictures_of_their_own_become_parts(tmp_path, longer):
    image = picture(tmp_path / "skin.png")
    pictures = [picture(tmp_path / f"{i}.png", i) for i in range(2)]
    two = [{"uri": "data:image/png;base64," + base64.b64encode(one).decode()} for one in pictures]
    source = gltf(tmp_path / "in.glb", image, parts=2, images=two)
    notes = run("one-stroke", source, longer, "-o", tmp_path / "out.glb", *QUICK).stderr
    assert "2 parts" in notes and "baseColorTexture" not in notes
    document, data = taken_apart(tmp_path / "out.glb")
    assert [part(document, data, one["bufferView"]) for one in document["images"]] == pictures


@pytest.mark.parametrize("kind, damage", [(kind, damage) for kind in (".png", ".jpg")
                                          for damage in ("cut", "flipped", "text", "absent")
                                          if (kind, damage) != (".jpg", "flipped")])  # a JPEG has no sums
def test_pictures_that_cannot_be_read_are_named(tmp_path, longer, kind, damage):
    image = picture(tmp_path / ("skin" + kind))
    name = "bad" + kind
    flipped = bytearray(image)
    flipped[len(image) // 2] ^= 255
    content = {"cut": image[:len(image) // 3], "flipped": bytes(flipped), "text": b"no picture"}
    if damage in content:
        (tmp_path / name).write_bytes(content[damage])
    source = gltf(tmp_path / "in.gltf", {"uri": name})
    message = refuse(1, "one-stroke", source, longer, "-o", tmp_path / "out.glb", *QUICK)
    assert "in.gltf: its picture " + name in message and not (tmp_path / "out.glb").exists()


def test_through_every_format_and_back(tmp_path, longer):
    image = picture(tmp_path / "skin.png")
    source = gltf(tmp_path / "in.glb", image)
    for name in ("a.vtp", "b.obj", "c.ply", "d.glb"):
        notes = drawn(source, longer, tmp_path / name)
        assert ("does not keep: materials\n" in notes) == (name == "c.ply")  # the OBJ's names of them
        assert notes.count("does not keep") == (name == "c.ply") and "not kept" not in notes
        source = tmp_path / name
    document, data = taken_apart(source)
    assert part(document, data, document["images"][0]["bufferView"]) == image
    assert (tmp_path / "b.png").read_bytes() == image and "map_Kd b.png" in (tmp_path / "b.mtl").read_text()
    assert numpy.abs(attribute(document, data, "TEXCOORD_0", numpy.float32, 2) - coordinates()).max() < 1e-6


@pytest.mark.parametrize("extension, dropped", [("stl", "colours, texture coordinates, the picture"), ("off", "the picture")])
def test_formats_without_pictures_say_so(tmp_path, longer, extension, dropped):
    source = gltf(tmp_path / "in.glb", picture(tmp_path / "skin.png"))
    notes = drawn(source, longer, tmp_path / f"out.{extension}")
    assert notes == f"oversketch: note: {extension.upper()} does not keep: {dropped}\n"


def test_ply_keeps_its_picture_beside_it(tmp_path, longer):
    image = picture(tmp_path / "skin.png")
    assert "PLY keeps the texture beside it, in out.png" in drawn(gltf(tmp_path / "in.glb", image), longer, tmp_path / "out.ply")
    assert (tmp_path / "out.png").read_bytes() == image
    assert b"\ncomment TextureFile out.png\n" in (tmp_path / "out.ply").read_bytes()
    drawn(tmp_path / "out.ply", longer, tmp_path / "again.glb")
    document, data = taken_apart(tmp_path / "again.glb")
    assert part(document, data, document["images"][0]["bufferView"]) == image
    assert numpy.abs(attribute(document, data, "TEXCOORD_0", numpy.float32, 2) - coordinates()).max() < 1e-6


def test_an_obj_replaces_no_file_that_is_not_its_own(tmp_path, longer):
    source = gltf(tmp_path / "in.glb", picture(tmp_path / "skin.png"))
    (tmp_path / "out.png").write_text("a holiday")
    done = run("one-stroke", source, longer, "-o", tmp_path / "out.obj", *QUICK)
    assert done.returncode == 1 and "out.png" in done.stderr
    assert (tmp_path / "out.png").read_text() == "a holiday"
    assert not (tmp_path / "out.obj").exists() and not (tmp_path / "out.mtl").exists()


def obj(path, materials, library):
    """The body as OBJ, its triangles in turn of these materials."""
    mesh = body()
    lines = ["mtllib skin.mtl"] + ["v %.17g %.17g %.17g" % tuple(p) for p in points_of(mesh)]
    lines += ["vt %.9g %.9g" % tuple(t) for t in coordinates()]
    triangles = triangles_of(mesh)
    for i, name in enumerate(materials):
        lines.append("usemtl " + name)
        lines += ["f " + " ".join(f"{v + 1}/{v + 1}" for v in t) for t in triangles[i::len(materials)]]
    path.write_text("\n".join(lines) + "\n")
    (path.parent / "skin.mtl").write_text(library)
    return path


def test_obj_brings_its_picture(tmp_path, longer):
    image = picture(tmp_path / "my skin.png")
    library = "newmtl fur\nmap_Kd -s 1 1 1 -clamp off my skin.png\nnewmtl nose\nmap_Kd my skin.png\n"
    notes = drawn(obj(tmp_path / "in.obj", ["fur", "nose"], library), longer, tmp_path / "out.glb")
    assert "map_Kd" not in notes
    document, data = taken_apart(tmp_path / "out.glb")
    assert part(document, data, document["images"][0]["bufferView"]) == image


def test_materials_with_pictures_of_their_own_become_parts(tmp_path, longer):
    image, other = picture(tmp_path / "skin.png"), picture(tmp_path / "nose.png", seed=2)
    library = "newmtl fur\nmap_Kd skin.png\nnewmtl nose\nmap_Kd nose.png\nnewmtl claw\n"
    source = obj(tmp_path / "in.obj", ["fur", "nose", "claw"], library)
    assert "map_Kd" not in drawn(source, longer, tmp_path / "out.glb")
    document, data = taken_apart(tmp_path / "out.glb")
    assert [part(document, data, view["bufferView"]) for view in document["images"]] == [image, other]
    assert len(document["materials"]) == len(document["meshes"][0]["primitives"]) == 3
    # The same from the glTF file; of the library's names an OBJ keeps those.
    drawn(tmp_path / "out.glb", longer, tmp_path / "again.glb")
    again, data = taken_apart(tmp_path / "again.glb")
    assert [part(again, data, view["bufferView"]) for view in again["images"]] == [image, other]
    drawn(source, longer, tmp_path / "out.obj")
    assert {name for name, *_ in worn_in(tmp_path / "out.obj")} == {"fur", "nose", "claw"}


@pytest.mark.parametrize("library, note", [
    ("newmtl fur\nmap_Kd absent.png\nnewmtl nose\nmap_Kd absent.png\n", "absent.png is no PNG or JPEG"),
    ("", "skin.mtl cannot be read")])
def test_obj_says_what_it_cannot_bring(tmp_path, longer, library, note):
    picture(tmp_path / "skin.png")
    notes = drawn(obj(tmp_path / "in.obj", ["fur", "nose"], library), longer, tmp_path / "out.glb")
    assert note in notes
    assert "images" not in taken_apart(tmp_path / "out.glb")[0]


@pytest.mark.parametrize("coordinates_too", [True, False])
@pytest.mark.parametrize("materials", [["fur", "nose", "fur again"], ["nose"], [None, "nose"], []])
def test_every_face_keeps_its_material(tmp_path, longer, materials, coordinates_too):
    source = obj(tmp_path / "in.obj", [name or "" for name in materials] or [""], "newmtl fur\n")
    text = source.read_text().replace("usemtl \n", "")
    if not coordinates_too:
        text = "\n".join(re.sub(r"/\d+", "", line) for line in text.splitlines() if not line.startswith("vt")) + "\n"
    source.write_text(text)
    drawn(source, longer, tmp_path / "out.obj")
    worn = lambda path: [(name, corners) for name, *corners in worn_in(path)]
    assert worn(tmp_path / "out.obj") == [(name or ("NO_MATERIAL" if "nose" in text else None), corners)
                                          for name, corners in worn(source)]
    drawn(source, longer, tmp_path / "out.vtp")
    mesh = read(tmp_path / "out.vtp").GetPointData()
    assert (mesh.GetTCoords() is not None) == coordinates_too
    assert [mesh.GetArrayName(i) for i in range(mesh.GetNumberOfArrays()) if mesh.GetArray(i).GetNumberOfComponents() == 2] == (
        ["TCoords"] if coordinates_too else [])


def worn_in(path):
    """Of each face: its material's name, and the texture coordinates of its corners (none without)."""
    material, coordinates = None, []
    for line in path.read_text().splitlines():
        keyword, _, rest = line.partition(" ")
        if keyword == "usemtl":
            material = rest
        elif keyword == "vt":
            coordinates.append(tuple(numpy.float32(value) for value in rest.split()))
        elif keyword == "f":
            corners = [corner.split("/") for corner in rest.split()]
            yield material, *(coordinates[int(corner[1]) - 1] if len(corner) > 1 else None for corner in corners)


def test_new_triangles_wear_the_picture_too(tmp_path, longer):
    image = picture(tmp_path / "skin.png")
    done = run("one-stroke", gltf(tmp_path / "in.glb", image), longer, "-o", tmp_path / "out.glb", "--backend", "embree",
               "--remesh", "on")
    assert done.returncode == 0, done.stderr
    document, data = taken_apart(tmp_path / "out.glb")
    assert part(document, data, document["images"][0]["bufferView"]) == image
    assert len(attribute(document, data, "TEXCOORD_0", numpy.float32, 2)) > body().GetNumberOfPoints()


def drawn_over(path, orientation):
    """A picture whose quarters are red, green, blue and white, in a file whose rows lie as the Exif orientation says; as it is to be seen, it is 96 x 64."""
    seen = numpy.zeros((64, 96, 3), numpy.uint8)  # from the upper left
    seen[:32, :48], seen[:32, 48:], seen[32:, :48], seen[32:, 48:] = (220, 20, 20), (20, 220, 20), (20, 20, 220), (240, 240, 240)
    stored = {1: seen, 3: seen[::-1, ::-1], 6: numpy.rot90(seen), 8: numpy.rot90(seen, -1)}[orientation]
    image = vtkImageData()
    image.SetDimensions(stored.shape[1], stored.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(stored[::-1].reshape(-1, 3).copy(), deep=True))
    writer = {".jpg": vtkJPEGWriter, ".bmp": vtkBMPWriter, ".tif": vtkTIFFWriter, ".png": vtkPNGWriter}[path.suffix]()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()
    if path.suffix == ".jpg":
        exif = b"Exif\0\0MM\0*\0\0\0\x08" + struct.pack(">HHHIHHI", 1, 0x0112, 3, 1, orientation, 0, 0)
        data = path.read_bytes()
        path.write_bytes(data[:2] + b"\xff\xe1" + struct.pack(">H", len(exif) + 2) + exif + data[2:])
    return path


@pytest.mark.parametrize("name, orientation", [("a.jpg", 1), ("a.jpg", 3), ("a.jpg", 6), ("a.jpg", 8), ("a.bmp", 1), ("a.tif", 1), ("a.png", 1)])
def test_a_picture_is_drawn_over_and_worn_upright(tmp_path, name, orientation):
    """The canvas is as wide as the picture is seen, and what the model wears is seen so by programs that know nothing of Exif."""
    source = drawn_over(tmp_path / name, orientation)
    turn = numpy.linspace(0, 2 * numpy.pi, 60)
    line = numpy.column_stack([48 + 40 * numpy.cos(turn), 32 + 25 * numpy.sin(turn)])
    drawing = stroke(line)
    drawing.GetCellData().GetArray("ViewTransform").SetTuple(0, numpy.eye(4).ravel())
    flat = numpy.diag([2 / 96, 2 / 64, -0.1, 1.0])
    flat[:2, 3] = -1
    drawing.GetCellData().GetArray("ProjectionTransform").SetTuple(0, flat.ravel())
    drawing.GetCellData().GetArray("ViewportSize").SetTuple(0, (96, 64))
    write(drawing, tmp_path / "line.vtp")
    done = run("inflate", tmp_path / "line.vtp", "--image", source, "-o", tmp_path / "o.glb", "--levels", "1")
    assert done.returncode == 0, done.stderr
    document, data = taken_apart(tmp_path / "o.glb")
    kind = document["images"][0]["mimeType"]
    assert kind == ("image/jpeg" if name == "a.jpg" else "image/png")
    worn = tmp_path / ("worn.jpg" if kind == "image/jpeg" else "worn.png")
    worn.write_bytes(part(document, data, document["images"][0]["bufferView"]))
    shown = pixels(worn)
    assert len(shown) == 96 * 64
    shown = shown.reshape(64, 96, 3)[::-1].astype(int)
    for y, x, colour in ((8, 8, (220, 20, 20)), (8, 80, (20, 220, 20)), (56, 8, (20, 20, 220)), (56, 80, (240, 240, 240))):
        assert abs(shown[y, x] - colour).max() < 12, (y, x, shown[y, x])
    refused = refuse(1, "inflate", tmp_path / "line.vtp", "--image", tmp_path / "line.vtp", "-o", tmp_path / "p.glb")
    assert "no PNG, JPEG, WebP, BMP or TIFF picture" in refused
