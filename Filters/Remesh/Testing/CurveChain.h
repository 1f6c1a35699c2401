// Strokes as chains of edges, from filter to filter. Header-only.
#ifndef oversketch_filters_remesh_testing_curve_chain_h
#define oversketch_filters_remesh_testing_curve_chain_h

#include "Harness/mesh_curves.h"
#include "Harness/promises.h"
#include "Harness/strokes.h"
#include "vtkOversketchInsertCurve.h"
#include "vtkOversketchNurbsFit.h"
#include "vtkOversketchProjectCurve.h"

namespace oversketch_test
{

struct CurveChain
{
  vtkNew<vtkOversketchNurbsFit> Fit;
  vtkNew<vtkOversketchProjectCurve> Project;
  vtkNew<vtkOversketchInsertCurve> Insert;

  CurveChain(vtkPolyData* mesh, vtkPolyData* strokes)
  {
    this->Fit->SetInputData(strokes);
    this->Project->SetInputConnection(this->Fit->GetOutputPort());
    this->Project->SetMeshData(mesh);
    this->Insert->SetInputData(mesh);
    this->Insert->SetCurvesConnection(this->Project->GetOutputPort());
  }
};

// A curve of the filter as the kernel has it.
inline MeshCurve curveOfCell(vtkPolyData* curves, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  curves->GetLines()->GetCellAtId(cell, ids);
  MeshCurve curve;
  curve.closed = ids->GetId(0) == ids->GetId(ids->GetNumberOfIds() - 1);
  for (vtkIdType i = 0; i < ids->GetNumberOfIds() - curve.closed; ++i)
  {
    const vtkIdType id = ids->GetId(i);
    curve.vertices.push_back(
      static_cast<int>(curves->GetPointData()->GetArray("VertexId")->GetComponent(id, 0)));
    curve.parameters.push_back(curves->GetPointData()->GetArray("CurveT")->GetComponent(id, 0));
  }
  return curve;
}

} // namespace oversketch_test
#endif
