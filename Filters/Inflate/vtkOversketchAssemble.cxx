#include "vtkOversketchAssemble.h"

#include "Inflate/placement.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchFilterTools.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
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

#include <regex>
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

// As vtkAppendPolyData joins them: of one name and type.
void setCoordinates(vtkPolyData* part)
{
  vtkDataArray* own = part->GetPointData()->GetTCoords();
  const auto coordinates = NewArray<vtkDoubleArray>("TCoords", 2, part->GetNumberOfPoints());
  for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 2; ++c)
    {
      coordinates->SetComponent(
        i, c, own && c < own->GetNumberOfComponents() ? own->GetComponent(i, c) : 0.0);
    }
  }
  if (own && own->GetName())
  {
    part->GetPointData()->RemoveArray(own->GetName());
  }
  part->GetPointData()->SetTCoords(coordinates);
}

vtkSmartPointer<vtkPolyData> placed(vtkPolyData* part, int number, bool withCoordinates)
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
      throw Error(Failure::BadMesh, "Point %1 is not finite; repair or remove it.", i);
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
  if (withCoordinates)
  {
    setCoordinates(result);
  }
  vtkDataArray* own = part->GetCellData()->GetArray("PartId");
  const auto parts = NewArray<vtkIntArray>("PartId", 1, part->GetNumberOfPolys());
  for (vtkIdType f = 0; f < part->GetNumberOfPolys(); ++f)
  {
    parts->SetValue(f, number + (own ? static_cast<int>(own->GetComponent(f, 0)) : 0));
  }
  result->GetCellData()->AddArray(parts);
  return result;
}

// "Part2.Canvas" of "Canvas" for part 2, "Part5.Canvas" of "Part3.Canvas".
std::string numbered(const std::string& name, int number)
{
  static const std::regex ofPart("Part(\\d{1,6})\\.(.*)");
  std::smatch match;
  const bool isOfPart = std::regex_match(name, match, ofPart);
  return "Part" + std::to_string(number + (isOfPart ? std::stoi(match[1]) : 0)) + "." +
         (isOfPart ? match[2].str() : name);
}

// The field arrays of a part, under names of its own.
void addFields(vtkPolyData* part, int number, vtkFieldData* fields)
{
  for (int i = 0; i < part->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = part->GetFieldData()->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (vtkDataArray* joined = name == "Joined" ? part->GetFieldData()->GetArray(i) : nullptr)
    {
      const auto all = fields->GetArray("Joined")
                         ? vtkSmartPointer<vtkIntArray>(vtkIntArray::SafeDownCast(fields->GetArray("Joined")))
                         : NewArray<vtkIntArray>("Joined", 1, 0);
      for (vtkIdType k = 0; k < joined->GetNumberOfTuples(); ++k)
      {
        all->InsertNextValue(number + static_cast<int>(joined->GetComponent(k, 0)));
      }
      fields->AddArray(all);
    }
    else if (name != "Placement")
    {
      const vtkSmartPointer<vtkAbstractArray> copy = vtk::TakeSmartPointer(array->NewInstance());
      copy->DeepCopy(array);
      copy->SetName(numbered(name, number).c_str());
      fields->AddArray(copy);
    }
  }
}

} // namespace

vtkOversketchAssemble::vtkOversketchAssemble()
{
  DeclareInput(this, 0, { Port::Repeatable });
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
      bool withCoordinates = false;
      for (int i = 0; i < count; ++i)
      {
        withCoordinates =
          withCoordinates || vtkPolyData::GetData(inputs[0], i)->GetPointData()->GetTCoords() != nullptr;
      }
      int number = 0; // of the first part of a connection
      for (int i = 0; i < count; ++i)
      {
        vtkPolyData* part = vtkPolyData::GetData(inputs[0], i);
        context.checkpoint(static_cast<double>(i) / count);
        if (part->GetNumberOfPoints() == 0)
        {
          ++number;
          continue;
        }
        try
        {
          const int parts = HighestPart(PartNumbers(part)) + 1; // it may have been assembled itself
          all->AddInputData(placed(part, number, withCoordinates));
          addFields(part, number, fields);
          number += parts;
        }
        catch (const Error& error)
        {
          throw Error(error.failure(), "Part %1: %2", i, error.message());
        }
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
