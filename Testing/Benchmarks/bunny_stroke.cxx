#include "bunny_stroke.h"

#include "Harness/polydata.h"

#include "vtkOversketchOutline.h"
#include "vtkOversketchSilhouette.h"
#include "vtkOversketchSnake.h"
#include "vtkOversketchVisibility.h"

#include <algorithm>
#include <cmath>

namespace oversketch_bench
{

using namespace oversketch_test;

View bunnyView(double degrees)
{
  const double turn = degrees * pi / 180.0;
  // The diagonal of the box, 1, takes two thirds of the picture's height.
  return orthographicView({ std::sin(turn), 0.0, std::cos(turn) }, { 0, 1, 0 }, 400.0);
}

vtkSmartPointer<vtkPolyData> earStroke(vtkPolyData* bunny, double pixels)
{
  const View view = bunnyView();
  const auto lookedAt = toStroke({ { 0, 0 }, { 1, 1 } }, view);
  vtkNew<vtkOversketchSilhouette> silhouette;
  silhouette->SetInputData(0, bunny);
  silhouette->SetInputData(1, lookedAt);
  vtkNew<vtkOversketchSnake> snake;
  vtkNew<vtkOversketchVisibility> visibility;
  vtkAlgorithm* curves = silhouette;
  for (vtkPolyDataAlgorithm* step :
    { static_cast<vtkPolyDataAlgorithm*>(snake), static_cast<vtkPolyDataAlgorithm*>(visibility) })
  {
    step->SetInputConnection(0, curves->GetOutputPort());
    step->SetInputData(1, bunny);
    step->SetInputData(2, lookedAt);
    curves = step;
  }
  vtkNew<vtkOversketchOutline> outline;
  outline->SetInputData(0, bunny);
  outline->SetInputData(1, lookedAt);
  outline->SetInputConnection(2, curves->GetOutputPort());
  outline->Update();
  // The loop with the highest point, walked both ways from there.
  vtkDataArray* display = outline->GetOutput()->GetPointData()->GetArray("Display");
  vtkNew<vtkIdList> loop;
  vtkIdType best = -1;
  std::vector<Vector2> around;
  for (vtkIdType c = 0; c < outline->GetOutput()->GetNumberOfCells(); ++c)
  {
    outline->GetOutput()->GetCellPoints(c, loop);
    for (vtkIdType i = 0; i + 1 < loop->GetNumberOfIds(); ++i)
    {
      const vtkIdType id = loop->GetId(i);
      if (best < 0 || display->GetComponent(id, 1) > display->GetComponent(best, 1))
      {
        best = id;
        around.clear();
        const vtkIdType count = loop->GetNumberOfIds() - 1;
        for (vtkIdType k = 0; k < count; ++k)
        {
          const vtkIdType at = loop->GetId((i + k) % count);
          around.emplace_back(display->GetComponent(at, 0), display->GetComponent(at, 1));
        }
      }
    }
  }
  std::vector<Vector2> samples;
  const double reach = 80.0;
  const auto draw = [&](const Vector2& p, double length)
  { samples.emplace_back(p[0], p[1] + pixels * std::pow(std::cos(0.5 * pi * length / reach), 2)); };
  const std::size_t count = around.size();
  double length = 0.0;
  for (std::size_t k = 1; k < count && length < reach; ++k)
  {
    draw(around[count - k], length += (around[count - k] - around[(count - k + 1) % count]).norm());
  }
  std::reverse(samples.begin(), samples.end());
  draw(around[0], length = 0.0);
  for (std::size_t k = 1; k < count && length < reach; ++k)
  {
    draw(around[k], length += (around[k] - around[k - 1]).norm());
  }
  return toStroke(samples, view);
}

} // namespace oversketch_bench
