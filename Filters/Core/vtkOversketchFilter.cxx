#include "vtkOversketchFilter.h"

#include "vtkOversketchFilterTools.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

int vtkOversketchFilter::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return oversketch::RunFilter(this,
    [&]
    {
      if (vtkPolyData::GetData(inputs[0])->GetNumberOfPoints() > 0)
      {
        this->Execute(inputs, outputs);
        return;
      }
      for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
      {
        if (vtkImageData* image = vtkImageData::GetData(outputs, port)) // the pipeline leaves it its size
        {
          image->Initialize();
        }
      }
    });
}
