#include "vtkOversketchProfilePlanes.h"

#include "Matrix/operations.h"
#include "vtkOversketchEditTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace oversketch;

struct vtkOversketchProfilePlanes::Cache
{
  std::shared_ptr<const MeshData> Data; // keeps the shared mesh alive between runs
  KeptValue<CurveOnMesh> Reference;     // as the plane slides it stays
  KeptOutput Kept;

  const CurveOnMesh& CurveOf(vtkPolyData* mesh, vtkPolyData* curve)
  {
    const StepKey key({ MeshKey(mesh, { mesh->GetPointData()->GetNormals() }), WholeKey(curve) }, {});
    return this->Reference.Provide(key,
      [&]
      {
        this->Data = SharedMesh(mesh);
        return CurveOnMesh(curve, *this->Data);
      });
  }
};

vtkStandardNewMacro(vtkOversketchProfilePlanes);

namespace
{

// Squares with these normals, each within the other two axes.
void WriteSquares(const CurveFrame& frame, double halfSize, vtkPolyData* output)
{
  const Vector3 axes[3] = { frame.outward, frame.side, frame.along };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> squares;
  const auto planes = NewArray<vtkIntArray>("Plane");
  const auto normals = NewArray<vtkDoubleArray>("Normals", 3);
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 u = halfSize * axes[(k + 1) % 3], v = axes[k].cross(u);
    squares->InsertNextCell(4);
    for (const Vector3& corner : { Vector3(-u - v), Vector3(u - v), Vector3(u + v), Vector3(v - u) })
    {
      squares->InsertCellPoint(points->InsertNextPoint(Vector3(frame.origin + corner).data()));
    }
    planes->InsertNextValue(k);
    normals->InsertNextTuple(axes[k].data());
  }
  output->SetPoints(points);
  output->SetPolys(squares);
  output->GetCellData()->AddArray(planes);
  output->GetCellData()->SetNormals(normals);
}

} // namespace

void vtkOversketchProfilePlanes::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* curve = vtkPolyData::GetData(inputs[1]);
  RequireFinite(this->T, "T");
  Cache& cache = this->Kept<Cache>();
  const StepKey key({ MeshKey(mesh, { mesh->GetPointData()->GetNormals() }), WholeKey(curve) },
    { this->T, static_cast<double>(this->Frame) });
  cache.Kept.Provide(key,
    vtkPolyData::GetData(outputs),
    [&](vtkPolyData* result)
    {
      const CurveOnMesh& reference = cache.CurveOf(mesh, curve);
      const CurveFrame frame =
        this->Frame == Fitted ? reference.Frames.planesAt(this->T) : reference.Frames.at(this->T);
      WriteSquares(frame, mesh->GetLength(), result);
      WriteMatrix(result->GetFieldData(), "Frame", matrixOf(frame));
      const auto vertices = NewArray<vtkIdTypeArray>("MeshVertices", 3);
      const auto weights = NewArray<vtkDoubleArray>("MeshWeights", 3);
      const Binding binding = reference.PlaceAt(this->T);
      weights->InsertNextTuple(binding.weights.data());
      for (const int v : binding.vertices)
      {
        vertices->InsertNextValue(v);
      }
      result->GetFieldData()->AddArray(OneValue<vtkDoubleArray>("PlaneT", this->T));
      result->GetFieldData()->AddArray(vertices);
      result->GetFieldData()->AddArray(weights);
    });
}

void vtkOversketchProfilePlanes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "T: " << this->T << '\n';
  os << indent << "Frame: " << this->Frame << '\n';
}
