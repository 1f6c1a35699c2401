#include "vtkOversketchVisibility.h"

#include "Silhouette/visibility.h"
#include "vtkOversketchCurveTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

using namespace oversketch;

struct vtkOversketchVisibility::Cache
{
  std::shared_ptr<const MeshData> Data;
  KeptOutput Kept;
};

vtkStandardNewMacro(vtkOversketchVisibility);

vtkOversketchVisibility::vtkOversketchVisibility()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(3);
}

vtkOversketchVisibility::~vtkOversketchVisibility() = default;

void vtkOversketchVisibility::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* curves = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const View view = ViewOf(vtkPolyData::GetData(inputs[2]));
  VisibilityOptions options;
  options.rejoin = this->Rejoin;
  options.backend = this->KernelBackend();
  Cache& cache = *this->Internals;
  cache.Kept.Provide(
    StepKey(
      { CurvesKey(curves), SurfaceKey(mesh) }, view, { double(this->Rejoin), double(this->GetBackend()) }),
    output,
    [&](vtkPolyData* result)
    {
      ++this->TestCount;
      cache.Data = SharedMesh(mesh);
      const MeshData& data = *cache.Data;
      const CurveSet read = ReadCurves(curves, data.Surface().vertexCount(), "silhouette curves");
      const VisibilityResult found =
        findVisible(read.Curves, data.Surface(), data.Normals(), view, options, ContextOf(this));
      if (!found.warning.empty())
      {
        Warn(this, found.warning);
      }
      this->UsedBackend(found.used);
      std::vector<Curve> parts;
      for (const VisibilitySegment& segment : found.segments)
      {
        parts.push_back(segment.curve);
      }
      WriteCurves(parts, view, result);
      result->GetCellData()->AddArray(
        ArrayOf<vtkIntArray>("CurveId", found.segments, &VisibilitySegment::source));
      result->GetCellData()->AddArray(
        ArrayOf<vtkUnsignedCharArray>("Visible", found.segments, &VisibilitySegment::visible));
    });
}

void vtkOversketchVisibility::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rejoin: " << this->Rejoin << "\n" << indent << "TestCount: " << this->TestCount << "\n";
}
