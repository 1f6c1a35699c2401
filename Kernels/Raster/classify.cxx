#include "Raster/classify.h"

#include "Mesh/shape.h"
#include "Stroke/meetings.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace oversketch
{
namespace
{

constexpr double smallestArea = 9.0; // px squared

// Connected areas of a raster without lines.
struct Blobs
{
  // Area that each sample is in, 4-connected, numbered by their first samples, so that 0 is the one at
  // the raster's border; -1 on a line.
  std::vector<int> labels;
  std::vector<int> sizes; // samples of each area
  int count() const { return static_cast<int>(this->sizes.size()); }
};

struct RowRun
{
  int begin, end; // samples of a row
};

int rootOf(std::vector<int>& parents, int i)
{
  while (parents[i] != i)
  {
    parents[i] = parents[parents[i]];
    i = parents[i];
  }
  return i;
}

// lines: 1 on a line, else 0; the raster's first sample is on none. Why not OpenCV: its areas' order is the
// algorithm's, and 8 neighbours, which leak through diagonal lines, are its default.
Blobs blobsOf(const Frame& frame, const std::vector<std::uint8_t>& lines)
{
  std::vector<RowRun> runs;
  std::vector<int> offsets{ 0 }; // of the rows' runs
  std::vector<int> parents;
  for (int y = 0; y < frame.height; ++y)
  {
    const std::uint8_t* row = lines.data() + frame.index(0, y);
    const std::uint8_t* end = row + frame.width;
    for (const std::uint8_t* at = row; at != end;)
    {
      const std::uint8_t* begin = std::find(at, end, 0);
      at = std::find(begin, end, 1);
      if (begin != at)
      {
        parents.push_back(static_cast<int>(runs.size()));
        runs.push_back({ static_cast<int>(begin - row), static_cast<int>(at - row) });
      }
    }
    const int first = offsets.back();
    offsets.push_back(static_cast<int>(runs.size()));
    // Runs of this row and the last one that share a column are one area; its number is its first run's.
    for (int above = first, below = y > 0 ? offsets[y - 1] : first; above < offsets.back() && below < first;)
    {
      if (runs[above].begin < runs[below].end && runs[below].begin < runs[above].end)
      {
        const int a = rootOf(parents, above), b = rootOf(parents, below);
        parents[std::max(a, b)] = std::min(a, b);
      }
      runs[above].end < runs[below].end ? ++above : ++below;
    }
  }
  Blobs blobs;
  blobs.labels.assign(frame.count(), -1);
  std::vector<int> numbers(runs.size(), -1);
  for (int y = 0; y < frame.height; ++y)
  {
    for (int i = offsets[y]; i < offsets[y + 1]; ++i)
    {
      const int root = rootOf(parents, i);
      if (root == i)
      {
        numbers[i] = blobs.count();
        blobs.sizes.push_back(0);
      }
      numbers[i] = numbers[root];
      blobs.sizes[numbers[i]] += runs[i].end - runs[i].begin;
      std::fill(blobs.labels.begin() + frame.index(runs[i].begin, y),
        blobs.labels.begin() + frame.index(runs[i].end, y),
        numbers[i]);
    }
  }
  return blobs;
}

// The contacts of a line's samples, each sample once however often the line passes it, by ascending area.
// `stamps` has an entry for each sample of the raster that differs from `stamp`.
std::vector<Contact> contactsOf(const Frame& frame,
  const Blobs& blobs,
  const std::vector<Place>& pixels,
  std::vector<int>& stamps,
  int stamp)
{
  std::map<int, int> counts;
  for (const Place& p : pixels)
  {
    const std::size_t at = frame.index(p[0], p[1]);
    if (stamps[at] == stamp)
    {
      continue;
    }
    stamps[at] = stamp;
    const std::array<int, 4> beside{ blobs.labels[at - 1],
      blobs.labels[at + 1],
      blobs.labels[at - frame.width],
      blobs.labels[at + frame.width] };
    for (int i = 0; i < 4; ++i)
    {
      if (beside[i] >= 0 && std::find(beside.begin(), beside.begin() + i, beside[i]) == beside.begin() + i)
      {
        ++counts[beside[i]];
      }
    }
  }
  std::vector<Contact> contacts;
  contacts.reserve(counts.size());
  for (const auto& [blob, count] : counts)
  {
    contacts.push_back({ blob, count });
  }
  return contacts;
}

// A closed curve that others are looked for in [px].
struct Outline
{
  int stroke;
  Polyline points;
  Eigen::AlignedBox2d box;
  double area = 0.0;

  Outline(int number, Polyline curve)
    : stroke(number)
    , points(std::move(curve))
  {
    const Vector2 first = this->points.front();
    for (std::size_t i = 0; i < this->points.size(); ++i)
    {
      const Vector2 p = this->points[i] - first, q = this->points[(i + 1) % this->points.size()] - first;
      this->area += 0.5 * cross(p, q);
      this->box.extend(this->points[i]);
    }
    this->area = std::abs(this->area);
  }
  // By the even-odd rule; the place is not on the curve.
  bool holds(const Vector2& place) const
  {
    if (!this->box.contains(place))
    {
      return false;
    }
    bool inside = false;
    for (std::size_t i = 0, j = this->points.size() - 1; i < this->points.size(); j = i++)
    {
      inside ^= passesRight(place, this->points[i], this->points[j]);
    }
    return inside;
  }
};

int distinctPoints(const Polyline& points)
{
  int count = 0;
  for (std::size_t i = 0; i < points.size() && count < 3; ++i)
  {
    count += std::find(points.begin(), points.begin() + i, points[i]) == points.begin() + i;
  }
  return count;
}

// A pen that was set down and hardly moved: however it runs, nothing is lost without it.
bool isDot(const Polyline& points)
{
  return boxRound(points).volume() < smallestArea;
}

void reject(StrokeClass& stroke, Rejection why)
{
  stroke.role = Role::Rejected;
  stroke.rejection = why;
}

// Draws the strokes that are on the canvas and finds what areas they touch.
void drawLines(const Frame& frame,
  const std::vector<PlaneCurve>& strokes,
  Classification& result,
  const Context& context)
{
  std::vector<std::uint8_t> lines(frame.count(), 0);
  std::vector<std::vector<Place>> pixels(strokes.size());
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    if (result.strokes[i].role != Role::Rejected)
    {
      pixels[i] = linePixels(strokes[i].points, strokes[i].closed);
      for (const Place& p : pixels[i])
      {
        lines[frame.index(p[0], p[1])] = 1;
      }
      ++result.blobs;
    }
  }
  context.checkpoint(0.3);
  Blobs blobs = blobsOf(frame, lines);
  result.blobs += blobs.count();
  context.checkpoint(0.5);
  std::vector<int> stamps(frame.count(), -1);
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    result.strokes[i].contacts = contactsOf(frame, blobs, pixels[i], stamps, static_cast<int>(i));
  }
  result.labels = std::move(blobs.labels);
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    for (const Place& p : pixels[i])
    {
      result.labels[frame.index(p[0], p[1])] = -1 - static_cast<int>(i);
    }
  }
}

// Areas that a stroke touches with at least so large a share of its largest contact.
int areasOf(const StrokeClass& stroke, double share)
{
  int largest = 0;
  for (const Contact& contact : stroke.contacts)
  {
    largest = std::max(largest, contact.pixels);
  }
  return static_cast<int>(std::count_if(stroke.contacts.begin(),
    stroke.contacts.end(),
    [&](const Contact& contact) { return contact.pixels >= share * largest; }));
}

bool rightAreas(const StrokeClass& stroke, const DrawnStroke& drawn, double share)
{
  const bool closed = drawn.closed;
  if (!drawn.nodes.empty())
  {
    return true;
  }
  if (share > 0.0)
  {
    return closed || areasOf(stroke, share) < 3;
  }
  return areasOf(stroke, share) == (closed ? 2 : 1);
}

} // namespace

Classification classify(const Frame& frame,
  const std::vector<DrawnStroke>& strokes,
  double contactShare,
  const Context& context)
{
  Classification result;
  result.strokes.resize(strokes.size());
  std::vector<PlaneCurve> curves(strokes.size());
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    const DrawnStroke& stroke = strokes[i];
    if (distinctPoints(stroke.points) < (stroke.closed ? 3 : 2))
    {
      reject(result.strokes[i], Rejection::TooShort);
    }
    else
    {
      curves[i] = { onRaster(frame, stroke.points), stroke.closed, stroke.nodes };
      if (curves[i].points.empty())
      {
        reject(result.strokes[i], Rejection::OffCanvas);
      }
    }
  }
  drawLines(frame, curves, result, context);
  const std::vector<Meeting> met = meetings(curves, context);
  std::vector<Outline> outlines;
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    StrokeClass& stroke = result.strokes[i];
    if (stroke.role == Role::Rejected)
    {
      continue;
    }
    if (met[i].segment >= 0)
    {
      const bool itself = met[i].other == static_cast<int>(i);
      reject(stroke,
        !itself                   ? Rejection::Crosses
        : isDot(curves[i].points) ? Rejection::TooSmall
                                  : Rejection::CrossesItself);
      stroke.other = met[i].other;
      stroke.segment = met[i].segment;
    }
    else if (!rightAreas(stroke, strokes[i], contactShare))
    {
      reject(stroke, Rejection::Areas);
    }
    else if (strokes[i].closed)
    {
      Outline outline(static_cast<int>(i), curves[i].points);
      if (outline.area < smallestArea)
      {
        reject(stroke, Rejection::TooSmall);
      }
      else
      {
        outlines.push_back(std::move(outline));
      }
    }
  }
  context.checkpoint(0.8);
  // Nothing crosses now, so any point beside nodes of a curve tells what it lies in: of the outlines round
  // it, the least.
  const auto around = [&](int stroke)
  {
    const Polyline& points = curves[stroke].points;
    const std::size_t middle = points.size() / 2;
    // Its ends may lie on an outline.
    const Vector2 place =
      strokes[stroke].nodes.empty() ? points.front() : Vector2(0.5 * (points[middle - 1] + points[middle]));
    int best = -1;
    for (std::size_t r = 0; r < outlines.size(); ++r)
    {
      if (outlines[r].stroke != stroke && (best < 0 || outlines[r].area < outlines[best].area) &&
          outlines[r].holds(place))
      {
        best = static_cast<int>(r);
      }
    }
    return best;
  };
  result.regions.resize(outlines.size());
  for (std::size_t r = 0; r < outlines.size(); ++r)
  {
    Region& region = result.regions[r];
    region.stroke = outlines[r].stroke;
    region.parent = around(region.stroke);
    if (region.parent < 0)
    {
      region.object = result.objects++;
    }
  }
  for (std::size_t r = 0; r < outlines.size(); ++r)
  {
    Region& region = result.regions[r];
    int top = static_cast<int>(r);
    while (result.regions[top].parent >= 0)
    {
      top = result.regions[top].parent;
      ++region.depth;
    }
    region.object = result.regions[top].object;
    StrokeClass& stroke = result.strokes[region.stroke];
    stroke.object = region.object;
    stroke.role = region.parent < 0 ? Role::Boundary : Role::ClosedFeature;
    stroke.region = region.parent < 0 ? static_cast<int>(r) : region.parent;
    if (region.parent >= 0)
    {
      stroke.childRegion = static_cast<int>(r);
      result.regions[region.parent].children.push_back(static_cast<int>(r));
    }
  }
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    StrokeClass& stroke = result.strokes[i];
    if (stroke.role == Role::Unknown)
    {
      stroke.region = around(static_cast<int>(i));
      if (stroke.region < 0)
      {
        reject(stroke, Rejection::Outside);
        continue;
      }
      stroke.role = Role::OpenFeature;
      stroke.object = result.regions[stroke.region].object;
    }
    if (stroke.role == Role::OpenFeature || stroke.role == Role::ClosedFeature)
    {
      result.regions[stroke.region].features.push_back(static_cast<int>(i));
    }
  }
  return result;
}

Message rejectionText(const Classification& classification,
  int stroke,
  const std::vector<DrawnStroke>& strokes)
{
  const StrokeClass& which = classification.strokes[stroke];
  const DrawnStroke& drawn = strokes[stroke];
  const int name = nameOf(strokes, stroke);
  const auto near = [&](int k) { return drawn.points[which.segment][k]; }; // where it crosses
  switch (which.rejection)
  {
    case Rejection::None:
      break;
    case Rejection::TooShort:
      return { "{Stroke %1} has too few distinct points; draw a longer one.", name };
    case Rejection::OffCanvas:
      return { "{Stroke %1} leaves the canvas; draw it inside.", name };
    case Rejection::CrossesItself:
      return { crossesItselfText, name, near(0), near(1) };
    case Rejection::Crosses:
      return { crossesText, name, nameOf(strokes, which.other), near(0), near(1) };
    case Rejection::Outside:
      if (!drawn.nodes.empty())
      {
        const Vector2 end = drawn.isNode(0) ? drawn.points.back() : drawn.points.front();
        return { "{Stroke %1} sticks out of the outline to (%2, %3), which is left out; end it inside, or "
                 "close what it is to bound.",
          name,
          end[0],
          end[1] };
      }
      return { "{Stroke %1} is open and in no closed stroke; close it, or draw a closed one round it.",
        name };
    case Rejection::TooSmall:
      return { "{Stroke %1} is closed round less than 9 px; draw it larger.", name };
    case Rejection::Areas:
      return {
        "{Stroke %1} touches %2 areas; draw it with more room to the others and between its own parts.",
        name,
        which.contacts.size()
      };
  }
  return {};
}

} // namespace oversketch
