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

// Columns and rows of places: the first ones, and those past the last.
struct FacingPlaces
{
  std::array<short, 2> from{}, to{};
  bool empty() const { return this->from[0] >= this->to[0] || this->from[1] >= this->to[1]; }
};

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
  short from(double px, int count) const
  {
    return static_cast<short>(std::clamp(std::ceil(px / this->step - 0.5), 0.0, static_cast<double>(count)));
  }
  // From the first ones at or beyond a point to those beyond it.
  FacingPlaces placesAt(const Vector3& p) const
  {
    return { { this->from(p[0], this->columns), this->from(p[1], this->rows) },
      { this->from(std::nextafter(p[0], 1e300), this->columns),
        this->from(std::nextafter(p[1], 1e300), this->rows) } };
  }
};

// The places that a triangle may cover, by those at its corners.
FacingPlaces facingPlacesOf(const FacingPlaces& a, const FacingPlaces& b, const FacingPlaces& c)
{
  FacingPlaces all;
  for (int k = 0; k < 2; ++k)
  {
    all.from[k] = std::min({ a.from[k], b.from[k], c.from[k] });
    all.to[k] = std::max({ a.to[k], b.to[k], c.to[k] });
  }
  return all;
}

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

  void draw(const Vector3& a, const Vector3& b, const Vector3& c, const FacingPlaces& places)
  {
    const int begin = std::max<int>(places.from[1], this->First);
    const int end = std::min<int>(places.to[1], this->Last);
    const double area = acrossFrom(a, b, c[0], c[1]);
    if (begin >= end || !(std::abs(area) > 0.0))
    {
      return;
    }
    for (int row = begin; row < end; ++row)
    {
      for (int column = places.from[0]; column < places.to[0]; ++column)
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
  std::vector<FacingPlaces> places(mesh.points.size());
  std::vector<char> seen(mesh.points.size(), 0);
  context.each(mesh.vertexCount(),
    [&](int v)
    {
      seen[v] = view.inFront(mesh.points[v]);
      screen[v] = seen[v] ? view.toScreen(mesh.points[v]) : Vector3::Zero();
      places[v] = grid.placesAt(screen[v]);
    });
  const auto placesOfTriangle = [&](const Triangle& t)
  { return facingPlacesOf(places[t[0]], places[t[1]], places[t[2]]); };
  const int bands = (grid.rows + rowsOfBand - 1) / rowsOfBand;
  std::vector<std::vector<int>> drawn(static_cast<std::size_t>(bands));
  for (int i = 0; i < mesh.triangleCount(); ++i)
  {
    const Triangle& t = mesh.triangles[i];
    const FacingPlaces reach = placesOfTriangle(t);
    if (!reach.empty() && seen[t[0]] && seen[t[1]] && seen[t[2]])
    {
      for (int band = reach.from[1] / rowsOfBand; band * rowsOfBand < reach.to[1]; ++band)
      {
        drawn[static_cast<std::size_t>(band)].push_back(i);
      }
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
        front.draw(screen[t[0]], screen[t[1]], screen[t[2]], placesOfTriangle(t));
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
