#include "vtkOversketchStellarRefine.h"

#include "vtkOversketchFilterTools.h"

#include "Stellar/refine.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchStellarSource.h"
#include "vtkOversketchStellarTools.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

struct vtkOversketchStellarRefine::Cache
{
  StellarStep Step;
  std::shared_ptr<const Source> Surface; // held for the next stroke
  MeshKey NormalsOf;                     // a mesh that had none
  std::vector<Vector3> Normals;

  // Those of the base, which the next stroke asks for again.
  void GiveNormals(vtkPolyData* mesh, Forest& forest, const Context& context)
  {
    if (forest.hasBaseNormals)
    {
      return;
    }
    const MeshKey key = StellarKey(mesh);
    const std::size_t count = forest.vertices.size();
    if (this->Normals.size() == count && this->NormalsOf == key)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        forest.vertices[i].baseNormal = this->Normals[i];
      }
      forest.hasBaseNormals = true;
      return;
    }
    this->Normals.clear();
    needBaseNormals(forest, context);
    this->Normals.reserve(count);
    for (const Forest::Vertex& vertex : forest.vertices)
    {
      this->Normals.push_back(vertex.baseNormal);
    }
    this->NormalsOf = key;
  }
};

vtkStandardNewMacro(vtkOversketchStellarRefine);

vtkOversketchStellarRefine::vtkOversketchStellarRefine()
{
  this->SetNumberOfInputPorts(3);
  DeclareInput(this, 2, { Port::Optional });
}

void vtkOversketchStellarRefine::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const CurveStep step = CurveStepOf(this, inputs, outputs);
  if (!step.curves)
  {
    return;
  }
  const std::vector<double> values{ this->Radius,
    this->Sharpness,
    this->TargetEdgeLength,
    static_cast<double>(this->FineFoot),
    static_cast<double>(this->Distance),
    static_cast<double>(this->ConnectedOnly),
    static_cast<double>(this->SeedCurveFaces),
    static_cast<double>(this->MaximumGeneration),
    static_cast<double>(this->MaximumFaces) };
  const FeatureCurves curves = CurvesOf(step.curves);
  this->Kept<Cache>().Step.Provide(step,
    { SourceKey(step), MaskKey(step.mesh) },
    values,
    &curves,
    StellarStep::Motion::None,
    [&](const Forest& before)
    {
      ++this->RefineCount;
      RefineOptions options;
      options.radius = LengthOf(this->Radius, 0.03, before, "Radius");
      options.sharpness = this->Sharpness;
      options.targetEdgeLength = this->TargetEdgeLength;
      options.fineFoot = this->FineFoot;
      options.distance = this->Distance == Geodesic ? CurveDistance::Geodesic : CurveDistance::Straight;
      options.connectedOnly = this->ConnectedOnly;
      options.seedCurveFaces = this->SeedCurveFaces;
      options.maximumGeneration = this->MaximumGeneration;
      options.maximumFaces = this->MaximumFaces;
      options.staying = { MaskedPointsOf(step.mesh) };
      Forest forest = before.roomyCopy();
      this->Kept<Cache>().GiveNormals(step.mesh, forest, step.context);
      const Source source = SourceOf(step, before, this->Kept<Cache>().Surface);
      int sweeps = 0;
      forest = refine(std::move(forest), curves, options, source, step.context, &sweeps);
      this->Sweeps = sweeps;
      return forest;
    });
}

void vtkOversketchStellarRefine::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Sharpness: " << this->Sharpness << "\n";
  os << indent << "TargetEdgeLength: " << this->TargetEdgeLength << "\n";
  os << indent << "FineFoot: " << this->FineFoot << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "ConnectedOnly: " << this->ConnectedOnly << "\n";
  os << indent << "SeedCurveFaces: " << this->SeedCurveFaces << "\n";
  os << indent << "MaximumGeneration: " << this->MaximumGeneration << "\n";
  os << indent << "MaximumFaces: " << this->MaximumFaces << "\n";
  os << indent << "Sweeps: " << this->Sweeps << "\n";
  os << indent << "RefineCount: " << this->RefineCount << "\n";
}
