/**
 * @class vtkOversketchFlatten
 * @brief a region of a mesh as a disc, to look at and to paint
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.1 and Appendix B: a
 * copy of the region is flattened, x and y within -1 and 1, z = 0; which map, the thesis does not say. The
 * disc is a picture: no length or angle is read from it. Kernels/Shading/flatten.h has the map, and that the
 * printed rescaling divides by zero. Departures, which AsPublished turns off: the map is balanced, since a
 * plain one squeezes a limb into a few texels; the ring of triangles round the boundary, which may touch
 * itself, is not flattened, for the boundary's edges are the mesh's.
 *
 * Input 0 (Mesh): triangles, the mesh or the patch of vtkOversketchEnclose, with point array EditRegion: 0
 * outside, 1 on the boundary or its ring, 2 strictly inside. The region is the triangles that cell array
 * EditRegion gives 2, without it those with a corner strictly inside. A patch's point array VertexId says
 * what the reference curve calls its vertices.
 * Input 1 (Reference): one polyline with point array VertexId, the vertices of the mesh it goes through.
 *
 * Output 0 (Mesh): the same with the point array DiscCoords, double[2]: u = (x + 1) / 2 and v alike, from 0
 * to 1; -1 where a vertex is not in the disc. The model's own texture coordinates stay the active ones.
 * Output 1 (Disc): the flattened triangles in the mesh's order, with point arrays VertexId, the point of
 * input 0, and DiscCoords, its active texture coordinates.
 * Output 2 (Disc curve): the reference curve on the disc, with its own arrays.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray; BadMesh for what is not a triangle or
 * not finite; BadRegion for a region without a vertex inside, one that is not a disc, saying what it is
 * instead; BadStroke for a reference that is not one polyline on vertices of the mesh, or not on the disc. A
 * mesh without points gives empty outputs silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: 2 to 11 solves of a sparse system;
 * the disc stays while points, triangles and EditRegion do: another reference flattens nothing.
 *
 * @sa vtkOversketchDistanceField vtkOversketchShadingLevels
 */
#ifndef vtkOversketchFlatten_h
#define vtkOversketchFlatten_h

#include "OversketchFiltersShadingModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSHADING_EXPORT vtkOversketchFlatten : public vtkOversketchFilter
{
public:
  static vtkOversketchFlatten* New();
  vtkTypeMacro(vtkOversketchFlatten, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The reference curve, on port 1.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(1, curve); }
  void SetReferenceData(vtkPolyData* curve) { this->SetInputData(1, curve); }

  ///@{
  /**
   * The disc and the curve on it, on ports 1 and 2.
   */
  vtkPolyData* GetDiscOutput() { return this->GetOutput(1); }
  vtkPolyData* GetDiscCurveOutput() { return this->GetOutput(2); }
  ///@}

  ///@{
  /**
   * Flatten as printed: with the ring, without balancing [default off].
   */
  vtkSetMacro(AsPublished, bool);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  /**
   * How many discs have been computed: executions that the kept one did not answer.
   */
  vtkGetMacro(FlattenCount, vtkIdType);

protected:
  vtkOversketchFlatten();
  ~vtkOversketchFlatten() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  bool AsPublished = false;
  vtkIdType FlattenCount = 0;

  struct Cache;
};

#endif
