"""Parts put together by the command: places, pictures, formats read back by VTK, and parts' files that are not right."""
import hashlib
import json
import os
import pty
import resource
import signal
import struct
import subprocess
import time
import zlib

import numpy
import pytest
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkFiltersCore import vtkMassProperties
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOImport import vtkGLTFImporter, vtkOBJImporter
from vtkmodules.vtkRenderingCore import vtkRenderWindow
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, what the importers make

from scene import *  # noqa: F403

DRAWINGS = SOURCE / "Data" / "Drawings"
FIGURE = ("figure_body", "figure_head", "figure_hat")


def png(red, green, blue, size=4):
    """The bytes of a picture of one colour."""
    rows = (b"\0" + bytes((red, green, blue)) * size) * size
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def pixels_of(image):
    return vtk_to_numpy(image.GetPointData().GetScalars())


def pixels_in(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return pixels_of(reader.GetOutput())


def tetrahedron(picture=None, at=0.0):
    """Closed, 1 high, with texture coordinates and that picture where there is one."""
    points = numpy.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float) + at
    mesh = polydata(points, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])
    if picture:
        coordinates = numpy_to_vtk(points[:, :2].copy(), deep=True)
        coordinates.SetName("TCoords")
        mesh.GetPointData().SetTCoords(coordinates)
        array = numpy_to_vtk(numpy.frombuffer(picture, numpy.uint8), deep=True)
        array.SetName("Texture")
        mesh.GetFieldData().AddArray(array)
    return mesh


def parts_file(path, *parts):
    path.write_text(json.dumps({"parts": list(parts)}))
    return path


def assembled(parts, out, *more):
    done = run("assemble", parts, "-o", out, *more)
    assert done.returncode == 0, done.stderr
    return done.stderr


def faces_of(mesh):
    ids = vtkIdList()
    for face in range(mesh.GetNumberOfPolys()):
        mesh.GetPolys().GetCellAtId(face, ids)
        yield [ids.GetId(k) for k in range(ids.GetNumberOfIds())]


def parts_of(mesh):
    """[(places of the corners, their texture coordinates)] of each part's faces, in order."""
    points, coordinates = points_of(mesh), vtk_to_numpy(mesh.GetPointData().GetTCoords())
    numbers = vtk_to_numpy(mesh.GetCellData().GetArray("PartId"))
    faces = numpy.array(list(faces_of(mesh)))
    return [(points[faces[numbers == n]], coordinates[faces[numbers == n]]) for n in sorted(set(numbers))]


def volumes_of(mesh):
    """Of each part, positive where it looks outward."""
    made = []
    for corners, _ in parts_of(mesh):
        made.append(numpy.einsum("ij,ij->i", corners[:, 0], numpy.cross(corners[:, 1], corners[:, 2])).sum() / 6)
    return made


@pytest.fixture(scope="module")
def figure(tmp_path_factory):
    """The gnome as figure.vtp, .glb, .gltf and .obj, with figure.json, the report, and what was said."""
    folder = tmp_path_factory.mktemp("figure")
    said = {name: assembled(DRAWINGS / "figure.json", folder / ("figure." + name), "--report", folder / "figure.json")
            for name in ("vtp", "glb", "gltf", "obj")}
    return folder, said


def test_the_figure_keeps_its_parts_and_their_pictures(figure):
    folder, said = figure
    assert said["vtp"] == ""
    mesh = read(folder / "figure.vtp")
    parts = parts_of(mesh)
    assert len(parts) == 3 and min(volumes_of(mesh)) > 1e6
    report = json.loads((folder / "figure.json").read_text())
    placements = json.loads((DRAWINGS / "figure.json").read_text())["parts"]
    for number, name in enumerate(FIGURE):
        texture = mesh.GetFieldData().GetAbstractArray(f"Part{number}.Texture")
        assert is_skin(vtk_to_numpy(texture).tobytes(), (DRAWINGS / (name + ".png")).read_bytes())
        told = report["parts"][number]
        assert told["after"]["triangles"] == len(parts[number][0]) and told["strokes"].count("boundary") == 1
        assert told["drawing"].endswith(name + ".vtp") and told["stage_milliseconds"]["Inflate"] > 0
        assert told["placement"] == sum(placements[number]["placement"], [])
    assert report["after"] == {"points": mesh.GetNumberOfPoints(), "triangles": mesh.GetNumberOfPolys()}
    # A part is what inflate makes of it, moved.
    done = run("inflate", DRAWINGS / "figure_hat.vtp", "--image", DRAWINGS / "figure_hat.png", "-o", folder / "hat.vtp")
    assert done.returncode == 0
    hat = read(folder / "hat.vtp")
    alone = points_of(hat)[numpy.array(list(faces_of(hat)))] + (64.0, 740.0, 105.0)
    assert numpy.array_equal(parts[2][0], alone)


def test_vtk_reads_the_figure_from_gltf(figure):
    folder, said = figure
    parts = parts_of(read(folder / "figure.vtp"))
    for name in ("glb", "gltf"):
        assert "does not keep" not in said[name]
        reader = vtkGLTFReader()
        reader.SetFileName(str(folder / ("figure." + name)))
        reader.Update()
        blocks, iterator = [], reader.GetOutput().NewIterator()
        while not iterator.IsDoneWithTraversal():
            blocks.append(iterator.GetCurrentDataObject())
            iterator.GoToNextItem()
        assert len(blocks) == 3 and reader.GetNumberOfTextures() == 3
        for block, (corners, coordinates) in zip(blocks, parts):
            triangles = triangles_of(block)
            assert numpy.array_equal(points_of(block)[triangles], corners.astype(numpy.float32))
            made = vtk_to_numpy(block.GetPointData().GetTCoords())[triangles]
            # VTK's reader leaves v as it is in the file, from the top.
            assert numpy.abs(made * (1, -1) + (0, 1) - coordinates).max() < 1e-6
        textures = textures_of(vtkGLTFImporter(), folder / ("figure." + name))
        assert len(textures) == 3
        for number, pixels in enumerate(textures):
            assert numpy.array_equal(pixels, pixels_in(folder / f"figure_part{number}.png"))


def textures_of(importer, path):
    """The pixels of each actor's texture, of actors with faces."""
    importer.SetFileName(str(path))
    importer.SetRenderWindow(vtkRenderWindow())
    importer.Update()
    found = []
    for actor in importer.GetRenderer().GetActors():
        actor.GetMapper().Update()
        if actor.GetMapper().GetInput().GetNumberOfPolys() > 0:
            texture = actor.GetTexture() or actor.GetProperty().GetTexture("albedoTex")
            texture.Update()
            found.append(pixels_of(texture.GetInput()))
    return found


def test_vtk_reads_the_figure_from_obj(figure):
    folder, said = figure
    assert "OBJ keeps the textures beside it, in figure.mtl" in said["obj"]
    parts = parts_of(read(folder / "figure.vtp"))
    mesh = read(folder / "figure.obj")
    array = mesh.GetFieldData().GetAbstractArray("MaterialNames")
    names = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    assert [name for name in names if name != "NO_MATERIAL"] == ["part0", "part1", "part2"]
    if "NO_MATERIAL" not in names:  # VTK 9.3's reader gives a material to the first of its faces alone
        worn = numpy.repeat(range(3), [len(corners) for corners, _ in parts])
        assert numpy.array_equal(vtk_to_numpy(mesh.GetCellData().GetArray("MaterialIds")), worn)
    triangles, points = triangles_of(mesh), points_of(mesh)
    for number, (corners, coordinates) in enumerate(parts):
        its, triangles = triangles[:len(corners)], triangles[len(corners):]
        assert numpy.array_equal(points[its].astype(numpy.float32), corners.astype(numpy.float32))
        made = vtk_to_numpy(mesh.GetPointData().GetArray(f"part{number}"))  # VTK's reader makes an array for each material
        assert numpy.array_equal(made[its], coordinates.astype(numpy.float32))
        assert is_skin((folder / f"figure_part{number}.png").read_bytes(), (DRAWINGS / (FIGURE[number] + ".png")).read_bytes())
    assert len(triangles) == 0
    importer = vtkOBJImporter()
    importer.SetFileNameMTL(str(folder / "figure.mtl"))
    importer.SetTexturePath(str(folder))
    textures = textures_of(importer, folder / "figure.obj")
    assert len(textures) == 3
    for number, pixels in enumerate(textures):
        assert numpy.array_equal(pixels, pixels_in(folder / f"figure_part{number}.png"))


def test_fronts_and_backs_keep_pictures_of_their_own(tmp_path):
    """A part drawn over two pictures, one that was made before and read, a plain one: each format read back, and assembled once more."""
    leaf_picture = (DRAWINGS / "leaf.png").read_bytes()
    pictures = [leaf_picture, png(9, 8, 7), png(90, 20, 60, 960), png(200, 10, 30), png(4, 5, 6)]
    for name, picture in zip(("front", "back", "second_front", "second_back", "plain"), pictures):
        (tmp_path / (name + ".png")).write_bytes(picture)
    leaf = DRAWINGS / "leaf.vtp"
    done = run("inflate", leaf, "--image", tmp_path / "second_front.png", "--back-image", tmp_path / "second_back.png",
               "--levels", "1", "-o", tmp_path / "made.vtp")
    assert done.returncode == 0, done.stderr
    write(tetrahedron(pictures[4]), tmp_path / "t.vtp")
    drawing = {"strokes": str(leaf), "picture": "front.png", "back_picture": "back.png", "parameters": {"levels": 1}}
    parts = parts_file(tmp_path / "parts.json", drawing, {"mesh": "made.vtp", "depth": 500}, {"mesh": "t.vtp"})
    assembled(parts, tmp_path / "o.vtp", "--report", tmp_path / "o.json")
    assert json.loads((tmp_path / "o.json").read_text())["parts"][0]["back_image"].endswith("back.png")
    mesh = read(tmp_path / "o.vtp")
    worn = parts_of(mesh)
    assert len(worn) == 5
    texture = lambda mesh, part: vtk_to_numpy(mesh.GetFieldData().GetAbstractArray(f"Part{part}.Texture")).tobytes()
    skins = [texture(mesh, part) for part in range(5)]
    assert all(is_skin(skin, picture) for skin, picture in zip(skins, pictures)) and skins[4] == pictures[4]
    pictures = skins
    sides = [corners[:, :, 2] for corners, _ in worn]
    assert sides[0].min() >= 0.0 >= sides[1].max() and sides[2].min() >= 500.0 >= sides[3].max()
    # A back is seen from behind: its picture is the other way round.
    rim = {tuple(place): at for place, at in zip(worn[0][0].reshape(-1, 3), worn[0][1].reshape(-1, 2))}
    shared = [(rim[tuple(place)], at) for place, at in zip(worn[1][0].reshape(-1, 3), worn[1][1].reshape(-1, 2)) if tuple(place) in rim]
    assert len(shared) > 50 and all(numpy.allclose(front, (1.0 - back[0], back[1])) for front, back in shared)

    for name in ("glb", "obj"):
        assembled(parts, tmp_path / ("o." + name))
    document = document_of(tmp_path / "o.glb")
    assert [len(document[name]) for name in ("materials", "images")] == [5, 5] and len(document["meshes"][0]["primitives"]) == 5
    reader = vtkGLTFReader()
    reader.SetFileName(str(tmp_path / "o.glb"))
    reader.Update()
    iterator = reader.GetOutput().NewIterator()
    for corners, coordinates in worn:
        block = iterator.GetCurrentDataObject()
        triangles = triangles_of(block)
        assert numpy.array_equal(points_of(block)[triangles], corners.astype(numpy.float32))
        assert numpy.abs(vtk_to_numpy(block.GetPointData().GetTCoords())[triangles] * (1, -1) + (0, 1) - coordinates).max() < 1e-6
        iterator.GoToNextItem()
    importer = vtkOBJImporter()
    importer.SetFileNameMTL(str(tmp_path / "o.mtl"))
    importer.SetTexturePath(str(tmp_path))
    for kind, path in ((importer, tmp_path / "o.obj"), (vtkGLTFImporter(), tmp_path / "o.glb")):
        found = textures_of(kind, path)
        assert len(found) == 5
        for pixels, picture in zip(found, pictures):
            (tmp_path / "seen.png").write_bytes(picture)
            assert numpy.array_equal(pixels, pixels_in(tmp_path / "seen.png"))
    assert [(tmp_path / f"o_part{part}.png").read_bytes() for part in range(5)] == pictures

    # What was read back from each is a part with the same pictures.
    for name in ("vtp", "glb", "obj"):
        again = parts_file(tmp_path / "again.json", {"mesh": "o." + name}, {"mesh": "t.vtp", "depth": 9})
        assembled(again, tmp_path / "again.vtp")
        whole = read(tmp_path / "again.vtp")
        assert [texture(whole, part) for part in range(6)] == pictures + pictures[4:], name
        for (corners, coordinates), (made, its) in zip(worn, parts_of(whole)):
            assert numpy.allclose(made, corners, atol=1e-3) and numpy.allclose(its, coordinates, atol=1e-5), name


def test_a_box_and_a_depth_place_a_part(tmp_path):
    write(tetrahedron(png(9, 9, 9), at=3.0), tmp_path / "t.vtp")
    parts = parts_file(tmp_path / "parts.json", {"mesh": "t.vtp"}, {"mesh": "t.vtp", "depth": 7},
                       {"mesh": "t.vtp", "box": [10, 20, 12, 28], "depth": -5},
                       {"strokes": str(DRAWINGS / "leaf.vtp"), "parameters": {"levels": 1}, "box": [0, 0, 1, 2]},
                       {"strokes": str(DRAWINGS / "leaf.vtp"), "parameters": {"levels": 1}})
    assembled(parts, tmp_path / "o.vtp")
    corners = [part[0].reshape(-1, 3) for part in parts_of(read(tmp_path / "o.vtp"))]
    assert numpy.array_equal(corners[1], corners[0] + (0, 0, 7)) and corners[0].min() == 3.0
    # 2 wide and 8 high: 4 deep, and z = 3 comes to 12, less 5.
    assert numpy.allclose(corners[2].min(axis=0), (10, 20, 7)) and numpy.allclose(corners[2].max(axis=0), (12, 28, 11))
    # Of a drawing the canvas fills the box: the picture of 960 x 640, from (-0.5, -0.5).
    assert numpy.allclose(corners[3], (corners[4] + (0.5, 0.5, 0)) * (1 / 960, 2 / 640, numpy.sqrt(2 / 960 / 640)))


def test_a_mirrored_part_looks_outward_in_every_format(tmp_path):
    write(tetrahedron(png(1, 2, 3)), tmp_path / "t.vtp")
    mirror = [[-2, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    parts = parts_file(tmp_path / "parts.json", {"mesh": "t.vtp"}, {"mesh": "t.vtp", "placement": mirror})
    assembled(parts, tmp_path / "o.vtp")
    assert volumes_of(read(tmp_path / "o.vtp")) == pytest.approx([1 / 6, 1 / 3])
    assembled(parts, tmp_path / "o.stl")
    mass = vtkMassProperties()
    mass.SetInputData(read(tmp_path / "o.stl"))
    assert mass.GetVolume() == pytest.approx(0.5)


def document_of(path):
    data = path.read_bytes()
    length = struct.unpack("<I", data[12:16])[0]
    return json.loads(data[20:20 + length])


def test_parts_share_a_picture_and_touch_without_growing_together(tmp_path):
    write(tetrahedron(png(9, 8, 7)), tmp_path / "t.vtp")
    write(tetrahedron(), tmp_path / "plain.vtp")
    parts = parts_file(tmp_path / "parts.json", {"mesh": "t.vtp"}, {"mesh": "plain.vtp"}, {"mesh": "t.vtp", "depth": 1})
    assembled(parts, tmp_path / "o.glb")
    document = document_of(tmp_path / "o.glb")
    assert [len(document[name]) for name in ("materials", "textures", "images")] == [3, 1, 1]
    worn = [document["materials"][primitive["material"]] for primitive in document["meshes"][0]["primitives"]]
    assert [material["name"] for material in worn] == ["part0", "part1", "part2"]
    assert ["baseColorTexture" in material["pbrMetallicRoughness"] for material in worn] == [True, False, True]
    assembled(parts, tmp_path / "o.obj")
    lines = (tmp_path / "o.obj").read_text().splitlines()
    assert sum(line.startswith("v ") for line in lines) == 12, "parts 0 and 1 are at one place, and parts 0 and 2 touch"
    assert (tmp_path / "o.mtl").read_text().count("map_Kd o_part0.png\n") == 2
    assert sorted(name for name in os.listdir(tmp_path) if name.endswith(".png")) == ["o_part0.png"]
    # One that has no coordinates has zeros, so that the others keep theirs.
    assembled(parts, tmp_path / "o.vtp")
    coordinates = [part[1] for part in parts_of(read(tmp_path / "o.vtp"))]
    assert (coordinates[1] == 0).all() and coordinates[0].max() == 1.0 and numpy.array_equal(coordinates[0], coordinates[2])


@pytest.mark.parametrize("extension", ["stl", "off"])
def test_formats_without_pictures_say_so(tmp_path, extension):
    write(tetrahedron(png(9, 8, 7)), tmp_path / "t.vtp")
    parts = parts_file(tmp_path / "parts.json", {"mesh": "t.vtp"}, {"mesh": "t.vtp", "depth": 1})
    said = assembled(parts, tmp_path / ("o." + extension))
    line, = [line for line in said.splitlines() if "does not keep" in line]
    assert line.endswith("which part a face is of, the parts' pictures")
    assert read(tmp_path / ("o." + extension)).GetNumberOfPolys() == 8


def test_quads_are_cut_where_they_must_be(tmp_path):
    leaf = {"strokes": str(DRAWINGS / "leaf.vtp"), "picture": str(DRAWINGS / "leaf.png"), "parameters": {"quads": True, "levels": 1}}
    parts = parts_file(tmp_path / "parts.json", leaf, dict(leaf, depth=200))
    assert "cut in two" not in assembled(parts, tmp_path / "o.obj")
    quads = sum(line.startswith("f ") and line.count("/") == 4 for line in (tmp_path / "o.obj").read_text().splitlines())
    assert quads > 300 and quads % 2 == 0
    assert "glTF keeps no quads; they are cut in two" in assembled(parts, tmp_path / "o.glb")
    document = document_of(tmp_path / "o.glb")
    counts = [document["accessors"][primitive["indices"]]["count"] for primitive in document["meshes"][0]["primitives"]]
    assert counts == [3 * quads] * 2 and len(document["images"]) == 1


def test_what_is_lost_of_the_parts_is_named(tmp_path, figure):
    write(body(), tmp_path / "body.vtp")  # with colours
    write(tetrahedron(), tmp_path / "t.vtp")
    said = assembled(parts_file(tmp_path / "parts.json", {"mesh": "body.vtp"}, {"mesh": "t.vtp"}), tmp_path / "o.vtp")
    assert said == f"oversketch: note: {tmp_path}/parts.json: normals, and arrays that only some parts have, are dropped: RGB\n"


def test_what_was_assembled_is_a_part_with_its_pictures(tmp_path, figure):
    write(tetrahedron(png(9, 8, 7)), tmp_path / "t.vtp")
    parts = parts_file(tmp_path / "parts.json", {"mesh": "t.vtp"}, {"mesh": str(figure[0] / "figure.vtp"), "depth": 5})
    assembled(parts, tmp_path / "o.vtp")
    mesh = read(tmp_path / "o.vtp")
    ids = vtk_to_numpy(mesh.GetCellData().GetArray("PartId"))
    assert sorted(set(ids)) == [0, 1, 2, 3] and (ids == 0).sum() == 4
    bytes_of = lambda data, name: vtk_to_numpy(data.GetFieldData().GetArray(name)).tobytes()
    whole = read(figure[0] / "figure.vtp")
    for part in range(3):
        assert bytes_of(mesh, f"Part{part + 1}.Texture") == bytes_of(whole, f"Part{part}.Texture")
    assert bytes_of(mesh, "Part0.Texture") == png(9, 8, 7)


def test_the_same_parts_give_the_same_bytes(tmp_path, figure):
    assembled(DRAWINGS / "figure.json", tmp_path / "figure.glb")
    assert hashlib.md5((tmp_path / "figure.glb").read_bytes()).digest() == hashlib.md5((figure[0] / "figure.glb").read_bytes()).digest()


IDENTITY = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]


def moved(row, column, value):
    matrix = [list(line) for line in IDENTITY]
    matrix[row][column] = value
    return matrix


HOSTILE = {  # what the file holds, and what the message says beside the file's name
    "empty": ("", "is empty"),
    "no JSON": ('{"parts": [', "no JSON: Line 1"),
    "a name twice": ('{"parts": [{"mesh": "t.vtp", "mesh": "t.vtp"}]}', "no JSON: Line 1"),
    "NaN": ('{"parts": [{"mesh": "t.vtp", "depth": NaN}]}', "no JSON: Line 1"),
    "nested": ('{"parts": ' + "[" * 5000 + "]" * 5000 + "}", "nested too deep"),
    "a list": ([], "is no object"),
    "no parts": ({}, "lacks 'parts'"),
    "another member": ({"parts": [{"mesh": "t.vtp"}], "units": "mm"}, "'units' is no member of it; these are: parts"),
    "parts are a text": ({"parts": "t.vtp"}, "'parts' is not a list"),
    "0 parts": ({"parts": []}, "'parts' is empty; name a part at least"),
    "1001 parts": ({"parts": [{"mesh": "t.vtp", "depth": i} for i in range(1001)]}, "has 1001 entries, and may have 1000; assemble some"),
    "a part is a text": ({"parts": [{"mesh": "t.vtp"}, "t.vtp"]}, "part 1 is no object"),
    "an empty part": ({"parts": [{}]}, "part 0 needs either 'strokes', a drawing, or 'mesh'"),
    "both": ({"parts": [{"mesh": "t.vtp", "strokes": "t.vtp"}]}, "part 0 needs either"),
    "a mesh with a picture of its back": ({"parts": [{"mesh": "t.vtp", "back_picture": "t.png"}]},
                                          "part 0: 'back_picture' belongs to 'strokes'"),
    "an absent picture of a back": ({"parts": [{"strokes": "fish.vtp", "back_picture": "t.jpg"}]}, "part 0: 'back_picture' names 't.jpg'"),
    "a mesh with a picture": ({"parts": [{"mesh": "t.vtp", "picture": "t.png"}]}, "part 0: 'picture' belongs to 'strokes'"),
    "a member that leans on another part": ({"parts": [{"mesh": "t.vtp", "on": 1}, {"mesh": "t.vtp", "on": 0}]},
                                            "part 0: 'on' is no member"),
    "its own file": ({"parts": [{"mesh": "parts.json"}]}, "part 0: ", "is none of the mesh formats"),
    "a number for a path": ({"parts": [{"mesh": 7}]}, "part 0: 'mesh' is not a string"),
    "absent": ({"parts": [{"mesh": "t.vtp"}, {"mesh": "no.vtp"}]}, "part 1: 'mesh' names 'no.vtp': there is no such file; mend the path"),
    "an empty path": ({"parts": [{"mesh": ""}]}, "part 0: 'mesh' is no path of a file"),
    "a path that ends early": ({"parts": [{"mesh": "t.vtp\0.obj"}]}, "part 0: 'mesh' is no path of a file"),
    "absent and outside": ({"parts": [{"strokes": "../../no/way.vtp"}]},
                           "part 0: 'strokes' names '../../no/way.vtp': there is no such file"),
    "a folder": ({"parts": [{"mesh": "."}]}, "part 0: 'mesh' names '.'", "is not a file"),
    "a pipe": ({"parts": [{"mesh": "/dev/zero"}]}, "part 0: 'mesh' names '/dev/zero': is not a file"),
    "no picture": ({"parts": [{"strokes": "fish.vtp", "picture": "t.vtp"}]}, "part 0: ", "t.vtp: is no PNG, JPEG"),
    "an absent picture": ({"parts": [{"strokes": "fish.vtp", "picture": "t.jpg"}]}, "part 0: 'picture' names 't.jpg'"),
    "no strokes": ({"parts": [{"mesh": "t.vtp"}, {"strokes": "t.vtp"}]}, "part 1: ", "holds no polyline"),
    "strokes for a mesh": ({"parts": [{"mesh": "fish.vtp"}]}, "part 0: ", "holds no polygons"),
    "an unknown parameter": ({"parts": [{"strokes": "fish.vtp", "parameters": {"hight": 2}}]},
                             "part 0, parameters: 'hight' is no parameter; they are called as the options of oversketch inflate"),
    "a text for a number": ({"parts": [{"strokes": "fish.vtp", "parameters": {"height": "2"}}]},
                            "part 0, parameters: 'height' is not a number"),
    "a list for parameters": ({"parts": [{"strokes": "fish.vtp", "parameters": [2]}]}, "part 0, parameters is no object"),
    "a stroke that is not there": ({"parts": [{"mesh": "t.vtp"}, {"strokes": "fish.vtp", "parameters": {"hole": "99"}}]}, "part 1: ", "99"),
    "a profile that is none": ({"parts": [{"strokes": "fish.vtp", "parameters": {"profile": "round"}}]}, "part 0: ", "rofile"),
    "a part twice": ({"parts": [{"mesh": "t.vtp", "depth": 1}, {"mesh": "t.vtp"}, {"mesh": "./t.vtp", "depth": 1.0}]},
                     "part 2 is part 0 once more, at the same place; take it out, or place it elsewhere"),
    "two ways of placing": ({"parts": [{"mesh": "t.vtp", "placement": IDENTITY, "depth": 0}]}, "part 0: 'placement' stands beside"),
    "three rows": ({"parts": [{"mesh": "t.vtp", "placement": IDENTITY[:3]}]},
                   "part 0: 'placement' is no matrix of four rows of four numbers"),
    "a short row": ({"parts": [{"mesh": "t.vtp", "placement": IDENTITY[:3] + [[0, 0, 1]]}]}, "part 0: 'placement' is no matrix"),
    "words in a matrix": ({"parts": [{"mesh": "t.vtp", "placement": moved(1, 1, "NaN")}]},
                          "part 0: 'placement' holds something that is no number"),
    "1e300": ({"parts": [{"mesh": "t.vtp", "placement": moved(0, 3, 1e300)}]}, "part 0: 'placement' holds a number beyond 1e9"),
    # Read as an infinite number or refused as no JSON, as jsoncpp's version has it; either names the value.
    "1e999": ('{"parts": [{"mesh": "t.vtp", "depth": 1e999}]}',
              ("part 0: 'depth' holds something that is no number", "it is no JSON: Line 1, Column 39")),
    "a flat one": ({"parts": [{"mesh": "t.vtp", "placement": moved(2, 2, 0)}]},
                   "part 0: 'placement': A part's placement flattens it; no scale"),
    "1e-300": ({"parts": [{"mesh": "t.vtp", "placement": moved(2, 2, 1e-300)}]}, "part 0: 'placement' scales the part by less than 1e-9"),
    "a box for a speck": ({"parts": [{"mesh": "t.vtp", "box": [0, 0, 1e-8, 1e9]}, {"mesh": "speck.vtp", "box": [0, 0, 1, 1]}]},
                          "part 1: 'box' scales the part by less than 1e-9 or over 1e9"),
    "a projection": ({"parts": [{"mesh": "t.vtp", "placement": moved(3, 0, 1)}]},
                     "part 0: 'placement': A part's placement must be an affine matrix"),
    "a zero box": ({"parts": [{"mesh": "t.vtp", "box": [1, 1, 1, 1]}]}, "part 0: 'box' is empty; right must be greater than left"),
    "a box turned round": ({"parts": [{"mesh": "t.vtp", "box": [2, 0, 1, 1]}]}, "part 0: 'box' is empty"),
    "a box of three": ({"parts": [{"mesh": "t.vtp", "box": [2, 0, 1]}]}, "part 0: 'box' is not left, bottom, right and top"),
    "a box of texts": ({"parts": [{"mesh": "t.vtp", "box": ["0", 0, 1, 1]}]}, "part 0: 'box' holds something that is no number"),
    "a box for what is flat": ({"parts": [{"mesh": "flat.vtp", "box": [0, 0, 1, 1]}]},
                               "part 0: 'box' cannot be filled by a part that is flat"),
    "a depth of true": ({"parts": [{"mesh": "t.vtp", "depth": True}]}, "part 0: 'depth' holds something that is no number"),
    "a far depth": ({"parts": [{"mesh": "t.vtp", "depth": -1e300}]}, "part 0: 'depth' holds a number beyond 1e9"),
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("hostile")
    write(tetrahedron(png(9, 8, 7)), folder / "t.vtp")
    flat = tetrahedron()
    for i in range(4):
        flat.GetPoints().SetPoint(i, 0.0, *flat.GetPoint(i)[1:])
    write(flat, folder / "flat.vtp")
    speck = tetrahedron()
    for i in range(4):
        speck.GetPoints().SetPoint(i, *(1e-10 * x for x in speck.GetPoint(i)))
    write(speck, folder / "speck.vtp")
    (folder / "t.png").write_bytes(png(1, 1, 1))
    (folder / "fish.vtp").write_bytes((DRAWINGS / "fish.vtp").read_bytes())
    return folder


@pytest.mark.parametrize("name", HOSTILE)
def test_what_is_not_right_is_one_message(folder, name):
    content, *words = HOSTILE[name]
    (folder / "parts.json").write_text(content if isinstance(content, str) else json.dumps(content))
    before = sorted(os.listdir(folder))
    message = refuse(1, "assemble", folder / "parts.json", "-o", folder / "o.vtp", "--report", folder / "o.json")
    said = [any(way in message for way in (word if isinstance(word, tuple) else (word,))) for word in words]
    assert str(folder / "parts.json") in message and all(said), message
    assert sorted(os.listdir(folder)) == before


def test_bad_use_is_told_apart(folder, tmp_path):
    parts = parts_file(tmp_path / "parts.json", {"mesh": "t.vtp"})
    write(tetrahedron(), tmp_path / "t.vtp")
    for arguments, word in (([parts], "needs -o OUT"), ([], "assemble needs a file of parts"),
                            ([parts, parts, "-o", "o.vtp"], "one file too many"),
                            ([parts, "-o", "o.png"], "none of the mesh formats"),
                            ([parts, "-o", "o.vtp", "--quads"], "'--quads' is no option of assemble"),
                            ([parts, "-o", tmp_path / "t.vtp"], "would replace the mesh of"),
                            ([parts, "-o", tmp_path / "o.vtp", "--report", parts], "would replace the parts"),
                            ([parts, "-o", "o.vtp", "--report", "o.vtp"], "--report writes a .json file")):
        assert word in refuse(2, "assemble", *arguments)
    assert "there is no such file" in refuse(1, "assemble", tmp_path / "no.json", "-o", tmp_path / "o.vtp")
    text = run("assemble", "--help").stdout
    assert all(word in text for word in ("strokes", "picture", "parameters", "box", "depth", "placement", "--report"))
    assert text.endswith("\n")
    assert max(map(len, text.splitlines())) <= 110
    assert "oversketch assemble PARTS.json -o OUT" in run("--help").stdout


def test_a_thousand_parts_with_a_thousand_pictures(tmp_path):
    for i in range(1000):
        write(tetrahedron(png(i % 256, i // 256, 5)), tmp_path / f"{i}.vtp")
    places = [{"mesh": f"{i}.vtp", "box": [i % 40, i // 40, i % 40 + 0.5, i // 40 + 0.5]} for i in range(1000)]
    parts = parts_file(tmp_path / "parts.json", *places)
    assembled(parts, tmp_path / "o.glb")
    document = document_of(tmp_path / "o.glb")
    assert [len(document[name]) for name in ("materials", "images")] == [1000, 1000] and len(document["meshes"][0]["primitives"]) == 1000
    assembled(parts, tmp_path / "o.obj", "--report", tmp_path / "o.json")
    assert [(tmp_path / f"o_part{i}.png").read_bytes() for i in (0, 999)] == [png(0, 0, 5), png(231, 3, 5)]
    assert len(json.loads((tmp_path / "o.json").read_text())["parts"]) == 1000
    assembled(parts, tmp_path / "o.vtp")
    mesh = read(tmp_path / "o.vtp")
    assert mesh.GetNumberOfPolys() == 4000 and mesh.GetFieldData().GetNumberOfArrays() == 1000
    corners = parts_of(mesh)[777][0].reshape(-1, 3)
    assert numpy.allclose(corners.min(axis=0), (17, 19, 0)) and numpy.allclose(corners.max(axis=0), (17.5, 19.5, 0.5))


def test_a_full_disk_leaves_nothing(tmp_path):
    write(tetrahedron(png(9, 8, 7)), tmp_path / "t.vtp")
    parts_file(tmp_path / "parts.json", *[{"mesh": "t.vtp", "depth": i} for i in range(50)])
    before = sorted(os.listdir(tmp_path))
    full = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000))
    done = run("assemble", "parts.json", "-o", "o.obj", cwd=tmp_path, preexec_fn=full)
    assert done.returncode == 1 and "o.obj: could not be written" in done.stderr, done.stderr
    (tmp_path / "o_part0.png").write_text("a holiday")
    done = run("assemble", "parts.json", "-o", "o.obj", cwd=tmp_path)
    assert done.returncode == 1 and "its texture would replace o_part0.png" in done.stderr
    assert (tmp_path / "o_part0.png").read_text() == "a holiday" and sorted(os.listdir(tmp_path)) == sorted(before + ["o_part0.png"])


def test_progress_on_a_terminal_and_interrupt(tmp_path):
    # Takes seconds of which the interrupt needs a part, however loaded the machine is.
    parts = tmp_path / "parts.json"
    parts.write_text(json.dumps({"parts": [{"strokes": str(DRAWINGS / "figure_body.vtp"), "parameters": {"levels": 6}}]}))
    leader, follower = pty.openpty()
    program = subprocess.Popen([COMMAND, "assemble", parts, "-o", tmp_path / "o.glb"], stderr=follower)
    os.close(follower)
    shown = b""
    deadline = time.monotonic() + 60
    while b" %  " not in shown and time.monotonic() < deadline:
        shown += os.read(leader, 4096)
    program.send_signal(signal.SIGINT)
    try:
        while True:
            shown += os.read(leader, 4096)
    except OSError:  # it has ended
        pass
    os.close(leader)
    assert program.wait(60) == 1 and b"interrupted; nothing is written" in shown
    assert os.listdir(tmp_path) == ["parts.json"]
