#include "Ray/curve_projection.h"

#include "Mesh/view.h"
#include "Ray/projection.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace oversketch
{

namespace
{

// A place of the picture and what is seen there.
struct Look
{
  Vector2 display;
  double along;
  SurfaceHit hit;
};

struct CurveTracer
{
  const SurfaceRays& surface;
  const View& camera;
  const std::vector<Vector2>& picture;
  const CurveRules rules;

  // The curve's place `along` it, modulo its count.
  Look look(double along) const
  {
    const int count = static_cast<int>(this->picture.size());
    const double floor = std::floor(along);
    const int before = static_cast<int>(floor) % count;
    const double t = along - floor;
    const Vector2& a = this->picture[before];
    const Vector2 display = t > 0.0 ? Vector2((1.0 - t) * a + t * this->picture[(before + 1) % count]) : a;
    return { display, along, this->surface.nearest(lineOfSight(this->camera, display, this->surface)) };
  }

  // Appends what follows a up to b.
  void join(const Look& a, const Look& b, std::vector<SurfaceSample>& row) const
  {
    if (a.hit.found() && b.hit.found())
    {
      this->across(a, b, row);
    }
    else if (a.hit.found())
    {
      append(this->lastSeen(a, b), row);
      row.emplace_back();
    }
    else
    {
      row.emplace_back();
      if (b.hit.found())
      {
        append(this->lastSeen(b, a), row);
        append(b, row);
      }
    }
  }

  double pixelAt(const Vector3& world) const { return pixelSize(this->camera, world); }

private:
  static constexpr int halvings = 12;
  static constexpr double largestRest = 0.2; // of a leap

  static void append(const Look& at, std::vector<SurfaceSample>& row)
  {
    row.push_back({ at.hit.at, at.hit.position, at.along });
  }

  // The last place that is seen on the way from one that is to one that is not.
  Look lastSeen(Look seen, Look missed) const
  {
    for (int i = 0; i < halvings; ++i)
    {
      const Look middle = this->look(0.5 * (seen.along + missed.along));
      (middle.hit.found() ? seen : missed) = middle;
    }
    return seen;
  }

  // Halves a leap until no two places are farther apart than is none; what then is, is one.
  void across(const Look& a, const Look& b, std::vector<SurfaceSample>& row) const
  {
    const double none =
      this->rules.gap * this->pixelAt((a.hit.distance < b.hit.distance ? a : b).hit.position);
    this->halve(a, b, halvings, none, std::max(none, largestRest * distance(a, b)), row);
  }

  static double distance(const Look& a, const Look& b) { return (a.hit.position - b.hit.position).norm(); }

  void halve(const Look& a,
    const Look& b,
    int left,
    double none,
    double rest,
    std::vector<SurfaceSample>& row) const
  {
    const double leap = distance(a, b);
    if (leap <= none || left == 0)
    {
      if (leap > rest)
      {
        row.emplace_back();
      }
      append(b, row);
      return;
    }
    const Look middle = this->look(0.5 * (a.along + b.along));
    if (middle.hit.found())
    {
      this->halve(a, middle, left - 1, none, rest, row);
      this->halve(middle, b, left - 1, none, rest, row);
      return;
    }
    const Look end = this->lastSeen(a, middle), begin = this->lastSeen(b, middle);
    this->halve(a, end, left - 1, none, rest, row);
    row.emplace_back();
    append(begin, row);
    this->halve(begin, b, left - 1, none, rest, row);
  }
};

// The step of even samples: half the mean edge of the triangles under the run, but 4 to 10 pixels' size.
double stepOf(const SurfaceCurve& run, const Mesh& mesh, const CurveTracer& tracer)
{
  std::set<int> triangles;
  double pixels = 0.0, edges = 0.0;
  for (const SurfaceSample& sample : run.samples)
  {
    pixels += tracer.pixelAt(sample.position);
    triangles.insert(sample.at.triangle);
  }
  pixels /= static_cast<double>(run.samples.size());
  for (const int t : triangles)
  {
    const Triangle& corners = mesh.triangles[t];
    for (int k = 0; k < 3; ++k)
    {
      edges += (mesh.points[corners[k]] - mesh.points[corners[(k + 1) % 3]]).norm();
    }
  }
  const double mean = edges / (3.0 * static_cast<double>(triangles.size()));
  return std::clamp(0.5 * mean, 4.0 * pixels, 10.0 * pixels);
}

// Samples of the run at equal lengths along it, each where a ray meets the surface.
SurfaceCurve evenRun(const SurfaceCurve& run, int pictureSize, const Mesh& mesh, const CurveTracer& tracer)
{
  std::vector<SurfaceSample> samples = run.samples;
  if (run.closed)
  {
    samples.push_back(samples.front());
    samples.back().along += pictureSize;
  }
  std::vector<double> lengths{ 0.0 };
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    lengths.push_back(lengths.back() + (samples[i].position - samples[i - 1].position).norm());
  }
  const double whole = lengths.back();
  const int steps =
    std::max(run.closed ? 3 : 1, static_cast<int>(std::lround(whole / stepOf(run, mesh, tracer))));
  SurfaceCurve even;
  even.closed = run.closed;
  std::size_t k = 0;
  for (int i = 0; i < steps; ++i)
  {
    const double length = whole * i / steps;
    while (k + 2 < samples.size() && lengths[k + 1] <= length)
    {
      ++k;
    }
    const SurfaceSample &a = samples[k], &b = samples[k + 1];
    const double t = (length - lengths[k]) / (lengths[k + 1] - lengths[k]);
    if (t <= 0.0)
    {
      even.samples.push_back(a);
      continue;
    }
    const Look middle = tracer.look((1.0 - t) * a.along + t * b.along);
    const Vector3 expected = (1.0 - t) * a.position + t * b.position;
    // Between two places of a leap that was followed to the end there may be one that is hidden.
    const bool near =
      middle.hit.found() && (middle.hit.position - expected).norm() <= (b.position - a.position).norm();
    even.samples.push_back(
      near ? SurfaceSample{ middle.hit.at, middle.hit.position, middle.along } : (t < 0.5 ? a : b));
  }
  if (!run.closed)
  {
    even.samples.push_back(samples.back());
  }
  return even;
}

// The samples of the whole curve, evenly in the picture, that lie on the run.
SurfaceCurve pictureRun(const SurfaceCurve& run,
  const std::vector<double>& places,
  int pictureSize,
  const CurveTracer& tracer)
{
  SurfaceCurve result;
  result.closed = run.closed;
  for (const int turn : { 0, 1 })
  {
    for (const double place : places)
    {
      const double along = place + turn * pictureSize;
      if (along >= run.samples.front().along && (turn == 0 || !run.closed) &&
          (run.closed || along <= run.samples.back().along))
      {
        const Look seen = tracer.look(along);
        if (seen.hit.found())
        {
          result.samples.push_back({ seen.hit.at, seen.hit.position, along });
        }
      }
    }
  }
  return result;
}

std::vector<double> publishedPlaces(const std::vector<Vector2>& picture, bool closed, double spacing)
{
  std::vector<double> lengths{ 0.0 };
  for (std::size_t i = 1; i < picture.size() + closed; ++i)
  {
    lengths.push_back(lengths.back() + (picture[i % picture.size()] - picture[i - 1]).norm());
  }
  const int count =
    std::max(closed ? 4 : 2, static_cast<int>(std::lround(lengths.back() / spacing)) + 1) - closed;
  std::vector<double> places;
  for (int i = 0; i < count; ++i)
  {
    const double length = lengths.back() * i / (closed ? count : count - 1);
    const auto next = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
    const double step = *next - *(next - 1);
    places.push_back(static_cast<double>(next - lengths.begin() - 1) +
                     (step > 0.0 ? std::min((length - *(next - 1)) / step, 1.0) : 0.0));
  }
  return places;
}

} // namespace

std::vector<SurfaceCurve> projectCurve(const SurfaceRays& surface,
  const View& view,
  const std::vector<Vector2>& picture,
  bool closed,
  const CurveRules& rules,
  const Context& context)
{
  const int count = static_cast<int>(picture.size());
  if (count < 2)
  {
    return {};
  }
  const CurveTracer tracer{ surface, view, picture, rules };
  std::vector<Look> looks(static_cast<std::size_t>(count) + closed);
  context.eachUntilCancelled(count, [&](int i) { looks[i] = tracer.look(i); });
  context.checkpoint(0.5);
  if (closed)
  {
    looks.back() = looks.front();
    looks.back().along = count;
  }
  const std::vector<std::vector<SurfaceSample>> rows = rowsOf(looks, tracer, context);
  context.checkpoint(0.7);
  const std::vector<double> places =
    rules.spacing > 0.0 ? publishedPlaces(picture, closed, rules.spacing) : std::vector<double>();
  std::vector<SurfaceCurve> runs;
  for (const SurfaceCurve& piece : piecesOf(rows, closed, count))
  {
    SurfaceCurve run = rules.spacing > 0.0 ? pictureRun(piece, places, count, tracer)
                                           : evenRun(piece, count, surface.mesh(), tracer);
    if (run.samples.size() >= (run.closed ? 3u : 2u))
    {
      runs.push_back(std::move(run));
    }
  }
  context.checkpoint(1.0);
  return runs;
}

} // namespace oversketch
