// A polydata of a few lines, such as a stroke with its view, packed: a history holds thousands of them, and a
// vtkPolyData takes some 20 kB whatever is in it. Ours, since VTK's marshalling (vtkCommunicator) gives the
// active arrays back before all others, and the bytes of a .vtp file take seven times as long to read: 0.09
// ms a stroke against 0.013.
#ifndef oversketch_applications_session_scene_lines_h
#define oversketch_applications_session_scene_lines_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

namespace oversketch_session
{

class Lines
{
public:
  Lines() = default;
  // Copies every bit of points, cells and arrays of numbers or texts.
  explicit Lines(vtkPolyData* data);

  // A new polydata each time, for whoever asks; null where there is nothing.
  vtkSmartPointer<vtkPolyData> own() const;

  explicit operator bool() const { return this->Held != nullptr; }
  // An identity that stays the same while these are the same lines.
  std::shared_ptr<const void> identity() const { return this->Held; }

private:
  std::shared_ptr<const std::string> Held;
};

} // namespace oversketch_session
#endif
