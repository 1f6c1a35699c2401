// Shapes that are drawn over a renderer's picture: lines, discs and plain shapes of any width and colour, in
// the order that they come in. Lines of the graphics library are of one width each, and of some drivers of
// one pixel.
#ifndef oversketch_widgets_edit_edit_overlay_h
#define oversketch_widgets_edit_edit_overlay_h

#include "Stroke/polyline.h"

#include "vtkNew.h"

#include <array>
#include <vector>

class vtkActor2D;
class vtkPolyData;
class vtkViewport;
class vtkWindow;

namespace oversketch
{

using Colour = std::array<unsigned char, 4>;

constexpr Colour strokeRed{ 219, 33, 31, 255 }, sectionBlue{ 41, 107, 242, 255 },
  regionOrange{ 250, 158, 51, 255 }, axisGreen{ 20, 145, 60, 255 }, paperWhite{ 255, 255, 255, 255 },
  inkGrey{ 60, 60, 66, 255 };

Polyline circle(const Vector2& centre, double radius, int corners);

class Overlay
{
public:
  Overlay();
  ~Overlay();

  void clear();
  // px from the viewport's lower left corner. A polygon is convex.
  void line(const Polyline& points, double width, const Colour& colour);
  void polygon(const Polyline& corners, const Colour& colour);
  // Lines with rims, which lie under all of them, so that they are seen before anything.
  void rimmed(const std::vector<Polyline>& lines,
    double width,
    const Colour& colour,
    const Colour& rim = paperWhite);
  // A profile: from orange at its first place to blue at its last, with a light rim.
  void profile(const std::vector<Polyline>& pieces, double width);
  void disc(const Vector2& centre, double radius, const Colour& colour);
  void knob(const Vector2& centre, double radius, const Colour& colour);

  int render(vtkViewport* viewport);
  void release(vtkWindow* window);

private:
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkActor2D> Actor;
};

} // namespace oversketch
#endif
