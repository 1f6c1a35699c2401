// The widgets of an edit, those that vtkOversketchEditWidget is over.
#ifndef oversketch_widgets_edit_edit_parts_h
#define oversketch_widgets_edit_edit_parts_h

#include "disc_window.h"
#include "vtkOversketchAreaSelectWidget.h"
#include "vtkOversketchAxisHandleWidget.h"
#include "vtkOversketchLayerHandleWidget.h"
#include "vtkOversketchProfilePlaneWidget.h"
#include "vtkOversketchRegionWidget.h"

#include "vtkNew.h"

#include <array>
#include <string>
#include <utility>

class vtkAlgorithm;
class vtkRenderer;

namespace oversketch
{

struct EditParts
{
  vtkNew<vtkOversketchRegionWidget> region;
  vtkNew<vtkOversketchAxisHandleWidget> axes;
  vtkNew<vtkOversketchLayerHandleWidget> layers;
  vtkNew<vtkOversketchAreaSelectWidget> areas;
  vtkNew<vtkOversketchProfilePlaneWidget> planes;
  DiscWindow disc;

  // Those over the model, in the order of the modes; all of them.
  std::array<vtkAbstractWidget*, 5> byMode()
  {
    return { this->region, this->axes, this->layers, this->areas, this->planes };
  }
  std::array<vtkAbstractWidget*, 7> all()
  {
    return { this->region,
      this->axes,
      this->layers,
      this->areas,
      this->planes,
      this->disc.layers(),
      this->disc.areas() };
  }
  // Shows what lassos hold over the model while others than their widget have the hand, or no more.
  void showAreas(vtkRenderer* renderer, bool show);
};

// Runs it. Whether that went well, and what it said, which is not printed.
std::pair<bool, Message> ranTold(vtkAlgorithm* system);

} // namespace oversketch
#endif
