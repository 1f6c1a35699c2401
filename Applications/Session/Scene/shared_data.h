// A polydata that several threads hold and none changes; its points and cells may be those of a pipeline,
// which makes new ones and leaves these alone. VTK looks for garbage whenever a polydata's count falls,
// without a lock: copies of this are counted by themselves, and a pipeline is given a shallow copy of its
// own.
#ifndef oversketch_applications_session_scene_shared_data_h
#define oversketch_applications_session_scene_shared_data_h

#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <utility>

namespace oversketch_session
{

// A shallow copy with the same points, cells and arrays, for a pipeline that goes on with it: filters make
// new ones and change none that they have put out.
template <typename Data>
vtkSmartPointer<Data> shallowCopyOf(Data* data)
{
  auto copy = vtkSmartPointer<Data>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  return copy;
}

// Data that nobody else holds anything of.
inline vtkSmartPointer<vtkPolyData> deepCopyOf(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

class SharedData
{
public:
  SharedData() = default;
  // From here on the data must not be changed.
  SharedData(vtkSmartPointer<vtkPolyData> data)
  {
    if (data)
    {
      // Kept by the data and its points, for all who ask later.
      data->GetBounds();
      if (vtkPoints* points = data->GetPoints())
      {
        points->GetBounds();
        points->GetData()->GetRange(0);
      }
      this->Held = std::make_shared<const vtkSmartPointer<vtkPolyData>>(std::move(data));
    }
  }

  vtkPolyData* Get() const { return this->Held ? this->Held->Get() : nullptr; }
  operator vtkPolyData*() const { return this->Get(); }
  vtkPolyData* operator->() const { return this->Get(); }

  // An identity that stays the same while this is the same data.
  std::shared_ptr<const void> identity() const { return this->Held; }

  // A shallow copy, for a pipeline; null where there is nothing.
  vtkSmartPointer<vtkPolyData> own() const { return this->Held ? shallowCopyOf(this->Get()) : nullptr; }

private:
  std::shared_ptr<const vtkSmartPointer<vtkPolyData>> Held;
};

} // namespace oversketch_session
#endif
