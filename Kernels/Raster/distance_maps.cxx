#include "Raster/distance_maps.h"

#include "Stroke/with_opencv.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace oversketch
{
namespace
{

constexpr float ridgeSlope = 0.75f, ridgeDepth = 3.0f;

// Findings of a row of samples: whether each is on the ridge, where T is not 0, its thickness there, and
// where the steepest way up leads to from the others. All are written for every sample of it, without
// branches, so that several are done at a time.
struct Row
{
  float* thickness;
  std::uint8_t* skeleton;
  int* uphill;
};

// `row`: T at the row's first sample, whose number is `first`.
void climb(const float* row, int width, int stride, int first, const Row& found)
{
  const float diagonal = std::sqrt(0.5f);
  const float *below = row - stride, *above = row + stride;
  for (int x = 0; x < width; ++x)
  {
    const float t = row[x];
    float steepest = (below[x - 1] - t) * diagonal;
    int step = -stride - 1;
    const auto offer = [&](float slope, int to)
    {
      step = slope > steepest ? to : step;
      steepest = slope > steepest ? slope : steepest;
    };
    offer(below[x] - t, -stride);
    offer((below[x + 1] - t) * diagonal, -stride + 1);
    offer(row[x - 1] - t, -1);
    offer(row[x + 1] - t, 1);
    offer((above[x - 1] - t) * diagonal, stride - 1);
    offer(above[x] - t, stride);
    offer((above[x + 1] - t) * diagonal, stride + 1);
    const int inside = t > 0.0f, top = steepest <= 0.0f, deep = t >= ridgeDepth, flat = steepest < ridgeSlope;
    const int ridge = inside & (top | (deep & flat));
    found.thickness[x] = ridge ? t : 0.0f;
    found.uphill[x] = inside & (ridge ^ 1) ? first + x + step : -1;
  }
  for (int x = 0; x < width; ++x)
  {
    found.skeleton[x] = found.thickness[x] > 0.0f; // T is, where the ridge is
  }
}

// Samples of each row from the first to the last one with an inside, [begin, end).
std::vector<std::array<int, 2>> insides(const std::vector<float>& distance, const Frame& frame)
{
  std::vector<std::array<int, 2>> spans(frame.height, { 0, 0 });
  const auto isInside = [](float t) { return t > 0.0f; };
  for (int y = 1; y + 1 < frame.height; ++y) // the border has no inside
  {
    const auto row = distance.begin() + static_cast<std::ptrdiff_t>(frame.index(0, y));
    const auto first = row + 1, last = row + frame.width - 1;
    const auto begin = std::find_if(first, last, isInside);
    if (begin != last)
    {
      const auto end =
        std::find_if(std::make_reverse_iterator(last), std::make_reverse_iterator(begin), isInside);
      spans[y] = { static_cast<int>(begin - row), static_cast<int>(end.base() - row) };
    }
  }
  return spans;
}

} // namespace

std::vector<char> regionsInHoles(const Classification& classification,
  const std::vector<Treatment>& treatments)
{
  const std::vector<Region>& regions = classification.regions;
  std::vector<char> gone(regions.size(), 0);
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    // Treatments of what bounds an object do not matter.
    gone[r] = regions[r].parent >= 0 && treatments[regions[r].stroke] == Treatment::Hole;
  }
  return gone;
}

std::vector<Rim> rimsOf(const Classification& classification,
  const std::vector<DrawnStroke>& strokes,
  const std::vector<Treatment>& treatments)
{
  const std::vector<char> isHole = regionsInHoles(classification, treatments);
  std::vector<Rim> rims;
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    const StrokeClass& stroke = classification.strokes[i];
    const bool rim = stroke.role == Role::Boundary || (stroke.role == Role::ClosedFeature &&
                                                        isHole[stroke.childRegion] != isHole[stroke.region]);
    if (rim)
    {
      rims.push_back({ strokes[i].points, stroke.object });
    }
  }
  return rims;
}

DistanceMaps distanceTo(const Frame& frame, const std::vector<Rim>& rims, const Context& context)
{
  DistanceMaps maps;
  maps.frame = frame;
  maps.object.assign(frame.count(), -1);
  maps.distance.assign(frame.count(), 0.0f);
  std::vector<Polyline> curves;
  std::vector<std::vector<Place>> lines;
  int objects = 0;
  int x0 = frame.width, x1 = -1, y0 = frame.height, y1 = -1;
  for (const Rim& rim : rims)
  {
    curves.push_back(onRaster(frame, rim.points));
    lines.push_back(linePixels(curves.back(), true));
    if (rim.points.size() < 3 || curves.back().empty() || rim.object < 0)
    {
      throw Error(
        Failure::BadStroke, "a rim has fewer than three points or leaves the canvas; draw it inside");
    }
    objects = std::max(objects, rim.object + 1);
    for (const Place& p : lines.back())
    {
      x0 = std::min(x0, p[0]);
      x1 = std::max(x1, p[0]);
      y0 = std::min(y0, p[1]);
      y1 = std::max(y1, p[1]);
    }
  }
  if (rims.empty())
  {
    return maps;
  }
  // By object, so that what one has cut out another one may fill.
  for (int object = 0; object < objects; ++object)
  {
    std::vector<Polyline> polygons;
    for (std::size_t r = 0; r < rims.size(); ++r)
    {
      if (rims[r].object == object)
      {
        polygons.push_back(curves[r]);
      }
    }
    fillEvenOdd(frame, polygons, object, maps.object);
  }
  // Only the box of all rims has an inside.
  const int width = x1 - x0 + 1, height = y1 - y0 + 1;
  std::vector<std::uint8_t> image(static_cast<std::size_t>(width) * height, 255);
  for (std::size_t r = 0; r < rims.size(); ++r)
  {
    for (const Place& p : lines[r])
    {
      image[static_cast<std::size_t>(p[1] - y0) * width + p[0] - x0] = 0;
      maps.object[frame.index(p[0], p[1])] = rims[r].object;
    }
  }
  context.checkpoint(0.1);
  withOpenCV("measure distances",
    [&]
    {
      const cv::Mat black(height, width, CV_8UC1, image.data());
      cv::Mat all(frame.height, frame.width, CV_32FC1, maps.distance.data());
      cv::Mat box = all(cv::Rect(x0, y0, width, height));
      cv::distanceTransform(black, box, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    });
  context.parallelFor(height,
    [&](int begin, int end)
    {
      for (std::size_t i = frame.index(0, y0 + begin); i < frame.index(0, y0 + end); ++i)
      {
        maps.distance[i] = maps.object[i] < 0 ? 0.0f : maps.distance[i];
      }
    });
  return maps;
}

std::vector<float> greatestDistances(const DistanceMaps& maps)
{
  std::vector<float> greatest;
  for (std::size_t i = 0; i < maps.object.size(); ++i)
  {
    if (maps.object[i] >= 0)
    {
      greatest.resize(std::max<std::size_t>(greatest.size(), maps.object[i] + 1), 0.0f);
      greatest[maps.object[i]] = std::max(greatest[maps.object[i]], maps.distance[i]);
    }
  }
  return greatest;
}

void findThickness(DistanceMaps& maps, ThicknessMode mode, const Context& context)
{
  const Frame& frame = maps.frame;
  const std::vector<float>& distance = maps.distance;
  maps.thickness.assign(frame.count(), 0.0f);
  maps.skeleton.assign(frame.count(), 0);
  maps.uphill.assign(frame.count(), -1);
  const std::vector<std::array<int, 2>> spans = insides(distance, frame);
  context.eachUntilCancelled(frame.height,
    [&](int y)
    {
      const auto [from, to] = spans[y];
      const std::size_t at = frame.index(from, y);
      const Row row{ maps.thickness.data() + at, maps.skeleton.data() + at, maps.uphill.data() + at };
      climb(distance.data() + at, to - from, frame.width, static_cast<int>(at), row);
    });
  context.checkpoint(0.6);
  if (mode == ThicknessMode::Global)
  {
    const std::vector<float> greatest = greatestDistances(maps);
    for (std::size_t i = 0; i < frame.count(); ++i)
    {
      maps.thickness[i] = distance[i] > 0.0f ? greatest[maps.object[i]] : 0.0f;
    }
    return;
  }
  // Every way up ends on the ridge, since T rises along it. Most samples are next to one that is settled when
  // walked from the ridge's side: those below it from above, and then the others; ways that wind are
  // followed.
  const std::vector<int>& uphill = maps.uphill;
  std::vector<float>& thickness = maps.thickness;
  for (int y = frame.height; y-- > 0;)
  {
    const std::size_t first = frame.index(spans[y][0], y);
    for (std::size_t i = frame.index(spans[y][1], y); i-- > first;)
    {
      if (uphill[i] >= 0)
      {
        thickness[i] = thickness[uphill[i]];
      }
    }
  }
  context.checkpoint(0.8);
  std::vector<int> way;
  for (int y = 0; y < frame.height; ++y)
  {
    const std::size_t end = frame.index(spans[y][1], y);
    for (std::size_t i = frame.index(spans[y][0], y); i < end; ++i)
    {
      if (uphill[i] < 0 || thickness[i] > 0.0f)
      {
        continue;
      }
      int at = static_cast<int>(i);
      for (way.clear(); thickness[at] == 0.0f; at = uphill[at])
      {
        way.push_back(at);
      }
      for (const int sample : way)
      {
        thickness[sample] = thickness[at];
      }
    }
  }
}

DistanceMaps distanceMaps(const Frame& frame,
  const std::vector<Rim>& rims,
  ThicknessMode mode,
  const Context& context)
{
  DistanceMaps maps = distanceTo(frame, rims, context);
  context.checkpoint(0.5);
  findThickness(maps, mode, context);
  context.checkpoint(1.0);
  return maps;
}

} // namespace oversketch
