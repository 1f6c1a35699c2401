#include "Stellar/displace.h"

#include "Mesh/context.h"
#include "Stellar/crest.h"
#include "Stellar/passage.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace oversketch
{

namespace
{

// What curves make of a vertex.
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
};

void refuseShape(int curve, const std::string& what, double value)
{
  std::ostringstream message;
  message << "The " << what << " of feature curve " << curve << " is " << value << "; give a number"
          << (what == "radius" ? " above 0, a length of the model." : ".");
  throw Error(Failure::BadStroke, message.str());
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
      options.profile ? *options.profile : Profile(curves[k].sharpness.value_or(options.sharpness)) });
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

// What all curves together make of the vertices that they reach, in the order in which they reach them.
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
      const double ratio = reach.distance / shapes[k].radius, feature = shapes[k].profile(ratio);
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
        rise.along = feature * (pressure * shapes[k].height);
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

// The faces around the vertices that rise, each once.
std::vector<int> facesAround(const Forest& forest, const std::vector<Rise>& rises)
{
  std::vector<int> faces;
  for (const Rise& rise : rises)
  {
    forest.star(rise.vertex, [&](int f, int) { faces.push_back(f); });
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

// What the stroke's vertices knew is of no use to the next one.
void endStroke(Forest& forest)
{
  for (Forest::Vertex& vertex : forest.vertices)
  {
    if (vertex.curveId >= 0)
    {
      vertex.moved |= Forest::Crest;
      vertex.curveId = -1;
      vertex.curveParam = 0.0;
    }
  }
  forest.hasBaseNormals = false;
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
  const Passage passage(forest, search, context);
  CurveReach reach(forest, search);
  CurvesReached reached;
  for (int k = 0; k < static_cast<int>(curves.size()); ++k)
  {
    reached.vertices.push_back(reach.find(
      k, passage.faces(k), { shapes[k].radius, options.distance, options.connectedOnly }, context));
    const std::vector<Binding> crest = crestPlaces(forest, curves[k], shapes[k].radius, passage.faces(k));
    reached.crest.insert(reached.crest.end(), crest.begin(), crest.end());
  }
  return reached;
}

DisplaceReport displace(Forest& forest,
  const FeatureCurves& curves,
  const DisplaceOptions& options,
  const Context& context)
{
  return displace(forest, curves, reachedBy(forest, curves, options, context), options, context);
}

DisplaceReport displace(Forest& forest,
  const FeatureCurves& curves,
  const CurvesReached& reached,
  const DisplaceOptions& options,
  const Context& context)
{
  checkCurves(curves);
  if (options.sketch)
  {
    checkSketch(curves, *options.sketch);
  }
  std::vector<Rise> rises = risesOf(forest, curves, reached, options);
  rises.erase(
    std::remove_if(rises.begin(), rises.end(), [](const Rise& rise) { return rise.feature == 0.0; }),
    rises.end());
  if (!options.sketch)
  {
    const bool base = options.along == RiseAlong::Base && forest.hasBaseNormals;
    context.parallelFor(static_cast<int>(rises.size()),
      [&](int begin, int end)
      {
        for (int i = begin; i < end && !context.cancelled(); ++i)
        {
          const int v = rises[i].vertex;
          rises[i].move = rises[i].along * (base ? forest.vertices[v].baseNormal : forest.vertexNormal(v));
        }
      });
  }
  const std::vector<int> faces = facesAround(forest, rises);
  std::vector<Vector3> normals;
  normals.reserve(faces.size());
  for (const int f : faces)
  {
    normals.push_back(forest.facetNormal(f));
  }
  context.checkpoint(0.9);

  DisplaceReport report;
  forest.displacement.assign(forest.vertices.size(), Vector3::Zero());
  forest.feature.assign(forest.vertices.size(), 0.0);
  for (const Rise& rise : rises)
  {
    forest.vertices[rise.vertex].position += rise.move;
    forest.vertices[rise.vertex].moved |= Forest::Displaced;
    forest.displacement[rise.vertex] = rise.move;
    forest.feature[rise.vertex] = rise.feature;
    report.peak = std::max(report.peak, rise.feature);
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    report.flipped += normals[i].dot(forest.facetNormal(faces[i])) < 0.0 ? 1 : 0;
  }
  report.moved = static_cast<int>(rises.size());
  report.crests = static_cast<int>(reached.crest.size());
  for (const Binding& at : reached.crest)
  {
    double value = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      value += at.weights[k] * forest.feature[at.vertices[k]];
    }
    report.crestMinimum = &at == reached.crest.data() ? value : std::min(report.crestMinimum, value);
    report.crestSum += value;
  }
  endStroke(forest);
  return report;
}

} // namespace oversketch
