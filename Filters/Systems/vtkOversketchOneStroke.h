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
 * if it is nearer to the stroke by 0.5 px at worst and no more than five edges were folded.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData. Points that a reader split for texture coordinates or
 * normals are welded for computing (exactly equal positions) and split again in the output. The mesh's
 * normals are not read: the silhouette of the surface itself is meant.
 * Input 1 (Stroke): one stroke (one polyline in display coordinates with the cell arrays ViewTransform,
 * ProjectionTransform, ViewportSize).
 *
 * Output 0: the deformed mesh. Point, cell and field arrays survive; where the remesher made points they are
 * interpolated (along texture seams once per side), and normals turn with the surface. Points outside the
 * region are bit-identical and, where nothing was remeshed, all points and cells keep their ids.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): one message, that of the step that failed, with its
 * failure; output empty. An empty mesh gives an empty output silently. After AbortExecute the output is empty
 * and the error code Cancelled; call Modified() before the next Update.
 *
 * Demand-driven: a new stroke computes neither shape diameter nor whole-model mixture again, a new stroke in
 * the same view no silhouette either; a new target for the same section and region uses the factorisation
 * again; a changed attribute array re-runs no step. Deterministic: same input, same bits, whatever the number
 * of threads.
 *
 * @sa vtkOversketchLaplacianDeform vtkOversketchMixtureRegion vtkOversketchMatch
 */
#ifndef vtkOversketchOneStroke_h
#define vtkOversketchOneStroke_h

#include "OversketchFiltersSystemsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory>

class vtkPoints;

class OVERSKETCHFILTERSSYSTEMS_EXPORT vtkOversketchOneStroke : public vtkPolyDataAlgorithm
{
public:
  static vtkOversketchOneStroke* New();
  vtkTypeMacro(vtkOversketchOneStroke, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The stroke, on port 1.
   */
  void SetStrokeConnection(vtkAlgorithmOutput* stroke) { this->SetInputConnection(1, stroke); }
  void SetStrokeData(vtkPolyData* stroke);

  enum BackendType
  {
    Auto = 0,
    OpenCL = 1,
    Host = 2
  };
  enum RemeshType
  {
    RemeshAuto = 0,
    RemeshOn = 1,
    RemeshOff = 2
  };

  ///@{
  /**
   * Where rays, mixtures and the visibility test run: Auto (default) takes OpenCL where there is a device;
   * Host takes Embree for the rays. Without an OpenCL device the host does the work, with a warning if OpenCL
   * was asked for.
   */
  void SetBackend(int backend);
  int GetBackend() const { return this->Backend; }
  void SetBackendToAuto() { this->SetBackend(Auto); }
  void SetBackendToOpenCL() { this->SetBackend(OpenCL); }
  void SetBackendToHost() { this->SetBackend(Host); }
  ///@}

  /**
   * What the rays of the last run ran on: OpenCL or Host.
   */
  int GetBackendUsed() const;

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

  /**
   * Computes what no stroke changes, the shape diameter of the mesh on port 0, so that the next Update need
   * not: to be called while the hand is busy. Reports progress and honours AbortExecute like a run; leaves
   * the output as it is. Returns false when it was stopped or the mesh cannot be used (the next Update says
   * why).
   */
  bool Prepare();

  /**
   * Preview of what a stroke would take hold of, for a pen that is still down: runs the steps up to {Match}
   * on a mesh and a stroke of its own and writes the section (vtkOversketchMatch). The curves of mesh and
   * view are kept, also for the next Update; while they stand a call costs the match alone. False, and
   * `section` empty, where there is nothing to take hold of, silently; a stroke of one sample makes the
   * curves. The output, the inputs and Drag stay as they are; inner outputs up to {Match} are those of the
   * preview.
   */
  bool MatchSection(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* section);

  /**
   * Preview of the output for the stroke moved so that all targets move by one vector [world]: writes places
   * into `points`, which are a copy of the last output's points (same number, float or double). Where the
   * output was not remeshed it is that of vtkOversketchLaplacianDeform::Drag, else the remeshed points follow
   * the triangles of the deformation that they lie on. Neither the output nor the pipeline changes: to keep
   * the place, move the stroke and Update. False, with an error, after a run that failed or when `points` do
   * not fit.
   */
  bool Drag(const double translation[3], vtkPoints* points);

  /**
   * The triangles of the region that the last run moved, where they are now, as a mesh of its own without
   * arrays. Empty after a run that failed.
   */
  void GetRegion(vtkPolyData* region);

  /**
   * True when the last output was remeshed.
   */
  vtkGetMacro(Remeshed, bool);

  ///@{
  /**
   * The output of an inner step after the last run, by the names above; null when there is no such step.
   * Empty for steps that did not run (Outline as published, Stretch and Restore without remeshing). Deform is
   * the deformation that the output was made of. Not to be changed.
   */
  int GetNumberOfInnerOutputs() const;
  const char* GetInnerOutputName(int index) const;
  vtkPolyData* GetInnerOutput(const char* name);
  ///@}

  /**
   * An inner step itself, to set parameters that the system does not repeat or to read its counters; null for
   * an unknown name. {Deform} is the step that deforms the mesh as it came, {DeformRemeshed} the one between
   * the remeshers, {DeformCorrected} and {DeformRemeshedCorrected} those with the handles of {Correction} and
   * {CorrectionRemeshed}.
   */
  vtkAlgorithm* GetStep(const char* name);

  /**
   * The step, for GetStep, whose deformation the last output was made of: Deform, DeformCorrected,
   * DeformRemeshed or DeformRemeshedCorrected.
   */
  const char* GetDeformationName() const;

  /**
   * Seconds that a step took in the last run, 0 where it did not execute.
   */
  double GetStageTime(const char* name) const;

  /**
   * Name of the running step, for progress displays; empty outside a run.
   */
  const char* GetStageName() const;

  /**
   * Includes the inner steps: a parameter set through GetStep makes the system run again.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkOversketchOneStroke();
  ~vtkOversketchOneStroke() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkOversketchOneStroke(const vtkOversketchOneStroke&) = delete;
  void operator=(const vtkOversketchOneStroke&) = delete;

  int Backend = Auto;
  int Remesh = RemeshAuto;
  bool CorrectOutline = true;
  bool AsPublished = false;
  bool Remeshed = false;

  struct Pipeline;
  std::unique_ptr<Pipeline> Inner;
};

#endif
