/**
 * @class vtkOversketchAugment
 * @brief strokes over a mesh make it finer there and raise it: system D as one filter
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators". Each step is a filter of its own
 * (see GetInnerOutput): strokes {Thinning, Chaikin}, 4-8 mesh {Base}, curves on it {Curves}, or in silhouette
 * mode {Silhouette, Visibility, Sketch}; finer triangles near curves {Refine}, and of a Simplified base or a
 * terrain, whose new points lie where mesh or image is, both again {CurvesOnSource, RefineOnSource}; edges
 * onto them {Snap}, even triangles {Smooth}, the feature {Displace}, what is not needed taken away
 * {Simplify}, which the paper schedules without a rule. Departures are those of each step, and {Even}: where
 * lines run over long thin triangles, whose shape bisection would keep, the mesh has even ones there first.
 * AsPublished turns all off.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData; a manifold with one orientation, with borders or without. One
 * that is a 4-8 mesh, as an output of this is, goes on from where it is. Points that a reader split for
 * texture coordinates or normals are welded for computing (exactly equal positions) and split again in the
 * output. The mesh's normals are not read. Point array Mask (vtkOversketchMask): points with 1 are neither
 * snapped, smoothed nor raised, nor new ones between two of them; others rise by 1 - Mask of the height.
 * Input 1 (Strokes): polylines in display coordinates with cell arrays ViewTransform, ProjectionTransform,
 * ViewportSize; any number, each with its own view. Cell arrays Radius, Height [model length] and Sharpness
 * go before the parameters, point array Pressure is read with UsePressure.
 *
 * Output 0: the mesh with its features, points in double, and the arrays of a 4-8 mesh
 * (Filters/Stellar/README.md), so that the next stroke can go on. Other arrays as vtkOversketchStellarBase
 * has them; along texture seams once per side, and points that repeat a place then come after all others, so
 * that welding gives the 4-8 mesh with its numbers. A seam's points move along it only. Points that were
 * there and are masked, or that no feature reaches, are bit-identical; {Even} gives all new numbers.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): one message, that of the step that failed;
 * BadStroke without a stroke; BadMesh for masked points over a Simplified base. An empty mesh gives an empty
 * output silently. After AbortExecute: Modified(). One warning says what is not as drawn: triangles that pass
 * through others or turned over, a low crest, a feature held back, lines that the mesh does not follow.
 *
 * Demand-driven: another height, sharpness (on the same side of 1 and 2) or profile runs {Displace} and on, a
 * radius {Curves} and {Refine} too, a stroke no {Base}, a changed attribute array no step. Deterministic.
 *
 * @sa vtkOversketchStellarBase vtkOversketchSurfaceStroke vtkOversketchOneStroke
 */
#ifndef vtkOversketchAugment_h
#define vtkOversketchAugment_h

#include "OversketchFiltersAugmentModule.h" // For export macro
#include "vtkOversketchSystem.h"

#include <memory>
#include <string>

class OVERSKETCHFILTERSAUGMENT_EXPORT vtkOversketchAugment : public vtkOversketchSystem
{
public:
  static vtkOversketchAugment* New();
  vtkTypeMacro(vtkOversketchAugment, vtkOversketchSystem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetStrokesConnection(vtkAlgorithmOutput* strokes) { this->SetInputConnection(1, strokes); }
  void SetStrokesData(vtkPolyData* strokes) { this->SetInputData(1, strokes); }
  int GetBackendUsed() override; // by the rays of {Visibility}, in silhouette mode

  enum BaseType
  {
    Direct = 0,
    Simplified = 1
  };
  ///@{
  /**
   * Mesh to refine: Direct (default), the mesh itself, or a coarser one (see {Base}) that follows it.
   */
  void SetBase(int base);
  vtkGetMacro(Base, int);
  void SetBaseToDirect() { this->SetBase(Direct); }
  void SetBaseToSimplified() { this->SetBase(Simplified); }
  ///@}

  enum SketchModeType
  {
    Surface = 0,
    Silhouette = 1
  };
  ///@{
  /**
   * Strokes lie on the Surface (default), or each is a stretch of the Silhouette drawn anew, without heights.
   */
  void SetSketchMode(int mode);
  vtkGetMacro(SketchMode, int);
  void SetSketchModeToSurface() { this->SetSketchMode(Surface); }
  void SetSketchModeToSilhouette() { this->SetSketchMode(Silhouette); }
  ///@}

  ///@{
  /**
   * How far from the stroke the feature ends [model length, default -1: 0.03 of the mesh's diagonal].
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Height of the feature under the stroke, below 0 inward [model length, default 0: half the radius].
   */
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Exponent s of the feature's profile (1 - distance / radius)^s, not negative [default 1.5].
   */
  vtkSetMacro(Sharpness, double);
  vtkGetMacro(Sharpness, double);
  ///@}

  /**
   * A polyline "x y, x y, ..." with x rising from 0 to 1 in the profile's place; empty (default): none.
   */
  void SetProfile(const char* text);
  const char* GetProfile() const { return this->Profile.c_str(); }

  ///@{
  /**
   * Multiply the height by the pen's Pressure [default off].
   */
  vtkSetMacro(UsePressure, bool);
  vtkGetMacro(UsePressure, bool);
  vtkBooleanMacro(UsePressure, bool);
  ///@}

  ///@{
  /**
   * How long either end of an open stroke runs out into a point [model length, default 0: ends are round].
   */
  vtkSetMacro(Taper, double);
  vtkGetMacro(Taper, double);
  ///@}

  enum CombineType
  {
    Nearest = 0,
    Sum = 1
  };
  ///@{
  /**
   * Where several strokes reach a vertex: the Nearest by share of its radius alone (default), or as published
   * the Sum, twice as high where two cross.
   */
  vtkSetClampMacro(Combine, int, Nearest, Sum);
  vtkGetMacro(Combine, int);
  void SetCombineToNearest() { this->SetCombine(Nearest); }
  void SetCombineToSum() { this->SetCombine(Sum); }
  ///@}

  enum DistanceType
  {
    Straight = 0,
    Geodesic = 1
  };
  ///@{
  /**
   * Distances through space (default, as published) or over the surface, which do not reach round thin parts.
   */
  vtkSetClampMacro(Distance, int, Straight, Geodesic);
  vtkGetMacro(Distance, int);
  void SetDistanceToStraight() { this->SetDistance(Straight); }
  void SetDistanceToGeodesic() { this->SetDistance(Geodesic); }
  ///@}

  ///@{
  /**
   * Longer edges near strokes are split [model length, default 0: radius / 4, / 8 with sharpness < 1 or > 2].
   */
  vtkSetClampMacro(TargetEdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TargetEdgeLength, double);
  ///@}

  ///@{
  /**
   * Each stroke is drawn on what the last one has made, but for those that neither cross nor come nearer than
   * a third of the radius; all rise along the normals of the mesh that came in, so that none leans over on
   * another one's flank. Off (default), all act at once. Inner outputs are then the last one's.
   */
  vtkSetMacro(OneByOne, bool);
  vtkGetMacro(OneByOne, bool);
  vtkBooleanMacro(OneByOne, bool);
  ///@}

  ///@{
  /**
   * Take away what of the refinement the mesh does not need, off the strokes [default on].
   */
  vtkSetMacro(Simplify, bool);
  vtkGetMacro(Simplify, bool);
  vtkBooleanMacro(Simplify, bool);
  ///@}

  ///@{
  /**
   * Turn every departure of every step off, so that strokes sum, or on (default); single ones by GetStep.
   */
  void SetAsPublished(bool published);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  /**
   * Figures of {Base}, base.pairs and base.unpaired; over all strokes met.crossings, met.residual,
   * met.refused_moves ({Smooth}'s too), met.faces_added of {Snap}, met.flipped_faces (by over 90 degrees),
   * met.self_intersecting_faces, met.crest_mean, met.crest_minimum of {Displace}, met.longest_curve_segment
   * [model length], met.smallest_angle of the output [degrees].
   */
  FigureList Figures() override;

  bool Prepare() override; // the 4-8 mesh and, in surface mode, what rays need
  bool Preview(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* hold) override; // curves
  void GetHold(vtkPolyData* hold) override;
  void GetRegion(vtkPolyData* region) override;
  /**
   * Shows what strokes would make, while the pen is down: three polylines a curve, cell arrays CurveId, Part
   * (0 crest or sketch, 1 and 2 feet). As Preview else; false without a stroke of two samples, after Prepare.
   */
  bool PreviewCrest(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* crest);

  /**
   * The last output with another height [model length, 0: half the radius] and sharpness, a preview: writes
   * places into `points`, a copy of its points. A stroke's own Height and Sharpness, and a profile, still go
   * before. False after a run that failed or was of several strokes one by one, where points do not fit (an
   * error), or numbers are out of range (the error code tells).
   */
  bool Reshape(double height, double sharpness, vtkPoints* points);

protected:
  vtkOversketchAugment();
  ~vtkOversketchAugment() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void BackendChanged() override;

private:
  int Base = Direct, SketchMode = Surface, Combine = Nearest, Distance = Straight;
  double Radius = -1.0, Height = 0.0, Sharpness = 1.5, Taper = 0.0, TargetEdgeLength = 0.0;
  bool UsePressure = false, OneByOne = false, Simplify = true, AsPublished = false;
  std::string Profile;

  struct Pipeline;
  std::unique_ptr<Pipeline> Inner;
};
#endif
