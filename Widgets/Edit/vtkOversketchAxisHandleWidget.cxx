#include "vtkOversketchAxisHandleWidget.h"

#include "vtkOversketchAxisHandleRepresentation.h"
#include "widget_events.h"

#include "Matrix/operations.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace oversketch;
using AxesShown = vtkOversketchAxisHandleRepresentation;

vtkStandardNewMacro(vtkOversketchAxisHandleWidget);
oversketchRepresentationMacro(AxisHandle);

namespace
{

constexpr double clickLength = 3.0; // px

double roundedPlace(double t)
{
  return std::round(1000.0 * std::clamp(t, 0.0, 1.0)) / 1000.0;
}

bool holds(const std::vector<double>& places, double t)
{
  return std::find(places.begin(), places.end(), t) != places.end();
}

} // namespace

vtkOversketchAxisHandleWidget::~vtkOversketchAxisHandleWidget()
{
  this->vtkOversketchAxisHandleWidget::SetEnabled(0);
}

bool vtkOversketchAxisHandleWidget::SetCurve(vtkPolyData* curve, vtkPolyData* mesh)
{
  this->StopDragging(false);
  AxesShown* shown = this->GetAxisHandleRepresentation();
  const bool fits = shown->SetCurve(curve, mesh);
  if (shown->GetSelectedHandle() >= shown->GetNumberOfHandles())
  {
    shown->SetSelectedHandle(-1);
  }
  return fits;
}

void vtkOversketchAxisHandleWidget::SetOperations(const char* text)
{
  AxesShown* shown = this->GetAxisHandleRepresentation();
  if (std::string(text ? text : "") == shown->GetOperations())
  {
    return;
  }
  this->StopDragging(false);
  const double selected = shown->GetHandleT(shown->GetSelectedHandle());
  shown->SetOperations(text);
  this->Select(selected);
  this->Modified();
}

const char* vtkOversketchAxisHandleWidget::GetOperations()
{
  return this->GetAxisHandleRepresentation()->GetOperations();
}

void vtkOversketchAxisHandleWidget::Select(double t)
{
  AxesShown* shown = this->GetAxisHandleRepresentation();
  shown->SetSelectedHandle(-1);
  for (int i = 0; i < shown->GetNumberOfHandles(); ++i)
  {
    if (shown->GetHandleT(i) == t)
    {
      shown->SetSelectedHandle(i);
    }
  }
}

bool vtkOversketchAxisHandleWidget::AddHandle(double t)
{
  this->StopDragging(false);
  AxesShown* shown = this->GetAxisHandleRepresentation();
  std::vector<Operation> rows = operationsOf(shown->GetOperations());
  const bool isNew = std::isfinite(t) && !holds(handlePlaces(rows), roundedPlace(t));
  if (isNew)
  {
    rows.push_back({ Verb::Pin, roundedPlace(t), 0, 0.0 });
    shown->SetOperations(operationText(rows).c_str());
  }
  this->Select(roundedPlace(t));
  return isNew;
}

bool vtkOversketchAxisHandleWidget::RemoveSelectedHandle()
{
  this->StopDragging(false);
  AxesShown* shown = this->GetAxisHandleRepresentation();
  const double t = shown->GetHandleT(shown->GetSelectedHandle());
  if (t < 0.0)
  {
    return false;
  }
  std::vector<Operation> rows = operationsOf(shown->GetOperations());
  rows.erase(
    std::remove_if(
      rows.begin(), rows.end(), [&](const Operation& row) { return row.verb != Verb::Drag && row.t == t; }),
    rows.end());
  shown->SetOperations(operationText(rows).c_str());
  shown->SetSelectedHandle(-1);
  shown->SetActiveGrip(0);
  return true;
}

bool vtkOversketchAxisHandleWidget::Grasp(int grip, const int at[2])
{
  AxesShown* shown = this->GetAxisHandleRepresentation();
  if (grip == 0)
  {
    return false;
  }
  const int part = shown->GetPart(grip), handle = shown->GetHandle(grip);
  this->Before = shown->GetOperations();
  this->Grip = grip;
  std::copy_n(at, 2, this->From);
  this->Moved = false;
  this->PulledLine = false;
  std::fill(this->Shift, this->Shift + 3, 0.0);
  this->T = part == AxesShown::Line ? roundedPlace(shown->GetT(at[0], at[1])) : shown->GetHandleT(handle);
  if (part == AxesShown::Knob)
  {
    shown->SetSelectedHandle(handle);
  }
  shown->StartDrag(at[0], at[1], handle, this->T);
  shown->SetActiveGrip(grip);
  return true;
}

void vtkOversketchAxisHandleWidget::Pull(const int at[2])
{
  this->Moved = this->Moved || std::hypot(at[0] - this->From[0], at[1] - this->From[1]) > clickLength;
  if (this->Moved)
  {
    this->GetAxisHandleRepresentation()->GetAxis(this->Grip) < 0 ? this->PullLine(at) : this->PullAxis(at);
  }
}

// One shift of all handles: between two of them both together are all of it.
void vtkOversketchAxisHandleWidget::PullLine(const int at[2])
{
  AxesShown* shown = this->GetAxisHandleRepresentation();
  shown->GetShift(at[0], at[1], this->Shift);
  this->PulledLine = true;
  std::vector<Operation> rows = operationsOf(this->Before);
  std::vector<double> places = handlePlaces(rows);
  if (places.empty())
  {
    places.push_back(this->T);
  }
  for (const double t : places)
  {
    double along[3];
    shown->GetAlongAxes(t, this->Shift, along);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (along[axis] != 0.0)
      {
        operate(rows, Verb::Move, t, axis, along[axis]);
      }
    }
  }
  shown->SetOperations(operationText(rows).c_str());
  this->Select(this->T);
}

void vtkOversketchAxisHandleWidget::PullAxis(const int at[2])
{
  AxesShown* shown = this->GetAxisHandleRepresentation();
  const int part = shown->GetPart(this->Grip), axis = shown->GetAxis(this->Grip);
  std::vector<Operation> rows = operationsOf(this->Before);
  const double amount = shown->GetAmount(part, axis, at[0], at[1]);
  if (std::isfinite(amount))
  {
    operate(rows, static_cast<Verb>(part), this->T, axis, amount);
  }
  shown->SetOperations(operationText(rows).c_str());
  for (const Operation& row : rows)
  {
    if (row.verb == static_cast<Verb>(part) && row.t == this->T && row.axis == axis)
    {
      shown->SetText(operationWords(row).c_str());
    }
  }
}

bool vtkOversketchAxisHandleWidget::LetGo(bool keep)
{
  AxesShown* shown = this->GetAxisHandleRepresentation();
  if (!keep)
  {
    const double selected = shown->GetHandleT(shown->GetSelectedHandle());
    shown->SetOperations(this->Before.c_str());
    shown->SetText("");
    this->Select(selected);
  }
  else if (!this->Moved && shown->GetPart(this->Grip) != AxesShown::Knob &&
           shown->IsOnLine(this->From[0], this->From[1])) // an axis may lie along the line
  {
    this->AddHandle(shown->GetT(this->From[0], this->From[1]));
  }
  shown->SetActiveGrip(0);
  this->PulledLine = false;
  return shown->GetOperations() != this->Before;
}

bool vtkOversketchAxisHandleWidget::UseKey(const std::string& key)
{
  AxesShown* shown = this->GetAxisHandleRepresentation();
  if (shown->GetSelectedHandle() < 0)
  {
    return false;
  }
  if (key == "Delete" || key == "BackSpace" || key == "KP_Delete")
  {
    this->RemoveSelectedHandle();
    this->ValueChanged();
    return true;
  }
  if (key == "Escape")
  {
    shown->SetSelectedHandle(-1);
    shown->SetText("");
    this->Render();
    return true;
  }
  return false;
}

void vtkOversketchAxisHandleWidget::SetRepresentation(vtkOversketchAxisHandleRepresentation* representation)
{
  this->StopDragging(false);
  this->SetWidgetRepresentation(representation);
}

void vtkOversketchAxisHandleWidget::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Operations: " << this->GetOperations() << "\n";
  os << indent << "Shift: " << this->Shift[0] << " " << this->Shift[1] << " " << this->Shift[2] << "\n";
}
