#include "Silhouette/attach.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

// The loop point in the middle of each run of points on one mesh edge.
std::vector<int> edgeMiddles(const OutlineLoop& loop)
{
  const int count = static_cast<int>(loop.points.size());
  std::vector<int> middles;
  for (int begin = 0, end = 0; begin < count; begin = end)
  {
    while (end < count && loop.edges[end].vertices == loop.edges[begin].vertices)
    {
      ++end;
    }
    if (loop.edges[begin].vertices[0] >= 0)
    {
      middles.push_back(begin + (end - begin) / 2);
    }
  }
  return middles;
}

} // namespace

std::vector<std::vector<OutlineStation>> attachSilhouette(const std::vector<OutlineLoop>& loops,
  const std::vector<VisibleCurve>& curves,
  double attachDistance,
  bool bindEdges)
{
  struct Track
  {
    Polyline points;
    std::vector<double> lengths;
    NearestPlace nearest;
    bool closed;
    double whole() const { return this->lengths.back(); }
  };
  std::vector<Track> tracks;
  for (const OutlineLoop& loop : loops)
  {
    const Polyline smooth = smoothLoop(loop.points, loop.closed);
    tracks.push_back(
      { smooth, arcLengths(smooth, loop.closed), NearestPlace(smooth, loop.closed), loop.closed });
  }
  struct Attachment
  {
    int loop = -1;
    NearestPlace::Answer place;
    double along = 0.0; // px along the loop
    Vector2 offset = Vector2::Zero();
    int curve = -1, point = -1;
    Binding edge{};
  };
  std::vector<std::vector<Attachment>> attached(loops.size());
  for (int c = 0; c < static_cast<int>(curves.size()); ++c)
  {
    const VisibleCurve& curve = curves[c];
    const int count = static_cast<int>(curve.display.size());
    std::vector<Attachment> found(curve.display.size());
    for (int i = 0; i < count; ++i)
    {
      double limit = curve.reach.empty() ? attachDistance : std::min(attachDistance, curve.reach[i]);
      for (int l = 0; l < static_cast<int>(tracks.size()); ++l)
      {
        const NearestPlace::Answer place = tracks[l].nearest(curve.display[i], limit);
        if (place.segment >= 0 && (found[i].loop < 0 || place.distance < limit))
        {
          const std::vector<double>& lengths = tracks[l].lengths;
          limit = place.distance;
          found[i] = { l,
            place,
            lengths[place.segment] + place.t * (lengths[place.segment + 1] - lengths[place.segment]),
            curve.display[i] - place.place,
            c,
            i };
        }
      }
    }
    // The step from point i to the next, along the loop they both hang on.
    const auto next = [&](int i) { return i + 1 < count ? i + 1 : curve.closed ? 0 : -1; };
    const auto progress = [&](int i, int j)
    {
      const Track& track = tracks[found[i].loop];
      double step = found[j].along - found[i].along;
      if (track.closed && std::abs(step) > 0.5 * track.whole())
      {
        step -= std::copysign(track.whole(), step);
      }
      return step;
    };
    const auto together = [&](int i, int j) { return found[i].loop >= 0 && found[i].loop == found[j].loop; };
    double run = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const int j = next(i);
      run += j >= 0 && together(i, j) ? progress(i, j) : 0.0;
    }
    const double sign = run < 0.0 ? -1.0 : 1.0;
    // +1: the step runs along the loop; -1: it runs back or leaves it sideways; 0: nothing to tell.
    const auto verdict = [&](int i, int j)
    {
      const double length = (curve.display[j] - curve.display[i]).norm();
      if (together(i, j))
      {
        return sign * progress(i, j) >= 0.3 * length ? 1 : length < 0.25 ? 0 : -1;
      }
      return length > 2.0 * attachDistance ? 0 : -1; // a long step says nothing of its ends
    };
    for (int i = 0; i < count; ++i)
    {
      if (found[i].loop < 0)
      {
        continue;
      }
      const int after = next(i), before = i > 0 ? i - 1 : curve.closed ? count - 1 : -1;
      const int ahead = after >= 0 ? verdict(i, after) : 0, behind = before >= 0 ? verdict(before, i) : 0;
      if (ahead > 0 || behind > 0 || (ahead == 0 && behind == 0))
      {
        attached[found[i].loop].push_back(found[i]);
      }
    }
  }

  std::vector<std::vector<OutlineStation>> outlines(loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    const Track& track = tracks[l];
    std::vector<Attachment>& list = attached[l];
    std::stable_sort(
      list.begin(), list.end(), [](const Attachment& a, const Attachment& b) { return a.along < b.along; });
    if (bindEdges)
    {
      for (const int middle : edgeMiddles(loops[l]))
      {
        Attachment edge;
        edge.loop = static_cast<int>(l);
        edge.place.segment = middle;
        edge.place.place = track.points[middle];
        edge.along = track.lengths[middle];
        edge.offset = loops[l].points[middle] - edge.place.place;
        edge.edge = loops[l].edges[middle];
        list.push_back(edge);
      }
      std::stable_sort(
        list.begin(), list.end(), [](const Attachment& a, const Attachment& b) { return a.along < b.along; });
    }
    // The offset of a loop point between two attached ones.
    const auto offsetAt = [&](double along, std::size_t nextIndex)
    {
      if (list.empty())
      {
        return Vector2(Vector2::Zero());
      }
      const bool wraps = nextIndex == 0 || nextIndex == list.size();
      const Attachment& a = wraps ? list.back() : list[nextIndex - 1];
      const Attachment& b = wraps ? list.front() : list[nextIndex];
      if (wraps && !track.closed)
      {
        return nextIndex == 0 ? b.offset : a.offset;
      }
      double gap = b.along - a.along, step = along - a.along;
      gap += wraps ? track.whole() : 0.0;
      step += step < 0.0 ? track.whole() : 0.0;
      return Vector2(gap > 0.0 ? a.offset + step / gap * (b.offset - a.offset) : a.offset);
    };
    std::size_t k = 0;
    for (int i = 0; i < static_cast<int>(track.points.size()); ++i)
    {
      // A loop point that stands for a mesh edge takes its own place.
      const bool own = k < list.size() && list[k].place.segment == i && list[k].curve < 0;
      if (!own)
      {
        outlines[l].push_back({ track.points[i], offsetAt(track.lengths[i], k), -1, -1, Binding() });
      }
      for (; k < list.size() && list[k].place.segment == i; ++k)
      {
        outlines[l].push_back(
          { list[k].place.place, list[k].offset, list[k].curve, list[k].point, list[k].edge });
      }
    }
  }
  return outlines;
}

} // namespace oversketch
