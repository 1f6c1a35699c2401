// Arrays, colours and pictures through each format: kept, or named where they are not.
#include "colours.h"
#include "made_files.h"
#include "mesh_file.h"
#include "texture.h"

#include "Harness/polydata.h"
#include "Harness/shapes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTriangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

using namespace oversketch_files;
using namespace oversketch_files_test;

namespace
{

// A folder that goes with the test.
class Place
{
public:
  Place()
    : Path(std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "-keeping"))
  {
    std::filesystem::create_directory(this->Path);
  }
  ~Place() { std::filesystem::remove_all(this->Path); }
  std::string at(const std::string& name) const { return (this->Path / name).string(); }
  std::string put(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(this->Path / name, std::ios::binary) << bytes;
    return this->at(name);
  }

private:
  std::filesystem::path Path;
};

// The mesh through a file of that name.
vtkSmartPointer<vtkPolyData> through(const Place& place,
  const std::string& name,
  vtkPolyData* mesh,
  Notes& notes)
{
  writeMesh(mesh, place.at(name), notes);
  return readMesh(place.at(name), notes);
}

// Points that no single precision holds, about that place.
vtkSmartPointer<vtkPolyData> ballAt(double offset)
{
  oversketch::Mesh ball = oversketch_test::icosphere(2);
  for (oversketch::Vector3& p : ball.points)
  {
    p = 1.1 * p + oversketch::Vector3(offset / 9.0, offset, -offset / 3.0);
  }
  return oversketch_test::toPolyData(ball);
}

// Two triangles of a square in the plane, and what a row of points and of faces says besides.
std::string plySquare(const std::string& header,
  const std::string& ofFaces,
  const std::vector<std::string>& pointRows,
  const std::vector<std::string>& faceRows,
  const std::string& more = "",
  const std::string& moreRows = "")
{
  const char* const corners[] = { "0 0 0", "1 0 0", "1 1 0", "0 1 0" };
  const char* const faces[] = { "3 0 1 2", "3 0 2 3" };
  std::string text =
    "ply\nformat ascii 1.0\n" + header.substr(0, header.find("property")) +
    "element vertex 4\nproperty double x\nproperty double y\nproperty double z\n" +
    (header.find("property") == std::string::npos ? "" : header.substr(header.find("property"))) +
    "element face 2\nproperty list uchar int vertex_indices\n" + ofFaces + more + "end_header\n";
  for (std::size_t i = 0; i < 4; ++i)
  {
    text += std::string(corners[i]) + ' ' + pointRows[i] + '\n';
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    text += std::string(faces[i]) + ' ' + faceRows[i] + '\n';
  }
  return text + moreRows;
}

} // namespace

TEST(Precision, EveryFormatKeepsItAtEveryOffset)
{
  const Place place;
  for (const double offset : { 0.0, 1e3, 5e5, 4.6e6 })
  {
    const auto mesh = ballAt(offset);
    const double size = mesh->GetLength();
    for (const std::string format : { "vtp", "obj", "ply", "off", "gltf", "glb", "stl" })
    {
      Notes notes;
      const auto read = through(place, "ball." + format, mesh, notes);
      double worst = 0.0;
      for (vtkIdType i = 0; format != "stl" && i < mesh->GetNumberOfPoints(); ++i)
      {
        double p[3], q[3];
        mesh->GetPoint(i, p);
        read->GetPoint(i, q);
        worst = std::max({ worst, std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2]) });
      }
      const bool single = format == "gltf" || format == "glb";
      EXPECT_LE(worst, single ? 1e-7 * size + 1e-15 * offset : 0.0) << format << " at " << offset;
      const bool isLost = format == "stl" && offset > 1e5;
      EXPECT_EQ(isSaid(notes, "single precision"), isLost) << format << " at " << offset << '\n'
                                                           << allOf(notes);
      EXPECT_EQ(isSaid(notes, "% of the model's size"), isLost);
      if (!isLost)
      {
        EXPECT_EQ(read->GetNumberOfPoints(), mesh->GetNumberOfPoints()) << format << " at " << offset;
        EXPECT_EQ(read->GetNumberOfPolys(), mesh->GetNumberOfPolys()) << format << " at " << offset;
      }
    }
  }
}

TEST(Precision, WhatALossIsIsSaid)
{
  const Place place;
  Notes notes;
  writeMesh(ballAt(4.6e6), place.at("ball.stl"), notes);
  // Numbers between 2^22 and 2^23 lie half apart; the diagonal is that of a box of 2.1 or so.
  EXPECT_TRUE(isSaid(notes, "points move by up to 0.24, 6.4 % of the model's size")) << allOf(notes);
  notes.clear();
  readMesh(place.at("ball.stl"), notes);
  EXPECT_TRUE(isSaid(notes, "they come in steps of 0.5, 14 % of the model's size")) << allOf(notes);
}

TEST(Precision, TextOfStlIsReadInDouble)
{
  const auto mesh =
    readText("solid\nfacet normal 0 0 1\nouter loop\nvertex 4600000.1 0 0\nvertex 4600001.1 0 0\n"
             "vertex 4600000.1 1.3 0\nendloop\nendfacet\nendsolid\n",
      "made.stl");
  EXPECT_EQ(mesh->GetPoint(0)[0], 4600000.1);
}

TEST(Precision, PlyIsDoubleWhereTheMeshIs)
{
  const Place place;
  Notes notes;
  writeMesh(ballAt(0.0), place.at("ball.ply"), notes);
  EXPECT_NE(wholeFile(place.at("ball.ply")).find("property double x"), std::string::npos);
  const auto single = readMesh(place.at("ball.ply"), notes);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(single->GetPoints());
  single->SetPoints(points);
  writeMesh(single, place.at("single.ply"), notes);
  EXPECT_NE(wholeFile(place.at("single.ply")).find("property float x"), std::string::npos);
}

TEST(Colours, OfObjAreReadAndWritten)
{
  const Place place;
  Notes notes;
  const auto text = [](const std::string& a, const std::string& b)
  { return "v 0 0 0 " + a + "\nv 1 0 0 " + b + "\nv 0 1 0\nf 1 2 3\n"; };
  // No byte is a half.
  auto mesh = readText(text("0.5 0.25 1", "0 0 0"), "made.obj", notes);
  ASSERT_TRUE(coloursOf(mesh));
  EXPECT_EQ(tuple(coloursOf(mesh), 0), (Numbers{ 0.5, 0.25, 1.0 }));
  EXPECT_EQ(tuple(coloursOf(mesh), 2), (Numbers{ 1.0, 1.0, 1.0 })) << "of a vertex without";
  writeMesh(mesh, place.at("again.obj"), notes);
  EXPECT_NE(wholeFile(place.at("again.obj")).find("v 0 0 0 0.5 0.25 1\n"), std::string::npos);
  const auto glb = through(place, "again.glb", mesh, notes);
  EXPECT_EQ(tuple(coloursOf(glb), 0), (Numbers{ 0.5, 0.25, 1.0, 1.0 }));
  EXPECT_EQ(allOf(notes), "");
  const auto ply = through(place, "again.ply", mesh, notes);
  EXPECT_EQ(tuple(coloursOf(ply), 0), (Numbers{ 128, 64, 255 }));
  EXPECT_TRUE(isSaid(notes, "PLY keeps colours of 8 bits")) << allOf(notes);
  // Bytes, as shares and as they are.
  for (const char* row : { "0.501961 0.25098 1", "128 64 255" })
  {
    mesh = readText(text(row, "0 0 0"), "made.obj");
    ASSERT_TRUE(coloursOf(mesh)) << row;
    EXPECT_TRUE(areBytes(coloursOf(mesh))) << row;
    EXPECT_EQ(tuple(coloursOf(mesh), 0), (Numbers{ 128, 64, 255 })) << row;
  }
  // A weight is no colour.
  EXPECT_FALSE(coloursOf(readText(text("1", "1"), "made.obj")));
}

TEST(Colours, OfOffAreReadAndWritten)
{
  const Place place;
  Notes notes;
  const auto mesh = readText("STCNOFF\n3 1 0\n0 0 0 0 0 1 9 8 7 255 0.5 0.25\n1 0 0 0 0 1 1 2 3 128 0 0\n"
                             "0 1 0 0 0 1 4 5 6 0 1 1\n3 0 1 2 250 10 20\n",
    "made.off",
    notes);
  const auto expectAll = [](vtkPolyData* read, const std::string& where)
  {
    ASSERT_TRUE(coloursOf(read) && faceColoursOf(read) && read->GetPointData()->GetNormals()) << where;
    EXPECT_EQ(tuple(coloursOf(read), 1), (Numbers{ 1, 2, 3, 128 })) << where;
    EXPECT_EQ(tuple(faceColoursOf(read), 0), (Numbers{ 250, 10, 20 })) << where;
    EXPECT_EQ(tuple(read->GetPointData()->GetNormals(), 2), (Numbers{ 0, 0, 1 })) << where;
    EXPECT_EQ(tuple(read->GetPointData()->GetTCoords(), 0), (Numbers{ 0.5, 0.25 })) << where;
  };
  expectAll(mesh, "read");
  expectAll(through(place, "again.off", mesh, notes), "again");
  expectAll(through(place, "again.ply", mesh, notes), "PLY");
  EXPECT_EQ(allOf(notes), "");
  const auto shares = readText(
    "COFF\n3 1 0\n0 0 0 0.5 0.25 1.0 1\n1 0 0 0 0 0 1\n0 1 0 1 1 1.0 1\n3 0 1 2 7\n", "made.off", notes);
  EXPECT_EQ(tuple(coloursOf(shares), 0), (Numbers{ 0.5, 0.25, 1.0, 1.0 }));
  EXPECT_EQ(
    tuple(coloursOf(through(place, "shares.off", shares, notes)), 0), (Numbers{ 0.5, 0.25, 1.0, 1.0 }));
  EXPECT_TRUE(isSaid(notes, "a list of colours")) << "of the face's 7";
}

TEST(Colours, OfStlAreReadAndWritten)
{
  const Place place;
  const auto stl = [](std::string header, const std::vector<unsigned short>& words)
  {
    header.resize(80, '\0');
    std::string bytes = header + bytesOf<unsigned>({ static_cast<unsigned>(words.size()) });
    for (std::size_t i = 0; i < words.size(); ++i)
    {
      const auto x = static_cast<float>(i);
      bytes +=
        bytesOf<float>({ 0, 0, 1, x, 0, 0, x + 1, 0, 0, x, 1, 0 }) + bytesOf<unsigned short>({ words[i] });
    }
    return bytes;
  };
  Notes notes;
  // Blue is lowest and the highest bit marks a colour; in Magics red is, and it marks what has none.
  const unsigned short red = 31 << 10 | 8, blue = 31;
  auto mesh = readText(stl("by hand", { red | 0x8000, 0 }), "made.stl", notes);
  ASSERT_TRUE(faceColoursOf(mesh));
  EXPECT_EQ(tuple(faceColoursOf(mesh), 0), (Numbers{ 255, 0, 66 }));
  EXPECT_EQ(tuple(faceColoursOf(mesh), 1), (Numbers{ 255, 255, 255 }));
  mesh = through(place, "again.stl", mesh, notes);
  ASSERT_TRUE(faceColoursOf(mesh));
  EXPECT_EQ(tuple(faceColoursOf(mesh), 0), (Numbers{ 255, 0, 66 }));
  mesh = through(place, "again.off", mesh, notes);
  EXPECT_EQ(tuple(faceColoursOf(mesh), 0), (Numbers{ 255, 0, 66 }));
  EXPECT_EQ(allOf(notes), "");
  mesh = readText(stl(std::string("COLOR=\x10\x20\x30\xff", 10), { blue, 0x8000 }), "made.stl", notes);
  ASSERT_TRUE(faceColoursOf(mesh));
  EXPECT_EQ(tuple(faceColoursOf(mesh), 0), (Numbers{ 255, 0, 0 }));
  EXPECT_EQ(tuple(faceColoursOf(mesh), 1), (Numbers{ 16, 32, 48 }));
  EXPECT_FALSE(faceColoursOf(readText(stl("by hand", { 0, 0 }), "made.stl")));
  // Some begin as text does.
  EXPECT_EQ(
    readText(stl("solid made by a program, facet by facet", { 0, 0 }), "made.stl")->GetNumberOfPolys(), 2);
  mesh = readText("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 250 10 20\n", "made.off");
  writeMesh(mesh, place.at("rounded.stl"), notes);
  EXPECT_TRUE(isSaid(notes, "in 5 bits")) << allOf(notes);
}

TEST(Ply, FurtherPropertiesAreArraysAndWrittenAgain)
{
  const Place place;
  Notes notes;
  const std::string path = place.put("made.ply",
    plySquare("property uchar quality\nproperty double time\nproperty list uchar int near\n",
      "property short flags\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n",
      { "7 0.1 2 1 2", "8 0.2 0", "9 0.3 0", "200 1e300 0" },
      { "-5 1 2 3", "6 4 5 6" },
      "element material 2\nproperty float shine\n",
      "0.5\n1.5\n"));
  const auto mesh = readMesh(path, notes);
  EXPECT_EQ(allOf(notes), path + ": not kept: the lists near of its points, the element material (2)\n");
  notes.clear();
  vtkNew<vtkDoubleArray> flow;
  flow->SetName("the flow");
  flow->SetNumberOfComponents(2);
  for (int i = 0; i < 4; ++i)
  {
    flow->InsertNextTuple2(0.1 * i, -i);
  }
  mesh->GetPointData()->AddArray(flow);
  const auto again = through(place, "again.ply", mesh, notes);
  EXPECT_EQ(allOf(notes), "");
  for (vtkPolyData* read : { mesh.Get(), again.Get() })
  {
    vtkDataArray* quality = read->GetPointData()->GetArray("quality");
    vtkDataArray* time = read->GetPointData()->GetArray("time");
    vtkDataArray* flags = read->GetCellData()->GetArray("flags");
    ASSERT_TRUE(quality && time && flags);
    EXPECT_EQ(quality->GetDataType(), VTK_UNSIGNED_CHAR);
    EXPECT_EQ(quality->GetComponent(3, 0), 200.0);
    EXPECT_EQ(time->GetComponent(0, 0), 0.1) << "to the bit";
    EXPECT_EQ(flags->GetDataType(), VTK_SHORT);
    EXPECT_EQ(flags->GetComponent(0, 0), -5.0);
    ASSERT_TRUE(faceColoursOf(read));
    EXPECT_EQ(tuple(faceColoursOf(read), 1), (Numbers{ 4, 5, 6 }));
  }
  ASSERT_TRUE(again->GetPointData()->GetArray("the_flow_1"));
  EXPECT_EQ(again->GetPointData()->GetArray("the_flow_1")->GetComponent(3, 0), -3.0);
}

TEST(Ply, ANumberBeyondItsTypeIsTheNearestOne)
{
  const auto mesh = readText(
    plySquare(
      "property uchar quality\nproperty int id\n", "", { "300 1e30", "-1 nan", "0 0", "0 0" }, { "", "" }),
    "made.ply");
  EXPECT_EQ(mesh->GetPointData()->GetArray("quality")->GetComponent(0, 0), 255.0);
  EXPECT_EQ(mesh->GetPointData()->GetArray("quality")->GetComponent(1, 0), 0.0);
  EXPECT_EQ(mesh->GetPointData()->GetArray("id")->GetComponent(0, 0), std::numeric_limits<int>::max());
}

TEST(Ply, StripsAreTriangles)
{
  Notes notes;
  const auto mesh =
    readText("ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
             "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 4 -1 4 3 1\n",
      "made.ply",
      notes);
  ASSERT_EQ(mesh->GetNumberOfPolys(), 4);
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < 3; ++face) // of the first strip, all facing up
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    double p[3][3], normal[3];
    for (int k = 0; k < 3; ++k)
    {
      mesh->GetPoint(ids->GetId(k), p[k]);
    }
    vtkTriangle::ComputeNormal(p[0], p[1], p[2], normal);
    EXPECT_EQ(normal[2], 1.0) << "face " << face;
  }
  EXPECT_EQ(allOf(notes), "");
}

TEST(Ply, ItsPictureComesAndGoesWithIt)
{
  const Place place;
  Notes notes;
  const std::string skin = pictureOfGrey(10), nose = pictureOfGrey(20);
  place.put("my skin.png", skin);
  place.put("nose.png", nose);
  // The seam, from 0 to 2, has other coordinates on its two sides.
  const std::vector<std::string> rows = { "", "", "", "" };
  const std::string wedges = "property list uchar float texcoord\n";
  const auto one = readMesh(
    place.put("one.ply",
      plySquare("comment TextureFile my skin.png\n", wedges, rows, { "6 0 0 1 0 1 1", "6 0.25 0 1 1 0 1" })),
    notes);
  EXPECT_EQ(textureOf(one), skin);
  ASSERT_EQ(one->GetNumberOfPoints(), 5);
  notes.clear();
  const auto again = through(place, "again.ply", one, notes);
  EXPECT_EQ(allOf(notes), "PLY keeps the texture beside it, in again.png\n");
  EXPECT_EQ(wholeFile(place.at("again.png")), skin);
  EXPECT_EQ(textureOf(again), skin);
  EXPECT_EQ(again->GetNumberOfPoints(), 5);
  EXPECT_NE(wholeFile(place.at("again.ply")).find("element vertex 4\n"), std::string::npos)
    << "a surface that is whole along its seam";
  EXPECT_EQ(tuple(again->GetPointData()->GetTCoords(), 4), (Numbers{ 0.25, 0.0 }));

  const auto two = readMesh(place.put("two.ply",
                              plySquare("comment TextureFile my skin.png\ncomment TextureFile nose.png\n",
                                wedges + "property int texnumber\n",
                                rows,
                                { "6 0 0 1 0 1 1 1", "6 0 0 1 1 0 1 0" })),
    notes);
  const auto twice = through(place, "twice.ply", two, notes);
  for (vtkPolyData* read : { two.Get(), twice.Get() })
  {
    EXPECT_EQ(picturesOf(read), (std::set<std::string>{ skin, nose }));
    ASSERT_TRUE(read->GetCellData()->GetArray("PartId"));
    const auto part = static_cast<int>(read->GetCellData()->GetArray("PartId")->GetComponent(0, 0));
    EXPECT_EQ(textureOf(read, "Part" + std::to_string(part) + "."), nose);
  }
  notes.clear();
  readMesh(
    place.put("none.ply", plySquare("comment TextureFile absent.png\n", wedges, rows, { "0", "0" })), notes);
  EXPECT_TRUE(isSaid(notes, "the picture absent.png is no PNG or JPEG")) << allOf(notes);
}

// A square of a textured and an untextured triangle.
TEST(Coordinates, OnAPartOfAModelStayThere)
{
  const Place place;
  const std::string text =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1 3 4\n";
  for (const char* format : { "obj", "ply", "glb" })
  {
    Notes notes;
    auto mesh = readText(text, "made.obj", notes);
    mesh = through(place, std::string("part.") + format, mesh, notes);
    vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
    ASSERT_TRUE(coordinates) << format;
    vtkNew<vtkIdList> ids;
    for (vtkIdType face = 0; face < 2; ++face)
    {
      mesh->GetPolys()->GetCellAtId(face, ids);
      for (const vtkIdType id : *ids)
      {
        EXPECT_EQ(isNowhere(coordinates, id), face == 1) << format << ", face " << face << ", point " << id;
      }
    }
    if (std::string(format) == "obj")
    {
      EXPECT_NE(wholeFile(place.at("part.obj")).find("\nf 1 3 4\n"), std::string::npos)
        << wholeFile(place.at("part.obj"));
    }
  }
}

TEST(Notes, SayWhatAUserLosesAndNothingOfASystemsOwn)
{
  const Place place;
  const auto mesh = ballAt(0.0);
  const auto add = [&](vtkFieldData* data, const char* name, vtkIdType count)
  {
    vtkNew<vtkIntArray> array;
    array->SetName(name);
    array->SetNumberOfValues(count);
    array->FillValue(1);
    data->AddArray(array);
  };
  const vtkIdType points = mesh->GetNumberOfPoints(), faces = mesh->GetNumberOfPolys();
  for (const char* name : { "StellarRoot", "StellarPath", "StellarGen" })
  {
    add(mesh->GetCellData(), name, faces);
  }
  for (const char* name : { "StellarMoved", "CurveId", "CurveParam", "Feature" })
  {
    add(mesh->GetPointData(), name, points);
  }
  add(mesh->GetFieldData(), "StellarVersion", 1);
  Notes notes;
  for (const char* name : { "a.stl", "a.off", "a.obj", "a.ply", "a.glb" })
  {
    writeMesh(mesh, place.at(name), notes);
  }
  EXPECT_EQ(allOf(notes), "");
  // By that name alone it is the user's.
  add(mesh->GetPointData(), "temperature", points);
  mesh->GetCellData()->RemoveArray("StellarRoot");
  mesh->GetCellData()->RemoveArray("StellarPath");
  mesh->GetCellData()->RemoveArray("StellarGen");
  writeMesh(mesh, place.at("b.stl"), notes);
  EXPECT_EQ(allOf(notes),
    "STL does not keep: the values StellarMoved, the values CurveId, the values CurveParam, the values "
    "Feature, the "
    "values temperature, the values StellarVersion\n");
}

// Faces keep their groups: those of a name that comes again, and those before the first one.
TEST(Obj, GroupsComeBackByName)
{
  const Place place;
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n", face = "f 1 2 3\n";
  const std::string file = place.put(
    "in.obj", points + face + "g left arm\n" + face + face + "g head\n" + face + "g left arm\n" + face);
  const auto groupsOf = [](vtkPolyData* mesh)
  {
    auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("GroupNames"));
    vtkDataArray* ids = mesh->GetCellData()->GetArray("GroupIds");
    std::vector<std::string> groups;
    for (vtkIdType i = 0; names && ids && i < mesh->GetNumberOfPolys(); ++i)
    {
      groups.push_back(names->GetValue(static_cast<vtkIdType>(ids->GetComponent(i, 0))));
    }
    return groups;
  };
  Notes notes;
  const auto mesh = readMesh(file, notes);
  const std::vector<std::string> told = { "default", "left arm", "left arm", "head", "left arm" };
  EXPECT_EQ(groupsOf(mesh), told);
  EXPECT_EQ(groupsOf(through(place, "out.obj", mesh, notes)), told);
  EXPECT_EQ(notes, Notes());
  through(place, "out.off", mesh, notes);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("groups"), std::string::npos) << notes[0];
}
