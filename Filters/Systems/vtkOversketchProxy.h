/**
 * @class vtkOversketchProxy
 * @brief a coarse mesh in the place of a large one, for systems to work on
 *
 * For models of ten million triangles: the hand draws on the proxy, and vtkOversketchDetailTransfer gives the
 * model itself what was done to it. Vertices of one cell of a grid that hang together are one, the one of
 * them nearest to their mean; see Kernels/Remesh/proxy.h.
 *
 * Departures: none, it is of no paper.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData. Points that share a position are one.
 *
 * Output 0 (Mesh): the proxy. Its points are points of the mesh, with their point arrays; without texture
 * coordinates and global ids, and without normals where points were welded. Point array Origin, 3 doubles:
 * the place of the point in the mesh [model length]. Cell and field arrays, which tell of other triangles,
 * stay behind. A mesh of no more triangles than TargetTriangles is passed as it is, with Origin.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, also where no triangle has an area. A mesh
 * without points gives an empty output silently.
 *
 * A closed manifold gives a closed manifold. Deterministic, for any number of threads. Cost: some 0.5 s a
 * million triangles.
 *
 * @sa vtkOversketchDetailTransfer
 */
#ifndef vtkOversketchProxy_h
#define vtkOversketchProxy_h

#include "OversketchFiltersSystemsModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSYSTEMS_EXPORT vtkOversketchProxy : public vtkOversketchFilter
{
public:
  static vtkOversketchProxy* New();
  vtkTypeMacro(vtkOversketchProxy, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * About how many triangles the proxy is to have, to within three tenths. Default 500,000; range 1000 up.
   */
  vtkSetClampMacro(TargetTriangles, int, 1000, VTK_INT_MAX);
  vtkGetMacro(TargetTriangles, int);
  ///@}

protected:
  vtkOversketchProxy() = default;
  ~vtkOversketchProxy() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int TargetTriangles = 500000;
};

#endif
