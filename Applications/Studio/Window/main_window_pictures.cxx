// The window's pictures: what is drawn over, and what stands behind the model.
#include "main_window.h"

#include "history_panel.h"
#include "long_work.h"
#include "picture_files.h"
#include "viewport.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include <memory>
#include <optional>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

// What is read of that file on a thread of its own; nothing where it was given up.
template <typename Read>
auto readOf(QWidget* window, const QString& path, const Read& read) -> std::optional<decltype(read())>
{
  const auto made = std::make_shared<std::optional<decltype(read())>>();
  const QString what = MainWindow::tr("Reading %1…").arg(QFileInfo(path).fileName());
  const bool done = doLongWork(window, what, [made, read] { *made = read(); });
  return done ? std::move(*made) : std::nullopt;
}

} // namespace

bool MainWindow::openPicture(const QString& path)
{
  if (!this->mayBegin())
  {
    return false;
  }
  bool opened = false;
  const auto mayLeave = [this] { return this->mayLeave(); };
  this->tried(
    [&]
    {
      if (path.isEmpty())
      {
        opened = this->OpenDocument->beginDrawing(mayLeave);
        return;
      }
      const auto read = readOf(this, path, [path] { return Document::readDrawing(path); });
      opened = read && this->OpenDocument->beginDrawing(read->step, QFileInfo(path).fileName(), mayLeave);
    });
  if (opened)
  {
    if (!path.isEmpty())
    {
      QSettings().setValue("folder", QFileInfo(path).absolutePath());
    }
    this->stopTeaching();
    this->Redrawn = -1;
  }
  return opened;
}

QString MainWindow::pictureAsked(const QString& title)
{
  QStringList patterns;
  for (const QString& extension : pictureExtensions())
  {
    patterns << "*." + extension;
  }
  return QFileDialog::getOpenFileName(this,
    title,
    QSettings().value("folder").toString(),
    tr("Pictures (%1);;All files (*)").arg(patterns.join(' ')));
}

void MainWindow::newFromPictureAsked()
{
  const QString path = this->pictureAsked(tr("Draw a model over a picture"));
  if (!path.isEmpty())
  {
    this->openPicture(path);
  }
}

void MainWindow::addPartAsked()
{
  if (!this->OpenDocument->isOpen())
  {
    this->newFromPictureAsked();
    return;
  }
  if (!this->OpenDocument->whyNoSteps().isEmpty())
  {
    this->advise(); // says why
    return;
  }
  const QString path = this->pictureAsked(tr("Draw a further part over a picture"));
  if (path.isEmpty() || !this->mayBegin())
  {
    return;
  }
  this->tried(
    [&]
    {
      const auto read = readOf(this, path, this->OpenDocument->partReader(path));
      if (!read)
      {
        return;
      }
      this->OpenDocument->add(*read->step);
      const int part = this->OpenDocument->shownTo() - 1;
      this->History->selectStep(part);
      this->setTool(this->toolOf(part));
    });
}

void MainWindow::addPictureAsked()
{
  const QString path = this->pictureAsked(tr("Put a picture behind the model"));
  if (!path.isEmpty())
  {
    this->addPicture(path);
  }
}

void MainWindow::addPicture(const QString& path)
{
  if (!this->OpenDocument->isOpen() || !this->mayBegin())
  {
    return;
  }
  this->tried(
    [&]
    {
      const auto read = readOf(this, path, [path] { return readPicture(path); });
      if (!read)
      {
        return;
      }
      Picture picture;
      picture.image = read->image;
      const int* size = read->decoded->pixels->GetDimensions();
      picture.frame = this->View->frameFor(size[0], size[1]);
      this->stopTeaching(); // it might not be legible before it
      this->OpenDocument->addPicture(picture);
    });
}

} // namespace oversketch_studio
