/**
 * @class vtkOversketchBackendFilter
 * @brief base of the filters that compute on an OpenCL device or on the host
 *
 * What runs there is said by the filter that derives from it. Results of the two may differ in their last
 * bits; each by itself is the same every time.
 *
 * @sa vtkOversketchShapeDiameter vtkOversketchMixtureRegion vtkOversketchVisibility vtkOversketchSystem
 */
#ifndef vtkOversketchBackendFilter_h
#define vtkOversketchBackendFilter_h

#include "Mesh/context.h"                // For KernelBackend
#include "OversketchFiltersCoreModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSCORE_EXPORT vtkOversketchBackendFilter : public vtkOversketchFilter
{
public:
  vtkAbstractTypeMacro(vtkOversketchBackendFilter, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum BackendType
  {
    Auto = 0,
    OpenCL = 1,
    Host = 2
  };

  ///@{
  /**
   * Where the work is done that can be done in more than one place: Auto (default) and OpenCL on the OpenCL
   * device where there is one, Host on the processor (rays by Embree). Where there is no device, or it fails,
   * the host does the work, with a warning. The environment variable OVERSKETCH_OPENCL=off hides the device.
   */
  void SetBackend(int backend);
  int GetBackend() const { return this->Backend; }
  void SetBackendToAuto() { this->SetBackend(Auto); }
  void SetBackendToOpenCL() { this->SetBackend(OpenCL); }
  void SetBackendToHost() { this->SetBackend(Host); }
  ///@}

  /**
   * Where the present result was computed: OpenCL or Host; Auto before the first one.
   */
  virtual int GetBackendUsed() { return this->BackendUsed; }

  /**
   * Name of a back end in files and on the command line: "auto", "opencl", or, for Host, "embree"
   * after the library that casts rays there; null beyond.
   */
  static const char* GetBackendWord(int backend);

protected:
  vtkOversketchBackendFilter() = default;
  ~vtkOversketchBackendFilter() override = default;

  // After a new choice.
  virtual void BackendChanged() {}

  // For kernels.
  oversketch::Backend KernelBackend() const { return static_cast<oversketch::Backend>(this->Backend); }
  void UsedBackend(oversketch::Backend used) { this->BackendUsed = static_cast<int>(used); }

private:
  int Backend = Auto;
  int BackendUsed = Auto;
};

#endif
