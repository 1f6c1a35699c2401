#include "raster.h"

#include "files.h"

#include <dlfcn.h>

namespace oversketch_files
{

std::string rasterFormatOf(const std::string& bytes)
{
  const auto begins = [&bytes](const std::string& with, std::size_t at = 0)
  { return bytes.compare(at, with.size(), with) == 0; };
  for (const char version : { '*', '+' }) // BigTIFF's is the latter
  {
    if (begins(std::string("II") + version + '\0') || begins(std::string("MM\0", 3) + version))
    {
      return "GTiff";
    }
  }
  if (begins("\x89PNG\r\n\x1a\n"))
  {
    return "PNG";
  }
  if (begins("BM"))
  {
    return "BMP";
  }
  return begins("RIFF") && bytes.size() > 8 && begins("WEBP", 8) ? "WEBP" : "";
}

const RasterReader& rasterReader()
{
  static const auto* const reader = []() -> const RasterReader*
  {
    // By its name, as other libraries are found. A sanitizer loads it in our place, and then the executable's
    // RPATH alone counts: their presets link without new dtags.
    void* const module = dlopen(OVERSKETCH_RASTER_MODULE, RTLD_NOW | RTLD_LOCAL);
    return module ? static_cast<const RasterReader*>(dlsym(module, "oversketch_raster_reader")) : nullptr;
  }();
  if (!reader)
  {
    throw Failed("TIFF, BMP, WebP and PNG of 16 bits cannot be read: the library " OVERSKETCH_RASTER_MODULE
                 ", or GDAL, cannot be loaded; install both again, or save the file as PNG of 8 bits");
  }
  return *reader;
}

} // namespace oversketch_files
