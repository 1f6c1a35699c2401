// A system over a model with strokes made over its middle, and meshes compared to the bit.
#ifndef oversketch_filters_augment_testing_augment_tools_h
#define oversketch_filters_augment_testing_augment_tools_h

#include "Harness/copies.h"
#include "Harness/shipped.h"
#include "vtkOversketchAugment.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

namespace oversketch_test
{

// The model from the front, upright, its box 500 px wide or high in a viewport of 800 x 600.
inline View viewOf(vtkPolyData* mesh, const Vector3& from = { 0, 0, 1 }, const Vector3& up = { 0, 1, 0 })
{
  double box[6];
  mesh->GetBounds(box);
  const Vector3 middle(0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]));
  const double size = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
  Eigen::Matrix4d shift = Eigen::Matrix4d::Identity(), eye = Eigen::Matrix4d::Identity();
  shift.topRightCorner<3, 1>() = -middle;
  const Vector3 z = from.normalized(), x = up.cross(z).normalized();
  eye.row(0).head<3>() = x;
  eye.row(1).head<3>() = z.cross(x);
  eye.row(2).head<3>() = z;
  eye(2, 3) = -2.0 * size;
  Eigen::Matrix4d p = Eigen::Matrix4d::Identity();
  p(0, 0) = 1000.0 / size / 800.0;
  p(1, 1) = 1000.0 / size / 600.0;
  p(2, 2) = -0.25 / size;
  return View(eye * shift, p, 800, 600);
}

// A wave through the middle of the viewport, `length` px long.
inline std::vector<Vector2> vein(double length = 120.0, double rise = 0.0)
{
  std::vector<Vector2> samples;
  for (int i = 0; i <= 40; ++i)
  {
    const double s = i / 40.0 - 0.5;
    samples.emplace_back(400.0 + length * s, 300.0 + rise + 8.0 * std::sin(9.0 * s));
  }
  return samples;
}

inline vtkSmartPointer<vtkPolyData> strokesOf(const std::vector<std::vector<Vector2>>& all, const View& view)
{
  auto strokes = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  strokes->SetPoints(points);
  strokes->SetLines(lines);
  for (const std::vector<Vector2>& samples : all)
  {
    const auto one = toStroke(samples, view);
    lines->InsertNextCell(static_cast<int>(samples.size()));
    for (const Vector2& s : samples)
    {
      lines->InsertCellPoint(points->InsertNextPoint(s[0], s[1], 0.0));
    }
    for (int a = 0; a < one->GetCellData()->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* from = one->GetCellData()->GetArray(a);
      if (vtkDataArray* to = strokes->GetCellData()->GetArray(from->GetName()))
      {
        to->InsertNextTuple(0, from);
      }
      else
      {
        strokes->GetCellData()->AddArray(from);
      }
    }
  }
  return strokes;
}

// A system over a shipped model.
struct System
{
  explicit System(vtkSmartPointer<vtkPolyData> model,
    const std::vector<std::vector<Vector2>>& drawn = { vein() })
    : mesh(std::move(model))
    , view(viewOf(mesh))
    , strokes(strokesOf(drawn, view))
  {
    this->filter->SetInputData(0, this->mesh);
    this->filter->SetStrokesData(this->strokes);
  }
  vtkPolyData* run()
  {
    this->filter->Update();
    EXPECT_EQ(this->filter->GetErrorCode(), 0u);
    return this->filter->GetOutput();
  }
  double diagonal() const
  {
    double box[6];
    this->mesh->GetCellsBounds(box);
    return Vector3(box[1] - box[0], box[3] - box[2], box[5] - box[4]).norm();
  }
  vtkSmartPointer<vtkPolyData> mesh;
  View view;
  vtkSmartPointer<vtkPolyData> strokes;
  vtkNew<vtkOversketchAugment> filter;
};

inline Vector3 pointOf(vtkPolyData* mesh, vtkIdType i)
{
  return Vector3(mesh->GetPoint(i));
}

// An arc over the model's outline near the middle of the picture, 12 px high.
inline std::vector<Vector2> overTheTop(const System& s)
{
  std::vector<Vector2> arc;
  for (double x = 380.0; x <= 440.0; x += 5.0)
  {
    double top = 0.0;
    for (vtkIdType i = 0; i < s.mesh->GetNumberOfPoints(); ++i)
    {
      const Vector3 d = s.view.toDisplay(pointOf(s.mesh, i));
      top = std::abs(d[0] - x) < 3.0 ? std::max(top, d[1]) : top;
    }
    arc.emplace_back(x, top - 1.0 + 12.0 * std::sin((x - 380.0) / 60.0 * pi));
  }
  return arc;
}

inline bool sameArray(vtkDataArray* a, vtkDataArray* b)
{
  if (!a || !b || a->GetNumberOfValues() != b->GetNumberOfValues() || a->GetDataType() != b->GetDataType())
  {
    return false;
  }
  return std::memcmp(a->GetVoidPointer(0),
           b->GetVoidPointer(0),
           static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())) == 0;
}

// Points, polygons and arrays, to the bit.
inline void expectSame(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_GT(a->GetNumberOfPolys(), 0);
  ASSERT_TRUE(identical(a, b)) << a->GetNumberOfPolys() << " " << b->GetNumberOfPolys();
  for (int k = 0; k < 3; ++k)
  {
    vtkFieldData* left = k == 0   ? static_cast<vtkFieldData*>(a->GetPointData())
                         : k == 1 ? static_cast<vtkFieldData*>(a->GetCellData())
                                  : a->GetFieldData();
    vtkFieldData* right = k == 0   ? static_cast<vtkFieldData*>(b->GetPointData())
                          : k == 1 ? static_cast<vtkFieldData*>(b->GetCellData())
                                   : b->GetFieldData();
    ASSERT_EQ(left->GetNumberOfArrays(), right->GetNumberOfArrays());
    for (int i = 0; i < left->GetNumberOfArrays(); ++i)
    {
      EXPECT_TRUE(sameArray(left->GetArray(i), right->GetArray(left->GetArrayName(i))))
        << left->GetArrayName(i);
    }
  }
}

} // namespace oversketch_test
#endif
