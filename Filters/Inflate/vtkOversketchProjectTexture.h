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
 * Output 0 (Mesh): the same with the point array TCoords, double[2], as active texture coordinates.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray with neither a picture nor Canvas;
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
#include "vtkPolyDataAlgorithm.h"

#include <memory>

class vtkImageData;

class OVERSKETCHFILTERSINFLATE_EXPORT vtkOversketchProjectTexture : public vtkPolyDataAlgorithm
{
public:
  static vtkOversketchProjectTexture* New();
  vtkTypeMacro(vtkOversketchProjectTexture, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The picture, on port 1.
   */
  void SetPictureConnection(vtkAlgorithmOutput* picture) { this->SetInputConnection(1, picture); }
  void SetPictureData(vtkImageData* picture);

protected:
  vtkOversketchProjectTexture();
  ~vtkOversketchProjectTexture() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkOversketchProjectTexture(const vtkOversketchProjectTexture&) = delete;
  void operator=(const vtkOversketchProjectTexture&) = delete;

  struct Cache;
  std::unique_ptr<Cache> Internals;
};

#endif
