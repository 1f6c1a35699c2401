// Curves on a canvas without the filters before them, and what to read of them, for the tests of this module.
#ifndef oversketch_filters_planar_testing_curve_shapes_h
#define oversketch_filters_planar_testing_curve_shapes_h

#include "Harness/drawing_shapes.h"
#include "Harness/promises.h"
#include "vtkOversketchDrawingTools.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"

namespace oversketch_test
{

// The curves of strokes on a canvas of 1024 x 1024 units, so that one is a pixel.
inline vtkSmartPointer<vtkPolyData> toCurves(const std::vector<DrawnStroke>& strokes,
  const Canvas& canvas = { Vector2::Zero(), Vector2(1024.0, 1024.0) })
{
  std::vector<CanvasStroke> curves;
  curves.reserve(strokes.size());
  for (const DrawnStroke& stroke : strokes)
  {
    curves.push_back({ stroke.points, stroke.closed });
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  WriteCurves(curves, canvas, result);
  return result;
}

inline std::vector<int> cellValues(vtkPolyData* curves, const char* name)
{
  std::vector<int> values;
  vtkDataArray* array = curves->GetCellData()->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(static_cast<int>(array->GetComponent(i, 0)));
  }
  return values;
}

// The topology of the paper's figure 6, and a hole beside: a body, a closed stroke in it with an open one
// inside, an open stroke, and another closed one.
inline std::vector<DrawnStroke> bodyWithFeatures()
{
  return { closedStroke(ringAt(500, 500, 400)),
    closedStroke(ringAt(350, 500, 120)),
    openStroke({ { 320, 470 }, { 350, 520 }, { 390, 530 } }),
    openStroke({ { 600, 300 }, { 650, 400 }, { 640, 600 } }),
    closedStroke(ringAt(700, 650, 60)) };
}

} // namespace oversketch_test
#endif
