#include "vtkOversketchRemesh.h"

#include "Remesh/remesh.h"
#include "Remesh/sizing.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <memory>

using namespace oversketch;

// The last result, and what it was made from.
struct vtkOversketchRemesh::Cache
{
  // Input of a run.
  struct Question
  {
    vtkDataArray* Region = nullptr;
    vtkDataArray* Diameters = nullptr; // null: they limit nothing
    vtkDataArray* Lengths = nullptr;   // of stage Restore, null: those that fit the mesh
    vtkDataArray* Charts = nullptr;    // null: one
    std::vector<Binding> Handles;
    double Factor = 1.0; // k
    double Guide = 0.0;  // L, 0: the region's own mean
    StepKey Key;
  };

  static Question Read(vtkOversketchRemesh* self, vtkPolyData* input, vtkPolyData* handles);
  void Remesh(vtkOversketchRemesh* self, vtkPolyData* input, const Question& question);
  void KeepMesh(vtkPolyData* input, bool sourcesOfAll);
  void Write(vtkPolyData* input, vtkPolyData* output);
  void WriteHandles(vtkPolyData* handles, vtkPolyData* output) const;

  StepKey Key;
  RemeshResult Result;               // without what is kept as arrays
  vtkSmartPointer<vtkPoints> Points; // null: nothing is kept
  vtkSmartPointer<vtkCellArray> Polys;
  vtkSmartPointer<vtkIdTypeArray> SourceCell;
  vtkSmartPointer<vtkDoubleArray> SourceWeights;
  vtkSmartPointer<vtkIntArray> UnchangedCell; // null where there are sources of all
  vtkSmartPointer<vtkDoubleArray> GuideLength;
  vtkSmartPointer<vtkAbstractArray> EdgeLength; // null but for stage Stretch
  KeptArrays Arrays;
};

namespace
{

const char* const handlesRemedy = "take them from vtkOversketchTargets";

// A point is a mix of the corners of the triangle that it lies in.
CarriedPoints PointsOf(const RemeshResult& result, vtkCellArray* triangles)
{
  const auto corners = [&result, triangles, ids = vtkSmartPointer<vtkIdList>::New(), mix = Mix(3)](
                         vtkIdType point) mutable -> const Mix&
  {
    const SurfacePoint place = result.place(static_cast<int>(point));
    triangles->GetCellAtId(place.triangle, ids);
    for (int k = 0; k < 3; ++k)
    {
      mix[k] = { static_cast<int>(ids->GetId(k)), place.weights[k] };
    }
    return mix;
  };
  return { result.pointSource, corners, "Region" };
}

} // namespace

vtkOversketchRemesh::Cache::Question vtkOversketchRemesh::Cache::Read(vtkOversketchRemesh* self,
  vtkPolyData* input,
  vtkPolyData* handles)
{
  RequirePolygonsOnly(input); // the key does not see other cells
  const vtkIdType count = input->GetNumberOfPoints();
  Question question;
  question.Region = RequireArray(
    input->GetPointData(), "Region", 1, count, "mesh", "run vtkOversketchMixtureRegion first, or make it");
  if (self->LimitByDiameter)
  {
    question.Diameters = RequireArray(input->GetPointData(),
      "ShapeDiameter",
      1,
      count,
      "mesh",
      "run vtkOversketchShapeDiameter first, or {LimitByDiameter off}");
  }
  if (input->GetCellData()->GetArray("Chart"))
  {
    question.Charts = RequireArray(
      input->GetCellData(), "Chart", 1, input->GetNumberOfCells(), "mesh", "one chart number per triangle");
  }
  if (handles)
  {
    question.Handles = ReadBindings(handles, static_cast<int>(count), "handles", handlesRemedy);
  }
  if (!question.Handles.empty() && self->Stage == Stretch)
  {
    const double factor = FieldValue(handles, "SectionLength", "handles", handlesRemedy) /
                          FieldValue(handles, "TargetLength", "handles", handlesRemedy);
    question.Factor = std::min(1.0, std::max(Sizing().minimumFactor, factor));
  }
  if (self->Stage == Restore && self->KeepSmooth && input->GetPointData()->GetAbstractArray("EdgeLength"))
  {
    question.Lengths = RequireArray(
      input->GetPointData(), "EdgeLength", 1, count, "mesh", "let stage Stretch make it, or remove it");
  }
  if (self->Stage == Restore && input->GetFieldData()->GetAbstractArray("GuideLength"))
  {
    question.Guide = FieldValue(input, "GuideLength", "mesh", "let stage Stretch make it, or remove it");
  }

  std::vector<double> values{ static_cast<double>(self->Stage),
    static_cast<double>(self->Iterations),
    question.Factor,
    question.Guide,
    self->ProtectSection ? 1.0 : 0.0,
    self->KeepSmooth ? 1.0 : 0.0,
    self->TakeOutFolds ? 1.0 : 0.0,
    self->SourcesOfAll ? 1.0 : 0.0 };
  for (const Binding& binding : question.Handles)
  {
    values.insert(values.end(), binding.vertices.begin(), binding.vertices.end());
    values.insert(values.end(), binding.weights.begin(), binding.weights.end());
  }
  question.Key = StepKey(
    { MeshKey(input, { question.Region, question.Diameters, question.Charts, question.Lengths }) }, values);
  return question;
}

void vtkOversketchRemesh::Cache::Remesh(vtkOversketchRemesh* self,
  vtkPolyData* input,
  const Question& question)
{
  *this = Cache();
  const std::shared_ptr<const MeshData> data = SharedMesh(input);
  const Mesh& mesh = data->Surface();
  const std::vector<char> mask = LabelsOf(question.Region);
  const auto valuesOf = [input](vtkDataArray* array)
  {
    std::vector<double> values(array ? static_cast<std::size_t>(input->GetNumberOfPoints()) : 0);
    vtkSMPTools::For(0,
      static_cast<vtkIdType>(values.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          values[i] = array->GetComponent(i, 0);
        }
      });
    return values;
  };
  std::vector<int> chart;
  for (vtkIdType i = 0; question.Charts && i < input->GetNumberOfCells(); ++i)
  {
    chart.push_back(static_cast<int>(question.Charts->GetComponent(i, 0)));
  }
  const std::vector<char> active = regionTriangles(mesh, mask);
  const double guide = question.Guide == 0.0 ? guideLength(mesh, active) : question.Guide;
  Sizing sizing;
  sizing.length = guide * question.Factor;
  // Lengths are of the mesh before it is stretched, like L.
  const std::vector<double> own =
    self->KeepSmooth && !question.Lengths ? fittingLengths(mesh, active) : valuesOf(question.Lengths);
  std::vector<double> fitting = own;
  for (double& length : fitting)
  {
    length *= question.Factor;
  }
  std::vector<double> targets = targetLengths(mesh, active, valuesOf(question.Diameters), fitting, sizing);
  const TriangleLimit limit = limitTriangles(mesh, active, targets);
  self->TrianglesWanted = std::min(limit.wanted, 1e15);
  this->Result = remesh({ mesh,
                          mask,
                          targets,
                          chart,
                          question.Handles,
                          self->ProtectSection,
                          self->Iterations,
                          self->KeepSmooth,
                          self->TakeOutFolds,
                          limit.most },
    ContextOf(self));
  ++self->RemeshCount;
  self->GuideLength = guide;
  self->Factor = question.Factor;
  this->KeepMesh(input, self->SourcesOfAll);
  if (self->Stage == Stretch && guide > 0.0)
  {
    this->GuideLength = OneValue<vtkDoubleArray>("GuideLength", guide);
  }
  if (self->Stage == Stretch && self->KeepSmooth)
  {
    const auto lengths = ArrayOf<vtkDoubleArray>("EdgeLength", own);
    this->EdgeLength = PointsOf(this->Result, input->GetPolys()).Array(lengths, false);
  }
  this->Key = question.Key;
}

// The result's mesh and what its corners were made from, as arrays.
void vtkOversketchRemesh::Cache::KeepMesh(vtkPolyData* input, bool sourcesOfAll)
{
  const Mesh& mesh = this->Result.mesh;
  this->Points = vtkSmartPointer<vtkPoints>::New();
  this->Points->SetDataType(input->GetPoints()->GetDataType());
  this->Points->SetNumberOfPoints(mesh.vertexCount());
  const int cells = mesh.triangleCount();
  const vtkIdType withoutSources = sourcesOfAll ? 0 : this->Result.outsideTriangles;
  this->SourceCell = NewArray<vtkIdTypeArray>("SourceCell", 3, cells - withoutSources);
  this->SourceWeights = NewArray<vtkDoubleArray>("SourceWeights", 9, cells - withoutSources);
  if (!sourcesOfAll)
  {
    this->UnchangedCell = NewArray<vtkIntArray>("UnchangedCell", 1, withoutSources);
    std::copy_n(this->Result.triangleSource.begin(), withoutSources, this->UnchangedCell->GetPointer(0));
  }
  auto connectivity = NewArray<vtkIdTypeArray>(nullptr, 1, 3 * static_cast<vtkIdType>(cells));
  auto offsets = NewArray<vtkIdTypeArray>(nullptr, 1, static_cast<vtkIdType>(cells) + 1);
  vtkSMPTools::For(0,
    mesh.vertexCount(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType v = begin; v < end; ++v)
      {
        this->Points->SetPoint(v, mesh.points[v].data());
      }
    });
  vtkSMPTools::For(0,
    cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      const vtkIdType first = std::max(begin, withoutSources) - withoutSources; // that has sources
      vtkIdType* id = connectivity->GetPointer(3 * begin);
      vtkIdType* source = this->SourceCell->GetPointer(3 * first);
      double* weight = this->SourceWeights->GetPointer(9 * first);
      for (vtkIdType t = begin; t < end; ++t)
      {
        offsets->SetValue(t, 3 * t);
        id = std::copy(mesh.triangles[t].begin(), mesh.triangles[t].end(), id);
        if (t < withoutSources)
        {
          continue;
        }
        for (const SurfacePoint& at : this->Result.corners(static_cast<int>(t)))
        {
          *source++ = at.triangle;
          weight = std::copy(at.weights.begin(), at.weights.end(), weight);
        }
      }
    });
  offsets->SetValue(cells, 3 * static_cast<vtkIdType>(cells));
  this->Polys = vtkSmartPointer<vtkCellArray>::New();
  this->Polys->SetData(offsets, connectivity);
  this->Result.mesh = Mesh();
  this->Result.insideCorners = {};
}

void vtkOversketchRemesh::Cache::Write(vtkPolyData* input, vtkPolyData* output)
{
  output->SetPoints(this->Points);
  output->SetPolys(this->Polys);
  const CarriedPoints points = PointsOf(this->Result, input->GetPolys());
  CarryArrays(input->GetPointData(),
    output->GetPointData(),
    [&](vtkAbstractArray* array, bool normals)
    { return this->Arrays.Provide(array, normals ? 2 : 1, [&] { return points.Array(array, normals); }); });
  CarryArrays(input->GetCellData(),
    output->GetCellData(),
    [&](vtkAbstractArray* array, bool)
    {
      return IsNamed(array, "SourceCell") || IsNamed(array, "SourceWeights")
               ? nullptr
               : this->Arrays.Provide(
                   array, 0, [&] { return CarriedArray(array, this->Result.triangleSource); });
    });
  this->Arrays.EndRun();
  vtkFieldData* fields = output->GetFieldData();
  fields->PassData(input->GetFieldData());
  for (const char* name : { "SourceCell", "SourceWeights", "UnchangedCell" }) // an earlier remeshing's
  {
    fields->RemoveArray(name);
  }
  vtkFieldData* sources = this->UnchangedCell ? fields : output->GetCellData();
  sources->AddArray(this->SourceCell);
  sources->AddArray(this->SourceWeights);
  if (this->UnchangedCell)
  {
    sources->AddArray(this->UnchangedCell);
  }
  DropHierarchy(output);
  if (this->GuideLength)
  {
    fields->AddArray(this->GuideLength);
  }
  if (this->EdgeLength)
  {
    output->GetPointData()->AddArray(this->EdgeLength);
  }
}

void vtkOversketchRemesh::Cache::WriteHandles(vtkPolyData* handles, vtkPolyData* output) const
{
  output->ShallowCopy(handles);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Binding& binding : this->Result.handles)
  {
    Vector3 position = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      Vector3 p;
      this->Points->GetPoint(binding.vertices[k], p.data());
      position += binding.weights[k] * p;
    }
    points->InsertNextPoint(position.data());
  }
  output->SetPoints(points);
  WriteBindings(this->Result.handles, output);
}

vtkStandardNewMacro(vtkOversketchRemesh);

vtkOversketchRemesh::vtkOversketchRemesh()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  DeclareInput(this, 1, { Port::Optional });
}

void vtkOversketchRemesh::ReleaseWork()
{
  this->Kept<Cache>() = Cache();
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    this->GetOutputDataObject(port)->ReleaseData();
  }
  this->Modified();
}

void vtkOversketchRemesh::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* handles = vtkPolyData::GetData(inputs[1]);
  Cache& cache = this->Kept<Cache>();
  const Cache::Question question = Cache::Read(this, input, handles);
  if (!cache.Points || cache.Key != question.Key)
  {
    cache.Remesh(this, input, question);
  }
  cache.Write(input, vtkPolyData::GetData(outputs, 0));
  if (handles)
  {
    cache.WriteHandles(handles, vtkPolyData::GetData(outputs, 1));
  }
}

void vtkOversketchRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Stage: " << (this->Stage == Stretch ? "Stretch" : "Restore") << "\n";
  os << indent << "Iterations: " << this->Iterations << "\n";
  os << indent << "LimitByDiameter: " << (this->LimitByDiameter ? "On" : "Off") << "\n";
  os << indent << "ProtectSection: " << (this->ProtectSection ? "On" : "Off") << "\n";
  os << indent << "KeepSmooth: " << (this->KeepSmooth ? "On" : "Off") << "\n";
  os << indent << "TakeOutFolds: " << (this->TakeOutFolds ? "On" : "Off") << "\n";
  os << indent << "SourcesOfAll: " << (this->SourcesOfAll ? "On" : "Off") << "\n";
  os << indent << "GuideLength: " << this->GuideLength << "\n";
  os << indent << "Factor: " << this->Factor << "\n";
  os << indent << "RemeshCount: " << this->RemeshCount << "\n";
}
