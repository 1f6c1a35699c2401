#include "last_frame.h"

#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRendererCollection.h"
#include "vtkTexture.h"
#include "vtkTexturedActor2D.h"
#include "vtkUnsignedCharArray.h"

namespace oversketch
{

LastFrame::LastFrame()
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(this->rectangle_->GetOutputPort());
  this->picture_->SetMapper(mapper);
  this->picture_->SetTexture(this->texture_);
  this->picture_->GetProperty()->SetDisplayLocationToBackground();
  this->texture_->InterpolateOff();
  this->overlay_->InteractiveOff(); // events belong to the renderers below
  this->overlay_->AddViewProp(this->picture_);
}

LastFrame::~LastFrame()
{
  this->thaw();
}

bool LastFrame::freeze(vtkRenderWindow* window)
{
  this->thaw();
  const int* size = window->GetSize();
  const int width = size[0], height = size[1];
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetNumberOfComponents(3);
  pixels->SetNumberOfTuples(static_cast<vtkIdType>(width) * height);
  if (width <= 0 || height <= 0 || window->GetNeverRendered() ||
      window->GetPixelData(0, 0, width - 1, height - 1, 1, pixels) != VTK_OK)
  {
    return false;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(pixels);
  this->texture_->SetInputData(image);
  this->rectangle_->SetOrigin(0.0, 0.0, 0.0);
  this->rectangle_->SetPoint1(width, 0.0, 0.0);
  this->rectangle_->SetPoint2(0.0, height, 0.0);

  vtkRendererCollection* renderers = window->GetRenderers();
  vtkCollectionSimpleIterator at;
  renderers->InitTraversal(at);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(at))
  {
    if (renderer->GetDraw())
    {
      renderer->DrawOff();
      this->off_.emplace_back(renderer);
    }
  }
  this->window_ = window;
  this->layers_ = window->GetNumberOfLayers();
  this->size_[0] = width;
  this->size_[1] = height;
  window->SetNumberOfLayers(this->layers_ + 1);
  this->overlay_->SetLayer(this->layers_);
  window->AddRenderer(this->overlay_);
  this->frozen_ = true;
  return true;
}

void LastFrame::thaw()
{
  if (!this->frozen_)
  {
    return;
  }
  this->frozen_ = false;
  for (const auto& renderer : this->off_)
  {
    renderer->DrawOn();
  }
  this->off_.clear();
  if (this->window_)
  {
    this->window_->RemoveRenderer(this->overlay_);
    if (this->window_->GetNumberOfLayers() == this->layers_ + 1)
    {
      this->window_->SetNumberOfLayers(this->layers_);
    }
  }
  this->texture_->SetInputData(nullptr);
}

bool LastFrame::fits() const
{
  if (!this->window_)
  {
    return false;
  }
  const int* size = this->window_->GetSize();
  return size[0] == this->size_[0] && size[1] == this->size_[1];
}

} // namespace oversketch
