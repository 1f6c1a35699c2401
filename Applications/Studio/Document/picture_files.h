// Pictures as files, read and decoded on any thread, so that the window's own need not.
#ifndef oversketch_applications_studio_document_picture_files_h
#define oversketch_applications_studio_document_picture_files_h

#include "step.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

class QObject;
class vtkPolyData;

namespace oversketch_studio
{

// How names of such files end.
QStringList pictureExtensions();

// Bytes as an Image has them, and their pixels: null where they are no picture.
using PictureBytes = std::shared_ptr<const std::string>;
struct DecodedPicture
{
  PictureBytes bytes;
  vtkSmartPointer<vtkImageData> pixels;

  explicit DecodedPicture(const PictureBytes& of);
  // The pixels as a model wears them (opaquePicture), made when they are asked for first, on any thread.
  vtkImageData* worn() const;

private:
  mutable std::once_flag Asked;
  mutable vtkSmartPointer<vtkImageData> Opaque;
};
// As long as somebody holds one, all who ask for equal bytes are given the same.
using SharedPicture = std::shared_ptr<const DecodedPicture>;
// Decodes it where nobody holds it.
SharedPicture decoded(const PictureBytes& bytes);
// Null where nobody holds it.
SharedPicture findDecoded(const std::string& bytes);
// Null where nobody holds it, too; then decodes it on a thread of its own, ready to be worn, and gives it to
// the window's by `then`, as long as the context is there.
SharedPicture whenDecoded(QObject* context,
  const PictureBytes& bytes,
  const std::function<void(const SharedPicture&)>& then);
// All that a mesh wears, ready to be worn; none of no mesh.
std::vector<SharedPicture> decodedOf(vtkPolyData* mesh);

// A picture (8 bits) without its alpha, as opaqueOf of Kernels/Raster/skin.h has it: there is nothing to be
// seen through what wears it. One without alpha is given back itself.
vtkSmartPointer<vtkImageData> opaquePicture(vtkImageData* picture);

// Throws Failed, with words for the user, for what is no picture.
struct ReadPicture
{
  oversketch_session::Image image;
  SharedPicture decoded;
};
ReadPicture readPicture(const QString& path);

} // namespace oversketch_studio
#endif
