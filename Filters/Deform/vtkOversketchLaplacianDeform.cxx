#include "vtkOversketchLaplacianDeform.h"

#include "Mesh/part.h"
#include "Sparse/laplacian.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchMovedPoints.h"
#include "vtkOversketchRegister.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <string>

using namespace oversketch;

namespace
{

struct Handles
{
  std::vector<Binding> Bindings;
  std::vector<Vector3> Displacements;
  std::vector<double> Shares; // of a drag
};

Handles HandlesOf(vtkPolyData* polyData, int vertexCount)
{
  const std::string remedy = "take them from vtkOversketchTargets";
  const vtkIdType count = polyData->GetNumberOfPoints();
  if (count == 0)
  {
    throw Error(Failure::BadRegion, "There is no handle: the handles input holds no point.");
  }
  Handles handles{ ReadBindings(polyData, vertexCount, "handles", remedy), {}, {} };
  vtkDataArray* targets = RequireArray(polyData->GetPointData(), "Target", 3, count, "handles", remedy);
  vtkDataArray* ratios = OptionalArray(polyData->GetPointData(), "MergeRatio", 1, count, "handles", remedy);
  for (vtkIdType h = 0; h < count; ++h)
  {
    Vector3 position, target;
    polyData->GetPoint(h, position.data());
    targets->GetTuple(h, target.data());
    handles.Shares.push_back(ratios ? ratios->GetComponent(h, 0) : 1.0);
    if (!position.allFinite() || !target.allFinite() || !std::isfinite(handles.Shares.back()))
    {
      throw Error(Failure::BadMesh,
        "Handle %1 has a position, a Target or a MergeRatio that is not finite; compute the targets again.",
        h);
    }
    handles.Displacements.push_back(target - position);
  }
  return handles;
}

// The context of a step that takes progress from `from` to `to`.
Context PartOf(const Context& whole, double from, double to)
{
  Context part = whole;
  part.progress = [=](double done) { whole.progress(from + done * (to - from)); };
  return part;
}

struct ShapeKey
{
  MeshKey Mesh;
  std::vector<int> Vertices; // of the part
  std::vector<char> Movable; // of these
  bool AdjustNormals;
  bool operator==(const ShapeKey& other) const
  {
    return this->Mesh == other.Mesh && this->Vertices == other.Vertices && this->Movable == other.Movable &&
           this->AdjustNormals == other.AdjustNormals;
  }
};

// The shapes that some filter holds: a system deforms the same region more than once, with other handles.
Register<LaplacianShape, ShapeKey>& Shapes()
{
  static Register<LaplacianShape, ShapeKey> instance;
  return instance;
}

} // namespace

// The factor, and what was written last, with what each was made from.
struct vtkOversketchLaplacianDeform::Cache
{
  MeshKey SystemKey;
  std::vector<char> Region;
  std::vector<Binding> Bindings;
  double HandleWeight = 0.0;
  bool AdjustNormals = false;
  std::shared_ptr<const MeshData> Data;        // keeps the shared mesh alive between runs
  std::unique_ptr<const MeshPart> Part;        // the region, with the handles
  std::shared_ptr<const LaplacianShape> Shape; // of the part
  std::shared_ptr<FactorMemory> Memory = std::make_shared<FactorMemory>(); // from factor to factor
  std::vector<Binding> Local;                                              // the bindings to the part
  std::unique_ptr<LaplacianSystem> System;

  MeshKey OutputKey;
  std::vector<Vector3> Displacements;
  std::vector<double> Shares;
  std::vector<Vector3> Moves; // of the vertices that may move, Shape->vertices
  oversketch::Drag Dragged;   // empty until it is asked for
  vtkSmartPointer<vtkPoints> Points;
  vtkSmartPointer<vtkDataArray> PointNormals;
  vtkSmartPointer<vtkDataArray> CellNormals;

  void CutOut(const std::vector<char>& region, const std::vector<Binding>& bindings);
  void Write(vtkPolyData* input, const std::vector<Vector3>& moves);
  void PrepareDrag();
};

vtkStandardNewMacro(vtkOversketchLaplacianDeform);

// Makes the part, and the bindings to it.
void vtkOversketchLaplacianDeform::Cache::CutOut(const std::vector<char>& region,
  const std::vector<Binding>& bindings)
{
  std::vector<int> held;
  for (const Binding& binding : bindings)
  {
    held.insert(held.end(), binding.vertices.begin(), binding.vertices.end());
  }
  this->Part = std::make_unique<const MeshPart>(this->Data->Surface(), region, ThreadsOnly(), held);
  this->Local = bindings;
  for (Binding& binding : this->Local)
  {
    for (int& v : binding.vertices)
    {
      v = this->Part->at(v);
    }
  }
}

// Makes Points, PointNormals and CellNormals from the input and the displacement of each vertex of the part.
void vtkOversketchLaplacianDeform::Cache::Write(vtkPolyData* input, const std::vector<Vector3>& moves)
{
  const Mesh& before = this->Data->Surface();
  Mesh after = this->Part->mesh;
  std::vector<char> isMoved(moves.size(), 0), touched(moves.size(), 0);
  std::vector<std::pair<int, Vector3>> changed;
  for (int v = 0; v < after.vertexCount(); ++v)
  {
    if (moves[v] != Vector3::Zero())
    {
      isMoved[v] = 1;
      after.points[v] += moves[v];
      changed.emplace_back(this->Part->vertices[v], after.points[v]);
    }
  }
  this->Points = WithPlaces(input->GetPoints(), changed);
  this->PointNormals = nullptr;
  this->CellNormals = nullptr;
  for (const Triangle& c : after.triangles)
  {
    if (isMoved[c[0]] || isMoved[c[1]] || isMoved[c[2]])
    {
      touched[c[0]] = touched[c[1]] = touched[c[2]] = 1;
    }
  }
  vtkDataArray* pointNormals = input->GetPointData()->GetNormals();
  if (UsableNormals(pointNormals, before.vertexCount()))
  {
    changed.clear();
    for (int v = 0; v < after.vertexCount(); ++v)
    {
      if (touched[v])
      {
        changed.emplace_back(
          this->Part->vertices[v], vertexNormal(after, this->Part->adjacency.vertexTriangles, v));
      }
    }
    this->PointNormals = WithNormals(pointNormals, changed);
  }
  vtkDataArray* cellNormals = input->GetCellData()->GetNormals();
  if (UsableNormals(cellNormals, before.triangleCount()))
  {
    changed.clear();
    for (int i = 0; i < after.triangleCount(); ++i)
    {
      const Triangle& c = after.triangles[i];
      if (isMoved[c[0]] || isMoved[c[1]] || isMoved[c[2]])
      {
        changed.emplace_back(this->Part->triangles[i], facetNormal(after, i));
      }
    }
    this->CellNormals = WithNormals(cellNormals, changed);
  }
}

// From the factor.
void vtkOversketchLaplacianDeform::Cache::PrepareDrag()
{
  oversketch::Drag drag{
    valuesAt(this->Part->vertices, this->Shape->vertices), {}, this->System->response(this->Shares, Context())
  };
  drag.rest.reserve(drag.vertices.size());
  for (std::size_t i = 0; i < drag.vertices.size(); ++i)
  {
    drag.rest.push_back(this->Data->Surface().points[drag.vertices[i]] + this->Moves[i]);
  }
  this->Dragged = std::move(drag);
}

void vtkOversketchLaplacianDeform::ReleaseFactor()
{
  Cache& cache = this->Kept<Cache>();
  if (cache.System && cache.Points && cache.Dragged.vertices.empty())
  {
    cache.PrepareDrag();
    ++this->SolveCount;
  }
  cache.System.reset();
  cache.Memory = std::make_shared<FactorMemory>();
}

void vtkOversketchLaplacianDeform::ReleaseWork()
{
  this->Kept<Cache>() = Cache();
  this->GetOutputDataObject(0)->ReleaseData();
  this->Modified();
}

bool vtkOversketchLaplacianDeform::Drag(const double translation[3], vtkPoints* points)
{
  Cache& cache = this->Kept<Cache>();
  if (!cache.Points)
  {
    vtkErrorMacro("There is nothing to drag yet: Update() first.");
    return false;
  }
  const int type = points ? points->GetDataType() : VTK_VOID;
  if ((type != VTK_FLOAT && type != VTK_DOUBLE) ||
      points->GetNumberOfPoints() != cache.Points->GetNumberOfPoints())
  {
    vtkErrorMacro("The points to drag do not fit; give a copy of the output's points, float or double.");
    return false;
  }
  const Context context = ContextOf(this);
  if (cache.Dragged.vertices.empty())
  {
    if (!cache.System)
    {
      cache.System = std::make_unique<LaplacianSystem>(
        cache.Shape, cache.Local, cache.HandleWeight, Context(), cache.Memory);
      ++this->FactorizationCount;
    }
    cache.PrepareDrag();
    ++this->SolveCount;
  }
  const Vector3 d(translation);
  type == VTK_FLOAT ? cache.Dragged.place(d, static_cast<float*>(points->GetVoidPointer(0)), context)
                    : cache.Dragged.place(d, static_cast<double*>(points->GetVoidPointer(0)), context);
  points->Modified();
  return true;
}

void vtkOversketchLaplacianDeform::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  Cache& cache = this->Kept<Cache>();
  RequirePolygonsOnly(input); // the keys do not see other cells
  const MeshKey systemKey(input);
  const MeshKey outputKey(input, { input->GetPointData()->GetNormals(), input->GetCellData()->GetNormals() });
  const std::vector<char> region = LabelsOf(RequireArray(input->GetPointData(),
    "Region",
    1,
    input->GetNumberOfPoints(),
    "mesh",
    "vtkOversketchMixtureRegion or another region filter makes it"));
  const Handles handles =
    HandlesOf(vtkPolyData::GetData(inputs[1]), static_cast<int>(input->GetNumberOfPoints()));
  const Context context = ContextOf(this);

  const bool sameSystem = cache.Shape && cache.SystemKey == systemKey && cache.Region == region &&
                          cache.Bindings == handles.Bindings && cache.HandleWeight == this->HandleWeight &&
                          cache.AdjustNormals == this->AdjustNormals;
  const bool isWritten = sameSystem && cache.Points && cache.OutputKey == outputKey &&
                         cache.Displacements == handles.Displacements;
  if (!sameSystem || (!cache.System && !isWritten))
  {
    cache.System.reset();
    cache.Points = nullptr;
    cache.Data = SharedMesh(input);
    cache.CutOut(region, handles.Bindings);
    const MeshPart& part = *cache.Part;
    const ShapeKey key{
      systemKey, part.vertices, movableVertices(part.adjacency, part.region, cache.Local), this->AdjustNormals
    };
    auto shape = Shapes().Find(key);
    if (!shape)
    {
      cache.Shape = nullptr;
      shape = std::make_shared<LaplacianShape>(part.mesh,
        part.adjacency,
        key.Movable,
        true, // border vertices keep their Laplacian, too: a C1 join
        this->AdjustNormals,
        PartOf(context, 0.0, 0.4));
      Shapes().Add(key, shape);
      ++this->AnalysisCount;
    }
    cache.Shape = shape;
    auto system = std::make_unique<LaplacianSystem>(
      cache.Shape, cache.Local, this->HandleWeight, PartOf(context, 0.4, 0.9), cache.Memory);
    ++this->FactorizationCount;
    cache.System = std::move(system);
    cache.Region = region;
    cache.Bindings = handles.Bindings;
    cache.HandleWeight = this->HandleWeight;
    cache.SystemKey = systemKey;
    cache.AdjustNormals = this->AdjustNormals;
  }
  if (!isWritten)
  {
    cache.Points = nullptr;
    cache.Dragged = oversketch::Drag();
    const std::vector<Vector3> moves = cache.System->solve(handles.Displacements, PartOf(context, 0.9, 1.0));
    ++this->SolveCount;
    this->MovableCount = cache.System->movableCount();
    this->ActiveHandleCount = 0;
    this->MeanHandleResidual = this->MaximumHandleResidual = 0.0;
    for (int h = 0; h < static_cast<int>(cache.Local.size()); ++h)
    {
      if (cache.System->handleActive(h))
      {
        const double residual = (cache.Local[h].of(moves) - handles.Displacements[h]).norm();
        this->MeanHandleResidual += residual;
        this->MaximumHandleResidual = std::max(this->MaximumHandleResidual, residual);
        ++this->ActiveHandleCount;
      }
    }
    this->MeanHandleResidual /= static_cast<double>(this->ActiveHandleCount);
    cache.Moves = valuesAt(moves, cache.Shape->vertices);
    cache.Write(input, moves);
    cache.OutputKey = outputKey;
    cache.Displacements = handles.Displacements;
  }
  if (cache.Shares != handles.Shares)
  {
    cache.Shares = handles.Shares;
    cache.Dragged = oversketch::Drag();
  }
  output->ShallowCopy(input);
  output->SetPoints(cache.Points);
  if (cache.PointNormals)
  {
    output->GetPointData()->SetNormals(cache.PointNormals);
  }
  if (cache.CellNormals)
  {
    output->GetCellData()->SetNormals(cache.CellNormals);
  }
}

void vtkOversketchLaplacianDeform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AdjustNormals: " << this->AdjustNormals << endl;
  os << indent << "HandleWeight: " << this->HandleWeight << endl;
  os << indent << "AnalysisCount: " << this->AnalysisCount << endl;
  os << indent << "FactorizationCount: " << this->FactorizationCount << endl;
  os << indent << "SolveCount: " << this->SolveCount << endl;
  os << indent << "MeanHandleResidual: " << this->MeanHandleResidual << endl;
  os << indent << "MaximumHandleResidual: " << this->MaximumHandleResidual << endl;
  os << indent << "MovableCount: " << this->MovableCount << endl;
  os << indent << "ActiveHandleCount: " << this->ActiveHandleCount << endl;
}
