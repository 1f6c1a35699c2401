// Boxes of faces in a tree, for whoever looks for faces that may meet.
#ifndef oversketch_kernels_intersection_face_tree_h
#define oversketch_kernels_intersection_face_tree_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <algorithm>
#include <vector>

namespace oversketch
{

struct BoxedFace
{
  int id;
  Eigen::AlignedBox3d box;
};

inline Eigen::AlignedBox3d boxOf(const Mesh& mesh, int face)
{
  const Triangle& t = mesh.triangles[face];
  Eigen::AlignedBox3d box(mesh.points[t[0]]);
  box.extend(mesh.points[t[1]]).extend(mesh.points[t[2]]);
  return box;
}

inline bool boxesMeet(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b)
{
  return (a.min().array() <= b.max().array()).all() && (b.min().array() <= a.max().array()).all();
}

// The tree of boxes that halves its faces in the middle of the longest axis. A node's first child
// follows it.
class FaceTree
{
public:
  struct Node
  {
    Eigen::AlignedBox3d box;
    int begin, end; // faces
    int second;     // -1 in a leaf
  };

  // Sorts the faces, and keeps them by reference.
  FaceTree(std::vector<BoxedFace>& faces, const Context& context)
    : Faces(faces)
  {
    const int count = static_cast<int>(faces.size());
    this->Nodes.resize(static_cast<std::size_t>(nodesOf(count)));
    this->divide(0, 0, count, context);
  }
  const std::vector<Node>& nodes() const { return this->Nodes; }

  // Calls visit(leaf) for each leaf that begins before `end` and whose box meets the box.
  template <class Visit>
  void leavesAt(const Eigen::AlignedBox3d& box, int end, const Visit& visit) const
  {
    int stack[64], size = 0; // depth is that of halving
    stack[size++] = 0;
    while (size)
    {
      const int n = stack[--size];
      const Node& node = this->Nodes[n];
      if (node.begin >= end || !boxesMeet(node.box, box))
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

  // Calls visit(id) for each face whose box meets the box.
  template <class Visit>
  void facesAt(const Eigen::AlignedBox3d& box, const Visit& visit) const
  {
    this->leavesAt(box,
      static_cast<int>(this->Faces.size()),
      [&](const Node& leaf)
      {
        for (int i = leaf.begin; i < leaf.end; ++i)
        {
          if (boxesMeet(this->Faces[i].box, box))
          {
            visit(this->Faces[i].id);
          }
        }
      });
  }

private:
  static constexpr int leafSize = 4, ofThread = 4096; // faces

  static int nodesOf(int faces)
  {
    return faces <= leafSize ? 1 : 1 + nodesOf(faces / 2) + nodesOf(faces - faces / 2);
  }

  // Makes node n and those below it.
  void divide(int n, int begin, int end, const Context& context)
  {
    Node& node = this->Nodes[n];
    node = { {}, begin, end, -1 };
    Eigen::AlignedBox3d centers;
    for (int i = begin; i < end; ++i)
    {
      node.box.extend(this->Faces[i].box);
      centers.extend(this->Faces[i].box.center());
    }
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
      [axis](const BoxedFace& a, const BoxedFace& b)
      {
        const double x = a.box.min()[axis] + a.box.max()[axis], y = b.box.min()[axis] + b.box.max()[axis];
        return x < y || (x == y && a.id < b.id);
      });
    node.second = n + 1 + nodesOf(middle - begin);
    const auto divideHalf = [&](int half)
    {
      half == 0 ? this->divide(n + 1, begin, middle, context)
                : this->divide(node.second, middle, end, context);
    };
    end - begin > ofThread ? context.each(2, divideHalf) : (divideHalf(0), divideHalf(1));
  }

  std::vector<BoxedFace>& Faces;
  std::vector<Node> Nodes;
};

} // namespace oversketch
#endif
