#include "Silhouette/targets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace oversketch
{

namespace
{

// Direction of a curve round a place, over some pixels so that a single sample does not decide.
Vector2 directionAt(const Polyline& points, const std::vector<double>& lengths, double length)
{
  const double reach = std::min(4.0, 0.1 * lengths.back()); // px
  const int count = static_cast<int>(points.size());
  return placeAt(lengths, count, length + reach).of(points) -
         placeAt(lengths, count, length - reach).of(points);
}

} // namespace

double mergeRatio(double r, double omega)
{
  if (r < omega)
  {
    return std::sqrt(std::max(r, 0.0) / omega);
  }
  if (r > 1.0 - omega)
  {
    return std::sqrt(std::max(1.0 - r, 0.0) / omega);
  }
  return 1.0;
}

std::vector<Handle> mapTargets(const std::vector<SectionPoint>& section,
  const Polyline& stroke,
  const View& view,
  double omega)
{
  Polyline curve;
  for (const SectionPoint& p : section)
  {
    curve.push_back(p.display);
  }
  const std::vector<double> along = arcLengths(curve);
  const std::vector<double> strokeAlong = arcLengths(stroke);
  const auto bound = std::count_if(
    section.begin(), section.end(), [](const SectionPoint& p) { return p.binding.vertices[0] >= 0; });
  if (bound < 2 || !(along.back() > 0.0))
  {
    throw Error(Failure::NoMatch,
      "The section has fewer than two control points on the mesh, or no length in the image plane; match the "
      "stroke to "
      "another curve.");
  }
  if (stroke.size() < 2 || !(strokeAlong.back() > 0.0))
  {
    throw Error(Failure::BadStroke, "The stroke has no length; draw a longer one.");
  }
  const int strokeCount = static_cast<int>(stroke.size());
  std::vector<Handle> handles;
  for (std::size_t j = 0; j < section.size(); ++j)
  {
    const SectionPoint& q = section[j];
    if (q.binding.vertices[0] < 0)
    {
      continue;
    }
    const double r = along[j] / along.back();
    const double length = r * strokeAlong.back();
    Vector2 offset = q.offset;
    if (!offset.isZero(0.0))
    {
      // The offset stands across the curve: where the stroke bends the limb, it turns along.
      const Vector2 from = directionAt(curve, along, along[j]), to = directionAt(stroke, strokeAlong, length);
      const double cosine = from.dot(to), sine = from[0] * to[1] - from[1] * to[0],
                   norm = std::hypot(cosine, sine);
      if (norm > 0.0)
      {
        offset = Vector2(cosine * offset[0] - sine * offset[1], sine * offset[0] + cosine * offset[1]) / norm;
      }
    }
    const Vector2 place = placeAt(strokeAlong, strokeCount, length).of(stroke) + offset;
    // As a difference of two points on one plane, so that rounding adds no movement along the view.
    const Vector3 present = view.toDisplay(q.position);
    const Vector3 move = view.toWorld(place, present[2]) - view.toWorld(q.display + q.offset, present[2]);
    Handle handle;
    handle.point = static_cast<int>(j);
    handle.relative = r;
    handle.unmerged = q.position + move;
    handle.target = q.position + mergeRatio(r, omega) * move;
    handles.push_back(handle);
  }
  return handles;
}

double curveLength(const std::vector<Vector3>& points)
{
  double length = 0.0;
  Vector3 last = Vector3::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    Vector3 p = points[i];
    if (i >= 2 && i + 2 < points.size())
    {
      p = (points[i - 2] + 4.0 * points[i - 1] + 6.0 * p + 4.0 * points[i + 1] + points[i + 2]) / 16.0;
    }
    length += i > 0 ? (p - last).norm() : 0.0;
    last = p;
  }
  return length;
}

std::vector<Handle> keepOneLayer(const std::vector<Handle>& handles,
  const std::vector<SectionPoint>& section,
  const Mesh& mesh,
  const Adjacency& adjacency,
  const View& view)
{
  const int count = static_cast<int>(handles.size());
  const auto binding = [&](int h) -> const Binding& { return section[handles[h].point].binding; };

  // Layers: handles whose vertices coincide or are neighbours, found by union over the vertices.
  std::vector<int> leader(count);
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](int h)
  {
    while (leader[h] != h)
    {
      h = leader[h] = leader[leader[h]];
    }
    return h;
  };
  const auto join = [&](int a, int b)
  {
    a = find(a);
    b = find(b);
    leader[std::max(a, b)] = std::min(a, b);
  };
  std::vector<int> handleAt(mesh.points.size(), -1);
  for (int h = 0; h < count; ++h)
  {
    for (const int v : binding(h).vertices)
    {
      if (handleAt[v] >= 0)
      {
        join(h, handleAt[v]);
      }
      handleAt[v] = h;
    }
  }
  for (int h = 0; h < count; ++h)
  {
    for (const int v : binding(h).vertices)
    {
      for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
      {
        if (handleAt[*n] >= 0)
        {
          join(h, handleAt[*n]);
        }
      }
    }
  }

  // Lengths along the section in the image plane; a pixel's size in the world turns gaps into geodesic
  // lengths.
  Polyline curve;
  for (const SectionPoint& p : section)
  {
    curve.push_back(p.display);
  }
  const std::vector<double> along = arcLengths(curve);
  const auto at = [&](int h) { return along[handles[h].point]; };

  // What each layer covers: the gaps between its own neighbours, none counted beyond a tenth of the section.
  std::vector<double> covers(count, 0.0);
  std::vector<int> previous(count, -1), layers;
  for (int h = 0; h < count; ++h)
  {
    const int layer = find(h);
    if (previous[layer] < 0)
    {
      layers.push_back(layer);
    }
    else
    {
      covers[layer] += std::min(at(h) - at(previous[layer]), 0.1 * along.back());
    }
    previous[layer] = h;
  }
  if (layers.size() < 2)
  {
    return handles;
  }
  const int main =
    *std::max_element(layers.begin(), layers.end(), [&](int a, int b) { return covers[a] < covers[b]; });

  double edge = 0.0, pixel = 0.0;
  int edges = 0;
  for (int h = 0; h < count; ++h)
  {
    const SectionPoint& q = section[handles[h].point];
    for (const int v : q.binding.vertices)
    {
      for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
      {
        edge += (mesh.points[*n] - mesh.points[v]).norm();
        ++edges;
      }
    }
    const double depth = view.depth(q.position);
    pixel +=
      (view.toWorld(q.display + Vector2(1.0, 0.0), depth) - view.toWorld(q.display, depth)).norm() / count;
  }
  edge = edges > 0 ? edge / edges : 0.0;

  std::vector<char> kept(count, 0);
  for (int h = 0; h < count; ++h)
  {
    kept[h] = find(h) == main;
  }
  std::vector<int> open;
  std::copy_if(
    layers.begin(), layers.end(), std::back_inserter(open), [main](int layer) { return layer != main; });
  while (!open.empty())
  {
    // Gap of each open layer to what is kept, along the section.
    std::vector<double> gap(count, std::numeric_limits<double>::infinity());
    for (const bool forward : { true, false })
    {
      double last = std::numeric_limits<double>::infinity();
      for (int k = 0; k < count; ++k)
      {
        const int h = forward ? k : count - 1 - k;
        if (kept[h])
        {
          last = at(h);
        }
        else
        {
          gap[find(h)] = std::min(gap[find(h)], std::abs(at(h) - last));
        }
      }
    }
    std::vector<int> sources;
    double reach = 0.0;
    for (int h = 0; h < count; ++h)
    {
      if (kept[h])
      {
        sources.insert(sources.end(), binding(h).vertices.begin(), binding(h).vertices.end());
      }
      else
      {
        reach = std::max(reach, 2.5 * gap[find(h)] * pixel + 6.0 * edge);
      }
    }
    const std::vector<double> distance = edgeDistances(mesh, adjacency, sources, reach);
    std::vector<double> geodesic(count, std::numeric_limits<double>::infinity());
    for (int h = 0; h < count; ++h)
    {
      for (const int v : binding(h).vertices)
      {
        geodesic[find(h)] = std::min(geodesic[find(h)], distance[v]);
      }
    }
    // The nearest layer within reach joins; what it brings may reach further ones.
    int joins = -1;
    for (const int layer : open)
    {
      if (geodesic[layer] <= 2.5 * gap[layer] * pixel + 6.0 * edge && (joins < 0 || gap[layer] < gap[joins]))
      {
        joins = layer;
      }
    }
    if (joins < 0)
    {
      break;
    }
    for (int h = 0; h < count; ++h)
    {
      kept[h] = kept[h] || find(h) == joins;
    }
    open.erase(std::find(open.begin(), open.end(), joins));
  }
  std::vector<Handle> result;
  for (int h = 0; h < count; ++h)
  {
    if (kept[h])
    {
      result.push_back(handles[h]);
    }
  }
  return result;
}

} // namespace oversketch
