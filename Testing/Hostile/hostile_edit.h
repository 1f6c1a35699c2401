// Lines and rings that nobody should draw, and what nobody should ask of the region between them.
// Header-only.
#ifndef oversketch_testing_hostile_hostile_edit_h
#define oversketch_testing_hostile_hostile_edit_h

#include "hostile_meshes.h"
#include "sound.h"

#include "Harness/region_data.h"
#include "Harness/strokes.h"
#include "vtkOversketchEdit.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"

#include <ctime>
#include <limits>

namespace oversketch_test
{

struct LineAndRing
{
  std::string name;
  vtkSmartPointer<vtkPolyData> line, ring;
};

// About a place of the picture, `length` px long.
inline std::vector<Vector2> lineAbout(const Vector2& at, double length = 60.0, int count = 41)
{
  std::vector<Vector2> samples;
  for (int i = 0; i < count; ++i)
  {
    const double s = static_cast<double>(i) / (count - 1) - 0.5;
    samples.emplace_back(at + Vector2(length * s, 6.0 * std::sin(6.0 * s)));
  }
  return samples;
}

inline std::vector<Vector2> ringAbout(const Vector2& at, double radius = 50.0, int count = 90)
{
  std::vector<Vector2> samples;
  for (int i = 0; i < count; ++i)
  {
    const double a = 2.0 * pi * i / count;
    samples.emplace_back(at + radius * Vector2(1.2 * std::cos(a), std::sin(a)));
  }
  return samples;
}

// The stroke with one number of an array of its view changed.
inline vtkSmartPointer<vtkPolyData> spoiltView(vtkSmartPointer<vtkPolyData> stroke,
  const char* array,
  int component,
  double value)
{
  stroke->GetCellData()->GetArray(array)->SetComponent(0, component, value);
  return stroke;
}

// The first is one that should stand.
inline std::vector<LineAndRing> hostileCurves(const Mesh& mesh, bool perspective)
{
  const View view = wholeView(mesh, perspective), other = wholeView(mesh, !perspective);
  const Vector2 at = frontOf(mesh, view), elsewhere = frontOf(mesh, other);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Eigen::Matrix4d behind = Eigen::Matrix4d::Identity(), askew = behind;
  behind(2, 3) = 1e3 * boundingDiagonal(mesh); // the eye has passed the model
  askew(0, 1) = 0.6;
  askew(1, 2) = -0.3;
  const View past(behind * view.viewTransform(), view.projectionTransform(), 800, 600);
  const View skewed(askew * view.viewTransform(), view.projectionTransform(), 800, 600);
  const Vector2 atSkewed = frontOf(mesh, skewed);
  std::vector<Vector2> eight, spiral, spoilt = lineAbout(at), spoiltRing = ringAbout(at);
  for (int i = 0; i < 120; ++i)
  {
    const double a = 2.0 * pi * i / 120.0;
    eight.emplace_back(at + Vector2(60.0 * std::sin(a), 45.0 * std::sin(2.0 * a)));
  }
  for (int i = 0; i < 100000; ++i)
  {
    const double s = i / 1e5;
    spiral.emplace_back(at + 50.0 * (1.0 - s) * Vector2(std::cos(40.0 * s), std::sin(40.0 * s)));
  }
  spoilt[7][0] = nan;
  spoiltRing[20][1] = nan;
  const auto both = [&](const char* name, const std::vector<Vector2>& line, const std::vector<Vector2>& ring)
  {
    return LineAndRing{ name, toStroke(line, view), toStroke(ring, view) };
  };
  const std::vector<Vector2> line = lineAbout(at), ring = ringAbout(at);
  return {
    both("line in a ring", line, ring),
    both("line outside", lineAbout(at + Vector2(150.0, 0.0)), ring),
    both("line across", lineAbout(at + Vector2(50.0, 0.0)), ring),
    both("line on the ring", { ring.begin(), ring.begin() + 30 }, ring),
    both("line and ring off the model", lineAbout({ -900.0, -900.0 }), ringAbout({ -900.0, -900.0 })),
    both("ring round everything", line, ringAbout({ 400.0, 300.0 }, 700.0)),
    both("ring round half", line, ringAbout(at, 190.0)),
    both("ring round one face", lineAbout(at, 3.0), ringAbout(at, 3.0)),
    both("figure eight", lineAbout(at, 40.0), eight),
    both("ring traced thrice", line, ringAbout(at, 50.0, 30)),
    both("line of two samples", lineAbout(at, 60.0, 2), ring),
    both("line of one place", { at, at, at }, ring),
    both("ring of two samples", line, ringAbout(at, 50.0, 2)),
    both("ring of three samples", lineAbout(at, 20.0), ringAbout(at, 50.0, 3)),
    both("100,000 samples", lineAbout(at, 60.0, 100000), ringAbout(at, 50.0, 100000)),
    both("a spiral for a ring", line, spiral),
    both("line that is not finite", spoilt, ring),
    both("ring that is not finite", line, spoiltRing),
    { "seen from past the model", toStroke(line, past), toStroke(ring, past) },
    { "seen askew", toStroke(lineAbout(atSkewed), skewed), toStroke(ringAbout(atSkewed), skewed) },
    { "line and ring in two views", toStroke(line, view), toStroke(ringAbout(elsewhere), other) },
    { "a view that is not finite",
      spoiltView(toStroke(line, view), "ViewTransform", 5, nan),
      toStroke(ring, view) },
    { "a view that is none", toStroke(line, view), spoiltView(toStroke(ring, view), "ViewTransform", 0, 0.0) }
  };
}

// What a run of the system on an input ended in: true for a sound mesh, false for one message.
inline bool soundOrRefused(vtkOversketchEdit* system, vtkPolyData* input, const Topology& topology)
{
  Ear ear(system);
  const std::clock_t start = std::clock();
  system->Update();
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, longestRun);
  if (system->GetErrorCode() != 0 || !ear.errors.empty())
  {
    EXPECT_EQ(ear.errors.size(), 1u) << (ear.errors.empty() ? "no message" : ear.errors.back());
    EXPECT_NE(system->GetErrorCode(), 0u);
    EXPECT_NE(system->GetErrorCode(), codeOf(Failure::Unexpected)) << ear.errors[0];
    for (int port = 0; port < 3; ++port)
    {
      EXPECT_EQ(system->GetOutput(port)->GetNumberOfPoints(), 0);
    }
    std::cout << (ear.errors.empty() ? "" : ear.errors[0]);
    return false;
  }
  vtkPolyData* output = system->GetOutput();
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    if (!Vector3(output->GetPoint(i)).allFinite())
    {
      ADD_FAILURE() << "point " << i << " is not finite";
      return true;
    }
  }
  EXPECT_GE(output->GetNumberOfPolys(), input->GetNumberOfPolys() / 2);
  const Topology made = topologyOf(output);
  EXPECT_TRUE(made == topology) << made.euler << " for " << topology.euler << ", " << made.borders
                                << " borders for " << topology.borders;
  for (int port = 1; port < 3; ++port)
  {
    vtkPolyData* curve = system->GetOutput(port);
    vtkDataArray* vertices = curve->GetPointData()->GetArray("VertexId");
    EXPECT_GT(curve->GetNumberOfPoints(), 1);
    for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
    {
      const double v = vertices->GetComponent(i, 0);
      EXPECT_TRUE(v < static_cast<double>(output->GetNumberOfPoints()));
      if (v >= 0.0)
      {
        EXPECT_EQ(Vector3(output->GetPoint(static_cast<vtkIdType>(v))), Vector3(curve->GetPoint(i)));
      }
    }
  }
  return true;
}

// A polyline in a plane, without a view.
inline vtkSmartPointer<vtkPolyData> flatCurve(const std::vector<Vector2>& samples)
{
  auto curve = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(samples.size()));
  for (const Vector2& p : samples)
  {
    lines->InsertCellPoint(points->InsertNextPoint(p[0], p[1], 0.0));
  }
  curve->SetPoints(points);
  curve->SetLines(lines);
  return curve;
}

inline vtkSmartPointer<vtkImageData> imageOf(int width, int height, int type, int components, double value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int k = 0; k < components; ++k)
      {
        image->SetScalarComponentFromDouble(x, y, 0, k, value);
      }
    }
  }
  return image;
}

} // namespace oversketch_test
#endif
