#include "vtkOversketchPushBetween.h"

#include "vtkOversketchPush.h"
#include "vtkOversketchStrokeFilter.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkOversketchPushBetween);

struct vtkOversketchPushBetween::Steps
{
  vtkNew<vtkOversketchStrokeFilter> First, Second;
  vtkNew<vtkOversketchPush> Push;
};

vtkOversketchPushBetween::vtkOversketchPushBetween()
  : Inner(new Steps)
{
  this->SetNumberOfInputPorts(4);
  this->Inner->Push->SetInputConnection(1, this->Inner->First->GetOutputPort());
  this->Inner->Push->SetInputConnection(2, this->Inner->Second->GetOutputPort());
  this->AddStage("FirstStroke", this->Inner->First, 0.1);
  this->AddStage("SecondStroke", this->Inner->Second, 0.1);
  this->AddStage("Push", this->Inner->Push, 0.8);
}

vtkOversketchPushBetween::~vtkOversketchPushBetween() = default;

void vtkOversketchPushBetween::SetSense(int sense)
{
  this->Inner->Push->SetSense(sense);
}

int vtkOversketchPushBetween::GetSense() const
{
  return this->Inner->Push->GetSense();
}

void vtkOversketchPushBetween::SetLength(double length)
{
  this->Inner->Push->SetLength(length);
}

double vtkOversketchPushBetween::GetLength() const
{
  return this->Inner->Push->GetLength();
}

int vtkOversketchPushBetween::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 3 ? "vtkImageData" : "vtkPolyData");
  return 1;
}

int vtkOversketchPushBetween::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return this->RunSystem(
    [&]
    {
      if (vtkPolyData::GetData(inputs[0])->GetNumberOfPoints() == 0)
      {
        return;
      }
      Steps& steps = *this->Inner;
      steps.First->SetInputData(vtkPolyData::GetData(inputs[1]));
      steps.Second->SetInputData(vtkPolyData::GetData(inputs[2]));
      steps.Push->SetInputData(0, vtkPolyData::GetData(inputs[0]));
      steps.Push->SetInputDataObject(3, vtkDataObject::GetData(inputs[3]));
      for (const char* name : { "FirstStroke", "SecondStroke", "Push" })
      {
        this->RunStage(name);
      }
      vtkPolyData::GetData(outputs)->ShallowCopy(steps.Push->GetOutput());
    });
}

void vtkOversketchPushBetween::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sense: " << this->GetSense() << "\n";
  os << indent << "Length: " << this->GetLength() << "\n";
}
