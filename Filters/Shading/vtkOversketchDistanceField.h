/**
 * @class vtkOversketchDistanceField
 * @brief how far a region's vertices are on the way from the reference curve to the boundary, beside which
 * place of the curve, and on which side
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.2: by each vertex's
 * distance to the closest point of the reference curve. Kernels/Shading/fields.h has the equations.
 * Departures, which AsPublished turns off: distances go over the surface, since straight ones cut through
 * thin parts (Measure); the share has creases, and the place along the curve leaps by as much as all of it,
 * so both are smoothed (FieldSmoothing, ParameterSmoothing).
 *
 * Input 0 (Mesh): as vtkOversketchFlatten takes it; the boundary is the border of the region.
 * Input 1 (Reference): one polyline with point array VertexId, a chain of the mesh's edges strictly inside.
 *
 * Output 0 (Mesh): the same with point arrays
 * - CurveDistance, double: 0 on the reference curve, 1 on the boundary and outside,
 * - CurveParameter, double: share of the reference curve's length, 0 to 1; 0 outside,
 * - CurveSide, int: 1 left of the curve as it goes, seen from outside, -1 right, 0 on it and outside.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): as vtkOversketchFlatten, and BadStroke for a
 * reference curve of fewer than two vertices, one that is not a chain of edges, or touches the boundary. A
 * mesh without points gives an empty output silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: two fronts over the region and two
 * solves of a sparse system; the arrays stay while points, triangles, EditRegion, the curve and the
 * parameters do.
 *
 * @sa vtkOversketchFlatten vtkOversketchShadingLevels
 */
#ifndef vtkOversketchDistanceField_h
#define vtkOversketchDistanceField_h

#include "OversketchFiltersShadingModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSHADING_EXPORT vtkOversketchDistanceField : public vtkOversketchFilter
{
public:
  static vtkOversketchDistanceField* New();
  vtkTypeMacro(vtkOversketchDistanceField, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The reference curve, on port 1.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(1, curve); }
  void SetReferenceData(vtkPolyData* curve) { this->SetInputData(1, curve); }

  enum MeasureType
  {
    SURFACE = 0,
    EUCLIDEAN = 1
  };
  ///@{
  /**
   * How distances go: Surface (default), over the surface; Euclidean, as published, through space.
   */
  vtkSetClampMacro(Measure, int, SURFACE, EUCLIDEAN);
  vtkGetMacro(Measure, int);
  void SetMeasureToSurface() { this->SetMeasure(SURFACE); }
  void SetMeasureToEuclidean() { this->SetMeasure(EUCLIDEAN); }
  ///@}

  ///@{
  /**
   * How far the distance is smoothed, as a share of the way from curve to boundary [0 to 10, default 0.15; as
   * published: 0, not at all].
   */
  vtkSetMacro(FieldSmoothing, double);
  vtkGetMacro(FieldSmoothing, double);
  ///@}

  ///@{
  /**
   * How far the parameter is [0 to 10, default 0.3; as published: 0].
   */
  vtkSetMacro(ParameterSmoothing, double);
  vtkGetMacro(ParameterSmoothing, double);
  ///@}

  ///@{
  /**
   * Measure as printed: through space, without smoothing, whatever the parameters say [default off].
   */
  vtkSetMacro(AsPublished, bool);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  /**
   * How many times the fields have been computed: executions that the kept ones did not answer.
   */
  vtkGetMacro(FieldCount, vtkIdType);

protected:
  vtkOversketchDistanceField() { this->SetNumberOfInputPorts(2); }
  ~vtkOversketchDistanceField() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Measure = SURFACE;
  double FieldSmoothing = 0.15;
  double ParameterSmoothing = 0.3;
  bool AsPublished = false;
  vtkIdType FieldCount = 0;
};

#endif
