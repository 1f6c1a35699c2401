#include "Stroke/enclosed.h"

#include "Stroke/with_opencv.h"

#include <opencv2/imgproc.hpp>

namespace oversketch
{

std::vector<char> enclosedBy(const std::vector<Vector2>& lasso,
  const std::vector<Vector2>& places,
  const Context& context)
{
  const auto rounded = [](const Vector2& p)
  { return cv::Point2f(static_cast<float>(p[0]), static_cast<float>(p[1])); };
  const auto box = boxRound(lasso);
  const auto contour = mapped(lasso, rounded);
  std::vector<char> inside(places.size(), 0);
  withOpenCV("test which places a lasso encloses",
    [&]
    {
      context.eachUntilCancelled(static_cast<int>(places.size()),
        [&](int i) {
          inside[i] =
            box.contains(places[i]) && cv::pointPolygonTest(contour, rounded(places[i]), false) >= 0.0;
        });
    });
  context.checkpoint(1.0);
  return inside;
}

} // namespace oversketch
