#include "Planar/face_edges.h"
#include "Planar/refine.h"

#include <algorithm>

namespace oversketch
{

namespace
{

// Cuts the corner after each of these new points, in the middle of a face's edges, off: what is left has as
// many corners as the face. A new point's other edges end inside the face's own edges or at a corner across:
// no chord is among them.
void cutFace(const PlanarFace& face, const std::array<int, 4>& middles, std::vector<PlanarFace>& faces)
{
  std::vector<int> around;
  for (int i = 0; i < face.count(); ++i)
  {
    around.push_back(face.corners[i]);
    if (middles[i] >= 0)
    {
      around.push_back(middles[i]);
    }
  }
  PlanarFace part = face;
  for (int i = 0; i < face.count(); ++i)
  {
    if (middles[i] < 0)
    {
      continue;
    }
    const int count = static_cast<int>(around.size());
    const int at = static_cast<int>(std::find(around.begin(), around.end(), middles[i]) - around.begin());
    const int corner = (at + 1) % count;
    part.corners = { middles[i], around[corner], around[(at + 2) % count], -1 };
    faces.push_back(part);
    around.erase(around.begin() + corner);
  }
  part.corners = { -1, -1, -1, -1 };
  std::copy(around.begin(), around.end(), part.corners.begin());
  faces.push_back(part);
}

} // namespace

PlanarMesh splitChords(const PlanarMesh& mesh)
{
  const FaceEdges links = faceEdges(mesh);
  PlanarMesh made;
  made.points = mesh.points;
  made.edges = mesh.edges;
  std::vector<int> middles(links.edges.size(), -1);
  for (std::size_t e = 0; e < links.edges.size(); ++e)
  {
    const FaceEdge& edge = links.edges[e];
    const PlanarPoint &from = mesh.points[edge.from], &to = mesh.points[edge.to];
    if (edge.stroke < 0 && isRim(from.kind) && isRim(to.kind))
    {
      middles[e] = static_cast<int>(made.points.size());
      PlanarPoint middle;
      middle.place = 0.5 * (from.place + to.place);
      middle.isBase = true;
      made.points.push_back(middle);
    }
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    std::array<int, 4> ofFace{ -1, -1, -1, -1 };
    for (int i = 0; i < mesh.faces[f].count(); ++i)
    {
      ofFace[i] = middles[links.ofFace[f][i]];
    }
    cutFace(mesh.faces[f], ofFace, made.faces);
  }
  return made;
}

} // namespace oversketch
