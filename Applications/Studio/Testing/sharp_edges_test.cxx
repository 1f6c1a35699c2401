// Which models are drawn with edges: solids that have some, however finely they are divided, and no animals.
#include "mesh_file.h"
#include "point_normals.h"
#include "sharp_edges.h"
#include "solids.h"

#include "Harness/data.h"
#include "Harness/polydata.h"
#include "Harness/shapes.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangle.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

using namespace oversketch_files;
using namespace oversketch_studio;
using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkPolyData> shown(const Mesh& mesh)
{
  return withPointNormals(toPolyData(mesh));
}

// The points that an edge's sides do not share any more.
vtkIdType split(const vtkSmartPointer<vtkPolyData>& mesh)
{
  const auto look = SharpEdges().look(mesh);
  EXPECT_EQ(look->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  return look->GetNumberOfPoints() - mesh->GetNumberOfPoints();
}

} // namespace

TEST(SharpEdges, OfSolidsAreSeenHoweverFinelyTheyAreDivided)
{
  for (const int n : { 1, 2, 4, 10, 30, 100 })
  {
    // Twice along each edge, thrice at corners.
    EXPECT_EQ(split(shown(boxOf(n))), 12 * (n - 1) + 8 * 2) << n << " squares a side";
  }
  for (const auto& [around, along] : { std::pair(16, 1), std::pair(32, 10), std::pair(200, 100) })
  {
    EXPECT_EQ(split(shown(drumOf(around, along))), 2 * around) << around << " x " << along;
  }
  EXPECT_EQ(split(shown(icosphere(4))), 0);
}

namespace
{

// The least cosine of the angle between a face's normal and those at its corners.
double flatness(vtkPolyData* look)
{
  vtkDataArray* normals = look->GetPointData()->GetNormals();
  vtkNew<vtkIdList> corners;
  double least = 1.0;
  for (vtkIdType cell = 0; cell < look->GetNumberOfCells(); ++cell)
  {
    look->GetCellPoints(cell, corners);
    double place[3][3], flat[3];
    for (int i = 0; i < 3; ++i)
    {
      look->GetPoint(corners->GetId(i), place[i]);
    }
    vtkTriangle::ComputeNormal(place[0], place[1], place[2], flat);
    for (int i = 0; i < 3; ++i)
    {
      least = std::min(least, vtkMath::Dot(flat, normals->GetTuple3(corners->GetId(i))));
    }
  }
  return least;
}

} // namespace

TEST(SharpEdges, StayWhileAHandMovesTheMesh)
{
  const auto mesh = shown(boxOf(100));
  SharpEdges edges;
  const vtkIdType points = edges.look(mesh)->GetNumberOfPoints();
  ASSERT_GT(points, mesh->GetNumberOfPoints());
  vtkNew<vtkPolyData> leaning;
  leaning->DeepCopy(mesh);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double at[3];
    mesh->GetPoint(i, at);
    leaning->GetPoints()->SetPoint(i, at[0] + 0.4 * at[1], at[1], at[2] - 0.2 * at[0]);
  }
  const auto look = edges.lookMoved(leaning);
  ASSERT_EQ(look->GetNumberOfPoints(), points);
  // Each face is as flat as a face of the box, up to its edges.
  EXPECT_GT(flatness(look), 0.9999);
  // A mesh of other faces has its own edges, or none where it is large.
  const auto other = shown(boxOf(99)), small = shown(boxOf(4));
  EXPECT_EQ(edges.lookMoved(other), other);
  EXPECT_EQ(edges.lookMoved(small)->GetNumberOfPoints(), SharpEdges().look(small)->GetNumberOfPoints());
}

// A roof over a line that was drawn on the surface, so steep on both sides; its ridge is one normal a point.
TEST(SharpEdges, OfLinesDrawnOnTheSurfaceAreSeen)
{
  constexpr int n = 8;
  const auto roof = [](double degrees)
  {
    Mesh mesh;
    for (int y = 0; y <= n; ++y)
    {
      for (int x = 0; x <= n; ++x)
      {
        mesh.points.emplace_back(x, y, -std::abs(x - n / 2) * std::tan(vtkMath::RadiansFromDegrees(degrees)));
      }
    }
    for (int y = 0; y < n; ++y)
    {
      for (int x = 0; x < n; ++x)
      {
        const int at = y * (n + 1) + x;
        mesh.triangles.push_back({ at, at + 1, at + n + 2 });
        mesh.triangles.push_back({ at, at + n + 2, at + n + 1 });
      }
    }
    auto made = shown(mesh);
    vtkNew<vtkIntArray> moved;
    moved->SetName("StellarMoved");
    for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
    {
      moved->InsertNextValue(i % (n + 1) == n / 2 ? 6 : 0);
    }
    made->GetPointData()->AddArray(moved);
    return made;
  };
  EXPECT_EQ(split(roof(10.0)), 0);
  const auto steep = roof(35.0);
  ASSERT_EQ(split(steep), n + 1) << "each point of the ridge once more";
  SharpEdges edges;
  const auto look = edges.look(steep);
  EXPECT_EQ(edges.lookMoved(steep)->GetNumberOfPoints(), look->GetNumberOfPoints());
  // Each side is as flat as it is, up to the ridge.
  EXPECT_GT(flatness(look), 0.9999);
}

// Who reads glTF shows a mesh without normals flat, triangle by triangle.
TEST(SharpEdges, AreInGltfFilesAndAllElseIsSmooth)
{
  const QTemporaryDir folder;
  const auto written = [&](vtkPolyData* mesh)
  {
    const QString path = folder.filePath("a \"box\".gltf");
    oversketch_files::Notes notes;
    writeMesh(mesh, path.toStdString(), notes);
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    const QJsonObject document = QJsonDocument::fromJson(file.readAll()).object();
    EXPECT_EQ(document["meshes"][0]["name"].toString(), "a \"box\"");
    return readMesh(path.toStdString(), notes);
  };
  const auto box = written(toPolyData(boxOf(4)));
  ASSERT_TRUE(box->GetPointData()->GetNormals());
  EXPECT_EQ(box->GetNumberOfPoints(), toPolyData(boxOf(4))->GetNumberOfPoints() + 12 * 3 + 8 * 2);
  EXPECT_GT(flatness(box), 0.9999);

  // A ball whose points are split along a seam of its texture.
  const Mesh whole = icosphere(4);
  Mesh cut = whole;
  vtkNew<vtkFloatArray> places;
  places->SetName("TCoords");
  places->SetNumberOfComponents(2);
  for (const Vector3& point : cut.points)
  {
    places->InsertNextTuple2(0.5, 0.5 + 0.5 * point[1]);
  }
  std::map<int, int> copies;
  for (Triangle& triangle : cut.triangles)
  {
    const double x = cut.points[triangle[0]][0] + cut.points[triangle[1]][0] + cut.points[triangle[2]][0];
    for (int& corner : triangle)
    {
      if (x > 0.0)
      {
        const auto [copy, isNew] = copies.insert({ corner, static_cast<int>(cut.points.size()) });
        if (isNew)
        {
          const Vector3 point = cut.points[corner];
          cut.points.push_back(point);
          places->InsertNextTuple2(0.9, 0.5 + 0.5 * point[1]);
        }
        corner = copy->second;
      }
    }
  }
  const auto seamed = toPolyData(cut);
  seamed->GetPointData()->SetTCoords(places);
  const auto ball = written(seamed);
  ASSERT_TRUE(ball->GetPointData()->GetNormals());
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    double normal[3], at[3];
    ball->GetPointData()->GetNormals()->GetTuple(i, normal);
    ball->GetPoint(i, at);
    ASSERT_GT(vtkMath::Dot(normal, at), 0.999) << i << ", at the seam or not";
  }
}

TEST(SharpEdges, OfAnimalsAreNotMade)
{
  std::vector<std::string> paths;
  for (const char* name : { "bear", "dinosaur", "dog", "hand", "octopus", "person" })
  {
    paths.push_back(std::string(OVERSKETCH_DATA_FOLDER "/Models/") + name + ".ply");
  }
  for (const char* name : { "armadillo_29k.obj",
         "bunny_180k.ply",
         "bunny_30k.ply",
         "bunny_5k.obj",
         "cat.off",
         "cow_nc.stl",
         "koala.stl",
         "man.ply",
         "scorpion.ply",
         "spot_1k6.off",
         "spot_5k9.obj" })
  {
    paths.push_back(sharedData(std::string("meshes/") + name));
  }
  int looked = 0;
  for (const std::string& path : paths)
  {
    if (!path.empty())
    {
      oversketch_files::Notes notes;
      const auto mesh = withPointNormals(oversketch_files::readMesh(path, notes));
      EXPECT_EQ(SharpEdges().look(mesh), mesh) << path;
      ++looked;
    }
  }
  EXPECT_GE(looked, 6);
}
