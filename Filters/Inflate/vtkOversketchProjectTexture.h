/**
 * @class vtkOversketchProjectTexture
 * @brief texture coordinates of a drawing's surface: where on its picture each point was drawn
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.4: s = (x - x_o) / w, t = (y - y_o) / h in world
 * units, z ignored, so front and back have the same coordinates. As the paper says, they all coincide along a
 * wall. The paper leaves open, and here is chosen: coordinates are not clamped.
 *
 * Input 0 (Mesh): a drawing's surface before it is placed (vtkOversketchAssemble).
 * Input 1 (Picture, vtkImageData, optional): the picture it was drawn over; without it the mesh's field array
 * Canvas says where that is.
 *
 * Input 2 (BackPicture, vtkImageData, optional): a picture of the back, as seen from behind. The paper names
 * separate front and back textures as future work. It fills the same rectangle, whatever its samples, its
 * left at the canvas's right.
 *
 * Output 0 (Mesh): the same with the point array TCoords, double[2], as active texture coordinates. With a
 * picture of the back, faces of the back (cell array Side) have points of their own: those that they share
 * with others are there twice, the second ones after all others; a cell array PartId, int, is 1 there and 0
 * on front and walls, so that each side can wear its picture, as parts of vtkOversketchAssemble do.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray with neither a picture nor Canvas;
 * without Side where there is a picture of the back;
 * BadStroke for a picture without samples, of several slices or with a direction matrix other than the
 * identity, and a Canvas without extent. A mesh without points gives an empty output silently.
 *
 * Deterministic. Cost: linear in the points.
 *
 * @sa vtkOversketchInflate vtkOversketchExtrude vtkOversketchAssemble
 */
#ifndef vtkOversketchProjectTexture_h
#define vtkOversketchProjectTexture_h

#include "OversketchFiltersInflateModule.h" // For export macro
#include "vtkOversketchFilter.h"

#include <memory>

class OVERSKETCHFILTERSINFLATE_EXPORT vtkOversketchProjectTexture : public vtkOversketchFilter
{
public:
  static vtkOversketchProjectTexture* New();
  vtkTypeMacro(vtkOversketchProjectTexture, vtkOversketchFilter);

  /**
   * The picture, on port 1.
   */
  void SetPictureConnection(vtkAlgorithmOutput* picture) { this->SetInputConnection(1, picture); }
  void SetPictureData(vtkDataObject* picture) { this->SetInputData(1, picture); }

  /**
   * The picture of the back, on port 2.
   */
  void SetBackPictureConnection(vtkAlgorithmOutput* picture) { this->SetInputConnection(2, picture); }
  void SetBackPictureData(vtkDataObject* picture) { this->SetInputData(2, picture); }

protected:
  vtkOversketchProjectTexture();
  ~vtkOversketchProjectTexture() override;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkOversketchProjectTexture(const vtkOversketchProjectTexture&) = delete;
  void operator=(const vtkOversketchProjectTexture&) = delete;

  struct Cache;
  std::unique_ptr<Cache> Internals;
};

#endif
