#include "vtkOversketchSilhouette.h"

#include "Silhouette/extract.h"
#include "vtkOversketchCurveTools.h"
#include "vtkOversketchFilterTools.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

using namespace oversketch;

// What depends on the mesh alone, kept between views.
struct vtkOversketchSilhouette::Cache
{
  MeshKey Key;
  Mesh Surface;
  Adjacency Neighbours;
  std::vector<Vector3> Normals;
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

int vtkOversketchSilhouette::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
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
      const MeshKey key(input, { input->GetPointData()->GetNormals() });
      Cache& cache = *this->Internals;
      if (cache.Key != key)
      {
        cache.Key = MeshKey();
        cache.Surface = MeshOf(input);
        cache.Normals = NormalsOf(input, cache.Surface);
        cache.Neighbours = buildAdjacency(cache.Surface);
        cache.Key = key;
      }
      const std::vector<Curve> curves =
        extractSilhouette(cache.Surface, cache.Neighbours, cache.Normals, view);
      std::vector<double> dots;
      for (const Curve& curve : curves)
      {
        for (const CurvePoint& p : curve.points)
        {
          dots.push_back(p.normal.dot(view.towardsViewer(p.position).normalized()));
        }
      }
      WriteCurves(curves, dots, output);
    });
}

void vtkOversketchSilhouette::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
