// A line and a ring over the middle of a model, and the system over them. Header-only.
#ifndef EditSystem_h
#define EditSystem_h

#include "Harness/edits.h"
#include "Harness/shipped.h"
#include "Harness/strokes.h"
#include "vtkOversketchEdit.h"

#include "vtkCallbackCommand.h"
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

inline double distanceTo(vtkPolyData* curve, const Vector3& p)
{
  double least = HUGE_VAL;
  for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
  {
    least = std::min(least, (placeOf(curve, i) - p).norm());
  }
  return least;
}

// Executions of each step.
class Count
{
public:
  explicit Count(vtkOversketchEdit* system)
  {
    this->Told->SetClientData(this);
    this->Told->SetCallback([](vtkObject* caller, unsigned long, void* self, void*)
      { ++static_cast<Count*>(self)->Of[static_cast<vtkAlgorithm*>(caller)]; });
    for (int i = 0; i < system->GetNumberOfStages(); ++i)
    {
      const char* name = system->GetStage(i);
      this->Names[system->GetStep(name)] = name;
      system->GetStep(name)->AddObserver(vtkCommand::StartEvent, this->Told);
    }
  }
  // The steps that ran since the last call.
  std::set<std::string> Ran()
  {
    std::set<std::string> names;
    for (const auto& [step, count] : this->Of)
    {
      names.insert(this->Names[step]);
    }
    this->Of.clear();
    return names;
  }

private:
  vtkNew<vtkCallbackCommand> Told;
  std::map<vtkAlgorithm*, int> Of;
  std::map<vtkAlgorithm*, std::string> Names;
};

using Steps = std::set<std::string>;

} // namespace oversketch_test
#endif
