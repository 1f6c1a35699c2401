#include "Silhouette/facing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace oversketch
{

namespace
{

constexpr double mostPlaces = 400.0; // along the picture's longer side
constexpr int rowsOfBand = 8;        // that a thread takes at a time

// The places of a picture that are looked at, row by row, and what lies in front there.
struct FacingGrid
{
  double step; // px
  int columns, rows;

  explicit FacingGrid(const View& view)
    : step(std::max(1.0, std::max(view.width(), view.height()) / mostPlaces))
    , columns(static_cast<int>(std::ceil(view.width() / this->step)))
    , rows(static_cast<int>(std::ceil(view.height() / this->step)))
  {
  }
  double at(int i) const { return (i + 0.5) * this->step; } // px
  // The first place at or beyond a position.
  int from(double px, int count) const
  {
    return static_cast<int>(std::clamp(std::ceil(px / this->step - 0.5), 0.0, static_cast<double>(count)));
  }
};

double acrossFrom(const Vector3& a, const Vector3& b, double x, double y)
{
  return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

// Counts, in some rows, of what is covered and shows its back.
struct BandCounts
{
  int covered = 0, back = 0;
};

class FacingBand
{
public:
  FacingBand(const FacingGrid& grid, int first)
    : Grid(grid)
    , First(first)
    , Last(std::min(first + rowsOfBand, grid.rows))
    , Front(static_cast<std::size_t>((this->Last - first) * grid.columns))
  {
  }

  void draw(const Vector3& a, const Vector3& b, const Vector3& c)
  {
    const auto [low, high] = std::minmax({ a[1], b[1], c[1] });
    const int begin = std::max(this->Grid.from(low, this->Grid.rows), this->First);
    const int end = std::min(this->Grid.from(std::nextafter(high, 1e300), this->Grid.rows), this->Last);
    const double area = acrossFrom(a, b, c[0], c[1]);
    if (begin >= end || !(std::abs(area) > 0.0))
    {
      return;
    }
    const auto [left, right] = std::minmax({ a[0], b[0], c[0] });
    const int from = this->Grid.from(left, this->Grid.columns),
              to = this->Grid.from(std::nextafter(right, 1e300), this->Grid.columns);
    for (int row = begin; row < end; ++row)
    {
      for (int column = from; column < to; ++column)
      {
        const double x = this->Grid.at(column), y = this->Grid.at(row);
        const double wa = acrossFrom(b, c, x, y) / area, wb = acrossFrom(c, a, x, y) / area,
                     wc = acrossFrom(a, b, x, y) / area;
        if (wa >= 0.0 && wb >= 0.0 && wc >= 0.0)
        {
          Place& place =
            this->Front[static_cast<std::size_t>((row - this->First) * this->Grid.columns + column)];
          const Place here{ wa * a[2] + wb * b[2] + wc * c[2], area < 0.0 };
          if (here.nearness > place.nearness || (here.nearness == place.nearness && !here.back))
          {
            place = here;
          }
        }
      }
    }
  }

  BandCounts counts() const
  {
    BandCounts counts;
    for (const Place& place : this->Front)
    {
      counts.covered += std::isfinite(place.nearness);
      counts.back += std::isfinite(place.nearness) && place.back;
    }
    return counts;
  }

private:
  struct Place
  {
    double nearness = -std::numeric_limits<double>::infinity();
    bool back = false;
  };

  const FacingGrid& Grid;
  const int First, Last;
  std::vector<Place> Front;
};

} // namespace

double backShare(const Mesh& mesh, const View& view, const Context& context)
{
  const FacingGrid grid(view);
  std::vector<Vector3> screen(mesh.points.size());
  std::vector<char> seen(mesh.points.size(), 0);
  context.each(mesh.vertexCount(),
    [&](int v)
    {
      seen[v] = view.inFront(mesh.points[v]);
      screen[v] = seen[v] ? view.toScreen(mesh.points[v]) : Vector3::Zero();
    });
  // The bands that each triangle reaches into: the first, and one past the last.
  std::vector<std::array<int, 2>> reach(mesh.triangles.size(), { 0, 0 });
  context.each(mesh.triangleCount(),
    [&](int i)
    {
      const Triangle& t = mesh.triangles[i];
      if (seen[t[0]] && seen[t[1]] && seen[t[2]])
      {
        const auto [low, high] = std::minmax({ screen[t[0]][1], screen[t[1]][1], screen[t[2]][1] });
        const int first = grid.from(low, grid.rows), last = grid.from(std::nextafter(high, 1e300), grid.rows);
        if (first < last)
        {
          reach[i] = { first / rowsOfBand, (last - 1) / rowsOfBand + 1 };
        }
      }
    });
  const int bands = (grid.rows + rowsOfBand - 1) / rowsOfBand;
  std::vector<std::vector<int>> drawn(static_cast<std::size_t>(bands));
  for (int i = 0; i < mesh.triangleCount(); ++i)
  {
    for (int band = reach[i][0]; band < reach[i][1]; ++band)
    {
      drawn[static_cast<std::size_t>(band)].push_back(i);
    }
  }
  std::vector<BandCounts> counts(static_cast<std::size_t>(bands));
  context.eachUntilCancelled(bands,
    [&](int band)
    {
      FacingBand front(grid, band * rowsOfBand);
      for (const int i : drawn[static_cast<std::size_t>(band)])
      {
        const Triangle& t = mesh.triangles[i];
        front.draw(screen[t[0]], screen[t[1]], screen[t[2]]);
      }
      counts[static_cast<std::size_t>(band)] = front.counts();
    });
  BandCounts all;
  for (const BandCounts& one : counts)
  {
    all.covered += one.covered;
    all.back += one.back;
  }
  return all.covered > 0 ? static_cast<double>(all.back) / all.covered : 0.0;
}

} // namespace oversketch
