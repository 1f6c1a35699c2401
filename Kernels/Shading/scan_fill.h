// Which pixels lie in a drawn polygon.
#ifndef oversketch_kernels_shading_scan_fill_h
#define oversketch_kernels_shading_scan_fill_h

#include <array>
#include <vector>

namespace oversketch
{

using Pixel = std::array<int, 2>; // x to the right, y upwards

// Pixels begin <= x < end of a row.
struct Span
{
  int y, begin, end;
};

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.4.1, after Foley and
// van Dam: edges join successive pixels and the last with the first; a row's pixels between the first and
// second edge, the third and fourth are inside. A pixel on a left or bottom edge is inside, one on a right or
// top edge is not, so polygons that share an edge share no pixel and leave none out. Rows from the bottom,
// each from the left, no span empty or next to another one.
//
// Departures: places of edges on a row are whole numbers and remainders, not sums of doubles, which gave
// other pixels for three of four random polygons. The text prints an edge's slope without its sign and calls
// the pixels strictly inside, though by its own rules the left and the bottom border are among them.
//
// Throws Error(Failure::BadStroke) for a pixel beyond 1e6 in x or y.
std::vector<Span> scanFill(const std::vector<Pixel>& polygon);

// 1 for those of width x height pixels that are inside, row by row.
std::vector<char> filledMask(const std::vector<Pixel>& polygon, int width, int height);

} // namespace oversketch
#endif
