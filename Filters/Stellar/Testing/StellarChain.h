// The steps from a mesh to a feature, and meshes compared to the bit, for the tests of this module.
#ifndef oversketch_filters_stellar_testing_stellar_chain_h
#define oversketch_filters_stellar_testing_stellar_chain_h

#include "Harness/promises.h"
#include "Harness/saved.h"
#include "vtkOversketchStellarBase.h"
#include "vtkOversketchStellarDisplace.h"
#include "vtkOversketchStellarRefine.h"
#include "vtkOversketchStellarSimplify.h"
#include "vtkOversketchStellarSmooth.h"
#include "vtkOversketchStellarSnap.h"
#include "vtkOversketchSurfaceStroke.h"

#include "vtkCellLocator.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"

#include <cstring>

namespace oversketch_test
{

inline void expectSameArray(vtkAbstractArray* a, vtkAbstractArray* b)
{
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues()) << a->GetName();
  ASSERT_EQ(a->GetDataType(), b->GetDataType()) << a->GetName();
  EXPECT_EQ(std::memcmp(a->GetVoidPointer(0),
              b->GetVoidPointer(0),
              static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())),
    0)
    << a->GetName();
}

// Points, polygons and all arrays, to the bit.
inline void expectSameMesh(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_GT(a->GetNumberOfCells(), 0);
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  expectSameArray(a->GetPoints()->GetData(), b->GetPoints()->GetData());
  vtkNew<vtkIdList> left, right;
  for (vtkIdType i = 0; i < a->GetNumberOfCells(); ++i)
  {
    a->GetPolys()->GetCellAtId(i, left);
    b->GetPolys()->GetCellAtId(i, right);
    ASSERT_TRUE(std::equal(left->begin(), left->end(), right->begin(), right->end())) << "cell " << i;
  }
  const auto compare = [](vtkFieldData* x, vtkFieldData* y)
  {
    ASSERT_EQ(x->GetNumberOfArrays(), y->GetNumberOfArrays());
    for (int i = 0; i < x->GetNumberOfArrays(); ++i)
      expectSameArray(x->GetAbstractArray(i), y->GetAbstractArray(x->GetAbstractArray(i)->GetName()));
  };
  compare(a->GetPointData(), b->GetPointData());
  compare(a->GetCellData(), b->GetCellData());
  compare(a->GetFieldData(), b->GetFieldData());
}

// A copy that shares nothing, so that no forest is found for it.
inline vtkSmartPointer<vtkPolyData> cold(vtkPolyData* mesh)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(mesh);
  return copy;
}

const View frontView = perspectiveView(Vector3(0, 0, 4), Vector3(0, 1, 0), 40.0);

inline std::vector<Vector2> line(const Vector2& a, const Vector2& b, int count = 40)
{
  std::vector<Vector2> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    samples.emplace_back(a + (b - a) * i / (count - 1.0));
  return samples;
}

inline std::vector<Vector2> wave()
{
  std::vector<Vector2> samples = line({ 300, 300 }, { 500, 300 }, 60);
  for (Vector2& s : samples)
    s[1] += 40.0 * std::sin((s[0] - 300.0) / 30.0);
  return samples;
}

// A sphere with arrays of the user's: what a colour, a label and normals become can be told.
inline vtkSmartPointer<vtkPolyData> sphere(int levels = 3)
{
  const Mesh mesh = icosphere(levels);
  auto result = toPolyData(mesh, &mesh.points);
  vtkNew<vtkFloatArray> height;
  height->SetName("Z");
  for (const Vector3& p : mesh.points)
    height->InsertNextValue(static_cast<float>(p[2]));
  result->GetPointData()->AddArray(height);
  vtkNew<vtkIntArray> chart;
  chart->SetName("Triangle");
  for (int t = 0; t < mesh.triangleCount(); ++t)
    chart->InsertNextValue(t);
  result->GetCellData()->AddArray(chart);
  return result;
}

// How far each point is from a surface [model length].
class Surface
{
public:
  explicit Surface(vtkPolyData* mesh)
  {
    this->Shape->SetPoints(mesh->GetPoints());
    this->Shape->SetPolys(mesh->GetPolys());
    this->Locator->SetDataSet(this->Shape);
    this->Locator->BuildLocator();
  }
  double distance(const double* p)
  {
    double closest[3], squared = 0.0;
    vtkIdType cell = -1;
    int sub = 0;
    this->Locator->FindClosestPoint(p, closest, this->Found, cell, sub, squared);
    return std::sqrt(squared);
  }

private:
  vtkNew<vtkPolyData> Shape;
  vtkNew<vtkCellLocator> Locator;
  vtkNew<vtkGenericCell> Found;
};

// Base to simplification, connected, with a stroke on the base.
struct Chain
{
  explicit Chain(vtkPolyData* mesh, const std::vector<Vector2>& stroke = wave())
  {
    base->SetInputData(mesh);
    curves->SetInputData(toStroke(stroke, frontView));
    curves->SetMeshConnection(base->GetOutputPort());
    refine->SetInputConnection(0, base->GetOutputPort());
    snap->SetInputConnection(0, refine->GetOutputPort());
    smooth->SetInputConnection(0, snap->GetOutputPort());
    displace->SetInputConnection(0, smooth->GetOutputPort());
    simplify->SetInputConnection(0, displace->GetOutputPort());
    for (vtkPolyDataAlgorithm* step : steps())
      step->SetInputConnection(1, curves->GetOutputPort());
    refine->SetRadius(0.15);
    displace->SetRadius(0.15);
    displace->SetHeight(0.1);
    simplify->SetRadius(0.15);
  }
  std::vector<vtkPolyDataAlgorithm*> steps() const { return { refine, snap, smooth, displace, simplify }; }

  vtkNew<vtkOversketchStellarBase> base;
  vtkNew<vtkOversketchSurfaceStroke> curves;
  vtkNew<vtkOversketchStellarRefine> refine;
  vtkNew<vtkOversketchStellarSnap> snap;
  vtkNew<vtkOversketchStellarSmooth> smooth;
  vtkNew<vtkOversketchStellarDisplace> displace;
  vtkNew<vtkOversketchStellarSimplify> simplify;
};

} // namespace oversketch_test
#endif
