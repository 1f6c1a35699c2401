#include "vtkOversketchBackendFilter.h"

#include <algorithm>

static_assert(int(vtkOversketchBackendFilter::Auto) == int(oversketch::Backend::Auto) &&
                int(vtkOversketchBackendFilter::OpenCL) == int(oversketch::Backend::OpenCL) &&
                int(vtkOversketchBackendFilter::Host) == int(oversketch::Backend::Host),
  "the filters' numbers are the kernels'");

void vtkOversketchBackendFilter::SetBackend(int backend)
{
  backend = std::clamp<int>(backend, Auto, Host);
  if (backend != this->Backend)
  {
    this->Backend = backend;
    this->BackendChanged();
    this->Modified();
  }
}

const char* vtkOversketchBackendFilter::GetBackendWord(int backend)
{
  static const char* const words[] = { "auto", "opencl", "embree" };
  return backend >= Auto && backend <= Host ? words[backend] : nullptr;
}

void vtkOversketchBackendFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Backend: " << this->Backend << "\n";
  os << indent << "BackendUsed: " << this->GetBackendUsed() << "\n";
}
