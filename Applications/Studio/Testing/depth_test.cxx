// The depth of a drawing's lines, as a person gives it: by a key, in the form, by the order of the rows.
#include "line_form.h"
#include "sheet.h"
#include "step_panel.h"
#include "tool.h"

#include "vtkOversketchDrawingWidget.h"
#include "vtkOversketchInteractorStyle.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointLocator.h"
#include "vtkPolyDataConnectivityFilter.h"

#include <QComboBox>
#include <QSlider>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace oversketch_studio;
using namespace oversketch_session;

namespace
{

// The boxes of a model's bodies, the largest first.
std::vector<std::array<double, 6>> bodiesOf(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataConnectivityFilter> connected;
  connected->SetInputData(mesh);
  connected->SetExtractionModeToAllRegions();
  connected->Update();
  std::vector<std::array<double, 6>> boxes;
  const int count = connected->GetNumberOfExtractedRegions();
  connected->SetExtractionModeToSpecifiedRegions();
  for (int i = 0; i < count; ++i)
  {
    connected->InitializeSpecifiedRegionList();
    connected->AddSpecifiedRegion(i);
    connected->Update();
    vtkPolyData* body = connected->GetOutput();
    std::array<double, 6> box{ 1e9, -1e9, 1e9, -1e9, 1e9, -1e9 }; // points of others are still there
    for (vtkIdType cell = 0; cell < body->GetNumberOfCells(); ++cell)
    {
      double of[6];
      body->GetCellBounds(cell, of);
      for (int k = 0; k < 6; k += 2)
      {
        box[k] = std::min(box[k], of[k]);
        box[k + 1] = std::max(box[k + 1], of[k + 1]);
      }
    }
    boxes.push_back(box);
  }
  std::sort(
    boxes.begin(), boxes.end(), [](const auto& a, const auto& b) { return a[1] - a[0] > b[1] - b[0]; });
  return boxes;
}

double middleOf(const std::array<double, 6>& box)
{
  return 0.5 * (box[4] + box[5]);
}

// How far the farthest point is from a point of the model's image in the plane z = 0.
double asymmetryOf(vtkPolyData* mesh)
{
  vtkNew<vtkPointLocator> locator;
  locator->SetDataSet(mesh);
  double most = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double at[3], near[3];
    mesh->GetPoint(i, at);
    at[2] = -at[2];
    mesh->GetPoint(locator->FindClosestPoint(at), near);
    most = std::max(most, std::hypot(at[0] - near[0], at[1] - near[1], at[2] - near[2]));
  }
  return most;
}

struct DepthSheet : Sheet
{
  DepthSheet()
  {
    this->open();
    QTest::keyClick(&this->window, Qt::Key_F4); // lines stay where they are drawn
    this->line(beast());
  }
  void deepen()
  {
    QTest::keyClick(&this->window, Qt::Key_F5);
    this->settle();
  }
  // Without the room for the marker below it.
  QPoint middleOfRow(int row)
  {
    this->list->scrollToItem(this->list->item(row));
    return this->list->visualItemRect(this->list->item(row)).topLeft() +
           QPoint(60, this->list->fontMetrics().height() / 2);
  }
  // Takes a row to just below another one, or with -1 to just above it.
  void dragRow(int from, int to, int side)
  {
    const QPoint start = this->middleOfRow(from), end = this->middleOfRow(to) + QPoint(0, 4 * side);
    QWidget* over = this->list->viewport();
    QTest::mousePress(over, Qt::LeftButton, Qt::NoModifier, start);
    sweepMouse(over, 1, 8, [&](int i) { return start + (end - start) * i / 8; });
    QTest::mouseRelease(over, Qt::LeftButton, Qt::NoModifier, end);
    this->settle();
  }
  template <typename Widget>
  Widget* field(const QString& title)
  {
    for (auto* one : this->window.findChild<StepPanel*>()->currentWidget()->findChildren<Widget*>())
    {
      if (one->accessibleName() == title)
      {
        return one;
      }
    }
    return nullptr;
  }
  void choose(const QString& title, Qt::Key key, int times)
  {
    auto* box = this->field<QComboBox>(title);
    ASSERT_TRUE(box) << title.toStdString();
    box->setFocus();
    for (int i = 0; i < times; ++i)
    {
      QTest::keyClick(box, key);
      this->settle();
    }
  }
  // Lines of layers, among those of the picture.
  int purple()
  {
    return count(this->pad->grabFramebuffer(),
      [](const QColor& c) { return c.red() > 140 && c.blue() > 150 && c.green() < 90; });
  }
  std::string said() { return this->pad->widget()->GetSaid().text(); }
};

} // namespace

TEST(Depth, ALimbAndItsTwinAreALineAndAKey)
{
  DepthSheet sheet;
  const std::string whole = sheet.document->digest();
  // In the plane it crosses the outline.
  sheet.line(ring({ 260, 125 }, 34));
  EXPECT_NE(sheet.failure(), "");
  EXPECT_TRUE(sheet.advice->text().contains("F5 makes line 2")) << sheet.advice->text().toStdString();
  sheet.deepen();
  EXPECT_EQ(sheet.failure(), "");
  EXPECT_EQ(sheet.said(), "");
  EXPECT_EQ(sheet.row(2), "Line 2, both sides");
  ASSERT_EQ(bodiesOf(sheet.mesh()).size(), 3u);
  EXPECT_LT(asymmetryOf(sheet.mesh()), 1e-9);
  EXPECT_EQ(openEdges(sheet.mesh()), 0);
  EXPECT_TRUE(sheet.advice->text().contains("F5 puts line 2")) << sheet.advice->text().toStdString();
  const std::string both = sheet.document->digest();
  // Saved and read back: the same model, and the same lines.
  const QString saved = sheet.folder.filePath("a.oversketch");
  sheet.document->save(saved);
  EXPECT_EQ(replayed(readSession(saved.toStdString()).session), both);
  ASSERT_TRUE(sheet.window.open(saved));
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), both);
  EXPECT_EQ(sheet.row(2), "Line 2, both sides");
  // Round, and back by undo. A body in front is not in the plane, one behind is its image.
  sheet.deepen();
  EXPECT_EQ(sheet.row(2), "Line 2, in front");
  const auto front = bodiesOf(sheet.mesh());
  ASSERT_EQ(front.size(), 2u);
  EXPECT_GT(middleOf(front[1]), 1.0);
  const int solid = sheet.purple();
  EXPECT_GT(solid, 100);
  sheet.deepen();
  EXPECT_EQ(sheet.row(2), "Line 2, behind");
  const auto behind = bodiesOf(sheet.mesh());
  ASSERT_EQ(behind.size(), 2u);
  EXPECT_NEAR(middleOf(behind[1]), -middleOf(front[1]), 1e-9);
  EXPECT_LT(sheet.purple(), 0.7 * solid) << "it is not dashed";
  sheet.deepen();
  EXPECT_EQ(sheet.row(2), "Line 2");
  EXPECT_NE(sheet.failure(), "");
  for (int i = 0; i < 3; ++i)
  {
    sheet.document->undo();
  }
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), both);
  // A further line is in the plane, and what stands is as it was.
  sheet.line({ { 120, 170 }, { 140, 185 }, { 160, 170 } });
  ASSERT_EQ(sheet.strokes().size(), 3u);
  EXPECT_EQ(depthOf(sheet.strokes()[1].line), 3);
  EXPECT_EQ(depthOf(sheet.strokes()[2].line), 0);
  EXPECT_EQ(sheet.failure(), "");
  EXPECT_EQ(sheet.said(), "");
  const std::string further = sheet.document->digest();
  sheet.deepen(); // an open line bounds nothing
  EXPECT_EQ(sheet.document->digest(), further);
  EXPECT_EQ(depthOf(sheet.strokes()[2].line), 0);
  EXPECT_FALSE(whole.empty());
  const QString listed = QString::fromUtf8(sheet.view->camera()->GetKeyList());
  EXPECT_TRUE(listed.contains("\nF5 ")) << listed.toStdString();
}

TEST(Depth, LaterRowsLieFurtherOutAndAreDragged)
{
  DepthSheet sheet;
  for (const double x : { 180.0, 225.0 })
  {
    sheet.line(ring({ x, 185 }, x < 200 ? 36 : 30));
    sheet.deepen();
    sheet.deepen();
  }
  EXPECT_EQ(sheet.failure(), "");
  EXPECT_EQ(sheet.said(), "");
  ASSERT_EQ(sheet.row(3), "Line 3, in front");
  const auto before = bodiesOf(sheet.mesh());
  ASSERT_EQ(before.size(), 3u);
  EXPECT_GT(middleOf(before[2]), middleOf(before[1]));
  const std::string drawn = sheet.document->digest();
  sheet.dragRow(3, 2, -1);
  EXPECT_EQ(sheet.list->currentRow(), 2);
  const auto after = bodiesOf(sheet.mesh());
  ASSERT_EQ(after.size(), 3u);
  EXPECT_LT(after[2][1] - after[2][0], after[1][1] - after[1][0]) << "the smaller one is the second still";
  EXPECT_LT(middleOf(after[2]), middleOf(after[1]));
  const std::string dragged = sheet.document->digest();
  EXPECT_EQ(dragged, replayed(sheet.session()));
  // Keys move it there and back.
  QTest::keyClick(&sheet.window, Qt::Key_Down, Qt::ControlModifier);
  sheet.settle();
  EXPECT_EQ(sheet.list->currentRow(), 3);
  EXPECT_EQ(sheet.document->digest(), drawn);
  QTest::keyClick(&sheet.window, Qt::Key_Up, Qt::ControlModifier);
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), dragged);
  for (const std::string& earlier : { drawn, dragged, drawn })
  {
    sheet.document->undo();
    sheet.settle();
    EXPECT_EQ(sheet.document->digest(), earlier);
  }
  // To where it is, and past its drawing, it stays in it; Escape on the way leaves all as it is.
  sheet.dragRow(3, 3, 1);
  EXPECT_EQ(sheet.document->digest(), drawn);
  const QPoint from = sheet.middleOfRow(3);
  QTest::mousePress(sheet.list->viewport(), Qt::LeftButton, Qt::NoModifier, from);
  sweepMouse(sheet.list->viewport(), 1, 8, [&](int i) { return from - QPoint(0, 8 * i); });
  QTest::keyClick(sheet.list, Qt::Key_Escape);
  QTest::mouseRelease(sheet.list->viewport(), Qt::LeftButton, Qt::NoModifier, from - QPoint(0, 64));
  sheet.settle();
  EXPECT_EQ(sheet.document->digest(), drawn);
  EXPECT_EQ(sheet.strokes().size(), 3u);
}

TEST(Depth, TheFormOfALineSetsDepthHeightAndCrossSection)
{
  DepthSheet sheet;
  sheet.line(ring({ 200, 185 }, 36));
  sheet.list->setCurrentRow(2);
  ASSERT_TRUE(sheet.field<QSlider>("Height"));
  const std::string flat = sheet.document->digest();
  sheet.choose("Depth", Qt::Key_Down, 1);
  EXPECT_EQ(depthOf(sheet.strokes()[1].line), 1);
  EXPECT_EQ(heightOf(sheet.strokes()[1].line), 0.0) << "it says none";
  const auto one = bodiesOf(sheet.mesh());
  ASSERT_EQ(one.size(), 2u);
  const std::string front = sheet.document->digest();
  // Higher: so is its body, and no other.
  QTest::keyClick(sheet.field<QSlider>("Height"), Qt::Key_PageUp);
  sheet.settle();
  const double height = heightOf(sheet.strokes()[1].line);
  EXPECT_GT(height, 1.1);
  const auto higher = bodiesOf(sheet.mesh());
  ASSERT_EQ(higher.size(), 2u);
  EXPECT_NEAR(higher[1][5] - higher[1][4], height * (one[1][5] - one[1][4]), 1e-6);
  EXPECT_EQ(higher[0], one[0]);
  const std::string high = sheet.document->digest();
  sheet.choose("Cross-section", Qt::Key_Down, 2);
  EXPECT_EQ(crossSectionOf(sheet.strokes()[1].line), 2);
  EXPECT_EQ(heightOf(sheet.strokes()[1].line), height);
  EXPECT_NE(sheet.document->digest(), high);
  EXPECT_EQ(sheet.document->digest(), replayed(sheet.session()));
  // One step of undo each.
  for (const std::string& earlier : { std::string(), high, front, flat })
  {
    sheet.document->undo();
    sheet.settle();
    EXPECT_TRUE(earlier.empty() || sheet.document->digest() == earlier);
  }
  EXPECT_EQ(sheet.field<QComboBox>("Depth")->currentIndex(), 0) << "the form shows what was";
  // The drawing's row has the drawing's form.
  sheet.list->setCurrentRow(0);
  EXPECT_FALSE(sheet.field<QComboBox>("Depth"));
  EXPECT_TRUE(sheet.field<QSlider>("Height"));
}

TEST(Depth, ALineThatIsRedrawnKeepsIt)
{
  DepthSheet sheet;
  // The remark on a line over nothing calls it as the rows do.
  sheet.line(ring({ 360, 60 }, 20));
  sheet.deepen();
  EXPECT_TRUE(sheet.advice->text().startsWith("Line 2 lies over nothing"))
    << sheet.advice->text().toStdString();
  sheet.document->undo();
  sheet.document->undo();
  sheet.settle();
  sheet.line(ring({ 200, 185 }, 36));
  sheet.deepen();
  sheet.list->setCurrentRow(2);
  sheet.choose("Cross-section", Qt::Key_Down, 2);
  const auto expectKept = [&](double left)
  {
    ASSERT_EQ(sheet.strokes().size(), 2u);
    EXPECT_EQ(depthOf(sheet.strokes()[1].line), 3);
    EXPECT_EQ(crossSectionOf(sheet.strokes()[1].line), 2);
    EXPECT_EQ(sheet.failure(), "");
    EXPECT_EQ(sheet.said(), "");
    const auto bodies = bodiesOf(sheet.mesh());
    ASSERT_EQ(bodies.size(), 3u);
    EXPECT_NEAR(bodies[1][0], left, 4.0);
  };
  expectKept(164.0);
  sheet.action("&Redraw")->trigger();
  sheet.line(ring({ 240, 185 }, 36));
  expectKept(204.0);
  // A part of it, by Shift, further to the left.
  Places bulge;
  for (int i = 0; i <= 20; ++i)
  {
    const double angle = M_PI * (0.5 + i / 20.0);
    bulge.push_back(QPointF(240, 185) +
                    QPointF((36 + 14 * std::sin(M_PI * i / 20.0)) * std::cos(angle), 36 * std::sin(angle)));
  }
  sheet.line(bulge, Qt::ShiftModifier);
  expectKept(190.0);
}
