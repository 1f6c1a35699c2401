// Ten tasks of a newcomer, each reached by real events in the window, and how many actions it takes: a click,
// a key with what is held beside it, a drag, a name typed into a dialogue. Testing/Studio/TASKS.md
// lists them.
#include "evaluator.h"
#include "files.h"
#include "lesson.h"
#include "mesh_file.h"
#include "profile_editor.h"
#include "scene.h"
#include "session_file.h"
#include "sheet.h"
#include "texture.h"

#include "vtkPointData.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QPointF>
#include <QProcess>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

using namespace oversketch_studio;
using namespace oversketch_session;

namespace
{

using Path = std::vector<QPoint>;

struct Newcomer : Scene
{
  Newcomer() { QApplication::setActiveWindow(&this->window); }

  void settle()
  {
    QApplication::processEvents();
    this->wait();
    QApplication::processEvents();
  }
  // Says what the actions since the last task were for.
  void did(const char* task, int expected)
  {
    std::printf("%-40s %d actions\n", task, this->actions);
    std::fflush(stdout);
    EXPECT_EQ(this->actions, expected) << task;
    this->actions = 0;
  }
  void key(Qt::Key key, Qt::KeyboardModifiers held = Qt::NoModifier)
  {
    ++this->actions;
    QTest::keyClick(this->view, key, held);
    this->settle();
  }
  void click(QWidget* on, const QPoint& at)
  {
    ++this->actions;
    QTest::mouseClick(on, Qt::LeftButton, Qt::NoModifier, at);
    QApplication::processEvents();
  }
  void drag(QWidget* on, const Path& path, Qt::KeyboardModifiers held = Qt::NoModifier)
  {
    ++this->actions;
    const auto send = [on, held](
                        QEvent::Type type, const QPoint& at, Qt::MouseButton button, Qt::MouseButtons down)
    {
      QMouseEvent event(type, at, on->mapToGlobal(at), button, down, held);
      QApplication::sendEvent(on, &event);
      QApplication::processEvents();
    };
    send(QEvent::MouseMove, path.front(), Qt::NoButton, Qt::NoButton);
    send(QEvent::MouseButtonPress, path.front(), Qt::LeftButton, Qt::LeftButton);
    for (const QPoint& at : path)
    {
      send(QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton);
    }
    send(QEvent::MouseButtonRelease, path.back(), Qt::LeftButton, Qt::NoButton);
    this->settle();
  }
  // A key that asks for a file, its name, Return.
  void file(Qt::Key key, const QString& path)
  {
    this->answering(path, [&] { this->key(key, Qt::ControlModifier); });
  }
  // A question for a number takes the one that is there, by Return.
  void answering(const QString& path, const std::function<void()>& ask)
  {
    bool answered = false;
    QTimer timer;
    QObject::connect(&timer,
      &QTimer::timeout,
      [&]
      {
        if (auto* number = qobject_cast<QInputDialog*>(QApplication::activeModalWidget()))
        {
          ++this->actions;
          QTest::keyClick(number, Qt::Key_Return);
          return;
        }
        auto* dialogue = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        auto* name = dialogue ? dialogue->findChild<QLineEdit*>() : nullptr;
        if (!name)
        {
          return;
        }
        name->selectAll();
        QTest::keyClicks(name, path);
        this->actions += answered ? 0 : 2; // the name, and Return
        answered = true;
        timer.setInterval(
          2000); // a dialogue whose folder a busy machine has not read yet leaves its button off
        QTest::keyClick(name, Qt::Key_Return);
      });
    timer.start(50);
    ask();
    EXPECT_TRUE(answered) << "no dialogue";
    QApplication::setActiveWindow(&this->window); // there is no window manager that would
  }
  // Menus and an entry, a click each.
  void menu(const QStringList& path)
  {
    QWidget* at = this->window.menuBar();
    for (const QString& text : path)
    {
      const auto all = at->actions();
      const auto one = std::find_if(
        all.begin(), all.end(), [&](QAction* entry) { return entry->text().remove('&').startsWith(text); });
      ASSERT_NE(one, all.end()) << text.toStdString();
      auto* menu = qobject_cast<QMenu*>(at);
      this->click(at,
        menu ? menu->actionGeometry(*one).center() : this->window.menuBar()->actionGeometry(*one).center());
      QMenu* next = (*one)->menu();
      ASSERT_TRUE(!next || QTest::qWaitFor([next] { return next->isVisible(); }, 60000));
      at = next;
    }
  }
  // The choice is opened by one click, taken by another.
  void choose(QComboBox* among, int row)
  {
    this->click(among, among->rect().center());
    ASSERT_TRUE(QTest::qWaitFor([&] { return among->view()->isVisible(); }, 60000));
    QTest::qWait(QApplication::doubleClickInterval() + 50); // or it would be the first one's second half
    const QRect at = among->view()->visualRect(among->model()->index(row, 0));
    this->click(among->view()->viewport(), at.center());
    this->settle();
    EXPECT_EQ(among->currentIndex(), row);
  }
  QPoint farthest(const QPointF& towards)
  {
    vtkPolyData* mesh = this->document->result().mesh;
    QPoint best;
    double most = -std::numeric_limits<double>::infinity();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const QPoint at = this->seen(mesh->GetPoint(i));
      const double along = QPointF::dotProduct(at, towards);
      if (along > most)
      {
        most = along;
        best = at;
      }
    }
    return best;
  }
  // An arch that hugs the limb that reaches farthest in a direction of the screen, and prolongs it.
  Path arch(const QPointF& towards, double by)
  {
    constexpr double back = 30.0; // px from the tip
    const QPointF across(-towards.y(), towards.x()), tip = this->farthest(towards);
    vtkPolyData* mesh = this->document->result().mesh;
    double least = 0.0, most = 0.0; // of the limb there
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const QPointF from = QPointF(this->seen(mesh->GetPoint(i))) - tip;
      const double aside = QPointF::dotProduct(from, across);
      if (std::abs(QPointF::dotProduct(from, towards) + back) < 6.0 && std::abs(aside) < 60.0)
      {
        least = std::min(least, aside);
        most = std::max(most, aside);
      }
    }
    Path path;
    for (int i = 0; i <= 40; ++i)
    {
      const double t = 0.05 * i - 1.0, side = std::min(1.0, std::max(-1.0, 4.0 * t));
      const double aside = 0.5 * (least + most) + side * (0.5 * (most - least) + 3.0);
      path.push_back((tip + towards * ((back + by) * (1.0 - t * t) - back) + across * aside).toPoint());
    }
    return path;
  }
  // A straight line of that many moves.
  static Path line(const QPoint& from, const QPoint& to, int moves = 30)
  {
    Path path;
    for (int i = 0; i <= moves; ++i)
    {
      path.push_back(from + (to - from) * i / moves);
    }
    return path;
  }
  // The last step's system; nothing of the session has failed.
  std::string made()
  {
    EXPECT_EQ(this->failures(), "");
    const auto& nodes = this->document->session().nodes;
    return nodes.empty() ? std::string() : nodes.back().step->system;
  }
  vtkPolyData* mesh() { return this->document->result().mesh; }
  std::string failures()
  {
    std::string all;
    for (const auto& node : this->document->result().nodes)
    {
      all += node.failure.text();
    }
    return all;
  }
  double bound(int which)
  {
    double box[6];
    this->mesh()->GetBounds(box);
    return box[which];
  }

  int actions = 0;
};

} // namespace

TEST(Tasks, OfANewcomerTakeFewActions)
{
  const QTemporaryDir folder;
  Newcomer hand;
  const auto model = [](const char* name)
  { return QString(OVERSKETCH_DATA_FOLDER) + "/" + QString::fromLatin1(name); };

  hand.file(Qt::Key_O, model("Models/person.ply"));
  EXPECT_EQ(hand.document->name(), "person.ply");
  const std::string opened = hand.document->digest();
  hand.did("Open one's own model", 3);

  const double sole = hand.bound(2), height = hand.bound(3) - sole;
  hand.drag(hand.view, hand.arch({ 0.0, 1.0 }, 40.0));
  EXPECT_EQ(hand.failures(), "");
  EXPECT_LT(hand.bound(2), sole - 0.02 * height);
  const std::string longer = hand.document->digest();
  hand.did("A longer leg", 1);

  hand.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(hand.document->digest(), opened);
  hand.did("Undo", 1);
  QTest::keyClick(hand.view, Qt::Key_Y, Qt::ControlModifier);
  hand.settle();
  ASSERT_EQ(hand.document->digest(), longer);

  hand.key(Qt::Key_B);
  const QPoint belly = hand.seen(hand.mesh()->GetCenter()) - QPoint(0, 40);
  Path vein;
  for (int i = 0; i <= 20; ++i)
  {
    vein.push_back(belly + QPoint(static_cast<int>(std::lround(6.0 * std::sin(0.3 * i))), 3 * i));
  }
  hand.drag(hand.view, vein);
  ASSERT_EQ(hand.document->session().nodes.size(), 2u);
  EXPECT_EQ(hand.document->session().nodes[1].step->system, "Augment");
  EXPECT_EQ(hand.failures(), "");
  const std::string raised = hand.document->digest();
  EXPECT_NE(raised, longer);
  hand.did("Raise a vein", 2);

  auto* curve = hand.window.findChild<ProfileCurve*>("profile_curve");
  ASSERT_TRUE(curve->isVisible());
  const QPoint handle = curve->placeOf(2);
  hand.drag(curve, { handle, handle - QPoint(0, 6), handle - QPoint(0, 12) });
  EXPECT_EQ(hand.failures(), "");
  EXPECT_NE(hand.document->digest(), raised);
  hand.did("Edit its profile", 1);

  auto* rows = hand.window.findChild<QListWidget*>("history");
  hand.click(rows->viewport(), rows->visualItemRect(rows->item(0)).center());
  hand.key(Qt::Key_R, Qt::ControlModifier);
  const auto before = hand.document->session().nodes;
  const double lower = hand.bound(2);
  hand.drag(hand.view, hand.arch({ 0.0, 1.0 }, 25.0));
  ASSERT_EQ(hand.document->session().nodes.size(), 2u);
  EXPECT_NE(hand.document->session().nodes[0].step, before[0].step);
  EXPECT_EQ(hand.document->session().nodes[1].step, before[1].step);
  EXPECT_EQ(hand.failures(), "");
  EXPECT_NE(hand.bound(2), lower);
  hand.did("Replace stroke 1, the later one follows", 3);
  QTest::keyClick(hand.view, Qt::Key_Escape);
  QTest::keyClick(hand.view, Qt::Key_Return);

  QTest::keyClick(hand.view, Qt::Key_D);
  hand.settle();
  const double left = hand.bound(0), right = hand.bound(1);
  const auto choices = hand.window.findChildren<QComboBox*>("mirror"); // each tool has its own
  const auto seen =
    std::find_if(choices.begin(), choices.end(), [](QComboBox* one) { return one->isVisible(); });
  ASSERT_NE(seen, choices.end());
  hand.choose(*seen, 1);
  hand.drag(hand.view, hand.arch({ 0.9, 0.436 }, 30.0));
  ASSERT_EQ(hand.document->session().nodes.size(), 3u);
  EXPECT_TRUE(hand.document->session().nodes[2].step->mirror);
  EXPECT_EQ(hand.failures(), "");
  EXPECT_GT(hand.bound(1), right + 0.01 * height);
  EXPECT_LT(hand.bound(0), left - 0.01 * height);
  hand.did("Mirror an arm", 3);

  const QString saved = folder.filePath("person.oversketch"), made = folder.filePath("replayed.vtp");
  hand.file(Qt::Key_S, saved);
  QProcess server; // scp and ssh would be one line more
  ++hand.actions;
  server.start(OVERSKETCH_COMMAND, { "replay", saved, "-o", made });
  ASSERT_TRUE(server.waitForFinished(600000));
  EXPECT_EQ(server.exitCode(), 0) << server.readAllStandardError().toStdString();
  oversketch_files::Notes notes;
  EXPECT_EQ(digestOf(oversketch_files::readMesh(made.toStdString(), notes)), hand.document->digest());
  hand.did("Send a session and replay it there", 4);

  const QString photo = model("Drawings/fish.png");
  hand.file(Qt::Key_N, photo);
  auto* pad = hand.window.findChild<DrawingPad*>();
  ASSERT_TRUE(pad->isVisible());
  const QImage picture(photo);
  vtkRenderer* from = pad->renderWindow()->GetRenderers()->GetFirstRenderer();
  Path outline;
  for (const QPointF& place : ring({ 0.5 * picture.width(), 0.5 * picture.height() }, 0.3 * picture.height()))
  {
    from->SetWorldPoint(place.x(), place.y(), 0.0, 1.0);
    from->WorldToDisplay();
    const double* at = from->GetDisplayPoint();
    outline.emplace_back(static_cast<int>(at[0]), pad->height() - 1 - static_cast<int>(at[1]));
  }
  hand.drag(pad, outline);
  EXPECT_EQ(hand.failures(), "");
  ASSERT_TRUE(hand.mesh() && hand.mesh()->GetNumberOfPolys() > 0);
  EXPECT_EQ(openEdges(hand.mesh()), 0);
  hand.did("Draw over a photo", 4);

  const QString exported = folder.filePath("fish.glb");
  hand.file(Qt::Key_E, exported);
  const auto textured = oversketch_files::readMesh(exported.toStdString(), notes);
  ASSERT_TRUE(textured);
  EXPECT_FALSE(oversketch_files::textureOf(textured).empty());
  hand.did("Export it with its texture", 3);
}

// Smoothing, masks, poses, places and traced outlines, on the shipped dog and a picture.
TEST(Tasks, OfWhoGoesOnTakeFewActionsToo)
{
  Newcomer hand;
  const QPoint back = hand.seen(hand.mesh()->GetCenter()) - QPoint(10, 20);
  const Path flank = Newcomer::line(back - QPoint(40, 0), back + QPoint(40, 4));
  QTest::keyClick(hand.view, Qt::Key_B);
  hand.drag(hand.view, flank);
  ASSERT_EQ(hand.made(), "Augment");
  hand.actions = 0;
  hand.key(Qt::Key_Return); // with Shift a part of the red line would be drawn anew
  hand.drag(hand.view, flank, Qt::ShiftModifier);
  EXPECT_EQ(hand.made(), "Relax");
  hand.did("Smooth a line away", 2);

  hand.key(Qt::Key_4);
  Path lasso;
  for (const QPointF& place : ring(back, 40.0))
  {
    lasso.push_back(place.toPoint());
  }
  hand.drag(hand.view, lasso);
  EXPECT_EQ(hand.made(), "Mask");
  EXPECT_TRUE(hand.mesh()->GetPointData()->HasArray("Mask"));
  hand.did("Keep a part as it is", 2);

  const QPoint tip = hand.farthest({ 0.0, -1.0 }); // of the tail
  const QPoint root = tip + QPoint(-10, 70);
  hand.key(Qt::Key_6);
  hand.drag(hand.view, Newcomer::line(root, tip));
  hand.drag(hand.view, Newcomer::line(root, root + QPoint(-60, -40)));
  EXPECT_EQ(hand.made(), "Pose");
  EXPECT_LT(hand.seen(hand.mesh()->GetCenter()).y(), hand.view->height());
  EXPECT_GT(hand.farthest({ 0.0, -1.0 }).y(), tip.y() + 10) << "the tail is down";
  hand.did("Bend a limb", 3);

  const double before = hand.bound(0), width = hand.bound(1) - before;
  hand.key(Qt::Key_7);
  const QPoint body = hand.seen(hand.mesh()->GetCenter());
  hand.click(hand.view, body);
  hand.settle();
  hand.drag(hand.view, Newcomer::line(body + QPoint(45, 0), body + QPoint(85, 0)));
  EXPECT_EQ(hand.made(), "Transform");
  EXPECT_GT(hand.bound(0), before + 0.02 * width);
  EXPECT_NEAR(hand.bound(1) - hand.bound(0), width, 1e-6 * width);
  hand.did("Move a model", 3);

  const vtkIdType once = hand.mesh()->GetNumberOfPoints();
  ++hand.actions; // and the key
  QTest::mouseDClick(
    hand.view, Qt::LeftButton, Qt::NoModifier, hand.seen(hand.mesh()->GetCenter()) + QPoint(-30, -15));
  ++hand.actions;
  hand.settle();
  EXPECT_EQ(hand.made(), "Transform");
  EXPECT_EQ(hand.mesh()->GetNumberOfPoints(), 2 * once);
  hand.did("Its twin in the mirror", 2);
}

TEST(Tasks, ASilhouetteIsAModelInFourActions)
{
  Newcomer hand;
  const QTemporaryDir folder;
  const QString picture = folder.filePath("disc.png");
  QImage disc(300, 200, QImage::Format_RGB32);
  disc.fill(Qt::white);
  QPainter painter(&disc);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(Qt::black);
  painter.drawEllipse(QPoint(150, 100), 90, 70);
  painter.end();
  ASSERT_TRUE(disc.save(picture));
  hand.file(Qt::Key_N, picture);
  auto* pad = hand.window.findChild<DrawingPad*>();
  ASSERT_TRUE(pad->isVisible());
  hand.click(pad, pad->rect().center());
  hand.settle();
  EXPECT_EQ(hand.made(), "InflateDrawing");
  ASSERT_TRUE(hand.mesh() && hand.mesh()->GetNumberOfPolys() > 0);
  EXPECT_EQ(openEdges(hand.mesh()), 0);
  EXPECT_NEAR(hand.bound(1) - hand.bound(0), 180.0, 3.0);
  hand.did("A model of a silhouette", 4);

  vtkRenderer* from = pad->renderWindow()->GetRenderers()->GetFirstRenderer();
  const auto onPad = [&](const QPointF& place)
  {
    from->SetWorldPoint(place.x(), place.y(), 0.0, 1.0);
    from->WorldToDisplay();
    const double* at = from->GetDisplayPoint();
    return QPoint(static_cast<int>(at[0]), pad->height() - 1 - static_cast<int>(at[1]));
  };
  Path limb;
  for (const QPointF& place : ring({ 190.0, 100.0 }, 30.0))
  {
    limb.push_back(onPad(place));
  }
  const double thick = hand.bound(5);
  hand.drag(pad, limb);
  hand.key(Qt::Key_F5);
  EXPECT_EQ(hand.failures(), "");
  EXPECT_GT(hand.bound(5), thick);
  EXPECT_EQ(hand.bound(5), -hand.bound(4)) << "one stands in front, its twin behind";
  hand.did("A limb and its twin", 2);

  const auto action = [&](const QString& text)
  {
    const auto all = hand.window.findChildren<QAction*>();
    const auto one = std::find_if(
      all.begin(), all.end(), [&](QAction* a) { return a->text().remove('&').startsWith(text); });
    EXPECT_NE(one, all.end()) << text.toStdString();
    return one == all.end() ? nullptr : *one;
  };
  QAction* worn = action("Pictures of models");
  hand.key(Qt::Key_F);
  EXPECT_TRUE(worn && !worn->isChecked());
  hand.did("See the form without the picture", 1);
}

TEST(Tasks, AFilmAndALessonTakeFewActions)
{
  Newcomer hand;
  const QTemporaryDir folder;
  const QString path = folder.filePath("dog.ogv");
  hand.answering(path, [&] { hand.menu({ "File", "Turntable" }); });
  QFile film(path);
  ASSERT_TRUE(film.open(QIODevice::ReadOnly));
  EXPECT_TRUE(film.readAll().startsWith("OggS"));
  hand.did("A film of it on a turntable", 5);

  const Lesson lesson = lessons().front();
  hand.menu({ "Help", "Lessons", QString(lesson.title).remove('&') });
  auto* player = hand.window.findChild<LessonPlayer*>();
  ASSERT_TRUE(player->isPlaying());
  EXPECT_TRUE(QTest::qWaitFor([&] { return player->words() == lesson.done; }, 240000)) << "nothing is drawn";
  hand.did("Be shown how it is done", 3);
  QTest::mouseClick(&hand.window, Qt::LeftButton, Qt::NoModifier, QPoint(2, 2));
  EXPECT_FALSE(player->isPlaying());
}
