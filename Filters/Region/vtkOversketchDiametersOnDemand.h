/**
 * @class vtkOversketchDiametersOnDemand
 * @brief the array ShapeDiameter whose values are computed where a step asks for them
 *
 * A value is 0 until then. A plain array for all who do not know it; a deep copy is one. For use in the .cxx
 * of filters; not wrapped.
 */
#ifndef vtkOversketchDiametersOnDemand_h
#define vtkOversketchDiametersOnDemand_h

#include "Ray/shape_diameter.h"

#include "vtkDoubleArray.h"

#include <memory>
#include <optional>
#include <vector>

namespace oversketch
{
class MeshData;
}

class vtkOversketchDiametersOnDemand : public vtkDoubleArray
{
public:
  static vtkOversketchDiametersOnDemand* New();
  vtkTypeMacro(vtkOversketchDiametersOnDemand, vtkDoubleArray);

  /**
   * Makes what rays need for this mesh.
   */
  void Open(const std::shared_ptr<const oversketch::MeshData>& mesh,
    const oversketch::ShapeDiameterOptions& options,
    const oversketch::Context& context);

  /**
   * Computes the values of some points. They are the same whatever was asked for before, so that the array is
   * not modified by it. Throws Error(Cancelled).
   */
  void Require(const std::vector<int>& points, const oversketch::Context& context);

  /**
   * Gives the memory back that further values need, until they are asked for.
   */
  void Rest() { this->Diameters->rest(); }

  /**
   * How the values came about that are known.
   */
  const oversketch::ShapeDiameter& Result() const { return this->Diameters->result(); }

private:
  std::shared_ptr<const oversketch::MeshData> Mesh;
  std::optional<oversketch::Diameters> Diameters;
};

#endif
