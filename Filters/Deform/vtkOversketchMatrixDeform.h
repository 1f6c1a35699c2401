/**
 * @class vtkOversketchMatrixDeform
 * @brief a region follows the transformations of handles along its reference curve, each point by its weight
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", chapters 7 and 8, equations
 * 8.1 to 8.3, after M. Alexa, "Linear Combination of Transformations": a share s of a transformation A is
 * exp(s log A), of two at once exp(log A + log B). The thesis has one matrix and one grey level; here point v
 * goes to exp(w sum of f_i log A_i) v, w being its EditWeight and f_i falling from 1 at handle i's place
 * along the curve to 0 at its neighbours', and staying 1 where it has none; handles at one place act at once.
 * Kernels/Matrix/moved.h says how.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData, with point arrays of one component
 * - EditRegion: 2 where a point may move (vtkOversketchEnclose),
 * - EditWeight: 0 to 1, how far it follows,
 * - CurveParameter: 0 to 1, its place along the reference curve; both are read where EditRegion is 2.
 * Input 1 (Handles): points with point arrays CurveT and Matrix (16 numbers row by row, in world space), see
 * vtkOversketchHandles. None at all, and the mesh goes through.
 *
 * Output 0 (Mesh): the mesh with moved points, double where the input's are double, else float. Points
 * outside the region, those of weight 0 and those to which handles do nothing are bit for bit those of the
 * input. Active point and cell normals are computed anew where a triangle changed; all other arrays and the
 * cells are passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): SolveFailed naming the handle whose matrix has no
 * logarithm (a reflection, half a turn, a singular one), or the point where sums are too large; BadStroke for
 * a handle off the curve and a matrix that is not finite or a perspective; BadRegion without a point that may
 * move, or naming a point whose value is out of range; BadMesh, MissingArray. A mesh without points gives an
 * empty output silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: one logarithm for each handle and
 * one exponential for each point that follows; what depends on mesh and region alone is kept between runs, so
 * that a drag of 50,000 points costs some 10 ms of processor time.
 *
 * @sa vtkOversketchHandles vtkOversketchProfileDeform
 */
#ifndef vtkOversketchMatrixDeform_h
#define vtkOversketchMatrixDeform_h

#include "OversketchFiltersDeformModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSDEFORM_EXPORT vtkOversketchMatrixDeform : public vtkOversketchFilter
{
public:
  static vtkOversketchMatrixDeform* New();
  vtkTypeMacro(vtkOversketchMatrixDeform, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The handles, on port 1.
   */
  void SetHandlesConnection(vtkAlgorithmOutput* handles) { this->SetInputConnection(1, handles); }
  void SetHandlesData(vtkPolyData* handles) { this->SetInputData(1, handles); }

  ///@{
  /**
   * Counts of the last deformation: points that are not where they were; edges whose triangles' normals are
   * over 120 degrees apart and were not before.
   */
  vtkGetMacro(MovedPoints, int);
  vtkGetMacro(FoldedEdges, int);
  ///@}

  /**
   * How many times a mesh has been deformed: executions that the kept result did not answer.
   */
  vtkGetMacro(DeformCount, vtkIdType);

protected:
  vtkOversketchMatrixDeform() { this->SetNumberOfInputPorts(2); }
  ~vtkOversketchMatrixDeform() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int MovedPoints = 0;
  int FoldedEdges = 0;
  vtkIdType DeformCount = 0;

  struct Cache;
};

#endif
