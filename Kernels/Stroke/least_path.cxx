#include "Stroke/least_path.h"

#include "Mesh/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace oversketch
{
namespace
{

constexpr double straightAngle = 3.14159265358979323846;
constexpr double edgeWeight = 0.43, turnWeight = 0.43, gradientWeight = 0.14;
constexpr double far = std::numeric_limits<double>::infinity();
constexpr std::array<std::array<int, 2>, 8> steps{
  { { -1, -1 }, { 0, -1 }, { 1, -1 }, { -1, 0 }, { 1, 0 }, { -1, 1 }, { 0, 1 }, { 1, 1 } }
};

// In [0, straightAngle]; where there is no edge, a right angle.
double turn(double tangent, double angle)
{
  double a = std::abs(tangent - angle);
  a = a > straightAngle ? 2.0 * straightAngle - a : a;
  return std::isnan(a) ? 0.5 * straightAngle : a;
}

double tangentAt(const EdgeFeatures& features, std::size_t pixel)
{
  const float gx = features.gx[pixel], gy = features.gy[pixel];
  return gx == 0.0f && gy == 0.0f ? std::numeric_limits<double>::quiet_NaN()
                                  : std::atan2(-static_cast<double>(gx), static_cast<double>(gy));
}

// A cell that is reached at a cost.
struct Place
{
  double cost;
  int cell;
};

// Places by cost, and of equal ones by number. Steps cost so little that all that wait at a time lie in as
// many buckets; each is a heap of few.
class PlaceQueue
{
public:
  void clear()
  {
    for (auto& bucket : this->Buckets)
    {
      bucket.clear();
    }
    this->Count = this->First = 0;
  }
  bool empty() const { return this->Count == 0; }
  void push(const Place& place)
  {
    auto& bucket = this->Buckets[static_cast<std::size_t>(bucketsPerCost * place.cost) % bucketCount];
    bucket.push_back(place);
    std::push_heap(bucket.begin(), bucket.end(), later);
    ++this->Count;
  }
  Place pop()
  {
    while (this->Buckets[this->First].empty())
    {
      this->First = (this->First + 1) % bucketCount;
    }
    auto& bucket = this->Buckets[this->First];
    std::pop_heap(bucket.begin(), bucket.end(), later);
    const Place place = bucket.back();
    bucket.pop_back();
    --this->Count;
    return place;
  }

private:
  static constexpr std::size_t bucketCount = 256;
  static constexpr double bucketsPerCost = 128.0;
  // The dearest step turns by three right angles.
  static_assert(bucketsPerCost * (edgeWeight + 1.5 * turnWeight + gradientWeight) < bucketCount - 1);
  static constexpr auto later = [](const Place& a, const Place& b)
  { return a.cost > b.cost || (a.cost == b.cost && a.cell > b.cell); };

  std::array<std::vector<Place>, bucketCount> Buckets;
  std::size_t Count = 0, First = 0; // the bucket that was popped from last
};

} // namespace

double tangentOf(const EdgeFeatures& features, std::size_t pixel)
{
  return tangentAt(features, pixel);
}

int indexOf(const PathField& field, const Pixel& pixel)
{
  const int x = pixel[0] - field.x0, y = pixel[1] - field.y0;
  return x < 0 || y < 0 || x >= field.width || y >= field.height ? -1 : y * field.width + x;
}

PathField wholeField(const EdgeFeatures& features)
{
  PathField field{ 0, 0, features.width, features.height, {} };
  field.states.resize(features.edges.size());
  std::transform(features.edges.begin(),
    features.edges.end(),
    field.states.begin(),
    [](std::uint8_t edge) { return edge ? PathField::Edge : PathField::Plain; });
  return field;
}

// One search, whose memory serves the next one too.
class PathSearch::Work
{
public:
  std::vector<Pixel> find(const EdgeFeatures& features,
    const PathField& field,
    const Pixel& from,
    const Pixel& to,
    const Context& context)
  {
    const auto cellOf = [&](const Pixel& pixel)
    { return (pixel[1] - field.y0 + 1) * (field.width + 2) + pixel[0] - field.x0 + 1; };
    const int source = cellOf(from), target = cellOf(to);
    this->lay(features, field);
    this->enter(source);
    this->Cells[source].reached = 0.0;
    this->Places.push({ 0.0, source });
    for (int popped = 1; !this->Places.empty(); ++popped)
    {
      if (popped % 16384 == 0)
      {
        context.checkpoint(0.0);
      }
      const Place place = this->Places.pop();
      if (place.cell == target)
      {
        break;
      }
      if (place.cost <= this->Cells[place.cell].reached) // else a cheaper way was found since
      {
        this->leave(place.cell);
      }
    }
    std::vector<Pixel> path;
    if (this->Cells[target].reached == far)
    {
      return path;
    }
    for (int at = target; at != source; at -= this->Offsets[this->Cells[at].back])
    {
      path.emplace_back(field.x0 + at % this->Width - 1, field.y0 + at / this->Width - 1);
    }
    path.push_back(from);
    std::reverse(path.begin(), path.end());
    return path;
  }

private:
  // Lays out the field's cells, and one more on every side, where no path goes.
  void lay(const EdgeFeatures& features, const PathField& field)
  {
    this->Features = &features;
    this->Field = &field;
    this->Scale = features.greatest > 0.0f ? 1.0 / features.greatest : 0.0;
    this->Width = field.width + 2;
    this->Cells.assign(static_cast<std::size_t>(this->Width) * (field.height + 2), Cell());
    for (int y = 0; y < field.height; ++y)
    {
      Cell* row = &this->Cells[static_cast<std::size_t>(y + 1) * this->Width + 1];
      const std::uint8_t* states = &field.states[static_cast<std::size_t>(y) * field.width];
      for (int x = 0; x < field.width; ++x)
      {
        row[x].state = states[x];
      }
    }
    for (std::size_t k = 0; k < steps.size(); ++k)
    {
      this->Angles[k] = std::atan2(steps[k][1], steps[k][0]);
      this->Offsets[k] = steps[k][1] * this->Width + steps[k][0];
    }
    this->Places.clear();
  }

  // A cell is reached.
  void enter(int at)
  {
    const int y = at / this->Width, x = at % this->Width;
    const std::size_t pixel =
      static_cast<std::size_t>(this->Field->y0 + y - 1) * this->Features->width + this->Field->x0 + x - 1;
    Cell& cell = this->Cells[at];
    cell.tangent = tangentAt(*this->Features, pixel);
    cell.flat = gradientWeight * (1.0 - this->Scale * this->Features->magnitude[pixel]);
  }

  // For its neighbours. acos of the dot product of two unit vectors is the angle between them, and turning
  // both tangents about is turning the step, so no cosine is needed.
  void leave(int p)
  {
    const Cell& from = this->Cells[p];
    const double cost = from.reached;
    for (std::size_t k = 0; k < steps.size(); ++k)
    {
      const int q = p + this->Offsets[k];
      Cell& to = this->Cells[q];
      if (to.state == PathField::Outside || to.reached <= cost)
      {
        continue;
      }
      if (to.reached == far)
      {
        this->enter(q);
      }
      const bool diagonal = steps[k][0] != 0 && steps[k][1] != 0;
      const double edge = to.state == PathField::Edge ? 0.0 : edgeWeight;
      const double flat = diagonal ? to.flat : to.flat * std::sqrt(0.5);
      if (cost + (edge + flat) >= to.reached) // too dear without its turn, to which rounding adds none
      {
        continue;
      }
      double ap = turn(from.tangent, this->Angles[k]), aq = turn(to.tangent, this->Angles[k]);
      if (ap > 0.5 * straightAngle)
      {
        ap = straightAngle - ap;
        aq = straightAngle - aq;
      }
      const double step = edge + turnWeight * (ap + aq) / straightAngle + flat;
      if (cost + step < to.reached)
      {
        to.reached = cost + step;
        to.back = static_cast<std::uint8_t>(k);
        this->Places.push({ to.reached, q });
      }
    }
  }

  struct Cell // a pixel of the field
  {
    double reached = far;                              // at what cost
    double tangent = 0.0, flat = 0.0;                  // once it is reached
    std::uint8_t state = PathField::Outside, back = 0; // the step that leads to it
  };

  const EdgeFeatures* Features = nullptr;
  const PathField* Field = nullptr;
  double Scale = 0.0;
  int Width = 0;
  std::vector<Cell> Cells;
  PlaceQueue Places;
  std::array<double, 8> Angles{};
  std::array<int, 8> Offsets{};
};

PathSearch::PathSearch()
  : Inner(std::make_unique<Work>())
{
}

PathSearch::~PathSearch() = default;

std::vector<Pixel> PathSearch::operator()(const EdgeFeatures& features,
  const PathField& field,
  const Pixel& from,
  const Pixel& to,
  const Context& context)
{
  const int source = indexOf(field, from), target = indexOf(field, to);
  const bool isIn = source >= 0 && target >= 0 && field.states[source] != PathField::Outside &&
                    field.states[target] != PathField::Outside;
  return isIn ? this->Inner->find(features, field, from, to, context) : std::vector<Pixel>();
}

std::vector<Pixel> leastPath(const EdgeFeatures& features,
  const PathField& field,
  const Pixel& from,
  const Pixel& to,
  const Context& context)
{
  return PathSearch()(features, field, from, to, context);
}

double pathCost(const EdgeFeatures& features, const PathField& field, const std::vector<Pixel>& path)
{
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const Pixel p = path[i - 1], q = path[i];
    const auto place = [&](const Pixel& a) { return static_cast<std::size_t>(a[1]) * features.width + a[0]; };
    const Vector2 way = (q - p).cast<double>().normalized();
    const auto along = [&](const Pixel& a)
    {
      const Vector2 tangent(features.gy[place(a)], -static_cast<double>(features.gx[place(a)]));
      const double length = tangent.norm();
      return length > 0.0 ? std::clamp(tangent.dot(way) / length, -1.0, 1.0) : 0.0;
    };
    double dp = along(p), dq = along(q);
    if (dp < 0.0)
    {
      dp = -dp;
      dq = -dq;
    }
    const double flat =
      1.0 - (features.greatest > 0.0f ? features.magnitude[place(q)] / double(features.greatest) : 0.0);
    const bool diagonal = p[0] != q[0] && p[1] != q[1];
    const int at = indexOf(field, q);
    cost += (at >= 0 && field.states[at] == PathField::Edge ? 0.0 : edgeWeight) +
            turnWeight * (std::acos(dp) + std::acos(dq)) / straightAngle +
            gradientWeight * (diagonal ? flat : flat * std::sqrt(0.5));
  }
  return cost;
}

} // namespace oversketch
