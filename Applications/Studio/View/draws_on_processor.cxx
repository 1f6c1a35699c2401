#include "draws_on_processor.h"

#include "vtkRenderWindow.h"

#include <cstring>

namespace oversketch_studio
{

bool drawsOnProcessor(vtkRenderWindow* window)
{
  const char* about = window->ReportCapabilities();
  return about && (std::strstr(about, "llvmpipe") || std::strstr(about, "softpipe"));
}

} // namespace oversketch_studio
