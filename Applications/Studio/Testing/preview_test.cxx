// The mesh under the hand: its normals are those of its shape.
#include "preview.h"

#include "../../Session/Testing/sessions.h"

#include "vtkOversketchFilterTools.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

using namespace oversketch_session;
using namespace oversketch_studio;
using namespace oversketch_test;

namespace
{

vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData* mesh)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(mesh);
  vtkNew<vtkFloatArray> array;
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  for (const oversketch::Vector3& normal : oversketch::vertexNormals(oversketch::MeshOf(mesh)))
  {
    array->InsertNextTuple(normal.data());
  }
  copy->GetPointData()->SetNormals(array);
  return copy;
}

} // namespace

TEST(Preview, NormalsAreThoseOfTheMovedMesh)
{
  Session session = dogSession();
  session.nodes.pop_back();
  std::vector<Outcome> outcomes;
  Evaluator evaluator;
  ASSERT_TRUE(evaluator.run(session, {}, outcomes));
  ASSERT_TRUE(evaluator.details(outcomes, {}));
  ASSERT_TRUE(outcomes[0].details && outcomes[0].details->following);
  const auto rest = withNormals(outcomes[0].mesh), kept = withNormals(outcomes[0].mesh);
  Preview preview(rest, outcomes[0].details->following);
  vtkNew<vtkPolyData> bare;
  for (const double by : { 0.1, -0.2, 0.0 })
  {
    const double vector[3] = { by, 0.5 * by, 0.0 };
    preview.moveTo(vector);
    bare->SetPoints(preview.mesh()->GetPoints());
    bare->SetPolys(preview.mesh()->GetPolys());
    const auto expected = withNormals(bare);
    vtkDataArray *is = preview.mesh()->GetPointData()->GetNormals(),
                 *should = expected->GetPointData()->GetNormals(),
                 *before = kept->GetPointData()->GetNormals();
    double worst = 0.0, turned = 0.0;
    for (vtkIdType i = 0; i < is->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        worst = std::max(worst, std::abs(is->GetComponent(i, c) - should->GetComponent(i, c)));
        turned = std::max(turned, std::abs(is->GetComponent(i, c) - before->GetComponent(i, c)));
      }
    }
    EXPECT_LT(worst, 1e-5) << by;
    EXPECT_EQ(turned > 0.1, by != 0.0) << by;
    EXPECT_EQ(largestMove(preview.mesh(), rest) > 0.05, by != 0.0);
  }
  EXPECT_TRUE(identical(rest, kept)) << "the mesh at rest has changed";
}
