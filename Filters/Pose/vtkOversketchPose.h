/**
 * @class vtkOversketchPose
 * @brief a bone drawn along a limb, and its new course: the limb bends with it
 *
 * Source: ours, of M. Alexa, "Linear Combination of Transformations", 2002, as R. Bujans, "Sketch-Based
 * Techniques for Mesh Deformation and Editing", chapter 8, uses it for handles along a line. The bone is the
 * centre line of the limb under a line: between where rays enter the limb and where they leave it. The limb
 * is what the surface joins to the tip's side of its cross-section at the joint. At each place of the bone
 * the rest of the limb turns about it, in the plane of the picture, as the bone's new course does; near the
 * place points take a share of the turn. Depths along the line of sight stay. Kernels/Pose/pose.h says how,
 * with departures.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData; borders, non-manifold edges and any orientation are tolerated.
 * Points that a reader split for texture coordinates or normals are welded for computing (exactly equal
 * positions), so seams stay closed. Point array Mask, where it has one (vtkOversketchMask): points move by
 * 1 - Mask of their way.
 * Input 1 (Bone): one polyline in display coordinates with cell arrays ViewTransform, ProjectionTransform,
 * ViewportSize: from the joint that stays to the limb's tip, drawn over the limb; where it bends the limb has
 * joints, too. What of it lies beside the model is left out.
 * Input 2 (Pose, optional): its new course, alike, drawn from the same joint; a begin beside that is moved
 * there. The view may be another one. Absent or without points: the mesh goes through.
 *
 * Output 0: the mesh with other points, in its own type; cells and arrays are passed, point normals turn with
 * the surface. Points that are not the limb's are bit-identical, and all where the course is the bone.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh; MissingArray; BadStroke, naming bone or
 * pose, where that is no one polyline, not finite, or shorter than 10 px; where the bone lies over nothing
 * that has a front and a back, nothing is beyond its joint, or it is seen from its end in the pose's view;
 * for a softness that is not finite. An empty mesh gives an empty output silently. A run that AbortExecute
 * stopped needs Modified() before the next.
 *
 * Deterministic: same result bit for bit for any number of threads. The first bone on a mesh makes its ray
 * scene, each further one walks over the limb; a new course costs what the limb's points do and a copy of the
 * mesh's.
 *
 * @sa vtkOversketchEdit vtkOversketchMatrixDeform
 */
#ifndef vtkOversketchPose_h
#define vtkOversketchPose_h

#include "OversketchFiltersPoseModule.h" // For export macro
#include "vtkOversketchSystem.h"

class OVERSKETCHFILTERSPOSE_EXPORT vtkOversketchPose : public vtkOversketchSystem
{
public:
  static vtkOversketchPose* New();
  vtkTypeMacro(vtkOversketchPose, vtkOversketchSystem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  // The lines on ports 1 and 2.
  void SetBoneConnection(vtkAlgorithmOutput* bone) { this->SetInputConnection(1, bone); }
  void SetBoneData(vtkPolyData* bone) { this->SetInputData(1, bone); }
  void SetPoseConnection(vtkAlgorithmOutput* pose) { this->SetInputConnection(2, pose); }
  void SetPoseData(vtkPolyData* pose) { this->SetInputData(2, pose); }
  ///@}

  ///@{
  /**
   * Length along the bone over which a joint bends, as a share of the limb's thickness there: less is a
   * sharper elbow [0.05 to 20, default 1].
   */
  vtkSetClampMacro(Softness, double, 0.05, 20.0);
  vtkGetMacro(Softness, double);
  ///@}

  ///@{
  /**
   * Stretch or shorten the limb along the bone, so that it ends where the pose does; off: it keeps its length
   * [default off].
   */
  vtkSetMacro(Stretch, bool);
  vtkGetMacro(Stretch, bool);
  vtkBooleanMacro(Stretch, bool);
  ///@}

  /**
   * How many times a limb has been found: runs and previews that what is kept did not answer.
   */
  vtkGetMacro(LimbCount, vtkIdType);

  bool Prepare() override;
  // The bone, where the surface is seen over it.
  bool Preview(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* hold) override;
  void GetHold(vtkPolyData* hold) override;
  // The triangles of the limb, where a pose moves it.
  void GetRegion(vtkPolyData* region) override;
  /**
   * Output for the inputs and parameters by now, without a run: to be shown while the pose is drawn. What
   * port 2 has may be replaced each time; bone and limb are kept. False, and `preview` as it was, where there
   * is no mesh, bone or pose, or the limb cannot be posed; the error code tells why.
   */
  bool PreviewPose(vtkPolyData* preview);
  /**
   * "moved": how many points of the output lie elsewhere; "joints": places of the bone that turn by over a
   * degree; "bend": the largest angle between bone and pose [degrees]; "folded_edges": edges whose triangles'
   * normals are over 120 degrees apart and were not before; "share": the limb's share of the mesh's points.
   * GetRemark is of the last two.
   */
  FigureList Figures() override;

protected:
  vtkOversketchPose();
  ~vtkOversketchPose() override = default;

  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Softness = 1.0;
  bool Stretch = false;
  vtkIdType LimbCount = 0;

  void PutPosed(vtkPolyData* mesh, vtkPolyData* bone, vtkPolyData* pose, vtkPolyData* output);

  struct Inner;
};

#endif
