// Pictures as files, read and decoded on any thread, so that the window's own need not.
#ifndef oversketch_studio_picture_files_h
#define oversketch_studio_picture_files_h

#include "step.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <string>

namespace oversketch_studio
{

// How names of such files end.
QStringList pictureExtensions();

// Throws Failed, with words for the user, for what is no picture.
struct ReadPicture
{
  oversketch_session::Image image;
  vtkSmartPointer<vtkImageData> pixels;
};
ReadPicture readPicture(const QString& path);

// Bytes as an Image has them. The first decodes them for whoever asks next by the second, which hands that
// out and forgets it, or decodes them itself. Null for what is no picture.
using PictureBytes = std::shared_ptr<const std::string>;
vtkSmartPointer<vtkImageData> decodeAhead(const PictureBytes& bytes);
vtkSmartPointer<vtkImageData> takeDecoded(const PictureBytes& bytes);

} // namespace oversketch_studio
#endif
