#include "Sparse/dissection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace oversketch
{

namespace
{

// A node with its place and the bounding box of its neighbours; together, as pieces are swept again and
// again.
struct Item
{
  int node;
  std::array<float, 3> at, low, high;
};

// A place to cut: items with key >= border (a bucket of the axis) lie on side 1.
struct Border
{
  int axis = -1, bucket = 0;
  int side = 0;            // the one that gives its nodes to the separator
  double size = 0.0;       // of the separator, at most
  double score = INFINITY; // the less, the better
};

// Sorts the keys of a piece along one axis into buckets. Monotone, so boxes stay boxes.
struct Buckets
{
  static constexpr int most = 256;
  int count;
  float origin, scale;
  Buckets(float low, float high, int items)
    : count(std::min(items, most))
    , origin(low)
    , scale(high > low ? static_cast<float>(this->count) / (high - low) : 0.0F)
  {
  }
  int of(float key) const
  {
    // Compared before the cast: a neighbour may lie further off than an int counts buckets of a thin piece.
    const float bucket = (key - this->origin) * this->scale;
    const int last = this->count - 1;
    return bucket > 0.0F ? (bucket < static_cast<float>(last) ? static_cast<int>(bucket) : last) : 0;
  }
};

// Sorts a separator by its longest extent. What a piece beside it touches then stands together.
void alongItself(std::vector<Item>& separator)
{
  std::array<float, 3> low, high;
  low.fill(INFINITY);
  high.fill(-INFINITY);
  for (const Item& item : separator)
  {
    for (int k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], item.at[k]);
      high[k] = std::max(high[k], item.at[k]);
    }
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k)
  {
    axis = high[k] - low[k] > high[axis] - low[axis] ? k : axis;
  }
  std::sort(separator.begin(),
    separator.end(),
    [axis](const Item& a, const Item& b)
    { return a.at[axis] < b.at[axis] || (a.at[axis] == b.at[axis] && a.node < b.node); });
}

class Dissector
{
public:
  Dissector(const Lists& pattern, const std::vector<Vector3>& positions, const Context& context);

  // Reorders the items begin .. end - 1 to: one side, the other side, the separator between them. Returns
  // where the second and the third begin, (begin, begin) where no cut was found. Pieces that are on two sides
  // of a separator can be cut at the same time.
  std::array<int, 2> cut(int begin, int end);

  std::vector<Item> items;

private:
  Border sweep(int begin, int end, int axis) const;
  void measure(int begin, int end, int label);

  const Lists& Pattern;
  std::vector<int> Label; // of a node: which side of which piece it is in; -1 in a separator
};

Dissector::Dissector(const Lists& pattern, const std::vector<Vector3>& positions, const Context& context)
  : items(positions.size())
  , Pattern(pattern)
  , Label(positions.size(), -1)
{
  const Eigen::AlignedBox3d box = boxRound(positions);
  const Vector3& low = box.min();
  const double extent = positions.empty() ? 0.0 : (box.max() - low).maxCoeff();
  const double scale = extent > 0.0 ? 1.0 / extent : 0.0;
  for (int v = 0; v < static_cast<int>(positions.size()); ++v)
  {
    this->items[v].node = v;
    for (int k = 0; k < 3; ++k)
    {
      this->items[v].at[k] = static_cast<float>((positions[v][k] - low[k]) * scale);
    }
  }
  context.each(static_cast<int>(positions.size()),
    [this](int v)
    {
      Item& item = this->items[v];
      item.low = item.high = item.at;
      for (const int n : this->Pattern[v])
      {
        for (int k = 0; k < 3; ++k)
        {
          item.low[k] = std::min(item.low[k], this->items[n].at[k]);
          item.high[k] = std::max(item.high[k], this->items[n].at[k]);
        }
      }
    });
}

// The best place to cut across the axis. The separator is counted from the items' boxes, without a look at
// the graph.
Border Dissector::sweep(int begin, int end, int axis) const
{
  float low = this->items[begin].at[axis], high = low;
  for (int i = begin; i < end; ++i)
  {
    low = std::min(low, this->items[i].at[axis]);
    high = std::max(high, this->items[i].at[axis]);
  }
  const Buckets buckets(low, high, end - begin);
  // Steps of three functions of the border: items below it, those of them that touch what is not, and the
  // others that touch what is below.
  std::array<int, Buckets::most + 1> below{}, touching{}, touched{};
  for (int i = begin; i < end; ++i)
  {
    const Item& item = this->items[i];
    const int at = buckets.of(item.at[axis]);
    ++below[at + 1];
    ++touching[at + 1];
    --touching[buckets.of(item.high[axis]) + 1];
    ++touched[buckets.of(item.low[axis]) + 1];
    --touched[at + 1];
  }
  Border best;
  double sum = 0.0, sumTouching = 0.0, sumTouched = 0.0;
  const double count = end - begin;
  for (int b = 1; b < buckets.count; ++b)
  {
    sum += below[b];
    sumTouching += touching[b];
    sumTouched += touched[b];
    const int side = sumTouched < sumTouching;
    const double first = sum - (side ? 0.0 : sumTouching);
    const double second = count - sum - (side ? sumTouched : 0.0);
    const double size = side ? sumTouched : sumTouching;
    // A separator of size 0 is best if it halves the piece.
    const double score = (size + 1e-3 * count) / (first * second);
    if (first > 0.0 && second > 0.0 && 4.0 * sum >= count && 4.0 * sum <= 3.0 * count && score < best.score)
    {
      best = { axis, b, side, size, score };
    }
  }
  return best;
}

// Replaces the first coordinate by the number of links from a node far off; by more than any where there is
// no path.
void Dissector::measure(int begin, int end, int label)
{
  std::vector<std::pair<int, float>> depths; // in the order they were reached
  int start = this->items[begin].node;
  for (int round = 0; round < 2; ++round) // the last node reached from any is far off
  {
    for (int i = begin; i < end; ++i)
    {
      this->Label[this->items[i].node] = label;
    }
    depths.assign(1, { start, 0.0F });
    this->Label[start] = label + 1;
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      const auto [v, depth] = depths[i];
      for (const int n : this->Pattern[v])
      {
        if (this->Label[n] == label)
        {
          this->Label[n] = label + 1;
          depths.emplace_back(n, depth + 1.0F);
        }
      }
    }
    start = depths.back().first;
  }
  const float beyond = depths.back().second + 2.0F;
  std::sort(depths.begin(), depths.end());
  for (int i = begin; i < end; ++i)
  {
    Item& item = this->items[i];
    const auto found = std::lower_bound(depths.begin(), depths.end(), std::pair(item.node, 0.0F));
    const float depth = found != depths.end() && found->first == item.node ? found->second : beyond;
    item.at[0] = depth;
    item.low[0] = depth - 1.0F;
    item.high[0] = depth + 1.0F;
  }
}

std::array<int, 2> Dissector::cut(int begin, int end)
{
  const int label = 2 * begin; // a piece has two nodes at least: no other one has these two numbers
  Border border;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Border other = this->sweep(begin, end, axis);
    border = other.score < border.score ? other : border;
  }
  // A straight cut through a flat piece, two rings of neighbours wide, takes about 2 sqrt(n) nodes. Where the
  // positions say little of the graph, distances along it do; the piece keeps them for its coordinates.
  const double count = end - begin;
  if (border.axis < 0 || border.size > 16.0 + 8.0 * std::sqrt(count))
  {
    std::vector<Item> kept(this->items.begin() + begin, this->items.begin() + end);
    this->measure(begin, end, label);
    const Border other = this->sweep(begin, end, 0);
    if (other.score < border.score)
    {
      border = other;
    }
    else
    {
      std::copy(kept.begin(), kept.end(), this->items.begin() + begin);
    }
  }
  if (border.axis < 0)
  {
    return { begin, begin };
  }
  const int axis = border.axis;
  float low = this->items[begin].at[axis], high = low;
  for (int i = begin; i < end; ++i)
  {
    low = std::min(low, this->items[i].at[axis]);
    high = std::max(high, this->items[i].at[axis]);
  }
  const Buckets buckets(low, high, end - begin);
  for (int i = begin; i < end; ++i)
  {
    this->Label[this->items[i].node] = label + (buckets.of(this->items[i].at[axis]) >= border.bucket);
  }
  std::vector<Item> sides[3];
  for (int i = begin; i < end; ++i)
  {
    const Item& item = this->items[i];
    const int side = this->Label[item.node] - label;
    const bool near = side == border.side && (side ? buckets.of(item.low[axis]) < border.bucket
                                                   : buckets.of(item.high[axis]) >= border.bucket);
    const bool touches = near && std::any_of(this->Pattern.begin(item.node),
                                   this->Pattern.end(item.node),
                                   [&](int n) { return this->Label[n] == label + 1 - side; });
    sides[touches ? 2 : side].push_back(item);
  }
  alongItself(sides[2]);
  for (const Item& item : sides[2])
  {
    this->Label[item.node] = -1;
  }
  auto out = this->items.begin() + begin;
  for (const std::vector<Item>& side : sides)
  {
    out = std::copy(side.begin(), side.end(), out);
  }
  const int second = begin + static_cast<int>(sides[0].size());
  return { second, second + static_cast<int>(sides[1].size()) };
}

} // namespace

Dissection dissect(const Lists& pattern,
  const std::vector<Vector3>& positions,
  int smallest,
  const Context& context)
{
  Dissector dissector(pattern, positions, context);
  std::vector<Dissection::Part> tree; // parents before children; first a piece, once cut its separator
  if (!positions.empty())
  {
    tree.push_back({ 0, static_cast<int>(positions.size()), -1 });
  }
  // Level by level: the pieces of one are cut in parallel.
  for (std::size_t begin = 0; begin < tree.size();)
  {
    context.checkpoint(0.0);
    const std::size_t end = tree.size();
    std::vector<std::array<int, 2>> borders(end - begin);
    context.eachUntilCancelled(static_cast<int>(end - begin),
      [&](int i)
      {
        const Dissection::Part& part = tree[begin + static_cast<std::size_t>(i)];
        borders[i] = { part.first, part.first };
        if (part.count > smallest)
        {
          borders[i] = dissector.cut(part.first, part.first + part.count);
        }
      });
    context.checkpoint(0.0);
    for (std::size_t i = begin; i < end; ++i)
    {
      const Dissection::Part part = tree[i];
      const auto [second, third] = borders[i - begin];
      if (second > part.first)
      {
        tree.push_back({ part.first, second - part.first, static_cast<int>(i) });
        tree.push_back({ second, third - second, static_cast<int>(i) });
      }
      tree[i] = { third, part.first + part.count - third, part.parent };
    }
    begin = end;
  }
  // Sides stand before their separator in the order of the nodes, and so do parts. A separator without nodes
  // (between pieces that do not touch) stands after its sides too.
  std::vector<int> sorted(tree.size()), place(tree.size());
  for (std::size_t i = 0; i < tree.size(); ++i)
  {
    sorted[i] = static_cast<int>(i);
  }
  const auto end = [&](int i) { return tree[i].first + tree[i].count; };
  std::sort(sorted.begin(),
    sorted.end(),
    [&](int a, int b) { return end(a) < end(b) || (end(a) == end(b) && a > b); });
  Dissection result;
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    place[sorted[i]] = static_cast<int>(i);
  }
  for (const int i : sorted)
  {
    result.parts.push_back({ tree[i].first, tree[i].count, tree[i].parent < 0 ? -1 : place[tree[i].parent] });
  }
  for (const Item& item : dissector.items)
  {
    result.inverse.push_back(item.node);
  }
  return result;
}

} // namespace oversketch
