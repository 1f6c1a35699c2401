#include "Stellar/defects.h"

#include "Mesh/context.h"

#include <algorithm>
#include <string>

namespace oversketch
{

namespace
{

// One kind of defect: how many there are, and the first five.
class DefectList
{
public:
  template <class Name>
  void add(const Name& name)
  {
    if (++this->Count <= 5)
    {
      this->Names += (this->Count > 1 ? ", " : "") + name();
    }
  }
  void addId(int id)
  {
    this->add([&] { return std::to_string(id); });
  }
  // "3 triangles without area (7, 9, 11)"
  void report(const char* one, const char* many, std::string& text) const
  {
    if (this->Count)
    {
      text += (text.empty() ? "" : "; ") + std::to_string(this->Count) + " " +
              (this->Count == 1 ? one : many) + " (" + this->Names + (this->Count > 5 ? ", …)" : ")");
    }
  }

private:
  int Count = 0;
  std::string Names;
};

void refuseDefects(const std::string& defects)
{
  if (!defects.empty())
  {
    throw Error(Failure::BadMesh,
      "The mesh is not an oriented manifold of triangles: %1; mend it, for instance with vtkCleanPolyData "
      "and with vtkPolyDataNormals, Consistency on.",
      defects);
  }
}

bool hasArea(const Mesh& mesh, const Triangle& t)
{
  Vector3 a = mesh.points[t[1]] - mesh.points[t[0]], b = mesh.points[t[2]] - mesh.points[t[0]];
  const double size = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  if (size == 0.0)
  {
    return false;
  }
  a /= size; // so that nothing underflows
  b /= size;
  return a.cross(b) != Vector3::Zero();
}

bool sameCorners(Triangle a, Triangle b)
{
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

} // namespace

void checkPointIds(const Mesh& mesh)
{
  DefectList nowhere;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    for (int v : mesh.triangles[t])
    {
      if (v < 0 || v >= mesh.vertexCount())
      {
        nowhere.addId(t);
        break;
      }
    }
  }
  std::string text;
  nowhere.report("triangle that names no point", "triangles that name no point", text);
  refuseDefects(text);
}

void checkManifold(const Mesh& mesh)
{
  checkPointIds(mesh);
  checkManifold(mesh, buildAdjacency(mesh));
}

void checkManifold(const Mesh& mesh, const Adjacency& adjacency)
{
  DefectList infinite, degenerate, flat, repeated, crowded, turned, pinched;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (!mesh.points[v].allFinite())
    {
      infinite.addId(v);
    }
  }
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& corners = mesh.triangles[t];
    const int edge = adjacency.triangleEdges[t][0];
    if (edge < 0)
    {
      degenerate.addId(t);
      continue;
    }
    if (!hasArea(mesh, corners))
    {
      flat.addId(t);
    }
    for (const int other : adjacency.trianglesAt(edge))
    {
      if (other < t && sameCorners(mesh.triangles[other], corners))
      {
        repeated.addId(t);
        break;
      }
    }
  }
  for (int e = 0; e < static_cast<int>(adjacency.edges.size()); ++e)
  {
    const MeshEdge& edge = adjacency.edges[e];
    const auto name = [&] { return std::to_string(edge.v0) + "-" + std::to_string(edge.v1); };
    if (edge.triangleCount > 2)
    {
      crowded.add(name);
    }
    else if (edge.triangleCount == 2)
    {
      const auto forward = [&](int t) { return runsAlong(mesh.triangles[t], edge.v0, edge.v1); };
      const int* around = adjacency.trianglesBegin(e);
      if (forward(around[0]) == forward(around[1]))
      {
        turned.add(name);
      }
    }
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (!isOneFan(adjacency, v))
    {
      pinched.addId(v);
    }
  }
  std::string text;
  infinite.report("point that is not finite", "points that are not finite", text);
  degenerate.report("triangle with a point twice", "triangles with a point twice", text);
  flat.report("triangle without area", "triangles without area", text);
  repeated.report("repeated triangle", "repeated triangles", text);
  crowded.report("edge of more than two triangles", "edges of more than two triangles", text);
  turned.report("edge whose triangles face opposite ways", "edges whose triangles face opposite ways", text);
  pinched.report("point where pieces only touch", "points where pieces only touch", text);
  refuseDefects(text);
}

} // namespace oversketch
