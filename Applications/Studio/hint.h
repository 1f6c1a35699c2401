// What a person new to it sees on the shipped model: a line round the limb that ends highest and beyond its
// tip, dashed in the pen's colour, and a line of text above.
#ifndef oversketch_studio_hint_h
#define oversketch_studio_hint_h

#include "vtkNew.h"

#include <string>

class vtkActor2D;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

namespace oversketch_studio
{

class Hint
{
public:
  Hint();
  ~Hint();
  Hint(const Hint&) = delete;
  Hint& operator=(const Hint&) = delete;

  void addTo(vtkRenderer* renderer);
  // Empty hides it.
  void setText(const std::string& text);
  void setVisible(bool visible);
  bool isVisible() const;
  void setDark(bool dark);
  // Round the limb that ends highest in the picture of the mesh, the text within the picture; ratio: the
  // screen's pixels a pixel as Qt counts them.
  void place(vtkRenderer* renderer, vtkPolyData* mesh, double ratio);

private:
  vtkNew<vtkTextActor> Text;
  vtkNew<vtkActor2D> Line;
  vtkNew<vtkPolyData> Dashes;
};

} // namespace oversketch_studio
#endif
