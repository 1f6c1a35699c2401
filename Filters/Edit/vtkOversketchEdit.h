/**
 * @class vtkOversketchEdit
 * @brief a line on a mesh and a ring round it: what lies between follows the line; system B as one filter
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing". Each step is a filter of its
 * own (see GetInnerOutput): the mean edge of the mesh {MeanEdge}, triangles as small as line and ring ask for
 * {ReferencePlace, BoundaryPlace, Refine}, the line {ReferenceFit, ReferenceProject, ReferenceInsert}, the
 * ring {BoundaryFit, BoundaryProject, BoundaryInsert}, of which counts what is on the line's limb, the region
 * {Enclose}, flat {Flatten}, where on the way from line to ring its vertices are {Distance}, how far they
 * follow, by grey layers {Areas, Shading} or an image {Texture}, what is done to the line {Handles, Deform},
 * or a cross-section drawn anew {Planes, Section, Redraw, Bend}, and new triangles {Retriangulate}, by what
 * the edit does between vertices too. Departures are those of each step; AsPublished turns all off, but that
 * curves are edges of the mesh, without which there is no region.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData. Points that a reader split for texture coordinates or normals
 * are welded for computing (exactly equal positions) and split again in the output. Field array MeanEdge, the
 * mean edge when it was loaded, is read where it is there. Point array Mask, where it has one
 * (vtkOversketchMask): points with 1 do not move, and triangles at them are only split, where line and ring
 * go through; with less EditWeight is that times 1 - Mask, of a profile with UseTexture.
 * Input 1 (Reference): the line: polylines in display coordinates with cell arrays ViewTransform,
 * ProjectionTransform, ViewportSize, each of a view of its own: the first one draws, each further one redraws
 * a part of what those before have made, in the picture (vtkOversketchResketch), as it is seen in its view;
 * what it leaves keeps its vertices {Refit, Resketch, Reproject, Reinsert}. Or the one curve that an earlier
 * edit has put out on port 1, which is laid on the mesh anew, each point at the nearest place.
 * Input 2 (Boundary): the ring round it, alike; it is closed wherever the first polyline ends.
 * Input 3 (Profile, optional): the cross-section at ProfileAt drawn anew, wholly or in part: polylines in its
 * plane (vtkOversketchCrossSection), or in display coordinates with a view onto that plane; each redraws what
 * those before have made of the section, and begins and ends within 0.75 of its width. No points: none.
 * Input 4 (Areas, optional): areas of the disc with layers of their own, see vtkOversketchScanFill.
 * Input 5 (Weights, vtkImageData, optional): an image on the disc, see vtkOversketchTextureToWeight; it takes
 * the place of layers and areas.
 * Input 6 (Handles, optional): further handles, see vtkOversketchHandles; of a profile, how far it reaches.
 *
 * Output 0 (Mesh): the mesh with the edit. Point arrays are mixed where a point is new, on each side of a
 * seam by itself, cell arrays those of the triangle that was there; field array MeanEdge is added, the arrays
 * of a 4-8 mesh are dropped. Points farther from the region than its ring of triangles and two mean edges are
 * bit-identical. An edit that moves nothing puts out its input, as the same arrays.
 * Output 1 (Reference): the line in the mesh, with point arrays VertexId, a vertex of output 0, or -1 where
 * the input is put out, and CurveT, and the stroke's cell arrays; its points lie where the edit left them.
 * Output 2 (Boundary): the ring, alike.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): one message, that of the step that failed;
 * BadStroke without line or ring, for operations with a profile, a profile that crosses itself, is closed or
 * comes out at the back, one or areas drawn in the line's or ring's view; BadRegion where all that the ring
 * encloses is masked; Torn where two vertices
 * are brought to one place. An empty mesh: empty outputs, silently. After AbortExecute: Modified().
 *
 * Demand-driven: an operation runs {Handles} and on, a layer {Shading} and on, a profile {Redraw} and on,
 * its place {Planes} and on: no region is grown, no field solved. Deterministic.
 *
 * @sa vtkOversketchInsertCurve vtkOversketchEnclose vtkOversketchShadingLevels vtkOversketchMatrixDeform
 */
#ifndef vtkOversketchEdit_h
#define vtkOversketchEdit_h

#include "OversketchFiltersEditModule.h" // For export macro
#include "vtkOversketchSystem.h"

#include <memory>
#include <string>

class OVERSKETCHFILTERSEDIT_EXPORT vtkOversketchEdit : public vtkOversketchSystem
{
public:
  static vtkOversketchEdit* New();
  vtkTypeMacro(vtkOversketchEdit, vtkOversketchSystem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  // The curves on ports 1 and 2, what may be absent on ports 3 to 6, and where the curves come out.
  void SetReferenceConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(1, curve); }
  void SetReferenceData(vtkPolyData* curve) { this->SetInputData(1, curve); }
  void SetBoundaryConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(2, curve); }
  void SetBoundaryData(vtkPolyData* curve) { this->SetInputData(2, curve); }
  void SetProfileConnection(vtkAlgorithmOutput* profile) { this->SetInputConnection(3, profile); }
  void SetProfileData(vtkPolyData* profile) { this->SetInputData(3, profile); }
  void SetAreasConnection(vtkAlgorithmOutput* areas) { this->SetInputConnection(4, areas); }
  void SetAreasData(vtkPolyData* areas) { this->SetInputData(4, areas); }
  void SetWeightsConnection(vtkAlgorithmOutput* image) { this->SetInputConnection(5, image); }
  void SetWeightsData(vtkDataObject* image) { this->SetInputData(5, image); }
  void SetHandlesConnection(vtkAlgorithmOutput* handles) { this->SetInputConnection(6, handles); }
  void SetHandlesData(vtkPolyData* handles) { this->SetInputData(6, handles); }
  vtkPolyData* GetReferenceOutput() { return this->GetOutput(1); }
  vtkPolyData* GetBoundaryOutput() { return this->GetOutput(2); }
  ///@}

  ///@{
  /**
   * Operations on the line, such as "move 0.5 n 0.1; rotate 0.7 t 30; pin 0.2; drag 12 -5", see
   * vtkOversketchHandles; all at once, in no order. A drag is in pixels of the view that the line was first
   * drawn in. Empty (default): nothing.
   */
  void SetOperations(const char* text);
  const char* GetOperations() const { return this->Operations.c_str(); }
  ///@}

  ///@{
  /**
   * How many grey levels there are [2 to 256, default 5]; weights do not depend on it.
   */
  vtkSetClampMacro(Levels, int, 2, 256);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * Handles on layers and layers of areas, such as "handle 0.4 0.2; area 0 9", see
   * vtkOversketchShadingLevels. Empty (default): none.
   */
  void SetLayers(const char* text);
  const char* GetLayers() const { return this->Layers.c_str(); }
  ///@}

  ///@{
  /**
   * Where the profile is: share of the line's length [0 to 1, default 0.5].
   */
  vtkSetClampMacro(ProfileAt, double, 0.0, 1.0);
  vtkGetMacro(ProfileAt, double);
  ///@}

  enum FalloffType
  {
    Smooth = 0,
    Linear = 1
  };
  ///@{
  /**
   * How weights fall from line to ring: Smooth (default), without a crease at either or a
   * point at the line's ends, or as published Linear.
   */
  vtkSetClampMacro(Falloff, int, Smooth, Linear);
  vtkGetMacro(Falloff, int);
  void SetFalloffToSmooth() { this->SetFalloff(Smooth); }
  void SetFalloffToLinear() { this->SetFalloff(Linear); }
  ///@}

  ///@{
  /**
   * Multiply what a profile does by the weights, as published, so that nothing off the line matches it
   * [default off].
   */
  vtkSetMacro(UseTexture, bool);
  vtkGetMacro(UseTexture, bool);
  vtkBooleanMacro(UseTexture, bool);
  ///@}

  ///@{
  /**
   * How far inside its border an area's weights blend with those round it, as a share of the disc's radius [0
   * to 1, default 0.05].
   */
  vtkSetMacro(Feather, double);
  vtkGetMacro(Feather, double);
  ///@}

  enum RuleType
  {
    Edit = 0,
    Curvature = 1,
    Off = 2
  };
  ///@{
  /**
   * New triangles by what the edit does (Edit, default), or as published by curvature; Off: none but those
   * that the curves made.
   */
  vtkSetClampMacro(Rule, int, Edit, Off);
  vtkGetMacro(Rule, int);
  void SetRuleToEdit() { this->SetRule(Edit); }
  void SetRuleToCurvature() { this->SetRule(Curvature); }
  void SetRuleToOff() { this->SetRule(Off); }
  ///@}

  ///@{
  /**
   * Turn every departure of every step off (true) or on (false, default): sets the properties of the inner
   * steps at once, so single ones can be changed afterwards by GetStep. While true, weights fall linearly,
   * areas do not blend and Rule Edit is Curvature.
   */
  void SetAsPublished(bool published);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  /**
   * Vertices that the edit moved, before new triangles were made; 0 after a run that failed.
   */
  int GetMovedPoints();

  /**
   * Moved points as edit.moved_points; edit.folded_edges of what comes out, by over 120 degrees, and
   * edit.crossings, pairs of its triangles that pass through each other, both less those that were;
   * edit.bridges, gaps that curves were led over; edit.share_seen, what part of the ring lies where it was
   * drawn, 1 of one that an earlier edit made or that was redrawn. GetRemark is of these, but points and
   * gaps, and of a profile that comes out at the back.
   */
  FigureList Figures() override;

  /**
   * All that comes before the deformation, for the inputs that there are: of a mesh alone little, of mesh and
   * line the line in it, with a ring the region, its disc, where its vertices are, and weights.
   */
  bool Prepare() override;

  ///@{
  /**
   * Output with Rule Off, to the bit, for the inputs and parameters by now, without a run: to be
   * shown while something is dragged. The mesh in `edited` always has active point normals. What one call has
   * written into `edited` the next one writes over, as the same cells and arrays: places and normals of the
   * region alone are new. DragLine adds "drag RIGHT UP" to the operations [px of the line's view], which stay
   * as they are; to keep it, add it to them. Both do what Prepare does where that is not done, and leave
   * output and inputs as they are. False, and `edited` as it was, without mesh, line or ring and where an
   * edit cannot be made; the error code tells why.
   */
  bool PreviewEdit(vtkPolyData* edited);
  bool DragLine(double right, double up, vtkPolyData* edited);
  ///@}

  // The line of the last run, where it was before the edit.
  void GetHold(vtkPolyData* hold) override;
  void GetRegion(vtkPolyData* region) override;

protected:
  vtkOversketchEdit();
  ~vtkOversketchEdit() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkOversketchEdit(const vtkOversketchEdit&) = delete;
  void operator=(const vtkOversketchEdit&) = delete;

  std::string Operations;
  int Levels = 5;
  std::string Layers;
  double ProfileAt = 0.5;
  int Falloff = Smooth;
  bool UseTexture = false;
  double Feather = 0.05;
  int Rule = Edit;
  bool AsPublished = false;

  struct Pipeline;
  std::unique_ptr<Pipeline> Inner;
};

#endif
