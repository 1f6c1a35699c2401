// A line and a ring over the middle of a model, and the system over them. Header-only.
#ifndef oversketch_filters_edit_testing_edit_system_h
#define oversketch_filters_edit_testing_edit_system_h

#include "Harness/bits.h"
#include "Harness/edits.h"
#include "Harness/executions.h"
#include "Harness/shipped.h"
#include "Harness/strokes.h"
#include "vtkOversketchEdit.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace oversketch_test
{

struct EditSystem
{
  explicit EditSystem(vtkSmartPointer<vtkPolyData> model,
    const std::vector<Vector2>& line = lineOver(),
    const std::vector<Vector2>& ring = ringOver())
    : mesh(std::move(model))
    , view(frontOf(mesh))
    , reference(toStroke(line, view))
    , boundary(toStroke(ring, view))
  {
    this->filter->SetInputData(0, this->mesh);
    this->filter->SetReferenceData(this->reference);
    this->filter->SetBoundaryData(this->boundary);
  }
  vtkPolyData* run()
  {
    Ear ear(this->filter);
    this->filter->Update();
    EXPECT_EQ(this->filter->GetErrorCode(), 0u) << (ear.errors.empty() ? "" : ear.errors[0]);
    return this->filter->GetOutput();
  }
  double diagonal() const { return this->mesh->GetLength(); }
  void operate(const char* format, double share)
  {
    char text[128];
    std::snprintf(text, sizeof text, format, share * this->diagonal());
    this->filter->SetOperations(text);
  }
  vtkSmartPointer<vtkPolyData> mesh;
  View view;
  vtkSmartPointer<vtkPolyData> reference, boundary;
  vtkNew<vtkOversketchEdit> filter;
};

inline Vector3 placeOf(vtkPolyData* mesh, vtkIdType i)
{
  return Vector3(mesh->GetPoint(i));
}

// V - E + F, and no edge of more than two triangles.
inline int eulerNumber(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  std::set<vtkIdType> used;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    mesh->GetPolys()->GetCellAtId(t, ids);
    for (int k = 0; k < 3; ++k)
    {
      used.insert(ids->GetId(k));
      const int count = ++edges[std::minmax(ids->GetId(k), ids->GetId((k + 1) % 3))];
      EXPECT_LE(count, 2);
    }
  }
  return static_cast<int>(used.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(mesh->GetNumberOfPolys());
}

inline double distanceTo(vtkPolyData* curve, const Vector3& p)
{
  double least = HUGE_VAL;
  for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
  {
    least = std::min(least, (placeOf(curve, i) - p).norm());
  }
  return least;
}

using Steps = std::set<std::string>;

} // namespace oversketch_test
#endif
