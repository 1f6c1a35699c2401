// Which of several strokes act at once.
#include "vtkOversketchAugmentPipeline.h"

#include "Mesh/nearest.h"
#include "Mesh/view.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchFilterTools.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"

#include <algorithm>

using namespace oversketch;

namespace
{

// How near two segments come, 0 where they cross.
double Apart(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d)
{
  const auto side = [](const Vector2& p, const Vector2& q, const Vector2& r)
  { return (q - p).x() * (r - p).y() - (q - p).y() * (r - p).x(); };
  if (side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0)
  {
    return 0.0;
  }
  return std::min({ distanceToSegment(a, c, d),
    distanceToSegment(b, c, d),
    distanceToSegment(c, a, b),
    distanceToSegment(d, a, b) });
}

std::size_t SegmentCount(const DrawnLine& line)
{
  return line.Samples.size() - (line.Closed ? 0 : 1);
}

bool Meet(const DrawnLine& one, const DrawnLine& other, double near)
{
  for (std::size_t i = 0; i < SegmentCount(one); ++i)
  {
    const Vector2 &a = one.Samples[i], &b = one.Samples[(i + 1) % one.Samples.size()];
    for (std::size_t k = 0; k < SegmentCount(other); ++k)
    {
      const Vector2 &c = other.Samples[k], &d = other.Samples[(k + 1) % other.Samples.size()];
      if (Apart(a, b, c, d) < near)
      {
        return true;
      }
    }
  }
  return false;
}

bool SameView(vtkPolyData* strokes, vtkIdType one, vtkIdType other)
{
  for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
  {
    vtkDataArray* array = strokes->GetCellData()->GetArray(name);
    for (int c = 0; array && c < array->GetNumberOfComponents(); ++c)
    {
      if (array->GetComponent(one, c) != array->GetComponent(other, c))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

// Parallel lines are raised together: beside its neighbour each would else stand on that one's flank, and its
// crest lean over.
std::vector<vtkSmartPointer<vtkPolyData>> vtkOversketchAugment::Pipeline::PassesOf(vtkPolyData* strokes,
  const Vector3& centre,
  double radius) const
{
  constexpr double over = 1.0 / 3.0; // of a radius: as near as lines come that are meant to lie on each other
  const std::vector<DrawnLine> lines = ReadStrokes(strokes);
  std::vector<std::vector<vtkIdType>> groups;
  for (vtkIdType i = 0; i < strokes->GetNumberOfLines(); ++i)
  {
    const double near = over * radius / pixelSize(ViewOfStroke(strokes, i), centre);
    const auto beside = [&](vtkIdType k)
    {
      return SameView(strokes, i, k) &&
             !Meet(lines[static_cast<std::size_t>(i)], lines[static_cast<std::size_t>(k)], near);
    };
    const bool joins = this->Self->SketchMode == Surface && !this->Self->AsPublished && !groups.empty() &&
                       std::all_of(groups.back().begin(), groups.back().end(), beside);
    if (!joins)
    {
      groups.emplace_back();
    }
    groups.back().push_back(i);
  }
  std::vector<vtkSmartPointer<vtkPolyData>> passes;
  for (const std::vector<vtkIdType>& group : groups)
  {
    vtkNew<vtkAppendPolyData> append;
    for (const vtkIdType i : group)
    {
      append->AddInputData(StrokeAlone(strokes, i));
    }
    append->Update();
    passes.emplace_back(group.size() == 1 ? StrokeAlone(strokes, group[0]).Get() : append->GetOutput());
  }
  return passes;
}
