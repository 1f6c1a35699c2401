#include "camera_keys.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace oversketch
{
namespace
{

constexpr int largestLetters = 14, leastLetters = 6;

struct Key
{
  std::vector<std::string>
    symbols; // letters in lower case; digits as the US, British and German layouts have them
  CameraAction plain, shifted;
  std::string name, plainText, shiftedText;
};

// Those of the thesis's table; its prose has p pan in and n pan out.
const std::vector<Key>& keys()
{
  using A = CameraAction;
  const auto look = [](const char* axis, int i)
  {
    return Key{ { axis },
      { A::Look, 1, i },
      { A::Look, -1, i },
      axis,
      std::string("look along +") + axis,
      std::string("along -") + axis };
  };
  const auto turn = [](int i, const char* axis, const std::vector<std::string>& symbols)
  {
    return Key{ symbols,
      { A::Turn, 1, i },
      { A::Turn, -1, i },
      symbols[0],
      std::string("turn clockwise about ") + axis,
      "counter-clockwise" };
  };
  static const std::vector<Key> table{
    { { "r" }, { A::Spin, 1 }, { A::Spin, -1 }, "r", "spin counter-clockwise", "clockwise" },
    look("x", 0),
    look("y", 1),
    look("z", 2),
    turn(0, "x", { "1", "exclam", "kp_1", "kp_end" }),
    turn(1, "y", { "2", "at", "quotedbl", "kp_2", "kp_down" }),
    turn(2, "z", { "3", "numbersign", "sterling", "section", "kp_3", "kp_next", "kp_page_down" }),
    { { "w" }, { A::Reset }, { A::Reset }, "w", "back to the first view", "" },
    { { "c" }, { A::Center }, { A::Center }, "c", "centre on the mesh", "" },
    { { "h" }, { A::Spin, -1 }, { A::Pan, 1, 2 }, "h", "spin clockwise", "pan in" },
    { { "l" }, { A::Spin, 1 }, { A::Pan, -1, 2 }, "l", "spin counter-clockwise", "pan out" },
    { { "i" }, { A::Orbit, 1, 1 }, { A::Pan, 1, 1 }, "i", "rotate up", "pan up" },
    { { "m" }, { A::Orbit, -1, 1 }, { A::Pan, -1, 1 }, "m", "rotate down", "pan down" },
    { { "j" }, { A::Orbit, -1, 0 }, { A::Pan, -1, 0 }, "j", "rotate left", "pan left" },
    { { "k" }, { A::Orbit, 1, 0 }, { A::Pan, 1, 0 }, "k", "rotate right", "pan right" },
    { { "p" }, { A::Zoom, -1 }, { A::Pan, 1, 2 }, "p", "zoom out", "pan in" },
    { { "n" }, { A::Zoom, 1 }, { A::Pan, -1, 2 }, "n", "zoom in", "pan out" },
    { { "question", "f1" }, { A::ShowKeys }, { A::ShowKeys }, "? F1", "show or hide this list", "" },
    { { "q" }, { A::Quit }, { A::Quit }, "q", "quit", "" },
  };
  return table;
}

} // namespace

CameraAction cameraAction(const std::string& keySymbol, bool shift)
{
  std::string symbol = keySymbol;
  std::transform(symbol.begin(),
    symbol.end(),
    symbol.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Key& key : keys())
  {
    if (std::find(key.symbols.begin(), key.symbols.end(), symbol) != key.symbols.end())
    {
      return shift ? key.shifted : key.plain;
    }
  }
  return {};
}

std::string cameraHelp(bool drawing)
{
  std::string list =
    drawing ? "Mode: draw\nleft drag    draw\n" : "Mode: navigate\nleft drag    turn the model\n";
  list += "middle drag  turn    or Ctrl + left drag\n"
          "right drag   pan     or Shift + left drag\n"
          "wheel        zoom    or Ctrl + Shift + left drag\n";
  for (const Key& key : keys())
  {
    std::string line = key.name;
    line.resize(6, ' ');
    line += key.plainText;
    if (!key.shiftedText.empty())
    {
      line.resize(30, ' ');
      line += "Shift: " + key.shiftedText;
    }
    list += line + '\n';
  }
  return list;
}

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
