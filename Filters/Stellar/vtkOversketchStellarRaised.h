// What a displacement knew of its mesh, for the simplification that follows it. Not installed.
#ifndef vtkOversketchStellarRaised_h
#define vtkOversketchStellarRaised_h

#include "Stellar/displace.h"
#include "vtkOversketchFilterTools.h"

#include <memory>

class vtkPolyData;

namespace oversketch
{

struct Raised
{
  std::shared_ptr<const Forest> before;
  std::shared_ptr<const CurvesReached> reached;
  MeshKey curves; // WholeKey of them
  double radius;
  CurveDistance distance;
  bool connectedOnly;
};

// Keeps it, as long as somebody holds it, with the mesh that it was raised to; callable from any thread.
void AddRaised(vtkPolyData* mesh, const std::shared_ptr<const Raised>& raised);
// Null where it is not known.
std::shared_ptr<const Raised> RaisedOf(vtkPolyData* mesh);

} // namespace oversketch
#endif
