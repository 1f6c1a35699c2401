/**
 * @class vtkOversketchRelax
 * @brief strokes over a mesh relax it there: what is small goes, the shape stays
 *
 * Source: ours; none of the papers has it. A stroke loses jitter {Thinning} and is projected on the surface
 * {Curves}. In a band on both sides of it a thin plate is laid that goes on as the surface beyond does and
 * clings to what is within (M. Botsch, L. Kobbelt, "An intuitive framework for real-time freeform modeling",
 * 2004; implicit as in M. Desbrun et al., "Implicit fairing of irregular meshes", 1999): what is smaller than
 * the band is gone in one pass, whatever the triangles, a bend that is longer stays, and with it the volume.
 * Of a limb that is thinner than the band smaller waves alone go, so that it keeps its girth; where a
 * triangle would turn over, in folds narrower than the band, points move less.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData; borders, non-manifold edges and any orientation are tolerated.
 * Points that a reader split for texture coordinates or normals are welded for computing (exactly equal
 * positions), so seams stay closed. Point array Mask, where it has one (vtkOversketchMask): 1: the point
 * stays, as those of borders do; between, it moves by 1 - Mask of its way.
 * Input 1 (Strokes): polylines in display coordinates with cell arrays ViewTransform, ProjectionTransform,
 * ViewportSize; any number, each with its own view, all at once. Cell array Radius [model length] goes before
 * the parameter, point array Pressure is read with UsePressure.
 *
 * Output 0: the mesh with other points, in its own type; cells and arrays are passed, point normals turn with
 * the surface. Points beyond the band, masked ones, and those on borders and at edges with more than two
 * triangles are bit-identical.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh; MissingArray for a Mask that is not one
 * finite number a point; BadStroke, naming the stroke, where there is none, where it misses the mesh, for
 * values that are not finite, a radius that is not positive, and where no point may move, as the triangles
 * are larger than the band or all of it is masked. An empty mesh gives an empty output silently.
 * A run that AbortExecute stopped needs Modified() before the next.
 *
 * Deterministic: same result bit for bit for any number of threads. The first stroke on a mesh makes its ray
 * scene; each further one costs what its band does, and a look at each point of the mesh.
 *
 * @sa vtkOversketchMask vtkOversketchSurfaceStroke vtkOversketchAugment
 */
#ifndef vtkOversketchRelax_h
#define vtkOversketchRelax_h

#include "OversketchFiltersRelaxModule.h" // For export macro
#include "vtkOversketchSystem.h"

class OVERSKETCHFILTERSRELAX_EXPORT vtkOversketchRelax : public vtkOversketchSystem
{
public:
  static vtkOversketchRelax* New();
  vtkTypeMacro(vtkOversketchRelax, vtkOversketchSystem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetStrokesConnection(vtkAlgorithmOutput* strokes) { this->SetInputConnection(1, strokes); }
  void SetStrokesData(vtkPolyData* strokes) { this->SetInputData(1, strokes); }

  ///@{
  /**
   * How far to each side of a stroke the surface is relaxed; from there to 5/4 of it the effect fades [model
   * length; default -1: below 0 stands for 3 % of the mesh's diagonal].
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Share of the way that points move to the relaxed surface [0 to 1, default 1].
   */
  vtkSetClampMacro(Strength, double, 0.0, 1.0);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /**
   * Multiply the strength by the pen's pressure, where the strokes have it [default on].
   */
  vtkSetMacro(UsePressure, bool);
  vtkGetMacro(UsePressure, bool);
  vtkBooleanMacro(UsePressure, bool);
  ///@}

  ///@{
  /**
   * Keep points at edges that bend by more than this [degrees, 0 to 180; default 180: none], such as the
   * crest of a line.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  /**
   * How many times a band has been relaxed: runs that the kept result did not answer.
   */
  vtkGetMacro(RelaxCount, vtkIdType);

  bool Prepare() override;
  bool Preview(vtkPolyData* mesh, vtkPolyData* stroke, vtkPolyData* hold) override;
  void GetHold(vtkPolyData* hold) override;
  void GetRegion(vtkPolyData* region) override;
  /**
   * "moved": how many points of the output lie elsewhere; "farthest": by how much at most [model length].
   */
  FigureList Figures() override;

protected:
  vtkOversketchRelax();
  ~vtkOversketchRelax() override = default;

  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Radius = -1.0;
  double Strength = 1.0;
  bool UsePressure = true;
  double FeatureAngle = 180.0;
  vtkIdType RelaxCount = 0;

  struct Inner;
};

#endif
