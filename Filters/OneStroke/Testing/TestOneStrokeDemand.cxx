// The one-stroke system re-runs what changed and nothing else.
#include "Harness/shipped.h"

#include "vtkOversketchLaplacianDeform.h"
#include "vtkOversketchMixtureRegion.h"
#include "vtkOversketchOneStroke.h"
#include "vtkOversketchShapeDiameter.h"
#include "vtkOversketchTargets.h"

#include "vtkFloatArray.h"

#include <gtest/gtest.h>

using namespace oversketch_test;

namespace
{

// Counts how often each inner step executes.
struct Executions
{
  explicit Executions(vtkOversketchOneStroke* system)
  {
    for (const char* name : names())
    {
      vtkNew<vtkCallbackCommand> command;
      command->SetClientData(&this->count[name]);
      command->SetCallback([](vtkObject*, unsigned long, void* n, void*) { ++*static_cast<int*>(n); });
      system->GetStep(name)->AddObserver(vtkCommand::StartEvent, command);
    }
  }
  static std::vector<const char*> names()
  {
    return { "Stroke",
      "Silhouette",
      "Snake",
      "Visibility",
      "Outline",
      "Match",
      "Targets",
      "ShapeDiameter",
      "MixtureRegion",
      "RegionBorder",
      "Deform",
      "Stretch",
      "DeformRemeshed",
      "Restore" };
  }
  void reset()
  {
    for (auto& entry : this->count)
    {
      entry.second = 0;
    }
  }
  int total() const
  {
    int sum = 0;
    for (const auto& entry : this->count)
    {
      sum += entry.second;
    }
    return sum;
  }
  std::map<std::string, int> count;
};

struct Demand : testing::Test
{
  Demand()
    : executions(this->filter)
  {
    this->filter->SetInputData(0, this->mesh);
    this->filter->SetStrokeData(this->stroke);
    this->filter->SetRemeshToOff();
    this->filter->Update();
    EXPECT_EQ(this->filter->GetErrorCode(), 0u);
    this->executions.reset();
    this->rays = this->sdf()->GetRayCastCount();
    this->fits = this->mixture()->GetWholeFitCount();
    this->factors = this->deform()->GetFactorizationCount();
  }
  vtkOversketchShapeDiameter* sdf()
  {
    return vtkOversketchShapeDiameter::SafeDownCast(this->filter->GetStep("ShapeDiameter"));
  }
  vtkOversketchMixtureRegion* mixture()
  {
    return vtkOversketchMixtureRegion::SafeDownCast(this->filter->GetStep("MixtureRegion"));
  }
  vtkOversketchLaplacianDeform* deform()
  {
    return vtkOversketchLaplacianDeform::SafeDownCast(this->filter->GetStep("Deform"));
  }

  vtkSmartPointer<vtkPolyData> mesh = shippedModel("dog");
  vtkSmartPointer<vtkPolyData> stroke = shippedStroke("dog_longer_leg");
  vtkNew<vtkOversketchOneStroke> filter;
  Executions executions;
  vtkIdType rays = 0, fits = 0, factors = 0;
};

// The stroke with its samples moved by (dx, dy) px in the middle, ends in place: same section, other targets.
vtkSmartPointer<vtkPolyData> bulged(vtkPolyData* stroke, double dx, double dy)
{
  auto other = vtkSmartPointer<vtkPolyData>::New();
  other->DeepCopy(stroke);
  const vtkIdType n = other->GetNumberOfPoints();
  for (vtkIdType i = 0; i < n; ++i)
  {
    double p[3];
    other->GetPoint(i, p);
    const double s = std::sin(pi * static_cast<double>(i) / static_cast<double>(n - 1));
    other->GetPoints()->SetPoint(i, p[0] + dx * s * s, p[1] + dy * s * s, p[2]);
  }
  return other;
}

} // namespace

TEST_F(Demand, ANewStrokeCastsNoRaysFitsNoWholeMixtureAndKeepsTheSilhouette)
{
  this->filter->SetStrokeData(bulged(this->stroke, 4, -6));
  this->filter->Update();
  ASSERT_EQ(this->filter->GetErrorCode(), 0u);
  EXPECT_EQ(this->sdf()->GetRayCastCount(), this->rays);
  EXPECT_EQ(this->mixture()->GetWholeFitCount(), this->fits);
  for (const char* name : { "Silhouette", "Snake", "Visibility", "Outline", "ShapeDiameter" })
  {
    EXPECT_EQ(this->executions.count[name], 0) << name;
  }
  for (const char* name : { "Stroke", "Match", "Targets", "MixtureRegion", "RegionBorder", "Deform" })
  {
    EXPECT_EQ(this->executions.count[name], 1) << name;
  }
}

TEST_F(Demand, AMovedTargetOfTheSameSectionReusesTheFactorisation)
{
  // Another merging ratio moves the targets and leaves section and region alone.
  vtkOversketchTargets::SafeDownCast(this->filter->GetStep("Targets"))->SetOmega(0.3);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(this->filter->GetOutput());
  this->filter->Update();
  ASSERT_EQ(this->filter->GetErrorCode(), 0u);
  EXPECT_GT(largestMove(before, this->filter->GetOutput()), 0.0);
  EXPECT_EQ(this->deform()->GetFactorizationCount(), this->factors);
  EXPECT_EQ(this->executions.count["Match"], 0);
}

TEST_F(Demand, AChangedColourRerunsNothingAndComesThrough)
{
  vtkNew<vtkPolyData> coloured;
  coloured->ShallowCopy(this->mesh);
  vtkNew<vtkFloatArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfTuples(this->mesh->GetNumberOfPoints());
  colour->FillComponent(0, 0.25);
  coloured->GetPointData()->AddArray(colour);
  this->filter->SetInputData(0, coloured);
  this->filter->Update();
  EXPECT_EQ(this->executions.total(), 0);
  ASSERT_NE(this->filter->GetOutput()->GetPointData()->GetArray("Colour"), nullptr);
  EXPECT_EQ(this->filter->GetOutput()->GetPointData()->GetArray("Colour")->GetComponent(5, 0), 0.25);
}

TEST_F(Demand, NothingChangedRunsNothing)
{
  this->filter->Update();
  EXPECT_EQ(this->executions.total(), 0);
}

TEST_F(Demand, AParameterOfAStepRunsThatStepAndWhatIsBelow)
{
  this->filter->SetAdjustNormals(true);
  this->filter->Update();
  EXPECT_EQ(this->executions.count["Deform"], 1);
  EXPECT_EQ(this->executions.total(), 1);
}

TEST_F(Demand, AMovedPointOfTheMeshRunsEverythingAgain)
{
  vtkNew<vtkPolyData> other;
  other->DeepCopy(this->mesh);
  double p[3];
  other->GetPoint(0, p);
  other->GetPoints()->SetPoint(0, p[0] + 1e-4, p[1], p[2]);
  this->filter->SetInputData(0, other);
  this->filter->Update();
  EXPECT_EQ(this->sdf()->GetRayCastCount(), this->rays + 1);
  EXPECT_EQ(this->mixture()->GetWholeFitCount(), this->fits + 1);
}
