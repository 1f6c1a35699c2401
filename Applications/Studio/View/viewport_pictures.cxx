// Pictures of the view, and films of it.
#include "viewport.h"

#include "film.h"
#include "tool.h"

#include "vtkOversketchInteractorStyle.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkWindowToImageFilter.h"

#include <functional>
#include <memory>

namespace oversketch_studio
{

class Viewport::Bare
{
public:
  explicit Bare(Viewport& view)
    : View(view)
    , Section(view.Section->GetVisibility())
    , Region(view.Region.isShown())
    , Mirror(view.Mirror.isVisible())
    , Hint(view.HintBox.isVisible())
    , Keys(view.Style->GetShowKeys())
  {
    this->showLines(false);
    this->View.Masked.setVisible(false);
    this->show(false, false, false, false, false);
  }
  ~Bare()
  {
    this->show(this->Section, this->Region, this->Mirror, this->Hint, this->Keys);
    this->View.Masked.setVisible(!this->View.Looks.instead());
    this->showLines(true);
    this->View.render();
  }
  Bare(const Bare&) = delete;
  Bare& operator=(const Bare&) = delete;

private:
  void show(bool section, bool region, bool mirror, bool hint, bool keys)
  {
    this->View.Section->SetVisibility(section);
    this->View.Region.actor()->SetVisibility(region);
    this->View.Mirror.setVisible(mirror);
    this->View.HintBox.setVisible(hint);
    this->View.Style->SetShowKeys(keys);
  }
  void showLines(bool show)
  {
    for (Tool* tool : this->View.findChildren<Tool*>())
    {
      tool->showLines(show);
    }
    emit this->View.linesShown(show);
    this->View.Looks.setOverlays(show);
  }

  Viewport& View;
  bool Section, Region, Mirror, Hint, Keys;
};

vtkSmartPointer<vtkImageData> Viewport::grabbed()
{
  this->render();
  this->renderSmooth();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(this->Window);
  picture->ReadFrontBufferOff();
  picture->Update();
  return picture->GetOutput();
}

void Viewport::screenshot(const QString& path, bool overlays)
{
  vtkSmartPointer<vtkImageData> picture;
  {
    const auto bare = overlays ? nullptr : std::make_unique<Bare>(*this);
    picture = this->grabbed();
  }
  oversketch_files::NewFiles files;
  oversketch_files::writePng(path.toStdString(), picture, files);
  files.commit();
}

bool Viewport::writeTurn(const QString& path, int frames, const std::function<bool(double)>& goesOn)
{
  const vtkBoundingBox box = this->Looks.box();
  if (!box.IsValid())
  {
    return false;
  }
  double middle[3], axis[3] = { 0.0, 0.0, 0.0 };
  box.GetCenter(middle);
  axis[this->Style->GetUpAxis()] = 1.0;
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  vtkNew<vtkCamera> before;
  before->DeepCopy(camera);
  const auto look = [&](double angle)
  {
    vtkNew<vtkTransform> turn;
    turn->Translate(middle);
    turn->RotateWXYZ(angle, axis);
    turn->Translate(-middle[0], -middle[1], -middle[2]);
    camera->DeepCopy(before);
    if (angle != 0.0) // to the bit
    {
      camera->ApplyTransform(turn);
      this->Renderer->ResetCameraClippingRange();
    }
  };
  const auto frame = [&](int number) -> vtkSmartPointer<vtkImageData>
  {
    if (!goesOn(double(number) / frames))
    {
      return nullptr;
    }
    look(360.0 * number / frames);
    return this->grabbed();
  };
  oversketch_files::NewFiles files;
  bool isWhole = false;
  {
    const Bare bare(*this);
    struct Back
    {
      const std::function<void()> look;
      ~Back() { this->look(); }
    } const back{ [&] { look(0.0); } };
    isWhole = oversketch_files::writeFilm(path.toStdString(), frames, frame, files);
  }
  if (isWhole)
  {
    files.commit();
  }
  return isWhole;
}

} // namespace oversketch_studio
