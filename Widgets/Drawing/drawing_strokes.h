// The strokes of a drawing as the pen made them, each with its view: added, corrected, taken away.
#ifndef oversketch_widgets_drawing_drawing_strokes_h
#define oversketch_widgets_drawing_drawing_strokes_h

#include "Stroke/canvas.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkPolyData;

namespace oversketch
{

class DrawingStrokes
{
public:
  int count() const { return static_cast<int>(this->All.size()); }

  // All strokes, those of a polydata in the place of what there was; and into one, with cell arrays Magnetic,
  // SnapRadius and Treatment. Throws Error(BadStroke) for what are no strokes.
  void set(vtkPolyData* drawing);
  void putInto(vtkPolyData* drawing) const;

  // One more, with what the others say of their depth (cell arrays Depth, Height, CrossSection) at 0. radius:
  // half the corridor [px of the picture].
  void add(vtkPolyData* stroke, bool magnetic, double radius);
  void removeLast();

  // A stroke drawn over another one replaces a part of it (oversketch::corrected): samples outside the blends
  // stay as they are, the others are put where they were drawn as seen in the old stroke's view. Returns the
  // number of the corrected stroke, -1 where the new one corrects none.
  int correct(vtkPolyData* stroke, const Canvas& canvas);

  // 0 fill, 1 hole, 2 tunnel.
  int treatment(int stroke) const;
  void setTreatment(int stroke, int treatment);

private:
  std::vector<vtkSmartPointer<vtkPolyData>> All; // one polyline each, with the three arrays
};

} // namespace oversketch
#endif
