// The stages from silhouette to visibility in a row, and what their tests ask of curves. Header-only.
#ifndef oversketch_filters_silhouette_testing_curve_chain_h
#define oversketch_filters_silhouette_testing_curve_chain_h

#include "Harness/promises.h"
#include "vtkOversketchSilhouette.h"
#include "vtkOversketchSnake.h"
#include "vtkOversketchVisibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace oversketch_test
{

const Vector3 axisY(0, 1, 0), axisZ(0, 0, 1);

struct CurveChain
{
  vtkSmartPointer<vtkPolyData> mesh, stroke;
  vtkNew<vtkOversketchSilhouette> silhouette;
  vtkNew<vtkOversketchSnake> snake;
  vtkNew<vtkOversketchVisibility> visibility;

  CurveChain(const Mesh& surface, const View& view, const std::vector<Vector3>* normals = nullptr)
    : mesh(toPolyData(surface, normals))
    , stroke(toStroke({ { 10, 10 }, { 20, 30 } }, view))
  {
    this->silhouette->SetInputData(this->mesh);
    this->silhouette->SetStrokeData(this->stroke);
    this->snake->SetInputConnection(this->silhouette->GetOutputPort());
    this->snake->SetMeshData(this->mesh);
    this->snake->SetStrokeData(this->stroke);
    this->visibility->SetInputConnection(this->snake->GetOutputPort());
    this->visibility->SetMeshData(this->mesh);
    this->visibility->SetStrokeData(this->stroke);
    this->visibility->SetBackendToHost();
  }
};

// A polyline of the output as point ids, the last one of a closed curve left out.
struct Line
{
  std::vector<vtkIdType> ids;
  bool closed;
};

inline Line lineOf(vtkPolyData* curves, vtkIdType cell)
{
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  curves->GetLines()->GetCellAtId(cell, size, ids);
  Line line{ std::vector<vtkIdType>(ids, ids + size), size > 2 && ids[0] == ids[size - 1] };
  if (line.closed)
  {
    line.ids.pop_back();
  }
  return line;
}

inline Vector3 pointAt(vtkPolyData* curves, vtkIdType i)
{
  Vector3 p;
  curves->GetPoint(i, p.data());
  return p;
}

inline std::set<int> supportOf(vtkPolyData* curves, vtkIdType i)
{
  std::set<int> support;
  for (int k = 0; k < 3; ++k)
  {
    support.insert(static_cast<int>(curves->GetPointData()->GetArray("MeshVertices")->GetComponent(i, k)));
  }
  return support;
}

inline double lengthOf(vtkPolyData* curves, const Line& line)
{
  double length = 0.0;
  for (std::size_t k = 0; k + (line.closed ? 0 : 1) < line.ids.size(); ++k)
  {
    length += (pointAt(curves, line.ids[(k + 1) % line.ids.size()]) - pointAt(curves, line.ids[k])).norm();
  }
  return length;
}

inline double totalLength(vtkPolyData* curves)
{
  double length = 0.0;
  for (vtkIdType cell = 0; cell < curves->GetNumberOfLines(); ++cell)
  {
    length += lengthOf(curves, lineOf(curves, cell));
  }
  return length;
}

inline int cellValue(vtkPolyData* curves, const char* name, vtkIdType cell)
{
  return static_cast<int>(curves->GetCellData()->GetArray(name)->GetComponent(cell, 0));
}

inline vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

// Points, lines and all arrays are equal bit for bit.
inline void expectSame(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfLines(), b->GetNumberOfLines());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(pointAt(a, i), pointAt(b, i)) << i;
  }
  for (vtkIdType cell = 0; cell < a->GetNumberOfLines(); ++cell)
  {
    ASSERT_EQ(lineOf(a, cell).ids, lineOf(b, cell).ids) << cell;
  }
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes *dataA = a->GetAttributes(association), *dataB = b->GetAttributes(association);
    ASSERT_EQ(dataA->GetNumberOfArrays(), dataB->GetNumberOfArrays());
    for (int k = 0; k < dataA->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* x = dataA->GetArray(k);
      vtkDataArray* y = dataB->GetArray(x->GetName());
      ASSERT_TRUE(y) << x->GetName();
      for (vtkIdType i = 0; i < x->GetNumberOfTuples(); ++i)
        for (int c = 0; c < x->GetNumberOfComponents(); ++c)
          ASSERT_EQ(x->GetComponent(i, c), y->GetComponent(i, c)) << x->GetName() << ' ' << i;
    }
  }
}

// As expectRefusal, of a step that reads curves, the mesh and the stroke.
template <typename Filter>
void expectRefusalOf(vtkPolyData* curves,
  vtkPolyData* mesh,
  vtkPolyData* stroke,
  Failure failure,
  const char* word)
{
  vtkNew<Filter> filter;
  filter->SetInputData(curves);
  filter->SetMeshData(mesh);
  filter->SetStrokeData(stroke);
  expectRefusal(filter, failure, word);
}

// No curves are no error, and give none.
template <typename Filter>
void expectNothingOfNoCurves(vtkPolyData* mesh, vtkPolyData* stroke)
{
  vtkNew<Filter> idle;
  Ear ear(idle);
  vtkNew<vtkPolyData> nothing;
  idle->SetInputData(nothing);
  idle->SetMeshData(mesh);
  idle->SetStrokeData(stroke);
  idle->Update();
  EXPECT_TRUE(ear.errors.empty());
  EXPECT_EQ(idle->GetOutput()->GetNumberOfPoints(), 0);
}

// Cancels `filter`, which has not run yet, then lets it run: it does what `other` does.
inline void expectCancelAndRetry(vtkPolyDataAlgorithm* filter, vtkPolyDataAlgorithm* other)
{
  other->Update();
  ASSERT_GT(other->GetOutput()->GetNumberOfPoints(), 0);
  expectCancel(filter);
  filter->Update();
  expectSame(other->GetOutput(), filter->GetOutput());
}

} // namespace oversketch_test
#endif
