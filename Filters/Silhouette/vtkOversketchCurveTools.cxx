#include "vtkOversketchCurveTools.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace oversketch
{

void WriteCurves(const std::vector<Curve>& curves, const std::vector<double>& normalDotView, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdTypeArray> meshVertices;
  meshVertices->SetName("MeshVertices");
  meshVertices->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> meshWeights;
  meshWeights->SetName("MeshWeights");
  meshWeights->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> dots;
  dots->SetName("NormalDotView");
  for (const Curve& curve : curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.points.size()) + (curve.closed ? 1 : 0));
    const vtkIdType first = points->GetNumberOfPoints();
    for (const CurvePoint& p : curve.points)
    {
      dots->InsertNextValue(normalDotView[static_cast<std::size_t>(points->GetNumberOfPoints())]);
      lines->InsertCellPoint(points->InsertNextPoint(p.position.data()));
      for (int k = 0; k < 3; ++k)
      {
        meshVertices->InsertNextValue(p.binding.vertices[k]);
        meshWeights->InsertNextValue(p.binding.weights[k]);
      }
      normals->InsertNextTuple(p.normal.data());
    }
    if (curve.closed)
    {
      lines->InsertCellPoint(first);
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->AddArray(meshVertices);
  output->GetPointData()->AddArray(meshWeights);
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->AddArray(dots);
}

} // namespace oversketch
