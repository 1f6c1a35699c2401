#include "pen_scene.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkPointData.h"
#include "vtkProperty2D.h"

#include <algorithm>
#include <cmath>

using namespace oversketch_test;

namespace
{

// The samples of pen_stroke.log.
std::vector<std::array<double, 2>> wave()
{
  std::vector<std::array<double, 2>> all;
  for (int i = 0; i <= 40; ++i)
  {
    all.push_back({ 60.0 + 4 * i, std::nearbyint(150.0 + 40.0 * std::sin(i / 8.0)) });
  }
  return all;
}

} // namespace

TEST(Pen, EverySampleOfTheLogIsKept)
{
  Pen scene;
  Counter starts(scene.pen, vtkCommand::StartInteractionEvent),
    moves(scene.pen, vtkCommand::InteractionEvent), ends(scene.pen, vtkCommand::EndInteractionEvent),
    commits(scene.pen, vtkCommand::WidgetValueChangedEvent);
  EXPECT_EQ(scene.pen->GetStroke()->GetNumberOfPoints(), 0);
  scene.play("pen_stroke.log");
  EXPECT_EQ(scene.samples(), wave());
  EXPECT_EQ(starts.count, 1);
  EXPECT_EQ(moves.count, 41);
  EXPECT_EQ(ends.count, 1);
  EXPECT_EQ(commits.count, 1);
  vtkPolyData* stroke = scene.pen->GetStroke();
  ASSERT_EQ(stroke->GetNumberOfLines(), 1);
  ASSERT_EQ(stroke->GetNumberOfCells(), 1);
  vtkDataArray* pressure = stroke->GetPointData()->GetArray("Pressure");
  vtkDataArray* time = stroke->GetPointData()->GetArray("Time");
  ASSERT_TRUE(pressure && time);
  EXPECT_EQ(pressure->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(time->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < 41; ++i)
  {
    EXPECT_EQ(pressure->GetComponent(i, 0), 1.0);
    EXPECT_GE(time->GetComponent(i, 0), i ? time->GetComponent(i - 1, 0) : 0.0);
  }
  EXPECT_EQ(time->GetComponent(0, 0), 0.0);
}

TEST(Pen, TheStrokeCarriesItsView)
{
  for (const bool parallel : { true, false })
  {
    Pen scene;
    scene.camera()->SetParallelProjection(parallel);
    scene.camera()->Azimuth(33.0);
    scene.camera()->Elevation(21.0);
    scene.renderer->ResetCameraClippingRange();
    scene.play("pen_stroke.log");
    const std::array<double, 3> world{ 0.1, 0.3, -0.2 };
    const auto at = scene.display(world);
    const auto expectView = [&]
    {
      const oversketch::View view = oversketch::ViewOf(scene.pen->GetStroke());
      EXPECT_EQ(view.width(), 400);
      EXPECT_EQ(view.height(), 300);
      EXPECT_EQ(view.perspective(), !parallel);
      const oversketch::Vector3 seen = view.toDisplay({ world[0], world[1], world[2] });
      EXPECT_NEAR(seen[0], at[0], 1e-9);
      EXPECT_NEAR(seen[1], at[1], 1e-9);
    };
    expectView();
    scene.camera()->Azimuth(90.0); // the stroke's own view stays
    expectView();
  }
}

TEST(Pen, AMoveDrawsOverTheLastFrame)
{
  for (const int samples : { 0, 4 })
  {
    SCOPED_TRACE(samples);
    Pen scene(samples);
    const Pixels before = scene.pixels();
    const int layers = scene.window->GetNumberOfLayers();
    scene.press(60, 150);
    Counter renders(scene.renderer, vtkCommand::StartEvent), frames(scene.window, vtkCommand::EndEvent);
    for (int x = 64; x <= 220; x += 4)
    {
      scene.move(x, 150);
    }
    EXPECT_EQ(renders.count, 0);
    EXPECT_EQ(frames.count, 40);
    const Pixels during = scene.pixels();
    int off = 0;
    for (int y = 0; y < 300; ++y)
    {
      for (int x = 0; x < 400; ++x)
      {
        const bool near = std::abs(y - 150) <= 3 && x >= 56 && x <= 224;
        const size_t i = 3 * (400 * y + x);
        off += !near && !std::equal(&before[i], &before[i] + 3, &during[i]);
      }
    }
    EXPECT_EQ(off, 0) << "pixels beside the stroke are not those of the last frame";
    for (int x = 62; x <= 218; x += 2)
    {
      EXPECT_TRUE(isRed(during, x, 150)) << x;
    }
    // The window's own redraws in mid-stroke (expose) show the same, still without the scene.
    scene.window->Render();
    EXPECT_EQ(scene.pixels(), during);
    EXPECT_EQ(renders.count, 0);
    scene.release(220, 150);
    EXPECT_GT(renders.count, 0);
    EXPECT_TRUE(isRed(scene.pixels(), 100, 150));
    EXPECT_EQ(scene.window->GetNumberOfLayers(), layers);
    EXPECT_EQ(scene.window->GetRenderers()->GetNumberOfItems(), 1);
    EXPECT_TRUE(scene.renderer->GetDraw());
    // The next stroke starts from a frame without this one.
    scene.press(10, 10);
    scene.move(14, 10);
    EXPECT_FALSE(isRed(scene.pixels(), 100, 150));
    scene.key("Escape"); // nothing has happened
    EXPECT_TRUE(isRed(scene.pixels(), 100, 150));
    scene.pen->GetStrokeRepresentation()->Clear();
    scene.window->Render();
    EXPECT_EQ(scene.pixels(), before);
  }
}

TEST(Pen, AStrokeLiesInThePictureNotOnTheModel)
{
  Pen scene;
  scene.drawLine(60, 220, 150);
  EXPECT_TRUE(isRed(scene.pixels(), 100, 150));
  scene.style->LookAlong(0, false);
  EXPECT_FALSE(isRed(scene.pixels(), 100, 150));
  scene.style->ResetToFirstView();
  EXPECT_TRUE(isRed(scene.pixels(), 100, 150));
  scene.pen->Off();
  scene.window->Render();
  EXPECT_FALSE(isRed(scene.pixels(), 100, 150));
}

TEST(Pen, EscapeDropsTheStroke)
{
  Pen scene;
  const Pixels before = scene.pixels();
  Counter ends(scene.pen, vtkCommand::EndInteractionEvent),
    commits(scene.pen, vtkCommand::WidgetValueChangedEvent);
  scene.play("pen_escape.log");
  EXPECT_EQ(ends.count, 1);
  EXPECT_EQ(commits.count, 0);
  EXPECT_EQ(scene.pen->GetStroke()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scene.pixels(), before);
}

TEST(Pen, BackspaceTakesTheLastPoints)
{
  Pen scene;
  scene.play("pen_backspace.log");
  const auto points = scene.samples();
  // 41 samples from 60 to 220, 20 px taken back to 196, 5 samples up at 220.
  ASSERT_EQ(points.size(), 35u + 5u);
  EXPECT_EQ(points[34], (std::array<double, 2>{ 196.0, 150.0 }));
  EXPECT_EQ(points[35], (std::array<double, 2>{ 220.0, 154.0 }));
  // Taken back entirely it is no stroke.
  scene.press(60, 150);
  scene.move(70, 150);
  const Pixels with = scene.pixels();
  EXPECT_TRUE(isRed(with, 65, 150));
  for (int i = 0; i < 5; ++i)
  {
    scene.key("BackSpace");
  }
  EXPECT_FALSE(isRed(scene.pixels(), 65, 150));
  Counter commits(scene.pen, vtkCommand::WidgetValueChangedEvent);
  scene.release(70, 150);
  EXPECT_EQ(commits.count, 0);
}

TEST(Pen, ABandUnderTheStrokeGrowsWithIt)
{
  Pen scene;
  vtkOversketchStrokeRepresentation* line = scene.pen->GetStrokeRepresentation();
  line->GetSectionProperty()->SetColor(0.0, 0.0, 1.0);
  line->GetSectionProperty()->SetLineWidth(20.0F);
  line->SetSectionFollows(true);
  EXPECT_FALSE(line->GetSectionFollows()) << "there is no stroke";
  const auto isBlue = [](const Pixels& pixels, int x, int y)
  {
    const unsigned char* p = &pixels[3 * (400 * y + x)];
    return p[2] > 200 && p[0] < 60;
  };
  scene.press(60, 20);
  scene.move(100, 20);
  EXPECT_FALSE(isBlue(scene.pixels(), 80, 27));
  line->SetSectionFollows(true); // what is drawn already, too
  for (int x = 104; x <= 220; x += 4)
  {
    scene.move(x, 20);
    const Pixels now = scene.pixels();
    EXPECT_TRUE(isBlue(now, 64, 27) && isBlue(now, x - 2, 27) && isBlue(now, x - 2, 13)) << x;
    EXPECT_FALSE(isBlue(now, x + 6, 27)) << x;
    EXPECT_TRUE(isRed(now, x - 2, 20)) << "the stroke lies over it";
  }
  line->RemoveLast(60.0);
  scene.move(164, 20);
  EXPECT_TRUE(isBlue(scene.pixels(), 150, 27));
  EXPECT_FALSE(isBlue(scene.pixels(), 190, 27));
  scene.release(164, 20);
  EXPECT_FALSE(isBlue(scene.pixels(), 100, 27));
  EXPECT_FALSE(line->GetSectionFollows());
}

TEST(Pen, AClickIsNoStroke)
{
  Pen scene;
  Counter commits(scene.pen, vtkCommand::WidgetValueChangedEvent);
  scene.press(100, 100);
  scene.release(100, 100);
  EXPECT_EQ(commits.count, 0);
  EXPECT_FALSE(scene.pen->IsDrawing());
}

TEST(Pen, DrawingNeverOrbitsAndOrbitingNeverDraws)
{
  Pen scene;
  EXPECT_EQ(scene.style->GetMode(), vtkOversketchInteractorStyle::Draw);
  const std::vector<double> before(scene.camera()->GetPosition(), scene.camera()->GetPosition() + 3);
  const auto position = [&]
  { return std::vector<double>(scene.camera()->GetPosition(), scene.camera()->GetPosition() + 3); };
  const double scale = scene.camera()->GetViewAngle();
  scene.play("pen_disturbed.log");
  EXPECT_EQ(position(), before);
  EXPECT_EQ(scene.camera()->GetViewAngle(), scale);
  EXPECT_EQ(scene.samples(), wave());

  Counter starts(scene.pen, vtkCommand::StartInteractionEvent);
  scene.event(vtkCommand::MiddleButtonPressEvent, 200, 150);
  scene.move(230, 150);
  scene.press(230, 150); // the pen touches in mid-turn
  scene.move(240, 160);
  scene.release(240, 160);
  EXPECT_EQ(starts.count, 0);
  EXPECT_NE(position(), before);
  scene.event(vtkCommand::MiddleButtonReleaseEvent, 240, 160);
  for (const int modifiers : { int(Shift), int(Control), int(Alt) })
  {
    const auto was = position();
    scene.event(vtkCommand::LeftButtonPressEvent, 200, 150, modifiers);
    scene.move(220, 160, modifiers);
    scene.event(vtkCommand::LeftButtonReleaseEvent, 220, 160, modifiers);
    EXPECT_EQ(starts.count, 0);
    EXPECT_NE(position(), was);
  }
  scene.pen->Off();
  EXPECT_EQ(scene.style->GetMode(), vtkOversketchInteractorStyle::Navigate);

  // Under VTK's own style too.
  vtkNew<vtkInteractorStyleTrackballCamera> stock;
  scene.interactor->SetInteractorStyle(stock);
  scene.pen->On();
  const auto was = position();
  scene.play("pen_disturbed.log");
  EXPECT_EQ(position(), was);
  EXPECT_EQ(scene.samples(), wave());
}

TEST(Pen, SamplesOfATablet)
{
  Pen scene;
  EXPECT_TRUE(scene.pen->BeginStroke(10.25, 20.5, 0.25));
  EXPECT_FALSE(scene.pen->BeginStroke(1.0, 1.0));
  scene.pen->AddSample(11.125, 21.0, 0.5, 0.125);
  scene.pen->AddSample(std::nan(""), 21.0, 0.5, 0.125);
  scene.pen->AddSample(12.5, 22.0, 1.5, 0.25);
  scene.pen->SetPressure(0.75); // what the host says of the mouse's samples
  scene.move(30, 40);
  scene.pen->EndStroke();
  scene.pen->AddSample(50.0, 50.0);
  scene.pen->EndStroke();
  EXPECT_EQ(scene.samples(),
    (std::vector<std::array<double, 2>>{
      { 10.25, 20.5 }, { 11.125, 21.0 }, { 12.5, 22.0 }, { 30.0, 40.0 } }));
  vtkDataArray* pressure = scene.pen->GetStroke()->GetPointData()->GetArray("Pressure");
  const double expected[] = { 0.25, 0.5, 1.0, 0.75 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(pressure->GetComponent(i, 0), expected[i]);
  }
  vtkDataArray* time = scene.pen->GetStroke()->GetPointData()->GetArray("Time");
  EXPECT_EQ(time->GetComponent(1, 0), 0.125);
  EXPECT_EQ(time->GetComponent(2, 0), 0.25);
}

TEST(Pen, TheStabiliserSteadiesTheHand)
{
  const auto draw = [](double length)
  {
    Pen scene;
    scene.pen->SetStabilizer(length);
    scene.press(50, 150);
    for (int i = 1; i <= 300; ++i)
    {
      scene.move(50 + i, 150 + (i % 2 ? 3 : -3));
    }
    scene.release(350, 147);
    return scene.samples();
  };
  const auto turning = [](const std::vector<std::array<double, 2>>& p)
  {
    double sum = 0.0;
    for (size_t i = 2; i + 1 < p.size(); ++i) // not the last, which goes up to the pen
    {
      const double a = std::atan2(p[i - 1][1] - p[i - 2][1], p[i - 1][0] - p[i - 2][0]);
      const double b = std::atan2(p[i][1] - p[i - 1][1], p[i][0] - p[i - 1][0]);
      sum += std::abs(std::remainder(b - a, 2.0 * M_PI));
    }
    return sum;
  };
  const auto off = draw(0.0), on = draw(20.0);
  EXPECT_EQ(off.size(), 301u);
  ASSERT_EQ(on.size(), 302u); // every sample, and the end
  // A string: never longer than its length, and the line ends at the pen.
  for (size_t i = 0; i < 301; ++i)
  {
    EXPECT_LE(std::hypot(on[i][0] - off[i][0], on[i][1] - off[i][1]), 20.0 + 1e-9) << i;
  }
  EXPECT_EQ(on.back(), off.back());
  EXPECT_LT(turning(on), 0.25 * turning(off));
  // Trembling on the spot leaves no trace.
  Pen scene;
  scene.pen->SetStabilizer(5.0);
  scene.press(100, 100);
  for (int i = 0; i < 20; ++i)
  {
    scene.move(100 + i % 3, 100 - i % 2);
  }
  scene.move(100, 100);
  scene.release(100, 100);
  for (const auto& p : scene.samples())
  {
    EXPECT_EQ(p, (std::array<double, 2>{ 100.0, 100.0 }));
  }
}

TEST(OverSketch, APartIsDrawnAnewBeforeTheCommit)
{
  Pen scene;
  scene.pen->CommitOnReleaseOff();
  Counter commits(scene.pen, vtkCommand::WidgetValueChangedEvent);
  scene.play("pen_over.log");
  EXPECT_TRUE(scene.pen->IsWaiting());
  EXPECT_EQ(commits.count, 0);
  EXPECT_EQ(scene.samples().size(), 0u);
  const Pixels shown = scene.pixels();
  EXPECT_TRUE(isRed(shown, 110, 150));
  EXPECT_TRUE(isRed(shown, 200, 158));
  EXPECT_FALSE(isRed(shown, 200, 150)); // the part drawn over
  EXPECT_TRUE(isRed(shown, 295, 150));
  scene.key("Return");
  EXPECT_EQ(commits.count, 1);
  EXPECT_FALSE(scene.pen->IsWaiting());
}

TEST(OverSketch, NumbersOfTheTransition)
{
  // Old line 100..300 at 150; new one 4 px above from 180 to 220: S' = 180 - 24, E' = 220 + 24.
  Pen scene;
  scene.pen->CommitOnReleaseOff();
  scene.drawLine(100, 300, 150, 2);
  scene.drawLine(180, 220, 154, 2);
  vtkNew<vtkPolyData> waiting;
  scene.pen->GetStrokeRepresentation()->GetPolyData(waiting);
  scene.pen->Commit();
  const auto points = scene.samples();
  EXPECT_EQ(waiting->GetNumberOfPoints(), vtkIdType(points.size()));
  EXPECT_EQ(points.front(), (std::array<double, 2>{ 100.0, 150.0 }));
  EXPECT_EQ(points.back(), (std::array<double, 2>{ 300.0, 150.0 }));
  for (const auto& p : points)
  {
    if (p[0] <= 156.0 || p[0] >= 244.0)
    {
      EXPECT_NEAR(p[1], 150.0, 1e-9);
    }
    else if (p[0] >= 180.0 && p[0] <= 220.0)
    {
      EXPECT_EQ(p[1], 154.0);
    }
    else
    {
      EXPECT_GT(p[1], 150.0);
      EXPECT_LT(p[1], 154.0);
    }
  }
  vtkDataArray* time = scene.pen->GetStroke()->GetPointData()->GetArray("Time");
  const auto middle = std::find_if(points.begin(), points.end(), [](const auto& p) { return p[1] == 154.0; });
  EXPECT_GE(time->GetComponent(middle - points.begin(), 0), time->GetComponent(points.size() - 1, 0));
}

TEST(OverSketch, KeysOfAStrokeThatWaits)
{
  Pen scene;
  const Pixels before = scene.pixels();
  scene.pen->CommitOnReleaseOff();
  scene.drawLine(60, 220, 150);
  scene.key("x"); // still the camera's
  EXPECT_NEAR(scene.camera()->GetDirectionOfProjection()[0], 1.0, 1e-12);
  scene.key("w");
  scene.key("BackSpace");
  EXPECT_FALSE(isRed(scene.pixels(), 210, 150));
  EXPECT_TRUE(isRed(scene.pixels(), 190, 150));
  // A stroke in another view replaces it.
  scene.key("x");
  scene.drawLine(60, 220, 40);
  EXPECT_FALSE(isRed(scene.pixels(), 100, 150));
  EXPECT_TRUE(isRed(scene.pixels(), 100, 40));
  scene.key("w");
  scene.key("Escape");
  EXPECT_FALSE(scene.pen->IsWaiting());
  EXPECT_EQ(scene.pixels(), before);
  scene.key("Return");
  EXPECT_EQ(scene.samples().size(), 0u);
  // Taken back bit by bit it is dropped.
  scene.drawLine(60, 100, 150);
  for (int i = 0; i < 4; ++i)
  {
    scene.key("BackSpace");
  }
  EXPECT_FALSE(scene.pen->IsWaiting());
}
