#include "picture_files.h"

#include "files.h"
#include "opaque_picture.h"
#include "pieces.h"
#include "texture.h"
#include "upright_picture.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QThreadPool>
#include <QTimer>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>

namespace oversketch_studio
{

namespace
{

struct PictureTexts
{
  Q_DECLARE_TR_FUNCTIONS(PictureFiles)
};

constexpr int lookTime = 10; // ms

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

void whenDecoded(QObject* context,
  const PictureBytes& bytes,
  const std::function<void(const SharedPicture&)>& then)
{
  struct Shared
  {
    std::atomic<bool> done{ false };
    SharedPicture picture;
  };
  const auto shared = std::make_shared<Shared>();
  QThreadPool::globalInstance()->start(
    [shared, bytes]
    {
      shared->picture = decoded(bytes);
      shared->picture->worn();
      shared->done = true;
    });
  auto* look = new QTimer(context); // which the thread may outlive
  QObject::connect(look,
    &QTimer::timeout,
    context,
    [shared, look, then]
    {
      if (shared->done)
      {
        look->stop();
        look->deleteLater();
        then(shared->picture);
      }
    });
  look->start(lookTime);
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
