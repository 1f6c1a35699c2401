/**
 * @class vtkOversketchRegionBorder
 * @brief smooths the border of a region of a mesh
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 4.4, Fig. 10. A region vertex with
 * at most two neighbours in the region (convex) leaves it; the one outside neighbour of a region vertex
 * (concave) joins it; until neither kind is left. Departures: convex before concave, then by vertex id; a
 * vertex changes sides at most twice, since on an open mesh the two rules can undo each other for ever;
 * vertices on the mesh's own border and seeds never leave; pieces without a seed are dropped; and, with
 * Confine, changes stay within Rings rings of the border as it comes in, since along lattice-like meshes the
 * concave rule runs away over the model.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData, with point arrays Region and RegionSeed, one component each,
 * not 0 meaning yes (vtkOversketchMixtureRegion). Where no vertex is a seed, no piece is dropped. Point array
 * Mask, where it has one (vtkOversketchMask): vertices with 1 are neither in the region nor seeds.
 *
 * Output 0: the input with Region, unsigned char, replaced. Everything else is passed; nothing is
 * interpolated or dropped.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, MissingArray; BadRegion when no vertex is
 * left in the region or none outside it, and when all seeds are masked. A mesh without points gives an empty
 * output silently.
 *
 * Deterministic. Cost: linear in the vertices. The array is kept, as the same object, while points, polygons,
 * Region, RegionSeed, Mask and parameters stand.
 *
 * @sa vtkOversketchMixtureRegion
 */
#ifndef vtkOversketchRegionBorder_h
#define vtkOversketchRegionBorder_h

#include "OversketchFiltersRegionModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSREGION_EXPORT vtkOversketchRegionBorder : public vtkOversketchFilter
{
public:
  static vtkOversketchRegionBorder* New();
  vtkTypeMacro(vtkOversketchRegionBorder, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Confine changes to Rings rings of vertices on either side of the border; default on. Off is as published.
   */
  vtkSetMacro(Confine, bool);
  vtkGetMacro(Confine, bool);
  vtkBooleanMacro(Confine, bool);
  ///@}

  ///@{
  /**
   * Rings of vertices that Confine leaves free, at least 1; default 2.
   */
  vtkSetClampMacro(Rings, int, 1, VTK_INT_MAX);
  vtkGetMacro(Rings, int);
  ///@}

  /**
   * How many times a border has been smoothed: executions that the kept result did not answer.
   */
  vtkGetMacro(SmoothingCount, vtkIdType);

protected:
  vtkOversketchRegionBorder() = default;
  ~vtkOversketchRegionBorder() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  bool Confine = true;
  int Rings = 2;
  vtkIdType SmoothingCount = 0;

  struct Cache;
};

#endif
