#include "Planar/trim.h"

#include "Planar/face_edges.h"

#include "Mesh/context.h"

namespace oversketch
{

void compact(PlanarMesh& mesh, const std::vector<char>& keptEdges)
{
  const std::vector<int> numbers = dropUnusedPoints(mesh);
  std::vector<StrokeEdge> edges;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i)
  {
    if (keptEdges[i])
    {
      edges.push_back(mesh.edges[i]);
      edges.back().from = numbers[edges.back().from];
      edges.back().to = numbers[edges.back().to];
    }
  }
  mesh.edges = std::move(edges);
}

PlanarMesh withoutRegions(const PlanarMesh& mesh, const std::vector<char>& gone)
{
  std::vector<char> lost(mesh.points.size(), 0);
  PlanarMesh made{ mesh.points, {}, mesh.edges };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const PlanarFace& face = mesh.faces[f];
    const int region = wholeRegion(face.region);
    if (region < 0 || region >= static_cast<int>(gone.size()))
    {
      throw Error(Failure::BadMesh,
        "face %1 lies in region %2 of %3: give the curves that the mesh was made of",
        f,
        face.region,
        gone.size());
    }
    if (!gone[region])
    {
      made.faces.push_back(face);
      continue;
    }
    for (int i = 0; i < face.count(); ++i)
    {
      lost[face.corners[i]] = 1;
    }
  }
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (lost[p] && made.points[p].kind != BoundaryKind::Object)
    {
      made.points[p].kind = BoundaryKind::Hole;
    }
  }
  std::vector<char> onEdge(mesh.edges.size(), 0);
  for (const FaceEdge& edge : faceEdges(mesh).edges)
  {
    for (const int f : edge.faces)
    {
      if (edge.stroke >= 0 && f >= 0 && !gone[wholeRegion(mesh.faces[f].region)])
      {
        onEdge[edge.stroke] = 1;
      }
    }
  }
  compact(made, onEdge);
  return made;
}

} // namespace oversketch
