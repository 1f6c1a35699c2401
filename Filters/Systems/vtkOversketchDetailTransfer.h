/**
 * @class vtkOversketchDetailTransfer
 * @brief a large mesh, moved as its proxy was
 *
 * What was done to a proxy (vtkOversketchProxy), by whatever steps, is done to the mesh that it was made of:
 * each point goes with the closest place on the proxy, and its way from there turns with the surface; see
 * Kernels/Ray/detail_transfer.h. Where the proxy has not moved the mesh keeps its bits.
 *
 * Departures: none, it is of no paper.
 *
 * Input 0 (Mesh): the triangle mesh that the proxy was made of, vtkPolyData. Points whose point array Mask is
 * 1 (vtkOversketchMask) keep their bits.
 * Input 1 (Proxy): the proxy after its steps, vtkPolyData, of
 * triangles of its own by now, perhaps. Point array Origin, 3 components: where each of its points was; steps
 * interpolate it for the points that they make.
 *
 * Output 0 (Mesh): the mesh with its points moved; point normals turn as the surface does. All else is
 * passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh; MissingArray where the proxy has no
 * Origin. A mesh without points gives an empty output silently.
 *
 * Deterministic, for any number of threads. Cost: some 1.5 s a million points and core.
 *
 * @sa vtkOversketchProxy
 */
#ifndef vtkOversketchDetailTransfer_h
#define vtkOversketchDetailTransfer_h

#include "OversketchFiltersSystemsModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSYSTEMS_EXPORT vtkOversketchDetailTransfer : public vtkOversketchFilter
{
public:
  static vtkOversketchDetailTransfer* New();
  vtkTypeMacro(vtkOversketchDetailTransfer, vtkOversketchFilter);

protected:
  vtkOversketchDetailTransfer() { this->SetNumberOfInputPorts(2); }
  ~vtkOversketchDetailTransfer() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
};

#endif
