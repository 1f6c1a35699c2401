/**
 * @class vtkOversketchMatch
 * @brief the section of the silhouette that a stroke is drawn over
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 3.3, Eq. 3: of the visible curves
 * the one of least D = mean image-plane distance of the stroke's samples to their nearest points on it; the
 * section is its part between the points nearest to the stroke's ends. Departures: samples are taken at 2 px,
 * so that D does not depend on the pen; of a closed curve the arc with the smaller mean distance back to the
 * stroke counts; the section runs along the stroke. With AmendedScore (specification 13.2) the section of
 * least score is taken instead: mean distance of the stroke to the section + mean distance of the section to
 * the stroke + half the sum of the gaps at its two ends; both arcs of closed curves compete; and a silhouette
 * curve of which four fifths run within 3 px of a loop from vtkOversketchOutline is left to that loop, so
 * that its offsets are kept.
 *
 * The ends of a stroke beside its limb are nearest to another limb, and the section between them is the
 * crotch or the long way round the whole body. With CompareShapes sections that look like the stroke anywhere
 * else compete with that one: their score counts a common shift of the whole stroke once (1.5 times its
 * length) and not in each of the three terms. Where the section between the nearest places is the same one
 * but for its ends, it stays as it is.
 *
 * Input 0 (Curves, repeatable): curves from vtkOversketchVisibility and, optionally, loops from
 * vtkOversketchOutline: point arrays MeshVertices, MeshWeights, Normals and, optionally, Display and
 * Offset; cells with Visible 0 are ignored, cells of an input with cell array Hole are loops.
 *
 * Input 1 (Stroke): exactly one stroke with its view (cell arrays ViewTransform, ProjectionTransform,
 * ViewportSize); optional cell array Moved, double[2] [px].
 *
 * A stroke that was dragged since it was drawn (cell array Moved) is matched where it was drawn: it keeps its
 * section.
 *
 * A closed stroke, drawn round a limb and back over its base, is opened there (with CompareShapes): the part
 * over the base stands for no outline.
 *
 * Output 0 (Section): one open polyline, from the place nearest to the stroke's first sample to the one
 * nearest to its last; its ends are interpolated, and hang on the mesh where the points they lie between
 * share a triangle. Point arrays:
 * - MeshVertices, MeshWeights, Normals, NormalDotView as in vtkOversketchSilhouette (MeshVertices -1: hangs
 * on nothing),
 * - Display, double[2] [px], and Offset, double[2] [px]: as in vtkOversketchOutline; on a plain curve the
 *   point's picture and zero.
 *
 * Cell array CurveId, int: of the matched curve. Field data Distance, double [px]: D of the matched curve;
 * Score, double [px]: what was minimised; Candidate, int: index of the connection on port 0 that the section
 * came from. Other arrays are dropped.
 *
 * Output 1 (Stroke): the stroke, opened where it was closed; it has then no point arrays.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray, BadStroke; BadMesh for unusable
 * curves; NoMatch when no section of at least 2 px with two points on the mesh fits, D exceeds
 * MaximumDistance, the stroke is farther than MaximumGap from every curve, or fewer than Candidate sections
 * fit. Curves without points give an empty output silently.
 *
 * Deterministic. Cost: curve points plus stroke samples, times a search over blocks of the other; the curves
 * are read once while they and the view stand.
 *
 * @sa vtkOversketchVisibility, vtkOversketchOutline, vtkOversketchTargets
 */
#ifndef vtkOversketchMatch_h
#define vtkOversketchMatch_h

#include "OversketchFiltersSilhouetteModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory>

class OVERSKETCHFILTERSSILHOUETTE_EXPORT vtkOversketchMatch : public vtkPolyDataAlgorithm
{
public:
  static vtkOversketchMatch* New();
  vtkTypeMacro(vtkOversketchMatch, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The stroke with its view, on port 1.
   */
  void SetStrokeConnection(vtkAlgorithmOutput* stroke) { this->SetInputConnection(1, stroke); }
  void SetStrokeData(vtkPolyData* stroke) { this->SetInputData(1, stroke); }

  ///@{
  /**
   * Choose by the amended score; off: by D alone, as published [default on].
   */
  vtkSetMacro(AmendedScore, bool);
  vtkGetMacro(AmendedScore, bool);
  vtkBooleanMacro(AmendedScore, bool);
  ///@}

  ///@{
  /**
   * With AmendedScore: let the section stand against those that look like the stroke elsewhere (see above)
   * [default on; off as published].
   */
  vtkSetMacro(CompareShapes, bool);
  vtkGetMacro(CompareShapes, bool);
  vtkBooleanMacro(CompareShapes, bool);
  ///@}

  ///@{
  /**
   * Which of the sections that fit is taken, 1 for the one that fits best [>= 1, default 1; read with
   * CompareShapes]. A number beyond the last one is refused.
   */
  vtkSetClampMacro(Candidate, int, 1, VTK_INT_MAX);
  vtkGetMacro(Candidate, int);
  ///@}

  /**
   * How many sections fitted the last stroke: so many candidates there are.
   */
  vtkGetMacro(NumberOfCandidates, int);

  ///@{
  /**
   * Strokes of which no place is nearer to any visible curve are refused [px, >= 0, default 0: no limit, as
   * published].
   */
  vtkSetClampMacro(MaximumGap, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumGap, double);
  ///@}

  ///@{
  /**
   * Strokes whose D is larger are refused [px, >= 0, default 0: no limit, as published].
   */
  vtkSetClampMacro(MaximumDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumDistance, double);
  ///@}

protected:
  vtkOversketchMatch();
  ~vtkOversketchMatch() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkOversketchMatch(const vtkOversketchMatch&) = delete;
  void operator=(const vtkOversketchMatch&) = delete;

  bool AmendedScore = true;
  bool CompareShapes = true;
  int Candidate = 1;
  int NumberOfCandidates = 0;
  double MaximumDistance = 0.0;
  double MaximumGap = 0.0;

  struct Cache;
  std::unique_ptr<Cache> Internals;
};

#endif
