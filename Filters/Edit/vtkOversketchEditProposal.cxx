// Where a ring encloses no region that can be moved: one that does.
#include "vtkOversketchEditPipeline.h"

#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchEditCurves.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using namespace oversketch;

namespace
{

struct Circle
{
  Vector2 middle; // px
  double radius;
};

// Round all samples, in the middle of their box.
Circle circleRound(const std::vector<Vector2>& samples)
{
  Eigen::AlignedBox2d box;
  for (const Vector2& p : samples)
  {
    box.extend(p);
  }
  Circle circle{ box.center(), 0.0 };
  for (const Vector2& p : samples)
  {
    circle.radius = std::max(circle.radius, (p - circle.middle).norm());
  }
  return circle;
}

// In the view of a stroke.
void putCircle(const Circle& circle, vtkPolyData* view, vtkPolyData* ring)
{
  constexpr int count = 72;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(count + 1);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / count;
    lines->InsertCellPoint(points->InsertNextPoint(circle.middle[0] + circle.radius * std::cos(angle),
      circle.middle[1] + circle.radius * std::sin(angle),
      0.0));
  }
  lines->InsertCellPoint(0);
  ring->SetPoints(points);
  ring->SetLines(lines);
  for (vtkDataArray* array : ViewArraysOf(view))
  {
    ring->GetCellData()->AddArray(array);
  }
}

} // namespace

// From nearly as wide as the ring down to just round the line, in its view; of whole pixels, as it is told.
Message vtkOversketchEdit::Pipeline::CircleThatWouldDo(const Inputs& inputs)
{
  constexpr double widest = 0.9, narrowest = 1.1, step = 0.75;
  if (IsCurveOfEdit(inputs.Reference) || IsCurveOfEdit(inputs.Boundary))
  {
    return {};
  }
  const auto line = StrokeAlone(inputs.Reference, 0), drawn = StrokeAlone(inputs.Boundary, 0);
  const Circle round = circleRound(ReadStrokes(line).front().Samples);
  const double least = narrowest * round.radius;
  const double most = widest * circleRound(ReadStrokes(drawn).front().Samples).radius;
  vtkNew<vtkOversketchEdit> other;
  for (double radius = std::max(least, most); radius >= least && !this->Self->GetAbortExecute();
       radius *= step)
  {
    const Circle circle{ round.middle.array().round(), std::ceil(radius) };
    vtkNew<vtkPolyData> ring;
    putCircle(circle, line, ring);
    const bool does = other->Try(
      [&]
      {
        Inputs others = inputs;
        others.Reference = line;
        others.Boundary = ring;
        other->Inner->FeedMesh(others.Mesh);
        other->Inner->FeedEdit(others, "");
        other->Inner->RunToWeights(others);
        return true;
      });
    if (does)
    {
      return {
        "A circle of %1 px round (%2, %3) would do.", circle.radius, circle.middle[0], circle.middle[1]
      };
    }
  }
  return {};
}
