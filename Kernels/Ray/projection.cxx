#include "Ray/projection.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

template <typename... Arguments>
[[noreturn]] void refuseStroke(const char* text, const Arguments&... arguments)
{
  throw Error(Failure::BadStroke, text, arguments...);
}

// A place of the stroke, and what is under it.
struct Seen
{
  Vector2 display;
  double along;
  SurfaceHit hit;
};

// Traces a stroke over what is seen of a surface.
struct StrokeTracer
{
  const SurfaceRays& surface;
  const View& camera;
  const double tolerance;

  Seen look(const Vector2& display, double along) const
  {
    return { display, along, this->surface.nearest(lineOfSight(this->camera, display, this->surface)) };
  }

  // Appends what follows a up to b; a sample without triangle is a gap.
  void join(const Seen& a, const Seen& b, std::vector<SurfaceSample>& samples) const
  {
    this->halve(a, b, this->tolerance > 0.0 ? mostHalvings : 0, samples);
  }

private:
  static constexpr int mostHalvings = 9;

  void halve(const Seen& a, const Seen& b, int halvings, std::vector<SurfaceSample>& samples) const
  {
    const bool both = a.hit.found() && b.hit.found();
    if (halvings > 0 && (a.hit.found() || b.hit.found()))
    {
      const Seen middle = this->look(0.5 * (a.display + b.display), 0.5 * (a.along + b.along));
      if (!both || !this->straight(a, middle, b))
      {
        this->halve(a, middle, halvings - 1, samples);
        this->halve(middle, b, halvings - 1, samples);
        return;
      }
    }
    else if (!both || (this->tolerance > 0.0 && this->leaps(a, b)))
    {
      samples.emplace_back();
    }
    if (b.hit.found())
    {
      samples.push_back({ b.hit.at, b.hit.position, b.along });
    }
  }

  // Whether the chord may stand for the surface.
  bool straight(const Seen& a, const Seen& middle, const Seen& b) const
  {
    const Vector3 chord = 0.5 * (a.hit.position + b.hit.position);
    return middle.hit.found() && (middle.hit.position - chord).norm() <= this->tolerance &&
           (b.hit.position - a.hit.position).norm() <= this->longest(this->pixelSize(a, b));
  }

  // Whether two places that no halving brought together lie on different parts. Those of a stroke with few
  // samples may still be far apart in the picture.
  bool leaps(const Seen& a, const Seen& b) const
  {
    const double pixel = this->pixelSize(a, b);
    return (b.hit.position - a.hit.position).norm() >
           std::max(this->longest(pixel), 2.0 * pixel * (b.display - a.display).norm());
  }

  // How long a segment may be.
  double longest(double pixel) const
  {
    return std::min(20.0 * pixel, std::max(2.0 * pixel, 25.0 * this->tolerance));
  }

  // Size of a pixel in the world, at the nearer of two places.
  double pixelSize(const Seen& a, const Seen& b) const
  {
    return oversketch::pixelSize(this->camera, (a.hit.distance < b.hit.distance ? a : b).hit.position);
  }
};

struct End
{
  int chain = -1, point = -1;
  Vector3 position, normal;
};

// The place of the silhouette that an end of the stroke stands for: the nearest in the picture if that is
// within reach, else the nearest to the surface under the end. As published, only the latter is asked where
// there is a surface.
End endOf(const SurfaceRays& surface,
  const View& view,
  const Vector2& display,
  const std::vector<SilhouetteChain>& silhouette,
  const SketchRules& rules,
  const char* which)
{
  const bool anyVisible = std::any_of(silhouette.begin(),
    silhouette.end(),
    [](const SilhouetteChain& chain) { return chain.visible && !chain.points.empty(); });
  const SurfaceHit under = surface.nearest(lineOfSight(view, display, surface));
  End inPicture, inSpace;
  double pixels = std::numeric_limits<double>::infinity(), length = pixels;
  for (int c = 0; c < static_cast<int>(silhouette.size()); ++c)
  {
    const SilhouetteChain& chain = silhouette[c];
    for (int i = 0; i < static_cast<int>(chain.points.size()) && (chain.visible || !anyVisible); ++i)
    {
      const Vector3& p = chain.points[i];
      const double across = (view.toDisplay(p).head<2>() - display).norm();
      if (across < pixels && view.inFront(p))
      {
        pixels = across;
        inPicture = { c, i, p, chain.normals[i] };
      }
      if (under.found() && (p - under.position).norm() < length)
      {
        length = (p - under.position).norm();
        inSpace = { c, i, p, chain.normals[i] };
      }
    }
  }
  if (inPicture.chain < 0 && inSpace.chain < 0)
  {
    refuseStroke("There is no silhouette that the stroke could begin and end on: turn the model until an "
                 "outline is seen, and draw from one place of it to another.");
  }
  const bool published = rules.projection == SketchProjection::Ray;
  if (pixels <= rules.reach && !(published && under.found()))
  {
    return inPicture;
  }
  if (!under.found())
  {
    refuseStroke("The stroke %1 %2 px beside the silhouette, and not on the model: press and release the pen "
                 "on the model, or within %3 px of its outline.",
      which,
      std::lround(std::min(pixels, 1e6)),
      rules.reach);
  }
  return inSpace;
}

// The stroke in the plane through both ends that holds n, the mean of their normals.
std::vector<Vector3> sketchInPlane(const SurfaceRays& surface,
  const View& view,
  const std::vector<Vector2>& stroke,
  const End& begin,
  const End& end,
  const Vector3& n)
{
  const Vector3 chord = end.position - begin.position;
  const Vector3 across = chord.stableNormalized().cross(n);
  if (!(across.norm() > 1e-6) || !(chord.norm() > 1e-9 * surface.diagonal()))
  {
    refuseStroke("The stroke's ends and the silhouette's normals there span no plane: begin and end at two "
                 "different places of the outline.");
  }
  const Vector3 normal = across.normalized();
  const double edgeOn = std::sin(5.0 * std::acos(-1.0) / 180.0);
  std::vector<Vector3> sketch;
  for (const Vector2& display : stroke)
  {
    const Ray ray = lineOfSight(view, display, surface);
    const double slope = ray.direction.stableNormalized().dot(normal);
    const double along = (begin.position - ray.origin).dot(normal) / ray.direction.dot(normal);
    if (!(std::abs(slope) >= edgeOn) || !(along > 0.0))
    {
      refuseStroke("The plane of the sketch is seen from within 5 degrees of its edge, or from behind: turn "
                   "the view, or begin and end where the outline lies across it.");
    }
    sketch.emplace_back(ray.origin + along * ray.direction);
  }
  return sketch;
}

// Share of the length before each point; refuses a line without length.
std::vector<double> sharesOf(const std::vector<Vector3>& points)
{
  std::vector<double> shares{ 0.0 };
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    shares.push_back(shares.back() + (points[i] - points[i - 1]).norm());
  }
  const double length = shares.back();
  if (!(length > 0.0) || !std::isfinite(length))
  {
    refuseStroke("The stroke has no length on the plane of the sketch; draw a longer one.");
  }
  for (double& share : shares)
  {
    share /= length;
  }
  return shares;
}

SurfaceHit firstHit(const SurfaceRays& surface, const Vector3& from, const Vector3& n)
{
  SurfaceHit hit = surface.nearest({ from, -n });
  if (!hit.found())
  {
    hit = surface.nearest({ from, n });
  }
  return hit.found() ? hit : surface.closest(from);
}

// The hit of the line through `from` along n that is nearest to `before`, or, where it is farther than
// `farthest`, the place nearest to `expected`.
SurfaceHit nextHit(const SurfaceRays& surface,
  const Vector3& from,
  const Vector3& n,
  const Vector3& before,
  double farthest,
  const Vector3& expected)
{
  SurfaceHit best;
  double least = std::numeric_limits<double>::infinity();
  for (const SurfaceHit& hit : surface.all({ from, n }))
  {
    const double distance = (hit.position - before).norm();
    if (distance < least)
    {
      least = distance;
      best = hit;
    }
  }
  return least <= farthest ? best : surface.closest(expected);
}

// The silhouette from one of its points to another, at the given shares of its length. Of the two ways round
// a closed chain, the one that lies nearer to the sketch.
std::vector<Vector3> pathBetween(const SilhouetteChain& chain,
  int begin,
  int end,
  const std::vector<double>& shares,
  const std::vector<Vector3>& sketch)
{
  const int count = static_cast<int>(chain.points.size());
  std::vector<Vector3> best;
  double least = std::numeric_limits<double>::infinity();
  for (const int step : { 1, -1 })
  {
    if (!chain.closed && (end - begin) * step < 0)
    {
      continue;
    }
    std::vector<Vector3> way{ chain.points[begin] };
    for (int i = begin; i != end;)
    {
      i = (i + step + count) % count;
      way.push_back(chain.points[i]);
    }
    const std::vector<double> lengths = sharesOf(way);
    std::vector<Vector3> path;
    double away = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k)
    {
      const auto after = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, shares[k]);
      const std::size_t i = static_cast<std::size_t>(after - lengths.begin());
      const double part = lengths[i] - lengths[i - 1];
      const double t = part > 0.0 ? (shares[k] - lengths[i - 1]) / part : 1.0;
      path.emplace_back((1.0 - t) * way[i - 1] + t * way[i]);
      away += (path.back() - sketch[k]).norm();
    }
    if (away < least)
    {
      least = away;
      best = std::move(path);
    }
  }
  return best;
}

// Appends a sample and what it goes to, unless it lies where the one before does; the last one stays.
void append(SilhouetteSketch& result, const SurfaceHit& hit, double along, const Vector3& target, bool last)
{
  std::vector<SurfaceSample>& samples = result.curve.samples;
  if (!samples.empty() && samples.back().position == hit.position)
  {
    if (!last)
    {
      return;
    }
    samples.pop_back();
    result.sketch.pop_back();
  }
  samples.push_back({ hit.at, hit.position, along });
  result.sketch.push_back(target);
}

// See SilhouetteSketch::hidden.
double hiddenDent(const SurfaceRays& surface,
  const View& view,
  const SilhouetteSketch& made,
  const Vector3& n)
{
  double in = 0.0, out = 0.0, hidden = 0.0;
  for (std::size_t k = 0; k < made.sketch.size(); ++k)
  {
    const double way = (made.sketch[k] - made.curve.samples[k].position).dot(n);
    in = std::max(in, -way);
    out = std::max(out, way);
    const Vector2 display = view.toDisplay(made.sketch[k]).head<2>();
    hidden = std::max(
      hidden, depthAt(surface, made.sketch[k], lineOfSight(view, display, surface).direction.normalized()));
  }
  return in > out ? hidden : 0.0;
}

// A limb beside which both ends lie on what it stands on.
void refuseSpike(const std::vector<Vector3>& sketch,
  const End& begin,
  const End& end,
  const SketchRules& rules)
{
  constexpr double steepest = 6.0; // times as long as the way from end to end
  double length = 0.0;
  for (std::size_t i = 1; i < sketch.size(); ++i)
  {
    length += (sketch[i] - sketch[i - 1]).norm();
  }
  const double times = length / (end.position - begin.position).norm();
  if (rules.projection == SketchProjection::Line && times > steepest)
  {
    refuseStroke("The stroke is %1 times as long as the way between its ends, which is a limb rather than a "
                 "bump: pull it by one-stroke, or begin and end farther apart.",
      times);
  }
}

} // namespace

Ray lineOfSight(const View& view, const Vector2& display, const SurfaceRays& surface)
{
  // The depth of the surface, where places are as precise as its own points.
  const double depth = view.depth(surface.centre());
  if (view.perspective())
  {
    const Vector3 place = view.toWorld(display, depth != 0.0 ? -std::abs(depth) : -1.0);
    return { view.eye(), place - view.eye() };
  }
  return { view.toWorld(display, depth) + 4.0 * surface.diagonal() * view.normal(), -view.normal() };
}

std::vector<SurfaceCurve> projectStroke(const SurfaceRays& surface,
  const View& view,
  const std::vector<Vector2>& stroke,
  bool closed,
  double tolerance,
  const Context& context)
{
  const int count = static_cast<int>(stroke.size());
  if (count == 0)
  {
    return {};
  }
  const StrokeTracer tracer{ surface, view, tolerance };
  std::vector<Seen> seen(stroke.size());
  context.eachUntilCancelled(count, [&](int i) { seen[i] = tracer.look(stroke[i], i); });
  context.checkpoint(0.3);
  if (closed)
  {
    seen.push_back(seen.front());
    seen.back().along = count;
  }
  const std::vector<std::vector<SurfaceSample>> rows = rowsOf(seen, tracer, context);
  context.checkpoint(0.9);
  return piecesOf(rows, closed, count);
}

SilhouetteSketch sketchSilhouette(const SurfaceRays& surface,
  const View& view,
  const std::vector<Vector2>& stroke,
  const std::vector<SilhouetteChain>& silhouette,
  const SketchRules& rules,
  const Context& context)
{
  if (stroke.size() < 2)
  {
    refuseStroke("The stroke has fewer than two samples; draw a longer one.");
  }
  const End begin = endOf(surface, view, stroke.front(), silhouette, rules, "begins");
  const End end = endOf(surface, view, stroke.back(), silhouette, rules, "ends");
  if (rules.projection == SketchProjection::Line && begin.normal.dot(end.normal) < -0.5)
  {
    refuseStroke(
      "The stroke leads round the end of a limb, from one side of it to the other. An outline drawn anew is "
      "for bumps and dents: begin and end on one side of the limb, or pull the limb itself by one-stroke.");
  }
  const Vector3 n = 0.5 * (begin.normal + end.normal);
  std::vector<Vector3> sketch = sketchInPlane(surface, view, stroke, begin, end, n);
  refuseSpike(sketch, begin, end, rules);
  const std::vector<double> shares = sharesOf(sketch);
  // It ends on the silhouette.
  const Vector3 atBegin = begin.position - sketch.front(), atEnd = end.position - sketch.back();
  for (std::size_t k = 0; k < sketch.size(); ++k)
  {
    sketch[k] += (1.0 - shares[k]) * atBegin + shares[k] * atEnd;
  }
  std::vector<Vector3> path;
  if (rules.projection == SketchProjection::Path)
  {
    if (begin.chain != end.chain)
    {
      refuseStroke("No one silhouette curve joins the stroke's ends, which the projection Path needs; draw "
                   "along one outline, or take the projection Line.");
    }
    path = pathBetween(silhouette[begin.chain], begin.point, end.point, shares, sketch);
  }

  SilhouetteSketch result;
  const std::size_t last = sketch.size() - 1;
  const Vector3 chord = end.position - begin.position;
  const double farthest = 4.0 * chord.norm() / static_cast<double>(last);
  Vector3 before = begin.position;
  for (std::size_t k = 0; k <= last; ++k)
  {
    SurfaceHit hit;
    if (k == 0 || k == last)
    {
      hit = surface.closest(k == 0 ? begin.position : end.position);
      sketch[k] = hit.position;
    }
    else if (!path.empty())
    {
      hit = surface.closest(path[k]);
    }
    else if (rules.projection == SketchProjection::Ray)
    {
      hit = firstHit(surface, sketch[k], n);
    }
    else
    {
      hit = nextHit(surface, sketch[k], n, before, farthest, begin.position + shares[k] * chord);
    }
    const double step = (hit.position - before).norm();
    if (rules.projection == SketchProjection::Line && rules.maximumStep > 0.0 && step > rules.maximumStep)
    {
      refuseStroke("The curve under the sketch takes a step of %1 at sample %2, longer than %3 "
                   "({maximumStep}): between the stroke's ends there is no surface for it to follow. An "
                   "outline drawn anew is for bumps and dents: draw nearer to the outline of one part, or "
                   "pull a limb by one-stroke (or take the projection Path).",
        step,
        k,
        rules.maximumStep);
    }
    append(result, hit, static_cast<double>(k), sketch[k], k == last);
    before = hit.position;
    context.checkpoint(static_cast<double>(k) / static_cast<double>(last + 1));
  }
  result.hidden = hiddenDent(surface, view, result, n);
  return result;
}

namespace
{

// Splits a row of samples at its gaps.
std::vector<SurfaceCurve> cutAtGaps(const std::vector<std::vector<SurfaceSample>>& rows)
{
  std::vector<SurfaceCurve> pieces(1);
  for (const std::vector<SurfaceSample>& row : rows)
  {
    for (const SurfaceSample& sample : row)
    {
      std::vector<SurfaceSample>& samples = pieces.back().samples;
      if (sample.at.triangle < 0)
      {
        pieces.emplace_back();
      }
      else if (samples.empty() || samples.back().position != sample.position)
      {
        samples.push_back(sample);
      }
    }
  }
  return pieces;
}

// The last piece of a closed stroke ends where the first one begins, if that place was hit.
void joinRing(std::vector<SurfaceCurve>& pieces, int strokeSize)
{
  std::vector<SurfaceSample>& first = pieces.front().samples;
  std::vector<SurfaceSample>& last = pieces.back().samples;
  if (first.empty() || last.empty() || first.front().position != last.back().position)
  {
    return;
  }
  if (pieces.size() == 1)
  {
    if (first.size() > 3)
    {
      first.pop_back();
      pieces.front().closed = true;
    }
    return;
  }
  for (std::size_t i = 1; i < first.size(); ++i)
  {
    first[i].along += strokeSize;
  }
  last.insert(last.end(), first.begin() + 1, first.end());
  first.swap(last);
  pieces.pop_back();
}

} // namespace

std::vector<SurfaceCurve> piecesOf(const std::vector<std::vector<SurfaceSample>>& rows,
  bool closed,
  int strokeSize)
{
  std::vector<SurfaceCurve> pieces = cutAtGaps(rows);
  if (closed)
  {
    joinRing(pieces, strokeSize);
  }
  pieces.erase(
    std::remove_if(
      pieces.begin(), pieces.end(), [](const SurfaceCurve& piece) { return piece.samples.size() < 2; }),
    pieces.end());
  return pieces;
}

} // namespace oversketch
