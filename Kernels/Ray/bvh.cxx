#include "Ray/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace oversketch
{

namespace
{

constexpr int binCount = 16;
// Deeper than this the heuristic gives way to halving, which bounds the depth for any input.
constexpr int heuristicDepth = 32;
constexpr float boxMargin = 1e-6f; // the scene's half width is 1

struct Box
{
  float low[3] = { std::numeric_limits<float>::max(),
    std::numeric_limits<float>::max(),
    std::numeric_limits<float>::max() };
  float high[3] = { std::numeric_limits<float>::lowest(),
    std::numeric_limits<float>::lowest(),
    std::numeric_limits<float>::lowest() };

  void add(const Box& other)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->low[k] = std::min(this->low[k], other.low[k]);
      this->high[k] = std::max(this->high[k], other.high[k]);
    }
  }
  float centre(int k) const { return 0.5f * (this->low[k] + this->high[k]); }
  float area() const
  {
    const float x = this->high[0] - this->low[0], y = this->high[1] - this->low[1],
                z = this->high[2] - this->low[2];
    return x < 0.0f ? 0.0f : x * y + y * z + z * x;
  }
};

// A node of the binary tree that is folded into the wide one.
struct Binary
{
  Box box;
  int begin, end;            // into the order of triangles
  int left = -1, right = -1; // -1: a leaf
};

class Builder
{
public:
  Builder(const RayScene& scene, const Context& context)
    : scene_(scene)
    , context_(context)
    , boxes_(scene.facets.size())
    , order_(scene.facets.size())
  {
    std::iota(this->order_.begin(), this->order_.end(), 0);
    for (std::size_t t = 0; t < scene.facets.size(); ++t)
    {
      for (const int v : scene.facets[t].places)
      {
        Box corner;
        std::copy_n(scene.points[v].data(), 3, corner.low);
        std::copy_n(scene.points[v].data(), 3, corner.high);
        this->boxes_[t].add(corner);
      }
    }
  }

  Bvh build()
  {
    this->binary_.reserve(this->order_.size());
    const int root = this->split(0, static_cast<int>(this->order_.size()), 0);
    this->bvh_.nodes.emplace_back();
    // The root's children are those of the binary root, or it alone where that is a leaf.
    this->bvh_.stackSize = this->fold(0, root);
    return std::move(this->bvh_);
  }

private:
  static int packsOf(int count) { return (count + 3) / 4; }

  // Builds the binary tree over order_[begin, end) and returns its root.
  int split(int begin, int end, int depth)
  {
    const int id = static_cast<int>(this->binary_.size());
    this->binary_.push_back({ Box(), begin, end });
    Box box, centres;
    for (int i = begin; i < end; ++i)
    {
      const Box& b = this->boxes_[this->order_[i]];
      box.add(b);
      Box centre;
      for (int k = 0; k < 3; ++k)
      {
        centre.low[k] = centre.high[k] = b.centre(k);
      }
      centres.add(centre);
    }
    this->binary_[id].box = box;
    const int count = end - begin;
    if (count <= 4)
    {
      return id;
    }
    if ((id & 4095) == 0)
    {
      this->context_.checkpoint(0.0);
    }
    int middle = depth < heuristicDepth ? this->partition(begin, end, box, centres) : -1;
    if (middle < 0)
    {
      if (count <= Bvh::leafSize)
      {
        return id;
      }
      middle = this->halve(begin, end, centres);
    }
    const int left = this->split(begin, middle, depth + 1);
    const int right = this->split(middle, end, depth + 1);
    this->binary_[id].left = left;
    this->binary_[id].right = right;
    return id;
  }

  // Parts the range where the heuristic is least; -1 where a leaf is no worse, or all centres coincide.
  int partition(int begin, int end, const Box& box, const Box& centres)
  {
    const int binsUsed = std::min(binCount, end - begin); // most nodes are small
    float best = std::numeric_limits<float>::max();
    int bestAxis = -1, bestBin = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const float extent = centres.high[axis] - centres.low[axis];
      if (!(extent > 0.0f))
      {
        continue;
      }
      Box bins[binCount];
      int counts[binCount] = {};
      for (int i = begin; i < end; ++i)
      {
        const Box& b = this->boxes_[this->order_[i]];
        const int bin = binOf(b.centre(axis), centres.low[axis], extent, binsUsed);
        bins[bin].add(b);
        ++counts[bin];
      }
      float rightCost[binCount];
      Box right;
      int rightCount = 0;
      for (int bin = binsUsed - 1; bin > 0; --bin)
      {
        right.add(bins[bin]);
        rightCount += counts[bin];
        rightCost[bin] = right.area() * static_cast<float>(packsOf(rightCount));
      }
      Box left;
      int leftCount = 0;
      for (int bin = 1; bin < binsUsed; ++bin)
      {
        left.add(bins[bin - 1]);
        leftCount += counts[bin - 1];
        const float cost = left.area() * static_cast<float>(packsOf(leftCount)) + rightCost[bin];
        if (leftCount > 0 && leftCount < end - begin && cost < best)
        {
          best = cost;
          bestAxis = axis;
          bestBin = bin;
        }
      }
    }
    const int count = end - begin;
    // One step down costs about as much as one pack.
    if (bestAxis < 0 ||
        (count <= Bvh::leafSize && best + box.area() >= box.area() * static_cast<float>(packsOf(count))))
    {
      return -1;
    }
    const float low = centres.low[bestAxis], extent = centres.high[bestAxis] - low;
    const auto middle = std::stable_partition(this->order_.begin() + begin,
      this->order_.begin() + end,
      [&](int t) { return binOf(this->boxes_[t].centre(bestAxis), low, extent, binsUsed) < bestBin; });
    return static_cast<int>(middle - this->order_.begin());
  }

  int halve(int begin, int end, const Box& centres)
  {
    int axis = 0;
    for (int k = 1; k < 3; ++k)
    {
      if (centres.high[k] - centres.low[k] > centres.high[axis] - centres.low[axis])
      {
        axis = k;
      }
    }
    const int middle = begin + (end - begin) / 2;
    std::nth_element(this->order_.begin() + begin,
      this->order_.begin() + middle,
      this->order_.begin() + end,
      [&](int a, int b)
      {
        const float ca = this->boxes_[a].centre(axis), cb = this->boxes_[b].centre(axis);
        return ca != cb ? ca < cb : a < b;
      });
    return middle;
  }

  static int binOf(float centre, float low, float extent, int bins)
  {
    return std::min(bins - 1, static_cast<int>(static_cast<float>(bins) * ((centre - low) / extent)));
  }

  // Fills wide node `wide` from a binary node; returns the stack entries that a walk below it can need.
  int fold(int wide, int binary)
  {
    std::vector<int> children{ binary };
    while (children.size() < 4)
    {
      // Open the largest inner child.
      int widest = -1;
      for (int i = 0; i < static_cast<int>(children.size()); ++i)
      {
        if (this->binary_[children[i]].left >= 0 &&
            (widest < 0 ||
              this->binary_[children[i]].box.area() > this->binary_[children[widest]].box.area()))
        {
          widest = i;
        }
      }
      if (widest < 0)
      {
        break;
      }
      const Binary& opened = this->binary_[children[widest]];
      children[widest] = opened.left;
      children.push_back(opened.right);
    }
    int deepest = 1;
    for (int i = 0; i < 4; ++i)
    {
      const bool present = i < static_cast<int>(children.size());
      const Box box = present ? this->binary_[children[i]].box : Box();
      for (int k = 0; k < 3; ++k)
      {
        // The triangle test rounds coordinates on its own; a hit that it finds must lie in the box all the
        // same.
        this->bvh_.nodes[wide].lower[k][i] = box.low[k] - boxMargin;
        this->bvh_.nodes[wide].upper[k][i] = box.high[k] + boxMargin;
      }
      int child = -1;
      if (present && this->binary_[children[i]].left < 0)
      {
        child = this->writeLeaf(this->binary_[children[i]]);
      }
      else if (present)
      {
        child = static_cast<int>(this->bvh_.nodes.size());
        this->bvh_.nodes.emplace_back();
        deepest = std::max(deepest, this->fold(child, children[i]));
      }
      this->bvh_.nodes[wide].child[i] = child;
      this->bvh_.nodes[wide].padding[i] = 0;
    }
    return deepest + static_cast<int>(children.size()) - 1;
  }

  int writeLeaf(const Binary& leaf)
  {
    const int first = static_cast<int>(this->bvh_.packs.size());
    const int count = packsOf(leaf.end - leaf.begin);
    for (int p = 0; p < count; ++p)
    {
      Bvh::Pack pack = {};
      for (int i = 0; i < 4; ++i)
      {
        const int at = leaf.begin + 4 * p + i;
        pack.triangle[i] = at < leaf.end ? this->order_[at] : -1;
        for (int corner = 0; at < leaf.end && corner < 3; ++corner)
        {
          for (int k = 0; k < 3; ++k)
          {
            pack.corner[corner][k][i] =
              this->scene_.points[this->scene_.facets[this->order_[at]].places[corner]][k];
          }
        }
      }
      this->bvh_.packs.push_back(pack);
    }
    return count == 0 ? -1 : -2 - (4 * first + count - 1);
  }

  const RayScene& scene_;
  const Context& context_;
  std::vector<Box> boxes_;
  std::vector<int> order_;
  std::vector<Binary> binary_;
  Bvh bvh_;
};

} // namespace

Bvh buildBvh(const RayScene& scene, const Context& context)
{
  return Builder(scene, context).build();
}

} // namespace oversketch
