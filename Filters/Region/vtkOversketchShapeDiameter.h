/**
 * @class vtkOversketchShapeDiameter
 * @brief local thickness of a triangle mesh, by cones of rays
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 4.1, Fig. 8. From each vertex v a
 * cone of rays is cast round -n_v into the solid; the shape diameter is the average length to where the rays
 * leave it. The paper leaves open, and here is chosen: ConeAngle is the full opening; the rays are a fixed
 * spiral of equal solid angles, so the result is not random, laid by the longer edges at v (TurnCones); a ray
 * ends at the first facet that it leaves through (direction . facet normal > 0) and that does not touch v,
 * passing through all others; hits farther than one standard deviation from the median are dropped, the rest
 * averaged with equal weights. Departure: a bounding volume tree built on the host instead of an octree.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData, oriented outward, closed or not; its point normals are used
 * where it has them, else angle-weighted ones are computed. Non-manifold edges are tolerated. An
 * unoriented or open mesh gives a value everywhere, but a thickness only where rays find a facet to leave
 * through.
 *
 * Output 0: the input with the point array ShapeDiameter added, double, [model length], finite, not negative.
 * Vertices whose rays all miss get the mean of their measured neighbours, ring by ring; pieces with no
 * measured vertex (an open sheet, a loose point) the mean of all measured ones; where no vertex is measured,
 * the bounding-box diagonal. Everything else is passed; nothing is interpolated or dropped.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh. A mesh without points gives an empty
 * output silently. Rays are cast on the back end that is chosen, see SetBackend.
 *
 * Deterministic: same result bit for bit for any number of threads. OpenCL and Embree trace the same rays;
 * their lengths agree to 1e-4, usually to the last bits, as lengths are refined in double precision.
 *
 * Cost: RayCount rays per vertex, about 5 million rays a second on two cores. The array is kept, as the same
 * object, while points, polygons, point normals and parameters stand.
 *
 * @sa vtkOversketchMixtureRegion
 */
#ifndef vtkOversketchShapeDiameter_h
#define vtkOversketchShapeDiameter_h

#include "OversketchFiltersRegionModule.h" // For export macro
#include "vtkOversketchBackendFilter.h"

class OVERSKETCHFILTERSREGION_EXPORT vtkOversketchShapeDiameter : public vtkOversketchBackendFilter
{
public:
  static vtkOversketchShapeDiameter* New();
  vtkTypeMacro(vtkOversketchShapeDiameter, vtkOversketchBackendFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Rays per vertex, 1 to 4096; default 32, as in the paper's device version ("around 30").
   */
  vtkSetClampMacro(RayCount, int, 1, 4096);
  vtkGetMacro(RayCount, int);
  ///@}

  ///@{
  /**
   * Full opening of the cone, degrees, 0.1 to 179.9; default 60, "typically" in the paper. Other
   * implementations of the shape diameter function commonly use 120.
   */
  vtkSetClampMacro(ConeAngle, double, 0.1, 179.9);
  vtkGetMacro(ConeAngle, double);
  ///@}

  ///@{
  /**
   * Weigh each ray by the inverse of its angle to the cone's axis, as the original shape diameter function
   * does; default off: equal weights.
   */
  vtkSetMacro(InverseAngleWeights, bool);
  vtkGetMacro(InverseAngleWeights, bool);
  vtkBooleanMacro(InverseAngleWeights, bool);
  ///@}

  ///@{
  /**
   * Lay each vertex' rays round the cone's axis by where its longer edges point to, or, where they are as
   * long on all sides, by a fixed direction; default on. Off, as published, which names no direction: by a
   * fixed one, and a model that is turned is hit elsewhere and gets another region (90 of its vertices, where
   * one was compared).
   */
  vtkSetMacro(TurnCones, bool);
  vtkGetMacro(TurnCones, bool);
  vtkBooleanMacro(TurnCones, bool);
  ///@}

  ///@{
  /**
   * Compute values where a step downstream asks for them, as vtkOversketchMixtureRegion does of what its
   * growth reads; default off: all. On, the array ShapeDiameter is 0 elsewhere, and each value is what it is
   * when all are computed, bit for bit.
   */
  vtkSetMacro(OnDemand, bool);
  vtkGetMacro(OnDemand, bool);
  vtkBooleanMacro(OnDemand, bool);
  ///@}

  /**
   * How many times rays have been made ready to be cast: executions that the kept result did not answer.
   */
  vtkGetMacro(RayCastCount, vtkIdType);

  /**
   * Rays that have been cast for the present result: RayCount for each vertex that has a normal, or of those
   * that were asked for.
   */
  vtkIdType GetTracedRayCount();

protected:
  vtkOversketchShapeDiameter() = default;
  ~vtkOversketchShapeDiameter() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int RayCount = 32;
  double ConeAngle = 60.0;
  bool InverseAngleWeights = false;
  bool TurnCones = true;
  bool OnDemand = false;
  vtkIdType RayCastCount = 0;
  vtkIdType TracedRayCount = 0;

  struct Cache;
};

#endif
