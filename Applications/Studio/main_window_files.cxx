#include "main_window.h"

#include "files.h"
#include "heights.h"
#include "history_panel.h"
#include "mesh_file.h"
#include "resources.h"
#include "texture.h"
#include "tool.h"
#include "viewport.h"

#include <QCloseEvent>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>

namespace oversketch_studio
{

using namespace oversketch_session;
using oversketch_files::Failed;

namespace
{

const QStringList pictureExtensions{ "png", "jpg", "jpeg" };

// "*.obj *.ply": of extensions with blanks between.
QString patternsOf(const char* extensions)
{
  QString patterns;
  for (const QString& extension : QString::fromLatin1(extensions).split(' '))
  {
    patterns += " *" + extension;
  }
  return patterns.mid(1);
}

} // namespace

bool MainWindow::tried(const std::function<void()>& run)
{
  try
  {
    run();
    return true;
  }
  catch (const std::bad_alloc&)
  {
    QMessageBox::critical(this, tr("Oversketch"), tr("Out of memory; the file is too large or damaged."));
  }
  catch (const std::exception& error)
  {
    QMessageBox::critical(this, tr("Oversketch"), QString::fromStdString(error.what()));
  }
  return false;
}

void MainWindow::tell(const QStringList& notes)
{
  if (!notes.isEmpty())
  {
    QMessageBox::information(this, tr("Oversketch"), notes.join('\n'));
  }
}

bool MainWindow::open(const QString& path)
{
  QStringList notes;
  bool opened = false;
  this->tried(
    [&]
    {
      opened = this->OpenDocument->open(
        path, [this] { return this->mayLeave(); }, notes);
    });
  if (opened)
  {
    this->remember(path);
    this->View->showHint({});
    this->Redrawn = -1;
    this->tell(notes);
  }
  return opened;
}

bool MainWindow::openPicture(const QString& path)
{
  bool opened = false;
  const auto mayLeave = [this] { return this->mayLeave(); };
  try
  {
    opened = path.isEmpty() ? this->OpenDocument->beginDrawing(mayLeave)
                            : this->OpenDocument->beginDrawing(path, mayLeave);
  }
  catch (const Failed& failure)
  {
    this->tell({ QString::fromStdString(failure.what()) });
  }
  if (opened)
  {
    this->View->showHint({});
    this->Redrawn = -1;
  }
  return opened;
}

QString MainWindow::pictureAsked(const QString& title)
{
  QStringList patterns;
  for (const QString& extension : pictureExtensions)
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
  const QString path = this->pictureAsked(tr("Draw a further part over a picture"));
  if (path.isEmpty())
  {
    return;
  }
  try
  {
    this->OpenDocument->addPart(path);
  }
  catch (const Failed& failure)
  {
    this->tell({ QString::fromStdString(failure.what()) });
    return;
  }
  const int part = this->OpenDocument->shownTo() - 1;
  this->History->selectStep(part);
  this->setTool(this->toolOf(part));
}

bool MainWindow::offerRecovery()
{
  for (const LeftBehind& left : leftBehind(autosaveRoot()))
  {
    QMessageBox box(QMessageBox::Question,
      tr("Oversketch"),
      tr("Oversketch ended before your work on %1 was saved. Open it again?")
        .arg(QString::fromStdString(left.meshName)),
      QMessageBox::NoButton,
      this);
    box.setInformativeText(left.strokes == 1
                             ? tr("It holds one stroke.")
                             : tr("It holds %n strokes.", nullptr, static_cast<int>(left.strokes)));
    QPushButton* again = box.addButton(tr("Open it"), QMessageBox::AcceptRole);
    QPushButton* away = box.addButton(tr("Throw it away"), QMessageBox::DestructiveRole);
    box.addButton(tr("Ask next time"), QMessageBox::RejectRole);
    box.setDefaultButton(again);
    box.exec();
    if (box.clickedButton() == again)
    {
      return this->tried([&] { this->OpenDocument->recover(left); });
    }
    if (box.clickedButton() == away)
    {
      removeLeftBehind(left);
    }
  }
  return false;
}

void MainWindow::openShippedModel()
{
  const QString path = shippedModel();
  QStringList none;
  if (!path.isEmpty() && this->tried(
                           [&]
                           {
                             this->OpenDocument->open(
                               path, [] { return true; }, none);
                           }))
  {
    this->View->showHint(this->View->tool()->hint());
  }
}

void MainWindow::openAsked()
{
  const QString path = QFileDialog::getOpenFileName(this,
    tr("Open a model or a session"),
    QSettings().value("folder").toString(),
    tr("Models and sessions (%1 *.oversketch);;Heights of a terrain (%2);;All files (*)")
      .arg(patternsOf(oversketch_files::meshExtensions), patternsOf(oversketch_files::heightsExtensions)));
  if (!path.isEmpty())
  {
    this->open(path);
  }
}

bool MainWindow::save()
{
  const QString path = this->OpenDocument->path();
  return path.isEmpty() ? this->saveAs() : this->tried([&] { this->OpenDocument->save(path); });
}

bool MainWindow::saveAs()
{
  if (!this->OpenDocument->isOpen())
  {
    return false;
  }
  QString path = QFileDialog::getSaveFileName(this,
    tr("Save the session"),
    QDir(QSettings().value("folder").toString())
      .filePath(QFileInfo(this->OpenDocument->name()).completeBaseName() + ".oversketch"),
    tr("Sessions (*.oversketch)"));
  if (path.isEmpty())
  {
    return false;
  }
  if (QFileInfo(path).suffix() != "oversketch")
  {
    path += ".oversketch";
  }
  return this->tried(
    [&]
    {
      this->OpenDocument->save(path);
      this->remember(path);
    });
}

void MainWindow::exportAsked()
{
  if (!this->OpenDocument->isOpen())
  {
    return;
  }
  const QString path = QFileDialog::getSaveFileName(this,
    tr("Export the mesh"),
    QDir(QSettings().value("folder").toString())
      .filePath(QFileInfo(this->OpenDocument->name()).completeBaseName() + ".ply"),
    tr("Meshes (%1)").arg(patternsOf(oversketch_files::meshExtensions)));
  if (!path.isEmpty())
  {
    this->tried([&] { this->tell(this->OpenDocument->save(path)); });
  }
}

void MainWindow::screenshot()
{
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QString name =
    tr("Oversketch %1.png").arg(QDateTime::currentDateTime().toString("yyyy-MM-dd hh.mm.ss"));
  QString path = QFileDialog::getSaveFileName(
    this, tr("Save a picture of the model"), QDir(folder).filePath(name), tr("Pictures (*.png)"));
  if (path.isEmpty())
  {
    return;
  }
  if (QFileInfo(path).suffix() != "png")
  {
    path += ".png";
  }
  const bool overlays =
    QMessageBox::question(this, tr("Oversketch"), tr("With the lines and texts over the model?")) ==
    QMessageBox::Yes;
  this->tried([&] { this->View->screenshot(path, overlays); });
}

bool MainWindow::mayLeave()
{
  if (!this->OpenDocument->isOpen() || !this->OpenDocument->isModified())
  {
    return true;
  }
  const auto answer = QMessageBox::question(this,
    tr("Oversketch"),
    tr("Save the session of %1?").arg(this->OpenDocument->name()),
    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel,
    QMessageBox::Save);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && this->save());
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  if (!this->mayLeave())
  {
    event->ignore();
    return;
  }
  QSettings settings;
  settings.setValue("geometry", this->saveGeometry());
  settings.setValue("state", this->saveState());
  this->OpenDocument->discardAutosave();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (event->mimeData()->hasUrls())
  {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event)
{
  const QList<QUrl> urls = event->mimeData()->urls();
  event->acceptProposedAction();
  if (urls.isEmpty())
  {
    return;
  }
  // Who dragged it need not wait for an answer to our questions.
  const QString path = urls.first().toLocalFile();
  QTimer::singleShot(0,
    this,
    [this, path]
    {
      // Behind an open model, or to be drawn over.
      const bool isPicture = pictureExtensions.contains(QFileInfo(path).suffix().toLower());
      const bool isBehind =
        this->OpenDocument->isOpen() && !this->Canvases[this->Tools.indexOf(this->View->tool())];
      isPicture ? (isBehind ? this->addPicture(path) : void(this->openPicture(path)))
                : void(this->open(path));
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
  if (!this->OpenDocument->isOpen())
  {
    return;
  }
  this->tried(
    [&]
    {
      QFile file(path);
      if (!file.open(QIODevice::ReadOnly))
      {
        throw Failed(tr("%1: %2").arg(path, file.errorString()).toStdString());
      }
      Picture picture;
      picture.image = { QFileInfo(path).fileName().toStdString(),
        std::make_shared<std::string>(file.readAll().toStdString()) };
      const auto pixels = oversketch_files::pictureOf(*picture.image.bytes);
      if (!pixels)
      {
        this->tell({ tr("%1 is no PNG or JPEG picture, or a damaged one.").arg(path) });
        return;
      }
      picture.frame = this->View->frameFor(pixels->GetDimensions()[0], pixels->GetDimensions()[1]);
      this->View->showHint({}); // it might not be legible before it
      this->OpenDocument->addPicture(picture);
    });
}

} // namespace oversketch_studio
