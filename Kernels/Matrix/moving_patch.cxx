#include "Matrix/moving_patch.h"

#include "Mesh/clones.h"
#include "Mesh/context.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double foldCosine = -0.5; // of 120 degrees

// Ascending, each once; of ids below a count.
class Ids
{
public:
  explicit Ids(std::size_t count)
    : Chosen(count, 0)
  {
  }
  template <typename Iterator>
  void add(Iterator begin, Iterator end)
  {
    for (; begin != end; ++begin)
    {
      this->Chosen[*begin] = 1;
    }
  }
  std::vector<int> list() const { return marked(this->Chosen); }

private:
  std::vector<char> Chosen;
};

std::vector<int> facesAround(const Mesh& mesh, const Adjacency& adjacency, const std::vector<int>& vertices)
{
  Ids faces(mesh.triangles.size());
  for (const int v : vertices)
  {
    faces.add(adjacency.vertexTriangles.begin(v), adjacency.vertexTriangles.end(v));
  }
  return faces.list();
}

// With some others.
std::vector<int> cornersOf(const Mesh& mesh,
  const std::vector<int>& faces,
  const std::vector<int>& others = {})
{
  Ids vertices(mesh.points.size());
  for (const int t : faces)
  {
    vertices.add(mesh.triangles[t].begin(), mesh.triangles[t].end());
  }
  vertices.add(others.begin(), others.end());
  return vertices.list();
}

constexpr int faceLanes = 32; // see moved.cxx

// Triangles side by side.
struct FaceBatch
{
  double corner[3][3][faceLanes]; // by corner and coordinate
  double normal[3][faceLanes];
  double angle[3][faceLanes];
};

// Normals and angles. An angle is the arc tangent of twice the area over the product of the two sides along
// each other; by S. Moshier's rational function (Cephes, atan.c), which is exact to the last bit or two.
OVERSKETCH_CLONES void measure(FaceBatch& batch)
{
  const auto& c = batch.corner;
  for (int i = 0; i < faceLanes; ++i)
  {
    double side[3][3]; // from corner k to the next
    for (int k = 0; k < 3; ++k)
    {
      for (int r = 0; r < 3; ++r)
      {
        side[k][r] = c[k == 2 ? 0 : k + 1][r][i] - c[k][r][i];
      }
    }
    const double x = side[2][1] * side[0][2] - side[2][2] * side[0][1],
                 y = side[2][2] * side[0][0] - side[2][0] * side[0][2],
                 z = side[2][0] * side[0][1] - side[2][1] * side[0][0];
    const double area = std::sqrt(x * x + y * y + z * z);
    const double unit = 1.0 / (area > 0.0 ? area : 1.0); // no branch, which would keep it from registers
    batch.normal[0][i] = x * unit;
    batch.normal[1][i] = y * unit;
    batch.normal[2][i] = z * unit;
    for (int k = 0; k < 3; ++k)
    {
      const double* out = side[k];
      const double* in = side[k == 0 ? 2 : k - 1];
      const double along = -(out[0] * in[0] + out[1] * in[1] + out[2] * in[2]);
      const double flat = std::abs(along), large = std::max(flat, area), small = std::min(flat, area);
      const double slope = small / (large > 0.0 ? large : 1.0), tilted = (slope - 1.0) / (slope + 1.0);
      const bool steep = slope > 0.66;
      const double t = steep ? tilted : slope, t2 = t * t;
      const double p =
        (((-8.750608600031904122785e-1 * t2 - 1.615753718733365076637e1) * t2 - 7.500855792314704667340e1) *
            t2 -
          1.228866684490136173410e2) *
          t2 -
        6.485021904942025371773e1;
      const double q = ((((t2 + 2.485846490142306297962e1) * t2 + 1.650270098316988542046e2) * t2 +
                          4.328810604912902668951e2) *
                           t2 +
                         4.853903996359136964868e2) *
                         t2 +
                       1.945506571482613964425e2;
      const double arc = (steep ? M_PI_4 : 0.0) + t + t * t2 * p / q;
      const double quadrant = area > flat ? M_PI_2 - arc : arc;
      batch.angle[k][i] = along < 0.0 ? M_PI - quadrant : quadrant;
    }
  }
}

} // namespace

// Lists of faces ascend with the mesh's, so that sums over a vertex's faces have the mesh's order.
MovingPatch::MovingPatch(const Mesh& mesh, const Adjacency& adjacency, const std::vector<int>& moving)
  : Moving(moving)
  , Rest(valuesAt(mesh.points, moving))
  , Faces(facesAround(mesh, adjacency, moving))
  , Touched(cornersOf(mesh, this->Faces))
{
  const std::vector<int> near = facesAround(mesh, adjacency, this->Touched);
  const std::vector<int> corners = cornersOf(mesh, near, moving); // with those without faces
  const std::vector<int> vertexPlace = placesIn(corners, mesh.points.size()),
                         facePlace = placesIn(near, mesh.triangles.size());
  this->Near.points = valuesAt(mesh.points, corners);
  for (const int t : near)
  {
    const Triangle& c = mesh.triangles[t];
    this->Near.triangles.push_back({ vertexPlace[c[0]], vertexPlace[c[1]], vertexPlace[c[2]] });
  }
  this->MovingPlaces = valuesAt(vertexPlace, moving);
  this->TouchedPlaces = valuesAt(vertexPlace, this->Touched);
  this->FacePlaces = valuesAt(facePlace, this->Faces);

  const Lists around = trianglesAround(this->Near);
  this->Corners.offsets.push_back(0);
  for (const int v : this->TouchedPlaces)
  {
    for (const int t : around[v])
    {
      for (int k = 0; k < 3; ++k)
      {
        if (this->Near.triangles[t][k] == v)
        {
          this->Corners.values.push_back(3 * t + k);
        }
      }
    }
    this->Corners.offsets.push_back(static_cast<int>(this->Corners.values.size()));
  }

  Ids joints(adjacency.edges.size());
  for (const int t : this->Faces)
  {
    for (const int e : adjacency.triangleEdges[t])
    {
      if (e >= 0 && adjacency.edges[e].triangleCount == 2)
      {
        joints.add(&e, &e + 1);
      }
    }
  }
  const std::vector<Vector3>& before = this->measured(Context()).normals;
  for (const int e : joints.list())
  {
    const int* sides = adjacency.trianglesBegin(e);
    const std::array<int, 2> places{ facePlace[sides[0]], facePlace[sides[1]] };
    if (before[places[0]].dot(before[places[1]]) >= foldCosine)
    {
      this->Joints.push_back(places);
    }
  }
}

// Into the same room each time: to ask for as much anew at each event of a drag takes as long as a pass over
// it.
const MovingPatch::Measures& MovingPatch::measured(const Context& context)
{
  const int count = this->Near.triangleCount();
  Measures& measures = this->Measured;
  measures.normals.resize(this->Near.triangles.size());
  measures.angles.resize(this->Near.triangles.size());
  context.parallelFor((count + faceLanes - 1) / faceLanes,
    [&](int begin, int end)
    {
      FaceBatch batch;
      for (int first = begin * faceLanes; first < std::min(end * faceLanes, count) && !context.cancelled();
           first += faceLanes)
      {
        for (int i = 0; i < faceLanes; ++i)
        {
          // The last lanes of the last batch repeat its last face.
          const Triangle& corners = this->Near.triangles[std::min(first + i, count - 1)];
          for (int k = 0; k < 3; ++k)
          {
            for (int r = 0; r < 3; ++r)
            {
              batch.corner[k][r][i] = this->Near.points[corners[k]][r];
            }
          }
        }
        measure(batch);
        for (int i = 0; i < faceLanes && first + i < count; ++i)
        {
          measures.normals[first + i] = { batch.normal[0][i], batch.normal[1][i], batch.normal[2][i] };
          measures.angles[first + i] = { batch.angle[0][i], batch.angle[1][i], batch.angle[2][i] };
        }
      }
    });
  return measures;
}

MovingPatch::Shape MovingPatch::shapeAt(const std::vector<Vector3>& places,
  Normals normals,
  const Context& context)
{
  std::vector<char> moved(this->Near.points.size(), 0), touched(this->Near.points.size(), 0);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    this->Near.points[this->MovingPlaces[i]] = places[i];
    moved[this->MovingPlaces[i]] = places[i] != this->Rest[i];
  }
  const Measures& measures = this->measured(context);
  Shape shape;
  const bool faces = normals == Normals::OfFaces || normals == Normals::OfBoth;
  shape.faceNormals.reserve(faces ? this->Faces.size() : 0);
  for (std::size_t i = 0; i < this->FacePlaces.size(); ++i)
  {
    const Triangle& c = this->Near.triangles[this->FacePlaces[i]];
    if (moved[c[0]] || moved[c[1]] || moved[c[2]])
    {
      touched[c[0]] = touched[c[1]] = touched[c[2]] = 1;
      if (faces)
      {
        shape.faceNormals.emplace_back(this->Faces[i], measures.normals[this->FacePlaces[i]]);
      }
    }
  }
  for (const std::array<int, 2>& joint : this->Joints)
  {
    shape.foldedEdges += measures.normals[joint[0]].dot(measures.normals[joint[1]]) < foldCosine ? 1 : 0;
  }
  if (normals == Normals::OfVertices || normals == Normals::OfBoth)
  {
    std::vector<int> changed; // of the touched ones
    changed.reserve(this->Touched.size());
    shape.vertexNormals.reserve(this->Touched.size());
    for (int i = 0; i < static_cast<int>(this->TouchedPlaces.size()); ++i)
    {
      if (touched[this->TouchedPlaces[i]])
      {
        changed.push_back(i);
        shape.vertexNormals.emplace_back(this->Touched[i], Vector3::Zero());
      }
    }
    context.each(static_cast<int>(shape.vertexNormals.size()),
      [&](int n)
      {
        Vector3 sum = Vector3::Zero();
        for (const int corner : this->Corners[changed[n]])
        {
          sum += measures.angles[corner / 3][corner % 3] * measures.normals[corner / 3];
        }
        const double length = sum.norm();
        shape.vertexNormals[n].second = length > 0.0 ? Vector3(sum / length) : Vector3(Vector3::Zero());
      });
  }
  context.checkpoint(1.0);
  return shape;
}

} // namespace oversketch
