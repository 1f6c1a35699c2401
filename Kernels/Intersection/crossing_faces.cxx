#include "Intersection/crossing_faces.h"

#include "Intersection/exact_triangles.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace oversketch
{

namespace
{

using Box = Eigen::AlignedBox3d;

bool meet(const Box& a, const Box& b)
{
  return (a.min().array() <= b.max().array()).all() && (b.min().array() <= a.max().array()).all();
}

struct Face
{
  int id;
  Box box;
};

// The tree of boxes that halves its faces in the middle of the longest axis. A node's first child
// follows it.
class FaceTree
{
public:
  struct Node
  {
    Box box;
    int begin, end; // faces
    int second;     // -1 in a leaf
  };

  explicit FaceTree(std::vector<Face>& faces)
    : Faces(faces)
  {
    this->Nodes.reserve(faces.size() / 2 + 1);
    this->divide(0, static_cast<int>(faces.size()));
  }
  const std::vector<Node>& nodes() const { return this->Nodes; }

  // Calls visit(other) for the leaf and those before it whose boxes meet its own.
  template <class Visit>
  void leavesAt(const Node& leaf, const Visit& visit) const
  {
    int stack[64], size = 0; // depth is that of halving
    stack[size++] = 0;
    while (size)
    {
      const int n = stack[--size];
      const Node& node = this->Nodes[n];
      if (node.begin >= leaf.end || !meet(node.box, leaf.box))
      {
        continue;
      }
      if (node.second < 0)
      {
        visit(node);
        continue;
      }
      stack[size++] = node.second;
      stack[size++] = n + 1;
    }
  }

private:
  static constexpr int leafSize = 4;

  void divide(int begin, int end)
  {
    const int n = static_cast<int>(this->Nodes.size());
    Node node{ {}, begin, end, -1 };
    Box centers;
    for (int i = begin; i < end; ++i)
    {
      node.box.extend(this->Faces[i].box);
      centers.extend(this->Faces[i].box.center());
    }
    this->Nodes.push_back(node);
    if (end - begin <= leafSize)
    {
      return;
    }
    int axis = 0;
    centers.sizes().maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    const auto first = this->Faces.begin();
    std::nth_element(first + begin,
      first + middle,
      first + end,
      [axis](const Face& a, const Face& b)
      {
        const double x = a.box.min()[axis] + a.box.max()[axis], y = b.box.min()[axis] + b.box.max()[axis];
        return x < y || (x == y && a.id < b.id);
      });
    this->divide(begin, middle);
    this->Nodes[n].second = static_cast<int>(this->Nodes.size());
    this->divide(middle, end);
  }

  std::vector<Face>& Faces;
  std::vector<Node> Nodes;
};

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

Box boxOf(const Mesh& mesh, int face)
{
  const Triangle& t = mesh.triangles[face];
  Box box(mesh.points[t[0]]);
  box.extend(mesh.points[t[1]]).extend(mesh.points[t[2]]);
  return box;
}

// The axes along which edges are longest and shortest: in boxes along them the needles of a stretched model
// lie beside each other, where along x, y and z each would meet all.
Eigen::Matrix3d axesOf(const Mesh& mesh, const std::vector<Face>& faces)
{
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Face& face : faces)
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
  std::vector<Face> faces; // changed
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
  const FaceTree tree(faces);
  context.checkpoint(0.2);
  // Each pair is met once, from the leaf of the one that comes last. An unchanged face is a leaf behind all.
  const auto findPairs = [&](const FaceTree::Node& leaf, const Face* own, std::vector<FacePair>& pairs)
  {
    const auto visit = [&](const FaceTree::Node& other)
    {
      for (int i = leaf.begin; i < leaf.end; ++i)
      {
        for (int k = other.begin; k < std::min(i, other.end); ++k)
        {
          const Face &a = own[i - leaf.begin], &b = faces[k];
          if (meet(a.box, b.box) && cross(mesh, a.id, b.id))
          {
            pairs.push_back({ std::min(a.id, b.id), std::max(a.id, b.id) });
          }
        }
      }
    };
    tree.leavesAt(leaf, visit);
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
        if (!isChanged(f) && meet(boxOf(mesh, f), reach) && hasExactArea(cornersOf(mesh, f)))
        {
          const Face face{ f, boxAlong(axes, mesh, f) };
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
