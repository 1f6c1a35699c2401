// Meshes of parts that wear pictures of their own, written and read again.
#include "Harness/shapes.h"
#include "files.h"
#include "made_files.h"
#include "mesh_file.h"
#include "texture.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <set>
#include <thread>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace oversketch_files;
using oversketch_files_test::pictureOfGrey;

namespace
{

// A folder that goes with the test.
class Folder
{
public:
  Folder()
    : Path(fs::temp_directory_path() / (std::to_string(::getpid()) + "-pieces"))
  {
    fs::create_directory(this->Path);
  }
  ~Folder() { fs::remove_all(this->Path); }
  std::string at(const std::string& name) const { return (this->Path / name).string(); }

private:
  fs::path Path;
};

// Strips of quads and triangles, one a part, each on the one before it, faces of the parts in turn; parts of
// an even number wear a picture.
vtkSmartPointer<vtkPolyData> strips(int parts, vtkIdType length)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetName("TCoords");
  coordinates->SetNumberOfComponents(2);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("PartId");
  vtkNew<vtkCellArray> polys;
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  for (int part = 0; part < parts; ++part)
  {
    for (vtkIdType i = 0; i <= length; ++i)
    {
      for (int side = 0; side < 2; ++side)
      {
        points->InsertNextPoint(static_cast<double>(i), part + side, 0.1 * static_cast<double>(i * i));
        coordinates->InsertNextTuple2(static_cast<double>(i) / 7.0, 0.25 * (part + side));
      }
    }
    vtkNew<vtkUnsignedCharArray> picture;
    const std::string bytes = pictureOfGrey(static_cast<unsigned char>(part));
    picture->SetName(("Part" + std::to_string(part) + ".Texture").c_str());
    for (const char byte : bytes)
    {
      picture->InsertNextValue(static_cast<unsigned char>(byte));
    }
    if (part % 2 == 0)
    {
      mesh->GetFieldData()->AddArray(picture);
    }
  }
  for (vtkIdType i = 0; i < length; ++i)
  {
    for (int part = 0; part < parts; ++part)
    {
      const vtkIdType at = 2 * (part * (length + 1) + i);
      const vtkIdType corners[4] = { at, at + 2, at + 3, at + 1 };
      polys->InsertNextCell(i % 2 == 0 ? 4 : 3, corners);
      numbers->InsertNextValue(part);
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  mesh->GetPointData()->SetTCoords(coordinates);
  mesh->GetCellData()->AddArray(numbers);
  return mesh;
}

// Each face as its corners' places and texture coordinates, in single precision, behind its material.
using Corner = std::array<float, 5>;
using Faces = std::multiset<std::pair<std::string, std::vector<Corner>>>;

Faces facesOf(vtkPolyData* mesh, const std::function<std::string(vtkIdType)>& material)
{
  Faces faces;
  vtkNew<vtkIdList> ids;
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    std::vector<Corner> corners;
    for (const vtkIdType id : *ids)
    {
      double p[3];
      mesh->GetPoint(id, p);
      corners.push_back({ static_cast<float>(p[0]),
        static_cast<float>(p[1]),
        static_cast<float>(p[2]),
        static_cast<float>(coordinates->GetComponent(id, 0)),
        static_cast<float>(coordinates->GetComponent(id, 1)) });
    }
    faces.emplace(material(face), corners);
  }
  return faces;
}

} // namespace

TEST(C15_4, AnObjItsMaterialsAndPicturesReloadTheSame)
{
  const Folder folder;
  const int parts = 5;
  const auto mesh = strips(parts, 40);
  Notes notes;
  writeMesh(mesh, folder.at("strips.obj"), notes);
  const auto read = readObj(folder.at("strips.obj"), notes);
  ASSERT_EQ(read->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  EXPECT_EQ(read->GetNumberOfPoints(), mesh->GetNumberOfPoints());
  auto* names = vtkStringArray::SafeDownCast(read->GetFieldData()->GetAbstractArray("MaterialNames"));
  vtkDataArray* worn = read->GetCellData()->GetArray("MaterialIds");
  ASSERT_TRUE(names && worn);
  vtkDataArray* numbers = mesh->GetCellData()->GetArray("PartId");
  const Faces before = facesOf(mesh,
    [&](vtkIdType face)
    { return "part" + std::to_string(static_cast<int>(numbers->GetComponent(face, 0))); });
  EXPECT_EQ(
    facesOf(read,
      [&](vtkIdType face) { return names->GetValue(static_cast<vtkIdType>(worn->GetComponent(face, 0))); }),
    before);
  for (int part = 0; part < parts; ++part)
  {
    const std::string picture = "strips_part" + std::to_string(part) + ".png";
    EXPECT_EQ(
      wholeFile(folder.at(picture)), part % 2 == 0 ? pictureOfGrey(static_cast<unsigned char>(part)) : "");
    const std::string library = wholeFile(folder.at("strips.mtl"));
    EXPECT_EQ(library.find("map_Kd " + picture) != std::string::npos, part % 2 == 0);
  }
  std::ostringstream figure;
  figure << parts << " parts, " << mesh->GetNumberOfPolys()
         << " faces, as OBJ, MTL and pictures: " << read->GetNumberOfPoints()
         << " points again, each face with its part's material and its corners' places and coordinates";
  oversketch_test::fact("C15_4", figure.str());
}

TEST(Pieces, AreThePartsOrTheWhole)
{
  const auto mesh = strips(3, 6);
  const std::vector<Piece> pieces = piecesOf(mesh);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[1].name, "part1");
  EXPECT_EQ(pieces[1].picture, "");
  EXPECT_EQ(pieces[2].picture, pictureOfGrey(2));
  EXPECT_EQ(pieces[2].mesh->GetNumberOfPoints(), 14);
  EXPECT_EQ(pieces[2].mesh->GetNumberOfPolys(), 6);
  EXPECT_EQ(pictureArrays(mesh).size(), 3u) << "two pictures and PartId";

  const auto isWhole = [](vtkPolyData* whole, const std::string& picture)
  {
    const std::vector<Piece> one = piecesOf(whole);
    return one.size() == 1 && one[0].mesh == whole && one[0].name.empty() && one[0].picture == picture;
  };
  const auto bare = strips(2, 4);
  bare->GetFieldData()->RemoveArray("Part0.Texture");
  EXPECT_TRUE(isWhole(bare, "")) << "no part has a picture";
  setTexture(bare, pictureOfGrey(9));
  EXPECT_TRUE(isWhole(bare, pictureOfGrey(9)));
  const auto without = strips(2, 4);
  without->GetPointData()->SetTCoords(nullptr);
  EXPECT_TRUE(isWhole(without, "")) << "a picture without coordinates";
  const auto spoilt = strips(2, 4);
  spoilt->GetCellData()->GetArray("PartId")->Resize(3);
  EXPECT_TRUE(isWhole(spoilt, "")) << "PartId of three faces";
  EXPECT_EQ(withoutParts(spoilt, { 0 }).Get(), spoilt.Get()) << "all of it is gone";
}

// The process keeps one error of all threads.
TEST(Pictures, ErrorsOfOtherThreadsAreNotThoseOfAPicture)
{
  catchMessages();
  takeError();
  const std::string good = pictureOfGrey<vtkJPEGWriter>(99, 512);
  std::string damaged = good;
  damaged[damaged.find("\xff\xda") + 4] = 9; // of so many components
  EXPECT_FALSE(pictureOf(damaged));
  EXPECT_EQ(takeError(), "") << "a picture's error is left to others";
  std::atomic<bool> done{ false };
  std::thread other(
    [&done]
    {
      const vtkNew<vtkPoints> points;
      while (!done)
      {
        vtkErrorWithObjectMacro(points.Get(), "another's");
      }
    });
  int decoded = 0, refused = 0;
  for (int i = 0; i < 300; ++i)
  {
    decoded += pictureOf(good) ? 1 : 0;
    refused += pictureOf(damaged) ? 0 : 1;
  }
  done = true;
  other.join();
  EXPECT_EQ(decoded, 300);
  EXPECT_EQ(refused, 300);
  EXPECT_EQ(takeError(), "another's") << "taken by a picture";
}
