/**
 * @class vtkOversketchResketch
 * @brief a curve drawn over a part of another one replaces that part
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 4.2:
 * Kernels/Stroke/resketch.h says how, and what is departed from; of closed curves, which the thesis does not
 * speak of, Kernels/Stroke/correct.h does. It works on any curve in a plane, a profile as well. Curves on a
 * mesh are blended in the picture; what comes of them is projected and laid into the mesh again, but for
 * points that have kept their vertices.
 *
 * Input 0 (Curve): the curve f, one polyline in the plane of the stroke; z is ignored. With point array
 * VertexId (1 component, the mesh's vertex that each point is, or -1) it is a curve on a mesh, in world
 * space, and seen in the view that the stroke carries. A closed one repeats its first point id at the end.
 * Input 1 (Stroke): the new curve m, one polyline, filtered, fitted and evenly sampled, in display
 * coordinates [px] or in the curve's plane; with the view it was drawn in where the curve is on a mesh.
 * Transitions are sampled as finely as the finer of both curves is on average.
 *
 * Output 0 (Curve): the result r, one polyline, z = 0, double, in the direction of f; closed if f is. It has
 * - point array CurveT, double: share of its length, 0 to 1, that of a closed one below 1,
 * - point array SourceT, double: share of the length of f at which each point takes the place of f's,
 * - point array VertexId, vtkIdType, if f has it: of points of f that stay, else -1,
 * - other floating arrays of one component that both inputs have on their points (Pressure, Time), blended,
 * - the stroke's cell arrays, those of f that the stroke does not have, and the field arrays of f.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke when an input is not one polyline of at
 * least two finite samples, of which two differ; when a curve on a mesh is not wholly in front of the eye;
 * MissingArray for a VertexId of another shape, and then for an absent view. An input without points gives an
 * empty output silently. A stroke both ends of which are nearest to the same inner place of f, and so says
 * nothing, gives f and a warning.
 *
 * Deterministic; a stroke drawn the other way round gives the same. Cost: the samples of m times the square
 * root of those of f. The result stays, as the same arrays, while inputs and parameters do.
 *
 * @sa vtkOversketchRedraw vtkOversketchResample
 */
#ifndef vtkOversketchResketch_h
#define vtkOversketchResketch_h

#include "OversketchFiltersStrokeModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTROKE_EXPORT vtkOversketchResketch : public vtkOversketchFilter
{
public:
  static vtkOversketchResketch* New();
  vtkTypeMacro(vtkOversketchResketch, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MiddleType
  {
    ArcLength = 0,
    Closest = 1
  };

  /**
   * The new curve, on port 1.
   */
  void SetStrokeConnection(vtkAlgorithmOutput* stroke) { this->SetInputConnection(1, stroke); }
  void SetStrokeData(vtkPolyData* stroke) { this->SetInputData(1, stroke); }

  ///@{
  /**
   * How far beside an end of the stroke the curve is left, in distances of that end from the curve;
   * dimensionless, at least 0. Default 6; the thesis found 3 worse.
   */
  vtkSetClampMacro(K, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(K, double);
  ///@}

  ///@{
  /**
   * Replacement of the part between the transitions: the stroke's own samples (ArcLength), or, as published,
   * of each sample of the curve the nearest place of the stroke (Closest), which loses bulges. Default
   * ArcLength.
   */
  vtkSetClampMacro(Middle, int, ArcLength, Closest);
  vtkGetMacro(Middle, int);
  void SetMiddleToArcLength() { this->SetMiddle(ArcLength); }
  void SetMiddleToClosest() { this->SetMiddle(Closest); }
  ///@}

  ///@{
  /**
   * Blend with tangents as long as the curves' steps are, as published, not as the transition is. Default
   * off.
   */
  vtkSetMacro(RawTangents, bool);
  vtkGetMacro(RawTangents, bool);
  vtkBooleanMacro(RawTangents, bool);
  ///@}

  /**
   * How many times a curve has been re-sketched: executions that the kept result did not answer.
   */
  vtkGetMacro(ResketchCount, vtkIdType);

protected:
  vtkOversketchResketch() { this->SetNumberOfInputPorts(2); }
  ~vtkOversketchResketch() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double K = 6.0;
  int Middle = ArcLength;
  bool RawTangents = false;
  vtkIdType ResketchCount = 0;
};

#endif
