#include "opaque_picture.h"

#include "vtkUnsignedCharArray.h"

#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <vector>

namespace oversketch_studio
{

namespace
{

constexpr unsigned char full = 250; // alpha of what is opaque
constexpr unsigned char half = 128; // below it nothing of a pixel's own colour is meant to be seen
constexpr int rim = 4;              // px: what is less opaque so near to nothing is its rim

// Of each pixel the number of one near it that is chosen, by two sweeps; -1 where none is chosen at all.
class Nearest
{
public:
  template <typename IsChosen>
  Nearest(int width, int height, const IsChosen& isChosen)
    : Width(width)
    , At(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1)
  {
    for (std::size_t i = 0; i < this->At.size(); ++i)
    {
      this->At[i] = isChosen(i) ? static_cast<int>(i) : -1;
    }
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        this->look(x, y, x - 1, y);
        for (int i = -1; i < 2 && y > 0; ++i)
        {
          this->look(x, y, x + i, y - 1);
        }
      }
      this->sweepBack(y);
    }
    for (int y = height - 1; y >= 0; --y)
    {
      for (int x = 0; x < width; ++x)
      {
        this->look(x, y, x - 1, y);
        for (int i = -1; i < 2 && y + 1 < height; ++i)
        {
          this->look(x, y, x + i, y + 1);
        }
      }
      this->sweepBack(y);
    }
  }
  int of(std::size_t pixel) const { return this->At[pixel]; }
  double squared(std::size_t pixel) const
  {
    const auto at = static_cast<int>(pixel);
    return this->squared(at % this->Width, at / this->Width, this->At[pixel]);
  }

private:
  void sweepBack(int y)
  {
    for (int x = this->Width - 2; x >= 0; --x)
    {
      this->look(x, y, x + 1, y);
    }
  }
  double squared(int x, int y, int pixel) const
  {
    const double dx = x - pixel % this->Width, dy = y - pixel / this->Width;
    return dx * dx + dy * dy;
  }
  void look(int x, int y, int besideX, int besideY)
  {
    if (besideX < 0 || besideX >= this->Width)
    {
      return;
    }
    int& own = this->At[static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Width) +
                        static_cast<std::size_t>(x)];
    const int other = this->At[static_cast<std::size_t>(besideY) * static_cast<std::size_t>(this->Width) +
                               static_cast<std::size_t>(besideX)];
    if (other >= 0 && (own < 0 || this->squared(x, y, other) < this->squared(x, y, own)))
    {
      own = other;
    }
  }

  int Width;
  std::vector<int> At;
};

} // namespace

vtkSmartPointer<vtkImageData> opaquePicture(vtkImageData* picture)
{
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  const int parts = pixels ? pixels->GetNumberOfComponents() : 0; // of a pixel
  if (parts != 2 && parts != 4)
  {
    return picture;
  }
  const int* size = picture->GetDimensions();
  const auto count = static_cast<std::size_t>(pixels->GetNumberOfTuples()),
             each = static_cast<std::size_t>(parts);
  const unsigned char* from = pixels->GetPointer(0);
  const auto alpha = [&](std::size_t pixel) { return from[each * pixel + each - 1]; };
  const Nearest opaque(size[0], size[1], [&](std::size_t pixel) { return alpha(pixel) >= full; });
  const Nearest nothing(size[0], size[1], [&](std::size_t pixel) { return alpha(pixel) < half; });
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(parts - 1);
  colours->SetNumberOfTuples(pixels->GetNumberOfTuples());
  unsigned char* to = colours->GetPointer(0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isRim = alpha(i) < full && nothing.of(i) >= 0 && nothing.squared(i) <= rim * rim;
    const std::size_t source = isRim && opaque.of(i) >= 0 ? static_cast<std::size_t>(opaque.of(i)) : i;
    std::copy_n(from + each * source, each - 1, to + (each - 1) * i);
  }
  auto made = vtkSmartPointer<vtkImageData>::New();
  made->CopyStructure(picture);
  made->GetPointData()->SetScalars(colours);
  return made;
}

} // namespace oversketch_studio
