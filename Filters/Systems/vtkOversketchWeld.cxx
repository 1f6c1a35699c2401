#include "vtkOversketchWeld.h"

#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

namespace oversketch
{

namespace
{

// A point of a result as a mix of points of the mesh: ids ascending, weights above rounding, sum 1.
using Mix = std::vector<std::pair<vtkIdType, double>>;

bool SameMix(const Mix& a, const Mix& b)
{
  return a.size() == b.size() && std::equal(a.begin(),
                                   a.end(),
                                   b.begin(),
                                   [](const auto& x, const auto& y)
                                   { return x.first == y.first && std::abs(x.second - y.second) < 1e-9; });
}

void Normalise(Mix& mix)
{
  std::sort(mix.begin(), mix.end());
  Mix merged;
  for (const auto& entry : mix)
  {
    if (!merged.empty() && merged.back().first == entry.first)
    {
      merged.back().second += entry.second;
    }
    else
    {
      merged.push_back(entry);
    }
  }
  merged.erase(
    std::remove_if(
      merged.begin(), merged.end(), [](const auto& entry) { return std::abs(entry.second) < 1e-12; }),
    merged.end());
  mix = std::move(merged);
  if (mix.size() == 1)
  {
    mix[0].second = 1.0;
  }
}

// The rotation that takes one surface normal to another, applied to a normal of the user's.
Vector3 Turned(const Vector3& normal, const Vector3& before, const Vector3& after)
{
  if (before.squaredNorm() == 0.0 || after.squaredNorm() == 0.0)
  {
    return normal;
  }
  return Eigen::Quaterniond::FromTwoVectors(before, after) * normal;
}

// Cell normals of triangles whose points changed are computed anew.
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

vtkSmartPointer<vtkPoints> NewPoints(vtkPolyData* like, vtkIdType count)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(like->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  return points;
}

} // namespace

Weld::Weld(vtkPolyData* mesh)
{
  this->Surface = MeshOf(mesh);
  this->Corners = this->Surface.triangles;
  this->FindVertices();
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("OriginalCell");
  cells->SetNumberOfTuples(mesh->GetNumberOfPolys());
  std::iota(cells->GetPointer(0), cells->GetPointer(0) + mesh->GetNumberOfPolys(), vtkIdType(0));
  this->Inner->GetCellData()->AddArray(cells);
  if (this->Vertices.empty())
  {
    this->Inner->SetPoints(mesh->GetPoints());
    this->Inner->SetPolys(mesh->GetPolys());
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  for (const Vector3& p : this->Surface.points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> polys;
  for (const Triangle& t : this->Surface.triangles)
  {
    const vtkIdType ids[3] = { t[0], t[1], t[2] };
    polys->InsertNextCell(3, ids);
  }
  this->Inner->SetPoints(points);
  this->Inner->SetPolys(polys);
  this->FindAttributeClasses(mesh);
  this->FindCharts();
}

Weld::~Weld() = default;

void Weld::FindVertices()
{
  const auto& p = this->Surface.points;
  const int count = this->Surface.vertexCount();
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  const auto compare = [&](int a, int b)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (p[a][k] != p[b][k])
        return p[a][k] < p[b][k] ? -1 : 1;
    }
    return 0;
  };
  std::sort(order.begin(),
    order.end(),
    [&](int a, int b)
    {
      const int c = compare(a, b);
      return c != 0 ? c < 0 : a < b;
    });
  // The lowest point of each position stands for it; vertices keep the order of those.
  std::vector<int> first(count);
  bool identity = true;
  for (int i = 0; i < count; ++i)
  {
    const bool same = i > 0 && compare(order[i - 1], order[i]) == 0;
    first[order[i]] = same ? first[order[i - 1]] : order[i];
    identity = identity && !same;
  }
  if (identity)
  {
    return;
  }
  this->Vertices.resize(count);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i)
  {
    if (first[i] == i)
    {
      this->Vertices[i] = static_cast<vtkIdType>(points.size());
      points.push_back(p[i]);
    }
    else
    {
      this->Vertices[i] = this->Vertices[first[i]];
    }
  }
  this->Surface.points = std::move(points);
  for (Triangle& t : this->Surface.triangles)
  {
    for (int& v : t)
    {
      v = static_cast<int>(this->Vertices[v]);
    }
  }
}

void Weld::FindAttributeClasses(vtkPolyData* mesh)
{
  vtkPointData* data = mesh->GetPointData();
  const int count = static_cast<int>(mesh->GetNumberOfPoints());
  std::vector<vtkDataArray*> arrays;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    if (vtkDataArray* array = data->GetArray(a))
    {
      arrays.push_back(array);
    }
  }
  const auto compare = [&](int a, int b)
  {
    if (this->Vertices[a] != this->Vertices[b])
    {
      return this->Vertices[a] < this->Vertices[b] ? -1 : 1;
    }
    for (vtkDataArray* array : arrays)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double x = array->GetComponent(a, c), y = array->GetComponent(b, c);
        if (x != y)
          return x < y ? -1 : 1;
      }
    }
    return 0;
  };
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(),
    order.end(),
    [&](int a, int b)
    {
      const int c = compare(a, b);
      return c != 0 ? c < 0 : a < b;
    });
  this->AttributeClasses.resize(count);
  for (int i = 0; i < count; ++i)
  {
    const bool same = i > 0 && compare(order[i - 1], order[i]) == 0;
    this->AttributeClasses[order[i]] = same ? this->AttributeClasses[order[i - 1]] : order[i];
  }
}

void Weld::FindCharts()
{
  const Adjacency adjacency = buildAdjacency(this->Surface);
  const int triangles = this->Surface.triangleCount();
  const auto classAt = [&](int triangle, int vertex)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (this->Surface.triangles[triangle][k] == vertex)
      {
        return this->AttributeClasses[this->Corners[triangle][k]];
      }
    }
    return vtkIdType(-1);
  };
  // Neighbours across an edge of two triangles, and whether an attribute jumps there.
  const auto eachNeighbour = [&](int triangle, auto&& visit)
  {
    for (int edge : adjacency.triangleEdges[triangle])
    {
      if (edge >= 0 && adjacency.edges[edge].triangleCount == 2)
      {
        const int* pair = adjacency.trianglesBegin(edge);
        const int other = pair[0] == triangle ? pair[1] : pair[0];
        const MeshEdge& e = adjacency.edges[edge];
        visit(other,
          classAt(triangle, e.v0) != classAt(other, e.v0) || classAt(triangle, e.v1) != classAt(other, e.v1));
      }
    }
  };
  // A seam may end inside a patch of the texture. A triangle joins a chart only if no triangle across one of
  // its seams is already there, so every seam separates two charts.
  vtkNew<vtkIntArray> charts;
  charts->SetName("Chart");
  charts->SetNumberOfTuples(triangles);
  charts->FillComponent(0, -1);
  int* chart = charts->GetPointer(0);
  int count = 0;
  for (int seed = 0; seed < triangles; ++seed)
  {
    if (chart[seed] >= 0)
    {
      continue;
    }
    std::queue<int> queue({ seed });
    chart[seed] = count;
    while (!queue.empty())
    {
      const int t = queue.front();
      queue.pop();
      eachNeighbour(t,
        [&](int other, bool seam)
        {
          if (seam || chart[other] >= 0)
          {
            return;
          }
          bool clash = false;
          eachNeighbour(
            other, [&](int beyond, bool jump) { clash = clash || (jump && chart[beyond] == count); });
          if (!clash)
          {
            chart[other] = count;
            queue.push(other);
          }
        });
    }
    ++count;
  }
  if (count > 1)
  {
    this->Inner->GetCellData()->AddArray(charts);
  }
}

void Weld::Move(vtkPolyData* mesh, vtkPolyData* moved, vtkPolyData* output) const
{
  output->ShallowCopy(mesh);
  const vtkIdType count = mesh->GetNumberOfPoints();
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->DeepCopy(mesh->GetPoints());
  std::vector<char> changed(static_cast<std::size_t>(count), 0);
  Mesh after = this->Surface;
  for (int v = 0; v < after.vertexCount(); ++v)
  {
    moved->GetPoint(v, after.points[v].data());
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType v = this->VertexOf(i);
    if (after.points[v] != this->Surface.points[v])
    {
      points->SetPoint(i, after.points[v].data());
      changed[i] = 1;
    }
  }
  output->SetPoints(points);
  if (vtkDataArray* old = mesh->GetPointData()->GetNormals())
  {
    const std::vector<Vector3> before = vertexNormals(this->Surface);
    const std::vector<Vector3> now = vertexNormals(after);
    auto normals = vtkSmartPointer<vtkDataArray>::Take(old->NewInstance());
    normals->DeepCopy(old);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType v = this->VertexOf(i);
      if (before[v] != now[v])
      {
        Vector3 n;
        old->GetTuple(i, n.data());
        normals->SetTuple(i, Turned(n, before[v], now[v]).data());
      }
    }
    output->GetPointData()->SetNormals(normals);
  }
  RefreshCellNormals(output, changed);
}

std::vector<int> Weld::Transfer(vtkPolyData* mesh,
  vtkPolyData* stretched,
  vtkPolyData* restored,
  vtkPolyData* output) const
{
  const char* remedy = "vtkOversketchRemesh writes it";
  const auto sources = [&](vtkPolyData* remeshed)
  {
    return std::make_pair(
      RequireArray(
        remeshed->GetCellData(), "SourceCell", 3, remeshed->GetNumberOfPolys(), "remeshed mesh", remedy),
      RequireArray(
        remeshed->GetCellData(), "SourceWeights", 9, remeshed->GetNumberOfPolys(), "remeshed mesh", remedy));
  };
  const auto first = sources(stretched);
  const auto second = sources(restored);
  const auto mixAt = [&](vtkIdType cell, int corner)
  {
    Mix mix;
    const auto between = static_cast<vtkIdType>(second.first->GetComponent(cell, corner));
    for (int k = 0; k < 3; ++k)
    {
      const double outer = second.second->GetComponent(cell, 3 * corner + k);
      if (outer == 0.0)
      {
        continue;
      }
      const auto source = static_cast<std::size_t>(first.first->GetComponent(between, k));
      for (int j = 0; j < 3; ++j)
      {
        const double weight = outer * first.second->GetComponent(between, 3 * k + j);
        const vtkIdType point = this->Corners[source][j];
        mix.emplace_back(this->AttributeClasses.empty() ? point : this->AttributeClasses[point], weight);
      }
    }
    Normalise(mix);
    return mix;
  };

  const Mesh result = MeshOf(restored);
  const Adjacency adjacency = buildAdjacency(result);
  std::vector<Triangle> triangles = result.triangles;
  std::vector<Mix> mixes;    // per point of the output
  std::vector<int> vertexOf; // per point of the output, in result
  for (int v = 0; v < result.vertexCount(); ++v)
  {
    const std::size_t begin = mixes.size();
    for (const int* t = adjacency.vertexTriangles.begin(v); t != adjacency.vertexTriangles.end(v); ++t)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        if (result.triangles[*t][corner] != v)
        {
          continue;
        }
        // Where nothing was split, one corner speaks for all.
        std::size_t point = begin;
        if (this->Vertices.empty() ? mixes.size() == begin : true)
        {
          const Mix mix = mixAt(*t, corner);
          while (point < mixes.size() && !SameMix(mixes[point], mix))
          {
            ++point;
          }
          if (point == mixes.size())
          {
            mixes.push_back(mix);
            vertexOf.push_back(v);
          }
        }
        triangles[*t][corner] = static_cast<int>(point);
      }
    }
    if (mixes.size() == begin)
    {
      // A vertex without a triangle: nothing tells its source.
      mixes.push_back({});
      vertexOf.push_back(v);
    }
  }

  const auto count = static_cast<vtkIdType>(mixes.size());
  auto points = NewPoints(mesh, count);
  vtkDataArray* oldNormals = mesh->GetPointData()->GetNormals();
  std::vector<Vector3> before, now; // of the surface, where the mesh's own have to turn with it
  if (oldNormals)
  {
    before = vertexNormals(this->Surface);
    now = vertexNormals(result);
  }
  vtkPointData* from = mesh->GetPointData();
  vtkPointData* to = output->GetPointData();
  to->InterpolateAllocate(from, count);
  std::vector<char> changed(mixes.size(), 0);
  vtkNew<vtkIdList> ids;
  std::vector<double> weights;
  // The first points of the vertices without a triangle, which the remesher keeps, in their order.
  std::vector<vtkIdType> loose;
  std::size_t nextLoose = 0;
  std::vector<char> known(this->Surface.points.size(), 0);
  for (const Triangle& t : this->Surface.triangles)
  {
    known[t[0]] = known[t[1]] = known[t[2]] = 1;
  }
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    char& seen = known[this->VertexOf(p)];
    if (!seen)
    {
      loose.push_back(p);
      seen = 1;
    }
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    Mix& mix = mixes[i];
    const int v = vertexOf[i];
    if (mix.empty())
    {
      mix = { { loose.at(nextLoose++), 1.0 } };
    }
    points->SetPoint(i, result.points[v].data());
    ids->Reset();
    weights.clear();
    Vector3 oldSurface = Vector3::Zero();
    for (const auto& [point, weight] : mix)
    {
      ids->InsertNextId(point);
      weights.push_back(weight);
      if (oldNormals)
      {
        oldSurface += weight * before[this->VertexOf(point)];
      }
    }
    if (mix.size() == 1)
    {
      to->CopyData(from, mix[0].first, i);
    }
    else
    {
      to->InterpolatePoint(from, i, ids, weights.data());
    }
    changed[i] = mix.size() > 1 || this->Surface.points[this->VertexOf(mix[0].first)] != result.points[v];
    if (oldNormals && (changed[i] || before[this->VertexOf(mix[0].first)] != now[v]))
    {
      Vector3 n;
      to->GetNormals()->GetTuple(i, n.data());
      to->GetNormals()->SetTuple(i, Turned(n, oldSurface, now[v]).normalized().eval().data());
    }
  }
  output->SetPoints(points);
  vtkNew<vtkCellArray> polys;
  output->GetCellData()->CopyAllocate(mesh->GetCellData(), static_cast<vtkIdType>(triangles.size()));
  vtkDataArray* cells = RequireArray(
    restored->GetCellData(), "OriginalCell", 1, restored->GetNumberOfPolys(), "remeshed mesh", remedy);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const vtkIdType corners[3] = { triangles[t][0], triangles[t][1], triangles[t][2] };
    polys->InsertNextCell(3, corners);
    const auto cell = static_cast<vtkIdType>(t);
    output->GetCellData()->CopyData(
      mesh->GetCellData(), static_cast<vtkIdType>(cells->GetComponent(cell, 0)), cell);
  }
  output->SetPolys(polys);
  output->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  RefreshCellNormals(output, changed);
  return vertexOf;
}

} // namespace oversketch
