#include "vtkOversketchSilhouette.h"

#include "Silhouette/extract.h"
#include "vtkOversketchCurveTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

// Work that depends on the mesh alone, held for the next view, and the last result.
struct vtkOversketchSilhouette::Cache
{
  std::shared_ptr<const MeshData> Data;
  KeptOutput Kept;

  std::vector<Curve> Extract(vtkPolyData* input, const View& view)
  {
    this->Data = SharedMesh(input);
    return extractSilhouette(this->Data->Surface(), this->Data->Neighbours(), this->Data->Normals(), view);
  }
};

vtkStandardNewMacro(vtkOversketchSilhouette);

vtkOversketchSilhouette::vtkOversketchSilhouette()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(2);
}

vtkOversketchSilhouette::~vtkOversketchSilhouette() = default;

void vtkOversketchSilhouette::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const View view = ViewOf(vtkPolyData::GetData(inputs[1]));
  Cache& cache = *this->Internals;
  cache.Kept.Provide(StepKey({ SurfaceKey(input) }, view, {}),
    output,
    [&](vtkPolyData* result)
    {
      ++this->ExtractionCount;
      WriteCurves(cache.Extract(input, view), view, result);
    });
}

void vtkOversketchSilhouette::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ExtractionCount: " << this->ExtractionCount << "\n";
}
