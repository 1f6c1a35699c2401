// The data that the widget of the edit is given, and what it has made of it.
#include "document.h"
#include "drawing_lines.h"
#include "edit_hand.h"
#include "edit_step.h"

#include "vtkOversketchAreaSelectWidget.h"
#include "vtkOversketchEdit.h"
#include "vtkOversketchEditWidget.h"
#include "vtkOversketchLayerHandleRepresentation.h"
#include "vtkOversketchLayerHandleWidget.h"
#include "vtkOversketchProfilePlaneWidget.h"
#include "vtkOversketchRegionWidget.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

void EditHand::load(const Work& work, bool again)
{
  const bool isSameMesh = isSameData(work.mesh, this->Loaded.mesh);
  const auto isSameLines = [&](const char* name)
  {
    const auto& known = this->Loaded.given;
    const auto one = work.given.find(name), other = known.find(name);
    const bool has = one != work.given.end();
    return isSameInput(work.step, this->Loaded.step, name) && has == (other != known.end()) &&
           (!has || isSameData(one->second, other->second));
  };
  const bool isSameStep = work.step.values == this->Loaded.step.values &&
                          std::all_of(editRow().inputs.begin(),
                            editRow().inputs.end(),
                            [&](const auto& one) { return isSameLines(one.name.c_str()); });
  if (isSameMesh && isSameStep && !again)
  {
    this->Loaded.isInHistory = work.isInHistory;
    this->Loaded.id = work.id;
    this->Loaded.mesh = work.mesh;
    this->Loaded.step.mirror = work.step.mirror;
    return;
  }
  this->stopFollowing();
  this->Loading = true;
  if (!isSameMesh || work.step.inputs.count(ringInput) == 0) // else the last region would stay
  {
    this->Widget->SetInputData(work.mesh ? work.mesh.own() : vtkSmartPointer<vtkPolyData>::New());
    this->Widget->Update();
  }
  this->Loaded = work;
  this->loadCurves(work);
  this->loadValues(work.step);
  this->Widget->GetEdit()->Modified();
  this->Widget->Update();
  this->Loading = false;
  this->Message.clear();
  if (work.isInHistory && !this->hasRegion())
  {
    this->Message = wordsOfEdit(this->Widget->GetSaid(), true);
  }
}

void EditHand::loadCurves(const Work& work)
{
  const auto data = [&](const char* name)
  {
    const auto given = work.given.find(name);
    if (given != work.given.end())
    {
      return given->second.own();
    }
    const auto lines = linesOf(work.step, name);
    return lines ? strokesThatAreOn(lines) : nullptr;
  };
  vtkOversketchRegionWidget* region = this->Widget->GetRegionWidget();
  region->SetRegion(data(lineInput), data(ringInput));
  const auto areas = data(areasInput);
  this->Widget->GetAreaSelectWidget()->SetAreas(areas);
  this->Widget->GetLayerHandleWidget()->GetLayerHandleRepresentation()->SetArea(
    areas ? static_cast<int>(areas->GetNumberOfLines()) - 1 : -1);
  this->Widget->GetProfilePlaneWidget()->SetProfile(data(profileInput));
  vtkOversketchEdit* edit = this->Widget->GetEdit();
  edit->SetInputDataObject(6, data(handlesInput));
  const bool isPainted = weightsOf(work.step) && this->Weights;
  edit->SetInputDataObject(5, isPainted ? this->Weights->pixels.Get() : nullptr);
  this->Weights = isPainted ? this->Weights : nullptr;
  this->Seen = { { lineInput, region->GetReference()->GetMTime() },
    { ringInput, region->GetBoundary()->GetMTime() },
    { areasInput, this->Widget->GetAreaSelectWidget()->GetAreas()->GetMTime() },
    { profileInput, this->Widget->GetProfilePlaneWidget()->GetProfile()->GetMTime() } };
}

void EditHand::loadValues(const Step& step)
{
  for (const Parameter& one : editRow().parameters)
  {
    if (one.property != ruleValue)
    {
      one.set(this->Widget->GetEdit(), valueOf(step, one));
    }
  }
}

Step EditHand::made()
{
  Step step = this->Loaded.step;
  const std::map<std::string, vtkPolyData*> strokes{ { lineInput,
                                                       this->Widget->GetRegionWidget()->GetReference() },
    { ringInput, this->Widget->GetRegionWidget()->GetBoundary() },
    { areasInput, this->Widget->GetAreaSelectWidget()->GetAreas() },
    { profileInput, this->Widget->GetProfilePlaneWidget()->GetProfile() } };
  for (const auto& [name, data] : strokes)
  {
    if (std::exchange(this->Seen[name], data->GetMTime()) == data->GetMTime())
    {
      continue;
    }
    step.inputs.erase(name);
    if (data->GetNumberOfPoints() > 0)
    {
      step.inputs[name] = Lines(data);
    }
  }
  for (const char* property : { operationsValue, layersValue, placeValue, levelsValue })
  {
    const Parameter& parameter = *findParameter(editRow(), property);
    const Value now = parameter.get(this->Widget->GetEdit());
    if (now != valueOf(step, parameter))
    {
      step.values[property] = now;
    }
  }
  return step;
}

} // namespace oversketch_studio
