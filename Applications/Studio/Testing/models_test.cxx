// Several models in one scene: added, chosen, locked, hidden, kept, written, one by one and together.
#include "autosave.h"
#include "mesh_file.h"
#include "models.h"
#include "scene.h"
#include "session_file.h"

#include "vtkNew.h"
#include "vtkPoints.h"

#include <QAction>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QProgressDialog>
#include <QPushButton>
#include <QSemaphore>
#include <QStyleOptionViewItem>
#include <QTemporaryDir>
#include <QThreadPool>
#include <QToolButton>
#include <QUrl>

using namespace oversketch_studio;
using namespace oversketch_session;

namespace
{

// The window on the dog, and a second dog in a file, beside it.
struct Dogs : Scene
{
  Dogs()
    : Scene(wholeWindow)
    , list(this->window.findChild<QListWidget*>("scene"))
    , advice(this->window.findChild<QLabel*>("advice"))
    , first(this->document->digest())
    , file(this->folder.filePath("second.ply"))
  {
    vtkNew<vtkPolyData> moved;
    moved->DeepCopy(this->document->result().mesh);
    const double* box = moved->GetBounds();
    const double step = 1.2 * (box[1] - box[0]);
    for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
    {
      double at[3];
      moved->GetPoint(i, at);
      moved->GetPoints()->SetPoint(i, at[0] + step, at[1], at[2]);
    }
    oversketch_files::Notes notes;
    oversketch_files::writeMesh(moved, this->file.toStdString(), notes);
    this->drop(this->list);
    this->wait();
  }

  const Session& session() const { return this->document->session(); }
  // The file on a part of the window.
  void drop(QWidget* over)
  {
    QMimeData data;
    data.setUrls({ QUrl::fromLocalFile(this->file) });
    const QPoint at = over->mapTo(&this->window, over->rect().center());
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&this->window, &enter); // which a drop is sent to
    QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    const auto before = this->document->result().ticket;
    QApplication::sendEvent(&this->window, &event);
    EXPECT_TRUE(QTest::qWaitFor([&] { return this->document->result().ticket > before; }, 600000));
  }
  bool comesTo(std::size_t place)
  {
    const bool came = QTest::qWaitFor([&] { return this->session().place == place; }, 600000);
    this->wait();
    return came;
  }
  void clickRow(int row)
  {
    const QRect place = this->list->visualItemRect(this->list->item(row));
    QTest::mouseClick(
      this->list->viewport(), Qt::LeftButton, Qt::NoModifier, { place.left() + 60, place.center().y() });
    QApplication::processEvents();
  }
  void clickTick(int row)
  {
    QStyleOptionViewItem option;
    option.initFrom(this->list);
    option.rect = this->list->visualItemRect(this->list->item(row));
    option.features = QStyleOptionViewItem::HasCheckIndicator | QStyleOptionViewItem::HasDisplay;
    option.text = this->list->item(row)->text();
    const QRect box =
      this->list->style()->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, this->list);
    QTest::mouseClick(this->list->viewport(), Qt::LeftButton, Qt::NoModifier, box.center());
    QApplication::processEvents();
  }
  void clickButton(const QString& text)
  {
    for (QToolButton* button : this->window.findChildren<QToolButton*>())
    {
      if (button->text() == text && button->isEnabled())
      {
        QTest::mouseClick(button, Qt::LeftButton);
        QApplication::processEvents();
        return;
      }
    }
    ADD_FAILURE() << "no button " << qPrintable(text);
  }
  QAction* action(const QString& text)
  {
    for (QAction* action : this->window.findChildren<QAction*>())
    {
      if (action->text() == text)
      {
        return action;
      }
    }
    ADD_FAILURE() << "no action " << qPrintable(text);
    return nullptr;
  }
  // Where the foremost point of a model is seen.
  QPoint front(vtkPolyData* mesh)
  {
    vtkIdType foremost = 0;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      foremost = mesh->GetPoint(i)[2] > mesh->GetPoint(foremost)[2] ? i : foremost;
    }
    return this->seen(mesh->GetPoint(foremost));
  }
  vtkPolyData* other(std::size_t place) { return restingAt(this->session(), place)->made.mesh; }
  void stroke()
  {
    this->draw();
    this->release();
    QApplication::processEvents();
    this->wait();
  }
  // Answers the question for a file's name, if that is asked; whether it was.
  static bool answersName(QWidget* asked, const QString& path)
  {
    auto* dialog = qobject_cast<QFileDialog*>(asked);
    if (dialog)
    {
      dialog->findChild<QLineEdit*>()->setText(path);
      static_cast<QDialog*>(dialog)->accept();
    }
    return dialog != nullptr;
  }

  // What an export writes, read back.
  vtkSmartPointer<vtkPolyData> written(QAction* exporting, const QString& name)
  {
    const QString path = this->folder.filePath(name);
    QTimer timer;
    QObject::connect(&timer,
      &QTimer::timeout,
      [&]
      {
        QWidget* asked = QApplication::activeModalWidget();
        if (!answersName(asked, path) && asked && asked->inherits("QMessageBox"))
        {
          asked->close();
        }
      });
    timer.start(50);
    exporting->trigger();
    timer.stop();
    oversketch_files::Notes notes;
    return oversketch_files::readMesh(path.toStdString(), notes);
  }

  // Given up as soon as the window asks: with no thread free the work cannot be done by then.
  void giveUp(QAction* exporting, const QString& name)
  {
    const QString path = this->folder.filePath(name);
    QThreadPool* pool = QThreadPool::globalInstance();
    pool->waitForDone();
    const int threads = pool->maxThreadCount();
    pool->setMaxThreadCount(1);
    QSemaphore go;
    pool->start([&go] { go.acquire(); });
    int cancelled = 0;
    QTimer timer;
    QObject::connect(&timer,
      &QTimer::timeout,
      [&]
      {
        QWidget* asked = QApplication::activeModalWidget();
        auto* progress = qobject_cast<QProgressDialog*>(asked);
        if (!answersName(asked, path) && progress && cancelled++ == 0)
        {
          EXPECT_TRUE(progress->labelText().contains(name)) << qPrintable(progress->labelText());
          progress->findChild<QPushButton*>()->click();
        }
      });
    timer.start(50);
    exporting->trigger();
    timer.stop();
    EXPECT_EQ(cancelled, 1);
    go.release();
    pool->waitForDone();
    pool->setMaxThreadCount(threads);
    EXPECT_FALSE(QFile::exists(path)) << "what was given up appeared";
    EXPECT_FALSE(this->advice->text().contains(name)) << qPrintable(this->advice->text());
  }

  QTemporaryDir folder;
  QListWidget* list;
  QLabel* advice;
  std::string first; // the digest of the dog as it was opened
  QString file;
};

} // namespace

TEST(Models, StrokesActOnTheChosenOne)
{
  Dogs pair;
  // Dropped on the list: beside the open one, chosen, all in the picture.
  ASSERT_EQ(modelCount(pair.session()), 2u);
  EXPECT_TRUE(pair.comesTo(1));
  ASSERT_EQ(pair.list->count(), 2);
  EXPECT_EQ(pair.list->item(1)->text(), "second.ply");
  EXPECT_TRUE(pair.list->item(1)->font().bold());
  EXPECT_FALSE(pair.list->item(0)->font().bold());
  EXPECT_EQ(restingAt(pair.session(), 0)->made.digest, pair.first);
  for (vtkPolyData* mesh : { pair.other(0), pair.document->result().mesh.Get() })
  {
    EXPECT_TRUE(pair.view->rect().contains(pair.front(mesh)));
  }
  const std::string second = pair.document->digest();
  // One undo for it, and back.
  pair.document->undo();
  pair.wait();
  EXPECT_EQ(modelCount(pair.session()), 1u);
  EXPECT_EQ(pair.document->digest(), pair.first);
  pair.document->redo();
  pair.wait();
  ASSERT_EQ(modelCount(pair.session()), 2u);
  EXPECT_EQ(pair.document->digest(), second);

  pair.stroke();
  ASSERT_EQ(pair.session().nodes.size(), 1u);
  const std::string drawn = pair.document->digest();
  EXPECT_NE(drawn, second);
  EXPECT_EQ(restingAt(pair.session(), 0)->made.digest, pair.first) << "the other one moved";

  // A click on a model chooses it, one on its row too.
  QTest::mouseClick(pair.view, Qt::LeftButton, Qt::NoModifier, pair.front(pair.other(0)));
  EXPECT_TRUE(pair.comesTo(0));
  EXPECT_EQ(pair.document->digest(), pair.first);
  EXPECT_TRUE(pair.session().nodes.empty()) << "the click was a stroke";
  EXPECT_EQ(restingAt(pair.session(), 1)->made.digest, drawn);
  pair.clickRow(1);
  EXPECT_TRUE(pair.comesTo(1));
  EXPECT_EQ(pair.document->digest(), drawn);
  pair.clickRow(0);
  EXPECT_TRUE(pair.comesTo(0));
  pair.stroke();
  EXPECT_EQ(pair.session().nodes.size(), 1u);
  EXPECT_EQ(restingAt(pair.session(), 1)->made.digest, drawn);
  // Undo leads to where each change was made.
  pair.document->undo();
  pair.wait();
  EXPECT_EQ(pair.document->digest(), pair.first);
  pair.document->undo();
  pair.wait();
  EXPECT_EQ(pair.document->digest(), second);
  EXPECT_EQ(pair.session().place, 1u);
  // A drop beside the list opens the file instead, once what is not saved has been asked about.
  pair.document->save(pair.folder.filePath("kept.oversketch"));
  pair.drop(pair.view);
  pair.wait();
  EXPECT_EQ(modelCount(pair.session()), 1u);
}

TEST(Models, LockedAndHiddenOnesTakeNoStrokesAndAreKept)
{
  Dogs pair;
  ASSERT_EQ(modelCount(pair.session()), 2u);
  EXPECT_TRUE(pair.comesTo(1));
  const std::string second = pair.document->digest();
  pair.clickButton("Lock");
  EXPECT_TRUE(pair.session().locked);
  EXPECT_EQ(pair.list->item(1)->text(), "second.ply (locked)");
  pair.stroke();
  EXPECT_TRUE(pair.session().nodes.empty());
  EXPECT_EQ(pair.document->digest(), second);
  EXPECT_TRUE(pair.advice->text().startsWith("second.ply is locked and takes no strokes."))
    << qPrintable(pair.advice->text());
  pair.document->undo();
  pair.wait();
  EXPECT_FALSE(pair.session().locked);

  // Hidden: not drawn, not clicked, by a tick that chooses nothing.
  const QImage both = pair.pictureAtRest();
  const QPoint there = pair.front(pair.other(0));
  pair.clickTick(0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !modelAt(pair.session(), 0).shown; }, 60000));
  EXPECT_EQ(pair.session().place, 1u) << "the tick chose it";
  EXPECT_GT(differing(pair.pictureAtRest(), both), 3000);
  QTest::mouseClick(pair.view, Qt::LeftButton, Qt::NoModifier, there);
  QApplication::processEvents();
  pair.wait();
  EXPECT_EQ(pair.session().place, 1u) << "what is hidden was clicked";
  pair.clickRow(0);
  EXPECT_TRUE(pair.comesTo(0));
  EXPECT_TRUE(pair.advice->text().contains("is hidden and takes no strokes"))
    << qPrintable(pair.advice->text());
  pair.stroke();
  EXPECT_TRUE(pair.session().nodes.empty());

  // Saved so, and opened again bit for bit.
  pair.clickRow(1);
  EXPECT_TRUE(pair.comesTo(1));
  pair.stroke();
  ASSERT_EQ(pair.session().nodes.size(), 1u);
  const std::string drawn = pair.document->digest();
  pair.clickButton("Lock");
  const QString kept = pair.folder.filePath("pair.oversketch");
  pair.document->save(kept);
  pair.window.openShippedModel();
  pair.wait();
  ASSERT_EQ(modelCount(pair.session()), 1u);
  ASSERT_TRUE(pair.window.open(kept));
  pair.wait();
  ASSERT_EQ(modelCount(pair.session()), 2u);
  EXPECT_EQ(pair.session().place, 1u);
  EXPECT_TRUE(pair.session().locked);
  EXPECT_FALSE(modelAt(pair.session(), 0).shown);
  EXPECT_EQ(pair.document->digest(), drawn);
  EXPECT_EQ(restingAt(pair.session(), 0)->made.digest, pair.first);
  EXPECT_FALSE(pair.window.isWindowModified());

  // Written as one mesh of two parts, and each by itself; given up before.
  pair.giveUp(pair.action("&Export mesh…"), "all.vtp");
  const auto all = pair.written(pair.action("&Export mesh…"), "all.vtp");
  const auto parts = oversketch_files::partsOf(all);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(
    oversketch_files::partAlone(all, parts[0])->GetNumberOfPolys(), pair.other(0)->GetNumberOfPolys());
  EXPECT_EQ(all->GetNumberOfPolys(),
    pair.other(0)->GetNumberOfPolys() + pair.document->result().mesh->GetNumberOfPolys());
  for (int row = 0; row < 2; ++row)
  {
    pair.list->setCurrentRow(row);
    const auto one =
      pair.written(pair.action("Export the selecte&d model or part…"), QString("%1.vtp").arg(row));
    EXPECT_EQ(digestOf(one), row == 0 ? pair.first : drawn);
  }

  // Removed, the chosen one as well; undone.
  pair.list->setCurrentRow(1);
  pair.clickButton("Remove");
  pair.wait();
  EXPECT_EQ(modelCount(pair.session()), 1u);
  EXPECT_EQ(pair.document->digest(), pair.first);
  pair.document->undo();
  pair.wait();
  ASSERT_EQ(modelCount(pair.session()), 2u);
  EXPECT_EQ(pair.document->digest(), drawn);

  // A crash loses neither.
  for (const auto& left : leftBehind(autosaveRoot()))
  {
    removeLeftBehind(left);
  }
  {
    Document document;
    document.open(Document::read(kept, 0));
    EXPECT_TRUE(QTest::qWaitFor([&] { return document.isSettled(); }, 600000));
    document.setModel(0, true, true);
  }
  pair.document->discardAutosave();
  MainWindow window;
  QTimer timer;
  QObject::connect(&timer,
    &QTimer::timeout,
    []
    {
      if (auto* box = QApplication::activeModalWidget(); box && box->inherits("QMessageBox"))
      {
        QTest::keyClick(box, Qt::Key_Return);
      }
    });
  timer.start(50);
  ASSERT_TRUE(window.offerRecovery());
  timer.stop();
  auto* document = window.findChild<Document*>();
  EXPECT_TRUE(QTest::qWaitFor([&] { return document->isSettled(); }, 600000));
  EXPECT_EQ(modelCount(document->session()), 2u);
  EXPECT_TRUE(modelAt(document->session(), 0).locked);
  EXPECT_EQ(document->digest(), drawn);
  document->discardAutosave();
}

// As many as a scene has, and one more.
TEST(Models, TooManyAreRefused)
{
  const QString dog = OVERSKETCH_DATA_FOLDER "/Models/dog.ply";
  Document document;
  document.open(Document::read(dog, 0));
  EXPECT_TRUE(QTest::qWaitFor([&] { return document.isSettled(); }, 600000));
  Document::Opened many = Document::readModels(dog, 0);
  ASSERT_EQ(many.session.others.size(), 1u);
  many.session.others.resize(mostModels, many.session.others.front());
  try
  {
    document.addModels(std::move(many));
    ADD_FAILURE() << "a scene of more models than it may have";
  }
  catch (const oversketch_files::Failed& refused)
  {
    EXPECT_STREQ(refused.what(), "A scene has at most 1000 models. Remove some first.");
  }
  EXPECT_EQ(modelCount(document.session()), 1u);
  EXPECT_FALSE(document.isModified());
  document.discardAutosave();
}
