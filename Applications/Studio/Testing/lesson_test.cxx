// Lessons play themselves in the window, undo what they drew, and leave the rest to the learner.
#include "lesson.h"
#include "scene.h"
#include "tool.h"

#include "drawing_lines.h"

#include <QLabel>

using namespace oversketch_studio;

namespace
{

constexpr double haste = 2.0; // times as fast as for a learner

struct LessonScene : Scene
{
  LessonScene()
    : Scene(wholeWindow)
    , player(window.findChild<LessonPlayer*>())
  {
    QElapsedTimer time;
    time.start();
    this->player->setClock([time] { return haste * static_cast<double>(time.elapsed()); });
  }
  // Until the hand has drawn something, and the model is there.
  bool isDrawn()
  {
    return QTest::qWaitFor([this] { return this->document->canUndo(); }, 120000) &&
           QTest::qWaitFor([this] { return this->document->isSettled(); }, 120000);
  }
  bool isOver()
  {
    return QTest::qWaitFor([this] { return !this->player->isPlaying(); }, 240000);
  }

  LessonPlayer* player;
};

} // namespace

TEST(Lessons, PlayThemselvesAndLeaveTheModelToTheLearner)
{
  LessonScene scene;
  const QVector<Lesson> all = lessons();
  ASSERT_EQ(all.size(), 3);
  for (const Lesson& lesson : all)
  {
    SCOPED_TRACE(qPrintable(lesson.title));
    scene.action(lesson.title)->trigger();
    ASSERT_TRUE(scene.player->isPlaying());
    const bool isDrawing = lesson.example.file.isEmpty();
    const int strokes = isDrawing ? 0 : static_cast<int>(scene.document->session().nodes.size());
    ASSERT_TRUE(scene.isDrawn());
    EXPECT_EQ(scene.view->tool()->system(), lesson.system);
    ASSERT_TRUE(QTest::qWaitFor([&] { return scene.player->words() == lesson.done; }, 120000));
    scene.wait();
    const auto& nodes = scene.document->session().nodes;
    if (isDrawing)
    {
      EXPECT_EQ(oversketch_session::strokesOf(*nodes.front().step).size(), std::size_t(lesson.count));
    }
    else
    {
      EXPECT_EQ(static_cast<int>(nodes.size()), strokes + lesson.count);
    }
    for (const auto& state : scene.document->result().nodes)
    {
      EXPECT_EQ(state.failure, "");
      EXPECT_EQ(state.remark, "") << "what it teaches is flawless";
    }
    ASSERT_TRUE(scene.document->result().mesh);
    EXPECT_GT(scene.document->result().mesh->GetNumberOfPoints(), 100);
    EXPECT_EQ(scene.window.findChild<QLabel*>("lesson_pen")->isVisible(), false);
    ASSERT_TRUE(scene.isOver());
    EXPECT_FALSE(scene.document->canUndo()) << "the example is as it was";
    EXPECT_FALSE(scene.document->isModified());
    EXPECT_EQ(scene.view->hint(), scene.view->tool()->hint()) << "where to draw";
  }
}

TEST(Lessons, EndWhereTheLearnerTakesTheMouse)
{
  LessonScene scene;
  scene.action(lessons().front().title)->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return scene.view->tool()->draws(); }, 120000));
  QTest::mouseClick(&scene.window, Qt::LeftButton, Qt::NoModifier, QPoint(2, 2));
  EXPECT_FALSE(scene.player->isPlaying());
  EXPECT_FALSE(scene.view->tool()->draws()) << "the line is given up";
  scene.wait();
  EXPECT_FALSE(scene.document->canUndo());
  EXPECT_EQ(scene.window.findChild<QLabel*>("lesson_pen"), nullptr);
}
