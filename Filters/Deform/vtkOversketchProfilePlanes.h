/**
 * @class vtkOversketchProfilePlanes
 * @brief three planes through a place of a reference curve: the frame in which its profile is cut and drawn
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 6.1, Fig. 6.1: the
 * n-plane is fitted to the curve, the t-plane runs lengthwise along it, the b-plane crosses it and slides
 * along it. Departures, which Frame turns off: the fitted plane of a straight curve on a ball stands on the
 * surface, and an axis that is carried along an S leaves "outward" by 40 degrees; so outward is the surface's
 * normal, made smooth along the curve, and the planes that are drawn are those of the frame that is cut in.
 * The printed fit has no plane parallel to z, and the printed vectors mix components up; Kernels/Matrix/
 * frames.h has what is made of both.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData; its point normals say what is outward.
 * Input 1 (Reference): the reference curve, one polyline with point array VertexId, see
 * vtkOversketchInsertCurve.
 *
 * Output 0 (Planes): three squares, their half size the diagonal of the mesh's bounding box, with
 * - cell array Plane, int: 0 the n-plane, 1 the t-plane, 2 the b-plane,
 * - active cell normals Normals, double: outward, to the side, along the curve; mutually perpendicular,
 * - field array Frame, double[16]: from the frame's axes to world space, a matrix row by row: columns along,
 * side, outward, place,
 * - field arrays PlaneT, double: where the planes are; MeshVertices, vtkIdType[3], and MeshWeights,
 * double[3]: the vertices on which that place hangs.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke for a curve that is none, or turns back
 * on itself at the place, and a T that is not finite; BadMesh, MissingArray. A mesh without points gives an
 * empty output silently.
 *
 * Deterministic. Cost: that of the curve's points. The result stays, as the same arrays, while inputs and
 * parameters do.
 *
 * @sa vtkOversketchCrossSection
 */
#ifndef vtkOversketchProfilePlanes_h
#define vtkOversketchProfilePlanes_h

#include "OversketchFiltersDeformModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSDEFORM_EXPORT vtkOversketchProfilePlanes : public vtkOversketchFilter
{
public:
  static vtkOversketchProfilePlanes* New();
  vtkTypeMacro(vtkOversketchProfilePlanes, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The reference curve, on port 1.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(1, curve); }
  void SetReferenceData(vtkPolyData* curve) { this->SetInputData(1, curve); }

  ///@{
  /**
   * Where the planes are: share of the curve's length, 0 to 1. Default 0.5.
   */
  vtkSetClampMacro(T, double, 0.0, 1.0);
  vtkGetMacro(T, double);
  ///@}

  enum FrameType
  {
    Surface = 0,
    Fitted = 1
  };
  ///@{
  /**
   * Outward direction: the Surface's normal at the place (default), or as published the normal of the plane
   * that is Fitted to the curve, the same all along it.
   */
  vtkSetClampMacro(Frame, int, Surface, Fitted);
  vtkGetMacro(Frame, int);
  void SetFrameToSurface() { this->SetFrame(Surface); }
  void SetFrameToFitted() { this->SetFrame(Fitted); }
  ///@}

protected:
  vtkOversketchProfilePlanes() { this->SetNumberOfInputPorts(2); }
  ~vtkOversketchProfilePlanes() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double T = 0.5;
  int Frame = Surface;

  struct Cache;
};

#endif
