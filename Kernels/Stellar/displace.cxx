#include "Stellar/displace.h"

#include "Mesh/context.h"
#include "Mesh/nearest.h"
#include "Stellar/crossed_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oversketch
{

namespace
{

// A vertex and what curves make of it.
struct Rise
{
  int vertex;
  double ratio; // distance / radius of the nearest curve
  double feature;
  double along = 0.0; // its normal, without a sketch
  Vector3 move = Vector3::Zero();
};

// A curve with its own values, or the options'.
struct Shape
{
  double radius, height;
  Profile profile;
  std::vector<double> limits; // per point of the curve, or empty

  // The height at a place of the curve.
  double heightAt(const FeatureCurve& curve, double parameter, double pressure) const
  {
    const double height = pressure * this->height;
    if (this->limits.empty())
    {
      return height;
    }
    const auto [segment, t] = curve.at(parameter);
    // Infinite ones have no mean.
    const double from = this->limits[segment], to = this->limits[curve.segmentEnd(segment)];
    const double limit = from == to ? from : (1.0 - t) * from + t * to;
    return std::abs(height) <= limit ? height : std::copysign(limit, height);
  }
};

void refuseShape(int curve, const std::string& what, double value)
{
  throw Error(Failure::BadStroke,
    "The %1 of feature curve %2 is %3; give a number%4",
    what,
    curve,
    value,
    (what == "radius" ? " above 0, a length of the model." : "."));
}

std::vector<Shape> shapesOf(const FeatureCurves& curves, const DisplaceOptions& options)
{
  std::vector<Shape> shapes;
  for (int k = 0; k < static_cast<int>(curves.size()); ++k)
  {
    const double radius = curves[k].radius.value_or(options.radius);
    const double height = curves[k].height.value_or(options.height);
    if (!(radius > 0.0) || !std::isfinite(radius))
    {
      refuseShape(k, "radius", radius);
    }
    if (!std::isfinite(height))
    {
      refuseShape(k, "height", height);
    }
    shapes.push_back({ radius,
      height,
      options.profile ? *options.profile : Profile(curves[k].sharpness.value_or(options.sharpness)),
      options.holdBack ? curves[k].limits(height > 0.0) : std::vector<double>() });
  }
  return shapes;
}

void checkSketch(const FeatureCurves& curves, const std::vector<std::vector<Vector3>>& sketch)
{
  bool fits = sketch.size() == curves.size();
  for (std::size_t k = 0; fits && k < sketch.size(); ++k)
  {
    fits = sketch[k].size() == curves[k].points.size() &&
           std::all_of(sketch[k].begin(), sketch[k].end(), [](const Vector3& x) { return x.allFinite(); });
  }
  if (!fits)
  {
    throw Error(Failure::BadStroke,
      "The sketch does not have a point, of finite numbers, for each point of each feature curve; pass both "
      "as they came from the same silhouette stroke.");
  }
}

// The share of its way that a vertex goes.
double freeOf(const DisplaceOptions& options, int vertex)
{
  return options.mask.empty() ? 1.0 : 1.0 - options.mask[vertex];
}

// Rises that all curves together make, in the order in which they reach the vertices.
std::vector<Rise> risesOf(const Forest& forest,
  const FeatureCurves& curves,
  const CurvesReached& reached,
  const DisplaceOptions& options)
{
  const std::vector<Shape> shapes = shapesOf(curves, options);
  std::vector<int> of(forest.vertices.size(), -1);
  std::vector<Rise> rises;
  for (int k = 0; k < static_cast<int>(curves.size()); ++k)
  {
    const FeatureCurve& curve = curves[k];
    for (const Reached& reach : reached.vertices[k])
    {
      const double taper = curve.taperAt(reach.parameter, options.taper);
      if (taper == 0.0)
      {
        continue;
      }
      const double ratio = reach.distance / (taper * shapes[k].radius),
                   feature = taper * taper * shapes[k].profile(ratio);
      Rise rise{ reach.vertex, ratio, feature };
      if (options.sketch)
      {
        const auto [segment, t] = curve.at(reach.parameter);
        const std::vector<Vector3>& sketch = (*options.sketch)[k];
        const int next = curve.segmentEnd(segment);
        rise.move = feature * ((1.0 - t) * (sketch[segment] - curve.points[segment]) +
                                t * (sketch[next] - curve.points[next]));
      }
      else
      {
        const double pressure = options.usePressure ? curve.pressureAt(reach.parameter) : 1.0;
        rise.along = feature * shapes[k].heightAt(curve, reach.parameter, pressure);
      }
      int& id = of[reach.vertex];
      if (id < 0)
      {
        id = static_cast<int>(rises.size());
        rises.push_back(rise);
      }
      else if (options.combine == Combine::Sum)
      {
        rises[id].feature += feature;
        rises[id].along += rise.along;
        rises[id].move += rise.move;
      }
      else if (ratio < rises[id].ratio)
      {
        rises[id] = rise;
      }
    }
  }
  return rises;
}

// Where the room along the curves holds features back.
void reportRoom(const FeatureCurves& curves, const DisplaceOptions& options, DisplaceReport& report)
{
  const std::vector<Shape> shapes = shapesOf(curves, options);
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    for (std::size_t i = 0; i < shapes[k].limits.size(); ++i)
    {
      const double pressure = options.usePressure ? curves[k].pressureAt(curves[k].arc[i]) : 1.0;
      const double height = std::abs(pressure * shapes[k].height);
      if (shapes[k].limits[i] < height)
      {
        ++report.heldBack;
        report.leastShare = std::min(report.leastShare, shapes[k].limits[i] / height);
      }
    }
  }
}

// The faces around vertices, each once.
std::vector<int> facesAround(const Forest& forest, const std::vector<int>& vertices)
{
  std::vector<char> around(forest.faces.size(), 0);
  for (const int v : vertices)
  {
    forest.star(v, [&](int f, int) { around[f] = 1; });
  }
  return marked(around);
}

// Forgets what the stroke's vertices knew, which is of no use to the next one.
void endStroke(Forest& forest, const std::vector<int>& vertices, bool keepBaseNormals)
{
  for (const int v : vertices)
  {
    Forest::Vertex& vertex = forest.vertices[v];
    if (vertex.curveId >= 0)
    {
      vertex.moved |= Forest::Crest;
      vertex.curveId = -1;
      vertex.curveParam = 0.0;
    }
  }
  forest.hasBaseNormals = forest.hasBaseNormals && keepBaseNormals;
}

// Puts back what was displaced before, or makes `after` a copy.
void startFrom(const Forest& before, const std::vector<int>& changing, Forest& after)
{
  if (after.faces.empty())
  {
    after = before;
    after.displacement.assign(before.vertices.size(), Vector3::Zero());
    after.feature.assign(before.vertices.size(), 0.0);
    return;
  }
  for (const int v : changing)
  {
    after.vertices[v] = before.vertices[v];
    after.displacement[v] = Vector3::Zero();
    after.feature[v] = 0.0;
  }
}

// How many of the faces have turned over: by over 90 degrees, and to the other side of the way they rose.
int turned(const Forest& forest, const CurvesReached& reached, const Context& context)
{
  std::vector<char> turned(reached.faces.size(), 0);
  context.each(static_cast<int>(turned.size()),
    [&](int i)
    {
      const int* v = forest.faces[reached.faces[i]].v;
      const Vector3 rise = forest.displacement[v[0]] + forest.displacement[v[1]] + forest.displacement[v[2]];
      const Vector3 &old = reached.normals[i], now = forest.facetNormal(reached.faces[i]);
      turned[i] = old.dot(now) < 0.0 && old.dot(rise) * now.dot(rise) <= 0.0 ? 1 : 0;
    });
  return static_cast<int>(std::count(turned.begin(), turned.end(), 1));
}

constexpr int stepsPerRadius = 20;
constexpr int mostPlaces = 100000; // of one curve; longer ones are looked at less often

// A place on a face, and how far it is from where it was sought.
struct Near
{
  int face = -1;
  Vector3 weights = Vector3::Zero();
  double distance = std::numeric_limits<double>::infinity();
};

Near nearIn(const Forest& forest, int f, const Vector3& at)
{
  const Vector3 &a = forest.cornerOf(f, 0), &b = forest.cornerOf(f, 1), &c = forest.cornerOf(f, 2);
  const auto [wa, wb, wc] = closestWeights(a, b, c, at);
  const Vector3 w(wa, wb, wc);
  return { f, w, (w[0] * a + w[1] * b + w[2] * c - at).norm() };
}

// From face to face, over the edge or the corner that is nearest, while that comes nearer.
Near walk(const Forest& forest, Near from, const Vector3& at)
{
  for (bool better = true; better;)
  {
    better = false;
    const Near last = from;
    const auto look = [&](int g)
    {
      const Near near = nearIn(forest, g, at);
      if (near.distance < from.distance)
      {
        from = near;
        better = true;
      }
    };
    const Forest::Face& face = forest.faces[last.face];
    for (int k = 0; k < 3; ++k)
    {
      if (last.weights[k] == 1.0)
      {
        forest.star(face.v[k], [&](int g, int) { look(g); });
      }
      else if (last.weights[k] == 0.0 && face.n[k] >= 0)
      {
        look(face.n[k]);
      }
    }
  }
  return from;
}

// Places along a feature's crest, by which is told how well the mesh holds it: every twentieth of the radius
// along a curve, a radius and the taper from either end excluded, the place on the mesh that is nearest
// there, sought from faces that the curve passes through.
std::vector<Binding> crestPlaces(const Forest& forest,
  const FeatureCurve& curve,
  double radius,
  double taper,
  const std::vector<int>& passed)
{
  std::vector<Binding> places;
  const double margin = curve.closed ? 0.0 : std::max(radius, taper), length = curve.length - 2.0 * margin;
  if (!(length > 0.0) || passed.empty())
  {
    return places;
  }
  const double wanted = length * stepsPerRadius / radius;
  const int count = wanted < mostPlaces ? static_cast<int>(wanted) + 1 : mostPlaces;
  Near near;
  for (int i = 0; i < count; ++i)
  {
    const Vector3 at = curve.position(margin + (i + 0.5) * length / count);
    if (near.face < 0)
    {
      for (const int f : passed)
      {
        const Near other = nearIn(forest, f, at);
        near = other.distance < near.distance ? other : near;
      }
    }
    near = walk(forest, nearIn(forest, near.face, at), at);
    const int* v = forest.faces[near.face].v;
    places.push_back({ { v[0], v[1], v[2] }, { near.weights[0], near.weights[1], near.weights[2] } });
  }
  return places;
}

} // namespace

CurvesReached reachedBy(const Forest& forest,
  const FeatureCurves& curves,
  const DisplaceOptions& options,
  const Context& context)
{
  checkCurves(curves);
  const std::vector<Shape> shapes = shapesOf(curves, options);
  const CurveSearch search(curves);
  const CrossedFaces crossed(forest, search, context);
  CurveReach reach(forest, search);
  CurvesReached reached;
  reached.needed = VerticesToKeep(forest);
  std::vector<char> changing(forest.vertices.size(), 0);
  for (int k = 0; k < static_cast<int>(curves.size()); ++k)
  {
    reached.vertices.push_back(reach.find(
      k, crossed.faces(k), { shapes[k].radius, options.distance, options.connectedOnly }, context));
    reached.needed.add(forest, k, shapes[k].radius, reached.vertices.back(), crossed);
    for (const Reached& r : reached.vertices.back())
    {
      changing[r.vertex] = 1;
    }
    const std::vector<Binding> crest =
      crestPlaces(forest, curves[k], shapes[k].radius, options.taper, crossed.faces(k));
    reached.crest.insert(reached.crest.end(), crest.begin(), crest.end());
  }
  for (std::size_t v = 0; v < forest.vertices.size(); ++v)
  {
    changing[v] = changing[v] || forest.vertices[v].curveId >= 0;
  }
  reached.changing = marked(changing);
  reached.faces = facesAround(forest, reached.changing);
  reached.normals.resize(reached.faces.size());
  context.each(static_cast<int>(reached.faces.size()),
    [&](int i) { reached.normals[i] = forest.facetNormal(reached.faces[i]); });
  return reached;
}

DisplaceReport displace(Forest& forest,
  const FeatureCurves& curves,
  const DisplaceOptions& options,
  const Context& context)
{
  const CurvesReached reached = reachedBy(forest, curves, options, context);
  Forest after;
  const DisplaceReport report = displace(forest, curves, reached, options, context, after);
  forest = std::move(after);
  return report;
}

DisplaceReport displace(const Forest& before,
  const FeatureCurves& curves,
  const CurvesReached& reached,
  const DisplaceOptions& options,
  const Context& context,
  Forest& after)
{
  checkCurves(curves);
  if (options.sketch)
  {
    checkSketch(curves, *options.sketch);
  }
  std::vector<Rise> rises = risesOf(before, curves, reached, options);
  rises.erase(std::remove_if(rises.begin(),
                rises.end(),
                [&](const Rise& rise) { return rise.feature == 0.0 || freeOf(options, rise.vertex) == 0.0; }),
    rises.end());
  if (!options.sketch)
  {
    const bool base = options.along == RiseAlong::Base && before.hasBaseNormals;
    context.eachUntilCancelled(static_cast<int>(rises.size()),
      [&](int i)
      {
        const int v = rises[i].vertex;
        rises[i].move = rises[i].along * (base ? before.vertices[v].baseNormal : before.vertexNormal(v));
      });
  }
  context.checkpoint(0.9);

  DisplaceReport report;
  startFrom(before, reached.changing, after);
  for (Rise& rise : rises)
  {
    rise.move *= freeOf(options, rise.vertex);
    after.vertices[rise.vertex].position += rise.move;
    after.vertices[rise.vertex].moved |= Forest::Displaced;
    after.displacement[rise.vertex] = rise.move;
    after.feature[rise.vertex] = rise.feature;
    report.peak = std::max(report.peak, rise.feature);
  }
  report.flipped = turned(after, reached, context);
  if (!options.sketch)
  {
    reportRoom(curves, options, report);
  }
  report.moved = static_cast<int>(rises.size());
  for (const Binding& at : reached.crest)
  {
    const auto isFree = [&](int v) { return freeOf(options, v) > 0.0; };
    if (!std::all_of(at.vertices.begin(), at.vertices.end(), isFree))
    {
      continue;
    }
    double value = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      value += at.weights[k] * after.feature[at.vertices[k]];
    }
    report.crestMinimum = report.crests == 0 ? value : std::min(report.crestMinimum, value);
    report.crestSum += value;
    ++report.crests;
  }
  endStroke(after, reached.changing, options.keepBaseNormals);
  return report;
}

} // namespace oversketch
