// A picture of what the view shows, as a file.
#include "viewport.h"

#include "files.h"
#include "tool.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkActor.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkPNGWriter.h"
#include "vtkWindowToImageFilter.h"

namespace oversketch_studio
{

void Viewport::screenshot(const QString& path, bool overlays)
{
  const int section = this->Section->GetVisibility(), region = this->Region.isShown();
  const bool mirror = this->Mirror.isVisible(), hint = this->HintBox.isVisible(),
             keys = this->Style->GetShowKeys();
  if (!overlays)
  {
    for (Tool* tool : this->findChildren<Tool*>())
    {
      tool->showLines(false);
    }
    emit this->linesShown(false);
    this->Section->VisibilityOff();
    this->Region.actor()->VisibilityOff();
    this->Mirror.setVisible(false);
    this->HintBox.setVisible(false);
    this->Style->SetShowKeys(false);
    this->Looks.setOverlays(false);
  }
  this->render();
  this->renderSmooth();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(this->Window);
  picture->ReadFrontBufferOff();
  picture->Update();
  this->Section->SetVisibility(section);
  this->Region.actor()->SetVisibility(region);
  this->Looks.setOverlays(true);
  this->Mirror.setVisible(mirror);
  this->HintBox.setVisible(hint);
  this->Style->SetShowKeys(keys);
  for (Tool* tool : this->findChildren<Tool*>())
  {
    tool->showLines(true);
  }
  emit this->linesShown(true);
  this->render();
  oversketch_files::writeWhole(path.toStdString(),
    [&](const std::string& file)
    {
      vtkNew<vtkPNGWriter> writer;
      writer->SetInputConnection(picture->GetOutputPort());
      writer->SetFileName(file.c_str());
      writer->Write();
      if (writer->GetErrorCode() != 0)
      {
        throw oversketch_files::Failed(
          tr("%1 could not be written. Is the disk full?").arg(path).toStdString());
      }
    });
}

} // namespace oversketch_studio
