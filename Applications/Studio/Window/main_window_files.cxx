#include "main_window.h"

#include "exporting.h"
#include "files.h"
#include "heights.h"
#include "history_panel.h"
#include "long_work.h"
#include "mesh_file.h"
#include "models.h"
#include "picture_files.h"
#include "pieces.h"
#include "print_dialog.h"
#include "resources.h"
#include "scene_panel.h"
#include "status_labels.h"
#include "system_strings.h"
#include "tool.h"
#include "viewport.h"

#include "vtkOversketchPrintCheck.h"
#include "vtkOversketchStepRunner.h"

#include <QAbstractSpinBox>
#include <QCloseEvent>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>

#include <algorithm>
#include <memory>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

// "*.obj *.ply": of extensions with blanks between.
QString patternsOf(const char* extensions)
{
  return '*' + QString::fromLatin1(extensions).replace(' ', " *");
}

// Where the session lies, else where the last one was saved, else where the model or the picture is from; not
// among the program's own files, nor where nothing can be written.
QString folderToSaveIn(const QString& session)
{
  const QSettings settings;
  const QFileInfo own(QFileInfo(shippedModel()).dir().filePath(".."));
  for (const QString& folder : { session.isEmpty() ? QString() : QFileInfo(session).absolutePath(),
         settings.value("saveFolder").toString(),
         settings.value("folder").toString() })
  {
    const QFileInfo info(folder);
    const bool isOwn = own.exists() && info.canonicalFilePath().startsWith(own.canonicalFilePath());
    if (!folder.isEmpty() && info.isDir() && info.isWritable() && !isOwn)
    {
      return folder;
    }
  }
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

// A function that makes one mesh of them, once, on any thread; null where that was given up. The window looks
// at them meanwhile, and a writer keeps ranges in the arrays.
std::function<vtkSmartPointer<vtkPolyData>()> wholeOf(const ExactResults& results)
{
  const auto meshes = std::make_shared<std::vector<vtkSmartPointer<vtkPolyData>>>();
  for (const auto& result : results)
  {
    meshes->push_back(result->isLarge() ? nullptr : deepCopyOf(result->dressed()));
  }
  return [meshes, results]() -> vtkSmartPointer<vtkPolyData>
  {
    for (std::size_t i = 0; i < results.size(); ++i)
    {
      const SharedData exact = (*meshes)[i] ? SharedData() : results[i]->mesh(progressOfWork());
      if (!(*meshes)[i] && !exact)
      {
        return nullptr;
      }
      (*meshes)[i] = (*meshes)[i] ? (*meshes)[i] : deepCopyOf(exact);
    }
    const auto whole = joined({ meshes->begin(), meshes->end() });
    meshes->clear(); // a large scene lies there once less
    return whole;
  };
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

bool MainWindow::mayBegin()
{
  const QString what = longWorkGoing();
  if (!what.isEmpty())
  {
    this->Advice->setText(tr("%1 Wait until that is done, or cancel it.").arg(what));
  }
  return what.isEmpty();
}

bool MainWindow::runAside(const QString& what,
  const std::function<void()>& work,
  const std::function<void()>& then)
{
  bool done = false;
  return this->mayBegin() &&
         this->tried(
           [&]
           {
             done = doLongWork(this, what, work);
             if (done)
             {
               then();
             }
           }) &&
         done;
}

void MainWindow::tell(const QStringList& notes)
{
  if (!notes.isEmpty())
  {
    QMessageBox::information(this, tr("Oversketch"), notes.join('\n'));
  }
}

// A picture is drawn over, or its greys are heights.
bool MainWindow::open(const QString& path)
{
  const QString suffix = QFileInfo(path).suffix().toLower();
  if (pictureExtensions().contains(suffix) && findSystem(drawingSystem))
  {
    const bool canBeHeights =
      oversketch_files::isHeightsExtension("." + suffix.toStdString()) && findSystem("Terrain");
    if (!canBeHeights)
    {
      return this->openPicture(path);
    }
    QMessageBox box(QMessageBox::Question,
      tr("Oversketch"),
      tr("What is %1 for?").arg(QFileInfo(path).fileName()),
      {},
      this);
    QPushButton* over = box.addButton(tr("&Draw over it"), QMessageBox::AcceptRole);
    QPushButton* heights = box.addButton(tr("Take it as &heights"), QMessageBox::AcceptRole);
    QPushButton* none = box.addButton(QMessageBox::Cancel);
    none->setText(tr("&Cancel"));
    box.setDefaultButton(over);
    box.exec();
    if (box.clickedButton() == over)
    {
      return this->openPicture(path);
    }
    if (box.clickedButton() != heights)
    {
      return false;
    }
  }
  const bool opened = this->openFile(path);
  if (opened)
  {
    this->remember(path);
  }
  return opened;
}

bool MainWindow::openFile(const QString& path)
{
  const int backend = this->OpenDocument->backend();
  return this->openRead(QFileInfo(path).fileName(),
    [path, backend, most = this->Large->most()] { return Document::read(path, backend, most); });
}

bool MainWindow::openExample(const Example& example)
{
  const int backend = this->OpenDocument->backend();
  return this->openRead(example.title, [example, backend] { return readExample(example, backend); });
}

bool MainWindow::openRead(const QString& name, const std::function<Document::Opened()>& read)
{
  return this->mayBegin() && this->mayLeave() &&
         this->readAside(name,
           read,
           [this](Document::Opened opened)
           {
             this->Redrawn = -1;
             this->stopTeaching();
             const QStringList notes = opened.notes;
             this->OpenDocument->open(std::move(opened));
             this->tell(notes);
           });
}

bool MainWindow::recover(const LeftBehind& left, const QString& name)
{
  const int backend = this->OpenDocument->backend();
  const QString folder = QString::fromStdString(left.folder);
  return this->readAside(
    name,
    [folder, backend, most = this->Large->most()] { return Document::read(folder, backend, most); },
    [this, &left](Document::Opened read) { this->OpenDocument->recover(left, std::move(read)); });
}

bool MainWindow::offerRecovery()
{
  for (const LeftBehind& left : leftBehind(autosaveRoot()))
  {
    const QString name = left.path.empty() ? QString::fromStdString(left.meshName)
                                           : QFileInfo(QString::fromStdString(left.path)).fileName();
    QMessageBox box(QMessageBox::Question,
      tr("Oversketch"),
      tr("Oversketch ended before your work on %1 was saved. Open it again?").arg(name),
      QMessageBox::NoButton,
      this);
    const QString time = QLocale().toString(QDateTime::fromSecsSinceEpoch(left.time), QLocale::ShortFormat);
    box.setInformativeText(
      left.strokes == 1
        ? tr("Last changed %1. It has one step.").arg(time)
        : tr("Last changed %1. It has %n steps.", nullptr, static_cast<int>(left.strokes)).arg(time));
    QPushButton* again = box.addButton(tr("&Open it"), QMessageBox::AcceptRole);
    QPushButton* away = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
    box.addButton(tr("&Ask next time"), QMessageBox::RejectRole);
    box.setDefaultButton(again);
    box.exec();
    if (box.clickedButton() == again)
    {
      return this->recover(left, name);
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
  if (!path.isEmpty() && this->openFile(path))
  {
    this->ShowsHints = true;
    this->teach();
  }
}

QString MainWindow::modelAsked(const QString& title)
{
  return QFileDialog::getOpenFileName(this,
    title,
    QSettings().value("folder").toString(),
    tr("Models and sessions (%1 *.oversketch);;Heights of a terrain (%2);;All files (*)")
      .arg(patternsOf(oversketch_files::meshExtensions), patternsOf(oversketch_files::heightsExtensions)));
}

void MainWindow::openAsked()
{
  const QString path = this->modelAsked(tr("Open a model or a session"));
  if (!path.isEmpty())
  {
    this->open(path);
  }
}

// A number or a name that was not confirmed yet: else Ctrl+S would keep the session without it.
void MainWindow::takeWhatIsTyped()
{
  QWidget* focused = this->focusWidget();
  if (qobject_cast<QLineEdit*>(focused) || qobject_cast<QAbstractSpinBox*>(focused))
  {
    focused->clearFocus();
    focused->setFocus();
  }
}

bool MainWindow::save()
{
  this->takeWhatIsTyped();
  const QString path = this->OpenDocument->path();
  return path.isEmpty() ? this->saveAs() : this->saveTo(path);
}

bool MainWindow::saveTo(const QString& path)
{
  const auto file = std::make_shared<const SessionFile>(this->OpenDocument->toSave());
  return this->runAside(
    tr("Saving %1…").arg(QFileInfo(path).fileName()),
    [path, file] { writeSession(path.toStdString(), *file); },
    [this, &path]
    {
      this->OpenDocument->saved(path);
      this->remember(path);
      QSettings().setValue("saveFolder", QFileInfo(path).absolutePath());
      this->Advice->setText(tr("Saved as %1.").arg(path));
    });
}

bool MainWindow::saveAs()
{
  this->takeWhatIsTyped();
  if (!this->OpenDocument->isOpen())
  {
    return false;
  }
  QString path = QFileDialog::getSaveFileName(this,
    tr("Save the session"),
    QDir(folderToSaveIn(this->OpenDocument->path()))
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
  return this->saveTo(path);
}

void MainWindow::exportAsked()
{
  if (this->OpenDocument->isOpen() && this->mayBegin())
  {
    this->exportMeshes(this->Large->results(), -1, this->OpenDocument->name());
  }
}

void MainWindow::exportMeshes(const ExactResults& results, int part, const QString& name)
{
  if (results.empty() || !results.front())
  {
    return;
  }
  const auto wears = [](const auto& result)
  { return !oversketch_files::picturesOf(result->dressed()).empty(); };
  const bool wearsPicture = std::any_of(results.begin(), results.end(), wears);
  const QString path = exportPathAsked(this, QFileInfo(name).completeBaseName(), wearsPicture);
  if (path.isEmpty())
  {
    return;
  }
  const QString said = !wearsPicture        ? tr("Exported %1.")
                       : keepsPicture(path) ? tr("Exported %1 with its picture.")
                                            : tr("Exported %1 without its picture: choose glTF to keep it.");
  this->writeAside(path,
    said,
    [makeWhole = wholeOf(results), part]() -> vtkSmartPointer<vtkPolyData>
    {
      const auto whole = makeWhole();
      return part < 0 || !whole ? whole : oversketch_files::partAlone(whole, part);
    });
}

void MainWindow::writeAside(const QString& path,
  const QString& said,
  const std::function<vtkSmartPointer<vtkPolyData>()>& make)
{
  const auto notes = std::make_shared<oversketch_files::Notes>();
  const QString file = QFileInfo(path).fileName();
  this->runAside(
    tr("Exporting %1…").arg(file),
    [make, path, notes]
    {
      if (const auto mesh = make())
      {
        oversketch_files::writeMesh(mesh, path.toStdString(), *notes);
      }
    },
    [&] { this->Advice->setText((QStringList{ said.arg(file) } + listOf(*notes)).join(' ')); });
}

void MainWindow::printAsked()
{
  const ExactResults results = this->OpenDocument->isOpen() ? this->Large->results() : ExactResults();
  if (results.empty())
  {
    return;
  }
  if (auto* open = this->findChild<PrintDialog*>())
  {
    open->reject(); // it is of the model as it was
  }
  const auto check = vtkSmartPointer<vtkOversketchPrintCheck>::New();
  const bool isChecked = this->runAside(
    tr("Checking %1…").arg(this->OpenDocument->name()),
    [check, makeWhole = wholeOf(results)]
    {
      if (const auto whole = makeWhole())
      {
        check->SetInputData(oversketch_files::withoutQuads(whole));
        oversketch::StepRunner(check, progressOfWork()).Run();
      }
    },
    [] {});
  if (!isChecked)
  {
    return;
  }
  this->View->display().others().show(Session()); // they are in what is shown
  auto* dialog = new PrintDialog(
    check,
    this->OpenDocument->upAxis(),
    [this](vtkPolyData* mesh) { this->View->showInstead(mesh, true); },
    this);
  connect(this->OpenDocument, &Document::changed, dialog, &QDialog::reject);
  connect(this->OpenDocument, &Document::begun, dialog, &QDialog::reject);
  connect(dialog,
    &QDialog::finished,
    this,
    [this]
    {
      this->View->showInstead(nullptr);
      this->View->display().others().show(this->OpenDocument->session());
    });
  connect(dialog,
    &QDialog::accepted,
    this,
    [this, dialog] // once it has closed: what asks for a name runs events, which may delete it
    { QTimer::singleShot(0, this, [this, mesh = dialog->printed()] { this->writePrint(mesh); }); });
  dialog->move(this->mapToGlobal(QPoint(this->width() - dialog->sizeHint().width(), 0))); // beside the model
  dialog->show();
}

void MainWindow::writePrint(const vtkSmartPointer<vtkPolyData>& mesh)
{
  const QString path = printPathAsked(this, QFileInfo(this->OpenDocument->name()).completeBaseName());
  if (!path.isEmpty())
  {
    this->writeAside(path, tr("Exported %1."), [mesh] { return mesh; });
  }
}

void MainWindow::screenshot(bool lines)
{
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QString name =
    tr("Oversketch %1.png").arg(QDateTime::currentDateTime().toString("yyyy-MM-dd hh.mm.ss"));
  QString path = QFileDialog::getSaveFileName(this,
    lines ? tr("Save a picture of the model with lines and texts") : tr("Save a picture of the model"),
    QDir(folder).filePath(name),
    tr("Pictures (*.png)"));
  if (path.isEmpty())
  {
    return;
  }
  if (QFileInfo(path).suffix() != "png")
  {
    path += ".png";
  }
  if (this->tried([&] { this->View->screenshot(path, lines); }))
  {
    this->Advice->setText(tr("Saved as %1.").arg(path));
  }
}

void MainWindow::turntableAsked()
{
  if (!this->View->mesh() || !this->mayBegin())
  {
    return;
  }
  if (this->OpenDocument->isBusy())
  {
    this->Advice->setText(tr("Wait until the model is computed: it would change in the film."));
    return;
  }
  const TurnFilm film = turnFilmAsked(this, QFileInfo(this->OpenDocument->name()).completeBaseName());
  if (film.path.isEmpty())
  {
    return;
  }
  bool isWritten = false;
  this->tried(
    [&]
    {
      WorkHere work(this, tr("Writing %1…").arg(QFileInfo(film.path).fileName()));
      isWritten =
        this->View->writeTurn(film.path, film.frames, [&work](double share) { return work.goesOn(share); });
    });
  if (isWritten)
  {
    this->Advice->setText(tr("Saved as %1.").arg(film.path));
  }
}

bool MainWindow::mayLeave()
{
  this->takeWhatIsTyped();
  if (!this->OpenDocument->isOpen() || !this->OpenDocument->isModified())
  {
    return true;
  }
  QMessageBox box(QMessageBox::Question,
    tr("Oversketch"),
    tr("Save the session of %1?").arg(this->OpenDocument->name()),
    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel,
    this);
  box.setDefaultButton(QMessageBox::Save);
  box.button(QMessageBox::Save)->setText(tr("&Save"));
  box.button(QMessageBox::Discard)->setText(tr("&Discard"));
  box.button(QMessageBox::Cancel)->setText(tr("&Cancel"));
  const int answer = box.exec();
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && this->save());
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  if (!this->mayBegin() || !this->mayLeave())
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
  const bool onScene = this->Scene->rect().contains(this->Scene->mapFrom(this, event->pos()));
  QTimer::singleShot(0,
    this,
    [this, path, onScene]
    {
      // A picture behind an open model, or to be drawn over; a model beside the open one, or instead of it.
      // A TIFF may be both: it is a grid of heights sooner.
      const QString kind = QFileInfo(path).suffix().toLower();
      const bool isPicture = pictureExtensions().contains(kind) && !kind.startsWith("tif");
      const bool isModel = !isPicture && this->OpenDocument->isOpen() && onScene;
      const bool isBehind =
        this->OpenDocument->isOpen() && !this->Canvases[this->Tools.indexOf(this->View->tool())];
      isPicture ? (isBehind ? this->addPicture(path) : void(this->openPicture(path)))
      : isModel ? this->addModel(path)
                : void(this->open(path));
    });
}

} // namespace oversketch_studio
