#include "vtkOversketchSnake.h"

#include "Silhouette/snake.h"
#include "vtkOversketchCurveTools.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

struct vtkOversketchSnake::Cache
{
  std::shared_ptr<const MeshData> Data;
  KeptOutput Kept;
};

vtkStandardNewMacro(vtkOversketchSnake);

vtkOversketchSnake::vtkOversketchSnake()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(3);
}

vtkOversketchSnake::~vtkOversketchSnake() = default;

void vtkOversketchSnake::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* curves = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const View view = ViewOf(vtkPolyData::GetData(inputs[2]));
  Cache& cache = *this->Internals;
  cache.Kept.Provide(StepKey({ CurvesKey(curves), SurfaceKey(mesh) }, view, { this->Epsilon }),
    output,
    [&](vtkPolyData* result)
    {
      ++this->SmoothingCount;
      cache.Data = SharedMesh(mesh);
      const MeshData& data = *cache.Data;
      const CurveSet read = ReadCurves(curves, data.Surface().vertexCount(), "silhouette curves");
      WriteCurves(smoothSilhouette(read.Curves,
                    data.Surface(),
                    data.Neighbours(),
                    data.Normals(),
                    view,
                    this->Epsilon,
                    ContextOf(this)),
        view,
        result);
    });
}

void vtkOversketchSnake::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Epsilon: " << this->Epsilon << "\n"
     << indent << "SmoothingCount: " << this->SmoothingCount << "\n";
}
