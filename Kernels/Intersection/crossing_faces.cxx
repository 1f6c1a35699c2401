#include "Intersection/crossing_faces.h"

#include "Intersection/exact_triangles.h"
#include "Mesh/weld.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>

namespace oversketch
{

namespace
{

using Box = Eigen::AlignedBox3d;

bool meet(const Box& a, const Box& b)
{
  return (a.min().array() <= b.max().array()).all() && (b.min().array() <= a.max().array()).all();
}

// A face as it stands in the tree.
struct Face
{
  int id;
  bool changed;
  Triangle vertices; // welded
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
    bool changed;
  };

  explicit FaceTree(std::vector<Face>& faces)
    : Faces(faces)
  {
    this->Nodes.reserve(faces.size() / 2 + 1);
    this->divide(0, static_cast<int>(faces.size()));
  }
  const std::vector<Node>& nodes() const { return this->Nodes; }

  // Calls visit(other) for the leaf and those after it whose boxes meet its own; where neither holds a
  // changed face for none.
  template <class Visit>
  void leavesAt(const Node& leaf, const Visit& visit) const
  {
    int stack[64], size = 0; // depth is that of halving
    stack[size++] = 0;
    while (size)
    {
      const int n = stack[--size];
      const Node& node = this->Nodes[n];
      if (node.end <= leaf.begin || !(leaf.changed || node.changed) || !meet(node.box, leaf.box))
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
    Node node{ {}, begin, end, -1, false };
    Box centers;
    for (int i = begin; i < end; ++i)
    {
      node.box.extend(this->Faces[i].box);
      node.changed |= this->Faces[i].changed;
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

// Whether two faces meet elsewhere than in a common corner.
bool cross(const Mesh& mesh, const Face& a, const Face& b)
{
  int common = 0, atA = 0, atB = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (a.vertices[i] == b.vertices[k])
      {
        ++common;
        atA = i;
        atB = k;
      }
    }
  }
  const auto cornersFrom = [&mesh](const Face& face, int first) -> Corners
  {
    const Triangle& t = mesh.triangles[face.id];
    return { mesh.points[t[first]], mesh.points[t[(first + 1) % 3]], mesh.points[t[(first + 2) % 3]] };
  };
  return common < 2 && (common ? fansMeet : trianglesMeet)(cornersFrom(a, atA), cornersFrom(b, atB));
}

Box boxOf(const Mesh& mesh, const Triangle& t)
{
  Box box(mesh.points[t[0]]);
  box.extend(mesh.points[t[1]]).extend(mesh.points[t[2]]);
  return box;
}

// Corners at equal places become one.
void weld(const Mesh& mesh, std::vector<Face>& faces)
{
  std::vector<int> number(mesh.points.size(), -1);
  std::vector<Vector3> points;
  for (Face& face : faces)
  {
    for (int& v : face.vertices)
    {
      if (number[v] < 0)
      {
        number[v] = static_cast<int>(points.size());
        points.push_back(mesh.points[v]);
      }
      v = number[v];
    }
  }
  const std::vector<int> vertices = weldPoints(points);
  for (Face& face : faces)
  {
    for (int& v : face.vertices)
    {
      v = vertices.empty() ? v : vertices[v];
    }
  }
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

// Puts each face's box along the axes, larger by what rounding may take from it.
void alignBoxes(const Mesh& mesh, std::vector<Face>& faces)
{
  Box whole;
  for (const Face& face : faces)
  {
    whole.extend(face.box);
  }
  const double size = whole.min().cwiseAbs().cwiseMax(whole.max().cwiseAbs()).maxCoeff();
  const Eigen::Matrix3d axes = axesOf(mesh, faces);
  const Vector3 error = Vector3::Constant(4e-15 * size);
  for (Face& face : faces)
  {
    face.box.setEmpty();
    for (const int v : mesh.triangles[face.id])
    {
      const Vector3 corner = axes * mesh.points[v];
      face.box.extend(corner - error).extend(corner + error);
    }
  }
}

// The faces that can be in a pair: with area, and near a changed one.
std::vector<Face> facesToTry(const Mesh& mesh, const std::vector<char>& changed)
{
  const auto isChanged = [&changed](int f) { return changed.empty() || changed[f] != 0; };
  Box reach;
  for (int f = 0; f < mesh.triangleCount(); ++f)
  {
    const Box box = isChanged(f) ? boxOf(mesh, mesh.triangles[f]) : Box();
    if (box.min().allFinite() && box.max().allFinite())
    {
      reach.extend(box);
    }
  }
  std::vector<Face> faces;
  for (int f = 0; f < mesh.triangleCount(); ++f)
  {
    const Triangle& t = mesh.triangles[f];
    const Box box = boxOf(mesh, t);
    if (meet(box, reach) && hasExactArea({ mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]] }))
    {
      faces.push_back({ f, isChanged(f), t, box });
    }
  }
  alignBoxes(mesh, faces);
  weld(mesh, faces);
  return faces;
}

} // namespace

std::vector<FacePair> crossingFaces(const Mesh& mesh,
  const std::vector<char>& changed,
  const Context& context)
{
  std::vector<Face> faces = facesToTry(mesh, changed);
  if (faces.empty())
  {
    return {};
  }
  const FaceTree tree(faces);
  context.checkpoint(0.2);
  // Each pair is met once, from the leaf of the one that comes first.
  std::vector<std::vector<FacePair>> found(tree.nodes().size());
  context.eachUntilCancelled(static_cast<int>(tree.nodes().size()),
    [&](int n)
    {
      const FaceTree::Node& leaf = tree.nodes()[n];
      if (leaf.second >= 0)
      {
        return;
      }
      const auto visit = [&](const FaceTree::Node& other)
      {
        for (int i = leaf.begin; i < leaf.end; ++i)
        {
          for (int k = std::max(i + 1, other.begin); k < other.end; ++k)
          {
            const Face &a = faces[i], &b = faces[k];
            if ((a.changed || b.changed) && meet(a.box, b.box) && cross(mesh, a, b))
            {
              found[n].push_back({ std::min(a.id, b.id), std::max(a.id, b.id) });
            }
          }
        }
      };
      tree.leavesAt(leaf, visit);
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
