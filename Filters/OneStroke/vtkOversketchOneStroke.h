/**
 * @class vtkOversketchOneStroke
 * @brief one stroke over a silhouette deforms the mesh: the whole of SEED as one filter
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation". The stroke replaces the part of the
 * silhouette that it was drawn near; control points, region of interest and deformation follow from it.
 * Inside, each step is a filter of its own (names in braces reach its output, see GetInnerOutput): clean
 * stroke {Stroke}, silhouette {Silhouette}, snake smoothing {Snake}, hidden parts {Visibility}, outline of
 * the picture {Outline}, matched section {Match}, targets {Targets}, shape diameter {ShapeDiameter}, Gaussian
 * mixtures and region growing {MixtureRegion}, region border {RegionBorder}, remeshing before {Stretch},
 * Laplacian deformation {Deform}, control points where its outline missed the stroke {Correction}, remeshing
 * after {Restore}.
 *
 * Departures from the paper are the amendments of each step, on by default; AsPublished turns all of them
 * off. Remeshing is Auto by default (the paper leaves it to the user): it is done where the plain deformation
 * stretches edges of the region by more than 1.5 (at least 1 % of them) or makes triangles narrow (an angle
 * under 30 degrees; at least 1 % of the region's more than before), and its result is kept only if the
 * outline has not left the stroke by 0.5 px more, in the mean and at worst, and no more edges are folded, or
 * if it is nearer to the stroke by 0.5 px at worst and no more than five edges were folded; and never where
 * what moved is rougher (mean angle between triangles over 1.25 times plus 1 degree of the plain one's, or
 * over 0.01 more of the edges' length beyond 40 degrees), since a limb is seen by its shading, nor where more
 * of it is seen from within (by 0.002 of what is seen) or passes through itself (over ten pairs of triangles
 * that cross, and more than of the plain one). A plain result that moved what lies beside the stroke and
 * misses it far, or is most of the surface, is not remeshed. Of a remeshed one with over five folds these are
 * taken out.
 *
 * Every result is judged before it is handed over, as it is seen by who drew: the outline against the stroke
 * both ways, folded edges, what is newly seen from within, what newly passes through itself, stretch,
 * roughness before and after, the share of the surface that moved and what moved beside the stroke (the
 * figures below). Where that is a wreck another section is tried, see Candidate. What is not as drawn is said
 * in one warning (vtkWarningMacro; GetRemark repeats it), in words and figures. A result that tears is
 * refused, see AllowTorn.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData. Points that a reader split for texture coordinates or
 * normals are welded for computing (exactly equal positions) and split again in the output. The mesh's
 * normals are not read: the silhouette of the surface itself is meant. Point array Mask, where it has one
 * (vtkOversketchMask): points with 1 leave the region, so that neither remeshing nor deformation touches
 * them; less counts as free.
 * Input 1 (Stroke): one stroke (one polyline in display coordinates with the cell
 * arrays ViewTransform, ProjectionTransform, ViewportSize).
 *
 * Output 0: the deformed mesh. Point, cell and field arrays survive; where the remesher made points they are
 * interpolated (along texture seams once per side), and normals turn with the surface. Points outside the
 * region and masked ones are bit-identical and, where nothing was remeshed, all points and cells keep their
 * ids; else the arrays of a 4-8 mesh are dropped.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): one message, that of the step that failed, with its
 * failure; BadRegion where all that the stroke would pull is masked; Torn where the result is refused; output
 * empty. An empty mesh gives an empty output silently.
 * After AbortExecute the output is empty and the error code Cancelled; call Modified() before the next
 * Update.
 *
 * Demand-driven: a new stroke computes neither shape diameter nor whole-model mixture again, a new stroke in
 * the same view no silhouette either; a new target for the same section and region uses the factorisation
 * again; a changed attribute array but Mask re-runs no step. Deterministic: same input, same bits, whatever
 * the number of threads.
 *
 * @sa vtkOversketchLaplacianDeform vtkOversketchMixtureRegion vtkOversketchMatch
 */
#ifndef vtkOversketchOneStroke_h
#define vtkOversketchOneStroke_h

#include "OversketchFiltersOneStrokeModule.h" // For export macro
#include "vtkOversketchSystem.h"

#include <memory>

class OVERSKETCHFILTERSONESTROKE_EXPORT vtkOversketchOneStroke : public vtkOversketchSystem
{
public:
  static vtkOversketchOneStroke* New();
  vtkTypeMacro(vtkOversketchOneStroke, vtkOversketchSystem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The stroke, on port 1.
   */
  void SetStrokeConnection(vtkAlgorithmOutput* stroke) { this->SetInputConnection(1, stroke); }
  void SetStrokeData(vtkPolyData* stroke) { this->SetInputData(1, stroke); }

  enum RemeshType
  {
    RemeshAuto = 0,
    RemeshOn = 1,
    RemeshOff = 2
  };

  /**
   * What the rays of the last run ran on: OpenCL or Host (Embree).
   */
  int GetBackendUsed() override;

  ///@{
  /**
   * Two-stage remeshing (Sec. 5.2): Auto (default, see above), On, Off.
   */
  vtkSetClampMacro(Remesh, int, RemeshAuto, RemeshOff);
  vtkGetMacro(Remesh, int);
  void SetRemeshToAuto() { this->SetRemesh(RemeshAuto); }
  void SetRemeshToOn() { this->SetRemesh(RemeshOn); }
  void SetRemeshToOff() { this->SetRemesh(RemeshOff); }
  ///@}

  ///@{
  /**
   * Let Laplacian coordinates turn with the surface (Sec. 5.1, AdjNorm): slower, better for large rotations.
   * Default off.
   */
  void SetAdjustNormals(bool adjust);
  bool GetAdjustNormals() const;
  vtkBooleanMacro(AdjustNormals, bool);
  ///@}

  ///@{
  /**
   * After deforming, add control points where other parts of the surface have become the outline and miss the
   * stroke, deform once more, and keep the better result (vtkOversketchCorrection). Where more than five
   * edges were folded, the second deformation pulls its handles with a fifth of the weight. Default on;
   * AsPublished turns it off.
   */
  vtkSetMacro(CorrectOutline, bool);
  vtkGetMacro(CorrectOutline, bool);
  vtkBooleanMacro(CorrectOutline, bool);
  ///@}

  ///@{
  /**
   * Turn every amendment of every step off (true) or on (false, default); sets the properties of the inner
   * steps at once, so single ones can be changed afterwards by GetStep. As published implies Remesh Off
   * unless it is On.
   */
  void SetAsPublished(bool published);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  ///@{
  /**
   * Which of the sections that fit the stroke is taken, 1 (default) for the one that fits best; where that
   * one turns a limb inside out, or misses far, the next of three that does as drawn. A number beyond the
   * last is refused; as published there is one. GetNumberOfCandidates: how many the last stroke had.
   */
  vtkSetClampMacro(Candidate, int, 1, VTK_INT_MAX);
  vtkGetMacro(Candidate, int);
  int GetNumberOfCandidates() const;
  ///@}

  ///@{
  /**
   * How much further into the body than found the region goes, less far where negative, in lengths of the
   * section, -1 to 1; default 0. See vtkOversketchMixtureRegion.
   */
  vtkSetClampMacro(Reach, double, -1.0, 1.0);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /**
   * Hand over a result that is torn, with a warning: one edge in a hundred of what moved is stretched or
   * squeezed more than 8 times and was not remeshed, or that, over 0.7 of the surface moved or over ten new
   * pairs of triangles cross, and the result is not as drawn else. Default off: it is refused. As published
   * nothing is refused.
   */
  vtkSetMacro(AllowTorn, bool);
  vtkGetMacro(AllowTorn, bool);
  vtkBooleanMacro(AllowTorn, bool);
  ///@}

  /**
   * What the last result is like: effect.outline_px and effect.worst_outline_px, mean and worst distance of
   * the stroke's middle 60 % to the outline, and effect.outline_back_px, of the outline between its ends back
   * to it; effect.new_folds, edges; effect.inside_out, share of what is seen of the mesh that newly shows its
   * back [0 to 1]; effect.new_crossings, pairs of triangles that newly pass through each other;
   * effect.stretch, by how much 99 of 100 edges of what moved are stretched or squeezed at most;
   * effect.roughness_before and effect.roughness, mean angle between triangles of what moved [degrees];
   * effect.moved_share of the surface [0 to 1]; effect.stray_distance_px, how far beside the stroke and its
   * section something moved (0: nothing beyond 25 px), and effect.stray_movement_px, by how much at most.
   *
   * And of the steps: remeshed; match.points; targets.handles; region.vertices, region.of_vertices and
   * region.area_share, of triangles wholly in it; deformation.movable_vertices, deformation.active_handles,
   * deformation.mean_handle_residual and deformation.maximum_handle_residual [model length].
   */
  FigureList Figures() override;

  ///@{
  /**
   * Prepare makes what rays into the mesh on port 0 need. Preview runs the steps up to {Match} and gives its
   * section; while mesh and view stay the same a call costs the match alone, and inner outputs up to
   * {Match} are those of the preview. The hold is the section that the last run matched.
   *
   * Drag: where the output was not remeshed it is that of vtkOversketchLaplacianDeform::Drag with the targets
   * moved, else the remeshed points follow the triangles of the deformation that they lie on.
   */
  bool Prepare() override;
  bool Preview(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* hold) override;
  void GetHold(vtkPolyData* hold) override;
  void GetRegion(vtkPolyData* region) override;
  bool Drag(const double translation[3], vtkPoints* points) override;
  void ReleaseWork() override;
  ///@}

  /**
   * True when the last output was remeshed.
   */
  vtkGetMacro(Remeshed, bool);

  /**
   * By the names above, of which {Deform} is the deformation that the output was made of. Outline is empty as
   * published, Stretch and Restore are without remeshing. For GetStep {Deform} is the step that deforms the
   * mesh as it came, {DeformRemeshed} the one between the remeshers, {DeformCorrected} and
   * {DeformRemeshedCorrected} those with the handles of {Correction} and {CorrectionRemeshed}.
   */
  vtkPolyData* GetInnerOutput(const char* name) override;

  /**
   * The step, for GetStep, whose deformation the last output was made of: Deform, DeformCorrected,
   * DeformRemeshed or DeformRemeshedCorrected.
   */
  const char* GetDeformationName() const;

protected:
  vtkOversketchOneStroke();
  ~vtkOversketchOneStroke() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void BackendChanged() override;

private:
  int Remesh = RemeshAuto;
  bool CorrectOutline = true;
  bool AsPublished = false;
  bool AllowTorn = false;
  int Candidate = 1;
  double Reach = 0.0;
  bool Remeshed = false;

  struct Pipeline;
  std::unique_ptr<Pipeline> Inner;
};

#endif
