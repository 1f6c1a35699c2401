#include "Harness/data.h"
#include "StellarChain.h"
#include "vtkOversketchFilterTools.h"

#include "vtkOBJReader.h"
#include "vtkPLYReader.h"

#include <gtest/gtest.h>

#include <chrono>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A model of the shared data; null, saying so, where it is absent.
vtkSmartPointer<vtkPolyData> modelOf(const std::string& name)
{
  const std::string path = sharedData("meshes/" + name);
  if (path.empty())
  {
    std::cout << name << " is absent: set OVERSKETCH_DATA\n";
    return nullptr;
  }
  auto model = vtkSmartPointer<vtkPolyData>::New();
  const auto read = [&](auto&& reader)
  {
    reader->SetFileName(path.c_str());
    reader->Update();
    model->ShallowCopy(reader->GetOutput());
  };
  if (name.substr(name.size() - 4) == ".ply")
    read(vtkSmartPointer<vtkPLYReader>::New());
  else
    read(vtkSmartPointer<vtkOBJReader>::New());
  return model;
}

// The model fills most of the picture, from the front.
View viewOf(vtkPolyData* model)
{
  double b[6];
  model->GetBounds(b);
  const Vector3 low(b[0], b[2], b[4]), high(b[1], b[3], b[5]);
  const View at = orthographicView({ 0.3, 0.2, 1 }, { 0, 1, 0 }, 550.0 / (high - low).norm());
  Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
  shift.topRightCorner<3, 1>() = -0.5 * (low + high);
  return View(at.viewTransform() * shift, at.projectionTransform(), 800, 600);
}

} // namespace

TEST(StellarModels, RealModelsGoAllTheWay)
{
  for (const char* name :
    { "bunny_5k.obj", "armadillo_29k.obj", "spot_5k9.obj", "hand_closed.obj", "torus.obj", "man.ply" })
  {
    const auto model = modelOf(name);
    if (!model)
      continue;
    SCOPED_TRACE(name);
    Chain chain(model);
    chain.curves->SetInputData(toStroke(line({ 330, 290 }, { 470, 320 }), viewOf(model)));
    chain.refine->SetRadius(-1.0);
    chain.displace->SetRadius(-1.0);
    chain.displace->SetHeight(0.0);
    chain.simplify->SetRadius(-1.0);
    chain.curves->Update();
    const auto start = std::chrono::steady_clock::now();
    chain.displace->Update();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    chain.simplify->Update();
    ASSERT_EQ(chain.simplify->GetErrorCode(), 0u);
    EXPECT_LT(chain.base->GetUnpaired(), 0.02 * static_cast<double>(model->GetNumberOfCells()));
    EXPECT_LE(chain.snap->GetResidual(), 0.01 * chain.snap->GetCrossings() + 1);
    EXPECT_GT(chain.displace->GetPeak(), 0.98);
    EXPECT_LE(chain.displace->GetPeak(), 1.0);
    vtkNew<vtkOversketchStellarSimplify> again;
    again->SetInputData(0, saved(chain.displace->GetOutput()));
    again->SetInputData(1, saved(chain.curves->GetOutput()));
    again->Update();
    expectSameMesh(again->GetOutput(), chain.simplify->GetOutput());
    std::cout << name << ": " << model->GetNumberOfCells() << " triangles, base "
              << chain.base->GetOutput()->GetNumberOfCells() << " (" << chain.base->GetUnpaired()
              << " unpaired), refined " << chain.refine->GetOutput()->GetNumberOfCells() << ", raised "
              << chain.displace->GetOutput()->GetNumberOfCells() << ", simplified "
              << chain.simplify->GetOutput()->GetNumberOfCells() << "; crossings "
              << chain.snap->GetCrossings() << ", residual " << chain.snap->GetResidual() << ", flipped "
              << chain.displace->GetFlippedFaces() << ", cut " << chain.displace->GetIntersectingFaces()
              << "; refine to displace " << seconds << " s\n";
  }
}

TEST(StellarModels, DirtyModelsAreRefusedOrSound)
{
  for (const char* name : { "dirty_degenerate_triangles.ply",
         "dirty_duplicate_vertices.obj",
         "dirty_far_from_origin.obj",
         "dirty_holes.obj",
         "dirty_inside_out.obj",
         "dirty_islands_unreferenced.ply",
         "dirty_klein_bottle.obj",
         "dirty_mixed_polygons.obj",
         "dirty_nan_inf.ply",
         "dirty_nonmanifold_edges.obj",
         "dirty_points_only.ply",
         "dirty_self_intersecting.ply",
         "cad_assembly_nonmanifold.ply",
         "single_triangle.obj" })
  {
    const auto model = modelOf(name);
    if (!model)
      continue;
    SCOPED_TRACE(name);
    vtkNew<vtkOversketchStellarBase> base;
    base->SetInputData(model);
    Ear ear(base);
    base->Update();
    if (base->GetErrorCode() != 0)
    {
      EXPECT_EQ(base->GetErrorCode(), codeOf(Failure::BadMesh));
      ASSERT_EQ(ear.errors.size(), 1u);
      EXPECT_EQ(base->GetOutput()->GetNumberOfPoints(), 0);
      continue;
    }
    EXPECT_TRUE(ear.errors.empty());
    EXPECT_EQ(base->GetOutput()->GetNumberOfCells(), 2 * base->GetPairs() + 3 * base->GetUnpaired());
    vtkNew<vtkOversketchStellarSimplify> rebuilt; // reads all arrays
    rebuilt->SetInputData(0, cold(base->GetOutput()));
    rebuilt->Update();
    EXPECT_EQ(rebuilt->GetErrorCode(), 0u);
  }
}

TEST(D6_2, RealModelsKeepTheirShapeAsCoarseBases)
{
  for (const char* name : { "bunny_5k.obj", "spot_5k9.obj", "armadillo_29k.obj" })
  {
    const auto input = modelOf(name);
    if (!input)
      GTEST_SKIP() << "no shared data";
    vtkNew<vtkOversketchStellarBase> base;
    base->SetInputData(input);
    base->SetModeToSimplified();
    base->Update();
    ASSERT_EQ(base->GetErrorCode(), 0u) << name;
    double box[6];
    input->GetBounds(box);
    const double diagonal = Vector3(box[1] - box[0], box[3] - box[2], box[5] - box[4]).norm();
    Surface original(input), made(base->GetOutput());
    double on = 0.0, off = 0.0;
    for (vtkIdType i = 0; i < base->GetOutput()->GetNumberOfPoints(); ++i)
      on = std::max(on, original.distance(base->GetOutput()->GetPoint(i)) / diagonal);
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
      off = std::max(off, made.distance(input->GetPoint(i)) / diagonal);
    EXPECT_LT(on, 1e-9) << name;
    EXPECT_LT(off, 4e-3) << name;
    const double least = smallestAngle(MeshOf(base->GetOutput()));
    EXPECT_GT(least, 2.5) << name; // none of the models has one under 6
    fact("D6_2",
      std::string(name) + ", filter: " + std::to_string(input->GetNumberOfCells()) + " to " +
        std::to_string(base->GetOutput()->GetNumberOfCells()) + " faces, the mesh's points within " +
        std::to_string(off) + " diagonals of them, smallest angle " + std::to_string(least));
  }
}
