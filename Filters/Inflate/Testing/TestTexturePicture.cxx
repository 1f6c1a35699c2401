// What a drawing's surface looks like from the front, and with a picture of its own from behind.
#include "DrawingChain.h"
#include "Harness/interaction.h"
#include "vtkOversketchProjectTexture.h"

#include "vtkActor.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr int square = 64, side = 1024; // px of the checkerboard

int shade(int x, int y)
{
  return (x / square + y / square) % 2 ? 230 : 40;
}

// Of one px per world unit, from the canvas's corner on.
vtkSmartPointer<vtkImageData> checkerboard()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, 1);
  image->SetOrigin(0.5, 0.5, 0.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        image->SetScalarComponentFromDouble(x, y, 0, c, shade(x, y));
      }
    }
  }
  return image;
}

// The surface as it looks along z, from the front or from behind, unlit, one px for a unit.
vtkSmartPointer<vtkImageData> look(vtkPolyData* mesh, vtkImageData* image, bool fromBehind)
{
  Window window(side, side);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  actor->GetProperty()->LightingOff();
  window.renderer->AddActor(actor);
  vtkCamera* camera = window.camera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * side);
  camera->SetFocalPoint(0.5 * side, 0.5 * side, 0.0);
  camera->SetPosition(0.5 * side, 0.5 * side, fromBehind ? -2000.0 : 2000.0);
  window.renderer->ResetCameraClippingRange();
  window.window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window.window);
  grab->ReadFrontBufferOff();
  grab->Update();
  return grab->GetOutput();
}

struct Compared
{
  int pixels = 0, wrong = 0;
};

// All but the background, which is white, and what lies within 1 px of the lines between squares.
Compared compare(vtkImageData* seen)
{
  Compared result;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      const double value = seen->GetScalarComponentAsDouble(x, y, 0, 0);
      const auto inner = [](int at) { return at % square > 0 && at % square < square - 1; };
      if (value < 250.0 && inner(x) && inner(y))
      {
        ++result.pixels;
        result.wrong += std::abs(value - shade(x, y)) > 2.0;
      }
    }
  }
  return result;
}

} // namespace

TEST(C15_3, FromTheFrontItLooksLikeItsPicture)
{
  DrawingChain chain(Treatment::Fill, 3);
  const auto board = checkerboard();
  vtkNew<vtkOversketchProjectTexture> texture;
  texture->SetInputConnection(chain.Cut->GetOutputPort());
  texture->SetPictureData(board);
  texture->Update();
  const Compared front = compare(look(texture->GetOutput(), board, false));
  EXPECT_GT(front.pixels, 50000);
  EXPECT_EQ(front.wrong, 0);
  // From behind the picture of the back stands as it was taken.
  texture->SetBackPictureData(board);
  texture->Update();
  const Compared back = compare(look(texture->GetOutput(), board, true));
  EXPECT_EQ(back.pixels, front.pixels);
  EXPECT_EQ(back.wrong, 0);
  fact("C15_3",
    "a checkerboard of 64 px squares: " + std::to_string(front.pixels) + " pixels of the rendered front, " +
      std::to_string(front.wrong) +
      " of another shade than the picture's; of the back with a picture of its own " +
      std::to_string(back.wrong));
}
