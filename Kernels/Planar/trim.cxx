#include "Planar/trim.h"

#include "Planar/face_edges.h"

#include "Mesh/context.h"

#include <string>

namespace oversketch
{

std::vector<char> regionsInHoles(const Classification& classification,
  const std::vector<Treatment>& treatments)
{
  const std::vector<Region>& regions = classification.regions;
  std::vector<char> gone(regions.size(), 0);
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    // Treatments of what bounds an object do not matter.
    gone[r] = regions[r].parent >= 0 && treatments[regions[r].stroke] == Treatment::Hole;
  }
  return gone;
}

PlanarMesh withoutRegions(const PlanarMesh& mesh, const std::vector<char>& gone)
{
  std::vector<char> kept(mesh.points.size(), 0), lost(mesh.points.size(), 0);
  PlanarMesh made;
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
    for (int i = 0; i < face.count(); ++i)
    {
      (gone[region] ? lost : kept)[face.corners[i]] = 1;
    }
    if (!gone[region])
    {
      made.faces.push_back(face);
    }
  }
  std::vector<int> number(mesh.points.size(), -1);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (kept[p])
    {
      number[p] = static_cast<int>(made.points.size());
      made.points.push_back(mesh.points[p]);
      BoundaryKind& kind = made.points.back().kind;
      kind = lost[p] && kind != BoundaryKind::Object ? BoundaryKind::Hole : kind;
    }
  }
  for (PlanarFace& face : made.faces)
  {
    for (int i = 0; i < face.count(); ++i)
    {
      face.corners[i] = number[face.corners[i]];
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
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
  {
    if (onEdge[e])
    {
      made.edges.push_back(mesh.edges[e]);
      made.edges.back().from = number[mesh.edges[e].from];
      made.edges.back().to = number[mesh.edges[e].to];
    }
  }
  return made;
}

} // namespace oversketch
