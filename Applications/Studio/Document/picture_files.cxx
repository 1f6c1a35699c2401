#include "picture_files.h"

#include "files.h"
#include "pieces.h"
#include "texture.h"
#include "upright_picture.h"

#include "Raster/skin.h"
#include "vtkOversketchFilterTools.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QPointer>
#include <QThreadPool>

#include <algorithm>
#include <mutex>
#include <set>
#include <utility>

namespace oversketch_studio
{

namespace
{

struct PictureTexts
{
  Q_DECLARE_TR_FUNCTIONS(PictureFiles)
};

std::mutex heldMutex;
std::vector<std::weak_ptr<const DecodedPicture>> held; // some are gone

// Behind the lock.
SharedPicture findHeld(const std::string& bytes)
{
  SharedPicture found;
  const auto isGone = [&](const std::weak_ptr<const DecodedPicture>& one)
  {
    const SharedPicture picture = one.lock();
    found = picture && *picture->bytes == bytes ? picture : found;
    return !picture;
  };
  held.erase(std::remove_if(held.begin(), held.end(), isGone), held.end());
  return found;
}

} // namespace

DecodedPicture::DecodedPicture(const PictureBytes& of)
  : bytes(of)
  , pixels(oversketch_files::pictureOf(*of))
{
}

vtkImageData* DecodedPicture::worn() const
{
  std::call_once(
    this->Asked, [this] { this->Opaque = this->pixels ? opaquePicture(this->pixels) : nullptr; });
  return this->Opaque;
}

QStringList pictureExtensions()
{
  return QString(oversketch_files::pictureExtensions).remove('.').split(' ');
}

ReadPicture readPicture(const QString& path)
{
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
  {
    throw oversketch_files::Failed(PictureTexts::tr("%1: %2").arg(path, file.errorString()).toStdString());
  }
  const oversketch_session::Image image{ QFileInfo(path).fileName().toStdString(),
    std::make_shared<const std::string>(oversketch_files::uprightPicture(file.readAll().toStdString())) };
  ReadPicture read{ image, decoded(image.bytes) };
  if (!read.decoded->pixels)
  {
    throw oversketch_files::Failed(
      PictureTexts::tr("%1 is no PNG, JPEG, WebP, BMP or TIFF picture, or a damaged one.")
        .arg(path)
        .toStdString());
  }
  return read;
}

SharedPicture findDecoded(const std::string& bytes)
{
  const std::lock_guard<std::mutex> lock(heldMutex);
  return findHeld(bytes);
}

SharedPicture decoded(const PictureBytes& bytes)
{
  if (SharedPicture known = findDecoded(*bytes))
  {
    return known;
  }
  const auto made = std::make_shared<const DecodedPicture>(bytes); // meanwhile others may look
  const std::lock_guard<std::mutex> lock(heldMutex);
  const SharedPicture known = findHeld(*bytes);
  if (!known)
  {
    held.push_back(made);
  }
  return known ? known : made;
}

SharedPicture whenDecoded(QObject* context,
  const PictureBytes& bytes,
  const std::function<void(const SharedPicture&)>& then)
{
  if (SharedPicture known = findDecoded(*bytes))
  {
    return known;
  }
  QThreadPool::globalInstance()->start(
    [bytes, then, alive = QPointer<QObject>(context)]() mutable
    {
      const SharedPicture picture = decoded(bytes);
      picture->worn();
      QMetaObject::invokeMethod(
        QCoreApplication::instance(),
        [picture, then = std::move(then), alive]
        {
          if (alive)
          {
            then(picture);
          }
        },
        Qt::QueuedConnection);
    });
  return nullptr;
}

vtkSmartPointer<vtkImageData> opaquePicture(vtkImageData* picture)
{
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  const int parts = pixels ? pixels->GetNumberOfComponents() : 0; // of a pixel
  if (parts != 2 && parts != 4)
  {
    return picture;
  }
  const int* size = picture->GetDimensions();
  const std::vector<std::uint8_t> opaque =
    oversketch::opaqueOf({ pixels->GetPointer(0), size[0], size[1], parts }, oversketch::ThreadsOnly());
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(parts - 1);
  colours->SetNumberOfTuples(pixels->GetNumberOfTuples());
  std::copy(opaque.begin(), opaque.end(), colours->GetPointer(0));
  auto made = vtkSmartPointer<vtkImageData>::New();
  made->CopyStructure(picture);
  made->GetPointData()->SetScalars(colours);
  return made;
}

std::vector<SharedPicture> decodedOf(vtkPolyData* mesh)
{
  std::vector<SharedPicture> pictures;
  for (const std::string& bytes : mesh ? oversketch_files::picturesOf(mesh) : std::set<std::string>())
  {
    pictures.push_back(decoded(std::make_shared<const std::string>(bytes)));
    pictures.back()->worn();
  }
  return pictures;
}

} // namespace oversketch_studio
