/**
 * @class vtkOversketchMirror
 * @brief does on the other side of a plane what a deformation did on one
 *
 * For symmetric models: a stroke on one limb moves the other one exactly alike. Not in the paper; what
 * modelling programs call symmetry. Of models without partners, sessions run the stroke a second time, in the
 * mirror (Applications/Session, SystemRunner::run).
 *
 * Input 0 (Mesh before): mesh before, vtkPolyData, symmetric about the plane wherever the deformation
 * moved it on the chosen side: every such point has a partner where the plane reflects it to, within
 * Tolerance. Point array Mask, where it has one (vtkOversketchMask): points with 1 do not follow their
 * partner.
 * Input 1 (Deformed mesh): the same mesh after a deformation: same number of points, same cells.
 *
 * Output 0: input 1 with new points: on the chosen side they are those of input 1. Points in the plane stay
 * in it (their coordinate along the axis is that of input 0). On the other side a point whose partner moved
 * is its partner's reflection, any other is where it was in input 0, bit for bit. Active point normals are
 * reflected alike. Reflection is exact for an Offset of 0: x becomes -x.
 *
 * Points of the chosen side that the deformation moved beyond the plane are not held back.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, when the inputs' numbers of points differ,
 * or a moved point has no partner (the message names it); MissingArray for a Mask that is not one finite
 * number a point. Empty inputs give an empty output silently.
 *
 * Deterministic. Cost: n log n for the search of partners, of moved points alone.
 *
 * @sa vtkOversketchOneStroke, with RemeshOff
 */
#ifndef vtkOversketchMirror_h
#define vtkOversketchMirror_h

#include "OversketchFiltersDeformModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class OVERSKETCHFILTERSDEFORM_EXPORT vtkOversketchMirror : public vtkPolyDataAlgorithm
{
public:
  static vtkOversketchMirror* New();
  vtkTypeMacro(vtkOversketchMirror, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The deformed mesh, on port 1.
   */
  void SetDeformedConnection(vtkAlgorithmOutput* deformed) { this->SetInputConnection(1, deformed); }

  ///@{
  /**
   * The plane is where the coordinate of this axis (0, 1, 2: x, y, z) is Offset [default x].
   */
  vtkSetClampMacro(Axis, int, 0, 2);
  vtkGetMacro(Axis, int);
  ///@}

  ///@{
  /**
   * See Axis [model length, default 0].
   */
  vtkSetMacro(Offset, double);
  vtkGetMacro(Offset, double);
  ///@}

  enum SideType
  {
    Below = 0,
    Above = 1
  };
  ///@{
  /**
   * The side that the other one follows: of smaller (Below) or larger (Above, default) coordinates.
   */
  vtkSetClampMacro(Side, int, Below, Above);
  vtkGetMacro(Side, int);
  void SetSideToBelow() { this->SetSide(Below); }
  void SetSideToAbove() { this->SetSide(Above); }
  ///@}

  ///@{
  /**
   * Partners may be this far from the exact place, and points this far from the plane lie in it [fraction of
   * the diagonal of the mesh's bounding box, 0 to 0.1, default 1e-6].
   */
  vtkSetClampMacro(Tolerance, double, 0.0, 0.1);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkOversketchMirror() { this->SetNumberOfInputPorts(2); }
  ~vtkOversketchMirror() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  int Axis = 0;
  double Offset = 0.0;
  int Side = Above;
  double Tolerance = 1e-6;
};

#endif
