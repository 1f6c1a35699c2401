// What a bad hand is told in the window, and that it spoils nothing.
#include "message_text.h"
#include "mouse.h"
#include "scene.h"

#include "vtkMath.h"

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace oversketch_studio
{
namespace
{

// No name of the code stands in what a person is told.
void expectPlain(const QString& words)
{
  static const QRegularExpression name("\\b[A-Z][a-z]+[A-Z]\\w*|\\bvtk\\w*");
  EXPECT_FALSE(name.match(words).hasMatch()) << qPrintable(words);
}

struct BadHands : Scene
{
  BadHands()
    : Scene(wholeWindow)
  {
  }

  void stroke(const std::vector<QPoint>& path)
  {
    this->settle();
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, path.front());
    sweepMouse(this->view, path);
    QTest::mouseRelease(this->view, Qt::LeftButton, Qt::NoModifier, path.back());
    this->wait();
    QApplication::processEvents();
  }
  // One row that did nothing and says why, and the model as it was.
  void expectRefused(const std::string& words, const std::string& before)
  {
    const auto& nodes = this->document->result().nodes;
    ASSERT_EQ(nodes.size(), 1u);
    EXPECT_NE(nodes[0].failure.text().find(words), std::string::npos) << nodes[0].failure;
    EXPECT_EQ(this->document->digest(), before);
    const QString advice = this->window.findChild<QLabel*>("advice")->text();
    EXPECT_TRUE(advice.contains("did nothing")) << qPrintable(advice);
    expectPlain(advice);
    // A button does what is asked for; the next pen-down ends what was said.
    auto* anyway = this->window.findChild<QPushButton*>("anyway");
    const bool isAsked = nodes[0].failure.text().find("AllowTorn") != std::string::npos;
    EXPECT_EQ(anyway->isVisible(), isAsked) << nodes[0].failure;
    if (isAsked)
    {
      anyway->click();
      const auto& values = this->document->session().nodes[0].step->values;
      EXPECT_TRUE(values.count("AllowTorn") == 1 && std::get<bool>(values.at("AllowTorn")));
      this->document->undo();
      this->wait();
    }
    const QPoint corner(20, this->view->height() - 20);
    QTest::mousePress(this->view, Qt::LeftButton, Qt::NoModifier, corner);
    EXPECT_FALSE(this->window.findChild<QLabel*>("advice")->text().contains("did nothing"));
    EXPECT_FALSE(anyway->isVisible());
    QTest::mouseRelease(this->view, Qt::LeftButton, Qt::NoModifier, corner);
    this->document->undo();
    this->wait();
    EXPECT_TRUE(this->document->session().nodes.empty());
  }
};

} // namespace

TEST(BadHand, IsToldHowFarFromTheModelALineIsAndThatAResultTears)
{
  BadHands scene;
  const std::string before = scene.document->digest();
  std::vector<QPoint> line;
  const QPoint corner(scene.view->width() - 20, scene.view->height() - 20);
  for (int i = 40; i >= 0; --i)
  {
    line.push_back(corner - QPoint(3 * i, 0));
  }
  scene.stroke(line);
  scene.expectRefused("px from any outline", before);
  // A loop over the tail, many times as large as it.
  const QPoint tip = scene.top();
  std::vector<QPoint> loop;
  for (int i = 0; i <= 100; ++i)
  {
    const double angle = 0.0628 * i;
    loop.push_back(tip + QPoint(static_cast<int>(std::lround(320.0 * std::sin(angle))),
                           static_cast<int>(std::lround(180.0 * (1.0 - std::cos(angle))))));
  }
  scene.stroke(loop);
  scene.expectRefused("would tear the mesh", before);
}

// What filters say by the names of their properties.
TEST(BadHand, IsToldNoNameOfTheCode)
{
  using oversketch::Message;
  const Message torn(
    "The stroke would tear the mesh: %1. Draw it nearer to the outline that it is to replace, of one "
    "limb alone, or, if that is meant, {AllowTorn on}.",
    Message("edges are stretched or squeezed %1 times", 9));
  const Message step(
    "The curve under the sketch takes a step of %1 at sample %2, longer than %3 ({maximumStep}): "
    "between the stroke's ends there is no surface for it to follow. An outline drawn anew is for "
    "bumps and dents: draw nearer to the outline of one part, or pull a limb by one-stroke (or take "
    "the projection Path).",
    2.5,
    7,
    1.2);
  const Message beyond("Only %1 sections fit the stroke; there is no number %2. Lower {candidate}.", 2, 3);
  for (const Message& said :
    { torn,
      step,
      beyond,
      Message(
        "The stroke is %1 px from any outline, more than {maximumGap} = %2 px. Draw it along the outline "
        "that it is to replace.",
        91,
        60),
      Message(
        "Fewer than two control points of the section lie on one layer of the mesh; {SingleLayer off} or "
        "draw along another outline."),
      Message(
        "The refinement needs more than {maximumFaces} (%1) new triangles, about %2 or more; ask for longer "
        "edges ({targetEdgeLength}) or a larger tolerance, a smaller {radius} or {maxGeneration}.",
        10000000,
        "3e+08") })
  {
    expectPlain(plainWords(said));
  }
  EXPECT_EQ(plainWords(torn), "it would spoil the model: edges are stretched or squeezed 9 times.");
  EXPECT_TRUE(plainWords(beyond).endsWith("Lower Other outline."));
  EXPECT_TRUE(plainWords("{AllowTorn on}.").endsWith("tick Even if it tears."));
  EXPECT_TRUE(plainWords(step).endsWith("or pull a limb with the tool Outline (D)."))
    << "a limb is not for this tool";
  EXPECT_EQ(askedFor(torn), "AllowTorn");
  EXPECT_EQ(askedFor(beyond), "");
  EXPECT_EQ(briefWords({ "The result is not as drawn: %1.",
              std::vector<Message>{
                { "the outline misses the stroke by %1 px in the mean and by %2 px at worst", 9, 36 },
                { "what lies up to %1 px beside the stroke moved too, by up to %2 px", 82, 4 },
                { "%1 edges are folded over", 104 } } }),
    "Not as drawn: the outline is beside the line, parts beside the line moved, too, some of it is folded.");
}

// A model so coarse that no line, however short, leaves anything of it where it is.
TEST(BadHand, IsToldThatAModelHasTooFewTriangles)
{
  const QTemporaryDir folder;
  QFile file(folder.filePath("cube.obj"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  for (const char* corner : { "0 0 0", "1 0 0", "1 1 0", "0 1 0", "0 0 1", "1 0 1", "1 1 1", "0 1 1" })
  {
    file.write(QByteArray("v ") + corner + '\n');
  }
  for (const char* side : { "1 4 3",
         "1 3 2",
         "5 6 7",
         "5 7 8",
         "1 2 6",
         "1 6 5",
         "4 8 7",
         "4 7 3",
         "1 5 8",
         "1 8 4",
         "2 3 7",
         "2 7 6" })
  {
    file.write(QByteArray("f ") + side + '\n');
  }
  file.close();
  BadHands scene;
  ASSERT_TRUE(scene.window.open(file.fileName()));
  scene.wait();
  const std::string before = scene.document->digest();
  const QPoint over = scene.top();
  std::vector<QPoint> line;
  for (int i = 0; i <= 30; ++i)
  {
    line.push_back(over + QPoint(20 + 3 * i, -20));
  }
  scene.stroke(line);
  const QString advice = scene.window.findChild<QLabel*>("advice")->text();
  EXPECT_TRUE(advice.contains("too few triangles")) << qPrintable(advice);
  EXPECT_FALSE(advice.contains("shorter")) << qPrintable(advice);
  scene.expectRefused("", before);
}

// Lines beside what they mean, by 20 px where the dog is 465 px long: the tail's, and one 30 px inside the
// back.
TEST(BadHand, LinesBesideATailAndInTheBodyMoveNothingElse)
{
  BadHands scene;
  const auto before = scene.document->result().mesh;
  std::set<std::array<double, 3>> there;
  int least = scene.view->width(), most = 0;
  for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p{};
    before->GetPoint(i, p.data());
    there.insert(p);
    const int x = scene.seen(p.data()).x();
    least = std::min(least, x);
    most = std::max(most, x);
  }
  const double length = (most - least) / 465.0; // [px]
  const QPoint tip = scene.top();
  // By shares of that from the tail's tip, which is the highest place.
  const auto draw = [&](const std::vector<QPointF>& corners)
  {
    std::vector<QPoint> line;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    {
      for (int k = 0; k < 6; ++k)
      {
        line.push_back(tip + (length * (corners[i] + k / 6.0 * (corners[i + 1] - corners[i]))).toPoint());
        EXPECT_TRUE(scene.view->rect().contains(line.back()));
      }
    }
    scene.stroke(line);
    ASSERT_EQ(scene.document->result().nodes.size(), 1u);
    EXPECT_EQ(scene.document->result().nodes[0].failure, "");
  };
  // How many points are where there was none, and how many of these outside.
  const auto expectWithin = [&](const QRectF& zone)
  {
    const auto after = scene.document->result().mesh;
    int moved = 0, outside = 0;
    for (vtkIdType i = 0; i < after->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> p{};
      after->GetPoint(i, p.data());
      if (!there.count(p))
      {
        ++moved;
        outside += zone.contains(QPointF(scene.seen(p.data()) - tip) / length) ? 0 : 1;
      }
    }
    EXPECT_GT(moved, 50);
    EXPECT_EQ(outside, 0) << "of " << moved;
  };
  draw({ { -42, 58 },
    { -35, 20 },
    { -27, 0 },
    { -10, -33 },
    { 10, -55 },
    { 25, -67 },
    { 38, -67 },
    { 42, -58 },
    { 35, -38 },
    { 15, -12 },
    { -5, 15 },
    { -15, 35 },
    { -21, 58 } });
  expectWithin({ QPointF(-100, -150), QPointF(80, 130) }); // the tail
  scene.document->undo();
  scene.wait();
  draw({ { 106, 155 }, { 153, 172 }, { 198, 164 }, { 240, 173 } });
  expectWithin({ QPointF(0, 90), QPointF(320, 260) }); // from the tail's root to the neck, without the legs
}

TEST(BadHand, ALineAlongTheBackTakesNoLimbWithIt)
{
  BadHands scene;
  const auto before = scene.document->result().mesh;
  const vtkIdType count = before->GetNumberOfPoints();
  std::vector<QPoint> places;
  for (vtkIdType i = 0; i < count; ++i)
  {
    places.push_back(scene.seen(before->GetPoint(i)));
  }
  const auto [left, right] = std::minmax_element(
    places.begin(), places.end(), [](const QPoint& a, const QPoint& b) { return a.x() < b.x(); });
  const int width = right->x() - left->x(), from = left->x() + 3 * width / 10, to = left->x() + width / 2;
  std::map<int, int> back; // the highest place of each column
  for (const QPoint& place : places)
  {
    if (place.x() >= from && place.x() <= to)
    {
      int& highest = back.emplace(place.x() / 6, place.y()).first->second;
      highest = std::min(highest, place.y());
    }
  }
  std::vector<QPoint> line;
  for (const auto& [column, highest] : back)
  {
    const double along = (6.0 * column + 3.0 - from) / (to - from);
    line.emplace_back(
      6 * column + 3, highest - static_cast<int>(std::lround(16.0 * std::sin(3.14159265 * along))));
  }
  ASSERT_GT(line.size(), 10u);
  scene.stroke(line);
  const auto& result = scene.document->result();
  ASSERT_EQ(result.nodes.size(), 1u);
  EXPECT_EQ(result.nodes[0].failure, "");
  ASSERT_EQ(result.mesh->GetNumberOfPoints(), count);
  const int low = line.front().y() + width / 6;
  int moved = 0, farOff = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3], q[3];
    before->GetPoint(i, p);
    result.mesh->GetPoint(i, q);
    if (vtkMath::Distance2BetweenPoints(p, q) > 0.0)
    {
      const QPoint& place = places[static_cast<std::size_t>(i)];
      ++moved;
      farOff += place.x() < from - width / 10 || place.x() > to + width / 10 || place.y() > low ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 50);
  EXPECT_EQ(farOff, 0) << moved << " moved";
}

} // namespace oversketch_studio
