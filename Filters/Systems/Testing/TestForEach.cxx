// Collections: every model gets what the filter alone would make of it, on however many ranks.
#include "Harness/ranks.h"
#include "Harness/shipped.h"

#include "vtkOversketchForEach.h"
#include "vtkOversketchOneStroke.h"

#include "vtkCompositeDataIterator.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkReverseSense.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

using namespace oversketch_test;

namespace
{

// Moves every point of its first input by the first sample of its second; refuses a model with the cell array
// "Refuse" and warns of one with "Warn".
class Mover : public vtkPolyDataAlgorithm
{
public:
  static Mover* New();
  vtkTypeMacro(Mover, vtkPolyDataAlgorithm);
  int runs = 0;
  bool third = false; // moves by the first sample of its third input, too
  void takeAThird()
  {
    this->third = true;
    this->SetNumberOfInputPorts(3);
  }

protected:
  Mover() { this->SetNumberOfInputPorts(2); }
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    ++this->runs;
    vtkPolyData* model = vtkPolyData::GetData(inputs[0]);
    vtkPolyData* stroke = vtkPolyData::GetData(inputs[1]);
    vtkPolyData* output = vtkPolyData::GetData(outputs);
    this->UpdateProgress(0.5);
    if (model->GetCellData()->GetAbstractArray("Refuse"))
    {
      vtkErrorMacro("The model asks to be refused.");
      output->Initialize();
      return 0;
    }
    if (model->GetCellData()->GetAbstractArray("Warn"))
    {
      vtkWarningMacro("The model asks for a warning.");
    }
    output->DeepCopy(model);
    double step[3];
    stroke->GetPoint(0, step);
    if (this->third)
    {
      double more[3];
      vtkPolyData::GetData(inputs[2])->GetPoint(0, more);
      step[0] += more[0];
    }
    for (vtkIdType i = 0; i < model->GetNumberOfPoints(); ++i)
    {
      double p[3];
      model->GetPoint(i, p);
      output->GetPoints()->SetPoint(i, p[0] + step[0], p[1] + step[1], p[2]);
    }
    return 1;
  }
};
vtkStandardNewMacro(Mover);

const View view(Eigen::Matrix4d::Identity(), Eigen::Matrix4d::Identity(), 100, 100);

vtkSmartPointer<vtkPolyData> ball(double radius)
{
  return toPolyData(icosphere(1, radius));
}

vtkSmartPointer<vtkPolyData> strokeFrom(double x, double y)
{
  return toStroke({ { x, y }, { x + 1, y } }, view);
}

void mark(vtkPolyData* model, const char* name)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(model->GetNumberOfCells());
  array->Fill(1);
  model->GetCellData()->AddArray(array);
}

// Three models under two blocks: "first" (balls of radius 1 and, named "two", 2) and a ball of radius 3; the
// place between the blocks is empty.
vtkSmartPointer<vtkMultiBlockDataSet> threeBalls()
{
  auto models = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkMultiBlockDataSet> first;
  first->SetBlock(0, ball(1));
  first->SetBlock(1, ball(2));
  first->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "two");
  models->SetBlock(0, first);
  models->SetBlock(1, nullptr);
  models->SetBlock(2, ball(3));
  return models;
}

std::vector<vtkPolyData*> leavesOf(vtkDataObject* collection)
{
  std::vector<vtkPolyData*> leaves;
  auto* tree = vtkDataObjectTree::SafeDownCast(collection);
  auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    leaves.push_back(vtkPolyData::SafeDownCast(it->GetCurrentDataObject()));
  }
  return leaves;
}

double firstX(vtkPolyData* model)
{
  return model->GetPoint(0)[0];
}

struct ForEach : testing::Test
{
  ForEach()
  {
    this->filter->SetFilter(this->mover);
    this->filter->SetInputDataObject(0, this->models);
  }
  vtkSmartPointer<vtkMultiBlockDataSet> models = threeBalls();
  vtkNew<Mover> mover;
  vtkNew<vtkOversketchForEach> filter;
};

// The collection with each leaf replaced by a stroke that begins at (index, 0).
vtkSmartPointer<vtkMultiBlockDataSet> aStrokeForEach(vtkMultiBlockDataSet* models)
{
  auto strokes = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  strokes->CopyStructure(models);
  auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(models->NewIterator());
  int index = 0;
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    strokes->SetDataSet(it, strokeFrom(++index, 0));
  }
  return strokes;
}

} // namespace

TEST_F(ForEach, OneStrokeMovesAllAndStructureNamesAndFieldDataStay)
{
  vtkNew<vtkIntArray> year;
  year->SetName("Year");
  year->InsertNextValue(2019);
  this->models->GetFieldData()->AddArray(year);
  this->filter->SetStrokeData(strokeFrom(10, 0));
  this->filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(this->filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(this->filter->GetErrorCode(), 0u);
  EXPECT_EQ(this->filter->GetNumberOfFailures(), 0);
  ASSERT_EQ(output->GetNumberOfBlocks(), 3u);
  EXPECT_EQ(output->GetBlock(1), nullptr);
  auto* first = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(0));
  ASSERT_NE(first, nullptr);
  EXPECT_STREQ(first->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME()), "two");
  EXPECT_NE(output->GetFieldData()->GetAbstractArray("Year"), nullptr);
  const auto before = leavesOf(this->models), after = leavesOf(output);
  ASSERT_EQ(after.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_DOUBLE_EQ(firstX(after[i]), firstX(before[i]) + 10);
  }
}

TEST_F(ForEach, StrokesPairByPlace)
{
  this->filter->SetStrokeData(aStrokeForEach(this->models));
  this->filter->Update();
  const auto before = leavesOf(this->models), after = leavesOf(this->filter->GetOutputDataObject(0));
  ASSERT_EQ(after.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_DOUBLE_EQ(firstX(after[i]), firstX(before[i]) + static_cast<double>(i + 1));
  }
}

TEST_F(ForEach, PartitionsOfACollectionPairToo)
{
  vtkNew<vtkPartitionedDataSetCollection> collection, strokes;
  vtkNew<vtkPartitionedDataSet> parts, drawn;
  for (unsigned int i = 0; i < 4; ++i)
  {
    parts->SetPartition(i, i == 2 ? nullptr : ball(i + 1).Get());
    drawn->SetPartition(i, strokeFrom(i, 0));
  }
  collection->SetPartitionedDataSet(0, parts);
  strokes->SetPartitionedDataSet(0, drawn);
  this->filter->SetInputDataObject(0, collection);
  this->filter->SetStrokeData(strokes);
  this->filter->Update();
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(this->filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  vtkPartitionedDataSet* made = output->GetPartitionedDataSet(0);
  ASSERT_EQ(made->GetNumberOfPartitions(), 4u);
  EXPECT_EQ(made->GetPartitionAsDataObject(2), nullptr);
  for (const unsigned int i : { 0u, 1u, 3u })
  {
    auto* leaf = vtkPolyData::SafeDownCast(made->GetPartitionAsDataObject(i));
    EXPECT_DOUBLE_EQ(firstX(leaf), firstX(ball(i + 1)) + i) << i;
  }
}

TEST_F(ForEach, ARefusedModelIsNamedAndTheOthersGoOn)
{
  auto* first = vtkMultiBlockDataSet::SafeDownCast(this->models->GetBlock(0));
  mark(vtkPolyData::SafeDownCast(first->GetBlock(1)), "Refuse");
  mark(vtkPolyData::SafeDownCast(this->models->GetBlock(2)), "Warn");
  this->filter->SetStrokeData(strokeFrom(10, 0));
  for (int run = 0; run < 2; ++run)
  {
    Ear ear(this->filter);
    this->filter->Modified();
    this->filter->Update();
    ASSERT_EQ(ear.errors.size(), 1u);
    EXPECT_NE(ear.errors[0].find("leaf 3 (two): The model asks to be refused."), std::string::npos)
      << ear.errors[0];
    ASSERT_EQ(ear.warnings.size(), 1u);
    EXPECT_NE(ear.warnings[0].find("leaf 5: The model asks for a warning."), std::string::npos)
      << ear.warnings[0];
    EXPECT_EQ(this->filter->GetNumberOfFailures(), 1);
    EXPECT_EQ(this->filter->GetErrorCode(), codeOf(oversketch::Failure::InnerStep));
    const auto after = leavesOf(this->filter->GetOutputDataObject(0));
    ASSERT_EQ(after.size(), 3u);
    EXPECT_DOUBLE_EQ(firstX(after[0]), firstX(ball(1)) + 10);
    EXPECT_EQ(after[1]->GetNumberOfPoints(), 0);
    EXPECT_DOUBLE_EQ(firstX(after[2]), firstX(ball(3)) + 10);
  }
}

TEST_F(ForEach, AModelWithoutItsStrokeOrOfAnotherTypeIsNamed)
{
  auto strokes = aStrokeForEach(this->models);
  strokes->SetBlock(2, nullptr);
  vtkMultiBlockDataSet::SafeDownCast(this->models->GetBlock(0))->SetBlock(0, vtkNew<vtkTable>());
  this->filter->SetStrokeData(strokes);
  Ear ear(this->filter);
  this->filter->Update();
  ASSERT_EQ(ear.errors.size(), 2u);
  EXPECT_NE(ear.errors[0].find("leaf 2: "), std::string::npos) << ear.errors[0];
  EXPECT_NE(ear.errors[0].find("vtkTable"), std::string::npos) << ear.errors[0];
  EXPECT_NE(ear.errors[1].find("leaf 5: There is no stroke for it."), std::string::npos) << ear.errors[1];
  const auto after = leavesOf(this->filter->GetOutputDataObject(0));
  ASSERT_EQ(after.size(), 3u);
  ASSERT_NE(after[0], nullptr);
  EXPECT_EQ(after[0]->GetNumberOfPoints(), 0);
  EXPECT_DOUBLE_EQ(firstX(after[1]), firstX(ball(2)) + 2);
  EXPECT_EQ(after[2]->GetNumberOfPoints(), 0);
}

TEST_F(ForEach, WhatCannotBePairedOrDrivenIsRefusedWhole)
{
  const auto expectNothing = [this](oversketch::Failure failure, const char* words)
  {
    Ear ear(this->filter);
    this->filter->Modified();
    this->filter->Update();
    ASSERT_EQ(ear.errors.size(), 1u) << words;
    EXPECT_NE(ear.errors[0].find(words), std::string::npos) << ear.errors[0];
    EXPECT_EQ(this->filter->GetErrorCode(), codeOf(failure));
    EXPECT_TRUE(leavesOf(this->filter->GetOutputDataObject(0)).empty());
    EXPECT_EQ(this->mover->runs, 0);
  };
  vtkNew<vtkMultiBlockDataSet> flat;
  flat->SetBlock(0, strokeFrom(0, 0));
  this->filter->SetStrokeData(flat);
  expectNothing(oversketch::Failure::BadStroke, "There are 4 models and 1 strokes");
  for (unsigned int i = 1; i < 4; ++i)
  {
    flat->SetBlock(i, strokeFrom(0, 0));
  }
  expectNothing(oversketch::Failure::BadStroke, "Leaf 2 of the models has no stroke at its place");
  this->filter->SetStrokeData(vtkNew<vtkPolyData>());
  expectNothing(oversketch::Failure::BadStroke, "There is no stroke");
  this->filter->SetStrokeData(strokeFrom(0, 0));
  this->filter->SetFilter(nullptr);
  expectNothing(oversketch::Failure::Unexpected, "There is no filter to drive");
  vtkNew<vtkPLYReader> reader;
  this->filter->SetFilter(reader);
  expectNothing(oversketch::Failure::Unexpected, "does not take a model");
}

// A filter of any number of inputs: each is the same for all models or has a leaf for each.
TEST_F(ForEach, FurtherInputsAreGivenToo)
{
  vtkNew<Mover> three;
  three->takeAThird();
  this->filter->SetFilter(three);
  ASSERT_EQ(this->filter->GetNumberOfInputPorts(), 3);
  this->filter->SetStrokeData(strokeFrom(10, 0));
  this->filter->SetInputDataObject(2, aStrokeForEach(this->models));
  this->filter->Update();
  const auto before = leavesOf(this->models), after = leavesOf(this->filter->GetOutputDataObject(0));
  ASSERT_EQ(after.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_DOUBLE_EQ(firstX(after[i]), firstX(before[i]) + 10 + static_cast<double>(i + 1));
  }
  this->filter->SetInputDataObject(2, vtkNew<vtkPolyData>());
  Ear ear(this->filter);
  this->filter->Update();
  ASSERT_EQ(ear.errors.size(), 1u);
  EXPECT_NE(ear.errors[0].find("There is nothing on input 2, which the filter needs."), std::string::npos)
    << ear.errors[0];
  EXPECT_EQ(this->filter->GetErrorCode(), codeOf(oversketch::Failure::BadStroke));
}

TEST_F(ForEach, AFilterOfOneInputNeedsNoStroke)
{
  vtkNew<vtkReverseSense> reverse;
  this->filter->SetFilter(reverse);
  this->filter->Update();
  EXPECT_EQ(this->filter->GetErrorCode(), 0u);
  EXPECT_EQ(leavesOf(this->filter->GetOutputDataObject(0)).size(), 3u);
}

TEST_F(ForEach, NothingInNothingOutSilently)
{
  vtkNew<vtkMultiBlockDataSet> none;
  none->SetNumberOfBlocks(3);
  this->filter->SetInputDataObject(0, none);
  this->filter->SetStrokeData(vtkNew<vtkPolyData>());
  Ear ear(this->filter);
  this->filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(this->filter->GetErrorCode(), 0u);
  EXPECT_EQ(
    vtkMultiBlockDataSet::SafeDownCast(this->filter->GetOutputDataObject(0))->GetNumberOfBlocks(), 3u);
}

TEST_F(ForEach, RunsAgainWhenAParameterOfTheFilterChangesAndOnlyThen)
{
  this->filter->SetStrokeData(strokeFrom(10, 0));
  this->filter->Update();
  EXPECT_EQ(this->mover->runs, 3);
  this->filter->Update();
  EXPECT_EQ(this->mover->runs, 3);
  this->mover->Modified();
  this->filter->Update();
  EXPECT_EQ(this->mover->runs, 6);
}

TEST_F(ForEach, CancelledAndTriedAgain)
{
  this->filter->SetStrokeData(strokeFrom(10, 0));
  double beyond = 0.4; // in the middle of the second model
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(&beyond);
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* share, void* progress)
    {
      if (*static_cast<double*>(progress) > *static_cast<double*>(share))
      {
        static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
      }
    });
  this->filter->AddObserver(vtkCommand::ProgressEvent, stop);
  Ear ear(this->filter);
  this->filter->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(this->filter->GetErrorCode(), codeOf(oversketch::Failure::Cancelled));
  EXPECT_TRUE(leavesOf(this->filter->GetOutputDataObject(0)).empty());
  EXPECT_EQ(this->mover->runs, 2);
  beyond = 2.0;
  this->filter->AbortExecuteOff();
  this->filter->Modified();
  this->filter->Update();
  EXPECT_EQ(leavesOf(this->filter->GetOutputDataObject(0)).size(), 3u);
}

// The system of the papers on shipped models: the same bits as by itself, whatever model went before.
TEST(ForEachOneStroke, SameBitsAsTheFilterAlone)
{
  const std::vector<std::pair<const char*, const char*>> pairs = {
    { "dog", "dog_longer_leg" }, { "hand", "hand_longer_finger" }, { "dog", "dog_curled_tail" }
  };
  vtkNew<vtkMultiBlockDataSet> models, strokes;
  for (unsigned int i = 0; i < pairs.size(); ++i)
  {
    models->SetBlock(i, shippedModel(pairs[i].first));
    strokes->SetBlock(i, shippedStroke(pairs[i].second));
  }
  vtkNew<vtkOversketchOneStroke> driven;
  vtkNew<vtkOversketchForEach> filter;
  filter->SetFilter(driven);
  filter->SetInputDataObject(0, models);
  filter->SetStrokeData(strokes);
  filter->Update();
  ASSERT_EQ(filter->GetErrorCode(), 0u);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (unsigned int i = 0; i < pairs.size(); ++i)
  {
    vtkNew<vtkOversketchOneStroke> alone;
    alone->SetInputData(0, vtkPolyData::SafeDownCast(models->GetBlock(i)));
    alone->SetStrokeData(vtkPolyData::SafeDownCast(strokes->GetBlock(i)));
    alone->Update();
    ASSERT_GT(alone->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_TRUE(identical(alone->GetOutput(), vtkPolyData::SafeDownCast(output->GetBlock(i)))) << i;
  }
}

// Three ranks: the stroke is on the second alone, the third holds no model, the first one that is refused.
TEST(ForEachRanks, TheStrokeReachesEveryRankAndEachReportsItsOwn)
{
  struct Result
  {
    std::vector<std::string> errors;
    unsigned long code = 0;
    std::vector<double> moved;
  };
  std::vector<Result> results(3);
  const auto bare = ball(1);
  const double start = firstX(bare);
  onRanks(3,
    [&](vtkMultiProcessController* controller)
    {
      const int rank = controller->GetLocalProcessId();
      vtkNew<vtkMultiBlockDataSet> models;
      models->SetNumberOfBlocks(4);
      if (rank < 2)
      {
        models->SetBlock(static_cast<unsigned int>(2 * rank), ball(1));
        models->SetBlock(static_cast<unsigned int>(2 * rank + 1), ball(1));
      }
      if (rank == 0)
      {
        mark(vtkPolyData::SafeDownCast(models->GetBlock(1)), "Refuse");
      }
      vtkNew<Mover> mover;
      vtkNew<vtkOversketchForEach> filter;
      filter->SetController(controller);
      filter->SetFilter(mover);
      filter->SetInputDataObject(0, models);
      filter->SetStrokeData(rank == 1 ? strokeFrom(0.1, 0) : vtkSmartPointer<vtkPolyData>::New());
      Ear ear(filter);
      filter->Update();
      Result& result = results[static_cast<std::size_t>(rank)];
      result.errors = ear.errors;
      result.code = filter->GetErrorCode();
      for (vtkPolyData* leaf : leavesOf(filter->GetOutputDataObject(0)))
      {
        result.moved.push_back(leaf->GetNumberOfPoints() > 0 ? firstX(leaf) - start : 0.0);
      }
    });
  const double step = (start + 0.1) - start; // bit for bit what one rank makes of it
  EXPECT_EQ(results[0].moved, (std::vector<double>{ step, 0.0 }));
  EXPECT_EQ(results[1].moved, (std::vector<double>{ step, step }));
  EXPECT_TRUE(results[2].moved.empty());
  ASSERT_EQ(results[0].errors.size(), 1u);
  EXPECT_NE(results[0].errors[0].find("rank 0, leaf 2: "), std::string::npos) << results[0].errors[0];
  EXPECT_TRUE(results[1].errors.empty());
  EXPECT_TRUE(results[2].errors.empty());
  EXPECT_EQ(results[2].code, 0u);
}

TEST(ForEachRanks, WithoutAStrokeRanksWithModelsSayItOnce)
{
  std::vector<std::size_t> errors(2, 99);
  onRanks(2,
    [&](vtkMultiProcessController* controller)
    {
      const int rank = controller->GetLocalProcessId();
      vtkNew<vtkMultiBlockDataSet> models;
      models->SetNumberOfBlocks(3);
      for (unsigned int i = 0; rank == 1 && i < 3; ++i)
      {
        models->SetBlock(i, ball(1));
      }
      vtkNew<Mover> mover;
      vtkNew<vtkOversketchForEach> filter;
      filter->SetController(controller);
      filter->SetFilter(mover);
      filter->SetInputDataObject(0, models);
      filter->SetStrokeData(vtkNew<vtkPolyData>());
      Ear ear(filter);
      filter->Update();
      errors[static_cast<std::size_t>(rank)] = ear.errors.size();
    });
  EXPECT_EQ(errors, (std::vector<std::size_t>{ 0, 1 }));
}
