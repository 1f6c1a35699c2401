// The ways in which a saved 4-8 mesh stops to be one: arrays that were changed or dropped, cells reordered,
// points made anew, split or merged. Header-only.
#ifndef oversketch_testing_harness_spoilt_h
#define oversketch_testing_harness_spoilt_h

#include "Harness/copies.h"
#include "Harness/promises.h"

#include "vtkCleanPolyData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkTypeUInt64Array.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace oversketch_test
{

struct Spoilt
{
  std::function<void(vtkPolyData* mesh)> spoil; // in place; arrays of the mesh are its own
  oversketch::Failure failure;
  std::string words;      // of the message: what is wrong where
  const char* needs = ""; // a point array that the mesh is to have
};

inline void swapFirstCells(vtkPolyData* mesh)
{
  const auto before = deepCopy(mesh);
  vtkNew<vtkIdList> ids;
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    const vtkIdType from = i < 2 ? 1 - i : i;
    before->GetPolys()->GetCellAtId(from, ids);
    cells->InsertNextCell(ids);
    for (int a = 0; a < mesh->GetCellData()->GetNumberOfArrays(); ++a)
    {
      mesh->GetCellData()->GetArray(a)->SetTuple(i, from, before->GetCellData()->GetArray(a));
    }
  }
  mesh->SetPolys(cells);
}

// In cells and arrays alike: what a filter that makes points anew does.
inline void swapLastPoints(vtkPolyData* mesh)
{
  const auto before = deepCopy(mesh);
  const vtkIdType last = mesh->GetNumberOfPoints() - 1;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkCellArray> cells;
  const auto to = [last](vtkIdType i) { return i == last ? last - 1 : i == last - 1 ? last : i; };
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    before->GetPolys()->GetCellAtId(i, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      ids->SetId(k, to(ids->GetId(k)));
    }
    cells->InsertNextCell(ids);
  }
  mesh->SetPolys(cells);
  for (vtkIdType i = last - 1; i <= last; ++i)
  {
    mesh->GetPoints()->SetPoint(to(i), before->GetPoint(i));
    for (int a = 0; a < mesh->GetPointData()->GetNumberOfArrays(); ++a)
    {
      mesh->GetPointData()->GetArray(a)->SetTuple(to(i), i, before->GetPointData()->GetArray(a));
    }
  }
}

// The first cell gets points of its own, as filters do that make normals.
inline void splitFirstCell(vtkPolyData* mesh)
{
  vtkPointData* data = mesh->GetPointData();
  vtkNew<vtkIdList> ids;
  mesh->GetPolys()->GetCellAtId(0, ids);
  for (vtkIdType k = 0; k < 3; ++k)
  {
    const Vector3 place(mesh->GetPoint(ids->GetId(k)));
    const vtkIdType id = mesh->GetPoints()->InsertNextPoint(place.data());
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      data->GetArray(a)->InsertNextTuple(ids->GetId(k), data->GetArray(a));
    }
    ids->SetId(k, id);
  }
  mesh->GetPolys()->ReplaceCellAtId(0, ids);
}

// Points that lie near each other become one.
inline void cleanPoints(vtkPolyData* mesh)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(deepCopy(mesh));
  clean->SetTolerance(0.02);
  clean->ConvertPolysToLinesOff();
  clean->ConvertLinesToPointsOff();
  clean->Update();
  mesh->ShallowCopy(clean->GetOutput());
}

// All but points that were split: those of a mesh with texture are, see splitFirstCell.
inline std::vector<Spoilt> spoiltWays()
{
  using oversketch::Failure;
  const auto cell = [](const char* name, vtkIdType at, double value)
  { return [=](vtkPolyData* m) { m->GetCellData()->GetArray(name)->SetComponent(at, 0, value); }; };
  const auto point = [](const char* name, vtkIdType at, int component, double value)
  { return [=](vtkPolyData* m) { m->GetPointData()->GetArray(name)->SetComponent(at, component, value); }; };
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  std::vector<Spoilt> ways = { { cell("StellarRoot", 5, 99.0), Failure::BadMesh, "StellarRoot of cell 5" },
    { [](vtkPolyData* m) {
       vtkTypeUInt64Array::SafeDownCast(m->GetCellData()->GetArray("StellarPath"))
         ->SetValue(7, 3000000001ull);
     },
      Failure::BadMesh,
      "StellarPath of cell 7" },
    { cell("StellarGen", 3, 40.0), Failure::BadMesh, "StellarGen of cell 3" },
    { point("StellarMoved", 2, 0, 9.0), Failure::BadMesh, "StellarMoved of point 2" },
    { point("CurveId", 0, 0, -5.0), Failure::BadMesh, "CurveId of point 0" },
    { point("CurveParam", 4, 0, nan), Failure::BadMesh, "CurveParam of point 4" },
    { point("BaseNormal", 1, 2, infinite), Failure::BadMesh, "BaseNormal of point 1", "BaseNormal" },
    { point("Displacement", 1, 2, infinite), Failure::BadMesh, "Displacement of point 1", "Displacement" },
    { point("Feature", 1, 0, nan), Failure::BadMesh, "Feature of point 1", "Feature" },
    { [](vtkPolyData* m) { m->GetFieldData()->GetArray("StellarVersion")->SetComponent(0, 0, 2.0); },
      Failure::BadMesh,
      "StellarVersion" },
    { [](vtkPolyData* m) { m->GetFieldData()->RemoveArray("StellarVersion"); },
      Failure::MissingArray,
      "StellarVersion" },
    // A path that a filter made a real number of has lost its last digits.
    { [](vtkPolyData* m)
      {
        vtkNew<vtkDoubleArray> real;
        real->DeepCopy(m->GetCellData()->GetArray("StellarPath"));
        real->SetName("StellarPath");
        m->GetCellData()->AddArray(real);
      },
      Failure::BadMesh,
      "StellarPath" },
    { swapFirstCells, Failure::BadMesh, "reordered" },
    { swapLastPoints, Failure::BadMesh, "reordered" },
    { cleanPoints, Failure::BadMesh, "merged" } };
  for (const char* name : { "StellarRoot", "StellarPath", "StellarGen" })
  {
    ways.push_back(
      { [name](vtkPolyData* m) { m->GetCellData()->RemoveArray(name); }, Failure::MissingArray, name });
  }
  for (const char* name : { "StellarMoved", "CurveId", "CurveParam" })
  {
    ways.push_back(
      { [name](vtkPolyData* m) { m->GetPointData()->RemoveArray(name); }, Failure::MissingArray, name });
  }
  return ways;
}

} // namespace oversketch_test
#endif
