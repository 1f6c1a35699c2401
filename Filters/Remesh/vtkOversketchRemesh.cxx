#include "vtkOversketchRemesh.h"

#include "Remesh/remesh.h"
#include "Remesh/sizing.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

using namespace oversketch;

struct vtkOversketchRemesh::Cache
{
  struct Carried // an array of the input and what became of it
  {
    vtkAbstractArray* Source;
    vtkMTimeType Time;
    bool Points, Normals;
    vtkSmartPointer<vtkAbstractArray> Result;
  };
  MeshKey Key;
  std::vector<double> Values; // everything else that was read
  RemeshResult Result;
  std::vector<Triangle> InputTriangles;
  vtkSmartPointer<vtkPoints> Points;
  vtkSmartPointer<vtkCellArray> Polys;
  vtkSmartPointer<vtkIdTypeArray> SourceCell;
  vtkSmartPointer<vtkDoubleArray> SourceWeights;
  vtkSmartPointer<vtkDoubleArray> GuideLength;
  std::vector<Carried> Arrays;
};

namespace
{

double FieldValue(vtkDataObject* object,
  const char* name,
  const std::string& holder,
  const std::string& remedy)
{
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfTuples() != 1 || array->GetNumberOfComponents() != 1 ||
      !std::isfinite(array->GetComponent(0, 0)) || !(array->GetComponent(0, 0) > 0.0))
  {
    std::ostringstream message;
    message << "Field array " << name << " of the " << holder << " must hold one positive value: " << remedy
            << ".";
    throw Error(Failure::MissingArray, message.str());
  }
  return array->GetComponent(0, 0);
}

bool IsReal(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
}

vtkSmartPointer<vtkAbstractArray> LikeArray(vtkAbstractArray* array, std::size_t tuples)
{
  auto result = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  result->SetName(array->GetName());
  result->SetNumberOfComponents(array->GetNumberOfComponents());
  result->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  result->CopyComponentNames(array);
  return result;
}

vtkSmartPointer<vtkAbstractArray> CarryPointArray(vtkAbstractArray* array,
  bool normals,
  const RemeshResult& result,
  const std::vector<Triangle>& triangles)
{
  auto carried = LikeArray(array, result.pointSource.size());
  const bool linear = IsReal(array) && !(array->GetName() && std::strcmp(array->GetName(), "Region") == 0);
  vtkNew<vtkIdList> corners;
  corners->SetNumberOfIds(3);
  for (std::size_t i = 0; i < result.pointSource.size(); ++i)
  {
    const auto target = static_cast<vtkIdType>(i);
    if (result.pointSource[i] >= 0)
    {
      carried->SetTuple(target, result.pointSource[i], array);
      continue;
    }
    std::array<double, 3> weights = result.places[i].weights;
    const Triangle& t = triangles[result.places[i].triangle];
    if (linear)
    {
      for (int k = 0; k < 3; ++k)
      {
        corners->SetId(k, t[k]);
      }
      carried->InterpolateTuple(target, corners, array, weights.data());
    }
    else
    {
      carried->SetTuple(target, t[std::max_element(weights.begin(), weights.end()) - weights.begin()], array);
    }
    auto* values = normals ? vtkDataArray::SafeDownCast(carried) : nullptr;
    if (values && values->GetNumberOfComponents() == 3)
    {
      Vector3 n;
      values->GetTuple(target, n.data());
      if (n.norm() > 0.0)
      {
        n.normalize();
        values->SetTuple(target, n.data());
      }
    }
  }
  return carried;
}

vtkSmartPointer<vtkAbstractArray> CarryCellArray(vtkAbstractArray* array, const RemeshResult& result)
{
  auto carried = LikeArray(array, result.triangleSource.size());
  for (std::size_t i = 0; i < result.triangleSource.size(); ++i)
  {
    carried->SetTuple(static_cast<vtkIdType>(i), result.triangleSource[i], array);
  }
  return carried;
}

} // namespace

vtkStandardNewMacro(vtkOversketchRemesh);

vtkOversketchRemesh::vtkOversketchRemesh()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

vtkOversketchRemesh::~vtkOversketchRemesh() = default;

void vtkOversketchRemesh::SetHandlesData(vtkPolyData* handles)
{
  this->SetInputData(1, handles);
}

int vtkOversketchRemesh::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkOversketchRemesh::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* handles = vtkPolyData::GetData(inputs[1]);
      vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
      vtkPolyData* boundHandles = vtkPolyData::GetData(outputs, 1);
      const vtkIdType pointCount = input->GetNumberOfPoints();
      if (pointCount == 0)
      {
        return;
      }
      Cache& cache = *this->Internals;

      // What is read.
      RequirePolygonsOnly(input);
      vtkDataArray* region = RequireArray(input->GetPointData(),
        "Region",
        1,
        pointCount,
        "mesh",
        "run vtkOversketchMixtureRegion first, or make it");
      vtkDataArray* diameters = nullptr;
      if (this->LimitByDiameter)
      {
        diameters = RequireArray(input->GetPointData(),
          "ShapeDiameter",
          1,
          pointCount,
          "mesh",
          "run vtkOversketchShapeDiameter first, or turn LimitByDiameter off");
      }
      vtkDataArray* charts = input->GetCellData()->GetArray("Chart");
      if (charts)
      {
        RequireArray(input->GetCellData(),
          "Chart",
          1,
          input->GetNumberOfCells(),
          "mesh",
          "one chart number per triangle");
      }
      const Mesh mesh = MeshOf(input);
      std::vector<Binding> bindings;
      double factor = 1.0;
      if (handles)
      {
        bindings =
          ReadBindings(handles, mesh.vertexCount(), "handles", "take them from vtkOversketchTargets");
      }
      if (!bindings.empty() && this->Stage == STRETCH)
      {
        const std::string remedy = "take the handles from vtkOversketchTargets";
        factor = FieldValue(handles, "SectionLength", "handles", remedy) /
                 FieldValue(handles, "TargetLength", "handles", remedy);
        factor = std::min(1.0, std::max(this->MinimumFactor, factor));
      }
      double guide = 0.0;
      if (this->Stage == RESTORE && input->GetFieldData()->GetAbstractArray("GuideLength"))
      {
        guide = FieldValue(input, "GuideLength", "mesh", "let stage Stretch make it, or remove it");
      }

      const MeshKey key(input, { region, diameters, charts });
      std::vector<double> values{ static_cast<double>(this->Stage),
        static_cast<double>(this->Iterations),
        factor,
        guide,
        this->ProtectSection ? 1.0 : 0.0,
        this->MinimumFactor };
      for (const Binding& binding : bindings)
      {
        values.insert(values.end(), binding.vertices.begin(), binding.vertices.end());
        values.insert(values.end(), binding.weights.begin(), binding.weights.end());
      }
      if (cache.Key != key || cache.Values != values)
      {
        cache = Cache();
        const std::vector<char> mask = LabelsOf(region);
        std::vector<double> diameter;
        for (vtkIdType i = 0; diameters && i < pointCount; ++i)
        {
          diameter.push_back(diameters->GetComponent(i, 0));
        }
        std::vector<int> chart;
        for (vtkIdType i = 0; charts && i < input->GetNumberOfCells(); ++i)
        {
          chart.push_back(static_cast<int>(charts->GetComponent(i, 0)));
        }
        const std::vector<char> active = regionTriangles(mesh, mask);
        if (guide == 0.0)
        {
          guide = guideLength(mesh, active);
        }
        Sizing sizing;
        sizing.length = guide * factor;
        sizing.minimumFactor = this->MinimumFactor;
        const std::vector<double> targets = targetLengths(mesh, active, diameter, sizing);
        cache.Result = remesh(
          { mesh, mask, targets, chart, bindings, this->ProtectSection, this->Iterations }, ContextOf(this));
        ++this->RemeshCount;
        cache.InputTriangles = mesh.triangles;
        this->GuideLength = guide;
        this->Factor = factor;

        cache.Points = vtkSmartPointer<vtkPoints>::New();
        cache.Points->SetDataType(input->GetPoints()->GetDataType());
        cache.Points->SetNumberOfPoints(cache.Result.mesh.vertexCount());
        for (int v = 0; v < cache.Result.mesh.vertexCount(); ++v)
        {
          cache.Points->SetPoint(v, cache.Result.mesh.points[v].data());
        }
        const int cells = cache.Result.mesh.triangleCount();
        cache.Polys = vtkSmartPointer<vtkCellArray>::New();
        cache.Polys->AllocateExact(cells, 3 * static_cast<vtkIdType>(cells));
        cache.SourceCell = vtkSmartPointer<vtkIdTypeArray>::New();
        cache.SourceCell->SetName("SourceCell");
        cache.SourceCell->SetNumberOfComponents(3);
        cache.SourceCell->SetNumberOfTuples(cells);
        cache.SourceWeights = vtkSmartPointer<vtkDoubleArray>::New();
        cache.SourceWeights->SetName("SourceWeights");
        cache.SourceWeights->SetNumberOfComponents(9);
        cache.SourceWeights->SetNumberOfTuples(cells);
        for (int t = 0; t < cells; ++t)
        {
          const Triangle& corners = cache.Result.mesh.triangles[t];
          const vtkIdType ids[3] = { corners[0], corners[1], corners[2] };
          cache.Polys->InsertNextCell(3, ids);
          for (int k = 0; k < 3; ++k)
          {
            const SurfacePoint& at = cache.Result.corners[t][k];
            cache.SourceCell->SetTypedComponent(t, k, at.triangle);
            for (int i = 0; i < 3; ++i)
            {
              cache.SourceWeights->SetTypedComponent(t, 3 * k + i, at.weights[i]);
            }
          }
        }
        if (this->Stage == STRETCH && guide > 0.0)
        {
          cache.GuideLength = vtkSmartPointer<vtkDoubleArray>::New();
          cache.GuideLength->SetName("GuideLength");
          cache.GuideLength->InsertNextValue(guide);
        }
        // Kept as arrays now.
        cache.Result.mesh = Mesh();
        cache.Result.corners.clear();
        cache.Values = values;
        cache.Key = key;
      }

      // Arrays of the input, each carried over once for as long as it stands.
      std::vector<Cache::Carried> carried;
      const auto carry = [&](vtkDataSetAttributes* from, vtkDataSetAttributes* to, bool points)
      {
        for (int i = 0; i < from->GetNumberOfArrays(); ++i)
        {
          vtkAbstractArray* array = from->GetAbstractArray(i);
          const int attribute = from->IsArrayAnAttribute(i);
          const std::string name = array->GetName() ? array->GetName() : "";
          if (attribute == vtkDataSetAttributes::GLOBALIDS ||
              (!points && (name == "SourceCell" || name == "SourceWeights")))
          {
            continue;
          }
          Cache::Carried item{
            array, array->GetMTime(), points, attribute == vtkDataSetAttributes::NORMALS, nullptr
          };
          for (const Cache::Carried& known : cache.Arrays)
          {
            if (known.Source == item.Source && known.Time == item.Time && known.Points == points &&
                known.Normals == item.Normals)
            {
              item.Result = known.Result;
            }
          }
          if (!item.Result)
          {
            item.Result = points ? CarryPointArray(array, item.Normals, cache.Result, cache.InputTriangles)
                                 : CarryCellArray(array, cache.Result);
          }
          carried.push_back(item);
          const int index = to->AddArray(item.Result);
          if (attribute >= 0)
          {
            to->SetActiveAttribute(index, attribute);
          }
        }
      };
      output->SetPoints(cache.Points);
      output->SetPolys(cache.Polys);
      carry(input->GetPointData(), output->GetPointData(), true);
      carry(input->GetCellData(), output->GetCellData(), false);
      cache.Arrays = carried;
      output->GetCellData()->AddArray(cache.SourceCell);
      output->GetCellData()->AddArray(cache.SourceWeights);
      output->GetFieldData()->PassData(input->GetFieldData());
      if (cache.GuideLength)
      {
        output->GetFieldData()->AddArray(cache.GuideLength);
      }

      if (handles)
      {
        boundHandles->ShallowCopy(handles);
        vtkNew<vtkPoints> points;
        points->SetDataTypeToDouble();
        for (const Binding& binding : cache.Result.handles)
        {
          Vector3 position = Vector3::Zero();
          for (int k = 0; k < 3; ++k)
          {
            Vector3 p;
            cache.Points->GetPoint(binding.vertices[k], p.data());
            position += binding.weights[k] * p;
          }
          points->InsertNextPoint(position.data());
        }
        boundHandles->SetPoints(points);
        WriteBindings(cache.Result.handles, boundHandles);
      }
    });
}

void vtkOversketchRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Stage: " << (this->Stage == STRETCH ? "Stretch" : "Restore") << "\n";
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "LimitByDiameter: " << (this->LimitByDiameter ? "On" : "Off") << "\n";
  os << indent << "ProtectSection: " << (this->ProtectSection ? "On" : "Off") << "\n";
  os << indent << "MinimumFactor: " << this->MinimumFactor << "\n";
  os << indent << "GuideLength: " << this->GuideLength << "\n";
  os << indent << "Factor: " << this->Factor << "\n";
  os << indent << "RemeshCount: " << this->RemeshCount << "\n";
}
