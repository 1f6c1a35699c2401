// Strokes that cross, touch or bound something together become curves that meet in common samples alone.
#ifndef oversketch_kernels_planar_arrange_h
#define oversketch_kernels_planar_arrange_h

#include "Mesh/context.h"
#include "Raster/classify.h"

#include <vector>

namespace oversketch
{

struct ArrangedCurve
{
  DrawnStroke curve; // with its nodes: the samples that it shares with others
  int stroke = -1;   // that it is a part of; of several the first
};

// Source: image-assisted modelling, section 17: "node all strokes, trace faces of the arrangement, classify
// faces". The paper names crossing and spanning strokes and boundaries of several strokes as future work.
// Where strokes cross or touch, themselves too, both get a common sample. An open end within `reach` [px] of
// another stroke, or of a far part of its own, goes on to the nearest sample there, the nearest ones first;
// an end that runs past a stroke by less than reach and a fourth of its stroke is cut off there.
//
// What encloses something is told by the faces between the strokes: the outline of all that hangs together,
// but by single lines, becomes one closed curve, whatever strokes it is of. A closed stroke inside stays one
// where neither an outline nor another such stroke meets it. Everything else becomes open curves from node to
// node: what lies inside divides a region there (triangulate.h), what lies outside is for `classify` to
// reject. Faces under a fourth of reach squared between several curves, as two lines drawn for one leave
// them, are joined to a neighbour: the longest curve round them is left out.
//
// Strokes that meet nothing come out as they are. So do those that `classify` rejects by themselves: of too
// few places, or not on the canvas. What is made does not depend on the strokes' order and direction, up to
// numbers; curves follow the order of the strokes.
//
// Throws Error(Failure::BadStroke), naming a stroke and the place, where two parts of an outline hang
// together by one point, which no closed surface has.
std::vector<ArrangedCurve> arrange(const Frame& frame,
  const std::vector<DrawnStroke>& strokes,
  double reach,
  const Context& context);

} // namespace oversketch
#endif
