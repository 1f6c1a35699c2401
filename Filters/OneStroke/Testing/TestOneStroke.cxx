// The one-stroke system: what comes out, how it fails, how it is cancelled.
#include "Harness/shipped.h"

#include "Mesh/context.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchMatch.h"
#include "vtkOversketchMixtureRegion.h"
#include "vtkOversketchOneStroke.h"

#include "vtkIdList.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace oversketch_test;

namespace
{

const char* const model = "dog";
const char* const strokeName = "dog_longer_leg";

struct System
{
  System()
  {
    this->filter->SetInputData(0, this->mesh);
    this->filter->SetStrokeData(this->stroke);
  }
  vtkSmartPointer<vtkPolyData> mesh = shippedModel(model);
  vtkSmartPointer<vtkPolyData> stroke = shippedStroke(strokeName);
  vtkNew<vtkOversketchOneStroke> filter;
};

} // namespace

TEST(OneStroke, MovesTheRegionAndNothingElse)
{
  System s;
  s.filter->SetRemeshToOff();
  s.filter->Update();
  ASSERT_EQ(s.filter->GetErrorCode(), 0u);
  vtkPolyData* output = s.filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), s.mesh->GetNumberOfPoints());
  EXPECT_EQ(output->GetPolys(), s.mesh->GetPolys());
  vtkDataArray* region = s.filter->GetInnerOutput("RegionBorder")->GetPointData()->GetArray("Region");
  ASSERT_NE(region, nullptr);
  vtkIdType inside = 0, moved = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Vector3 p, q;
    s.mesh->GetPoint(i, p.data());
    output->GetPoint(i, q.data());
    const bool chosen = region->GetComponent(i, 0) != 0.0;
    inside += chosen;
    moved += p != q;
    EXPECT_TRUE(chosen || p == q) << "point " << i;
  }
  EXPECT_GT(moved, inside / 2);
  EXPECT_LT(inside, s.mesh->GetNumberOfPoints() / 2);
}

// The welded mesh, the stretched one, that one deformed, once more with the outline corrected (and again with
// weaker handles), and the restored one, of which a part is linked to be judged. A mesh that was only
// deformed has the links of the one before it.
TEST(OneStroke, ConvertsAndLinksEachMeshOnceAndTakesNormalsOfTheFirstAlone)
{
  System s;
  s.filter->SetRemeshToOn();
  const oversketch::MeshWork& work = oversketch::MeshWorkDone();
  for (const bool first : { true, false })
  {
    const int conversions = work.Conversions, linkings = work.Linkings, normals = work.Normals;
    s.filter->SetStrokeData(shippedStroke(first ? strokeName : "dog_curled_tail"));
    s.filter->Update();
    ASSERT_EQ(s.filter->GetErrorCode(), 0u);
    EXPECT_LE(work.Conversions - conversions, first ? 6 : 5);
    EXPECT_LE(work.Linkings - linkings, first ? 2 : 1);
    EXPECT_LE(work.Normals - normals, first ? 1 : 0);
  }
}

// The result is the same for any number of threads, cold and cached, from run to run.
TEST(A12_2, SameBitsForOneAndTwoThreadsColdAndCached)
{
  for (const int remesh : { vtkOversketchOneStroke::RemeshOff, vtkOversketchOneStroke::RemeshOn })
  {
    System s;
    s.filter->SetRemesh(remesh);
    vtkSMPTools::Initialize(1);
    s.filter->Update();
    vtkNew<vtkPolyData> cold;
    cold->DeepCopy(s.filter->GetOutput());
    ASSERT_GT(cold->GetNumberOfPoints(), 0);
    s.filter->Modified();
    s.filter->Update();
    EXPECT_TRUE(identical(cold, s.filter->GetOutput())) << "cached";
    System two;
    two.filter->SetRemesh(remesh);
    vtkSMPTools::Initialize(2);
    two.filter->Update();
    EXPECT_TRUE(identical(cold, two.filter->GetOutput())) << "two threads";
  }
  vtkSMPTools::Initialize();
  fact("A12_2", "bit-identical for 1 and 2 threads, cold and cached, with and without remeshing");
}

TEST(OneStroke, RefusesABadStrokeWithOneMessageAndNoStaleOutput)
{
  System s;
  s.filter->Update();
  ASSERT_GT(s.filter->GetOutput()->GetNumberOfPoints(), 0);
  Ear ear(s.filter);
  const View view = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 100);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& samples : std::vector<std::vector<Vector2>>{
         { { 10, 10 }, { 12, 10 } }, { { 10, 10 }, { nan, 10 }, { 60, 40 } }, { { 10, 10 } } })
  {
    ear.errors.clear();
    s.filter->SetStrokeData(toStroke(samples, view));
    for (int again = 0; again < 2; ++again)
    {
      s.filter->Update();
      EXPECT_EQ(s.filter->GetErrorCode(), codeOf(Failure::BadStroke));
      EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0);
    }
    ASSERT_FALSE(ear.errors.empty());
    EXPECT_EQ(ear.errors[0].find("0x0"), std::string::npos);
  }
  auto viewless = toStroke({ { 10, 10 }, { 100, 100 } }, view);
  viewless->GetCellData()->RemoveArray("ViewTransform");
  ear.errors.clear();
  s.filter->SetStrokeData(viewless);
  s.filter->Update();
  ASSERT_EQ(ear.errors.size(), 1u);
  EXPECT_NE(ear.errors[0].find("ViewTransform"), std::string::npos) << ear.errors[0];
  EXPECT_EQ(s.filter->GetErrorCode(), codeOf(Failure::MissingArray));
  s.filter->SetStrokeData(s.stroke);
  s.filter->Update();
  EXPECT_EQ(s.filter->GetErrorCode(), 0u);
  EXPECT_GT(s.filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(OneStroke, RefusesABadMesh)
{
  System s;
  Ear ear(s.filter);
  vtkNew<vtkPolyData> bad;
  bad->DeepCopy(s.mesh);
  bad->GetPoints()->SetPoint(7, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  s.filter->SetInputData(0, bad);
  s.filter->Update();
  ASSERT_EQ(ear.errors.size(), 1u);
  EXPECT_NE(ear.errors[0].find("Point 7"), std::string::npos) << ear.errors[0];
  EXPECT_EQ(s.filter->GetErrorCode(), codeOf(Failure::BadMesh));
  vtkNew<vtkPolyData> empty;
  ear.errors.clear();
  s.filter->SetInputData(0, empty);
  s.filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0);
}

// Match refuses a stroke that is farther than its gate; the system fails with that message and that code.
TEST(OneStroke, AnInnerErrorIsTheSystemsError)
{
  System s;
  Ear ear(s.filter);
  vtkOversketchMatch::SafeDownCast(s.filter->GetStep("Match"))->SetMaximumDistance(0.01);
  s.filter->Update();
  ASSERT_EQ(ear.errors.size(), 1u);
  EXPECT_EQ(s.filter->GetErrorCode(), codeOf(Failure::NoMatch));
  EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0);
  vtkOversketchMatch::SafeDownCast(s.filter->GetStep("Match"))->SetMaximumDistance(0.0);
  s.filter->Update();
  EXPECT_EQ(s.filter->GetErrorCode(), 0u);
  EXPECT_GT(s.filter->GetOutput()->GetNumberOfPoints(), 0);
}

// Cancelled at any point of the run, then tried again: the full result, and no error event.
TEST(OneStroke, CancelThenRetryGivesTheFullResult)
{
  System reference;
  reference.filter->SetRemeshToOn();
  reference.filter->Update();
  for (const double at : { 0.05, 0.2, 0.4, 0.6, 0.8, 0.85 })
  {
    System s;
    s.filter->SetRemeshToOn();
    Ear ear(s.filter);
    vtkNew<vtkCallbackCommand> stop;
    double when = at;
    bool stopped = false;
    std::pair<double*, bool*> data{ &when, &stopped };
    stop->SetClientData(&data);
    stop->SetCallback(
      [](vtkObject* caller, unsigned long, void* client, void*)
      {
        auto* filter = static_cast<vtkAlgorithm*>(caller);
        auto* state = static_cast<std::pair<double*, bool*>*>(client);
        if (filter->GetProgress() >= *state->first)
        {
          filter->SetAbortExecute(1);
          *state->second = true;
        }
      });
    const unsigned long tag = s.filter->AddObserver(vtkCommand::ProgressEvent, stop);
    s.filter->Update();
    EXPECT_TRUE(stopped) << at;
    EXPECT_EQ(s.filter->GetErrorCode(), codeOf(Failure::Cancelled)) << at;
    EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0) << at;
    EXPECT_TRUE(ear.errors.empty()) << at;
    s.filter->RemoveObserver(tag);
    s.filter->Modified();
    s.filter->Update();
    EXPECT_EQ(s.filter->GetErrorCode(), 0u) << at;
    EXPECT_TRUE(identical(reference.filter->GetOutput(), s.filter->GetOutput())) << at;
  }
}

// What no stroke changes is computed before the stroke is there.
TEST(OneStroke, PreparedTheNextRunComputesNoShapeDiameterAndNoMixtureOfTheWhole)
{
  System cold, prepared;
  for (System* s : { &cold, &prepared })
  {
    s->filter->SetRemeshToOff();
  }
  cold.filter->Update();
  EXPECT_TRUE(prepared.filter->Prepare());
  const vtkMTimeType made = prepared.filter->GetInnerOutput("ShapeDiameter")->GetMTime();
  auto* region = vtkOversketchMixtureRegion::SafeDownCast(prepared.filter->GetStep("MixtureRegion"));
  EXPECT_EQ(region->GetWholeFitCount(), 1);
  prepared.filter->Update();
  EXPECT_EQ(region->GetWholeFitCount(), 1);
  EXPECT_EQ(prepared.filter->GetInnerOutput("ShapeDiameter")->GetMTime(), made);
  EXPECT_TRUE(identical(cold.filter->GetOutput(), prepared.filter->GetOutput()));

  vtkNew<vtkOversketchOneStroke> none;
  EXPECT_FALSE(none->Prepare()) << "no mesh";
  vtkNew<vtkPolyData> empty;
  none->SetInputData(0, empty);
  EXPECT_FALSE(none->Prepare()) << "an empty mesh";
}
