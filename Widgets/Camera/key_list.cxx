#include "key_list.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

namespace oversketch
{

namespace
{

constexpr int largestLetters = 14, leastLetters = 6;

} // namespace

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
  in->AddViewProp(this->Actor);
  // As large as fits beside the margin at each side, up to a size that reads well.
  const int* size = in->GetSize();
  const auto fits = [&]
  {
    double box[4];
    this->Actor->GetBoundingBox(in, box);
    return box[1] - box[0] <= 0.98 * size[0] && box[3] - box[2] <= 0.98 * size[1];
  };
  int letters = largestLetters;
  this->Actor->GetTextProperty()->SetFontSize(letters);
  while (in->GetRenderWindow() && letters > leastLetters && !fits())
  {
    this->Actor->GetTextProperty()->SetFontSize(--letters);
  }
}

} // namespace oversketch
