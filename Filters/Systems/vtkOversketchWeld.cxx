#include "vtkOversketchWeld.h"

#include "Mesh/place.h"
#include "Mesh/rotation.h"
#include "Mesh/weld.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchSources.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace oversketch
{

namespace
{

const char* const remedy = "vtkOversketchRemesh writes it";

} // namespace

Vector3 Turned(const Vector3& normal, const Vector3& before, const Vector3& after)
{
  if (before.squaredNorm() == 0.0 || after.squaredNorm() == 0.0)
  {
    return normal;
  }
  return rotationBetween(before, after) * normal;
}

void RefreshCellNormals(vtkPolyData* output, const std::vector<char>& changedPoint)
{
  vtkDataArray* old = output->GetCellData()->GetNormals();
  if (!old || old->GetNumberOfTuples() != output->GetNumberOfPolys())
  {
    return;
  }
  auto normals = vtkSmartPointer<vtkDataArray>::Take(old->NewInstance());
  normals->DeepCopy(old);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < output->GetNumberOfPolys(); ++cell)
  {
    output->GetPolys()->GetCellAtId(cell, ids);
    if (changedPoint[ids->GetId(0)] || changedPoint[ids->GetId(1)] || changedPoint[ids->GetId(2)])
    {
      Mesh one;
      one.points.resize(3);
      one.triangles = { { 0, 1, 2 } };
      for (int k = 0; k < 3; ++k)
      {
        output->GetPoint(ids->GetId(k), one.points[k].data());
      }
      normals->SetTuple(cell, facetNormal(one, 0).data());
    }
  }
  output->GetCellData()->SetNormals(normals);
}

namespace
{

vtkSmartPointer<vtkPoints> NewPoints(vtkPolyData* like, vtkIdType count)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(like->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  return points;
}

// The geometry of a mesh without its arrays: what SharedMesh keeps serves any step that reads no normals.
std::shared_ptr<const MeshData> SharedGeometry(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(mesh->GetPolys());
  return SharedMesh(bare);
}

} // namespace

// Where the corners of the last remeshing come from, through all of them: points of the mesh, each standing
// for its class.
class Weld::Origins
{
public:
  Origins(const Weld& weld, const std::vector<vtkPolyData*>& remeshings)
    : Welding(weld)
  {
    for (vtkPolyData* remeshing : remeshings)
    {
      this->Chain.emplace_back(remeshing);
    }
  }

  // The one point that the corner is as a whole, told at a glance; -1 where it takes a mix to tell.
  int WholeAt(vtkIdType triangle, int corner) const
  {
    for (auto sources = this->Chain.rbegin(); sources != this->Chain.rend(); ++sources)
    {
      const double* weights = sources->WeightsAt(triangle, corner);
      int whole = -1;
      for (int k = 0; k < 3; ++k)
      {
        if (weights[k] != 0.0)
        {
          if (whole >= 0 || weights[k] != 1.0)
          {
            return -1;
          }
          whole = k;
        }
      }
      if (whole < 0)
      {
        return -1;
      }
      triangle = sources->Cell(triangle, corner);
      corner = whole;
    }
    return this->PointAt(triangle, corner);
  }

  Mix MixAt(vtkIdType triangle, int corner) const
  {
    struct Share
    {
      vtkIdType triangle;
      int corner;
      double weight;
    };
    std::vector<Share> shares, earlier;
    shares.reserve(9); // of two remeshings
    earlier.reserve(9);
    shares.push_back({ triangle, corner, 1.0 });
    for (auto sources = this->Chain.rbegin(); sources != this->Chain.rend(); ++sources)
    {
      earlier.clear();
      for (const Share& share : shares)
      {
        const double* weights = sources->WeightsAt(share.triangle, share.corner);
        for (int k = 0; k < 3; ++k)
        {
          if (weights[k] != 0.0)
          {
            earlier.push_back({ sources->Cell(share.triangle, share.corner), k, share.weight * weights[k] });
          }
        }
      }
      shares.swap(earlier);
    }
    Mix mix;
    mix.reserve(shares.size());
    for (const Share& share : shares)
    {
      mix.emplace_back(this->PointAt(share.triangle, share.corner), share.weight);
    }
    return normalisedMix(std::move(mix));
  }

private:
  int PointAt(vtkIdType triangle, int corner) const
  {
    return this->Welding.ClassOf(this->Welding.CornersOf()[static_cast<std::size_t>(triangle)][corner]);
  }

  const Weld& Welding;
  std::vector<Sources> Chain;
};

// The points of the output: one per vertex of the last remeshing, or one per chart where the mesh was split.
class Weld::Split
{
public:
  Split(const Weld& weld, const Origins& origins, const MeshData& result, bool whole)
  {
    whole ? this->TakeVertices(origins, result.Surface(), weld)
          : this->SplitVertices(origins, result.Surface(), weld.LoosePoints());
  }

  std::vector<Triangle> Triangles; // empty where nothing was split
  std::vector<int> Vertices;       // per point, in the last remeshing
  std::vector<int> Whole;          // per point, the point of the mesh that it is; -1 for a mix
  // The mix that a point is which is none of the mesh.
  const Mix& MixedOf(vtkIdType point) const
  {
    return this->Mixes[static_cast<std::size_t>(this->MixOf[static_cast<std::size_t>(point)])];
  }
  Mix Of(vtkIdType point) const
  {
    const int whole = this->Whole[static_cast<std::size_t>(point)];
    return whole >= 0 ? Mix{ { whole, 1.0 } } : this->MixedOf(point);
  }

private:
  // Where nothing was split, every vertex is a point, and one corner speaks for all.
  void TakeVertices(const Origins& origins, const Mesh& mesh, const Weld& weld)
  {
    std::vector<int> corners(mesh.points.size(), -1); // the first of each vertex, 3 t + k
    for (int t = mesh.triangleCount() - 1; t >= 0; --t)
    {
      for (int k = 2; k >= 0; --k)
      {
        corners[mesh.triangles[t][k]] = 3 * t + k;
      }
    }
    const bool anyLoose = std::find(corners.begin(), corners.end(), -1) != corners.end();
    const std::vector<int> loose = anyLoose ? weld.LoosePoints() : std::vector<int>();
    this->Vertices.resize(mesh.points.size());
    std::iota(this->Vertices.begin(), this->Vertices.end(), 0);
    this->Whole.resize(mesh.points.size());
    vtkSMPTools::For(0,
      mesh.vertexCount(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType v = begin; v < end; ++v)
        {
          this->Whole[v] = corners[v] < 0 ? -1 : origins.WholeAt(corners[v] / 3, corners[v] % 3);
        }
      });
    this->MixOf.assign(mesh.points.size(), -1);
    std::vector<int> mixed;
    std::size_t nextLoose = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (corners[v] < 0)
      {
        this->Whole[v] = loose.at(nextLoose++);
      }
      else if (this->Whole[v] < 0)
      {
        this->MixOf[v] = static_cast<int>(mixed.size());
        mixed.push_back(v);
      }
    }
    this->Mixes.resize(mixed.size());
    vtkSMPTools::For(0,
      static_cast<vtkIdType>(mixed.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          Mix& mix = this->Mixes[i];
          mix = origins.MixAt(corners[mixed[i]] / 3, corners[mixed[i]] % 3);
          this->Whole[mixed[i]] = mix.size() == 1 ? mix[0].first : -1;
        }
      });
  }

  void SplitVertices(const Origins& origins, const Mesh& mesh, const std::vector<int>& loose)
  {
    std::size_t nextLoose = 0;
    this->Triangles = mesh.triangles;
    const Lists around = trianglesAround(mesh);
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      const std::size_t begin = this->Vertices.size();
      for (const int* t = around.begin(v); t != around.end(v); ++t)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          if (mesh.triangles[*t][corner] == v)
          {
            this->Triangles[*t][corner] = static_cast<int>(this->PointOf(begin, v, origins, *t, corner));
          }
        }
      }
      if (this->Vertices.size() == begin)
      {
        // A vertex without a triangle, which nothing tells the source of: the remesher keeps them, in their
        // order.
        this->Add(v, loose.at(nextLoose++), {});
      }
    }
  }

  // Finds, of the vertex's points, which are those from begin on, the one that comes from where the corner
  // does.
  std::size_t PointOf(std::size_t begin, int vertex, const Origins& origins, int triangle, int corner)
  {
    Mix mix;
    int whole = origins.WholeAt(triangle, corner);
    if (whole < 0)
    {
      mix = origins.MixAt(triangle, corner);
      whole = mix.size() == 1 ? mix[0].first : -1;
    }
    std::size_t point = begin;
    while (point < this->Vertices.size() &&
           (this->Whole[point] != whole || (whole < 0 && !sameMix(this->Mixes[this->MixOf[point]], mix))))
    {
      ++point;
    }
    if (point == this->Vertices.size())
    {
      this->Add(vertex, whole, std::move(mix));
    }
    return point;
  }

  void Add(int vertex, int whole, Mix mix)
  {
    this->Vertices.push_back(vertex);
    this->Whole.push_back(whole);
    this->MixOf.push_back(whole < 0 ? static_cast<int>(this->Mixes.size()) : -1);
    if (whole < 0)
    {
      this->Mixes.push_back(std::move(mix));
    }
  }

  std::vector<int> MixOf; // per point, into Mixes
  std::vector<Mix> Mixes;
};

Weld::Weld(vtkPolyData* mesh)
{
  RequirePolygonsOnly(mesh);
  this->Geometry->SetPoints(mesh->GetPoints());
  this->Geometry->SetPolys(mesh->GetPolys());
  const std::shared_ptr<const MeshData> split = SharedMesh(this->Geometry);
  this->Data = split;
  this->Vertices = weldPoints(split->Surface().points);
  const bool welded = !this->Vertices.empty();
  if (welded)
  {
    const Mesh surface = weldedMesh(split->Surface(), this->Vertices);
    auto points = NewPoints(mesh, surface.vertexCount());
    for (int v = 0; v < surface.vertexCount(); ++v)
    {
      points->SetPoint(v, surface.points[v].data());
    }
    this->Geometry->SetPoints(points);
    this->Geometry->SetPolys(CellsOf(surface.triangles));
    this->Data = SharedMesh(this->Geometry);
  }
  const auto cells = NewArray<vtkIdTypeArray>("OriginalCell", 1, mesh->GetNumberOfPolys());
  std::iota(cells->GetPointer(0), cells->GetPointer(0) + mesh->GetNumberOfPolys(), vtkIdType(0));
  this->Geometry->GetCellData()->AddArray(cells);
  if (!welded)
  {
    return;
  }

  std::vector<std::pair<vtkDataArray*, int>> components;
  for (int a = 0; a < mesh->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = mesh->GetPointData()->GetArray(a);
    for (int c = 0; array && c < array->GetNumberOfComponents(); ++c)
    {
      components.emplace_back(array, c);
    }
  }
  this->Classes =
    attributeClasses(this->Vertices, { static_cast<int>(components.size()), [&components](int point, int k) {
                                        return components[k].first->GetComponent(point, components[k].second);
                                      } });
  this->Corners = split->Surface().triangles;
  const Charts charts =
    findCharts(this->Data->Surface(), this->Data->Neighbours(), this->Corners, this->Classes);
  if (charts.count > 1)
  {
    this->Geometry->GetCellData()->AddArray(ArrayOf<vtkIntArray>("Chart", charts.of));
  }
}

Weld::~Weld() = default;

void Weld::PutMask(vtkPolyData* mesh, vtkPolyData* welded) const
{
  const std::vector<double> mask = MaskOf(mesh);
  std::vector<double> ofVertices(
    mask.empty() ? 0 : static_cast<std::size_t>(welded->GetNumberOfPoints()), 0.0);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    double& one = ofVertices[static_cast<std::size_t>(this->VertexOf(static_cast<vtkIdType>(i)))];
    one = std::max(one, mask[i]);
  }
  oversketch::PutMask(ofVertices, welded);
}

void Weld::Move(vtkPolyData* mesh, vtkPolyData* moved, vtkPolyData* output) const
{
  output->ShallowCopy(mesh);
  const vtkIdType count = mesh->GetNumberOfPoints();
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->DeepCopy(mesh->GetPoints());
  std::vector<char> changed(static_cast<std::size_t>(count), 0);
  const Mesh& before = this->Data->Surface();
  Mesh after = before;
  for (int v = 0; v < after.vertexCount(); ++v)
  {
    moved->GetPoint(v, after.points[v].data());
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType v = this->VertexOf(i);
    if (after.points[v] != before.points[v])
    {
      points->SetPoint(i, after.points[v].data());
      changed[i] = 1;
    }
  }
  output->SetPoints(points);
  if (vtkDataArray* old = mesh->GetPointData()->GetNormals())
  {
    const std::vector<Vector3>& normalsBefore = this->Data->Normals();
    const std::vector<Vector3> normalsNow =
      vertexNormals(after, this->Data->Neighbours().vertexTriangles, ThreadsOnly());
    auto normals = vtkSmartPointer<vtkDataArray>::Take(old->NewInstance());
    normals->DeepCopy(old);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType v = this->VertexOf(i);
      if (normalsBefore[v] != normalsNow[v])
      {
        Vector3 n;
        old->GetTuple(i, n.data());
        normals->SetTuple(i, Turned(n, normalsBefore[v], normalsNow[v]).data());
      }
    }
    output->GetPointData()->SetNormals(normals);
  }
  RefreshCellNormals(output, changed);
}

// The first points of the vertices without a triangle, in their order.
std::vector<int> Weld::LoosePoints() const
{
  std::vector<char> known(this->Data->Surface().points.size(), 0);
  for (const Triangle& t : this->Data->Surface().triangles)
  {
    known[t[0]] = known[t[1]] = known[t[2]] = 1;
  }
  std::vector<int> loose;
  const auto points = this->Vertices.empty() ? known.size() : this->Vertices.size();
  for (int p = 0; p < static_cast<int>(points); ++p)
  {
    char& seen = known[this->VertexOf(p)];
    if (!seen)
    {
      loose.push_back(p);
      seen = 1;
    }
  }
  return loose;
}

void Weld::CarryPoints(vtkPolyData* mesh,
  const Split& split,
  const MeshData& result,
  vtkPolyData* output) const
{
  vtkPointData* from = mesh->GetPointData();
  const auto count = static_cast<vtkIdType>(split.Whole.size());
  auto points = NewPoints(mesh, count);
  vtkSMPTools::For(0,
    count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        points->SetPoint(i, result.Surface().points[split.Vertices[i]].data());
      }
    });
  output->SetPoints(points);
  const CarriedPoints carried{ split.Whole,
    [&split](vtkIdType point) -> const Mix& { return split.MixedOf(point); } };
  CarryArrays(from,
    output->GetPointData(),
    [&](vtkAbstractArray* array, bool)
    {
      const bool ids = array->GetDataType() == VTK_ID_TYPE || array == from->GetPedigreeIds();
      return ids ? nullptr : carried.Array(array, false); // normals are CarryNormals'
    });
}

// Where the surface has turned, the mesh's own normals turn with it.
void Weld::CarryNormals(vtkPolyData* mesh,
  const Split& split,
  const MeshData& result,
  vtkPolyData* output) const
{
  const auto count = static_cast<vtkIdType>(split.Whole.size());
  const Mesh& surface = this->Data->Surface();
  vtkDataArray* normals = mesh->GetPointData()->GetNormals() ? output->GetPointData()->GetNormals() : nullptr;
  if (!normals && !output->GetCellData()->GetNormals())
  {
    return;
  }
  const std::vector<Vector3> none;
  const std::vector<Vector3>& before = normals ? this->Data->Normals() : none;
  const std::vector<Vector3>& now = normals ? result.Normals() : none;
  std::vector<char> changed(split.Whole.size(), 0);
  vtkSMPTools::For(0,
    count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const int v = split.Vertices[i], whole = split.Whole[i];
        changed[i] = whole < 0 || surface.points[this->VertexOf(whole)] != result.Surface().points[v];
        if (!normals || !(changed[i] || before[this->VertexOf(whole)] != now[v]))
        {
          continue;
        }
        Vector3 n, old = Vector3::Zero();
        for (const auto& [point, weight] : split.Of(i))
        {
          old += weight * before[this->VertexOf(point)];
        }
        normals->GetTuple(i, n.data());
        normals->SetTuple(i, Turned(n, old, now[v]).normalized().eval().data());
      }
    });
  RefreshCellNormals(output, changed);
}

std::vector<int> Weld::Transfer(vtkPolyData* mesh,
  const std::vector<vtkPolyData*>& remeshings,
  vtkPolyData* output,
  Seams seams) const
{
  vtkPolyData* last = remeshings.back();
  const std::shared_ptr<const MeshData> result = SharedGeometry(last);
  const bool sameTriangles = seams == Seams::Shared || (seams == Seams::AsBefore && this->Vertices.empty());
  const Split split(*this, Origins(*this, remeshings), *result, sameTriangles);
  output->SetPolys(sameTriangles ? last->GetPolys() : CellsOf(split.Triangles).Get());
  this->CarryPoints(mesh, split, *result, output);

  vtkCellData* from = mesh->GetCellData();
  vtkDataArray* cells =
    RequireArray(last->GetCellData(), "OriginalCell", 1, last->GetNumberOfPolys(), "remeshed mesh", remedy);
  std::vector<vtkIdType> sources(from->GetNumberOfArrays() > 0 ? result->Surface().triangles.size() : 0);
  for (std::size_t t = 0; t < sources.size(); ++t)
  {
    sources[t] = static_cast<vtkIdType>(cells->GetComponent(static_cast<vtkIdType>(t), 0));
  }
  CopyElements(from, sources, output->GetCellData());
  output->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  this->CarryNormals(mesh, split, *result, output);
  return split.Vertices;
}

} // namespace oversketch
