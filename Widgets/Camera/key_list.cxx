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
  this->actor_->PickableOff();
  vtkTextProperty* look = this->actor_->GetTextProperty();
  look->SetFontFamilyToCourier();
  look->SetColor(1.0, 1.0, 1.0);
  look->SetBackgroundColor(0.1, 0.1, 0.1);
  look->SetBackgroundOpacity(0.75);
  look->SetVerticalJustificationToTop();
  this->actor_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->actor_->SetPosition(0.01, 0.99);
}

KeyList::~KeyList() = default;

void KeyList::show(vtkRenderer* in, const std::string& text)
{
  if (this->in_ && this->in_ != in)
  {
    this->in_->RemoveViewProp(this->actor_);
  }
  this->in_ = in;
  if (!in)
  {
    return;
  }
  this->actor_->SetInput(text.c_str());
  // As large as fits, up to a size that reads well.
  const auto [lines, columns] = extentOf(text);
  const int* size = in->GetSize();
  this->actor_->GetTextProperty()->SetFontSize(
    std::clamp(static_cast<int>(std::min(size[0] / (columns * 0.62), size[1] / (lines * 1.25))), 6, 14));
  in->AddViewProp(this->actor_);
}

} // namespace oversketch
