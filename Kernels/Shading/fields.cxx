#include "Shading/fields.h"

#include "Mesh/context.h"
#include "Shading/directions.h"
#include "Shading/flatten.h"
#include "Shading/front.h"
#include "Sparse/cholesky.h"
#include "Stellar/curves.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <tuple>

namespace oversketch
{
namespace
{

FeatureCurve curveOf(const Mesh& mesh, const std::vector<int>& chain, bool closed)
{
  FeatureCurve curve;
  curve.closed = closed;
  curve.points = valuesAt(mesh.points, chain);
  curve.measure();
  return curve;
}

// f' - div(room^2 grad f') = f at the vertices that are not held; the others keep theirs.
void smoothField(const Mesh& patch,
  const Adjacency& adjacency,
  const std::vector<double>& room,
  const std::vector<char>& held,
  std::vector<double>& field,
  const Context& context)
{
  // Linear elements, of each triangle with the mean of its corners' room.
  std::vector<double> flow(adjacency.edges.size(), 0.0), mass(patch.points.size(), 0.0);
  for (int t = 0; t < patch.triangleCount(); ++t)
  {
    const Triangle& c = patch.triangles[t];
    double square = 0.0;
    for (const int k : c)
    {
      square += room[k] * room[k] / 3.0;
    }
    for (int k = 0; k < 3; ++k)
    {
      const int next = c[(k + 1) % 3], last = c[(k + 2) % 3];
      const Vector3 u = patch.points[next] - patch.points[c[k]], v = patch.points[last] - patch.points[c[k]];
      const double twice = u.cross(v).norm();
      mass[c[k]] += twice / 6.0;
      flow[adjacency.findEdge(next, last)] += twice > 0.0 ? 0.5 * square * u.dot(v) / twice : 0.0;
    }
  }
  std::vector<int> free, number(patch.points.size(), -1);
  std::vector<Vector3> places;
  std::vector<double> diagonal;
  for (int v = 0; v < patch.vertexCount(); ++v)
  {
    if (!held[v])
    {
      number[v] = static_cast<int>(free.size());
      free.push_back(v);
      places.push_back(patch.points[v]);
      diagonal.push_back(mass[v]);
    }
  }
  if (free.empty())
  {
    return;
  }
  const BlockMatrix matrix = weightMatrix(adjacency, flow, free, number, diagonal);
  Eigen::MatrixXd side(static_cast<Eigen::Index>(free.size()), 1);
  for (std::size_t i = 0; i < free.size(); ++i)
  {
    const int v = free[i];
    double sum = mass[v] * field[v];
    for (const int n : adjacency.vertexVertices[v])
    {
      sum += held[n] ? flow[adjacency.findEdge(v, n)] * field[n] : 0.0;
    }
    side(static_cast<Eigen::Index>(i), 0) = sum;
  }
  Cholesky factor(std::make_shared<const Elimination>(matrix.pattern, places, context));
  if (!factor.factorise(matrix, context))
  {
    throw Error(Failure::SolveFailed, "The region's shading could not be smoothed; clean the mesh first.");
  }
  factor.solve(side, context);
  for (std::size_t i = 0; i < free.size(); ++i)
  {
    field[free[i]] = std::clamp(side(static_cast<Eigen::Index>(i), 0), 0.0, 1.0);
  }
}

// The neighbours of a vertex inside, counter-clockwise seen from outside, with the angle turned so far, of
// 2 pi for all of it.
std::vector<std::pair<int, double>> anglesRound(const Mesh& mesh, const Adjacency& adjacency, int vertex)
{
  std::vector<std::array<int, 2>> steps; // from a neighbour to the next
  for (const int t : adjacency.vertexTriangles[vertex])
  {
    const Triangle& c = mesh.triangles[t];
    const int k = cornerOf(c, vertex);
    steps.push_back({ c[(k + 1) % 3], c[(k + 2) % 3] });
  }
  std::vector<std::pair<int, double>> round;
  double sum = 0.0;
  for (auto step = steps.begin(); round.size() < steps.size() && step != steps.end();)
  {
    round.emplace_back((*step)[0], sum);
    const Vector3 a = mesh.points[(*step)[0]] - mesh.points[vertex],
                  b = mesh.points[(*step)[1]] - mesh.points[vertex];
    sum += std::atan2(a.cross(b).norm(), a.dot(b));
    const int next = (*step)[1];
    step = std::find_if(steps.begin(), steps.end(), [&](const auto& other) { return other[0] == next; });
  }
  for (auto& [neighbour, angle] : round)
  {
    angle *= 2.0 * M_PI / sum;
  }
  return round;
}

void checkChain(const Mesh& patch,
  const Adjacency& adjacency,
  const std::vector<int>& reference,
  const std::vector<char>& onBorder)
{
  bool good = reference.size() >= 2;
  for (std::size_t i = 0; good && i < reference.size(); ++i)
  {
    good = reference[i] >= 0 && reference[i] < patch.vertexCount() && !onBorder[reference[i]] &&
           (i == 0 || adjacency.findEdge(reference[i - 1], reference[i]) >= 0);
  }
  if (!good)
  {
    throw Error(Failure::BadStroke,
      "{The reference curve} is not a chain of two or more vertices inside the region; lay it on the mesh "
      "anew.");
  }
}

std::optional<Directions> directionsUnless(bool straight,
  const Mesh& mesh,
  const Adjacency& adjacency,
  const Context& context)
{
  return straight ? std::nullopt : std::make_optional<Directions>(mesh, adjacency, context);
}

// Over the surface where there are directions, else through space.
ChainDistances distancesTo(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& chain,
  bool closed,
  const std::optional<Directions>& directions,
  const Context& context)
{
  const FeatureCurves curves{ curveOf(mesh, chain, closed) };
  const CurveSearch search(curves);
  ChainDistances result;
  result.distance.resize(mesh.points.size());
  result.place.resize(mesh.points.size());
  context.eachUntilCancelled(mesh.vertexCount(),
    [&](int v)
    {
      const NearestOnCurve nearest = search.nearest(0, mesh.points[v]);
      result.distance[v] = nearest.distance;
      result.place[v] = nearest.parameter;
    });
  context.checkpoint(0.0);
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    result.distance[chain[i]] = 0.0;
    result.place[chain[i]] = curves[0].arc[i];
  }
  if (directions)
  {
    marchFront(mesh, adjacency, *directions, chain, curves[0], result, context);
  }
  return result;
}

} // namespace

ChainDistances chainDistances(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& chain,
  bool closed,
  bool straight,
  const Context& context)
{
  return distancesTo(
    mesh, adjacency, chain, closed, directionsUnless(straight, mesh, adjacency, context), context);
}

std::vector<signed char> chainSides(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& chain)
{
  std::vector<signed char> side(mesh.points.size(), 0);
  std::vector<char> done = marksAt(chain, mesh.points.size());
  struct Way
  {
    double length;
    int vertex;
    signed char side;
    bool operator>(const Way& other) const
    {
      return std::tie(this->length, this->vertex, this->side) >
             std::tie(other.length, other.vertex, other.side);
    }
  };
  std::priority_queue<Way, std::vector<Way>, std::greater<>> queue;
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    const std::vector<std::pair<int, double>> round = anglesRound(mesh, adjacency, chain[i]);
    const auto angleTo = [&](int v)
    {
      const auto found =
        std::find_if(round.begin(), round.end(), [v](const auto& each) { return each.first == v; });
      return found == round.end() ? 0.0 : found->second;
    };
    const double before = i > 0 ? angleTo(chain[i - 1]) : angleTo(chain[i + 1]) + M_PI;
    const double after = i + 1 < chain.size() ? angleTo(chain[i + 1]) : angleTo(chain[i - 1]) + M_PI;
    const auto turned = [&](double angle) { return std::fmod(angle - after + 4.0 * M_PI, 2.0 * M_PI); };
    for (const auto& [v, angle] : round)
    {
      if (!done[v])
      {
        const signed char which = turned(angle) < turned(before) ? 1 : -1;
        queue.push({ (mesh.points[v] - mesh.points[chain[i]]).norm(), v, which });
      }
    }
  }
  while (!queue.empty())
  {
    const Way way = queue.top();
    queue.pop();
    if (done[way.vertex])
    {
      continue;
    }
    done[way.vertex] = 1;
    side[way.vertex] = way.side;
    for (const int n : adjacency.vertexVertices[way.vertex])
    {
      if (!done[n])
      {
        queue.push({ way.length + (mesh.points[n] - mesh.points[way.vertex]).norm(), n, way.side });
      }
    }
  }
  return side;
}

CurveFields curveFields(const Mesh& patch,
  const std::vector<int>& reference,
  const FieldRules& rules,
  const Context& context)
{
  const Adjacency adjacency = buildAdjacency(patch, context);
  const std::vector<int> border = discBorder(patch, adjacency);
  std::vector<char> fixed = marksAt(border, patch.points.size());
  checkChain(patch, adjacency, reference, fixed);

  const std::optional<Directions> directions = directionsUnless(rules.straight, patch, adjacency, context);
  const ChainDistances inner = distancesTo(patch, adjacency, reference, false, directions, context);
  const ChainDistances outer = distancesTo(patch, adjacency, border, true, directions, context);
  const double length = curveOf(patch, reference, false).length;
  CurveFields fields;
  std::vector<double> whole;
  for (std::size_t v = 0; v < patch.points.size(); ++v)
  {
    whole.push_back(inner.distance[v] + outer.distance[v]);
    fields.share.push_back(fixed[v] ? 1.0 : inner.distance[v] / whole.back());
    fields.parameter.push_back(inner.place[v] / length);
  }

  std::vector<char> onReference(patch.points.size(), 0);
  for (const int v : reference)
  {
    onReference[v] = fixed[v] = 1;
  }
  const auto smoothed = [&](double c, const std::vector<char>& held, std::vector<double>& field)
  {
    if (c > 0.0)
    {
      const auto room = mapped(whole, [c](double w) { return c * w; });
      smoothField(patch, adjacency, room, held, field, context);
    }
  };
  smoothed(rules.smoothing, fixed, fields.share);
  smoothed(rules.parameterSmoothing, onReference, fields.parameter);
  fields.side = chainSides(patch, adjacency, reference);
  return fields;
}

} // namespace oversketch
