#include "reflected_strokes.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace oversketch_session
{

namespace
{

using Matrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

Matrix matrixOf(vtkDataArray* array, vtkIdType cell)
{
  Matrix matrix;
  array->GetTuple(cell, matrix.data());
  return matrix;
}

vtkDataArray* arrayOf(vtkPolyData* strokes, const char* name, int components)
{
  vtkDataArray* array = strokes->GetCellData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == components &&
                    array->GetNumberOfTuples() == strokes->GetNumberOfCells();
  return fits ? array : nullptr;
}

} // namespace

vtkSmartPointer<vtkPolyData> withReflections(vtkPolyData* strokes, const MirrorPlane& plane)
{
  auto mirrored = vtkSmartPointer<vtkPolyData>::New();
  mirrored->DeepCopy(strokes);
  vtkDataArray* view = arrayOf(mirrored, "ViewTransform", 16);
  vtkDataArray* projection = arrayOf(mirrored, "ProjectionTransform", 16);
  vtkDataArray* size = arrayOf(mirrored, "ViewportSize", 2);
  if (!view || !projection || !size || mirrored->GetNumberOfLines() != mirrored->GetNumberOfCells())
  {
    return strokes;
  }
  Matrix across = Matrix::Identity();
  across(plane.axis, plane.axis) = -1.0;
  across(plane.axis, 3) = 2.0 * plane.offset;
  Matrix flipped = Matrix::Identity(); // left and right
  flipped(0, 0) = -1.0;
  std::vector<bool> done(static_cast<std::size_t>(mirrored->GetNumberOfPoints()), false);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mirrored->GetNumberOfCells(); ++cell)
  {
    view->SetTuple(cell, Matrix(flipped * matrixOf(view, cell) * across).data());
    projection->SetTuple(cell, Matrix(flipped * matrixOf(projection, cell) * flipped).data());
    const double width = size->GetComponent(cell, 0);
    mirrored->GetCellPoints(cell, ids);
    for (const vtkIdType id : *ids)
    {
      double place[3];
      mirrored->GetPoint(id, place);
      place[0] = width - place[0];
      if (!done[static_cast<std::size_t>(id)]) // a closed stroke may name its first point twice
      {
        mirrored->GetPoints()->SetPoint(id, place);
        done[static_cast<std::size_t>(id)] = true;
      }
    }
  }
  vtkNew<vtkAppendPolyData> both;
  both->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  both->AddInputData(strokes);
  both->AddInputData(mirrored);
  both->Update();
  return both->GetOutput();
}

} // namespace oversketch_session
