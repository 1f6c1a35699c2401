// Pictures, and drawings over them, for tests of filters. Header-only.
#ifndef oversketch_testing_harness_drawings_h
#define oversketch_testing_harness_drawings_h

#include "Harness/strokes.h"

#include "vtkImageData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <cstring>
#include <gtest/gtest.h>

namespace oversketch_test
{

// A picture of spacing 1 and origin 0 by the value of each channel, 0 to 255; with Array
// vtkUnsignedShortArray, 257 times that.
template <typename Array = vtkUnsignedCharArray>
vtkSmartPointer<vtkImageData> picture(int columns,
  int rows,
  int channels,
  const std::function<int(int x, int y, int channel)>& value)
{
  using Number = typename Array::ValueType;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns, rows, 1);
  vtkNew<Array> scalars;
  scalars->SetName("Colours");
  scalars->SetNumberOfComponents(channels);
  for (int y = 0; y < rows; ++y)
  {
    for (int x = 0; x < columns; ++x)
    {
      for (int c = 0; c < channels; ++c)
      {
        scalars->InsertNextValue(static_cast<Number>((sizeof(Number) == 2 ? 257 : 1) * value(x, y, c)));
      }
    }
  }
  image->GetPointData()->SetScalars(scalars);
  return image;
}

// A bright disc on dark ground.
inline vtkSmartPointer<vtkImageData> discPicture(int size, double radius, const Vector2& centre)
{
  return picture(
    size, size, 1, [&](int x, int y, int) { return (Vector2(x, y) - centre).norm() <= radius ? 220 : 30; });
}

// A parallel view of width x height px along -z over a rectangle of the plane.
inline View viewOver(const Vector2& corner, const Vector2& size, int width, int height)
{
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity(), projection = Eigen::Matrix4d::Identity();
  view(0, 3) = -corner[0] - 0.5 * size[0];
  view(1, 3) = -corner[1] - 0.5 * size[1];
  view(2, 3) = -1.0;
  projection(0, 0) = 2.0 / size[0];
  projection(1, 1) = 2.0 / size[1];
  projection(2, 2) = -1.0;
  return View(view, projection, width, height);
}

// The view that a picture has of itself: display px are its own.
inline View viewOfPicture(vtkImageData* image)
{
  const int* n = image->GetDimensions();
  const Vector2 spacing(image->GetSpacing());
  return viewOver(
    Vector2(image->GetOrigin()) - 0.5 * spacing, spacing.cwiseProduct(Vector2(n[0], n[1])), n[0], n[1]);
}

// Places of the plane as a view shows them [px].
inline std::vector<Vector2> seen(const std::vector<Vector2>& world, const View& view)
{
  std::vector<Vector2> display;
  display.reserve(world.size());
  for (const Vector2& p : world)
  {
    display.emplace_back(view.toDisplay(Vector3(p[0], p[1], 0.0)).head<2>());
  }
  return display;
}

inline std::vector<Vector2> ring(const Vector2& centre, double radius, int count)
{
  std::vector<Vector2> points;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * pi * i / count;
    points.emplace_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

template <typename Array = vtkDoubleArray>
vtkSmartPointer<Array> arrayOf(const char* name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(static_cast<typename Array::ValueType>(value));
  }
  return array;
}

// Points, polylines and all numbers of two polydata, to the bit.
inline void expectSameCurves(vtkPolyData* a, vtkPolyData* b)
{
  const auto same = [](vtkDataArray* x, vtkDataArray* y, const char* what)
  {
    ASSERT_TRUE(x && y) << what;
    ASSERT_EQ(x->GetNumberOfValues(), y->GetNumberOfValues()) << what;
    ASSERT_EQ(x->GetDataType(), y->GetDataType()) << what;
    EXPECT_EQ(std::memcmp(x->GetVoidPointer(0),
                y->GetVoidPointer(0),
                static_cast<std::size_t>(x->GetNumberOfValues() * x->GetDataTypeSize())),
      0)
      << what;
  };
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfLines(), b->GetNumberOfLines());
  same(a->GetPoints()->GetData(), b->GetPoints()->GetData(), "points");
  same(a->GetLines()->GetConnectivityArray(), b->GetLines()->GetConnectivityArray(), "ids");
  same(a->GetLines()->GetOffsetsArray(), b->GetLines()->GetOffsetsArray(), "polylines");
  for (const auto& [x, y] :
    { std::pair<vtkDataSetAttributes*, vtkDataSetAttributes*>(a->GetPointData(), b->GetPointData()),
      std::pair<vtkDataSetAttributes*, vtkDataSetAttributes*>(a->GetCellData(), b->GetCellData()) })
  {
    ASSERT_EQ(x->GetNumberOfArrays(), y->GetNumberOfArrays());
    for (int i = 0; i < x->GetNumberOfArrays(); ++i)
    {
      same(x->GetArray(i), y->GetArray(x->GetArrayName(i)), x->GetArrayName(i));
    }
  }
}

} // namespace oversketch_test
#endif
