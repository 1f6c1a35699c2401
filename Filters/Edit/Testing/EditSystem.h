// A line and a ring over the middle of a model, and the system over them. Header-only.
#ifndef EditSystem_h
#define EditSystem_h

#include "Harness/shipped.h"
#include "Harness/strokes.h"
#include "vtkOversketchEdit.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace oversketch_test
{

// The model from the front, upright, its box 500 px wide or high in a viewport of 800 x 600.
inline View frontOf(vtkPolyData* mesh)
{
  double box[6];
  mesh->GetBounds(box);
  const double size = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
  Eigen::Matrix4d eye = Eigen::Matrix4d::Identity(), p = Eigen::Matrix4d::Identity();
  eye.topRightCorner<3, 1>() = -0.5 * Vector3(box[0] + box[1], box[2] + box[3], box[4] + box[5]);
  eye(2, 3) -= 2.0 * size;
  p(0, 0) = 1000.0 / size / 800.0;
  p(1, 1) = 1000.0 / size / 600.0;
  p(2, 2) = -0.25 / size;
  return View(eye, p, 800, 600);
}

// A gentle S through the middle of the viewport, `length` px long.
inline std::vector<Vector2> lineOver(double length = 60.0, double rise = 0.0)
{
  std::vector<Vector2> samples;
  for (int i = 0; i <= 40; ++i)
  {
    const double s = i / 40.0 - 0.5;
    samples.emplace_back(400.0 + length * s, 300.0 + rise + 6.0 * std::sin(6.0 * s));
  }
  return samples;
}

inline std::vector<Vector2> ringOver(double radius = 55.0, double rise = 0.0)
{
  std::vector<Vector2> samples;
  for (int i = 0; i < 90; ++i)
  {
    const double a = 2.0 * pi * i / 90.0;
    samples.emplace_back(400.0 + 1.2 * radius * std::cos(a), 300.0 + rise + radius * std::sin(a));
  }
  return samples;
}

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

inline bool sameValues(vtkDataArray* a, vtkDataArray* b)
{
  return a && b && a->GetNumberOfValues() == b->GetNumberOfValues() && a->GetDataType() == b->GetDataType() &&
         std::memcmp(a->GetVoidPointer(0),
           b->GetVoidPointer(0),
           static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())) == 0;
}

// Points, polygons and arrays of points and cells, to the bit.
inline void expectSameBits(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_GT(a->GetNumberOfPolys(), 0);
  ASSERT_TRUE(sameValues(a->GetPoints()->GetData(), b->GetPoints()->GetData()));
  ASSERT_TRUE(identical(a, b));
  for (const bool ofPoints : { true, false })
  {
    vtkFieldData* left = ofPoints ? static_cast<vtkFieldData*>(a->GetPointData()) : a->GetCellData();
    vtkFieldData* right = ofPoints ? static_cast<vtkFieldData*>(b->GetPointData()) : b->GetCellData();
    ASSERT_EQ(left->GetNumberOfArrays(), right->GetNumberOfArrays());
    for (int i = 0; i < left->GetNumberOfArrays(); ++i)
    {
      EXPECT_TRUE(sameValues(left->GetArray(i), right->GetArray(left->GetArrayName(i))))
        << left->GetArrayName(i);
    }
  }
}

inline vtkSmartPointer<vtkPolyData> deepCopy(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
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

} // namespace oversketch_test
#endif
