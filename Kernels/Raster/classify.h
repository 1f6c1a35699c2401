// Classes of a drawing's strokes: an object's boundary, a closed or an open feature, or none of these.
#ifndef oversketch_kernels_raster_classify_h
#define oversketch_kernels_raster_classify_h

#include "Mesh/context.h"
#include "Raster/frame.h"

#include <algorithm>

namespace oversketch
{

// How many samples of a line are beside an area, over one of their four sides.
struct Contact
{
  int blob = 0, pixels = 0;
};

enum class Role : int
{
  Rejected = -1,
  Unknown = 0,
  Boundary = 1,      // of an object: it lies in no other stroke
  ClosedFeature = 2, // lies in a region and bounds one
  OpenFeature = 3    // lies in a region
};

enum class Rejection : int
{
  None = 0,
  TooShort,      // fewer than two distinct points, a closed one fewer than three
  OffCanvas,     // or not finite
  CrossesItself, // or touches
  Crosses,       // another stroke, or touches it
  Outside,       // an open one in no region
  TooSmall,      // a closed one round less than 9 px, or one that crosses itself in a box of less
  Areas          // touches more areas, or fewer, than a stroke of its kind does
};

struct StrokeClass
{
  Role role = Role::Unknown;
  int region = -1;      // that it lies in; of a boundary, the one it bounds
  int childRegion = -1; // that a closed feature bounds
  int object = -1;
  Rejection rejection = Rejection::None;
  int other = -1;   // the stroke it crosses
  int segment = -1; // where it crosses itself or another one: from this point to the next
  std::vector<Contact> contacts;
};

// Area that a closed stroke bounds which is not rejected, numbered in the strokes' order.
struct Region
{
  int stroke = -1; // that bounds it
  int parent = -1; // the region it lies in
  int object = -1;
  int depth = 0; // 0 for an object's whole
  std::vector<int> children;
  std::vector<int> features; // strokes, closed and open, that lie in it
};

struct Classification
{
  std::vector<StrokeClass> strokes;
  std::vector<Region> regions;
  int objects = 0;
  // Each sample's background area (0: outside everything), -1 - i on stroke i, the last of several.
  std::vector<int> labels;
  int blobs = 0; // background areas and strokes on the canvas
};

struct DrawnStroke
{
  Polyline points;     // world
  bool closed = false; // the first point is not repeated
  // Samples, ascending, that other strokes have too: there they may meet (Planar/arrange.h).
  std::vector<int> nodes = {};
  int number = -1; // that it is called by in messages; -1: its place among the strokes

  bool isNode(int sample) const { return std::binary_search(this->nodes.begin(), this->nodes.end(), sample); }
};

// Number by which messages call a stroke.
inline int nameOf(const std::vector<DrawnStroke>& strokes, int stroke)
{
  return strokes[stroke].number < 0 ? stroke : strokes[stroke].number;
}

// Source: image-assisted modelling, section 5. Lines are 1 px, strokes 8-connected, the background
// 4-connected. Regions are those of the closed curves themselves: one lies in the smallest other one round
// it, in no other one it bounds an object; open strokes lie in regions likewise. Strokes that meet another
// one or themselves are rejected, all of them, by an exact test of their segments rounded to 2^-20 px.
//
// contactShare: an area that a stroke touches with less than this share of the pixels that it touches its
// largest one with is ignored; 0.05. An open stroke at three or more areas is rejected; a closed stroke that
// crosses nothing is sound however many it touches. With 0, as published, every area counts: a stroke is
// rejected at three or more, an open one at two (the paper takes it for closed, or fails), a closed one at
// one. Departure: roles follow from the curves in both, which is what areas tell of what is not rejected.
//
// Where strokes meet in a node of both they do not cross, and areas are not counted of strokes with nodes:
// those of arranged strokes, section 17, meet nowhere else, and touch as many areas as they have neighbours.
//
// Roles and regions do not depend on order and direction of the strokes, up to numbers. Nothing is thrown
// for a bad stroke; Error(Failure::Cancelled) when cancelled.
Classification classify(const Frame& frame,
  const std::vector<DrawnStroke>& strokes,
  double contactShare,
  const Context& context);

// Texts about strokes that cross, which vtkOversketchArrange would take as they are.
constexpr const char* crossesItselfText =
  "{Stroke %1} crosses itself near {(%2, %3)}; draw it without the loop.";
constexpr const char* crossesText =
  "{Stroke %1} crosses {stroke %2} near {(%3, %4)}; end it before the other "
  "one, or draw one of them anew.";

// Why a stroke was rejected and what to do about it; empty when it was not.
Message rejectionText(const Classification& classification,
  int stroke,
  const std::vector<DrawnStroke>& strokes);

} // namespace oversketch
#endif
