// The hint that a person new to it sees on the shipped model: where to draw, dashed in the pen's colour, and
// a line of text above.
#ifndef oversketch_applications_studio_window_hint_h
#define oversketch_applications_studio_window_hint_h

#include "Stroke/polyline.h"

#include "vtkNew.h"

#include <string>
#include <vector>

class vtkActor2D;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

namespace oversketch_studio
{

// A line to be followed exactly: up one side of the limb that ends at the highest of the points, over a tip
// that stands further out, and down the other side; lengths in pixels of `ratio` each. Empty where there are
// no points.
oversketch::Polyline hintLine(const oversketch::Polyline& picture, double ratio);

// The shape of a tool's hint: that limb; a line on the body; a ring round that line.
enum class HintShape
{
  Limb,
  Line,
  Ring
};
oversketch::Polyline hintLine(HintShape shape, const oversketch::Polyline& picture, double ratio);

class Hint
{
public:
  Hint();
  ~Hint();

  void addTo(vtkRenderer* renderer);
  // Empty hides it.
  void setText(const std::string& text, HintShape shape = HintShape::Limb);
  const std::string& text() const { return this->Words; }
  void setVisible(bool visible);
  bool isVisible() const;
  void setDark(bool dark);
  // A place in the picture, in the screen's pixels from its lower left corner.
  struct Box
  {
    double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;
  };
  // Where it is in the picture of the mesh, the text within the picture and beside or under what else lies
  // over it; ratio: the screen's pixels a pixel as Qt counts them.
  void place(vtkRenderer* renderer, vtkPolyData* mesh, double ratio, const std::vector<Box>& taken);
  const Box& textBox() const { return this->Written; } // as it was placed

private:
  void placeText(vtkRenderer* renderer,
    const oversketch::Vector2& over,
    double ratio,
    const std::vector<Box>& taken);

  std::string Words;
  HintShape Shape = HintShape::Limb;
  Box Written;
  vtkNew<vtkTextActor> Text;
  vtkNew<vtkActor2D> Line;
  vtkNew<vtkPolyData> Dashes;
};

} // namespace oversketch_studio
#endif
