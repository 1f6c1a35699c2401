#include "Intersection/crossing_faces.h"

#include "Intersection/face_tree.h"
#include "Intersection/sides.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace oversketch
{

namespace
{

// Segments of one plane that are not on one line.
bool segmentsCross(int axis, const Vector3& a, const Vector3& b, const Vector3& p, const Vector3& q)
{
  const int sa = turnOf(axis, p, q, a), sb = turnOf(axis, p, q, b);
  return (sa != 0 || sb != 0) && sa * sb <= 0 && turnOf(axis, a, b, p) * turnOf(axis, a, b, q) <= 0;
}

// A segment in the plane of the triangle. One on the line of an edge that holds the whole edge crosses the
// two others at their ends.
bool meetsInPlane(const Vector3& a, const Vector3& b, const Corners& t)
{
  const int axis = openAxis(t), turn = turnOf(axis, t[0], t[1], t[2]);
  const auto holds = [&](const Vector3& p)
  {
    return turnOf(axis, t[0], t[1], p) * turn >= 0 && turnOf(axis, t[1], t[2], p) * turn >= 0 &&
           turnOf(axis, t[2], t[0], p) * turn >= 0;
  };
  return holds(a) || holds(b) || segmentsCross(axis, a, b, t[0], t[1]) ||
         segmentsCross(axis, a, b, t[1], t[2]) || segmentsCross(axis, a, b, t[2], t[0]);
}

// A segment whose ends are on the given sides of the triangle's plane.
bool segmentMeets(const Vector3& a, const Vector3& b, int sideA, int sideB, const Corners& t)
{
  if (sideA * sideB > 0)
  {
    return false;
  }
  if (sideA == 0 && sideB == 0)
  {
    return meetsInPlane(a, b, t);
  }
  bool left = false, right = false;
  for (int k = 0; k < 3 && !(left && right); ++k)
  {
    const int side = sideOf(a, b, t[k], t[(k + 1) % 3]);
    left |= side > 0;
    right |= side < 0;
  }
  return !(left && right);
}

// The sides of a triangle's corners from `first` on of another's plane.
struct Sides
{
  std::array<int, 3> of{};
  bool apart; // all of those strictly on one side

  Sides(const Corners& t, const Corners& plane, int first)
  {
    for (int k = first; k < 3; ++k)
    {
      this->of[k] = sideOf(plane[0], plane[1], plane[2], t[k]);
    }
    this->apart =
      this->of[1] != 0 && this->of[1] == this->of[2] && (first == 1 || this->of[0] == this->of[1]);
  }
};

// Whether rounded sums show that a plane across the way keeps the triangles apart; any way may be tried. The
// corners of b from `first` on are looked at, those of a likewise, as seen from b[0].
bool keptApart(const Vector3& way, const Corners& a, const Corners& b, int first)
{
  double least = std::numeric_limits<double>::infinity(), most = first == 0 ? 0.0 : -least, size = 0.0;
  for (int k = first; k < 3; ++k)
  {
    const Vector3 toA = a[k] - b[0];
    least = std::min(least, way.dot(toA));
    size = std::max(size, toA.lpNorm<1>());
  }
  for (int k = 1; k < 3; ++k)
  {
    const Vector3 toB = b[k] - b[0];
    most = std::max(most, way.dot(toB));
    size = std::max(size, toB.lpNorm<1>());
  }
  // Each sum is off by less than six roundings of its terms; what is below the smallest normal number decides
  // nothing.
  const double error = 1e-15 * size * way.lpNorm<Eigen::Infinity>() + 1e-290;
  return first == 0 ? least - most > 2.0 * error : least > error && most < -error;
}

// Whether the corners lie on no line. False where one is not finite.
bool hasExactArea(const Corners& t)
{
  return t[0].allFinite() && t[1].allFinite() && t[2].allFinite() && openAxis(t) < 3;
}

// Whether two triangles with area have a point in common.
bool trianglesMeet(const Corners& a, const Corners& b)
{
  const Vector3 way = (a[0] - b[0]) + (a[1] - b[1]) + (a[2] - b[2]);
  if (keptApart(way, a, b, 0))
  {
    return false;
  }
  const Sides sidesA(a, b, 0);
  if (sidesA.apart)
  {
    return false;
  }
  const Sides sidesB(b, a, 0);
  if (sidesB.apart)
  {
    return false;
  }
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    if (segmentMeets(a[k], a[next], sidesA.of[k], sidesA.of[next], b) ||
        segmentMeets(b[k], b[next], sidesB.of[k], sidesB.of[next], a))
    {
      return true;
    }
  }
  return false;
}

// Whether two triangles with area whose corners 0 are the same have another point in common. From the common
// corner each way that both hold leaves one of them first, through its opposite edge.
bool fansMeet(const Corners& a, const Corners& b)
{
  const auto middle = [](const Corners& t) -> Vector3
  { return (t[1] - t[0]).normalized() + (t[2] - t[0]).normalized(); };
  if (keptApart(middle(a) - middle(b), a, b, 1))
  {
    return false;
  }
  const Sides sidesA(a, b, 1);
  if (sidesA.apart)
  {
    return false;
  }
  const Sides sidesB(b, a, 1);
  return !sidesB.apart && (segmentMeets(a[1], a[2], sidesA.of[1], sidesA.of[2], b) ||
                            segmentMeets(b[1], b[2], sidesB.of[1], sidesB.of[2], a));
}

using Box = Eigen::AlignedBox3d;

Corners cornersOf(const Mesh& mesh, int face, int first = 0)
{
  const Triangle& t = mesh.triangles[face];
  return { mesh.points[t[first]], mesh.points[t[(first + 1) % 3]], mesh.points[t[(first + 2) % 3]] };
}

// Whether two faces meet elsewhere than in a common corner.
bool cross(const Mesh& mesh, int a, int b)
{
  const Corners ofA = cornersOf(mesh, a), ofB = cornersOf(mesh, b);
  int common = 0, atA = 0, atB = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (ofA[i] == ofB[k])
      {
        ++common;
        atA = i;
        atB = k;
      }
    }
  }
  return common == 0 ? trianglesMeet(ofA, ofB)
                     : common == 1 && fansMeet(cornersOf(mesh, a, atA), cornersOf(mesh, b, atB));
}

// The axes along which edges are longest and shortest: in boxes along them the needles of a stretched model
// lie beside each other, where along x, y and z each would meet all.
Eigen::Matrix3d axesOf(const Mesh& mesh, const std::vector<BoxedFace>& faces)
{
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const BoxedFace& face : faces)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Triangle& t = mesh.triangles[face.id];
      const Vector3 edge = mesh.points[t[(i + 1) % 3]] - mesh.points[t[i]];
      spread += edge * edge.transpose();
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  return axes.eigenvectors().allFinite() ? Eigen::Matrix3d(axes.eigenvectors().transpose())
                                         : Eigen::Matrix3d::Identity();
}

// A face's box along the axes, larger by what rounding may take from it.
Box boxAlong(const Eigen::Matrix3d& axes, const Mesh& mesh, int face)
{
  Box box;
  for (const int v : mesh.triangles[face])
  {
    const Vector3 corner = axes * mesh.points[v];
    const double size = mesh.points[v].cwiseAbs().maxCoeff();
    const Vector3 error = Vector3::Constant(4e-15 * size + std::numeric_limits<double>::min());
    box.extend(corner - error).extend(corner + error);
  }
  return box;
}

} // namespace

std::vector<FacePair> crossingFaces(const Mesh& mesh,
  const std::vector<char>& changed,
  const Context& context)
{
  const auto isChanged = [&changed](int f) { return changed.empty() || changed[f] != 0; };
  std::vector<BoxedFace> faces; // changed
  Box reach;
  for (int f = 0; f < mesh.triangleCount(); ++f)
  {
    if (isChanged(f) && hasExactArea(cornersOf(mesh, f)))
    {
      faces.push_back({ f, {} });
      reach.extend(boxOf(mesh, f));
    }
  }
  if (faces.empty())
  {
    return {};
  }
  const Eigen::Matrix3d axes = axesOf(mesh, faces);
  const int count = static_cast<int>(faces.size());
  context.each(count, [&](int i) { faces[i].box = boxAlong(axes, mesh, faces[i].id); });
  const FaceTree tree(faces, context);
  context.checkpoint(0.2);
  // Each pair is met once, from the leaf of the one that comes last. An unchanged face is a leaf behind all.
  const auto findPairs = [&](const FaceTree::Node& leaf, const BoxedFace* own, std::vector<FacePair>& pairs)
  {
    const auto visit = [&](const FaceTree::Node& other)
    {
      for (int i = leaf.begin; i < leaf.end; ++i)
      {
        for (int k = other.begin; k < std::min(i, other.end); ++k)
        {
          const BoxedFace &a = own[i - leaf.begin], &b = faces[k];
          if (boxesMeet(a.box, b.box) && cross(mesh, a.id, b.id))
          {
            pairs.push_back({ std::min(a.id, b.id), std::max(a.id, b.id) });
          }
        }
      }
    };
    tree.leavesAt(leaf.box, leaf.end, visit);
  };
  constexpr int ofPart = 1024; // unchanged faces that a thread takes at a time
  const int nodes = static_cast<int>(tree.nodes().size());
  const int parts = changed.empty() ? 0 : (mesh.triangleCount() + ofPart - 1) / ofPart;
  std::vector<std::vector<FacePair>> found(static_cast<std::size_t>(nodes + parts));
  context.eachUntilCancelled(nodes + parts,
    [&](int n)
    {
      if (n < nodes)
      {
        const FaceTree::Node& node = tree.nodes()[n];
        if (node.second < 0)
        {
          findPairs(node, faces.data() + node.begin, found[n]);
        }
        return;
      }
      const int first = (n - nodes) * ofPart, end = std::min(first + ofPart, mesh.triangleCount());
      for (int f = first; f < end; ++f)
      {
        if (!isChanged(f) && boxesMeet(boxOf(mesh, f), reach) && hasExactArea(cornersOf(mesh, f)))
        {
          const BoxedFace face{ f, boxAlong(axes, mesh, f) };
          findPairs({ face.box, count, count + 1, -1 }, &face, found[n]);
        }
      }
    });
  context.checkpoint(1.0);
  std::vector<FacePair> pairs;
  for (const std::vector<FacePair>& some : found)
  {
    pairs.insert(pairs.end(), some.begin(), some.end());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace oversketch
