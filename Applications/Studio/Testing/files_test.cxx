// Files as a person has them: opened, saved, exported, left, found again after a crash.
#include "autosave.h"
#include "files.h"
#include "long_work.h"
#include "mesh_file.h"
#include "picture_files.h"
#include "resources.h"
#include "scene.h"
#include "session_file.h"
#include "texture.h"
#include "tool.h"
#include "viewport.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <QAction>
#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QThreadPool>

#include <algorithm>
#include <atomic>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

using namespace oversketch_studio;
using namespace oversketch_session;

namespace
{

// Answers what a window asks, once it is there.
class Answer
{
public:
  explicit Answer(std::function<bool(QWidget*)> act)
  {
    QObject::connect(&this->Look,
      &QTimer::timeout,
      [this, act = std::move(act)]
      {
        QWidget* asked = QApplication::activeModalWidget();
        if (asked && asked->isVisible() && act(asked))
        {
          ++this->Given;
        }
      });
    this->Look.start(20);
  }
  int given() const { return this->Given; }

private:
  QTimer Look;
  int Given = 0;
};

QAction* actionOf(QWidget& window, const QString& text)
{
  for (QAction* action : window.findChildren<QAction*>())
  {
    if (action->text() == text)
    {
      return action;
    }
  }
  ADD_FAILURE() << "no action " << qPrintable(text);
  return nullptr;
}

bool answerName(QWidget* asked, const QString& path)
{
  auto* dialog = qobject_cast<QFileDialog*>(asked);
  if (!dialog)
  {
    return false;
  }
  dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path);
  static_cast<QDialog*>(dialog)->accept();
  return true;
}

void drawStroke(Scene& scene)
{
  scene.draw();
  scene.release();
  scene.wait();
  ASSERT_EQ(scene.document->session().nodes.size(), 1u);
}

// The shipped model in a picture, as a file of that path.
QString dressedDog(const std::string& picture, const QString& path)
{
  oversketch_files::Notes notes;
  const auto mesh = oversketch_files::readMesh(OVERSKETCH_DATA_FOLDER "/Models/dog.ply", notes);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TCoords");
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    coordinates->InsertNextTuple2(0.5, 0.5);
  }
  mesh->GetPointData()->SetTCoords(coordinates);
  oversketch_files::setTexture(mesh, picture);
  oversketch_files::writeMesh(mesh, path.toStdString(), notes);
  return path;
}

} // namespace

TEST(Files, WhatIsNotChangedIsNotAskedAbout)
{
  const QTemporaryDir folder;
  Scene scene;
  auto* kept = scene.window.findChild<QLabel*>("kept");
  ASSERT_TRUE(kept);
  EXPECT_FALSE(scene.window.isWindowModified());
  EXPECT_EQ(kept->text(), "");
  drawStroke(scene);
  EXPECT_TRUE(scene.window.isWindowModified());
  EXPECT_TRUE(QTest::qWaitFor([&] { return kept->text().startsWith("kept "); }, 60000));
  scene.document->undo();
  scene.wait();
  EXPECT_FALSE(scene.window.isWindowModified()) << "undone to the start";
  scene.document->redo();
  scene.wait();
  EXPECT_TRUE(scene.window.isWindowModified());
  {
    const Answer name([&](QWidget* asked) { return answerName(asked, folder.filePath("my dog")); });
    actionOf(scene.window, "&Save session")->trigger();
    EXPECT_EQ(name.given(), 1);
  }
  EXPECT_TRUE(QFile::exists(folder.filePath("my dog.oversketch")));
  EXPECT_FALSE(scene.window.isWindowModified());
  EXPECT_TRUE(scene.window.findChild<QLabel*>("advice")->text().startsWith("Saved as "));
  EXPECT_TRUE(QTest::qWaitFor([&] { return kept->text().startsWith("saved "); }, 60000));
  scene.document->undo();
  scene.wait();
  EXPECT_TRUE(scene.window.isWindowModified()) << "not as it was saved";
  scene.document->redo();
  scene.wait();
  EXPECT_FALSE(scene.window.isWindowModified());
}

// The three answers of the question, and the menu of what was open before.
TEST(Files, WhatIsChangedIsAskedAboutAndFoundAgain)
{
  QSettings().remove("recent");
  const QTemporaryDir folder;
  const QString saved = folder.filePath("my dog.oversketch");
  const QString other = folder.filePath("other dog.ply");
  ASSERT_TRUE(QFile::copy(OVERSKETCH_DATA_FOLDER "/Models/dog.ply", other));
  Scene scene;
  drawStroke(scene);
  // Another is to be opened; the name is asked for once where the session is to be saved.
  const auto opens = [&](QMessageBox::StandardButton pressed, int questions)
  {
    const Answer answer(
      [&](QWidget* asked)
      {
        auto* box = qobject_cast<QMessageBox*>(asked);
        if (!box)
        {
          return answerName(asked, saved);
        }
        QTest::mouseClick(box->button(pressed), Qt::LeftButton);
        return true;
      });
    const bool opened = scene.window.open(other);
    EXPECT_EQ(answer.given(), questions);
    scene.wait();
    return opened;
  };
  EXPECT_FALSE(opens(QMessageBox::Cancel, 1));
  EXPECT_EQ(scene.document->session().nodes.size(), 1u) << "cancelled, and lost";
  EXPECT_TRUE(scene.window.isWindowModified());
  EXPECT_TRUE(opens(QMessageBox::Save, 2));
  EXPECT_EQ(readSession(saved.toStdString()).session.nodes.size(), 1u);
  EXPECT_TRUE(scene.document->session().nodes.empty());
  drawStroke(scene);
  EXPECT_TRUE(opens(QMessageBox::Discard, 1));
  EXPECT_TRUE(scene.document->session().nodes.empty());
  auto* recent = actionOf(scene.window, "Open &recent")->menu();
  emit recent->aboutToShow();
  ASSERT_EQ(recent->actions().size(), 2);
  EXPECT_EQ(recent->actions()[0]->text(), other);
  EXPECT_EQ(recent->actions()[1]->text(), saved);
  recent->actions()[1]->trigger();
  scene.wait();
  EXPECT_EQ(scene.document->path(), saved);
  EXPECT_EQ(scene.document->session().nodes.size(), 1u);
  emit recent->aboutToShow();
  EXPECT_EQ(recent->actions()[0]->text(), saved) << "the last one stands first";
}

TEST(Files, AnExportHasASuffixAndRemembersItsFormat)
{
  QSettings().remove("exportFormat");
  const QTemporaryDir folder;
  Scene scene;
  QString offered;
  const auto exports = [&](const QString& name, const QString& format)
  {
    offered.clear();
    const Answer answer(
      [&](QWidget* asked)
      {
        auto* dialog = qobject_cast<QFileDialog*>(asked);
        if (!dialog)
        {
          return false;
        }
        EXPECT_GE(dialog->nameFilters().size(), 7);
        offered = dialog->selectedNameFilter();
        for (const QString& filter : dialog->nameFilters())
        {
          if (filter.contains(format))
          {
            dialog->selectNameFilter(filter);
            emit dialog->filterSelected(filter);
            const QString typed = dialog->findChild<QLineEdit*>("fileNameEdit")->text();
            EXPECT_TRUE(typed.endsWith(format.mid(1, format.size() - 2))) << qPrintable(typed);
          }
        }
        return answerName(asked, name);
      });
    actionOf(scene.window, "&Export mesh…")->trigger();
    EXPECT_EQ(answer.given(), 1);
    EXPECT_TRUE(QTest::qWaitFor([] { return !QApplication::activeModalWidget(); }, 60000));
  };
  exports(folder.filePath("dog"), "*.glb)");
  EXPECT_TRUE(QFileInfo(folder.filePath("dog.glb")).size() > 1000);
  EXPECT_TRUE(scene.window.findChild<QLabel*>("advice")->text().contains("dog.glb"))
    << "nothing says that it is done";
  // A point in the name is no suffix.
  exports(folder.filePath("dog.v2"), "*.stl)");
  EXPECT_TRUE(offered.contains("*.glb")) << qPrintable(offered);
  EXPECT_TRUE(QFile::exists(folder.filePath("dog.v2.stl")));
  exports(folder.filePath("dog.obj"), "*.stl)");
  EXPECT_TRUE(QFile::exists(folder.filePath("dog.obj"))) << "the suffix that was typed counts";
  EXPECT_EQ(QSettings().value("exportFormat").toString(), "obj");
  // What wears a picture is offered one file with it; PLY has it beside.
  QSettings().remove("exportFormat");
  QImage red(8, 8, QImage::Format_RGB32);
  red.fill(Qt::red);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  red.save(&buffer, "PNG");
  ASSERT_TRUE(scene.window.open(dressedDog(bytes.toStdString(), folder.filePath("red.glb"))));
  scene.wait();
  exports(folder.filePath("red.ply"), "*.ply)");
  EXPECT_TRUE(offered.contains("*.glb")) << qPrintable(offered);
  const QString said = scene.window.findChild<QLabel*>("advice")->text();
  EXPECT_TRUE(said.startsWith("Exported red.ply with its picture.")) << qPrintable(said);
  EXPECT_EQ(QDir(folder.path()).entryList({ "red*.png" }).size(), 1);
}

TEST(Files, WhatTakesLongShowsThatAndCanBeGivenUp)
{
  const QTemporaryDir folder;
  const std::string late = folder.filePath("late.txt").toStdString(),
                    soon = folder.filePath("soon.txt").toStdString();
  QWidget window;
  window.show();
  // What is quick shows nothing; what it throws comes here.
  {
    const Answer none([](QWidget*) { return true; });
    EXPECT_TRUE(doLongWork(&window, "quick", [soon] { oversketch_files::writeText(soon, "there"); }));
    EXPECT_THROW(doLongWork(&window, "bad", [] { throw std::runtime_error("bad"); }), std::runtime_error);
  }
  EXPECT_TRUE(QFile::exists(QString::fromStdString(soon)));
  const auto go = std::make_shared<std::atomic<bool>>(false);
  const Answer cancel(
    [](QWidget* asked)
    {
      auto* dialog = qobject_cast<QProgressDialog*>(asked);
      if (!dialog)
      {
        return false;
      }
      EXPECT_EQ(dialog->labelText(), "slow");
      EXPECT_FALSE(longWorkGoing().isEmpty());
      dialog->findChild<QPushButton*>()->click();
      return true;
    });
  EXPECT_FALSE(doLongWork(&window,
    "slow",
    [go, late]
    {
      while (!*go)
      {
        std::this_thread::yield();
      }
      oversketch_files::writeText(late, "too late");
    }));
  EXPECT_EQ(cancel.given(), 1);
  EXPECT_TRUE(longWorkGoing().isEmpty());
  *go = true;
  QThreadPool::globalInstance()->waitForDone();
  EXPECT_FALSE(QFile::exists(QString::fromStdString(late))) << "what was given up appeared";
}

// The window's own works, each held back until it has been given up, as where the disk is slow.
TEST(Files, EachWorkOnAFileShowsThatAndCanBeGivenUp)
{
  const QTemporaryDir folder;
  const QString picture = folder.filePath("square.png"), other = folder.filePath("other dog.ply");
  QImage square(64, 64, QImage::Format_RGB32);
  square.fill(Qt::magenta);
  ASSERT_TRUE(square.save(picture));
  ASSERT_TRUE(QFile::copy(OVERSKETCH_DATA_FOLDER "/Models/dog.ply", other));
  const QString saved = folder.filePath("late.oversketch"), exported = folder.filePath("late.ply");
  Scene scene;
  auto* advice = scene.window.findChild<QLabel*>("advice");
  const std::string bytes = oversketch_files::wholeFile(picture.toStdString());
  emit actionOf(scene.window, "E&xamples")->menu()->aboutToShow();
  const auto menu = [&](const QString& text)
  { return [&, text] { actionOf(scene.window, text)->trigger(); }; };
  struct Work
  {
    QString said, name;
    std::function<void()> begin;
  };
  const Work works[] = {
    { "Reading other dog.ply", {}, [&] { scene.window.open(other); } },
    { "Reading Leaf (drawing)", {}, menu("Leaf (drawing)") },
    { "Reading square.png", picture, menu("&New from picture…") },
    { "Reading square.png", picture, menu("Add a pict&ure as a part…") },
    { "Reading square.png", picture, menu("Add a p&icture…") },
    { "Reading other dog.ply", other, menu("Add a &model…") },
    { "Saving late.oversketch", saved, menu("Save session &as…") },
    { "Exporting late.ply", exported, menu("&Export mesh…") },
  };
  auto* pool = QThreadPool::globalInstance();
  const int threads = pool->maxThreadCount();
  pool->setMaxThreadCount(1);
  const std::string digest = scene.document->digest();
  for (const Work& work : works)
  {
    SCOPED_TRACE(qPrintable(work.said));
    std::promise<void> go;
    pool->start([mayGo = go.get_future().share()] { mayGo.wait(); });
    const Answer answers(
      [&](QWidget* asked)
      {
        auto* dialog = qobject_cast<QProgressDialog*>(asked);
        if (!dialog)
        {
          return answerName(asked, work.name);
        }
        EXPECT_TRUE(dialog->labelText().startsWith(work.said)) << qPrintable(dialog->labelText());
        // Nothing else is begun meanwhile, and that is said.
        for (const QString& path : { picture, QString() })
        {
          advice->clear();
          EXPECT_FALSE(scene.window.openPicture(path));
          EXPECT_TRUE(advice->text().startsWith(work.said) && advice->text().endsWith("or cancel it."))
            << qPrintable(advice->text());
        }
        QTest::mouseClick(dialog->findChild<QPushButton*>(), Qt::LeftButton);
        return true;
      });
    work.begin();
    EXPECT_EQ(answers.given(), work.name.isEmpty() ? 1 : 2);
    EXPECT_TRUE(longWorkGoing().isEmpty());
    go.set_value();
    pool->waitForDone();
    scene.wait();
    EXPECT_EQ(scene.document->digest(), digest);
    EXPECT_EQ(scene.document->name(), "dog.ply");
    EXPECT_TRUE(scene.document->session().nodes.empty());
    EXPECT_TRUE(scene.document->session().pictures.empty());
    EXPECT_TRUE(scene.document->session().others.empty());
    EXPECT_FALSE(QFile::exists(saved) || QFile::exists(exported)) << "what was given up appeared";
    EXPECT_FALSE(findDecoded(bytes)) << "kept for ever";
  }
  pool->setMaxThreadCount(threads);
}

// By a document, whatever a view of it does.
TEST(Files, PicturesAreDecodedBeforeTheyAreSeen)
{
  const QTemporaryDir folder;
  const auto pictureOf = [&](const QColor& colour)
  {
    const QString path = folder.filePath(colour.name().mid(1) + ".png");
    QImage square(64, 64, QImage::Format_RGB32);
    square.fill(colour);
    EXPECT_TRUE(square.save(path));
    return oversketch_files::wholeFile(path.toStdString());
  };
  const auto dressed = [&](const std::string& bytes, const QString& name)
  { return dressedDog(bytes, folder.filePath(name)); };
  // Equal bytes are one picture while somebody holds it.
  const std::string red = pictureOf(Qt::red), green = pictureOf(Qt::green);
  {
    const ReadPicture read = readPicture(folder.filePath("ff0000.png"));
    EXPECT_EQ(decoded(std::make_shared<const std::string>(red)), read.decoded);
    EXPECT_TRUE(read.decoded->pixels);
  }
  EXPECT_FALSE(findDecoded(red)) << "kept for ever";
  const QString redDog = dressed(red, "red.glb"), greenDog = dressed(green, "green.glb");
  Document document;
  const auto settles = [&] { return QTest::qWaitFor([&] { return document.isSettled(); }, 600000); };
  {
    Document::Opened read = Document::read(redDog, 0);
    EXPECT_TRUE(findDecoded(red)) << "left to the window's thread";
    document.open(std::move(read));
  }
  EXPECT_TRUE(findDecoded(red));
  ASSERT_TRUE(settles());
  EXPECT_TRUE(findDecoded(red));
  // What rests is seen as well, and what is chosen again.
  document.addModels(Document::readModels(greenDog, 0));
  ASSERT_TRUE(settles());
  EXPECT_TRUE(findDecoded(red) && findDecoded(green));
  document.chooseModel(0);
  ASSERT_TRUE(settles());
  EXPECT_TRUE(findDecoded(red) && findDecoded(green));
  document.open(Document::read(OVERSKETCH_DATA_FOLDER "/Models/dog.ply", 0));
  ASSERT_TRUE(settles());
  EXPECT_FALSE(findDecoded(red) || findDecoded(green)) << "kept for ever";
  // A drawing's model wears what was made of the picture that it was drawn over.
  const auto example = examples();
  const auto leaf =
    std::find_if(example.begin(), example.end(), [](const Example& one) { return !one.picture.isEmpty(); });
  ASSERT_NE(leaf, example.end());
  document.open(readExample(*leaf, 0));
  ASSERT_TRUE(settles());
  EXPECT_TRUE(findDecoded(oversketch_files::textureOf(document.result().mesh)));
  document.discardAutosave();
}

TEST(Files, EveryExampleOpens)
{
  const QVector<Example> all = examples();
  EXPECT_EQ(all.size(), 14);
  for (const Example& one : all)
  {
    const Document::Opened opened = readExample(one, 0);
    EXPECT_TRUE(opened.path.isEmpty()) << "what is shipped would be overwritten";
    if (one.file.endsWith(".oversketch"))
    {
      EXPECT_TRUE(!opened.session.mesh && opened.session.nodes.size() > 5) << qPrintable(one.title);
      continue;
    }
    EXPECT_TRUE(one.picture.isEmpty() ? opened.session.mesh && opened.session.nodes.empty()
                                      : !opened.session.mesh && opened.session.nodes.size() == 1)
      << qPrintable(one.title);
  }
  Scene scene;
  auto* menu = actionOf(scene.window, "E&xamples")->menu();
  emit menu->aboutToShow();
  ASSERT_EQ(menu->actions().size(), all.size());
  actionOf(*menu, "Leaf (drawing)")->trigger();
  scene.wait();
  EXPECT_EQ(scene.view->tool()->objectName(), "drawing");
  ASSERT_EQ(scene.document->result().nodes.size(), 1u);
  EXPECT_EQ(scene.document->result().nodes[0].failure, "");
  EXPECT_TRUE(scene.view->mesh());
  EXPECT_FALSE(scene.document->isModified());
  actionOf(*menu, "Shell (session)")->trigger();
  scene.wait();
  const auto& steps = scene.document->result().nodes;
  EXPECT_GT(steps.size(), 10u);
  for (const auto& step : steps)
  {
    EXPECT_EQ(step.failure, "");
  }
  EXPECT_EQ(scene.document->path(), "");
  EXPECT_FALSE(scene.document->isModified());
}

TEST(Files, ASessionIsSeenAsItWasSaved)
{
  const QTemporaryDir folder;
  const QString file = folder.filePath("turned.oversketch");
  Scene scene;
  const Look first = lookOf(*scene.view);
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  camera->Azimuth(40.0);
  camera->Zoom(1.5);
  camera->SetParallelProjection(true);
  const Look turned = lookOf(*scene.view);
  ASSERT_FALSE(turned == first);
  scene.document->save(file);
  EXPECT_TRUE(readSession(file.toStdString()).look == turned);
  scene.window.openShippedModel();
  scene.wait();
  camera->SetParallelProjection(false);
  EXPECT_FALSE(lookOf(*scene.view) == turned);
  ASSERT_TRUE(scene.window.open(file));
  scene.wait();
  EXPECT_TRUE(lookOf(*scene.view) == turned);
  EXPECT_FALSE(scene.window.isWindowModified());
}

TEST(Files, RecoveryNamesTheFileAndTheTimeAndAsksAboutNothingElse)
{
  const QTemporaryDir folder;
  const QString file = folder.filePath("my dog.oversketch");
  for (const auto& left : leftBehind(autosaveRoot()))
  {
    removeLeftBehind(left);
  }
  const auto crash = [&](bool changed)
  {
    auto document = std::make_unique<Document>();
    document->open(Document::read(OVERSKETCH_DATA_FOLDER "/Models/dog.ply", 0));
    EXPECT_TRUE(QTest::qWaitFor([&] { return document->isSettled(); }, 600000));
    document->save(file);
    if (changed)
    {
      document->setBackend(2);
      EXPECT_TRUE(QTest::qWaitFor([&] { return document->isSettled(); }, 600000));
    }
  };
  crash(false);
  crash(true);
  QString text, more;
  MainWindow window;
  const Answer answer(
    [&](QWidget* asked)
    {
      auto* box = qobject_cast<QMessageBox*>(asked);
      if (!box)
      {
        return false;
      }
      text = box->text();
      more = box->informativeText();
      box->defaultButton()->click();
      return true;
    });
  EXPECT_TRUE(window.offerRecovery());
  EXPECT_EQ(answer.given(), 1) << "of the session that was all saved nothing is asked";
  EXPECT_TRUE(text.contains("my dog.oversketch")) << qPrintable(text);
  EXPECT_TRUE(more.contains(QLocale().toString(QDate::currentDate(), QLocale::ShortFormat)))
    << qPrintable(more);
  auto* document = window.findChild<Document*>();
  EXPECT_EQ(document->path(), file);
  EXPECT_TRUE(document->isModified());
  EXPECT_TRUE(QTest::qWaitFor([&] { return document->isSettled(); }, 600000));
  document->discardAutosave();
  EXPECT_TRUE(leftBehind(autosaveRoot()).empty());
}

TEST(Files, PicturesAreSavedWithAndWithoutLines)
{
  const QTemporaryDir folder;
  Scene scene;
  drawStroke(scene);
  const auto red = [&](const QString& action, const QString& name)
  {
    const Answer answer([&](QWidget* asked) { return answerName(asked, folder.filePath(name)); });
    actionOf(scene.window, action)->trigger();
    EXPECT_EQ(answer.given(), 1);
    const QImage image(folder.filePath(name + ".png"));
    EXPECT_FALSE(image.isNull());
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
    {
      for (int x = 0; x < image.width(); ++x)
      {
        const QColor pixel = image.pixelColor(x, y);
        count += pixel.red() > 60 + std::max(pixel.green(), pixel.blue());
      }
    }
    return count;
  };
  EXPECT_GT(red("Save a picture with &lines…", "with"), 100);
  EXPECT_EQ(red("Save a &picture…", "without"), 0);
}

TEST(Files, QDoesNotQuit)
{
  Scene scene;
  scene.view->setFocus();
  QTest::keyClick(scene.view, Qt::Key_Q);
  QApplication::processEvents();
  EXPECT_TRUE(scene.window.isVisible());
}
