#include "vtkOversketchEnclose.h"

#include "Region/enclose.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

using namespace oversketch;

struct vtkOversketchEnclose::Cache
{
  std::shared_ptr<const MeshData> Data;
  StepKey Key;
  vtkSmartPointer<vtkUnsignedCharArray> Vertices, Faces; // null: nothing is kept
  Extract Patch;
  KeptOutput KeptPatch;
};

namespace
{

void writePatch(vtkPolyData* mesh, const Extract& extract, vtkPolyData* patch)
{
  vtkNew<vtkPoints> points;
  points->SetData(CarriedArray(mesh->GetPoints()->GetData(), extract.vertices));
  patch->SetPoints(points);
  patch->SetPolys(CellsOf(extract.mesh.triangles));
  patch->GetPointData()->CopyAllOn(); // global ids stay ids
  patch->GetCellData()->CopyAllOn();
  CopyElements(mesh->GetPointData(), extract.vertices, patch->GetPointData());
  CopyElements(mesh->GetCellData(), extract.triangles, patch->GetCellData());
  patch->GetPointData()->AddArray(ArrayOf<vtkIdTypeArray>("VertexId", extract.vertices));
  patch->GetFieldData()->PassData(mesh->GetFieldData());
}

} // namespace

vtkStandardNewMacro(vtkOversketchEnclose);

vtkOversketchEnclose::vtkOversketchEnclose()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

void vtkOversketchEnclose::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* reference = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* boundary = vtkPolyData::GetData(inputs[2]);
  Cache& cache = this->Kept<Cache>();
  cache.Data = SharedMesh(input);
  const StepKey key({ MeshKey(input), ChainsKey(reference), ChainsKey(boundary) }, {});
  if (!cache.Vertices || cache.Key != key)
  {
    cache.Vertices = nullptr;
    ++this->GrowthCount;
    const Mesh& mesh = cache.Data->Surface();
    const Enclosed enclosed = enclose(mesh,
      cache.Data->Neighbours(),
      ReadChain(reference, mesh.vertexCount(), "reference curve").Vertices,
      ReadChain(boundary, mesh.vertexCount(), "boundary curve").Vertices,
      ContextOf(this));
    cache.Patch = extractFaces(mesh, enclosed.faces, 1);
    cache.Faces = ArrayOf<vtkUnsignedCharArray>("EditRegion", enclosed.faces);
    cache.Vertices = ArrayOf<vtkUnsignedCharArray>("EditRegion", enclosed.vertices);
    cache.Key = key;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  output->ShallowCopy(input);
  output->GetPointData()->AddArray(cache.Vertices);
  output->GetCellData()->AddArray(cache.Faces);
  cache.KeptPatch.Provide(StepKey({ WholeKey(output) }, {}),
    vtkPolyData::GetData(outputs, 1),
    [&](vtkPolyData* patch) { writePatch(output, cache.Patch, patch); });
}

void vtkOversketchEnclose::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GrowthCount: " << this->GrowthCount << '\n';
}
