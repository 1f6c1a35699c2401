// Sections found on a thread of their own: the same as Preview's, for the newest stroke.
#include "section_finder.h"
#include "sessions.h"

#include "vtkOversketchSystem.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <future>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

// A finder, with all that it tells.
struct Desk
{
  std::mutex mutex;
  std::condition_variable told;
  bool ready = false;
  std::vector<std::uint64_t> tickets; // of the answers, in their order
  SectionFinder finder{ *findSystem("OneStroke"),
    [this]
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->ready = true;
      this->told.notify_all();
    } };

  // The answer to a stroke; null where it does not come.
  vtkSmartPointer<vtkPolyData> wait(std::uint64_t ticket)
  {
    for (;;)
    {
      {
        std::unique_lock<std::mutex> lock(this->mutex);
        if (!this->told.wait_for(lock, std::chrono::minutes(10), [this] { return this->ready; }))
        {
          return nullptr;
        }
        this->ready = false;
      }
      if (const auto found = this->finder.take())
      {
        this->tickets.push_back(found->ticket);
        if (found->ticket >= ticket)
        {
          return found->ticket == ticket ? found->section : nullptr;
        }
      }
    }
  }
};

// The first samples of a stroke.
vtkSmartPointer<vtkPolyData> begun(vtkPolyData* stroke, vtkIdType samples)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->DeepCopy(stroke);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(samples));
  for (vtkIdType i = 0; i < samples; ++i)
  {
    line->InsertCellPoint(points->InsertNextPoint(stroke->GetPoint(i)));
  }
  part->GetPointData()->Initialize();
  part->SetPoints(points);
  part->SetLines(line);
  return part;
}

// The same line in another view: the camera a little to one side.
vtkSmartPointer<vtkPolyData> seenFromBeside(vtkPolyData* stroke)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(stroke);
  vtkDataArray* view = copy->GetCellData()->GetArray("ViewTransform");
  view->SetComponent(0, 3, view->GetComponent(0, 3) + 0.1);
  return copy;
}

vtkSmartPointer<vtkPolyData> expected(vtkPolyData* mesh, vtkPolyData* stroke)
{
  vtkNew<vtkOversketchOneStroke> system;
  system->SetBackendToHost();
  auto section = vtkSmartPointer<vtkPolyData>::New();
  system->Preview(mesh, stroke, section);
  return section;
}

bool sameArrays(vtkFieldData* a, vtkFieldData* b)
{
  bool same = a->GetNumberOfArrays() == b->GetNumberOfArrays();
  for (int i = 0; same && i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray *x = a->GetArray(i), *y = b->GetArray(x->GetName());
    same = y && x->GetNumberOfValues() == y->GetNumberOfValues() && x->GetDataType() == y->GetDataType() &&
           std::memcmp(x->GetVoidPointer(0),
             y->GetVoidPointer(0),
             static_cast<std::size_t>(x->GetNumberOfValues() * x->GetDataTypeSize())) == 0;
  }
  return same;
}

// Points, lines and all arrays, bit for bit.
bool same(vtkPolyData* a, vtkPolyData* b)
{
  if (!a || largestMove(a, b) != 0.0 || a->GetNumberOfLines() != b->GetNumberOfLines())
  {
    return false;
  }
  return sameArrays(a->GetPointData(), b->GetPointData()) && sameArrays(a->GetCellData(), b->GetCellData()) &&
         sameArrays(a->GetFieldData(), b->GetFieldData());
}

} // namespace

TEST(SectionFinder, FindsWhatPreviewFinds)
{
  for (const auto& [model, name] : { std::pair("dog", "dog_longer_leg"),
         std::pair("dog", "dog_curled_tail"),
         std::pair("octopus", "octopus_bent_arm") })
  {
    const auto mesh = shippedModel(model);
    const auto stroke = shippedStroke(name);
    Desk desk;
    desk.finder.setMesh(mesh);
    int sections = 0;
    const vtkIdType all = stroke->GetNumberOfPoints();
    for (const vtkIdType samples : { vtkIdType(1), all / 4, all / 2, all })
    {
      const auto part = begun(stroke, samples);
      const auto section = desk.wait(desk.finder.find(part));
      ASSERT_TRUE(section);
      EXPECT_TRUE(same(section, expected(mesh, part))) << name << ", " << samples << " samples";
      sections += section->GetNumberOfPoints() > 10;
    }
    EXPECT_GT(sections, 0) << name;
  }
}

// As a reader makes it of a mesh with texture coordinates: points split along seams, arrays on them.
TEST(SectionFinder, OfAMeshWithSplitPointsAndAttributes)
{
  const auto mesh = shippedModel("dog");
  vtkNew<vtkPolyData> split;
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetCellPoints(t, ids);
    triangles->InsertNextCell(3);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      triangles->InsertCellPoint(points->InsertNextPoint(mesh->GetPoint(ids->GetId(k))));
      coordinates->InsertNextTuple2(0.1 * static_cast<double>(t % 10), 0.5 * static_cast<double>(k));
    }
  }
  split->SetPoints(points);
  split->SetPolys(triangles);
  split->GetPointData()->SetTCoords(coordinates);
  const auto stroke = shippedStroke("dog_longer_leg");
  Desk desk;
  desk.finder.setMesh(split);
  const auto section = desk.wait(desk.finder.find(stroke));
  ASSERT_TRUE(section);
  EXPECT_GT(section->GetNumberOfPoints(), 10);
  EXPECT_TRUE(same(section, expected(split, stroke)));
}

TEST(SectionFinder, TheNewestStrokeWinsAndOthersAreAnsweredInOrderOrNotAtAll)
{
  const auto mesh = shippedModel("dog");
  const auto leg = shippedStroke("dog_longer_leg"), beside = seenFromBeside(leg);
  const auto answer = expected(mesh, leg);
  Desk desk;
  desk.finder.setMesh(mesh);
  std::uint64_t last = 0;
  constexpr std::uint64_t rounds = 40;
  for (std::uint64_t i = 1; i <= rounds; ++i)
  {
    // Two views in turn, as of a camera that does not rest.
    const auto part = begun(i % 2 ? beside : leg, 10 + static_cast<vtkIdType>(i % 7));
    last = desk.finder.find(i == rounds ? leg : part);
    EXPECT_EQ(last, i);
  }
  EXPECT_TRUE(same(desk.wait(last), answer)) << "what was cancelled is seen in the next";
  EXPECT_TRUE(std::is_sorted(desk.tickets.begin(), desk.tickets.end()));
  EXPECT_LT(desk.tickets.size(), rounds) << "nothing was superseded";
}

TEST(SectionFinder, StrokesInOneViewDoNotKeepEachOtherFromBeingAnswered)
{
  const auto mesh = shippedModel("dog");
  const auto leg = shippedStroke("dog_longer_leg");
  Desk desk;
  desk.finder.setMesh(mesh);
  // A pen that never stands: it goes on until the first answer comes.
  const std::uint64_t first = desk.finder.find(begun(leg, 1));
  std::optional<SectionFinder::Found> found;
  for (int i = 0; i < 600000 && !found; ++i)
  {
    desk.finder.find(begun(leg, 2 + i % (leg->GetNumberOfPoints() - 2)));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    found = desk.finder.take();
  }
  ASSERT_TRUE(found);
  EXPECT_GE(found->ticket, first);
}

TEST(SectionFinder, AnotherMeshIsFollowedAndTheLastOnesAnswersEnd)
{
  const auto dog = shippedModel("dog"), octopus = shippedModel("octopus");
  const auto leg = shippedStroke("dog_longer_leg"), arm = shippedStroke("octopus_bent_arm");
  Desk desk;
  const auto none = desk.wait(desk.finder.find(leg)); // before there is a mesh
  ASSERT_TRUE(none);
  EXPECT_EQ(none->GetNumberOfPoints(), 0);
  desk.finder.setMesh(dog);
  desk.finder.find(leg);
  desk.finder.setMesh(octopus);
  const std::uint64_t ticket = desk.finder.find(arm);
  EXPECT_TRUE(same(desk.wait(ticket), expected(octopus, arm)));
  EXPECT_TRUE(same(desk.wait(desk.finder.find(arm)), expected(octopus, arm))) << "the next stroke too";
  {
    // Its owner may let it go, and give the polydata other points, at once.
    vtkNew<vtkPolyData> gone;
    gone->DeepCopy(dog);
    desk.finder.setMesh(gone);
    vtkNew<vtkPoints> other;
    other->DeepCopy(gone->GetPoints());
    other->SetPoint(0, 1e6, 1e6, 1e6);
    gone->SetPoints(other);
  }
  EXPECT_TRUE(same(desk.wait(desk.finder.find(leg)), expected(dog, leg)));
  vtkNew<vtkPolyData> empty;
  desk.finder.setMesh(empty);
  const auto nothing = desk.wait(desk.finder.find(leg));
  ASSERT_TRUE(nothing);
  EXPECT_EQ(nothing->GetNumberOfPoints(), 0);
}

// Nothing of an answer stays behind with the finder's thread, also where it replaces one that nobody took:
// VTK would walk through it there while it is used here.
TEST(SectionFinder, HandsOverTheOnlyReference)
{
  std::mutex mutex;
  std::condition_variable told;
  int answers = 0, references = 0;
  SectionFinder* asked = nullptr;
  SectionFinder finder(*findSystem("OneStroke"),
    [&]
    {
      const std::lock_guard<std::mutex> lock(mutex);
      if (++answers == 2)
      {
        const auto found = asked->take();
        references = std::max(found->section->GetReferenceCount(), found->crest->GetReferenceCount());
      }
      told.notify_all();
    });
  asked = &finder;
  const auto leg = shippedStroke("dog_longer_leg");
  finder.setMesh(shippedModel("dog"));
  std::unique_lock<std::mutex> lock(mutex);
  for (const int expected : { 1, 2 })
  {
    finder.find(leg);
    ASSERT_TRUE(told.wait_for(lock, std::chrono::minutes(10), [&] { return answers == expected; }));
  }
  EXPECT_EQ(references, 1);
}

// A search that never ends by itself is cancelled, waited for and not answered, whenever it is met.
TEST(SectionFinder, EndsAtOnceInTheMiddleOfASearch)
{
  const auto mesh = shippedModel("dog");
  const auto leg = shippedStroke("dog_longer_leg");
  for (int i = 0; i < 10; ++i)
  {
    std::promise<void> begun;
    bool cancelled = false;
    int answers = 0;
    {
      SectionFinder finder(
        *findSystem("OneStroke"),
        [&] { ++answers; },
        [&](vtkOversketchSystem* system,
          vtkPolyData* model,
          vtkPolyData* stroke,
          vtkPolyData* section,
          vtkPolyData*)
        {
          begun.set_value();
          do
          {
            system->Preview(model, stroke, section);
            system->UpdateProgress(0.5); // where a step asks whether it is to go on
          } while (!system->GetAbortExecute());
          cancelled = true;
        });
      finder.setMesh(mesh);
      finder.find(leg);
      ASSERT_EQ(begun.get_future().wait_for(std::chrono::minutes(10)), std::future_status::ready);
      std::this_thread::sleep_for(std::chrono::milliseconds(i));
    }
    EXPECT_TRUE(cancelled) << i;
    EXPECT_EQ(answers, 0) << i;
  }
}
