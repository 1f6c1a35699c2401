#include "sharp_edges.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <cmath>

namespace oversketch_studio
{

namespace
{

constexpr double edge = 60.0;         // degrees between faces
constexpr double off = 40.0;          // between a face and the normal at a point of it, which an edge bends
constexpr double share = 0.08;        // of such faces: CAD models have over a half, animals up to 0.04
constexpr vtkIdType largest = 200000; // faces
constexpr vtkIdType looked = 10000;   // faces that are looked at, evenly among all
constexpr vtkIdType largestInHand = 20000; // that follow a hand

bool isSharp(vtkPolyData* mesh)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  const vtkIdType faces = mesh->GetNumberOfPolys();
  if (!normals || faces == 0 || faces > largest)
  {
    return false;
  }
  const double least = std::cos(vtkMath::RadiansFromDegrees(off));
  const vtkIdType step = std::max(vtkIdType{ 1 }, faces / looked);
  vtkIdType bent = 0, seen = 0;
  for (vtkIdType cell = 0; cell < faces; cell += step, ++seen)
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    mesh->GetPolys()->GetCellAtId(cell, count, points);
    double face[3];
    vtkPolygon::ComputeNormal(mesh->GetPoints(), static_cast<int>(count), points, face);
    for (vtkIdType i = 0; i < count; ++i)
    {
      double at[3];
      normals->GetTuple(points[i], at);
      if (vtkMath::Dot(at, face) < least * vtkMath::Norm(at))
      {
        ++bent;
        break;
      }
    }
  }
  return static_cast<double>(bent) > share * static_cast<double>(seen);
}

vtkSmartPointer<vtkPolyData> split(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SetFeatureAngle(edge);
  normals->SplittingOn();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

} // namespace

vtkSmartPointer<vtkPolyData> SharpEdges::look(vtkPolyData* mesh)
{
  this->Sharp = mesh && isSharp(mesh);
  return this->Sharp ? split(mesh) : vtkSmartPointer<vtkPolyData>(mesh);
}

vtkSmartPointer<vtkPolyData> SharpEdges::lookMoved(vtkPolyData* mesh) const
{
  const bool is = this->Sharp && mesh && mesh->GetNumberOfPolys() <= largestInHand;
  return is ? split(mesh) : vtkSmartPointer<vtkPolyData>(mesh);
}

} // namespace oversketch_studio
