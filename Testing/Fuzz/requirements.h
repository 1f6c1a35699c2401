// What must hold of what a target makes. Header-only.
#ifndef oversketch_testing_fuzz_requirements_h
#define oversketch_testing_fuzz_requirements_h

#include "Harness/polydata.h"
#include "Mesh/context.h"

#include "vtkPolyData.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace oversketch_fuzz
{

inline void require(bool good, const std::string& what)
{
  if (!good)
  {
    throw std::logic_error(what);
  }
}

inline void requireFinite(vtkPolyData* mesh)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    require(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]), "a point that is not finite");
  }
}

// What a run of a system may end in: a mesh, or one message and none. Whether it is the mesh.
template <class System>
bool requireMeshOrMessage(System* system, const oversketch_test::Ear& ear)
{
  vtkPolyData* result = system->GetOutput();
  require(ear.errors.size() < 2, "more than one message");
  require((system->GetErrorCode() != 0) == !ear.errors.empty(),
    "an error code and no message, or the other way round");
  if (!ear.errors.empty())
  {
    require(result->GetNumberOfPoints() == 0, "an error and an output");
    const auto unexpected = static_cast<unsigned long>(oversketch::Failure::Unexpected);
    require(system->GetErrorCode() - 40000 != unexpected, ear.errors[0]);
    return false;
  }
  requireFinite(result);
  require(result->GetNumberOfPolys() > 0, "no polygon and no message");
  return true;
}

} // namespace oversketch_fuzz
#endif
