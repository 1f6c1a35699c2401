// What every system has: named steps that are run, timed, heard and cancelled.
#include "Harness/promises.h"
#include "Harness/shapes.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchStepRunner.h"
#include "vtkOversketchSystem.h"

#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace oversketch_test;
using oversketch::Failure;

namespace
{

// Passes its mesh on with one point more, whatever it is told to say.
class Adder : public vtkPolyDataAlgorithm
{
public:
  static Adder* New();
  vtkTypeMacro(Adder, vtkPolyDataAlgorithm);
  int runs = 0;
  bool fails = false, warns = false;

protected:
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    ++this->runs;
    return oversketch::RunFilter(this,
      [&]
      {
        this->UpdateProgress(0.5);
        if (this->warns)
        {
          vtkWarningMacro("Something is odd.");
        }
        if (this->fails)
        {
          throw oversketch::Error(Failure::BadRegion, "The region is empty.");
        }
        vtkPolyData* output = vtkPolyData::GetData(outputs);
        vtkNew<vtkPoints> points;
        points->DeepCopy(vtkPolyData::GetData(inputs[0])->GetPoints());
        points->InsertNextPoint(0.0, 0.0, 0.0);
        output->SetPoints(points);
      });
  }
};
vtkStandardNewMacro(Adder);

// Two steps and one that repeats the second.
class Twice : public vtkOversketchSystem
{
public:
  static Twice* New();
  vtkTypeMacro(Twice, vtkOversketchSystem);
  vtkNew<Adder> first, second, again;
  int handed = -1;
  FigureList Figures() override
  {
    return { { "first.ran", true },
      { "first.runs", this->first->runs },
      { "share", 0.25 },
      { "words", std::vector<std::string>{ "one" } } };
  }

protected:
  Twice()
  {
    this->second->SetInputConnection(this->first->GetOutputPort());
    this->again->SetInputConnection(this->second->GetOutputPort());
    this->AddStage("First", this->first, 0.25);
    this->AddStage("Second", this->second, 0.25);
    this->AddStage("SecondAgain", this->again, 0.5, Listed::No);
  }
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    return this->RunSystem(
      [&]
      {
        this->first->SetInputData(vtkPolyData::GetData(inputs[0]));
        for (const char* name : { "First", "Second", "SecondAgain" })
        {
          this->RunStage(name);
        }
        vtkPolyData::GetData(outputs)->ShallowCopy(this->StageOutput("SecondAgain"));
      });
  }
  void BackendChanged() override { this->handed = this->GetBackend(); }
};
vtkStandardNewMacro(Twice);

struct System : testing::Test
{
  System()
  {
    this->system->SetInputData(this->mesh);
    vtkNew<vtkCallbackCommand> watch;
    watch->SetClientData(this);
    watch->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* share)
      {
        auto* test = static_cast<System*>(self);
        test->shares.push_back(*static_cast<double*>(share));
        test->stages.emplace_back(test->system->GetStageName());
      });
    this->system->AddObserver(vtkCommand::ProgressEvent, watch);
  }
  vtkSmartPointer<vtkPolyData> mesh = toPolyData(icosphere(1, 1.0));
  vtkNew<Twice> system;
  std::vector<double> shares;
  std::vector<std::string> stages;
};

} // namespace

TEST_F(System, RunsItsStepsInTheirOrderAndAddsUpTheirProgress)
{
  this->system->Update();
  EXPECT_EQ(this->system->GetErrorCode(), 0u);
  EXPECT_EQ(this->system->GetOutput()->GetNumberOfPoints(), this->mesh->GetNumberOfPoints() + 3);
  std::vector<double> inside;
  for (std::size_t i = 0; i < this->shares.size(); ++i)
  {
    if (!this->stages[i].empty())
    {
      inside.push_back(this->shares[i]);
    }
  }
  EXPECT_TRUE(std::is_sorted(inside.begin(), inside.end()));
  for (const double half : { 0.125, 0.375, 0.75 }) // half of each step
  {
    EXPECT_NE(std::find(inside.begin(), inside.end(), half), inside.end()) << half;
  }
  EXPECT_STREQ(this->system->GetStageName(), "");
  EXPECT_GT(this->system->GetStageTime("First"), 0.0);
  EXPECT_EQ(this->system->GetStageTime("Third"), 0.0);
}

TEST_F(System, NamesItsStepsAndListsTheOutputsThatAreItsOwn)
{
  this->system->Update();
  ASSERT_EQ(this->system->GetNumberOfStages(), 3);
  EXPECT_STREQ(this->system->GetStage(2), "SecondAgain");
  EXPECT_EQ(this->system->GetStage(3), nullptr);
  EXPECT_EQ(this->system->GetStage(-1), nullptr);
  ASSERT_EQ(this->system->GetNumberOfInnerOutputs(), 2);
  EXPECT_STREQ(this->system->GetInnerOutputName(1), "Second");
  EXPECT_EQ(this->system->GetInnerOutputName(2), nullptr);
  EXPECT_EQ(this->system->GetStep("Second"), this->system->second.Get());
  EXPECT_EQ(this->system->GetStep("Third"), nullptr);
  EXPECT_EQ(this->system->GetInnerOutput("First")->GetNumberOfPoints(), this->mesh->GetNumberOfPoints() + 1);
  EXPECT_EQ(this->system->GetInnerOutput(nullptr), nullptr);
}

TEST_F(System, AChangedStepRunsAndWhatComesAfterIt)
{
  this->system->Update();
  this->system->second->Modified();
  this->system->Update();
  EXPECT_EQ(this->system->first->runs, 1);
  EXPECT_EQ(this->system->second->runs, 2);
  EXPECT_EQ(this->system->again->runs, 2);
}

TEST_F(System, FailsAsItsStepDoesOnceAndRunsAgain)
{
  this->system->second->fails = true;
  Ear ear(this->system);
  this->system->Update();
  ASSERT_EQ(ear.errors.size(), 1u);
  EXPECT_NE(ear.errors[0].find("The region is empty."), std::string::npos) << ear.errors[0];
  EXPECT_EQ(this->system->GetErrorCode(), codeOf(Failure::BadRegion));
  EXPECT_EQ(this->system->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->system->again->runs, 0);
  this->system->second->fails = false; // without Modified(): it has not done its work
  this->system->Modified();
  this->system->Update();
  EXPECT_EQ(this->system->GetErrorCode(), 0u);
  EXPECT_EQ(this->system->GetOutput()->GetNumberOfPoints(), this->mesh->GetNumberOfPoints() + 3);
}

TEST_F(System, PassesWarningsOn)
{
  this->system->second->warns = true;
  Ear ear(this->system);
  this->system->Update();
  ASSERT_EQ(ear.warnings.size(), 1u);
  EXPECT_NE(ear.warnings[0].find("Something is odd."), std::string::npos);
  EXPECT_TRUE(ear.errors.empty());
}

TEST_F(System, StopsInTheStepThatRuns)
{
  expectCancel(this->system);
  this->system->Modified();
  this->system->Update();
  EXPECT_EQ(this->system->GetOutput()->GetNumberOfPoints(), this->mesh->GetNumberOfPoints() + 3);
}

TEST_F(System, GivesItsFiguresAsNumbersByTheirNames)
{
  this->system->Update();
  EXPECT_EQ(this->system->GetFigure("first.ran"), 1.0);
  EXPECT_EQ(this->system->GetFigure("first.runs"), 1.0);
  EXPECT_EQ(this->system->GetFigure("share"), 0.25);
  for (const char* none : { "words", "first", "cats", static_cast<const char*>(nullptr) })
  {
    EXPECT_TRUE(std::isnan(this->system->GetFigure(none)));
  }
}

TEST_F(System, HandsItsBackendOnAndSaysNoToWhatItHasNot)
{
  this->system->SetBackend(99);
  EXPECT_EQ(this->system->GetBackend(), Twice::Host);
  EXPECT_EQ(this->system->handed, Twice::Host);
  EXPECT_EQ(this->system->GetBackendUsed(), Twice::Host);
  this->system->Update();
  EXPECT_FALSE(this->system->Prepare());
  vtkNew<vtkPolyData> some;
  some->DeepCopy(this->mesh);
  EXPECT_FALSE(this->system->Preview(this->mesh, this->mesh, some));
  EXPECT_EQ(some->GetNumberOfPoints(), 0);
  some->DeepCopy(this->mesh);
  this->system->GetHold(some);
  EXPECT_EQ(some->GetNumberOfPoints(), 0);
  some->DeepCopy(this->mesh);
  this->system->GetRegion(some);
  EXPECT_EQ(some->GetNumberOfPoints(), 0);
  const double by[3] = { 1.0, 0.0, 0.0 };
  vtkNew<vtkPoints> points;
  EXPECT_FALSE(this->system->Drag(by, points));
}

// The runner by itself.
TEST(StepRunner, ThrowsTheFirstErrorWithItsCodeAndInnerStepWithoutOne)
{
  vtkNew<Adder> step;
  step->fails = true;
  step->SetInputData(toPolyData(icosphere(1, 1.0)));
  oversketch::StepRunner runner(step, {});
  const auto failureOf = [&](const std::function<void()>& work)
  {
    try
    {
      runner.Run(work);
    }
    catch (const oversketch::Error& error)
    {
      return std::make_pair(error.failure(), std::string(error.what()));
    }
    return std::make_pair(Failure::Unexpected, std::string("nothing was thrown"));
  };
  EXPECT_EQ(failureOf([&] { step->Update(); }),
    std::make_pair(Failure::BadRegion, std::string("The region is empty.")));
  step->fails = false;
  step->Update();
  EXPECT_EQ(failureOf(
              [&]
              {
                vtkErrorWithObjectMacro(step, << "One.");
                vtkErrorWithObjectMacro(step, << "Two.");
              }),
    std::make_pair(Failure::InnerStep, std::string("One.")));
}

TEST(StepRunner, ACancelIsAskedForBeforeAndWhileTheStepRuns)
{
  vtkNew<Adder> step;
  step->SetInputData(toPolyData(icosphere(1, 1.0)));
  bool stop = true;
  oversketch::StepRunner::Listener listener;
  listener.cancelled = [&] { return stop; };
  std::vector<double> told;
  oversketch::StepRunner runner(step, listener);
  EXPECT_THROW(runner.Run(), oversketch::Error);
  EXPECT_EQ(step->runs, 0);
  stop = false;
  runner.Run();
  EXPECT_EQ(step->runs, 1);
  EXPECT_GT(step->GetOutput()->GetNumberOfPoints(), 0);
}
