#include "vtkOversketchEditTools.h"

#include "Mesh/context.h"
#include "Stroke/polyline.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchFilterTools.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace oversketch
{

namespace
{

const char* const regionRemedy = "the filters of Filters/Shading make it";
const char* const handleRemedy = "make handles with vtkOversketchHandles";

Matrix4 matrixOf(vtkDataArray* array, vtkIdType tuple)
{
  Matrix4 matrix;
  for (int i = 0; i < 16; ++i)
  {
    matrix(i / 4, i % 4) = array->GetComponent(tuple, i);
  }
  return matrix;
}

} // namespace

CurveOnMesh::CurveOnMesh(vtkPolyData* curve, const MeshData& mesh)
  : Vertices(VerticesOnce(ReadChain(curve, mesh.Surface().vertexCount(), "reference curve")))
  , Points(valuesAt(mesh.Surface().points, this->Vertices))
  , Lengths(arcLengths(this->Points))
  , Frames(this->Points, valuesAt(mesh.Normals(), this->Vertices))
{
}

Binding CurveOnMesh::PlaceAt(double t) const
{
  const std::vector<double>& lengths = this->Lengths;
  const double length = t * lengths.back();
  const auto after = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
  const auto i = static_cast<std::size_t>(after - lengths.begin());
  const double step = lengths[i] - lengths[i - 1];
  const double share = step > 0.0 ? std::min(1.0, (length - lengths[i - 1]) / step) : 0.0;
  return Binding::edge(this->Vertices[i - 1], this->Vertices[i], 1.0 - share);
}

std::vector<double> ReadValues(vtkPolyData* mesh,
  const char* name,
  const std::vector<int>& vertices,
  double least)
{
  vtkDataArray* array =
    RequireArray(mesh->GetPointData(), name, 1, mesh->GetNumberOfPoints(), "mesh", regionRemedy);
  constexpr double rounding = 1e-6;
  auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(array);
  const double* own = doubles ? doubles->GetPointer(0) : nullptr; // quicker than to ask for each
  std::vector<double> values;
  values.reserve(vertices.size());
  for (const int v : vertices)
  {
    const double value = own ? own[v] : array->GetComponent(v, 0);
    if (!(value >= least - rounding && value <= 1.0 + rounding))
    {
      throw Error(Failure::BadRegion,
        "%1 of point %2 is %3, not within %4 and %5: %6.",
        name,
        v,
        value,
        least,
        1.0,
        regionRemedy);
    }
    values.push_back(std::clamp(value, least, 1.0));
  }
  return values;
}

void WriteMatrix(vtkFieldData* data, const char* name, const Matrix4& matrix)
{
  const auto array = NewArray<vtkDoubleArray>(name, 16, 1);
  for (int i = 0; i < 16; ++i)
  {
    array->SetComponent(0, i, matrix(i / 4, i % 4));
  }
  data->AddArray(array);
}

Matrix4 ReadMatrix(vtkFieldData* data, const char* name, const std::string& holder, const std::string& remedy)
{
  vtkDataArray* array = data->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == 16 && array->GetNumberOfTuples() == 1;
  if (!fits || !matrixOf(array, 0).allFinite())
  {
    throw Error(fits ? Failure::BadStroke : Failure::MissingArray,
      "The " + holder + " has no field array " + name + " of 16 finite numbers: " + remedy + ".");
  }
  return matrixOf(array, 0);
}

CurveFrame FrameOf(const Matrix4& matrix)
{
  return {
    matrix.col(3).head<3>(), matrix.col(0).head<3>(), matrix.col(1).head<3>(), matrix.col(2).head<3>()
  };
}

std::vector<double> ReadHandlePlaces(vtkPolyData* handles)
{
  const vtkIdType count = handles->GetNumberOfPoints();
  std::vector<double> places;
  if (count == 0)
  {
    return places;
  }
  vtkDataArray* array = RequireArray(handles->GetPointData(), "CurveT", 1, count, "handles", handleRemedy);
  for (vtkIdType i = 0; i < count; ++i)
  {
    places.push_back(array->GetComponent(i, 0));
    if (!(places.back() >= 0.0 && places.back() <= 1.0))
    {
      throw Error(Failure::BadStroke,
        "Handle %1 has a CurveT of %2, which is no place on the curve; give one from 0, where the curve "
        "begins, to "
        "1.",
        i,
        places.back());
    }
  }
  return places;
}

std::vector<Matrix4> ReadHandleMatrices(vtkPolyData* handles)
{
  const vtkIdType count = handles->GetNumberOfPoints();
  std::vector<Matrix4> matrices;
  if (count == 0)
  {
    return matrices;
  }
  vtkDataArray* array = RequireArray(handles->GetPointData(), "Matrix", 16, count, "handles", handleRemedy);
  for (vtkIdType i = 0; i < count; ++i)
  {
    matrices.push_back(matrixOf(array, i));
    const bool finite = matrices.back().allFinite();
    if (!finite || matrices.back().row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0))
    {
      throw Error(Failure::BadStroke,
        finite ? "The Matrix of handle %1 is a perspective: its last row is not 0 0 0 1; give an affine one."
               : "The Matrix of handle %1 is not finite; give one that is.",
        i);
    }
  }
  return matrices;
}

} // namespace oversketch
