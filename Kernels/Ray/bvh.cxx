#include "Ray/bvh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace oversketch
{

namespace
{

constexpr int binCount = 16;
// Deeper than this the heuristic gives way to halving, which bounds the depth for any input.
constexpr int heuristicDepth = 20;
constexpr int usualLeaf = 5;       // triangles, or a little more
constexpr float boxMargin = 1e-6f; // the scene's half width is 1
constexpr float far = std::numeric_limits<float>::max();

using Quad = float __attribute__((vector_size(16)));

inline Quad lesser(const Quad& a, const Quad& b)
{
  return a < b ? a : b;
}

inline Quad greater(const Quad& a, const Quad& b)
{
  return a > b ? a : b;
}

struct Box
{
  Quad low = { far, far, far, far }, high = { -far, -far, -far, -far };

  void add(const Box& other)
  {
    this->low = lesser(this->low, other.low);
    this->high = greater(this->high, other.high);
  }
  void add(const Quad& point)
  {
    this->low = lesser(this->low, point);
    this->high = greater(this->high, point);
  }
  float area() const
  {
    const Quad size = this->high - this->low;
    return size[0] < 0.0f ? 0.0f : size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
};

struct Prim
{
  Box box;
  // Twice the centre; its last component holds the triangle's id, bit by bit.
  Quad centre;
  int triangle() const
  {
    int id;
    const float bits = this->centre[3];
    std::memcpy(&id, &bits, sizeof id);
    return id;
  }
};

// A run of primitives, their bounds and their centres'.
struct Range
{
  int begin, end, depth;
  Box box, centres;
  int count() const { return this->end - this->begin; }
};

// Where a subtree's nodes and leaves are written; joined when all are there.
struct Part
{
  std::vector<Bvh::Node> nodes;
  std::vector<Bvh::Pack> packs;
  int stackSize = 1;
};

class Builder
{
public:
  Builder(const RayScene& scene, const Context& context)
    : Scene(scene)
    , Caller(context)
    , Prims(scene.facets.size())
  {
    context.each(static_cast<int>(this->Prims.size()),
      [&](int t)
      {
        Prim& prim = this->Prims[t];
        prim.box = Box();
        for (const int v : scene.facets[t].places)
        {
          Quad point;
          std::memcpy(&point, scene.points[v].data(), sizeof point);
          prim.box.add(point);
        }
        prim.centre = prim.box.low + prim.box.high;
        float bits;
        std::memcpy(&bits, &t, sizeof bits);
        prim.centre[3] = bits;
      });
  }

  Bvh build()
  {
    Range whole{ 0, static_cast<int>(this->Prims.size()), 0, {}, {} };
    for (const Prim& prim : this->Prims)
    {
      whole.box.add(prim.box);
      whole.centres.add(prim.centre);
    }
    // Two levels of nodes, then every subtree on its own.
    Part top;
    std::vector<Range> second, third;
    std::vector<int> secondSlots, thirdSlots; // 8 * node + child
    this->expand(top, whole, second, secondSlots);
    const int firstCount = static_cast<int>(second.size());
    std::vector<Part> halves(firstCount);
    std::vector<std::vector<Range>> halfRanges(firstCount);
    std::vector<std::vector<int>> halfSlots(firstCount);
    this->Caller.eachUntilCancelled(
      firstCount, [&](int i) { this->expand(halves[i], second[i], halfRanges[i], halfSlots[i]); });
    this->Caller.checkpoint(0.0);
    for (int i = 0; i < firstCount; ++i)
    {
      const int node = append(top, halves[i]);
      top.nodes[secondSlots[i] / Bvh::width].child[secondSlots[i] % Bvh::width] = node;
      for (std::size_t k = 0; k < halfRanges[i].size(); ++k)
      {
        third.push_back(halfRanges[i][k]);
        thirdSlots.push_back(halfSlots[i][k] + Bvh::width * node);
      }
    }
    const int partCount = static_cast<int>(third.size());
    std::vector<Part> parts(partCount);
    this->Caller.eachUntilCancelled(partCount,
      [&](int i)
      {
        parts[i].packs.reserve(third[i].count() / usualLeaf);
        this->subtree(parts[i], third[i]);
      });
    this->Caller.checkpoint(0.0);
    return this->join(top, parts, thirdSlots);
  }

private:
  // Adds a node over the range; its children that are no leaves go to `open` with their places in the node.
  void expand(Part& part, const Range& range, std::vector<Range>& open, std::vector<int>& slots)
  {
    Range children[Bvh::width] = { range };
    int count = 1;
    while (count < Bvh::width)
    {
      // Part the largest of those too large for a leaf.
      int widest = -1;
      float area = -1.0f;
      for (int i = 0; i < count; ++i)
      {
        if (children[i].count() > Bvh::width && children[i].box.area() > area)
        {
          widest = i;
          area = children[i].box.area();
        }
      }
      if (widest < 0)
      {
        break;
      }
      this->split(children[widest], children[widest], children[count++]);
    }
    const int id = static_cast<int>(part.nodes.size());
    part.nodes.emplace_back();
    for (int i = 0; i < Bvh::width; ++i)
    {
      const bool present = i < count && children[i].count() > 0;
      const Box box = present ? children[i].box : Box();
      Bvh::Node& node = part.nodes[id];
      for (int k = 0; k < 3; ++k)
      {
        // The triangle test rounds coordinates on its own; a hit that it finds must lie in the box all the
        // same.
        node.lower[k][i] = present ? box.low[k] - boxMargin : 1.0f;
        node.upper[k][i] = present ? box.high[k] + boxMargin : -1.0f;
        node.normalLower[k][i] = 127; // neutral for the bounds above
        node.normalUpper[k][i] = -128;
      }
      node.child[i] = -1;
      if (present && children[i].count() <= Bvh::width)
      {
        this->writeLeaf(part, id, i, children[i]);
      }
      else if (present)
      {
        open.push_back(children[i]);
        slots.push_back(Bvh::width * id + i);
      }
    }
    std::memset(part.nodes[id].padding, 0, sizeof part.nodes[id].padding);
  }

  // The whole subtree of a range, its root first.
  void subtree(Part& part, const Range& range)
  {
    std::vector<Range> open;
    std::vector<int> slots;
    this->expand(part, range, open, slots);
    for (std::size_t i = 0; i < open.size() && !this->Caller.cancelled(); ++i)
    {
      part.nodes[slots[i] / Bvh::width].child[slots[i] % Bvh::width] = static_cast<int>(part.nodes.size());
      this->subtree(part, open[i]);
    }
  }

  // Parts a range where the heuristic is least, or in the middle where it finds nothing. `range` may be
  // `left`.
  void split(Range range, Range& left, Range& right)
  {
    left = right = { range.begin, range.end, range.depth + 1, {}, {} };
    const Quad extent = range.centres.high - range.centres.low;
    const int bins = std::min(binCount, 4 + range.count() / 4);
    Quad scale;
    for (int k = 0; k < 4; ++k)
    {
      scale[k] = k < 3 && extent[k] > 0.0f ? 0.999f * static_cast<float>(bins) / extent[k] : 0.0f;
    }
    int axis = -1, bin = 0;
    if (range.depth < heuristicDepth)
    {
      this->bestSplit(range, scale, bins, axis, bin);
    }
    Prim* const begin = this->Prims.data() + range.begin;
    Prim* const end = this->Prims.data() + range.end;
    Prim* middle;
    if (axis >= 0)
    {
      const float low = range.centres.low[axis], factor = scale[axis];
      middle = begin;
      for (Prim *from = begin, *to = end;;)
      {
        const auto onLeft = [=](const Prim& p)
        { return static_cast<int>((p.centre[axis] - low) * factor) < bin; };
        while (from < to && onLeft(*from))
        {
          left.box.add(from->box);
          left.centres.add(from->centre);
          ++from;
        }
        while (from < to && !onLeft(to[-1]))
        {
          --to;
          right.box.add(to->box);
          right.centres.add(to->centre);
        }
        if (from >= to)
        {
          middle = from;
          break;
        }
        std::swap(*from, to[-1]);
      }
    }
    else
    {
      int longest = 0;
      for (int k = 1; k < 3; ++k)
      {
        longest = extent[k] > extent[longest] ? k : longest;
      }
      middle = begin + range.count() / 2;
      std::nth_element(begin,
        middle,
        end,
        [=](const Prim& a, const Prim& b)
        {
          return a.centre[longest] != b.centre[longest] ? a.centre[longest] < b.centre[longest]
                                                        : a.triangle() < b.triangle();
        });
      for (const Prim* p = begin; p != end; ++p)
      {
        Range& side = p < middle ? left : right;
        side.box.add(p->box);
        side.centres.add(p->centre);
      }
    }
    left.end = right.begin = static_cast<int>(middle - this->Prims.data());
  }

  void bestSplit(const Range& range, const Quad& scale, int bins, int& axis, int& bin) const
  {
    Box boxes[3][binCount];
    int counts[3][binCount] = {};
    for (int i = range.begin; i < range.end; ++i)
    {
      const Prim& prim = this->Prims[i];
      const Quad along = (prim.centre - range.centres.low) * scale;
      for (int k = 0; k < 3; ++k)
      {
        const int b = static_cast<int>(along[k]);
        boxes[k][b].add(prim.box);
        ++counts[k][b];
      }
    }
    float best = far;
    for (int k = 0; k < 3; ++k)
    {
      if (!(scale[k] > 0.0f))
      {
        continue;
      }
      float rightCost[binCount];
      Box side;
      int count = 0;
      for (int b = bins - 1; b > 0; --b)
      {
        side.add(boxes[k][b]);
        count += counts[k][b];
        rightCost[b] = side.area() * blocks(count);
      }
      side = Box();
      count = 0;
      for (int b = 1; b < bins; ++b)
      {
        side.add(boxes[k][b - 1]);
        count += counts[k][b - 1];
        const float cost = side.area() * blocks(count) + rightCost[b];
        if (count > 0 && count < range.count() && cost < best)
        {
          best = cost;
          axis = k;
          bin = b;
        }
      }
    }
  }

  // A leaf costs the same however many of its lanes are used; half of them is what is reached on average.
  static float blocks(int count)
  {
    const int packs = (count + 3) / 4;
    return static_cast<float>(packs);
  }

  void writeLeaf(Part& part, int node, int child, const Range& range)
  {
    part.packs.emplace_back();
    Bvh::Pack& pack = part.packs.back();
    std::memset(pack.corner, 0, sizeof pack.corner);
    float low[3] = { 1.0f, 1.0f, 1.0f }, high[3] = { -1.0f, -1.0f, -1.0f };
    for (int i = 0; i < Bvh::width; ++i)
    {
      pack.triangle[i] = i < range.count() ? this->Prims[range.begin + i].triangle() : -1;
      if (i < range.count())
      {
        const RayFacet& facet = this->Scene.facets[pack.triangle[i]];
        for (int k = 0; k < 3; ++k)
        {
          low[k] = std::min(low[k], facet.normal[k]);
          high[k] = std::max(high[k], facet.normal[k]);
          for (int corner = 0; corner < 3; ++corner)
          {
            pack.corner[corner][k][i] = this->Scene.points[facet.places[corner]][k];
          }
        }
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      part.nodes[node].normalLower[k][child] =
        static_cast<std::int8_t>(std::floor(Bvh::normalScale * low[k]));
      part.nodes[node].normalUpper[k][child] =
        static_cast<std::int8_t>(std::ceil(Bvh::normalScale * high[k]));
    }
    part.nodes[node].child[child] = -1 - static_cast<int>(part.packs.size());
  }

  // Appends a part's nodes and packs, references moved; returns where its root went.
  static int append(Part& to, const Part& from)
  {
    const int node = static_cast<int>(to.nodes.size()), pack = static_cast<int>(to.packs.size());
    to.nodes.insert(to.nodes.end(), from.nodes.begin(), from.nodes.end());
    to.packs.insert(to.packs.end(), from.packs.begin(), from.packs.end());
    for (std::size_t i = node; i < to.nodes.size(); ++i)
    {
      move(to.nodes[i], node, pack);
    }
    return node;
  }

  static void move(Bvh::Node& node, int nodes, int packs)
  {
    for (std::int32_t& child : node.child)
    {
      child = child >= 0 ? child + nodes : child < -1 ? child - packs : child;
    }
  }

  Bvh join(const Part& top, const std::vector<Part>& parts, const std::vector<int>& slots)
  {
    Bvh bvh;
    std::vector<int> nodeStarts, packStarts;
    std::size_t nodes = top.nodes.size(), packs = top.packs.size();
    for (const Part& part : parts)
    {
      nodeStarts.push_back(static_cast<int>(nodes));
      packStarts.push_back(static_cast<int>(packs));
      nodes += part.nodes.size();
      packs += part.packs.size();
    }
    bvh.nodes.resize(nodes);
    bvh.packs.resize(packs);
    std::copy(top.nodes.begin(), top.nodes.end(), bvh.nodes.begin());
    std::copy(top.packs.begin(), top.packs.end(), bvh.packs.begin());
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      bvh.nodes[slots[i] / Bvh::width].child[slots[i] % Bvh::width] = nodeStarts[i];
    }
    this->Caller.each(static_cast<int>(parts.size()),
      [&](int i)
      {
        Bvh::Node* node =
          std::copy(parts[i].nodes.begin(), parts[i].nodes.end(), bvh.nodes.data() + nodeStarts[i]);
        for (Bvh::Node* n = bvh.nodes.data() + nodeStarts[i]; n != node; ++n)
        {
          move(*n, nodeStarts[i], packStarts[i]);
        }
        std::copy(parts[i].packs.begin(), parts[i].packs.end(), bvh.packs.data() + packStarts[i]);
      });
    finish(bvh);
    return bvh;
  }

  // Normals of inner nodes, and the depth: children come after their parents.
  static void finish(Bvh& bvh)
  {
    std::vector<std::int16_t> waiting(bvh.nodes.size());
    for (int i = static_cast<int>(bvh.nodes.size()) - 1; i >= 0; --i)
    {
      Bvh::Node& node = bvh.nodes[i];
      int deepest = 1, present = 0;
      for (int c = 0; c < Bvh::width; ++c)
      {
        present += node.child[c] != -1;
        if (node.child[c] >= 0)
        {
          const Bvh::Node& child = bvh.nodes[node.child[c]];
          deepest = std::max<int>(deepest, waiting[node.child[c]]);
          for (int k = 0; k < 3; ++k)
          {
            node.normalLower[k][c] =
              *std::min_element(child.normalLower[k], child.normalLower[k] + Bvh::width);
            node.normalUpper[k][c] =
              *std::max_element(child.normalUpper[k], child.normalUpper[k] + Bvh::width);
          }
        }
      }
      waiting[i] = static_cast<std::int16_t>(deepest + std::max(present - 1, 0));
    }
    bvh.stackSize = waiting[0];
  }

  const RayScene& Scene;
  const Context& Caller;
  std::vector<Prim> Prims;
};

} // namespace

Bvh buildBvh(const RayScene& scene, const Context& context)
{
  return Builder(scene, context).build();
}

} // namespace oversketch
