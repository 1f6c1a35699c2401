#include "vtkOversketchLayerHandleWidget.h"

#include "vtkOversketchLayerHandleRepresentation.h"
#include "widget_events.h"

#include "Mesh/context.h"
#include "Shading/layer_list.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

using namespace oversketch;
using LayersShown = vtkOversketchLayerHandleRepresentation;

vtkStandardNewMacro(vtkOversketchLayerHandleWidget);
oversketchRepresentationMacro(LayerHandle);

namespace
{

double roundedShare(double share)
{
  return std::round(1e4 * share) / 1e4;
}

} // namespace

vtkOversketchLayerHandleWidget::~vtkOversketchLayerHandleWidget()
{
  this->vtkOversketchLayerHandleWidget::SetEnabled(0);
}

bool vtkOversketchLayerHandleWidget::SetRegion(vtkPolyData* mesh)
{
  this->StopDragging(false);
  return this->GetLayerHandleRepresentation()->SetRegion(mesh);
}

void vtkOversketchLayerHandleWidget::SetLayers(const char* text)
{
  LayersShown* shown = this->GetLayerHandleRepresentation();
  if (std::string(text ? text : "") != shown->GetLayers())
  {
    this->StopDragging(false);
    shown->SetLayers(text);
    shown->SetActiveGrip(0);
    this->Modified();
  }
}

const char* vtkOversketchLayerHandleWidget::GetLayers()
{
  return this->GetLayerHandleRepresentation()->GetLayers();
}

bool vtkOversketchLayerHandleWidget::Grasp(int grip, const int at[2])
{
  LayersShown* shown = this->GetLayerHandleRepresentation();
  if (grip == 0 && !shown->IsOnRegion(at[0], at[1]))
  {
    return false;
  }
  this->Before = shown->GetLayers();
  this->Moved = false;
  std::copy_n(at, 2, this->From);
  LayerList list = layerList(this->Before);
  try
  {
    std::vector<LayerHandle>& handles = handlesIn(list, shown->GetArea());
    if (grip > 0)
    {
      handles = grasped(handles, grip - 1);
    }
    else
    {
      const double share = roundedShare(shown->GetShareAt(at[0], at[1]));
      const double rest = roundedShare(Layers(2, handles).restOf(share));
      handles.push_back({ rest, share });
      Layers(2, handles); // whether there is room for it
    }
    this->LastRest = handles.back().rest;
  }
  catch (const Error& error)
  {
    this->Tell(error.what());
    this->Render();
    return false;
  }
  this->Held = layerText(list);
  this->HeldArea = shown->GetArea();
  shown->SetLayers(this->Held.c_str());
  shown->SetActiveGrip(shown->GetNumberOfHandles());
  shown->PutKnob(shown->GetNumberOfHandles() - 1, at[0], at[1]);
  return true;
}

void vtkOversketchLayerHandleWidget::Pull(const int at[2])
{
  LayersShown* shown = this->GetLayerHandleRepresentation();
  LayerList list = layerList(this->Held);
  LayerHandle& handle = handlesIn(list, this->HeldArea).back(); // whichever the host shows by now
  const double share = roundedShare(shown->GetShareAt(at[0], at[1]));
  this->Moved = this->Moved || at[0] != this->From[0] || at[1] != this->From[1];
  if (this->Moved) // a press beside the line's middle is no drag yet
  {
    handle.place = share;
  }
  shown->SetLayers(layerText(list).c_str());
  if (shown->GetArea() == this->HeldArea)
  {
    shown->PutKnob(shown->GetNumberOfHandles() - 1, at[0], at[1]);
  }
}

bool vtkOversketchLayerHandleWidget::LetGo(bool keep)
{
  LayersShown* shown = this->GetLayerHandleRepresentation();
  if (!keep)
  {
    shown->SetLayers(this->Before.c_str());
    shown->SetText("");
  }
  shown->SetActiveGrip(0);
  return shown->GetLayers() != this->Before;
}

bool vtkOversketchLayerHandleWidget::RemoveHandle()
{
  this->StopDragging(false);
  LayersShown* shown = this->GetLayerHandleRepresentation();
  LayerList list = layerList(shown->GetLayers());
  std::vector<LayerHandle>& handles = handlesIn(list, shown->GetArea());
  const auto last = std::find_if(handles.begin(),
    handles.end(),
    [this](const LayerHandle& handle) { return handle.rest == this->LastRest; });
  if (last == handles.end())
  {
    return false;
  }
  handles.erase(last);
  shown->SetLayers(layerText(list).c_str());
  shown->SetActiveGrip(0);
  return true;
}

bool vtkOversketchLayerHandleWidget::UseKey(const std::string& key)
{
  if ((key == "Delete" || key == "BackSpace" || key == "KP_Delete") && this->RemoveHandle())
  {
    this->GetLayerHandleRepresentation()->SetText("");
    this->ValueChanged();
    return true;
  }
  return false;
}

void vtkOversketchLayerHandleWidget::SetRepresentation(vtkOversketchLayerHandleRepresentation* representation)
{
  this->StopDragging(false);
  this->SetWidgetRepresentation(representation);
}

void vtkOversketchLayerHandleWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layers: " << this->GetLayers() << "\n";
  os << indent << "LastRest: " << this->LastRest << "\n";
}
