// The window's pictures: what is drawn over, and what stands behind the model.
#include "main_window.h"

#include "drawing_lines.h"
#include "history_panel.h"
#include "picture_files.h"
#include "status_labels.h"
#include "systems.h"
#include "tool.h"
#include "viewport.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace oversketch_studio
{

using namespace oversketch_session;

bool MainWindow::openPicture(const QString& path)
{
  const bool opened = this->beginDrawing(path);
  if (opened && !path.isEmpty())
  {
    QSettings().setValue("folder", QFileInfo(path).absolutePath());
  }
  return opened;
}

bool MainWindow::beginDrawing(const QString& picture)
{
  if (!this->mayBegin())
  {
    return false;
  }
  bool opened = false;
  const QString name = QFileInfo(picture).fileName();
  const auto mayLeave = [this] { return this->mayLeave(); };
  picture.isEmpty() ? this->tried([&] { opened = this->OpenDocument->beginDrawing(mayLeave); })
                    : this->readAside(
                        name,
                        [picture] { return Document::readDrawing(picture); },
                        [&](const Document::ReadDrawing& read)
                        { opened = this->OpenDocument->beginDrawing(read.step, name, mayLeave); });
  if (opened)
  {
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
  if (const QString why = this->OpenDocument->whyNoSteps(drawingSystem); !why.isEmpty())
  {
    this->Advice->setText(why);
    return;
  }
  const QString path = this->pictureAsked(tr("Draw a further part over a picture"));
  if (path.isEmpty())
  {
    return;
  }
  this->readAside(QFileInfo(path).fileName(),
    this->OpenDocument->partReader(path),
    [this](const Document::ReadDrawing& read)
    {
      this->OpenDocument->add(*read.step);
      const int part = this->OpenDocument->shownTo() - 1;
      this->History->selectStep(part);
      this->setTool(this->toolOf(part));
    });
}

int MainWindow::drawingMeant() const
{
  const auto drawing = std::find_if(
    this->Tools.begin(), this->Tools.end(), [](const Tool* tool) { return tool->system() == drawingSystem; });
  return drawing == this->Tools.end() ? -1 : (*drawing)->node();
}

void MainWindow::addBackAsked()
{
  const QString path = this->pictureAsked(tr("The drawing's back, as seen from behind"));
  if (!path.isEmpty())
  {
    this->readAside(
      QFileInfo(path).fileName(),
      [path] { return readPicture(path); },
      [this](const ReadPicture& read) { this->setBack(&read.image); });
  }
}

void MainWindow::setBack(const Image* image)
{
  const int at = this->drawingMeant();
  const Node* drawing = this->OpenDocument->nodeAt(at);
  if (!drawing)
  {
    return; // it went while the picture was read
  }
  const std::string& back = findSystem(drawingSystem)->backTextureInput;
  Step step = *drawing->step;
  step.inputs.erase(back);
  if (image)
  {
    step.inputs[back] = *image;
  }
  this->OpenDocument->redraw(at, step);
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
  if (!this->OpenDocument->isOpen())
  {
    return;
  }
  this->readAside(
    QFileInfo(path).fileName(),
    [path] { return readPicture(path); },
    [this](const ReadPicture& read)
    {
      Picture picture;
      picture.image = read.image;
      const int* size = read.decoded->pixels->GetDimensions();
      picture.frame = this->View->frameFor(size[0], size[1]);
      this->stopTeaching(); // it might not be legible before it
      this->OpenDocument->addPicture(picture);
    });
}

} // namespace oversketch_studio
