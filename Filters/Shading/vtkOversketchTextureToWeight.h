/**
 * @class vtkOversketchTextureToWeight
 * @brief weights of a region's vertices from a painted image: white follows wholly, black not at all
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.5: each vertex takes
 * its weight from the grey that the texture has at its texture coordinates; nothing is computed anew. Left
 * open there, and chosen here: between texels weights are bilinear; colours count by their brightness, 0.299
 * R + 0.587 G + 0.114 B; where the image is transparent nothing is painted, so it counts as black.
 *
 * Input 0 (Mesh): with point arrays EditRegion and DiscCoords (vtkOversketchFlatten).
 * Input 1 (Image, vtkImageData): of one slice, its scalars grey, grey and alpha, RGB or RGBA; unsigned char,
 * unsigned short, or numbers from 0, black, to 1, white. Of any size: its left and right edges are u = 0 and
 * 1, its first row is the lowest.
 *
 * Output 0 (Mesh): the same with point array EditWeight, double: 0 where EditRegion is not 2.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray; BadRegion for an EditRegion that is
 * none; BadMesh for DiscCoords that are not finite; BadStroke, naming the sample, for an image without
 * samples or scalars, of several slices, of another type or with numbers outside 0 to 1 where a vertex lies.
 * A mesh without points gives an empty output silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: linear in the vertices.
 *
 * @sa vtkOversketchShadingLevels vtkOversketchFlatten
 */
#ifndef vtkOversketchTextureToWeight_h
#define vtkOversketchTextureToWeight_h

#include "OversketchFiltersShadingModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSHADING_EXPORT vtkOversketchTextureToWeight : public vtkOversketchFilter
{
public:
  static vtkOversketchTextureToWeight* New();
  vtkTypeMacro(vtkOversketchTextureToWeight, vtkOversketchFilter);

  /**
   * The image, on port 1.
   */
  void SetImageConnection(vtkAlgorithmOutput* image) { this->SetInputConnection(1, image); }
  void SetImageData(vtkDataObject* image) { this->SetInputData(1, image); }

protected:
  vtkOversketchTextureToWeight();
  ~vtkOversketchTextureToWeight() override = default;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
};

#endif
