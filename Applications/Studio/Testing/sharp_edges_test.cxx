// Which models are drawn with edges: solids that have some, however finely they are divided, and no animals.
#include "mesh_file.h"
#include "models.h"
#include "sharp_edges.h"
#include "solids.h"

#include "Harness/data.h"
#include "Harness/polydata.h"

#include <gtest/gtest.h>

#include <string>

using namespace oversketch_session;
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
