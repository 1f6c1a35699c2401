// Refines a drawing's coarse mesh: each level cuts every face in four and puts what lies on strokes on them.
#ifndef oversketch_kernels_planar_refine_h
#define oversketch_kernels_planar_refine_h

#include "Mesh/context.h"
#include "Planar/planar_mesh.h"
#include "Raster/classify.h"

namespace oversketch
{

struct PlanarRefineOptions
{
  int levels = 3; // 0 to 10
  // Share of the snap of a feature's points that their neighbours get; 0 to 1.
  double snapShare = 0.3;
  // Nothing inverted leaves; off, as published, it is counted.
  bool guard = true;
  // L, the longest side of the canvas [world]: a face is inverted whose signed area is at most 1e-12 L^2,
  // with the guard four times that for each level to come, since its parts will be a quarter of it.
  double canvasSide = 1.0;
  // Catmull-Clark's masks also where the mesh has triangles alone.
  bool quads = false;
};

struct PlanarRefineResult
{
  PlanarMesh mesh; // without points where there are splits
  // The parts of strokes to be approximated closer, each once, ascending: those that faces stay inverted at,
  // or, where none does, that the refined edges miss. Never without the guard.
  std::vector<StrokeSplit> splits;
  int inverted = 0; // faces: of the mesh, without the guard; with it those that are the cause of the splits
};

// Source: image-assisted modelling, sections 9 and 10: Loop's subdivision where all faces are triangles,
// Catmull and Clark's where one is a quad, all are after one level. See subdivide.h for masks and snapping,
// guard.h for what keeps faces from turning over, which is our addition: on 13 of 14 real outlines the
// published rule turns over 24 to 700 triangles. Level 0 is the mesh itself, its chords split (see there).
//
// The splits are the parts of strokes along the edges of the coarse faces that faces stay inverted in, or,
// where these have none, along the edges that end at their corners, as the mesh has them. The levels after
// are made all the same, to find them all at once. Who takes them makes the mesh anew from a closer
// approximation; it ends, since strokes between neighbouring samples are straight, where nothing turns over.
//
// An edge misses a sample of its part of the stroke that is farther from it than 0.05 L / 4^levels, what
// becomes of a round curve that was approximated to 0.05 L, and than 0.004 L, 4 px of 1024. The paper leaves
// it there, and small tips and notches with it: on nine of 70 real outlines the rim was 4 to 10 px off.
//
// strokes: all that the mesh's points and edges name. Stroke points lie at S(t), t by arc length;
// an end that joins another stroke takes the stroke's last piece with it. Throws
// Error(Failure::BadMesh), naming the place, for a mesh that is not sound (face_edges.h), names a stroke or a
// length that is not there, or would have more than 2^24 faces, and where inverted faces lie at no stroke;
// Error(Failure::BadStroke) for options out of range. The same to the bit for any number of threads; where
// the guard hands nothing back and nothing turns over also without it.
PlanarRefineResult refinePlanar(const PlanarMesh& mesh,
  const std::vector<DrawnStroke>& strokes,
  const PlanarRefineOptions& options,
  const Context& context);

// The least number of levels after which no edge of a coarse mesh is 4 h = 0.02 L long or longer, if a level
// halves it; edges on strokes are measured along them. Source: section 17, "parameters from the
// sketch: k until edge length < 4 h". Departure: no more levels than make 2^20 faces, at most 10; one long
// edge beside many short ones is not worth more.
int levelsOfSketch(const PlanarMesh& mesh, double canvasSide);

// Whether a coarse mesh's faces are larger on the mean than the square of a sixteenth of the canvas's longest
// side: after three levels they would be wider than 8 px of 1024. Departure: of such a mesh, of a drawing
// that is plump and has few corners, inflated triangles are turned by over 12 degrees and cut dents of up to
// 5 px into the foot of a limb, and the rim is up to 4 px off.
bool hasLargeFaces(const PlanarMesh& mesh, double canvasSide);

// The mesh with every chord, an edge on no stroke between two points of rims, split in the middle, and the
// faces beside them: two copies of it, joined along the rims, would have the chord's edge four times. From
// level 1 on there are none, of triangles where none of them has two edges on rims.
PlanarMesh splitChords(const PlanarMesh& mesh);

// Adds what was handed back to what was before: a part that meets one of those is to be halved once more than
// it was. The order is that of the rounds.
void addSplits(std::vector<StrokeSplit>& splits, const std::vector<StrokeSplit>& more);

} // namespace oversketch
#endif
