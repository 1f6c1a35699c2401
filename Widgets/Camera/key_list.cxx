#include "key_list.h"

#include "camera_keys.h"

#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>

namespace oversketch
{

KeyList::KeyList()
{
  this->Actor->PickableOff();
  vtkTextProperty* look = this->Actor->GetTextProperty();
  look->SetFontFamilyToCourier();
  look->SetColor(1.0, 1.0, 1.0);
  look->SetBackgroundColor(0.1, 0.1, 0.1);
  look->SetBackgroundOpacity(0.75);
  look->SetVerticalJustificationToTop();
  this->Actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->Actor->SetPosition(0.01, 0.99);
}

KeyList::~KeyList() = default;

void KeyList::show(vtkRenderer* in, const std::string& text)
{
  if (this->In && this->In != in)
  {
    this->In->RemoveViewProp(this->Actor);
  }
  this->In = in;
  if (!in)
  {
    return;
  }
  this->Actor->SetInput(text.c_str());
  // As large as fits, up to a size that reads well.
  const auto [lines, columns] = extentOf(text);
  const int* size = in->GetSize();
  this->Actor->GetTextProperty()->SetFontSize(
    std::clamp(static_cast<int>(std::min(size[0] / (columns * 0.62), size[1] / (lines * 1.25))), 6, 14));
  in->AddViewProp(this->Actor);
}

} // namespace oversketch
