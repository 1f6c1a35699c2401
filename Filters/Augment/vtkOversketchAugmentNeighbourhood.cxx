// Even triangles for lines that run over long thin ones.
#include "vtkOversketchAugmentPipeline.h"

#include "Stellar/quality.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchStellarCurves.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

using namespace oversketch;

namespace
{

// The share of long thin triangles (CurveNeighbourhood) that lines bear: scans and marching cubes stay below.
constexpr double bearable = 0.06;

// The mesh as vtkOversketchRemesh is to have it: edges of a length in the region.
void PutRegion(vtkPolyData* mesh, const std::vector<char>& region, double length, vtkPolyData* to)
{
  to->ShallowCopy(mesh);
  RemoveStellarArrays(to);
  to->GetPointData()->AddArray(ArrayOf<vtkUnsignedCharArray>("Region", region));
  to->GetFieldData()->AddArray(OneValue<vtkDoubleArray>("GuideLength", length));
}

// Whether vertices are on curves of a stroke that is not ended; the steps refuse such a mesh.
bool InAStroke(vtkPolyData* mesh)
{
  vtkDataArray* curve = mesh->GetPointData()->GetArray("CurveId");
  for (vtkIdType i = 0; curve && i < curve->GetNumberOfTuples(); ++i)
  {
    if (curve->GetComponent(i, 0) >= 0.0)
    {
      return true;
    }
  }
  return false;
}

} // namespace

void vtkOversketchAugment::Pipeline::LayCurves()
{
  const auto key = [this]
  {
    const vtkOversketchAugment* self = this->Self;
    return StepKey({ WholeKey(this->Mesh), WholeKey(this->Strokes) },
      { self->Radius, static_cast<double>(self->SketchMode), static_cast<double>(self->Base) });
  };
  const bool known = this->Evened->GetNumberOfPoints() > 0 && key() == this->EvenedKey;
  this->RunBase(known ? this->Evened : this->Mesh);
  this->RunCurves();
  if (known || this->Self->AsPublished || this->Base->GetOutput()->GetFieldData()->GetArray("TerrainGray") ||
      InAStroke(this->Base->GetOutput()))
  {
    return;
  }
  this->Evened->Initialize();
  const FeatureCurves curves = CurvesOf(this->Self->StageOutput(this->DrawnName()));
  const double done = this->Self->GetDone();
  const CurveNeighbourhood near =
    neighbourhoodOf(MeshOf(this->Mesh), curves, this->PassRadius, ContextOf(this->Self, done, done));
  if (near.thinShare <= bearable)
  {
    return;
  }
  double length = HUGE_VAL; // the radius of the finest feature, but for one finer than bisection is for
  for (const FeatureCurve& curve : curves)
  {
    length = std::min(length, curve.radius.value_or(this->PassRadius));
  }
  const std::vector<char> masked = MaskedPointsOf(this->Mesh);
  std::vector<char> region = near.vertices;
  for (std::size_t v = 0; v < masked.size(); ++v)
  {
    region[v] = region[v] && !masked[v];
  }
  PutRegion(this->Mesh, region, std::max(length, 0.125 * near.meanEdge), this->Uneven);
  this->Self->RunStage("Even");
  this->Evened->ShallowCopy(this->Self->StageOutput("Even"));
  this->Evened->GetPointData()->RemoveArray("Region");
  this->Evened->GetFieldData()->RemoveArray("GuideLength");
  for (const char* name : { "SourceCell", "SourceWeights" })
  {
    this->Evened->GetCellData()->RemoveArray(name);
  }
  this->EvenedKey = key();
  this->RunBase(this->Evened);
  this->RunCurves();
}
