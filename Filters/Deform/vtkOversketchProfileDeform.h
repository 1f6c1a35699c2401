/**
 * @class vtkOversketchProfileDeform
 * @brief a region follows its profile that was drawn anew
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 6.3: the mesh is
 * deformed to match the new profile; how is left to chapter 8, which does not say. Here each place of the old
 * profile has a partner on the new one (SourceT); a point moves by the displacement of the place that is as
 * far on the way from the reference curve to the boundary, on its side of the curve, carried from frame to
 * frame along the curve; round the curve's ends both sides are mixed. Departures: by the chapter's rule the
 * grey level would multiply it, and the mesh would match off the curve nowhere (UseTexture). Without handles
 * all of the region follows, as the thesis has it; with handles what lies between the plane and its
 * neighbours among them, evenly less towards those. Kernels/Section/profile.h and follow.h say more.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData, with point arrays of one component EditRegion, 2 where a point
 * may move (vtkOversketchEnclose), CurveDistance, CurveParameter and CurveSide (vtkOversketchDistanceField),
 * with UseTexture also EditWeight; the others are read where EditRegion is 2.
 * Input 1 (Reference): the reference curve, one polyline with point array VertexId, see
 * vtkOversketchInsertCurve.
 * Input 2 (Profile): the old profile, output 0 of vtkOversketchCrossSection of this mesh.
 * Input 3 (Drawn): the new one, in the old one's plane, one polyline with point array SourceT (1 component):
 * the CurveT of the old one that each point takes the place of, not falling; see vtkOversketchResketch. Its
 * ends are drawn to the old one's over a tenth of the length.
 * Input 4 (Handles, optional): points with point array CurveT, see vtkOversketchHandles.
 *
 * Output 0 (Mesh): the mesh with moved points, double where the input's are double, else float. Points
 * outside the region, and those beside places where both profiles are one, are bit for bit those of the
 * input. Active point and cell normals are computed anew where a triangle changed; all other arrays and the
 * cells are passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke for curves and profiles that are none,
 * naming the point of a profile that is not finite or comes from nowhere; BadRegion without a point that may
 * move, or naming a point whose value is out of range; BadMesh, MissingArray. A mesh without points gives an
 * empty output silently; without a profile (vtkOversketchCrossSection found none) it goes through.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: linear in the region; what depends
 * on mesh, region and curve alone is kept between runs.
 *
 * @sa vtkOversketchCrossSection vtkOversketchResketch vtkOversketchMatrixDeform
 */
#ifndef vtkOversketchProfileDeform_h
#define vtkOversketchProfileDeform_h

#include "OversketchFiltersDeformModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSDEFORM_EXPORT vtkOversketchProfileDeform : public vtkOversketchFilter
{
public:
  static vtkOversketchProfileDeform* New();
  vtkTypeMacro(vtkOversketchProfileDeform, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The reference curve, the old profile, the new one and handles, on ports 1 to 4.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(1, curve); }
  void SetReferenceData(vtkPolyData* curve) { this->SetInputData(1, curve); }
  void SetProfileConnection(vtkAlgorithmOutput* profile) { this->SetInputConnection(2, profile); }
  void SetProfileData(vtkPolyData* profile) { this->SetInputData(2, profile); }
  void SetDrawnConnection(vtkAlgorithmOutput* profile) { this->SetInputConnection(3, profile); }
  void SetDrawnData(vtkPolyData* profile) { this->SetInputData(3, profile); }
  void SetHandlesConnection(vtkAlgorithmOutput* handles) { this->SetInputConnection(4, handles); }
  void SetHandlesData(vtkPolyData* handles) { this->SetInputData(4, handles); }
  ///@}

  ///@{
  /**
   * Multiply displacements by EditWeight, as published, so that nothing off the curve matches the profile.
   * Default off.
   */
  vtkSetMacro(UseTexture, bool);
  vtkGetMacro(UseTexture, bool);
  vtkBooleanMacro(UseTexture, bool);
  ///@}

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
  vtkOversketchProfileDeform();
  ~vtkOversketchProfileDeform() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  bool UseTexture = false;
  int MovedPoints = 0;
  int FoldedEdges = 0;
  vtkIdType DeformCount = 0;

  struct Cache;
};

#endif
