// What is seen of a drawing, and hands that do anything.
#include "Harness/windows.h"
#include "desk.h"

#include "vtkCallbackCommand.h"
#include "vtkUnsignedCharArray.h"

#include <random>

using namespace oversketch_test;
using oversketch::Vector2;

namespace
{

std::array<int, 3> pixel(Desk& desk, const Vector2& place)
{
  desk.window->Render();
  const auto at = desk.display({ place[0], place[1], 0.0 });
  vtkNew<vtkUnsignedCharArray> data;
  const int x = int(std::lround(at[0])), y = int(std::lround(at[1]));
  desk.window->GetPixelData(x, y, x, y, 1, data);
  return { data->GetValue(0), data->GetValue(1), data->GetValue(2) };
}

bool isRed(const std::array<int, 3>& c)
{
  return c[0] > 180 && c[1] < 90 && c[2] < 90;
}

} // namespace

TEST(DrawingWindow, ColoursSayWhatStrokesAre)
{
  Desk desk;
  const auto at = [&](double x, double y)
  {
    const auto place = desk.display({ x, y, 0.0 });
    return Vector2(place[0], place[1]);
  };
  const double unit = at(1, 0)[0] - at(0, 0)[0];
  desk.drawRing(at(200, 150), 100 * unit);
  desk.drawRing(at(200, 150), 40 * unit);
  EXPECT_TRUE(isRed(pixel(desk, { 300, 150 })));
  const auto blue = pixel(desk, { 240, 150 });
  EXPECT_TRUE(blue[2] > 180 && blue[0] < 90) << blue[0] << " " << blue[1] << " " << blue[2];
  EXPECT_EQ(pixel(desk, { 200, 150 }), (std::array<int, 3>{ 255, 255, 255 })) << "filled: nothing is shaded";
  const Vector2 inside = at(200, 165);
  desk.click(int(inside[0]), int(inside[1]));
  const auto hole = pixel(desk, { 200, 150 });
  EXPECT_LT(hole[0], 140) << "a hole is dark";
  desk.click(int(inside[0]), int(inside[1]));
  const auto tunnel = pixel(desk, { 200, 150 });
  EXPECT_GT(tunnel[2], tunnel[1] + 40) << "a tunnel is violet";
  EXPECT_EQ(pixel(desk, { 150, 150 }), (std::array<int, 3>{ 255, 255, 255 }));
}

// Of what the hand waits for, drawing is the most.
TEST(DrawingWindow, AReleaseDrawsTheWindowOnce)
{
  Desk desk;
  int drawn = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&drawn);
  count->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  const std::vector<Vector2> outline = Desk::closedRing({ 200, 150 }, 100.0);
  const auto at = [&](const Vector2& p, unsigned long event) { desk.event(event, int(p[0]), int(p[1])); };
  at(outline[0], vtkCommand::LeftButtonPressEvent);
  for (const Vector2& p : outline)
  {
    at(p, vtkCommand::MouseMoveEvent);
  }
  desk.window->AddObserver(vtkCommand::StartEvent, count);
  at(outline.back(), vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(desk.labels("Role"), std::vector<int>{ 1 });
  EXPECT_EQ(drawn, 1);
  drawn = 0;
  desk.sheet->RemoveLastStroke();
  EXPECT_EQ(drawn, 1); // and what no pen does draws itself
}

TEST(DrawingWindow, ThePictureIsSeenWholeUnderTheCurves)
{
  Desk desk;
  desk.sheet->SetPicture(picture(20, 10, 3, [](int x, int, int c) { return c == 1 ? 200 : 10 * x; }));
  EXPECT_EQ(pixel(desk, { 0, 5 })[1], 200);
  EXPECT_EQ(pixel(desk, { -0.45, -0.45 })[1], 200) << "samples are squares round their centres";
  EXPECT_EQ(pixel(desk, { 19.45, 9.45 })[1], 200);
  EXPECT_EQ(pixel(desk, { -0.6, 5 })[0], 255) << "beyond them is nothing";
}

TEST(Random, EventsOnADrawing)
{
  Quiet quiet;
  const std::vector<unsigned long> mouse =
    mouseEvents({ vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent });
  const std::vector<const char*> keys{ "Escape", "BackSpace", "Return", "x", "w", "q" };
  const auto disc = discPicture(200, 60.0, { 100.0, 80.0 });
  Desk desk;
  const Sequences sequences = sequencesAsked(6);
  MemoryLevel memory(sequences);
  Counter changes(desk.sheet, vtkCommand::WidgetValueChangedEvent);
  for (unsigned seed = sequences.first; seed < sequences.end(); ++seed)
  {
    memory.before(seed);
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&](std::size_t n) { return static_cast<int>(random() % n); };
    desk.interactor->SetEnableRender(seed % 4 == 0); // the rest in less time
    desk.sheet->SetDrawing(nullptr);
    desk.sheet->SetPicture(seed % 2 ? disc : nullptr);
    desk.drawRing({ 200, 150 }, 80);
    for (int i = 0; i < 200; ++i)
    {
      const int x = below(480) - 40, y = below(380) - 40, modifiers = below(4) ? 0 : below(8);
      switch (below(12))
      {
        case 0:
          desk.key(keys[static_cast<std::size_t>(below(keys.size()))], modifiers, x, y);
          break;
        case 1:
          desk.sheet->SetMagnetic(below(2) != 0);
          break;
        case 2:
          below(3) ? desk.sheet->RemoveLastStroke() : desk.sheet->ResetView();
          break;
        case 3:
          desk.sheet->SetEnabled(below(3) != 0);
          break;
        case 4:
          desk.drawRing({ x, y }, 5 + below(90));
          break;
        case 5:
        case 6:
        case 7:
          desk.event(mouse[static_cast<std::size_t>(below(mouse.size()))], x, y, modifiers);
          break;
        default:
          desk.move(x, y, modifiers);
      }
    }
    desk.sheet->On();
    desk.event(vtkCommand::LeftButtonReleaseEvent, 10, 10);
    desk.event(vtkCommand::MiddleButtonReleaseEvent, 10, 10);
    // What could not be classified is said.
    const auto strokes = std::size_t(desk.drawing()->GetNumberOfCells());
    EXPECT_TRUE(desk.labels("Role").size() == strokes || desk.sheet->GetText()[0] != '\0');
  }
  memory.print();
  EXPECT_LT(memory.growth(), 4.0);
  EXPECT_GT(changes.count, 0);
  EXPECT_EQ(quiet.errors(), 0);
}
