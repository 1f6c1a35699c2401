"""Pictures that a drawing may be over: of any size, depth and colour, and files that are none."""
import struct
import zlib

import numpy
import pytest

import oversketch
from scene import *  # noqa: F403

GREY, RGB, PALETTE, GREY_ALPHA, RGB_ALPHA = 0, 2, 3, 4, 6
CHANNELS = {GREY: 1, RGB: 3, PALETTE: 1, GREY_ALPHA: 2, RGB_ALPHA: 4}


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(columns, rows, depth=8, colour=RGB):
    """The bytes of a picture: a bright ellipse in its middle on dark ground."""
    y, x = numpy.mgrid[0:rows, 0:columns]
    inside = ((x - 0.5 * columns) / (0.3 * columns)) ** 2 + ((y - 0.5 * rows) / (0.3 * rows)) ** 2 < 1
    values = numpy.where(inside, 210, 30)
    if depth == 16:
        samples = (values * 257).astype(">u2").view(numpy.uint8).reshape(rows, columns, 2)
    elif depth == 8:
        samples = (inside.astype(numpy.uint8) if colour == PALETTE else values.astype(numpy.uint8)).reshape(rows, columns, 1)
    else:  # one bit
        samples = numpy.packbits(inside, axis=1)
    if depth >= 8:
        samples = numpy.repeat(samples[:, :, None, :], CHANNELS[colour], axis=2).reshape(rows, -1)
    lines = numpy.concatenate([numpy.zeros((rows, 1), numpy.uint8), samples.astype(numpy.uint8)], axis=1)
    parts = [chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, depth, colour, 0, 0, 0))]
    if colour == PALETTE:
        parts.append(chunk(b"PLTE", bytes([20, 60, 30, 220, 210, 120])))
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts) + chunk(b"IDAT", zlib.compress(lines.tobytes(), 1)) + chunk(b"IEND", b"")


def drawn(columns, rows, folder):
    """A drawing in the middle of a picture: an ellipse and a line in it."""
    angles = numpy.arange(160) * (2 * numpy.pi / 160)
    at = lambda share: numpy.column_stack([columns * (0.5 + share * numpy.cos(angles)), rows * (0.5 + share * numpy.sin(angles))])
    line = numpy.array([(0.45, 0.5), (0.5, 0.52), (0.55, 0.5)]) * (columns, rows)
    write(oversketch.drawing([at(0.32), line], (columns, rows), closed=[True, False]), folder / "drawing.vtp")
    return folder / "drawing.vtp"


@pytest.mark.parametrize("columns, rows, depth, colour", [
    (200, 160, 8, RGB), (200, 160, 16, RGB), (200, 160, 8, GREY), (200, 160, 16, GREY), (200, 160, 1, GREY), (200, 160, 8, PALETTE),
    (200, 160, 8, GREY_ALPHA), (200, 160, 8, RGB_ALPHA), (200, 160, 16, RGB_ALPHA), (1, 1, 8, RGB), (300, 300, 8, RGB)])
def test_pictures_of_any_kind(tmp_path, columns, rows, depth, colour):
    (tmp_path / "picture.png").write_bytes(png(columns, rows, depth, colour))
    drawing = drawn(columns, rows, tmp_path)
    done = run("inflate", drawing, "--image", tmp_path / "picture.png", "--magnetic", "-o", tmp_path / "made.vtp", "--levels", "2")
    assert done.returncode == 0, done.stderr
    mesh = read(tmp_path / "made.vtp")
    assert mesh.GetNumberOfPolys() > 100 and mesh.GetPointData().GetTCoords() is not None
    bounds = mesh.GetBounds()
    assert abs(bounds[1] - bounds[0] - 0.64 * columns) < 0.12 * columns and bounds[5] > 0


@pytest.mark.parametrize("columns, rows", [(400, 1), (1, 400), (16000, 8), (20000, 20), (4, 20000)])
def test_narrow_and_huge_pictures(tmp_path, columns, rows):
    """A model, or one message and no file."""
    (tmp_path / "picture.png").write_bytes(png(columns, rows))
    drawing = drawn(columns, rows, tmp_path)
    done = run("inflate", drawing, "--image", tmp_path / "picture.png", "--magnetic", "-o", tmp_path / "made.vtp", "--levels", "1")
    errors = [line for line in done.stderr.splitlines() if line.startswith("oversketch: ") and "arning" not in line]
    if done.returncode:
        assert len(errors) >= 1 and not (tmp_path / "made.vtp").exists(), done.stderr
        assert any(word in done.stderr for word in ("draw it", "draw a", "16384", "give")), done.stderr
    else:
        assert read(tmp_path / "made.vtp").GetNumberOfPolys() > 0


@pytest.mark.parametrize("what, words", [
    ("truncated", "icture"), ("header", "icture"), ("text", "no PNG, JPEG"), ("nothing", "is empty"), ("absent", "picture.png"), ("folder", "picture.png")])
def test_what_is_no_picture(tmp_path, what, words):
    path, whole = tmp_path / "picture.png", png(200, 160)
    if what == "folder":
        path.mkdir()
    elif what != "absent":
        path.write_bytes({"truncated": whole[:len(whole) // 2], "header": whole[:20], "text": b"no picture", "nothing": b""}[what])
    message = refuse(1, "inflate", drawn(200, 160, tmp_path), "--image", path, "--magnetic", "-o", tmp_path / "made.vtp")
    assert words in message and not (tmp_path / "made.vtp").exists(), message


def test_front_and_back_wear_pictures_of_their_own(tmp_path):
    front, back = png(200, 160), png(100, 80, colour=GREY)
    (tmp_path / "front.png").write_bytes(front)
    (tmp_path / "back.png").write_bytes(back)
    drawing = drawn(200, 160, tmp_path)
    for extension in ("vtp", "obj", "glb"):
        out = tmp_path / ("made." + extension)
        done = run("inflate", drawing, "--image", tmp_path / "front.png", "--back-image", tmp_path / "back.png", "-o", out, "--levels", "2")
        assert done.returncode == 0, done.stderr
    mesh = read(tmp_path / "made.vtp")
    fields = mesh.GetFieldData()
    worn = [vtk_to_numpy(fields.GetAbstractArray(f"Part{i}.Texture")).tobytes() for i in range(2)]
    assert is_skin(worn[0], front) and is_skin(worn[1], back) and worn[0] != worn[1]
    parts, sides = (vtk_to_numpy(mesh.GetCellData().GetArray(name)) for name in ("PartId", "Side"))
    assert ((parts == 1) == (sides == -1)).all() and 0 < parts.sum() < len(parts)
    pictures = {path.read_bytes() for path in tmp_path.glob("made*.png")}
    assert pictures == set(worn), "the OBJ's materials"
    assert all(picture in (tmp_path / "made.glb").read_bytes() for picture in worn)


def test_the_back_goes_on_from_the_rim(tmp_path):
    columns, rows = 200, 160
    y, x = numpy.mgrid[0:rows, 0:columns]
    eye = (x - 120) ** 2 + (y - 80) ** 2 < 100  # to the right of the middle, so that a mirrored one is elsewhere
    pixels = numpy.where(eye[..., None], (250, 20, 20), (60, 90, 160)).astype(numpy.uint8)
    pixels[x > 140] = (60, 160, 90)  # the tail
    lines = numpy.concatenate([numpy.zeros((rows, 1), numpy.uint8), pixels.reshape(rows, -1)], axis=1)
    header = struct.pack(">IIBBBBB", columns, rows, 8, RGB, 0, 0, 0)
    front = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines.tobytes())) + chunk(b"IEND", b"")
    (tmp_path / "front.png").write_bytes(front)
    drawing = drawn(columns, rows, tmp_path)
    call = ["inflate", drawing, "--image", tmp_path / "front.png", "--levels", "2", "--back-from-rim"]
    for extension in ("vtp", "glb"):
        done = run(*call, "-o", tmp_path / ("made." + extension))
        assert done.returncode == 0 and not done.stderr, done.stderr
    mesh = read(tmp_path / "made.vtp")
    worn = [vtk_to_numpy(mesh.GetFieldData().GetAbstractArray(f"Part{i}.Texture")).tobytes() for i in range(2)]
    assert is_skin(worn[0], front) and all(picture in (tmp_path / "made.glb").read_bytes() for picture in worn)
    parts, sides = (vtk_to_numpy(mesh.GetCellData().GetArray(name)) for name in ("PartId", "Side"))
    assert ((parts == 1) == (sides == -1)).all() and 0 < parts.sum() < len(parts)
    reader = vtkPNGReader()
    reader.SetMemoryBuffer(worn[1])
    reader.SetMemoryBufferLength(len(worn[1]))
    reader.Update()
    back = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(rows, columns, 3).astype(int)  # rows from the bottom
    assert abs(back[80, 40:160, 0] - 60).max() <= 2, "no eye, neither where it was nor mirrored"
    assert abs(back[80, 40:48] - (60, 160, 90)).max() < 6 and abs(back[80, 152:160] - (60, 90, 160)).max() < 6, "mirrored"
    # A picture of the back goes before it; without a picture it does nothing.
    done = run(*call, "--back-image", tmp_path / "front.png", "-o", tmp_path / "given.vtp")
    assert done.returncode == 0 and "--back-from-rim does nothing" in done.stderr and done.stderr.count("arning") == 1, done.stderr
    assert is_skin(vtk_to_numpy(read(tmp_path / "given.vtp").GetFieldData().GetAbstractArray("Part1.Texture")).tobytes(), front)
    done = run("inflate", drawing, "--back-from-rim", "--levels", "2", "-o", tmp_path / "bare.vtp")
    assert done.returncode == 0 and "--back-from-rim does nothing without --image" in done.stderr
    assert read(tmp_path / "bare.vtp").GetCellData().GetArray("PartId") is None
