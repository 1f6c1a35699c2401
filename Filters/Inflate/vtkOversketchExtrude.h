/**
 * @class vtkOversketchExtrude
 * @brief a drawing's mesh as a slab: front and back at equal distances from the plane, and walls between
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.3, Fig. 12b: for rectilinear shapes all points are
 * moved by the same distance, and faces stitched between front and back so that the surface stays
 * semi-regular. The printed count of these faces, "2k triangles (k quads)" after k subdivisions, is 0 for
 * k = 0: exponents were lost in print. Here they are 2 4^k triangles (4^k quads) for each border edge of the
 * coarse mesh, what subdivision makes of 2 (of 1); WallRows 1 gives 2 2^k. The paper leaves the distance
 * open.
 *
 * Input 0 (Mesh): the drawing's mesh in the plane, triangles or quads, as vtkOversketchPlanarRefine puts it
 * out, holes trimmed, with field array Canvas.
 *
 * Output 0 (Mesh): the closed surface: the front's points in the mesh's order, the back's, the walls'; of
 * quads quads. All arrays are passed, walls having those of the rim's points and faces but BaseFaceId -1, and
 * - point array Displacement, double: distance from the plane [world],
 * - point and cell array Side, int: 1 front, -1 back, 0 of walls,
 * - point array PlanarId, int: the point of the input.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray naming an absent array, Canvas only
 * where Depth is 0; BadMesh, naming points, where the mesh is no sheet, two borders meet, or a border is not
 * subdivided equally; BadStroke for a negative Depth. A mesh without points gives an empty output silently.
 *
 * Deterministic. Cost: linear in the mesh.
 *
 * @sa vtkOversketchInflate vtkOversketchTunnel
 */
#ifndef vtkOversketchExtrude_h
#define vtkOversketchExtrude_h

#include "OversketchFiltersInflateModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSINFLATE_EXPORT vtkOversketchExtrude : public vtkOversketchFilter
{
public:
  static vtkOversketchExtrude* New();
  vtkTypeMacro(vtkOversketchExtrude, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Distance of front and back from the plane [world, default 0: 0.1 of the canvas's longest side].
   */
  vtkSetMacro(Depth, double);
  vtkGetMacro(Depth, double);
  ///@}

  ///@{
  /**
   * Rows of faces in the walls: 0 (default) as many as a border edge of the coarse mesh was divided in, or 1.
   */
  vtkSetClampMacro(WallRows, int, 0, 1);
  vtkGetMacro(WallRows, int);
  ///@}

  /**
   * How many times the surface has been computed: executions that the kept one did not answer.
   */
  vtkGetMacro(ExtrudeCount, vtkIdType);

protected:
  vtkOversketchExtrude() = default;
  ~vtkOversketchExtrude() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Depth = 0.0;
  int WallRows = 0;
  vtkIdType ExtrudeCount = 0;
};

#endif
