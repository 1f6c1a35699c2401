// A hand over a canvas and over a picture: what becomes of its strokes.
#include "desk.h"

using namespace oversketch_test;
using oversketch::Vector2;

TEST(DrawingWidget, TheSameDragAtTwiceTheZoomIsHalfAsLongAndNothingElseMoves)
{
  Desk desk;
  desk.draw({ { 100, 100 }, { 150, 100 }, { 200, 100 } });
  const auto before = pointsOf(desk.drawing());
  const double whole =
    (desk.curvePoint(desk.sheet->GetCurves()->GetNumberOfPoints() - 1) - desk.curvePoint(0)).norm();
  const vtkMTimeType time = desk.drawing()->GetMTime();
  const auto scale = desk.camera()->GetParallelScale();
  while (desk.camera()->GetParallelScale() > 0.5 * scale)
  {
    desk.wheel(true, 130, 210);
  }
  desk.event(vtkCommand::MiddleButtonPressEvent, 200, 150);
  desk.move(230, 140);
  desk.event(vtkCommand::MiddleButtonReleaseEvent, 230, 140);
  EXPECT_EQ(desk.drawing()->GetMTime(), time) << "neither zoom nor pan touches the drawing";
  const double zoom = scale / desk.camera()->GetParallelScale();
  const vtkIdType curvePoints = desk.sheet->GetCurves()->GetNumberOfPoints();
  desk.draw({ { 100, 160 }, { 150, 160 }, { 200, 160 } });
  const auto after = pointsOf(desk.drawing());
  ASSERT_EQ(after.size(), before.size() + 3);
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    EXPECT_EQ(after[i], before[i]);
  }
  const double part =
    (desk.curvePoint(desk.sheet->GetCurves()->GetNumberOfPoints() - 1) - desk.curvePoint(curvePoints)).norm();
  EXPECT_NEAR(part, whole / zoom, 1e-9 * whole);
  EXPECT_GT(zoom, 1.99);
}

TEST(DrawingWidget, TheWheelKeepsThePlaceUnderTheCursorAndTheCameraNeverTurns)
{
  Desk desk;
  const auto placeOf = [&](int x, int y)
  {
    desk.renderer->SetDisplayPoint(x, y, 0.0);
    desk.renderer->DisplayToWorld();
    const double* p = desk.renderer->GetWorldPoint();
    return Vector2(p[0] / p[3], p[1] / p[3]);
  };
  const Vector2 under = placeOf(310, 70);
  for (int i = 0; i < 40; ++i)
  {
    desk.wheel(i % 5 < 3, 310, 70);
    EXPECT_NEAR((placeOf(310, 70) - under).norm(), 0.0, 1e-9 * 400);
  }
  const double* normal = desk.camera()->GetDirectionOfProjection();
  EXPECT_EQ(normal[2], -1.0);
  // No end to the wheel is an end of the canvas.
  for (int i = 0; i < 500; ++i)
  {
    desk.wheel(false, 10, 10);
  }
  const double farthest = desk.camera()->GetParallelScale();
  EXPECT_LT(farthest, 1e3 * 400);
  EXPECT_GT(farthest, 1e2 * 300);
}

TEST(DrawingWidget, StrokesAreWhatTheyBound)
{
  Desk desk;
  Counter changes(desk.sheet, vtkCommand::WidgetValueChangedEvent);
  desk.drawRing({ 200, 150 }, 100);
  EXPECT_EQ(desk.labels("Role"), (std::vector<int>{ 1 }));
  desk.drawRing({ 200, 150 }, 40);
  desk.draw({ { 120, 150 }, { 140, 160 }, { 150, 150 } });
  EXPECT_EQ(desk.labels("Role"), (std::vector<int>{ 1, 2, 3 }));
  EXPECT_STREQ(desk.sheet->GetText(), "");
  EXPECT_EQ(changes.count, 3);
  Counter told(desk.sheet, vtkCommand::MessageEvent);
  desk.draw({ { 10, 20 }, { 30, 40 }, { 60, 20 } }); // in the void
  EXPECT_EQ(desk.labels("Role"), (std::vector<int>{ 1, 2, 3, -1 }));
  EXPECT_NE(std::string(desk.sheet->GetText()).find("troke 3"), std::string::npos) << desk.sheet->GetText();
  EXPECT_EQ(told.count, 1);
  desk.sheet->RemoveLastStroke();
  EXPECT_EQ(desk.labels("Role"), (std::vector<int>{ 1, 2, 3 }));
  EXPECT_STREQ(desk.sheet->GetText(), "");
}

TEST(DrawingWidget, StrokesCrossSpanAndBoundTogetherWhereTheyMay)
{
  Desk desk;
  // An outline of two halves, each past the other one's ends, and a line from rim to rim and beyond.
  const auto half = [](double from)
  {
    std::vector<Vector2> places;
    for (int i = -1; i <= 31; ++i)
    {
      const double angle = from + pi * i / 30.0;
      places.emplace_back(200.0 + 100.0 * std::cos(angle), 150.0 + 100.0 * std::sin(angle));
    }
    return places;
  };
  desk.draw(half(0.0));
  desk.draw(half(pi));
  desk.draw({ { 190, 46 }, { 200, 150 }, { 210, 254 } });
  desk.drawRing({ 240, 150 }, 20);
  for (const int role : desk.labels("Role"))
  {
    EXPECT_NE(role, 1) << "nothing is closed round the others";
  }
  EXPECT_STRNE(desk.sheet->GetText(), "");
  desk.sheet->ArrangeOn();
  EXPECT_STREQ(desk.sheet->GetText(), "");
  const auto roles = desk.labels("Role"), strokes = desk.labels("StrokeId");
  ASSERT_EQ(roles.size(), strokes.size());
  EXPECT_EQ(std::count(roles.begin(), roles.end(), 1), 1) << "one outline";
  EXPECT_EQ(std::count(roles.begin(), roles.end(), -1), 0);
  for (std::size_t i = 0; i < roles.size(); ++i)
  {
    EXPECT_EQ(roles[i], strokes[i] < 2 ? 1 : strokes[i] == 2 ? 3 : 2) << "stroke " << strokes[i];
  }
  // A click is the stroke's whose curve it is in, wherever that stands among the curves.
  desk.click(240, 150);
  EXPECT_EQ(desk.drawing()->GetCellData()->GetArray("Treatment")->GetComponent(3, 0), 1.0);
  const auto treatments = desk.labels("Treatment");
  EXPECT_EQ(std::count(treatments.begin(), treatments.end(), 1), 1);
  EXPECT_EQ(desk.drawing()->GetNumberOfCells(), 4);
  desk.sheet->ArrangeOff();
  EXPECT_EQ(std::count(roles.begin(), roles.end(), 1), 1);
  EXPECT_STRNE(desk.sheet->GetText(), "");
}

TEST(DrawingWidget, ATinyRingIsClosed)
{
  Desk desk;
  desk.sheet->SetCanvas(
    0.0, 0.0, 1024.0, 768.0); // 2.8 of it a pixel of the window, and 0.36 when it is nearer
  desk.drawRing({ 200, 150 }, 100);
  while (desk.camera()->GetParallelScale() > 110.0)
  {
    desk.wheel(true, 200, 150);
  }
  const double pixel = 2.0 * desk.camera()->GetParallelScale() / 300.0;
  std::vector<int> roles{ 1 };
  for (const double across : { 6.0, 8.0, 12.0 }) // of the canvas
  {
    const double x = 120.0 + 20.0 * across;
    const auto eye = Desk::closedRing({ x, 150.0 }, 0.5 * across / pixel);
    desk.draw({ eye.begin(), eye.end() - 3 }); // three sixtieths of a turn are left open
    roles.push_back(2);
    EXPECT_EQ(desk.labels("Role"), roles) << across << ": " << desk.sheet->GetText();
    EXPECT_STREQ(desk.sheet->GetText(), "") << across;
    desk.click(int(x), 150);
    EXPECT_EQ(desk.labels("Treatment").back(), 1) << across;
  }
}

TEST(DrawingWidget, AClickInAClosedFeatureCyclesWhatBecomesOfIt)
{
  Desk desk;
  desk.drawRing({ 200, 150 }, 100);
  desk.drawRing({ 200, 150 }, 60);
  desk.drawRing({ 200, 150 }, 25);
  Counter changes(desk.sheet, vtkCommand::WidgetValueChangedEvent);
  for (const int treatment : { 1, 2, 0, 1 })
  {
    desk.click(240, 150);
    EXPECT_EQ(desk.labels("Treatment"), (std::vector<int>{ 0, treatment, 0 })) << desk.sheet->GetText();
  }
  desk.click(200, 150); // the smallest one round the place
  EXPECT_EQ(desk.labels("Treatment"), (std::vector<int>{ 0, 1, 1 }));
  EXPECT_EQ(changes.count, 5);
  desk.click(125, 150); // in the object, in no closed feature
  desk.click(20, 20);
  EXPECT_EQ(changes.count, 5);
  EXPECT_EQ(desk.drawing()->GetNumberOfCells(), 3) << "a click is no stroke";
  // A hand that trembles by two pixels clicks.
  desk.draw({ { 240, 150 }, { 241, 151 }, { 240, 152 } });
  EXPECT_EQ(desk.labels("Treatment"), (std::vector<int>{ 0, 2, 1 }));
  // Escape is no click.
  desk.event(vtkCommand::LeftButtonPressEvent, 240, 150);
  desk.key("Escape", 0, 240, 150);
  desk.event(vtkCommand::LeftButtonReleaseEvent, 240, 150);
  EXPECT_EQ(desk.labels("Treatment"), (std::vector<int>{ 0, 2, 1 }));
}

TEST(DrawingWidget, ShiftReplacesAPartAndLeavesTheRestToTheBit)
{
  Desk desk;
  desk.drawRing({ 200, 150 }, 100);
  const auto before = pointsOf(desk.drawing());
  for (int i = 0; i < 6; ++i) // the correction is drawn nearer
  {
    desk.wheel(true, 300, 150);
  }
  // An arc of 30 degrees round the rightmost point, 6 units farther out in the middle.
  std::vector<Vector2> arc;
  for (int i = -15; i <= 15; ++i)
  {
    const double angle = i * pi / 180.0, bulge = 100.0 + 6.0 * std::cos(i * pi / 30.0);
    const auto at = desk.display({ 200.0 + bulge * std::cos(angle), 150.0 + bulge * std::sin(angle), 0.0 });
    arc.emplace_back(at[0], at[1]);
  }
  desk.draw(arc, Shift);
  EXPECT_EQ(desk.drawing()->GetNumberOfCells(), 1);
  const auto after = pointsOf(desk.drawing());
  const Vector2 middle(200, 150);
  int far = 0;
  for (const Vector2& p : before) // the circle's other half, as it was drawn
  {
    EXPECT_TRUE(p[0] > middle[0] || std::find(after.begin(), after.end(), p) != after.end());
  }
  EXPECT_EQ(desk.labels("Role"), (std::vector<int>{ 1 })) << desk.sheet->GetText();
  for (vtkIdType i = 0; i < desk.sheet->GetCurves()->GetNumberOfPoints(); ++i)
  {
    const Vector2 from = desk.curvePoint(i) - middle;
    far += from.norm() > 115.0 || from.norm() < 85.0;
  }
  EXPECT_EQ(far, 0);
  // Where no stroke is, nothing is corrected, and it is said.
  const vtkMTimeType time = desk.drawing()->GetMTime();
  desk.draw({ { 5, 5 }, { 10, 8 }, { 20, 5 } }, Shift);
  EXPECT_EQ(desk.drawing()->GetMTime(), time);
  EXPECT_NE(std::string(desk.sheet->GetText()).find("begin and end on the stroke"), std::string::npos);
}

TEST(DrawingWidget, AMagneticPenKeepsToThePicturesEdges)
{
  Desk desk;
  const Vector2 centre(160.0, 120.0);
  desk.sheet->SetPicture(discPicture(320, 90.0, centre));
  const auto meanDistance = [&]
  {
    double sum = 0.0;
    const vtkIdType count = desk.sheet->GetCurves()->GetNumberOfPoints();
    for (vtkIdType i = 0; i < count; ++i)
    {
      sum += std::abs((desk.curvePoint(i) - centre).norm() - 90.5);
    }
    return sum / double(count);
  };
  const auto drawRound = [&](double radius)
  {
    std::vector<Vector2> places;
    for (const Vector2& p : Desk::closedRing(centre, radius))
    {
      const auto at = desk.display({ p[0], p[1], 0.0 });
      places.emplace_back(at[0], at[1]);
    }
    desk.draw(places);
  };
  drawRound(95.0);
  EXPECT_LT(meanDistance(), 1.0);
  EXPECT_EQ(desk.labels("Role"), (std::vector<int>{ 1 }));
  EXPECT_NEAR(desk.drawing()->GetCellData()->GetArray("SnapRadius")->GetComponent(0, 0),
    10.0 * 2.0 * desk.camera()->GetParallelScale() / 300.0,
    1e-9)
    << "ten px of the window, in the picture's";
  desk.sheet->RemoveLastStroke();
  desk.sheet->MagneticOff();
  drawRound(95.0);
  EXPECT_NEAR(meanDistance(), 4.5, 0.7);
}

TEST(DrawingWidget, AClickOnAThingTracesItAndItsHoles)
{
  Desk desk;
  const Vector2 centre(160.0, 120.0);
  const auto click = [&](double x, double y)
  {
    const auto at = desk.display({ x, y, 0.0 });
    desk.click(int(std::lround(at[0])), int(std::lround(at[1])));
  };
  Counter changes(desk.sheet, vtkCommand::WidgetValueChangedEvent);
  click(200.0, 120.0); // on an empty sheet
  EXPECT_EQ(changes.count, 0);
  desk.sheet->SetPicture(picture(320,
    240,
    1,
    [&](int x, int y, int)
    {
      const double from = (Vector2(x, y) - centre).norm();
      return from < 90.0 && from > 30.0 ? 30 : 220;
    }));
  click(centre[0] + 60.0, centre[1]);
  EXPECT_EQ(changes.count, 1) << "both outlines at once";
  EXPECT_STREQ(desk.sheet->GetText(), "");
  EXPECT_EQ(desk.labels("Role"), (std::vector<int>{ 1, 2 }));
  EXPECT_EQ(desk.labels("Treatment"), (std::vector<int>{ 0, 2 }));
  for (vtkIdType i = 0; i < desk.sheet->GetCurves()->GetNumberOfPoints(); ++i)
  {
    const double from = (desk.curvePoint(i) - centre).norm();
    EXPECT_LT(std::min(std::abs(from - 90.0), std::abs(from - 30.0)), 1.5);
  }
  // A click in a closed line is what it was.
  click(centre[0], centre[1]);
  EXPECT_EQ(desk.labels("Treatment"), (std::vector<int>{ 0, 0 }));
  click(centre[0] + 60.0, centre[1]);
  EXPECT_EQ(changes.count, 2);
  // Beside it the largest thing is meant, which has its outline; beyond the picture nothing is.
  click(8.0, 8.0);
  EXPECT_EQ(changes.count, 2);
  EXPECT_NE(std::string(desk.sheet->GetText()).find("has its outline"), std::string::npos);
  EXPECT_EQ(desk.drawing()->GetNumberOfCells(), 2);
  EXPECT_TRUE(desk.sheet->SetDrawing(nullptr));
  EXPECT_TRUE(desk.sheet->Trace(8.0, 8.0));
  EXPECT_EQ(desk.drawing()->GetNumberOfCells(), 2);
  // A traced stroke is corrected as a drawn one is.
  const auto at = [&](double angle, double out)
  {
    const auto place =
      desk.display({ centre[0] + out * std::cos(angle), centre[1] + out * std::sin(angle), 0.0 });
    return Vector2(place[0], place[1]);
  };
  std::vector<Vector2> bulge;
  for (int i = -10; i <= 10; ++i)
  {
    bulge.push_back(at(0.04 * i, 90.0 + 10.0 * std::cos(0.05 * pi * i)));
  }
  desk.draw(bulge, Shift);
  EXPECT_EQ(desk.drawing()->GetNumberOfCells(), 2) << desk.sheet->GetText();
  double farthest = 0.0;
  for (vtkIdType i = 0; i < desk.sheet->GetCurves()->GetNumberOfPoints(); ++i)
  {
    farthest = std::max(farthest, (desk.curvePoint(i) - centre).norm());
  }
  EXPECT_GT(farthest, 96.0);
  // Where nothing stands out it is said.
  desk.sheet->SetDrawing(nullptr);
  desk.sheet->SetPicture(picture(320, 240, 1, [](int, int, int) { return 128; }));
  click(100.0, 100.0);
  EXPECT_NE(std::string(desk.sheet->GetText()).find("nothing to trace"), std::string::npos);
  EXPECT_EQ(desk.drawing()->GetNumberOfCells(), 0);
}

TEST(DrawingWidget, ADrawingIsTakenAndHandedOn)
{
  Desk desk, other;
  desk.drawRing({ 200, 150 }, 100);
  desk.draw({ { 150, 150 }, { 200, 160 }, { 250, 150 } });
  ASSERT_TRUE(other.sheet->SetDrawing(desk.drawing()));
  EXPECT_EQ(other.labels("Role"), desk.labels("Role"));
  EXPECT_EQ(pointsOf(other.drawing()), pointsOf(desk.drawing()));
  vtkNew<vtkPolyData> cloud; // points without polylines
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.0, 2.0, 0.0);
  cloud->SetPoints(points);
  EXPECT_FALSE(other.sheet->SetDrawing(cloud));
  EXPECT_EQ(other.drawing()->GetNumberOfCells(), 2) << "nothing has changed";
  EXPECT_TRUE(other.sheet->SetDrawing(nullptr));
  EXPECT_EQ(other.drawing()->GetNumberOfCells(), 0);
  EXPECT_EQ(other.sheet->GetCurves()->GetNumberOfPoints(), 0);
}

TEST(DrawingWidget, BadSheetsAreRefusedAndTheOldOneStays)
{
  Desk desk;
  Quiet quiet;
  desk.sheet->SetCanvas(0.0, 0.0, -1.0, 5.0);
  desk.sheet->SetCanvas(0.0, std::nan(""), 1.0, 5.0);
  auto block = picture(8, 8, 1, [](int, int, int) { return 9; });
  block->SetSpacing(1.0, -1.0, 1.0);
  desk.sheet->SetPicture(block);
  EXPECT_EQ(quiet.errors(), 3);
  EXPECT_EQ(desk.sheet->GetPicture(), nullptr);
  desk.drawRing({ 200, 150 }, 100);
  EXPECT_EQ(desk.labels("Role"), (std::vector<int>{ 1 }));
}
