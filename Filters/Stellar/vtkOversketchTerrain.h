/**
 * @class vtkOversketchTerrain
 * @brief a height image becomes a coarse terrain that refinement reads it into
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. IV: a grid of quads, as
 * coarse as the user likes, each two triangles that are a pair of a 4-8 mesh. Silent there, and chosen here:
 * heights between samples are bilinear, quads are cut from lower left to upper right, 64 of them along the
 * longer side. Missing samples in places narrower than three are filled, by the plane through those beside
 * them; quads over those that lie in 3 x 3 missing ones are left out, and then those that meet others at a
 * corner alone. A warning says how many.
 *
 * A system of no steps, so that it can be the first in a session.
 *
 * Input 0 (Heights, vtkImageData): one slice across z with scalars; of colours the luminance counts, of two
 * components the first. Samples that are not finite are missing. The origin is the place of the lower left
 * sample on its map, the spacing is in units of that.
 *
 * Output 0 (Mesh): 4-8 mesh, see vtkOversketchStellarBase: point (i, j) at i times QuadX, j times QuadY, and
 * Offset + Scale * gray; with the field arrays TerrainGray and TerrainRules, double, from which
 * vtkOversketchStellarRefine reads heights anew where it refines.
 * Both outputs have the field array MapOrigin, three doubles, where the image's origin is not 0: what is
 * added to each point to be on the map, x and y of the origin and 0. Points themselves are small numbers.
 * Output 1 (Source): no points, the field arrays alone.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray without scalars; BadMesh for several
 * slices, fewer than two samples in a row or column, parameters out of range, more than eight million quads,
 * heights beyond 1e12, or where no quad is left. An image without points gives empty outputs silently.
 *
 * Deterministic: same result bit for bit for any number of threads, cached or read from a file. The result
 * stays, as the same arrays, while all that is read does.
 *
 * @sa vtkOversketchStellarRefine
 */
#ifndef vtkOversketchTerrain_h
#define vtkOversketchTerrain_h

#include "OversketchFiltersStellarModule.h" // For export macro
#include "vtkOversketchSystem.h"

class OVERSKETCHFILTERSSTELLAR_EXPORT vtkOversketchTerrain : public vtkOversketchSystem
{
public:
  static vtkOversketchTerrain* New();
  vtkTypeMacro(vtkOversketchTerrain, vtkOversketchSystem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The source, on port 1.
   */
  vtkPolyData* GetSourceOutput() { return this->GetOutput(1); }

  ///@{
  /**
   * Quads along x [default 0: 64 along the longer side of the image, or so many that quads are square].
   */
  vtkSetClampMacro(Columns, int, 0, VTK_INT_MAX);
  vtkGetMacro(Columns, int);
  ///@}

  ///@{
  /**
   * Quads along y [default 0, as Columns].
   */
  vtkSetClampMacro(Rows, int, 0, VTK_INT_MAX);
  vtkGetMacro(Rows, int);
  ///@}

  ///@{
  /**
   * Side of a quad along x [model length, default 0: as long as the image is by its spacing].
   */
  vtkSetMacro(QuadX, double);
  vtkGetMacro(QuadX, double);
  ///@}

  ///@{
  /**
   * Side of a quad along y [model length, default 0, as QuadX].
   */
  vtkSetMacro(QuadY, double);
  vtkGetMacro(QuadY, double);
  ///@}

  ///@{
  /**
   * Height of one unit of gray [model length, default 1].
   */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /**
   * Height where gray is 0 [model length, default 0].
   */
  vtkSetMacro(Offset, double);
  vtkGetMacro(Offset, double);
  ///@}

  /**
   * How many terrains have been made: executions that the kept result did not answer.
   */
  vtkGetMacro(TerrainCount, vtkIdType);

protected:
  vtkOversketchTerrain();
  ~vtkOversketchTerrain() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  int Columns = 0;
  int Rows = 0;
  double QuadX = 0.0;
  double QuadY = 0.0;
  double Scale = 1.0;
  double Offset = 0.0;
  vtkIdType TerrainCount = 0;

  struct Cache;
};

#endif
