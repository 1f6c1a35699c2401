/**
 * Motion of a region's places by the editors, as handles and a profile that was drawn anew say it. Free
 * functions, for use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchEditMotion_h
#define vtkOversketchEditMotion_h

#include "OversketchFiltersDeformModule.h" // For export macro

#include "Matrix/frames.h"
#include "Matrix/logarithm.h"
#include "Remesh/retriangulate.h"
#include "Section/follow.h"
#include "Section/profile.h"

#include <algorithm>
#include <functional>
#include <vector>

class vtkPolyData;

namespace oversketch
{

/**
 * Logarithms by place, those at one place summed up.
 */
struct Pulls
{
  std::vector<double> Places; // ascending
  std::vector<Matrix4> Logs;

  bool Still() const
  {
    return std::all_of(
      this->Logs.begin(), this->Logs.end(), [](const Matrix4& log) { return log.isZero(0.0); });
  }
};

/**
 * Throws what ReadHandlePlaces and ReadHandleMatrices do, and Error(SolveFailed) naming a handle whose matrix
 * has no logarithm.
 */
Pulls PullsOf(vtkPolyData* handles);

/**
 * A profile, what was drawn in its place, and how far along the curve it reaches. Throws Error(BadStroke),
 * Error(MissingArray).
 */
struct DrawnChange
{
  FlatProfile Old;
  CurveFrame Plane;
  ProfileChange Change;
  PlaneReach Reach;
};
DrawnChange ReadChange(vtkPolyData* profile, vtkPolyData* drawn, const std::vector<double>& handles);

/**
 * A vertex's weight by its share of the way from the reference curve to the boundary, for places between
 * vertices; what a vertex's EditWeight differs from that (an area, a painted image) is mixed of their
 * vertices'. Null: all of the weight is.
 */
using WeightOfShare = std::function<double(double share)>;

///@{
/**
 * What vtkOversketchMatrixDeform and vtkOversketchProfileDeform do, at every place of the mesh: read there as
 * here, and CurveDistance besides. Throw what these do.
 */
OVERSKETCHFILTERSDEFORM_EXPORT Motion MotionOfHandles(vtkPolyData* mesh,
  vtkPolyData* handles,
  const WeightOfShare& weight);
OVERSKETCHFILTERSDEFORM_EXPORT Motion MotionOfProfile(vtkPolyData* mesh,
  vtkPolyData* reference,
  vtkPolyData* profile,
  vtkPolyData* drawn,
  vtkPolyData* handles,
  bool useTexture,
  const WeightOfShare& weight);
///@}

} // namespace oversketch
#endif
