// The box of a part over the model, with handles that put the part elsewhere.
#ifndef oversketch_applications_studio_tools_part_handles_h
#define oversketch_applications_studio_tools_part_handles_h

#include "part_drag.h"

#include "vtkNew.h"

#include <functional>
#include <optional>

class vtkActor2D;
class vtkCallbackCommand;
class vtkPolyData;

namespace oversketch_studio
{

class Viewport;

class PartHandles
{
public:
  explicit PartHandles(Viewport* view);
  ~PartHandles();

  // A drag has put the part there; `mergesIntoLast`: of the same drag as the last time. It was given up
  // (Escape).
  std::function<void(const oversketch_session::PartPlace& place, bool mergesIntoLast)> moved;
  std::function<void()> givenUp;

  // Shows the box of a part, or none.
  void show(const std::optional<oversketch_session::PartPlace>& place);
  // A frame begins: where the handles are seen in it.
  void follow();
  // For a picture without them.
  void setVisible(bool visible) { this->Visible = visible; }
  void setPixelRatio(double ratio);
  bool isHeld() const { return this->Held.has_value(); }

private:
  struct Drag
  {
    PartHandle handle;
    oversketch::Vector2 start;
    oversketch_session::PartPlace from;
    bool hasMoved = false;
  };

  void heard(unsigned long event);
  std::optional<PartHandle> handleAt(const oversketch::Vector2& place) const;
  void point(const std::optional<PartHandle>& handle); // the cursor

  Viewport* View;
  std::optional<oversketch_session::PartPlace> Place;
  std::optional<std::array<oversketch::Vector2, 6>> Seen;
  std::optional<Drag> Held;
  double Ratio = 1.0;
  bool Visible = true, Pointed = false;
  vtkNew<vtkPolyData> Lines, Corners, Depth;
  vtkNew<vtkActor2D> LineActor, CornerActor, DepthActor;
  vtkNew<vtkCallbackCommand> Observer;
};

} // namespace oversketch_studio
#endif
