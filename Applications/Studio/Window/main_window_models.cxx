// The window's models: those of a scene, and which of them is worked on.
#include "main_window.h"

#include "history_panel.h"
#include "models.h"
#include "scene_panel.h"
#include "status_labels.h"
#include "stroke_lines.h"
#include "tool.h"
#include "viewport.h"

#include "vtkRenderer.h"

#include <QFileInfo>

#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

// Before the window hears of the document, so that a mesh is not drawn as chosen and as one beside.
void MainWindow::listenToModels()
{
  const auto follow = [this]
  {
    const Session& scene = this->OpenDocument->session();
    this->View->display().others().show(scene);
    this->Lines->setVisible(scene.shown);
    this->View->renderSoon();
  };
  connect(this->OpenDocument,
    &Document::changed,
    this,
    [this, follow]
    {
      follow();
      // No line of a model that takes no strokes can be taken hold of.
      const bool takes = this->OpenDocument->whyNoSteps().isEmpty();
      if (takes != std::exchange(this->AcceptsSteps, takes))
      {
        this->offerStep();
        this->chooseLine();
      }
    });
  connect(this->OpenDocument, &Document::opened, this, follow);
  connect(this->OpenDocument, &Document::begun, this, [this] { this->FrameOnNextMesh = true; });
  connect(this->OpenDocument,
    &Document::refused,
    this,
    [this](const QString& why)
    {
      this->showResult(); // without what the hand has drawn
      this->Redrawn = -1;
      this->Advice->setText(why);
    });
  connect(this->Scene, &ScenePanel::partsHidden, this->View, &Viewport::hideParts);
  connect(this->Scene, &ScenePanel::exportAsked, this, &MainWindow::exportModel);
  connect(this->Scene, &ScenePanel::modelAsked, this, &MainWindow::addModelAsked);
  connect(this->Scene,
    &ScenePanel::joinAsked,
    this,
    [this](const Step& step)
    {
      const int row = this->OpenDocument->shownTo();
      this->OpenDocument->add(step);
      this->History->selectStep(row);
    });
}

void MainWindow::addModelAsked()
{
  const QString path = this->modelAsked(tr("Add a model"));
  if (!path.isEmpty())
  {
    this->addModel(path);
  }
}

void MainWindow::addModel(const QString& path)
{
  if (!this->OpenDocument->isOpen())
  {
    this->open(path);
    return;
  }
  const int backend = this->OpenDocument->backend();
  this->readAside(
    QFileInfo(path).fileName(),
    [path, backend, most = this->Large->most()] { return Document::readModels(path, backend, most); },
    [this, &path](const Document::Opened& read)
    {
      this->OpenDocument->addModels(read);
      this->stopTeaching();
      this->remember(path);
      this->View->display().showWhole(this->View->fittedSize().data());
      this->View->renderSoon();
      this->tell(read.notes);
    });
}

void MainWindow::exportModel(int model, int part, const QString& name)
{
  if (!this->OpenDocument->isOpen() || !this->mayBegin())
  {
    return;
  }
  this->exportMeshes({ this->Large->resultAt(indexOf(model)) }, part, name);
}

bool MainWindow::chooseModelAt(const QPoint& place)
{
  if (!this->OpenDocument->isOpen() || this->View->tool()->isBusy())
  {
    return false;
  }
  const double ratio = this->View->devicePixelRatioF();
  const double x = ratio * place.x(), y = ratio * (this->View->height() - 1 - place.y());
  if (this->View->tool()->holds(x, y))
  {
    return false;
  }
  const auto id = this->View->display().others().at(static_cast<int>(x), static_cast<int>(y));
  const int model = id ? placeOfModel(this->OpenDocument->session(), *id) : -1;
  if (model >= 0)
  {
    this->OpenDocument->chooseModel(model);
  }
  return model >= 0;
}

} // namespace oversketch_studio
