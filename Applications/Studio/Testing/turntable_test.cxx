// Films of one turn: of the view, and by a hand at the window.
#include "film.h"
#include "long_work.h"
#include "mesh_file.h"
#include "scene.h"

#include "vtkCamera.h"
#include "vtkNew.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QProgressDialog>
#include <QTemporaryDir>

using namespace oversketch_studio;

namespace
{

struct TurnedDog
{
  TurnedDog()
  {
    oversketch_files::Notes notes;
    this->view.resize(200, 160);
    this->view.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&this->view, 60000));
    this->view.showMesh(oversketch_files::readMesh(OVERSKETCH_DATA_FOLDER "/Models/dog.ply", notes), true);
    this->view.renderNow();
    this->view.renderer()->ResetCameraClippingRange();
  }
  QString path(const char* name) const { return this->folder.filePath(name); }
  QStringList files() const
  {
    return QDir(this->folder.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
  }
  // As F12 takes it, after the camera has gone round so far [degrees].
  QImage seenFrom(double angle)
  {
    vtkCamera* camera = this->view.renderer()->GetActiveCamera();
    vtkNew<vtkCamera> before;
    before->DeepCopy(camera);
    camera->Azimuth(angle);
    this->view.renderer()->ResetCameraClippingRange();
    const QString path = this->path("seen.png");
    this->view.screenshot(path, false);
    camera->DeepCopy(before);
    const QImage seen(path);
    QFile::remove(path);
    return seen;
  }

  Viewport view;
  QTemporaryDir folder;
};

bool goesOnAlways(double)
{
  return true;
}

// Answers the questions about a film, and gives it up once so many of its frames are there.
class TurnAnswers
{
public:
  TurnAnswers(const QString& path, bool givesUp)
  {
    QObject::connect(&this->Look,
      &QTimer::timeout,
      [path, givesUp]
      {
        QWidget* asked = QApplication::activeModalWidget();
        if (auto* number = qobject_cast<QInputDialog*>(asked))
        {
          number->setIntValue(4);
          number->accept();
        }
        else if (auto* name = qobject_cast<QFileDialog*>(asked))
        {
          name->findChild<QLineEdit*>("fileNameEdit")->setText(path);
          static_cast<QDialog*>(name)->accept();
        }
        else if (auto* work = qobject_cast<QProgressDialog*>(asked); work && givesUp)
        {
          work->cancel();
        }
      });
    this->Look.start(5);
  }

private:
  QTimer Look;
};

} // namespace

TEST(Turntable, FramesGoRoundOnce)
{
  TurnedDog dog;
  const QImage front = dog.seenFrom(0.0), side = dog.seenFrom(90.0), back = dog.seenFrom(180.0);
  EXPECT_GT(differing(front, back), 300) << "the model is the same from behind";
  ASSERT_TRUE(dog.view.writeTurn(dog.path("dog.png"), 4, goesOnAlways));
  EXPECT_EQ(dog.files(), QStringList({ "dog_001.png", "dog_002.png", "dog_003.png", "dog_004.png" }));
  EXPECT_TRUE(QImage(dog.path("dog_001.png")) == front) << "the first frame is the view";
  // To the right, as the eye sees it.
  EXPECT_LT(differing(QImage(dog.path("dog_002.png")), side), 30);
  EXPECT_LT(differing(QImage(dog.path("dog_003.png")), back), 30);
  EXPECT_TRUE(dog.seenFrom(0.0) == front) << "the camera is not where it was";
}

TEST(Turntable, WhatIsGivenUpLeavesNothing)
{
  TurnedDog dog;
  for (const char* name : { "dog.png", "dog.ogv" })
  {
    for (const double share : { 0.0, 0.5 })
    {
      EXPECT_FALSE(dog.view.writeTurn(dog.path(name), 4, [share](double done) { return done < share; }));
      EXPECT_EQ(dog.files(), QStringList());
    }
  }
  EXPECT_THROW(dog.view.writeTurn(dog.path("dog.mov"), 4, goesOnAlways), oversketch_files::Failed);
  EXPECT_THROW(dog.view.writeTurn(dog.path("none/dog.ogv"), 4, goesOnAlways), oversketch_files::Failed);
  // A film of another size than it began with.
  const auto grows = [&](double done)
  {
    dog.view.resize(done < 0.5 ? 200 : 240, 160);
    QApplication::processEvents();
    return true;
  };
  EXPECT_THROW(dog.view.writeTurn(dog.path("dog.ogv"), 4, grows), oversketch_files::Failed);
  EXPECT_EQ(dog.files(), QStringList());
}

TEST(Turntable, AFilmIsOneFile)
{
  TurnedDog dog;
  ASSERT_TRUE(dog.view.writeTurn(dog.path("dog.ogv"), 24, goesOnAlways));
  EXPECT_EQ(dog.files(), QStringList("dog.ogv"));
  QFile film(dog.path("dog.ogv"));
  ASSERT_TRUE(film.open(QIODevice::ReadOnly));
  const QByteArray bytes = film.readAll();
  EXPECT_TRUE(bytes.startsWith("OggS"));
  EXPECT_TRUE(bytes.contains("theora"));
  EXPECT_GT(bytes.size(), 6000) << "has no frames: heads alone are 3,400 bytes";
  EXPECT_LT(bytes.size(), 24 * 200 * 160 * 3) << "is not compressed";
}

TEST(Turntable, AHandWritesOneAndGivesOneUp)
{
  Scene scene;
  const QTemporaryDir folder;
  const auto files = [&] { return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name); };
  QAction* turntable = scene.action(QString::fromUtf8("&Turntable…"));
  ASSERT_TRUE(turntable && turntable->isEnabled());
  {
    const TurnAnswers answers(folder.filePath("given up.png"), true);
    turntable->trigger();
  }
  EXPECT_EQ(files(), QStringList());
  EXPECT_TRUE(longWorkGoing().isEmpty());
  {
    const TurnAnswers answers(folder.filePath("dog.ogv"), false);
    turntable->trigger();
  }
  EXPECT_EQ(files(), QStringList("dog.ogv"));
}
