#include "Raster/trace.h"

#include "Raster/thing.h"
#include "Stroke/meetings.h"
#include "Stroke/with_opencv.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace oversketch
{
namespace
{

constexpr double halfCover = 127.5;

// The parts of a mask that hold a disc of that width, with the corners that it does not reach.
cv::Mat1b withoutWhiskers(const cv::Mat1b& mask, double width)
{
  const double radius = 0.5 * width;
  const double slack = radius + 0.6; // px: discs on a grid of pixels, and a px that they miss of a smooth rim
  cv::Mat1f depth, away;
  cv::distanceTransform(mask, depth, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const cv::Mat1b middles(depth >= radius + 0.5); // depths are to the middle of the first pixel outside
  if (cv::countNonZero(middles) == 0)
  {
    return middles;
  }
  cv::distanceTransform(~middles, away, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::Mat1b kept((away <= slack) & mask);
  cv::Mat1i parts;
  const int count = cv::connectedComponents(mask & ~kept, parts, 8);
  std::vector<float> reach(static_cast<std::size_t>(count), 0.0F);
  for (int y = 0; y < parts.rows; ++y)
  {
    for (int x = 0; x < parts.cols; ++x)
    {
      float& farthest = reach[static_cast<std::size_t>(parts(y, x))];
      farthest = std::max(farthest, away(y, x));
    }
  }
  for (int y = 0; y < parts.rows; ++y)
  {
    for (int x = 0; x < parts.cols; ++x)
    {
      const int part = parts(y, x);
      if (part > 0 && reach[static_cast<std::size_t>(part)] <= slack + 1.5 * width)
      {
        kept(y, x) = 255;
      }
    }
  }
  return kept;
}

// The connected part under a place, else the largest; nothing of an empty mask.
cv::Mat1b oneOf(const cv::Mat1b& mask, const std::optional<cv::Point>& place)
{
  cv::Mat1i parts, statistics;
  cv::Mat1d centres;
  const int count = cv::connectedComponentsWithStats(mask, parts, statistics, centres, 8);
  int chosen = place ? parts(*place) : 0;
  for (int i = 1; i < count && !(place && parts(*place) > 0); ++i)
  {
    const int area = statistics(i, cv::CC_STAT_AREA);
    chosen = chosen == 0 || area > statistics(chosen, cv::CC_STAT_AREA) ? i : chosen;
  }
  if (chosen == 0)
  {
    return cv::Mat1b(mask.size(), std::uint8_t(0));
  }
  return cv::Mat1b(parts == chosen);
}

using Chain = std::vector<cv::Point>;

// Between the four pixels round a place, which may be half a pixel beyond the outermost; 0 farther out.
double coverAt(const cv::Mat1b& cover, const Vector2& place)
{
  const int x = static_cast<int>(std::floor(place[0])), y = static_cast<int>(std::floor(place[1]));
  const double s = place[0] - x, t = place[1] - y;
  const auto at = [&](int u, int v) -> double
  { return u >= 0 && v >= 0 && u < cover.cols && v < cover.rows ? cover(v, u) : 0.0; };
  return (1.0 - t) * ((1.0 - s) * at(x, y) + s * at(x + 1, y)) +
         t * ((1.0 - s) * at(x, y + 1) + s * at(x + 1, y + 1));
}

// How far from a pixel in the thing coverage crosses one half; half a pixel where it does not within two.
double wayOut(const cv::Mat1b& cover, const Vector2& from, const Vector2& outward)
{
  constexpr double step = 0.25, farthest = 2.0;
  double before = coverAt(cover, from);
  for (double way = step; way <= farthest; way += step)
  {
    const double now = coverAt(cover, from + way * outward);
    if (before >= halfCover && now < halfCover)
    {
      return way - step * (halfCover - now) / (before - now);
    }
    before = now;
  }
  return 0.5;
}

// The pixels of a rim moved to where it is between them, within the picture.
Polyline placed(const Chain& chain, bool isHole, const cv::Mat1b& cover)
{
  constexpr int side = 3; // pixels that a tangent reaches to either side
  const int count = static_cast<int>(chain.size());
  const auto pixel = [&](int i)
  {
    const cv::Point& at = chain[static_cast<std::size_t>((i + side * count) % count)];
    return Vector2(at.x, at.y);
  };
  const double turn = (cv::contourArea(chain, true) < 0.0 ? -1.0 : 1.0) * (isHole ? -1.0 : 1.0);
  Polyline rim;
  for (int i = 0; i < count; ++i)
  {
    const Vector2 along = pixel(i + side) - pixel(i - side);
    const Vector2 outward =
      along.norm() > 0.0 ? Vector2(turn * Vector2(along[1], -along[0]).normalized()) : Vector2::Zero().eval();
    const Vector2 at = pixel(i) + wayOut(cover, pixel(i), outward) * outward;
    rim.emplace_back(at.cwiseMax(Vector2::Zero()).cwiseMin(Vector2(cover.cols - 1, cover.rows - 1)));
  }
  return rim;
}

// Gaussian means along a closed line of places, one a pixel.
cv::Mat2d meansAlong(const cv::Mat2d& line)
{
  constexpr int reach = 6;
  constexpr double sigma = 1.5; // px
  cv::Mat2d round, means;
  cv::copyMakeBorder(line, round, 0, 0, reach, reach, cv::BORDER_WRAP);
  cv::GaussianBlur(round, means, { 2 * reach + 1, 1 }, sigma);
  return means.colRange(reach, reach + line.cols);
}

// Without the stairs of pixels, samples 1 px apart. The remainder of a smoothed line, smoothed too, gives
// corners and round rims back what smoothing took.
Polyline smoothed(const Polyline& rim)
{
  const std::vector<double> lengths = arcLengths(rim, true);
  const int count = std::max(8, static_cast<int>(std::lround(lengths.back())));
  cv::Mat2d even(1, count);
  const std::vector<Blend> places = evenPlaces(lengths, static_cast<int>(rim.size()), count);
  for (int i = 0; i < count; ++i)
  {
    const Vector2 at = places[static_cast<std::size_t>(i)].of(rim);
    even(0, i) = cv::Vec2d(at[0], at[1]);
  }
  const cv::Mat2d means = meansAlong(even), rest = meansAlong(cv::Mat2d(even - means));
  Polyline result;
  for (int i = 0; i < count; ++i)
  {
    const cv::Vec2d at = means(0, i) + rest(0, i);
    result.emplace_back(at[0], at[1]);
  }
  return result;
}

// Samples as a hand leaves them, of those that lie 1 px apart, within a picture of that size.
Polyline drawnFrom(const Polyline& rim, const cv::Size& size)
{
  constexpr int usual = 4, near = 2, side = 3;
  constexpr double bend = 0.3; // rad
  const int count = static_cast<int>(rim.size());
  const auto at = [&](int i) { return rim[static_cast<std::size_t>((i + count) % count)]; };
  Polyline drawn;
  for (int i = 0, last = -usual; i <= count - near; ++i)
  {
    const Vector2 before = at(i) - at(i - side), after = at(i + side) - at(i);
    const double turning = std::atan2(before[0] * after[1] - before[1] * after[0], before.dot(after));
    if (i - last >= (std::abs(turning) > bend ? near : usual))
    {
      drawn.push_back(at(i).cwiseMax(Vector2::Zero()).cwiseMin(Vector2(size.width - 1, size.height - 1)));
      last = i;
    }
  }
  return drawn;
}

// The rims of a mask of one part, the outer one first.
std::vector<TracedRim> rimsOf(const cv::Mat1b& mask, const cv::Mat1b& cover, double width)
{
  std::vector<Chain> chains;
  std::vector<cv::Vec4i> nesting;
  cv::findContours(mask, chains, nesting, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  std::vector<TracedRim> rims;
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    const bool isHole = nesting[i][3] >= 0;
    const auto length = static_cast<double>(chains[i].size());
    // Pixels that it goes round, by Pick's theorem.
    const double inside = cv::contourArea(chains[i]) - 0.5 * length + 1.0;
    if (!isHole || 2.0 * inside >= width * length)
    {
      const auto place = isHole ? rims.end() : rims.begin();
      rims.insert(
        place, TracedRim{ drawnFrom(smoothed(placed(chains[i], isHole, cover)), mask.size()), isHole });
    }
  }
  return rims;
}

// Whether no rim meets itself or another one, as strokes of a drawing must not.
bool areApart(const std::vector<TracedRim>& rims, const Context& context)
{
  const auto curves = mapped(rims, [](const TracedRim& rim) { return PlaneCurve{ rim.points, true }; });
  const std::vector<Meeting> met = meetings(curves, context);
  return std::none_of(met.begin(), met.end(), [](const Meeting& one) { return one.segment >= 0; });
}

std::vector<TracedRim> rimsIn(const PictureSamples& picture,
  const std::optional<cv::Point>& place,
  const Context& context)
{
  const double width = std::max(3.0, 0.006 * std::max(picture.width, picture.height)); // of a whisker
  const Thing thing = thingIn(picture, place, context);
  if (thing.mask.empty())
  {
    return {};
  }
  cv::Mat1b cover, covered, kept;
  const auto look = [&](const cv::Mat1b& mask, double done)
  {
    context.checkpoint(done);
    cover = thing.alpha.empty() ? coverage(thing.colours, mask, thing.off, context) : thing.alpha;
    covered = cover > halfCover;
    kept = withoutWhiskers(covered, width);
  };
  look(thing.mask, 0.5);
  if (!thing.solid.empty() && 2 * cv::countNonZero(kept) < cv::countNonZero(covered))
  {
    look(thing.solid, 0.7); // lines alone
  }
  cv::Mat1b whole = oneOf(kept, place);
  constexpr double speck = 0.001; // of the picture
  if (!(place && whole(*place)) && cv::countNonZero(whole) < speck * static_cast<double>(whole.total()))
  {
    return {};
  }
  // Ragged rims meet themselves, where slits and necks are not closed and cut.
  constexpr int narrowest = 3, widest = 9; // px
  for (int slit = narrowest;; slit += 2)
  {
    context.checkpoint(0.8);
    cv::Mat1b told = cover.clone();
    told.setTo(0, covered & ~whole);
    told.setTo(255, whole & ~covered);
    std::vector<TracedRim> rims = rimsOf(whole, told, width);
    if (slit > widest || areApart(rims, context))
    {
      return rims;
    }
    const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, { slit, slit });
    cv::Mat1b closed, open;
    cv::morphologyEx(whole, closed, cv::MORPH_CLOSE, disc);
    cv::morphologyEx(closed, open, cv::MORPH_OPEN, disc);
    whole = oneOf(open, place);
  }
}

} // namespace

std::vector<TracedRim> traced(const PictureSamples& picture,
  const std::optional<Vector2>& place,
  const Context& context)
{
  std::vector<TracedRim> rims;
  withOpenCV("trace what is in the picture",
    [&]
    {
      std::optional<cv::Point> pixel;
      if (place)
      {
        pixel = cv::Point(std::clamp(static_cast<int>(std::lround((*place)[0])), 0, picture.width - 1),
          std::clamp(static_cast<int>(std::lround((*place)[1])), 0, picture.height - 1));
      }
      rims = rimsIn(picture, pixel, context);
    });
  if (rims.empty())
  {
    throw Error(Failure::BadStroke,
      "There is nothing to trace: nothing of the picture that is wide enough to be drawn stands out from "
      "what is round it; choose a place on another thing, or draw its outline.");
  }
  return rims;
}

} // namespace oversketch
