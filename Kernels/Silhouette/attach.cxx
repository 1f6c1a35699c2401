#include "Silhouette/attach.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

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

// A smoothed loop, and what hangs on it.
struct LoopTrack
{
  Polyline points;
  std::vector<double> lengths;
  NearestPlace nearest;
  bool closed;
  double whole() const { return this->lengths.back(); }
};

struct Attachment
{
  int loop = -1;
  NearestPlace::Answer place;
  double along = 0.0; // px along the loop
  Vector2 offset = Vector2::Zero();
  int curve = -1, point = -1;
  Binding edge{};
};

std::vector<LoopTrack> tracksOf(const std::vector<OutlineLoop>& loops)
{
  std::vector<LoopTrack> tracks;
  for (const OutlineLoop& loop : loops)
  {
    const Polyline smooth = smoothLoop(loop.points, loop.closed);
    tracks.push_back(
      { smooth, arcLengths(smooth, loop.closed), NearestPlace(smooth, loop.closed), loop.closed });
  }
  return tracks;
}

// One silhouette curve against the loops: which of its points hang on which.
class CurveAttacher
{
public:
  CurveAttacher(const std::vector<LoopTrack>& tracks,
    const VisibleCurve& curve,
    int number,
    double attachDistance)
    : Tracks(tracks)
    , Curve(curve)
    , Count(static_cast<int>(curve.display.size()))
    , AttachDistance(attachDistance)
    , Found(curve.display.size())
  {
    for (int i = 0; i < this->Count; ++i)
    {
      this->findNearest(i, number);
    }
    double run = 0.0;
    for (int i = 0; i < this->Count; ++i)
    {
      const int j = this->next(i);
      run += j >= 0 && this->together(i, j) ? this->progress(i, j) : 0.0;
    }
    this->Sign = run < 0.0 ? -1.0 : 1.0;
  }

  // Adds those that run along their loop to the loop's attachments.
  void addTo(std::vector<std::vector<Attachment>>& attached) const
  {
    for (int i = 0; i < this->Count; ++i)
    {
      if (this->Found[i].loop < 0)
      {
        continue;
      }
      const int after = this->next(i), before = this->previous(i);
      const int ahead = after >= 0 ? this->verdict(i, after) : 0,
                behind = before >= 0 ? this->verdict(before, i) : 0;
      if (ahead > 0 || behind > 0 || (ahead == 0 && behind == 0))
      {
        attached[this->Found[i].loop].push_back(this->Found[i]);
      }
    }
  }

private:
  void findNearest(int i, int number)
  {
    double limit =
      this->Curve.reach.empty() ? this->AttachDistance : std::min(this->AttachDistance, this->Curve.reach[i]);
    Attachment& found = this->Found[i];
    for (int l = 0; l < static_cast<int>(this->Tracks.size()); ++l)
    {
      const NearestPlace::Answer place = this->Tracks[l].nearest(this->Curve.display[i], limit);
      if (place.segment >= 0 && (found.loop < 0 || place.distance < limit))
      {
        const std::vector<double>& lengths = this->Tracks[l].lengths;
        limit = place.distance;
        found = { l, place, place.along(lengths), this->Curve.display[i] - place.place, number, i };
      }
    }
  }

  int next(int i) const { return i + 1 < this->Count ? i + 1 : this->Curve.closed ? 0 : -1; }
  int previous(int i) const { return i > 0 ? i - 1 : this->Curve.closed ? this->Count - 1 : -1; }
  bool together(int i, int j) const
  {
    return this->Found[i].loop >= 0 && this->Found[i].loop == this->Found[j].loop;
  }

  // The step from point i to the next, along the loop they both hang on.
  double progress(int i, int j) const
  {
    const LoopTrack& track = this->Tracks[this->Found[i].loop];
    double step = this->Found[j].along - this->Found[i].along;
    if (track.closed && std::abs(step) > 0.5 * track.whole())
    {
      step -= std::copysign(track.whole(), step);
    }
    return step;
  }

  // +1: the step runs along the loop; -1: it runs back or leaves it sideways; 0: nothing to tell.
  int verdict(int i, int j) const
  {
    const double length = (this->Curve.display[j] - this->Curve.display[i]).norm();
    if (this->together(i, j))
    {
      return this->Sign * this->progress(i, j) >= 0.3 * length ? 1 : length < 0.25 ? 0 : -1;
    }
    return length > 2.0 * this->AttachDistance ? 0 : -1; // a long step says nothing of its ends
  }

  const std::vector<LoopTrack>& Tracks;
  const VisibleCurve& Curve;
  const int Count;
  const double AttachDistance;
  std::vector<Attachment> Found; // per point of the curve
  double Sign = 1.0;             // of its way along the loops
};

// Where curves cross in the picture the ends of their visible parts are at one place but for rounding: the
// curves' numbers decide there, edges come last.
void sortAlong(std::vector<Attachment>& list)
{
  constexpr double samePlace = 1e-6; // px
  std::stable_sort(list.begin(),
    list.end(),
    [](const Attachment& a, const Attachment& b)
    { return std::tie(a.place.segment, a.along) < std::tie(b.place.segment, b.along); });
  for (auto first = list.begin(); first != list.end();)
  {
    auto last = std::next(first);
    while (last != list.end() && last->place.segment == first->place.segment &&
           last->along - std::prev(last)->along < samePlace)
    {
      ++last;
    }
    std::stable_sort(first,
      last,
      [](const Attachment& a, const Attachment& b)
      { return static_cast<unsigned>(a.curve) < static_cast<unsigned>(b.curve); });
    first = last;
  }
}

void addEdges(const OutlineLoop& loop, int number, const LoopTrack& track, std::vector<Attachment>& list)
{
  for (const int middle : edgeMiddles(loop))
  {
    Attachment edge;
    edge.loop = number;
    edge.place.segment = middle;
    edge.place.place = track.points[middle];
    edge.along = track.lengths[middle];
    edge.offset = loop.points[middle] - edge.place.place;
    edge.edge = loop.edges[middle];
    list.push_back(edge);
  }
  sortAlong(list);
}

// The offset of a loop point between two attached ones, the second of which is list[next].
Vector2 offsetBetween(const LoopTrack& track,
  const std::vector<Attachment>& list,
  double along,
  std::size_t next)
{
  if (list.empty())
  {
    return Vector2::Zero();
  }
  const bool wraps = next == 0 || next == list.size();
  const Attachment& a = wraps ? list.back() : list[next - 1];
  const Attachment& b = wraps ? list.front() : list[next];
  if (wraps && !track.closed)
  {
    return next == 0 ? b.offset : a.offset;
  }
  double gap = b.along - a.along, step = along - a.along;
  gap += wraps ? track.whole() : 0.0;
  step += step < 0.0 ? track.whole() : 0.0;
  return gap > 0.0 ? Vector2(a.offset + step / gap * (b.offset - a.offset)) : a.offset;
}

// The points of a loop, and what hangs on it, in their order along it.
std::vector<OutlineStation> stationsOf(const LoopTrack& track, const std::vector<Attachment>& list)
{
  std::vector<OutlineStation> stations;
  std::size_t k = 0;
  for (int i = 0; i < static_cast<int>(track.points.size()); ++i)
  {
    // A loop point that stands for a mesh edge takes its own place.
    const bool own = k < list.size() && list[k].place.segment == i && list[k].curve < 0;
    if (!own)
    {
      stations.push_back(
        { track.points[i], offsetBetween(track, list, track.lengths[i], k), -1, -1, Binding() });
    }
    for (; k < list.size() && list[k].place.segment == i; ++k)
    {
      stations.push_back({ list[k].place.place, list[k].offset, list[k].curve, list[k].point, list[k].edge });
    }
  }
  return stations;
}

} // namespace

std::vector<std::vector<OutlineStation>> attachSilhouette(const std::vector<OutlineLoop>& loops,
  const std::vector<VisibleCurve>& curves,
  double attachDistance,
  bool bindEdges)
{
  const std::vector<LoopTrack> tracks = tracksOf(loops);
  std::vector<std::vector<Attachment>> attached(loops.size());
  for (int c = 0; c < static_cast<int>(curves.size()); ++c)
  {
    CurveAttacher(tracks, curves[c], c, attachDistance).addTo(attached);
  }
  std::vector<std::vector<OutlineStation>> outlines;
  for (int l = 0; l < static_cast<int>(loops.size()); ++l)
  {
    sortAlong(attached[l]);
    if (bindEdges)
    {
      addEdges(loops[l], l, tracks[l], attached[l]);
    }
    outlines.push_back(stationsOf(tracks[l], attached[l]));
  }
  return outlines;
}

} // namespace oversketch
