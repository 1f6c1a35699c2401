/**
 * @class vtkOversketchHandles
 * @brief handles along a reference curve, and the transformations that were made with them
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", chapter 7: a handle is three
 * axes at a place of the curve; dragged along an axis it moves, scales or turns, and the change of its pose
 * is a matrix. Departures: the thesis prints T(-c) ... T(c) with T(c) moving to the origin; here the handle's
 * own place stays where it is turned and scaled. Each operation is one matrix, so that it has a logarithm.
 * The text is ours. Kernels/Matrix/operations.h says more.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData; its point normals say what is outward.
 * Input 1 (Reference): the reference curve, one polyline with point array VertexId, see
 * vtkOversketchInsertCurve; to be dragged it has the cell arrays of the view that it was drawn in.
 * Input 2 (Handles, optional): further handles, points with point arrays CurveT, the place, and Matrix, 16
 * numbers row by row: the transformation in the handle's own axes, x along the curve, y beside it, z outward,
 * from its place. Where the points lie is not read.
 *
 * Output 0 (Handles): one vertex for each operation but drags, in their order, then for each point of input
 * 2, at their places; with a drag then one more at each place that has one, at the middle where none has, of
 * what moves the curve as a whole. Point arrays
 * - CurveT, double: share of the curve's length, 0 to 1,
 * - Matrix, double[16]: the transformation in world space, row by row,
 * - Frame, double[16]: from the handle's axes to world space: columns along, side, outward, place.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke naming the operation by number and text,
 * or the handle, and the remedy: for what cannot be read, a place outside 0 and 1, a factor that is not above
 * 0, 180 degrees and more, a matrix that is not finite or a perspective; BadStroke for a curve that is none;
 * BadMesh, MissingArray. A mesh without points gives an empty output silently.
 *
 * Deterministic. Cost: that of the curve's points. The result stays, as the same arrays, while inputs and
 * parameters do.
 *
 * @sa vtkOversketchMatrixDeform
 */
#ifndef vtkOversketchHandles_h
#define vtkOversketchHandles_h

#include "OversketchFiltersDeformModule.h" // For export macro
#include "vtkOversketchFilter.h"

#include <string>

class OVERSKETCHFILTERSDEFORM_EXPORT vtkOversketchHandles : public vtkOversketchFilter
{
public:
  static vtkOversketchHandles* New();
  vtkTypeMacro(vtkOversketchHandles, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The reference curve, on port 1.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(1, curve); }
  void SetReferenceData(vtkPolyData* curve) { this->SetInputData(1, curve); }

  /**
   * Further handles, on port 2.
   */
  void SetHandlesConnection(vtkAlgorithmOutput* handles) { this->SetInputConnection(2, handles); }
  void SetHandlesData(vtkPolyData* handles) { this->SetInputData(2, handles); }

  ///@{
  /**
   * Operations, apart by semicolons: "move 0.5 n 0.1; rotate 0.7 t 30; scale 0.3 w 1.5; pin 0.2": at a
   * share of the curve's length, along or about an axis (t along the curve, w beside it, n outward), by a
   * length, degrees or a factor. A pin does nothing and so ends what its neighbours do. Several at one place
   * act at once. "drag 12 -5" moves the curve as a whole, so many pixels to the right and up in its view, as
   * far from the eye as its middle is; pins do not hold it. Empty (default): nothing.
   */
  void SetOperations(const char* text);
  const char* GetOperations() const { return this->Operations.c_str(); }
  ///@}

protected:
  vtkOversketchHandles();
  ~vtkOversketchHandles() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  std::string Operations;
};

#endif
