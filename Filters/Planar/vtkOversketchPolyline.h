/**
 * @class vtkOversketchPolyline
 * @brief the strokes of a drawing as polylines of few vertices, from which its coarse mesh is made
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.2.2, Fig. 7: corners by the change of direction,
 * then splits where the deviation is largest. Departures (Kernels/Planar/approximate.h): the tolerance is a
 * fourth of how thick the object is along the piece (DeltaMode Adaptive), since limbs thinner than the
 * published one, 0.05 of the canvas's longest side, turn over in refinement; there, a piece of an open
 * feature is no longer than the object is thick at its middle, since needles would join a long straight one
 * to the points beside it; one of a rim is halved where a feature's free end is very near to it for its
 * length, since the triangle between them folds when inflated; polylines that meet though their strokes do
 * not are made finer; open ends near the rim join it.
 *
 * Input 0 (Curves): curves of vtkOversketchClassify, resampled (vtkOversketchResample); cell array Treatment
 * (see vtkOversketchTreatment) may be absent: all filled.
 * Input 1 (Distance, vtkImageData, optional): that of vtkOversketchDistance, point array LocalMax. Not read
 * in mode Fixed.
 *
 * Input 2 (Splits, optional): parts of strokes to be approximated closer, from
 * vtkOversketchPlanarRefine.
 *
 * Output 0 (Polylines): one polyline per stroke, without rejected ones and those in holes; a closed one
 * repeats its first point id at the end. An end that joins another stroke lies on a vertex of that. It has
 * - point array ArcLength, double: along the stroke, from its first sample [world],
 * - cell arrays StrokeId, Closed, Role, RegionId, ChildRegionId, ObjectId, Treatment, int, as the curves',
 * - cell array StrokeLength, double: of the whole stroke [world],
 * - the field arrays of the curves.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray without Canvas, the arrays of
 * vtkOversketchClassify, or a distance image where one is needed; BadStroke for contradictions in them,
 * splits of strokes that there are not, and, naming both strokes, where strokes are so near each other that
 * their samples cannot be kept apart. Curves without points give an empty output silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: some milliseconds. The result stays
 * while curves, distance, splits and parameters do.
 *
 * @sa vtkOversketchDistance vtkOversketchDarts vtkOversketchCoarseMesh
 */
#ifndef vtkOversketchPolyline_h
#define vtkOversketchPolyline_h

#include "OversketchFiltersPlanarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSPLANAR_EXPORT vtkOversketchPolyline : public vtkOversketchFilter
{
public:
  static vtkOversketchPolyline* New();
  vtkTypeMacro(vtkOversketchPolyline, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Mode
  {
    ADAPTIVE = 0,
    FIXED = 1
  };

  /**
   * The distance image, on port 1.
   */
  void SetDistanceConnection(vtkAlgorithmOutput* distance) { this->SetInputConnection(1, distance); }
  void SetDistanceData(vtkDataObject* distance) { this->SetInputData(1, distance); }

  /**
   * Parts to be approximated closer, on port 2.
   */
  void SetSplitsConnection(vtkAlgorithmOutput* splits) { this->SetInputConnection(2, splits); }
  void SetSplitsData(vtkPolyData* splits) { this->SetInputData(2, splits); }

  ///@{
  /**
   * How far samples may be from their piece: Adaptive, a fourth of the object's least thickness along it, at
   * least 0.0025 of the canvas's longest side and at most Tolerance, and no longer than that thickness (at
   * least 0.04 of the longest side) on open features; Fixed, Tolerance, as published [default Adaptive].
   */
  vtkSetClampMacro(DeltaMode, int, ADAPTIVE, FIXED);
  vtkGetMacro(DeltaMode, int);
  void SetDeltaModeToAdaptive() { this->SetDeltaMode(ADAPTIVE); }
  void SetDeltaModeToFixed() { this->SetDeltaMode(FIXED); }
  ///@}

  ///@{
  /**
   * Share of the canvas's longest side [0.0001 to 1, default 0.05, as published].
   */
  vtkSetClampMacro(Tolerance, double, 0.0001, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Ends of open features so near the rim of their region join it: share of the canvas's longest side [0 to
   * 0.1, default 0.01; 0: ends stay where they were drawn].
   */
  vtkSetClampMacro(JoinDistance, double, 0.0, 0.1);
  vtkGetMacro(JoinDistance, double);
  ///@}

  ///@{
  /**
   * As the paper prints it: DeltaMode counts as Fixed. Default off.
   */
  vtkSetMacro(AsPublished, bool);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  /**
   * How many times strokes have been approximated: executions that the kept result did not answer.
   */
  vtkGetMacro(PolylineCount, vtkIdType);

protected:
  vtkOversketchPolyline();
  ~vtkOversketchPolyline() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int DeltaMode = ADAPTIVE;
  double Tolerance = 0.05;
  double JoinDistance = 0.01;
  bool AsPublished = false;
  vtkIdType PolylineCount = 0;
};

#endif
