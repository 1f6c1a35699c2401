#include "vtkOversketchAssemble.h"

#include "Inflate/placement.h"
#include "vtkOversketchFilterTools.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchAssemble);

namespace
{

Placement placementOf(vtkPolyData* part)
{
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  if (vtkDataArray* array = part->GetFieldData()->GetArray("Placement"))
  {
    const int components = array->GetNumberOfComponents();
    if (components * array->GetNumberOfTuples() != 16)
    {
      throw Error(Failure::BadMesh, "Field array Placement must hold 16 numbers, a matrix row by row.");
    }
    for (int i = 0; i < 16; ++i)
    {
      matrix(i / 4, i % 4) = array->GetComponent(i / components, i % components);
    }
  }
  return Placement(matrix);
}

vtkSmartPointer<vtkPolyData> placed(vtkPolyData* part, int number)
{
  RequirePolygonsOnly(part);
  const Placement placement = placementOf(part);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(part);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(part->GetNumberOfPoints());
  for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
  {
    const Vector3 place = placement(Vector3(part->GetPoint(i)));
    if (!place.allFinite())
    {
      throw Error(Failure::BadMesh, "Point " + std::to_string(i) + " is not finite; repair or remove it.");
    }
    points->SetPoint(i, place.data());
  }
  result->SetPoints(points);
  if (placement.mirrors())
  {
    vtkNew<vtkCellArray> polys;
    vtkNew<vtkIdList> corners;
    for (vtkIdType f = 0; f < part->GetNumberOfPolys(); ++f)
    {
      part->GetPolys()->GetCellAtId(f, corners);
      const vtkIdType count = corners->GetNumberOfIds();
      polys->InsertNextCell(static_cast<int>(count));
      for (vtkIdType k = 0; k < count; ++k)
      {
        polys->InsertCellPoint(corners->GetId((count - k) % count)); // the first one stays
      }
    }
    result->SetPolys(polys);
  }
  result->GetPointData()->SetNormals(nullptr);
  result->GetCellData()->SetNormals(nullptr);
  vtkNew<vtkIntArray> parts;
  parts->SetName("PartId");
  parts->SetNumberOfTuples(part->GetNumberOfPolys());
  parts->FillValue(number);
  result->GetCellData()->AddArray(parts);
  return result;
}

// The field arrays of a part, under names of its own.
void addFields(vtkPolyData* part, int number, vtkFieldData* fields)
{
  for (int i = 0; i < part->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = part->GetFieldData()->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (name != "Placement")
    {
      const vtkSmartPointer<vtkAbstractArray> copy = vtk::TakeSmartPointer(array->NewInstance());
      copy->DeepCopy(array);
      copy->SetName(("Part" + std::to_string(number) + "." + name).c_str());
      fields->AddArray(copy);
    }
  }
}

} // namespace

int vtkOversketchAssemble::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return this->Superclass::FillInputPortInformation(port, information);
}

int vtkOversketchAssemble::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      const Context context = ContextOf(this);
      const int count = inputs[0]->GetNumberOfInformationObjects();
      vtkNew<vtkAppendPolyData> all;
      all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
      vtkNew<vtkFieldData> fields;
      for (int number = 0; number < count; ++number)
      {
        vtkPolyData* part = vtkPolyData::GetData(inputs[0], number);
        context.checkpoint(static_cast<double>(number) / count);
        if (part->GetNumberOfPoints() == 0)
        {
          continue;
        }
        try
        {
          all->AddInputData(placed(part, number));
        }
        catch (const Error& error)
        {
          throw Error(error.failure(), "Part " + std::to_string(number) + ": " + error.what());
        }
        addFields(part, number, fields);
      }
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      if (all->GetNumberOfInputConnections(0) > 0)
      {
        all->Update();
        output->ShallowCopy(all->GetOutput());
      }
      output->SetFieldData(fields);
    });
}

void vtkOversketchAssemble::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
