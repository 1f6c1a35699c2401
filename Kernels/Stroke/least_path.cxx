#include "Stroke/least_path.h"

#include "Mesh/mesh.h"
#include "Stroke/path_search.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

int indexOf(const PathField& field, const Pixel& pixel)
{
  const int x = pixel[0] - field.x0, y = pixel[1] - field.y0;
  return x < 0 || y < 0 || x >= field.width || y >= field.height ? -1 : y * field.width + x;
}

PathField wholeField(const EdgeFeatures& features)
{
  PathField field{ 0, 0, features.width, features.height, {}, {} };
  field.states.resize(features.edges.size());
  std::transform(features.edges.begin(),
    features.edges.end(),
    field.states.begin(),
    [](std::uint8_t edge) { return edge ? PathField::Edge : PathField::Plain; });
  return field;
}

std::vector<Pixel> leastPath(const EdgeFeatures& features,
  const PathField& field,
  const Pixel& from,
  const Pixel& to,
  const Context& context)
{
  return PathSearch()(features, field, { { from, 0.0 } }, { to }, context).pathTo(to);
}

double pathCost(const EdgeFeatures& features, const PathField& field, const std::vector<Pixel>& path)
{
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const Pixel &p = path[i - 1], &q = path[i];
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
    cost += (at >= 0 && field.states[at] == PathField::Edge ? 0.0 : PathWeights::edge) +
            PathWeights::turn * (std::acos(dp) + std::acos(dq)) / PathWeights::straightAngle +
            PathWeights::gradient * (diagonal ? flat : flat * std::sqrt(0.5));
  }
  return cost;
}

} // namespace oversketch
