#include "vtkOversketchSilhouette.h"

#include "Silhouette/extract.h"
#include "vtkOversketchCurveTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

// What depends on the mesh alone, kept between views, and the last result.
struct vtkOversketchSilhouette::Cache
{
  std::shared_ptr<const MeshData> Data;
  std::unique_ptr<SilhouetteExtractor> Extractor; // of Data; made for the second view of a mesh
  KeptOutput Kept;

  std::vector<Curve> Extract(vtkPolyData* input, const View& view)
  {
    const std::shared_ptr<const MeshData> data = SharedMesh(input);
    if (data != this->Data)
    {
      this->Extractor.reset();
      this->Data = data;
      return extractSilhouette(data->Surface(), data->Neighbours(), data->Normals(), view);
    }
    if (!this->Extractor)
    {
      this->Extractor =
        std::make_unique<SilhouetteExtractor>(data->Surface(), data->Neighbours(), data->Normals());
    }
    return (*this->Extractor)(view);
  }
};

vtkStandardNewMacro(vtkOversketchSilhouette);

vtkOversketchSilhouette::vtkOversketchSilhouette()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(2);
}

vtkOversketchSilhouette::~vtkOversketchSilhouette() = default;

void vtkOversketchSilhouette::SetStrokeData(vtkPolyData* stroke)
{
  this->SetInputData(1, stroke);
}

int vtkOversketchSilhouette::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      if (input->GetNumberOfPoints() == 0)
      {
        return;
      }
      const View view = ViewOf(vtkPolyData::GetData(inputs[1]));
      Cache& cache = *this->Internals;
      cache.Kept.Provide(StepKey({ SurfaceKey(input) }, view, {}),
        output,
        [&](vtkPolyData* result)
        {
          ++this->ExtractionCount;
          WriteCurves(cache.Extract(input, view), view, result);
        });
    });
}

void vtkOversketchSilhouette::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ExtractionCount: " << this->ExtractionCount << "\n";
}
