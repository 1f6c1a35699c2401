#include "Raster/distance_maps.h"

#include "Stroke/with_opencv.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr float ridgeSlope = 0.75f, ridgeDepth = 3.0f;

// Of a row of samples, the steepest way up and where it leads: the step's number, or -1 on the ridge and
// where T is 0. `row` is the sample's own row of T.
void steepest(const float* row, int width, int stride, float* slopes, int* steps)
{
  const int offsets[8] = { -stride - 1, -stride, -stride + 1, -1, 1, stride - 1, stride, stride + 1 };
  const float diagonal = std::sqrt(0.5f);
  for (int x = 0; x < width; ++x)
  {
    slopes[x] = -1e30f;
    steps[x] = 0;
  }
  for (int k = 0; k < 8; ++k)
  {
    const float* other = row + offsets[k];
    const float scale = k == 0 || k == 2 || k == 5 || k == 7 ? diagonal : 1.0f;
    for (int x = 0; x < width; ++x)
    {
      const float slope = (other[x] - row[x]) * scale;
      steps[x] = slope > slopes[x] ? offsets[k] : steps[x];
      slopes[x] = slope > slopes[x] ? slope : slopes[x];
    }
  }
}

} // namespace

std::vector<Rim> rimsOf(const Classification& classification,
  const std::vector<DrawnStroke>& strokes,
  const std::vector<Treatment>& treatments)
{
  const auto isHole = [&](int region)
  {
    const Region& which = classification.regions[region];
    return which.parent >= 0 && treatments[which.stroke] == Treatment::Hole;
  };
  std::vector<Rim> rims;
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    const StrokeClass& stroke = classification.strokes[i];
    bool rim = stroke.role == Role::Boundary;
    if (stroke.role == Role::ClosedFeature && isHole(stroke.childRegion))
    {
      rim = true;
      for (int around = stroke.region; around >= 0; around = classification.regions[around].parent)
      {
        rim = rim && !isHole(around);
      }
    }
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

void findThickness(DistanceMaps& maps, ThicknessMode mode, const Context& context)
{
  const Frame& frame = maps.frame;
  const std::vector<float>& distance = maps.distance;
  maps.thickness.assign(frame.count(), 0.0f);
  maps.skeleton.assign(frame.count(), 0);
  maps.uphill.assign(frame.count(), -1);
  const int inner = frame.width - 2; // the border has no inside
  context.parallelFor(frame.height - 2,
    [&](int begin, int end)
    {
      std::vector<float> slopes(inner);
      std::vector<int> steps(inner);
      for (int y = begin + 1; y <= end && !context.cancelled(); ++y)
      {
        const std::size_t first = frame.index(1, y);
        // Rows without an inside are most of many pictures.
        const auto begins = std::find_if(
          distance.begin() + first, distance.begin() + first + inner, [](float t) { return t > 0.0f; });
        const int from = static_cast<int>(begins - distance.begin() - first);
        if (from == inner)
        {
          continue;
        }
        steepest(distance.data() + first + from, inner - from, frame.width, slopes.data(), steps.data());
        for (int x = from; x < inner; ++x)
        {
          const std::size_t at = first + x;
          const float t = distance[at];
          if (t > 0.0f)
          {
            const float slope = slopes[x - from];
            const bool ridge = slope <= 0.0f || (t >= ridgeDepth && slope < ridgeSlope);
            maps.skeleton[at] = ridge;
            maps.thickness[at] = ridge ? t : 0.0f;
            maps.uphill[at] = ridge ? -1 : static_cast<int>(at) + steps[x - from];
          }
        }
      }
    });
  context.checkpoint(0.6);
  if (mode == ThicknessMode::Global)
  {
    std::vector<float> greatest;
    for (std::size_t i = 0; i < frame.count(); ++i)
    {
      if (maps.object[i] >= 0)
      {
        greatest.resize(std::max<std::size_t>(greatest.size(), maps.object[i] + 1), 0.0f);
        greatest[maps.object[i]] = std::max(greatest[maps.object[i]], distance[i]);
      }
    }
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
  for (std::size_t i = frame.count(); i-- > 0;)
  {
    if (uphill[i] >= 0)
    {
      thickness[i] = thickness[uphill[i]];
    }
  }
  context.checkpoint(0.8);
  std::vector<int> way;
  for (std::size_t i = 0; i < frame.count(); ++i)
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
