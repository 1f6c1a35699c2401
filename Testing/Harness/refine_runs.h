// From strokes to the refined mesh, with what the guard hands back, for tests. Header-only.
#ifndef oversketch_testing_harness_refine_runs_h
#define oversketch_testing_harness_refine_runs_h

#include "Harness/planar_shapes.h"
#include "Planar/coarse_faces.h"
#include "Planar/darts.h"
#include "Planar/refine.h"
#include "Planar/triangulate.h"

namespace oversketch_test
{

using namespace oversketch;

struct Rebuilt
{
  PlanarRefineResult result;
  int rounds = 0, base = 0;
};

// The coarse mesh of a drawing; of triangles, repaired, or of quads where they can be.
inline PlanarMesh coarseMesh(const UnitDrawing& drawing,
  DeltaMode mode,
  const std::vector<StrokeSplit>& splits,
  bool quads,
  DartMode darts)
{
  ApproximationRules rules;
  rules.mode = mode;
  const std::vector<StrokeLine> lines = strokeLines(
    drawing.polylines(rules, splits), drawing.strokes, drawing.classes.strokes, drawing.treatments);
  const PlanarMesh mesh = triangulate(lines, throwDarts(drawing.maps, lines, darts, 1, Context()), Context());
  const PlanarMesh repaired = repairTerminals(mesh, TerminalRule::TwoBoundaryEdges);
  return quads ? mergeQuads(repaired) : repaired;
}

// Coarse meshes and their refinement, until nothing is handed back; 24 times at most.
inline Rebuilt rebuilt(const UnitDrawing& drawing,
  DeltaMode mode,
  const PlanarRefineOptions& options,
  DartMode darts = DartMode::Off)
{
  Rebuilt run;
  std::vector<StrokeSplit> splits;
  for (;; ++run.rounds)
  {
    const PlanarMesh coarse = coarseMesh(drawing, mode, splits, options.quads, darts);
    run.base = static_cast<int>(coarse.faces.size());
    run.result = refinePlanar(coarse, drawing.strokes, options, Context());
    if (run.result.splits.empty() || run.rounds == 24)
    {
      return run;
    }
    addSplits(splits, run.result.splits);
  }
}

} // namespace oversketch_test
#endif
