#include "Ray/surface_pieces.h"

#include <algorithm>

namespace oversketch
{

namespace
{

// Splits a row of samples at its gaps.
std::vector<SurfaceCurve> cutAtGaps(const std::vector<std::vector<SurfaceSample>>& rows)
{
  std::vector<SurfaceCurve> pieces(1);
  for (const std::vector<SurfaceSample>& row : rows)
  {
    for (const SurfaceSample& sample : row)
    {
      std::vector<SurfaceSample>& samples = pieces.back().samples;
      if (sample.at.triangle < 0)
      {
        pieces.emplace_back();
      }
      else if (samples.empty() || samples.back().position != sample.position)
      {
        samples.push_back(sample);
      }
    }
  }
  return pieces;
}

// The last piece of a closed stroke ends where the first one begins, if that place was hit.
void joinRing(std::vector<SurfaceCurve>& pieces, int strokeSize)
{
  std::vector<SurfaceSample>& first = pieces.front().samples;
  std::vector<SurfaceSample>& last = pieces.back().samples;
  if (first.empty() || last.empty() || first.front().position != last.back().position)
  {
    return;
  }
  if (pieces.size() == 1)
  {
    if (first.size() > 3)
    {
      first.pop_back();
      pieces.front().closed = true;
    }
    return;
  }
  for (std::size_t i = 1; i < first.size(); ++i)
  {
    first[i].along += strokeSize;
  }
  last.insert(last.end(), first.begin() + 1, first.end());
  first.swap(last);
  pieces.pop_back();
}

} // namespace

std::vector<SurfaceCurve> piecesOf(const std::vector<std::vector<SurfaceSample>>& rows,
  bool closed,
  int strokeSize)
{
  std::vector<SurfaceCurve> pieces = cutAtGaps(rows);
  if (closed)
  {
    joinRing(pieces, strokeSize);
  }
  pieces.erase(
    std::remove_if(
      pieces.begin(), pieces.end(), [](const SurfaceCurve& piece) { return piece.samples.size() < 2; }),
    pieces.end());
  return pieces;
}

} // namespace oversketch
