#include "Planar/approximate.h"

#include "Planar/pieces.h"
#include "Planar/predicates.h"
#include "Planar/stroke_line.h"
#include "Stroke/meetings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace oversketch
{
namespace
{

constexpr double endRoom = 0.03;  // of a rim's piece, that a free end is off it
constexpr double endPiece = 0.02; // of L, of pieces that may be as short

// D of each sample [world]: the greatest of the 3 x 3 round it, then the median of nine along the stroke.
std::vector<double> thicknessAlong(const DrawnStroke& stroke, const DistanceMaps& maps)
{
  const Frame& frame = maps.frame;
  std::vector<double> greatest;
  for (const Vector2& place : stroke.points)
  {
    const Vector2 pixel = frame.toPixels(place);
    const int x = static_cast<int>(std::lround(std::clamp(pixel[0], 1.0, frame.width - 2.0)));
    const int y = static_cast<int>(std::lround(std::clamp(pixel[1], 1.0, frame.height - 2.0)));
    float most = 0.0f;
    for (int k = 0; k < 9; ++k)
    {
      most = std::max(most, maps.thickness[frame.index(x + k % 3 - 1, y + k / 3 - 1)]);
    }
    greatest.push_back(frame.spacing * most);
  }
  const int count = static_cast<int>(greatest.size());
  std::vector<double> result, window;
  for (int i = 0; i < count; ++i)
  {
    window.clear();
    for (int k = i - 4; k <= i + 4; ++k)
    {
      if (stroke.closed || (k >= 0 && k < count))
      {
        window.push_back(greatest[((k % count) + count) % count]);
      }
    }
    std::nth_element(window.begin(), window.begin() + window.size() / 2, window.end());
    result.push_back(window[window.size() / 2]);
  }
  return result;
}

// Whether a stroke is a rim of a region: its object's boundary or that of a hole in it.
bool isRimOf(int region, const StrokeClass& which, Treatment treatment)
{
  return which.region == region && (which.role == Role::Boundary ||
                                     (which.role == Role::ClosedFeature && treatment == Treatment::Hole));
}

// The rim's sample that an end of an open feature joins.
StrokeJoin joinOf(const Vector2& end,
  int region,
  const std::vector<DrawnStroke>& strokes,
  const std::vector<StrokeClass>& classes,
  const std::vector<Treatment>& treatments,
  double reach)
{
  StrokeJoin best;
  double least = reach > 0.0 ? reach : -1.0;
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    if (!isRimOf(region, classes[i], treatments[i]))
    {
      continue;
    }
    for (std::size_t k = 0; k < strokes[i].points.size(); ++k)
    {
      const Vector2& place = strokes[i].points[k];
      const double distance = (place - end).norm();
      const auto isLess = [&]
      {
        const Vector2& other = strokes[best.stroke].points[best.sample];
        return std::make_pair(place[0], place[1]) < std::make_pair(other[0], other[1]);
      };
      if (distance < least || (distance == least && (best.stroke < 0 || isLess())))
      {
        best = { static_cast<int>(i), static_cast<int>(k) };
        least = distance;
      }
    }
  }
  return best;
}

// Polylines in the making; none of a stroke that has none.
using Drafts = std::vector<std::optional<PieceList>>;

// Whether an open stroke's end is joined to another stroke or a node.
bool isHeld(const StrokePolyline& polyline, const DrawnStroke& stroke, int end)
{
  return polyline.joins[end].stroke >= 0 ||
         stroke.isNode(end == 0 ? 0 : static_cast<int>(stroke.points.size()) - 1);
}

// Halves the pieces of rims that a free end comes too near to, see approximate.h. Whether one is halved
// depends on ends alone, which stay, not on the order.
void makeRoomForEnds(Drafts& drafts,
  const std::vector<StrokePolyline>& polylines,
  const std::vector<DrawnStroke>& strokes,
  const std::vector<StrokeClass>& classes,
  const std::vector<Treatment>& treatments,
  double longest)
{
  for (const StrokePolyline& polyline : polylines)
  {
    const DrawnStroke& stroke = strokes[polyline.stroke];
    for (const int end : { 0, 1 })
    {
      if (polyline.closed || isHeld(polyline, stroke, end))
      {
        continue;
      }
      const Vector2& place = end == 0 ? stroke.points.front() : stroke.points.back();
      for (std::size_t i = 0; i < drafts.size(); ++i)
      {
        if (drafts[i] && isRimOf(classes[polyline.stroke].region, classes[i], treatments[i]))
        {
          drafts[i]->makeRoom(place, endRoom, endPiece * longest);
        }
      }
    }
  }
}

// A piece of one stroke's polyline and one of another's, or of its own, that are in each other's way.
struct Fault
{
  std::array<int, 2> first, second; // stroke, piece
};

std::vector<Fault> crossings(const Drafts& drafts)
{
  struct Segment
  {
    SegmentEnds ends;
    std::array<int, 2> piece;
    double least() const { return std::min(this->ends[0][0], this->ends[1][0]); }
  };
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < drafts.size(); ++i)
  {
    for (std::size_t k = 0; drafts[i] && k < drafts[i]->pieces().size(); ++k)
    {
      const Piece& piece = drafts[i]->pieces()[k];
      segments.push_back({ { drafts[i]->sample(piece.from), drafts[i]->sample(piece.to) },
        { static_cast<int>(i), static_cast<int>(k) } });
    }
  }
  std::stable_sort(segments.begin(),
    segments.end(),
    [](const Segment& s, const Segment& t) { return s.least() < t.least(); });
  std::vector<SegmentEnds> ends;
  std::transform(
    segments.begin(), segments.end(), std::back_inserter(ends), [](const Segment& s) { return s.ends; });
  std::vector<Fault> faults;
  forEachNear(ends,
    [&](int i, int j)
    {
      if (segmentsMeet(ends[i][0], ends[i][1], ends[j][0], ends[j][1]))
      {
        faults.push_back({ segments[i].piece, segments[j].piece });
      }
    });
  return faults;
}

// Whether a place lies in a closed stroke's polyline, by the even-odd rule.
bool holds(const PieceList& list, const Vector2& place)
{
  bool inside = false;
  for (const Piece& piece : list.pieces())
  {
    inside ^= passesRight(place, list.sample(piece.from), list.sample(piece.to));
  }
  return inside;
}

// Strokes that lie on another side of a closed stroke's polyline than of the stroke. Nothing crosses, so the
// middle of one piece tells of a whole stroke.
std::vector<Fault> wrongSides(const Drafts& drafts, const std::vector<StrokeClass>& classes)
{
  const auto bounded = [&](std::size_t i)
  { return classes[i].role == Role::Boundary ? classes[i].region : classes[i].childRegion; };
  std::vector<int> around(classes.size(), -1); // of each region, the one round it
  for (const StrokeClass& which : classes)
  {
    if (which.childRegion >= 0)
    {
      around.resize(std::max<std::size_t>(around.size(), which.childRegion + 1), -1);
      around[which.childRegion] = which.region;
    }
  }
  std::vector<Fault> faults;
  for (std::size_t p = 0; p < drafts.size(); ++p)
  {
    if (!drafts[p] || bounded(p) < 0)
    {
      continue;
    }
    for (std::size_t i = 0; i < drafts.size(); ++i)
    {
      if (!drafts[i] || i == p)
      {
        continue;
      }
      int region = classes[i].role == Role::Boundary ? -1 : classes[i].region;
      for (std::size_t step = 0; region >= 0 && region != bounded(p) && step < classes.size(); ++step)
      {
        region = region < static_cast<int>(around.size()) ? around[region] : -1;
      }
      const Piece& first = drafts[i]->pieces().front();
      const Vector2 middle = 0.5 * (drafts[i]->sample(first.from) + drafts[i]->sample(first.to));
      if (holds(*drafts[p], middle) == (region == bounded(p)))
      {
        continue;
      }
      const std::array<int, 2> own{ static_cast<int>(i), 0 };
      const std::size_t before = faults.size();
      for (std::size_t k = 0; k < drafts[p]->pieces().size(); ++k)
      {
        if (drafts[p]->leavesOut(static_cast<int>(k), middle))
        {
          faults.push_back({ { static_cast<int>(p), static_cast<int>(k) }, own });
        }
      }
      if (faults.size() == before)
      {
        faults.push_back({ own, own });
      }
    }
  }
  return faults;
}

[[noreturn]] void refuse(const Drafts& drafts, const Fault& fault, const std::vector<DrawnStroke>& strokes)
{
  const int one = nameOf(strokes, fault.first[0]), two = nameOf(strokes, fault.second[0]);
  const auto [a, b] = std::minmax(one, two);
  const PieceList& list = *drafts[fault.first[0]];
  const Vector2 place = list.sample(list.pieces()[fault.first[1]].from);
  throw Error(Failure::BadStroke,
    a == b ? "{stroke %1} comes so near itself near {(%3, %4)} that no polyline of its samples keeps clear; "
             "draw it with more room there"
           : "{stroke %1} comes so near {stroke %2} near {(%3, %4)} that no polyline of its samples keeps "
             "clear; draw it with more room there",
    a,
    b,
    place[0],
    place[1]);
}

// Makes the pieces concerned finer until one of them is split.
void resolve(Drafts& drafts, const std::vector<Fault>& faults, const std::vector<DrawnStroke>& strokes)
{
  std::vector<std::array<int, 2>> concerned;
  for (const Fault& fault : faults)
  {
    concerned.insert(concerned.end(), { fault.first, fault.second });
  }
  // From each stroke's end, so that a split moves no piece that is still to come.
  std::sort(concerned.begin(), concerned.end(), std::greater<>());
  concerned.erase(std::unique(concerned.begin(), concerned.end()), concerned.end());
  for (bool split = false; !split;)
  {
    std::vector<std::array<int, 2>> spent;
    for (const std::array<int, 2>& piece : concerned)
    {
      const PieceList::Halved halved = drafts[piece[0]]->halve(piece[1]);
      split = split || halved == PieceList::Halved::Split;
      if (halved == PieceList::Halved::Spent)
      {
        spent.push_back(piece);
      }
    }
    const auto isSpent = [&](const std::array<int, 2>& piece)
    { return std::binary_search(spent.begin(), spent.end(), piece, std::greater<>()); };
    for (const Fault& fault : faults)
    {
      if (isSpent(fault.first) && isSpent(fault.second))
      {
        refuse(drafts, fault, strokes);
      }
    }
  }
}

} // namespace

std::vector<StrokePolyline> approximate(const std::vector<DrawnStroke>& strokes,
  const std::vector<StrokeClass>& classes,
  const std::vector<Treatment>& treatments,
  const DistanceMaps& maps,
  const std::vector<StrokeSplit>& splits,
  double longest,
  const ApproximationRules& rules,
  const Context& context)
{
  const std::vector<bool> gone = inHoles(classes, treatments);
  std::vector<StrokePolyline> result;
  std::vector<std::vector<int>> forced(strokes.size());
  std::transform(
    strokes.begin(), strokes.end(), forced.begin(), [](const DrawnStroke& s) { return s.nodes; });
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    if (classes[i].role == Role::Rejected || classes[i].role == Role::Unknown || gone[i])
    {
      continue;
    }
    StrokePolyline polyline{ static_cast<int>(i), strokes[i].closed, {}, {} };
    if (!strokes[i].closed)
    {
      auto& [first, last] = polyline.joins;
      const auto join = [&](const Vector2& end)
      { return joinOf(end, classes[i].region, strokes, classes, treatments, rules.joinDistance * longest); };
      const auto ends = [&](bool isLast)
      {
        const int sample = isLast ? static_cast<int>(strokes[i].points.size()) - 1 : 0;
        return strokes[i].isNode(sample) ? StrokeJoin() : join(strokes[i].points[sample]);
      };
      first = ends(false);
      last = ends(true);
      if (first.stroke == last.stroke && first.sample == last.sample)
      {
        last = {};
      }
      for (const StrokeJoin& to : { first, last })
      {
        if (to.stroke >= 0)
        {
          forced[to.stroke].push_back(to.sample);
        }
      }
    }
    result.push_back(std::move(polyline));
  }
  Drafts drafts(strokes.size());
  for (const StrokePolyline& polyline : result)
  {
    context.checkpoint(0.5 * polyline.stroke / static_cast<double>(strokes.size()));
    const DrawnStroke& stroke = strokes[polyline.stroke];
    Polyline samples = stroke.points;
    for (const int end : { 0, 1 })
    {
      const StrokeJoin& to = polyline.joins[end];
      if (to.stroke >= 0)
      {
        (end == 0 ? samples.front() : samples.back()) = strokes[to.stroke].points[to.sample];
      }
    }
    std::vector<StrokeSplit> own;
    std::copy_if(splits.begin(),
      splits.end(),
      std::back_inserter(own),
      [&](const StrokeSplit& split) { return split.stroke == polyline.stroke; });
    drafts[polyline.stroke].emplace(std::move(samples),
      stroke,
      rules.mode == DeltaMode::Fixed ? std::vector<double>() : thicknessAlong(stroke, maps),
      forced[polyline.stroke],
      std::move(own),
      longest,
      rules);
    // Where one segment divides a region from rim to rim, two copies of it joined at the rims would be one.
    if (!polyline.closed && isHeld(polyline, stroke, 0) && isHeld(polyline, stroke, 1))
    {
      drafts[polyline.stroke]->divide();
    }
  }
  if (rules.mode == DeltaMode::Adaptive)
  {
    makeRoomForEnds(drafts, result, strokes, classes, treatments, longest);
  }
  while (true)
  {
    context.checkpoint(0.7);
    std::vector<Fault> faults = crossings(drafts);
    if (faults.empty())
    {
      faults = wrongSides(drafts, classes);
    }
    if (faults.empty())
    {
      break;
    }
    resolve(drafts, faults, strokes);
  }
  for (StrokePolyline& polyline : result)
  {
    polyline.samples = drafts[polyline.stroke]->vertices();
  }
  return result;
}

std::vector<int> approximateAlone(const Polyline& stroke, bool closed, double longest)
{
  if (stroke.size() < 2)
  {
    return stroke.empty() ? std::vector<int>() : std::vector<int>{ 0 };
  }
  ApproximationRules rules;
  rules.mode = DeltaMode::Fixed;
  return PieceList(stroke, { stroke, closed }, {}, {}, {}, longest, rules).vertices();
}

} // namespace oversketch
