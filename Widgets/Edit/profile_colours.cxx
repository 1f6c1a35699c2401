#include "profile_colours.h"

#include <cmath>

namespace oversketch
{

void paintProfile(Overlay& overlay, const std::vector<Polyline>& pieces, double width)
{
  double length = 0.0;
  for (const Polyline& piece : pieces)
  {
    overlay.line(piece, width + 2.0, paperWhite);
    length += piece.empty() ? 0.0 : arcLengths(piece).back();
  }
  double done = 0.0;
  for (const Polyline& piece : pieces)
  {
    for (std::size_t i = 1; i < piece.size(); ++i)
    {
      const double share = length > 0.0 ? done / length : 0.0;
      Colour colour{ 0, 0, 0, 255 };
      for (std::size_t c = 0; c < 3; ++c)
      {
        colour[c] =
          static_cast<unsigned char>(std::lround((1.0 - share) * regionOrange[c] + share * sectionBlue[c]));
      }
      overlay.line({ piece[i - 1], piece[i] }, width, colour);
      done += (piece[i] - piece[i - 1]).norm();
    }
  }
}

} // namespace oversketch
