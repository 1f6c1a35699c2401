// Strokes onto a surface: along the lines of sight, or, as a new outline, beside the silhouette.
//
// Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. III-A. Departures, both on
// by default: strokes are made denser where the surface bends and cut where it leaps, since plain samples
// step through the air at every occlusion (projectStroke); and a sketch comes back to the surface by the hit
// next to the one before, since the first hit is often on the far side (SketchProjection::Line).
#ifndef oversketch_kernels_ray_projection_h
#define oversketch_kernels_ray_projection_h

#include "Mesh/view.h"
#include "Ray/surface_rays.h"

#include <vector>

namespace oversketch
{

struct SurfaceSample
{
  SurfacePoint at;
  Vector3 position = Vector3::Zero(); // of `at`
  // Where on the stroke: sample floor(along), and the share of the way to the next. Of a closed stroke it may
  // run on beyond the last sample, modulo their number.
  double along = 0.0;
};

struct SurfaceCurve
{
  std::vector<SurfaceSample> samples; // no two that follow each other at one place
  bool closed = false;                // the first sample is not repeated
};

// The line of sight through a place of the picture [px], from the eye; in a parallel view from before all of
// the surface, as the camera has no place there. Near and far planes mean nothing.
Ray lineOfSight(const View& view, const Vector2& display, const SurfaceRays& surface);

// The stroke [px] as it lies on what is seen first, in pieces where samples miss the surface. With a
// tolerance [model length] above 0, between two samples the stroke is halved in the picture, at most nine
// times, until the surface under the middle is that near to the middle of the chord and the chord is no
// longer than 20 pixels' size, and, where those are more than two, than 25 tolerances: that is half the
// radius of a feature where the tolerance is a fiftieth of it. What then is longer, and what misses, is cut.
// Pieces with fewer than two samples are left out; of a closed stroke (its first sample not repeated) that is
// cut, the pieces that meet at its first sample are one.
std::vector<SurfaceCurve> projectStroke(const SurfaceRays& surface,
  const View& view,
  const std::vector<Vector2>& stroke,
  bool closed,
  double tolerance,
  const Context& context = Context());

// A silhouette curve, or a part of one.
struct SilhouetteChain
{
  std::vector<Vector3> points, normals; // normals of unit length
  bool closed = false;                  // the first point is not repeated
  bool visible = true;
};

// How a sketch in its plane comes to the surface. n is the mean of the silhouette's normals at both ends.
enum class SketchProjection
{
  Ray = 0,  // first hit against n; else along n; else the nearest place
  Line = 1, // the hit of the line along n, both ways, that is nearest to the one before
  Path = 2  // the silhouette between the ends, by shares of length
};

struct SketchRules
{
  SketchProjection projection = SketchProjection::Line;
  double maximumStep =
    0.0; // model length, Line only: a longer step bridges empty space and is refused; 0: none is
  double reach = 20.0; // px from an end of the stroke to the silhouette
};

// The curve on the surface, and beside each of its samples where that part of the surface is to go.
struct SilhouetteSketch
{
  SurfaceCurve curve; // open, one sample for each of the stroke
  std::vector<Vector3> sketch;
  // How far, of a dent, from the curve the surface hides it along the lines of sight: from there on nothing
  // of it need move; 0 of a bump [model length].
  double hidden = 0.0;
};

// The stroke as a new silhouette between the places where it begins and ends: those of `silhouette`, visible
// ones where there are any, that are nearest to its ends in the picture if within reach, else nearest to the
// surface under them. Departure: as published, which the projection Ray does, the surface is asked first; but
// a pen that presses a pixel beside a limb lies on what is behind it, and would take that one's silhouette.
// Departure: a stroke from one side of a limb round its end to the other is none for the projection Line, as
// the mean of the normals is no way to go then.
// Throws Error(Failure::BadStroke) when there is no silhouette, both ends' normals are over 120 degrees
// apart, an end lies too far beside the model, the plane of the sketch is degenerate or seen within 5 degrees
// of edge-on, the sketch has no length, a step is too long, or, for Path, no one chain joins the ends.
SilhouetteSketch sketchSilhouette(const SurfaceRays& surface,
  const View& view,
  const std::vector<Vector2>& stroke,
  const std::vector<SilhouetteChain>& silhouette,
  const SketchRules& rules,
  const Context& context = Context());

// What a tracer joins each sample of a stroke to the one before by.
template <typename Look, typename Tracer>
std::vector<std::vector<SurfaceSample>> rowsOf(const std::vector<Look>& looks,
  const Tracer& tracer,
  const Context& context)
{
  std::vector<std::vector<SurfaceSample>> rows(looks.size());
  context.eachUntilCancelled(static_cast<int>(rows.size()),
    [&](int i)
    {
      if (i > 0)
      {
        tracer.join(looks[i - 1], looks[i], rows[i]);
      }
      else if (looks[0].hit.found())
      {
        rows[0].push_back({ looks[0].hit.at, looks[0].hit.position, 0.0 });
      }
    });
  return rows;
}

// Row 0 is the first sample of the stroke, row i what follows sample i - 1 up to sample i; a sample without
// triangle is a gap. Of a closed stroke of strokeSize samples there is a row more, up to the first one again:
// the pieces that meet there are one. Pieces with fewer than two samples are left out.
std::vector<SurfaceCurve> piecesOf(const std::vector<std::vector<SurfaceSample>>& rows,
  bool closed,
  int strokeSize);

} // namespace oversketch
#endif
