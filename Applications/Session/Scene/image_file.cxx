#include "image_file.h"

#include "files.h"
#include "heights.h"
#include "texture.h"
#include "upright_picture.h"

#include <filesystem>

namespace oversketch_session
{

using namespace oversketch_files;

Image readImage(const std::string& path, SystemInput::Kind kind)
{
  requireReadable(path);
  Image image{ std::filesystem::path(path).filename().string(),
    std::make_shared<const std::string>(wholeFile(path)) };
  if (kind == SystemInput::Kind::Heights)
  {
    parseHeights(path, *image.bytes);
    return image;
  }
  image.bytes = std::make_shared<const std::string>(uprightPicture(*image.bytes));
  if (!pictureOf(*image.bytes))
  {
    throw Failed(path + ": is " + notAnUprightPicture);
  }
  return image;
}

} // namespace oversketch_session
