#include "picture_files.h"

#include "files.h"
#include "texture.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace oversketch_studio
{

namespace
{

struct Texts
{
  Q_DECLARE_TR_FUNCTIONS(PictureFiles)
};

// What has been decoded and not been asked for. Whose bytes are gone, as those of a work that was given up,
// goes when the next picture comes.
struct Ahead
{
  std::weak_ptr<const std::string> bytes;
  vtkSmartPointer<vtkImageData> pixels;
};
std::mutex aheadMutex;
std::vector<Ahead> ahead;

// Behind the lock.
vtkSmartPointer<vtkImageData> takeKept(const PictureBytes& bytes)
{
  vtkSmartPointer<vtkImageData> found;
  const auto isDone = [&](Ahead& one)
  {
    const PictureBytes of = one.bytes.lock();
    found = of && of == bytes ? one.pixels : found;
    return !of || of == bytes;
  };
  ahead.erase(std::remove_if(ahead.begin(), ahead.end(), isDone), ahead.end());
  return found;
}

} // namespace

QStringList pictureExtensions()
{
  return { "png", "jpg", "jpeg" };
}

ReadPicture readPicture(const QString& path)
{
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
  {
    throw oversketch_files::Failed(Texts::tr("%1: %2").arg(path, file.errorString()).toStdString());
  }
  const oversketch_session::Image image{ QFileInfo(path).fileName().toStdString(),
    std::make_shared<const std::string>(file.readAll().toStdString()) };
  const auto pixels = decodeAhead(image.bytes);
  if (!pixels)
  {
    throw oversketch_files::Failed(
      Texts::tr("%1 is no PNG or JPEG picture, or a damaged one.").arg(path).toStdString());
  }
  return { image, pixels };
}

vtkSmartPointer<vtkImageData> decodeAhead(const PictureBytes& bytes)
{
  vtkSmartPointer<vtkImageData> pixels = oversketch_files::pictureOf(*bytes);
  const std::lock_guard<std::mutex> lock(aheadMutex);
  takeKept(bytes);
  ahead.push_back({ bytes, pixels });
  return pixels;
}

vtkSmartPointer<vtkImageData> takeDecoded(const PictureBytes& bytes)
{
  vtkSmartPointer<vtkImageData> kept;
  {
    const std::lock_guard<std::mutex> lock(aheadMutex);
    kept = takeKept(bytes);
  }
  return kept ? kept : oversketch_files::pictureOf(*bytes);
}

} // namespace oversketch_studio
