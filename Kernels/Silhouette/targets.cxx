#include "Silhouette/targets.h"

#include "Mesh/shape.h"
#include "Silhouette/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
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

Polyline displayOf(const std::vector<SectionPoint>& section)
{
  Polyline curve;
  for (const SectionPoint& p : section)
  {
    curve.push_back(p.display);
  }
  return curve;
}

// The layers of handles, and which of them stay (see keepOneLayer).
class LayerChooser
{
public:
  LayerChooser(const std::vector<Handle>& handles,
    const std::vector<SectionPoint>& section,
    const Mesh& mesh,
    const Adjacency& adjacency,
    const View& view)
    : Handles(handles)
    , Section(section)
    , Model(mesh)
    , Neighbours(adjacency)
    , Count(static_cast<int>(handles.size()))
    , Leader(handles.size())
  {
    this->Along = arcLengths(displayOf(section));
    this->joinNeighbours();
    if (this->rankLayers())
    {
      this->measure(view);
      this->Kept.resize(handles.size());
      for (int h = 0; h < this->Count; ++h)
      {
        this->Kept[h] = this->layerOf(h) == this->Main;
      }
      // The nearest layer within reach joins; what it brings may reach further ones.
      while (this->joinOne())
      {
      }
    }
  }

  std::vector<Handle> kept() const
  {
    return this->Kept.empty() ? this->Handles : valuesAt(this->Handles, marked(this->Kept));
  }

private:
  const SectionPoint& pointOf(int h) const { return this->Section[this->Handles[h].point]; }
  const std::array<int, 3>& verticesOf(int h) const { return this->pointOf(h).binding.vertices; }
  // Where a handle is along the section [px].
  double at(int h) const { return this->Along[this->Handles[h].point]; }

  // A layer goes by its first handle.
  int layerOf(int h)
  {
    while (this->Leader[h] != h)
    {
      h = this->Leader[h] = this->Leader[this->Leader[h]];
    }
    return h;
  }

  void join(int a, int b)
  {
    a = this->layerOf(a);
    b = this->layerOf(b);
    this->Leader[std::max(a, b)] = std::min(a, b);
  }

  // Handles whose vertices coincide or are neighbours are of one layer.
  void joinNeighbours()
  {
    std::iota(this->Leader.begin(), this->Leader.end(), 0);
    std::vector<int> handleAt(this->Model.points.size(), -1);
    for (int h = 0; h < this->Count; ++h)
    {
      for (const int v : this->verticesOf(h))
      {
        if (handleAt[v] >= 0)
        {
          this->join(h, handleAt[v]);
        }
        handleAt[v] = h;
      }
    }
    const Lists& neighbours = this->Neighbours.vertexVertices;
    for (int h = 0; h < this->Count; ++h)
    {
      for (const int v : this->verticesOf(h))
      {
        for (const int n : neighbours[v])
        {
          if (handleAt[n] >= 0)
          {
            this->join(h, handleAt[n]);
          }
        }
      }
    }
  }

  // Finds the layer that covers most: the gaps between its own neighbours, none counted beyond a tenth of the
  // section. False where there is only one.
  bool rankLayers()
  {
    std::vector<double> covers(this->Handles.size(), 0.0);
    std::vector<int> previous(this->Handles.size(), -1), layers;
    for (int h = 0; h < this->Count; ++h)
    {
      const int layer = this->layerOf(h);
      if (previous[layer] < 0)
      {
        layers.push_back(layer);
      }
      else
      {
        covers[layer] += std::min(this->at(h) - this->at(previous[layer]), 0.1 * this->Along.back());
      }
      previous[layer] = h;
    }
    if (layers.size() < 2)
    {
      return false;
    }
    this->Main =
      *std::max_element(layers.begin(), layers.end(), [&](int a, int b) { return covers[a] < covers[b]; });
    std::copy_if(layers.begin(),
      layers.end(),
      std::back_inserter(this->Open),
      [this](int layer) { return layer != this->Main; });
    return true;
  }

  // Sizes that turn gaps in the image plane into geodesic lengths.
  void measure(const View& view)
  {
    const Lists& neighbours = this->Neighbours.vertexVertices;
    int edges = 0;
    for (int h = 0; h < this->Count; ++h)
    {
      const SectionPoint& q = this->pointOf(h);
      for (const int v : q.binding.vertices)
      {
        for (const int n : neighbours[v])
        {
          this->Edge += (this->Model.points[n] - this->Model.points[v]).norm();
          ++edges;
        }
      }
      const double depth = view.depth(q.position);
      this->Pixel +=
        (view.toWorld(q.display + Vector2(1.0, 0.0), depth) - view.toWorld(q.display, depth)).norm() /
        this->Count;
    }
    this->Edge = edges > 0 ? this->Edge / edges : 0.0;
  }

  double reachOver(double gap) const { return 2.5 * gap * this->Pixel + 6.0 * this->Edge; }

  // Gap of each open layer to what is kept, along the section.
  std::vector<double> gaps()
  {
    std::vector<double> gap(this->Handles.size(), infinite);
    for (const bool forward : { true, false })
    {
      double last = infinite;
      for (int k = 0; k < this->Count; ++k)
      {
        const int h = forward ? k : this->Count - 1 - k;
        if (this->Kept[h])
        {
          last = this->at(h);
        }
        else
        {
          double& least = gap[this->layerOf(h)];
          least = std::min(least, std::abs(this->at(h) - last));
        }
      }
    }
    return gap;
  }

  // Way along edges from each open layer to what is kept, as far as it matters.
  std::vector<double> ways(const std::vector<double>& gap)
  {
    std::vector<int> sources;
    double reach = 0.0;
    for (int h = 0; h < this->Count; ++h)
    {
      if (this->Kept[h])
      {
        sources.insert(sources.end(), this->verticesOf(h).begin(), this->verticesOf(h).end());
      }
      else
      {
        reach = std::max(reach, this->reachOver(gap[this->layerOf(h)]));
      }
    }
    const std::vector<double> distance = edgeDistances(this->Model, this->Neighbours, sources, reach);
    std::vector<double> way(this->Handles.size(), infinite);
    for (int h = 0; h < this->Count; ++h)
    {
      for (const int v : this->verticesOf(h))
      {
        double& least = way[this->layerOf(h)];
        least = std::min(least, distance[v]);
      }
    }
    return way;
  }

  bool joinOne()
  {
    if (this->Open.empty())
    {
      return false;
    }
    const std::vector<double> gap = this->gaps(), way = this->ways(gap);
    int joins = -1;
    for (const int layer : this->Open)
    {
      if (way[layer] <= this->reachOver(gap[layer]) && (joins < 0 || gap[layer] < gap[joins]))
      {
        joins = layer;
      }
    }
    if (joins < 0)
    {
      return false;
    }
    for (int h = 0; h < this->Count; ++h)
    {
      this->Kept[h] = this->Kept[h] || this->layerOf(h) == joins;
    }
    this->Open.erase(std::find(this->Open.begin(), this->Open.end(), joins));
    return true;
  }

  static constexpr double infinite = std::numeric_limits<double>::infinity();

  const std::vector<Handle>& Handles;
  const std::vector<SectionPoint>& Section;
  const Mesh& Model;
  const Adjacency& Neighbours;
  const int Count;
  std::vector<double> Along; // lengths along the section in the image plane
  std::vector<int> Leader;   // per handle, towards the first one of its layer
  int Main = -1;             // the layer that covers most
  std::vector<int> Open;     // layers that have not joined
  std::vector<char> Kept;    // per handle; empty where there is one layer
  double Edge = 0.0;         // mean length of the mesh edges at the handles
  double Pixel = 0.0;        // a pixel's size in the world there
};

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
  const Polyline curve = displayOf(section);
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
      const double cosine = from.dot(to), sine = cross(from, to), norm = std::hypot(cosine, sine);
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
  return LayerChooser(handles, section, mesh, adjacency, view).kept();
}

std::vector<OutlineCorrection> correctOutline(const Mesh& deformed,
  const std::vector<char>& chosen,
  const Polyline& stroke,
  const View& view,
  double omega,
  double tolerance,
  double reach,
  const Context& context)
{
  constexpr double onOutline = 1.0; // px; the loop runs between pixel centres and cuts sharper corners
  const PixelWindow window = strokeWindow(stroke, reach + 2.0 * onOutline + 2.0);
  const std::vector<NearestPlace> loops = nearestPlaces(traceOutline(deformed, view, window, context));
  const NearestPlace pen(stroke);
  const std::vector<double> lengths = arcLengths(stroke);
  std::vector<OutlineCorrection> corrections;
  if (!(lengths.back() > 0.0))
  {
    return corrections;
  }
  for (int v = 0; v < deformed.vertexCount(); ++v)
  {
    if (!chosen[v] || !view.inFront(deformed.points[v]))
    {
      continue;
    }
    const Vector3 display = view.toDisplay(deformed.points[v]);
    const Vector2 place = display.head<2>();
    if (pen(place, reach + onOutline).segment < 0)
    {
      continue;
    }
    NearestPlace::Answer border;
    border.distance = onOutline;
    for (const NearestPlace& loop : loops)
    {
      const NearestPlace::Answer answer = loop(place, border.distance);
      if (answer.segment >= 0 && answer.distance <= border.distance)
      {
        border = answer;
      }
    }
    if (border.segment < 0)
    {
      continue;
    }
    const NearestPlace::Answer goal = pen(border.place, reach);
    if (goal.segment < 0 || goal.distance <= tolerance)
    {
      continue;
    }
    const double along = goal.along(lengths);
    const double relative = along / lengths.back();
    if (relative >= omega && relative <= 1.0 - omega)
    {
      corrections.push_back({ v, relative, view.toWorld(place + goal.place - border.place, display[2]) });
    }
  }
  return corrections;
}

} // namespace oversketch
