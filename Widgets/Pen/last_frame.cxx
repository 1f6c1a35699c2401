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
  mapper->SetInputConnection(this->Rectangle->GetOutputPort());
  this->Picture->SetMapper(mapper);
  this->Picture->SetTexture(this->Texture);
  this->Picture->GetProperty()->SetDisplayLocationToBackground();
  this->Texture->InterpolateOff();
  this->Overlay->InteractiveOff(); // events belong to the renderers below
  this->Overlay->AddViewProp(this->Picture);
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
  this->Texture->SetInputData(image);
  this->Rectangle->SetOrigin(0.0, 0.0, 0.0);
  this->Rectangle->SetPoint1(width, 0.0, 0.0);
  this->Rectangle->SetPoint2(0.0, height, 0.0);

  vtkRendererCollection* renderers = window->GetRenderers();
  vtkCollectionSimpleIterator at;
  renderers->InitTraversal(at);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(at))
  {
    if (renderer->GetDraw())
    {
      renderer->DrawOff();
      this->Off.emplace_back(renderer);
    }
  }
  this->Window = window;
  this->Layers = window->GetNumberOfLayers();
  this->Size[0] = width;
  this->Size[1] = height;
  window->SetNumberOfLayers(this->Layers + 1);
  this->Overlay->SetLayer(this->Layers);
  window->AddRenderer(this->Overlay);
  this->Frozen = true;
  return true;
}

void LastFrame::thaw()
{
  if (!this->Frozen)
  {
    return;
  }
  this->Frozen = false;
  for (const auto& renderer : this->Off)
  {
    renderer->DrawOn();
  }
  this->Off.clear();
  if (this->Window)
  {
    this->Window->RemoveRenderer(this->Overlay);
    if (this->Window->GetNumberOfLayers() == this->Layers + 1)
    {
      this->Window->SetNumberOfLayers(this->Layers);
    }
  }
  this->Texture->SetInputData(nullptr);
}

bool LastFrame::fits() const
{
  if (!this->Window)
  {
    return false;
  }
  const int* size = this->Window->GetSize();
  return size[0] == this->Size[0] && size[1] == this->Size[1];
}

} // namespace oversketch
