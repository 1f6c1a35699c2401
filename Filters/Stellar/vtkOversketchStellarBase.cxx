#include "vtkOversketchStellarBase.h"

#include "Stellar/clusters.h"
#include "Stellar/pairing.h"
#include "Stellar/refine.h"
#include "vtkOversketchSharedMesh.h"
#include "vtkOversketchStellarSource.h"
#include "vtkOversketchStellarTools.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

struct vtkOversketchStellarBase::Cache
{
  StellarStep Step;
  std::shared_ptr<const Forest> Passed;  // of an input that goes through, held for the next step
  vtkSmartPointer<vtkPolyData> Records;  // of output 1; null: none
  std::shared_ptr<const Source> Surface; // the same, held for the next step
};

vtkStandardNewMacro(vtkOversketchStellarBase);

namespace
{

Origins OriginsOfBase(const BaseMesh& base, const Mesh& mesh)
{
  Origins origins;
  const std::vector<Forest::Vertex>& vertices = base.forest.vertices;
  std::vector<int> triangleOf(vertices.size(), -1); // of a barycentre
  for (const Forest::Face& face : base.forest.faces)
  {
    origins.cellFrom.push_back(base.rootTriangle[face.root]);
  }
  for (std::size_t root = 0; root < base.rootCorners.size(); ++root)
  {
    triangleOf[base.rootCorners[root][0]] = base.rootTriangle[root];
  }
  for (int i = 0; i < static_cast<int>(vertices.size()); ++i)
  {
    origins.pointFrom.push_back(i < mesh.vertexCount() ? i : -1);
    const int* parents = vertices[i].parents;
    if (i >= mesh.vertexCount() && parents[0] < 0)
    {
      const Triangle& t = mesh.triangles[triangleOf[i]];
      origins.born.emplace_back(i, Binding{ { t[0], t[1], t[2] }, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } });
    }
    else if (i >= mesh.vertexCount())
    {
      origins.born.emplace_back(i, Binding::edge(parents[0], parents[1], 0.5));
    }
  }
  return origins;
}

// Places on the original of all points and cells of a forest that was made of a simplified mesh.
Origins OriginsOnSurface(const Forest& forest,
  const OriginalSurface& surface,
  const std::vector<int>& pointFrom)
{
  Origins origins;
  const auto bindingOf = [&](const SurfacePoint& at)
  {
    const Triangle& t = surface.records.faces[at.triangle];
    return Binding{ { t[0], t[1], t[2] }, at.weights };
  };
  for (int i = 0; i < static_cast<int>(forest.vertices.size()); ++i)
  {
    if (i < static_cast<int>(pointFrom.size()))
    {
      origins.pointFrom.push_back(pointFrom[i]);
      continue;
    }
    const Binding at = bindingOf(surface.at(forest.place(i)));
    origins.pointFrom.push_back(at.vertices[0]);
    origins.slid.emplace_back(i, at);
  }
  for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
  {
    Vector3 weights[3];
    forest.rootWeights(f, weights);
    const SourcePlace middle{
      forest.faces[f].root, (weights[0] + weights[1] + weights[2]) / 3.0, Vector3::Zero()
    };
    origins.cellFrom.push_back(surface.at(middle).triangle);
  }
  return origins;
}

} // namespace

void vtkOversketchStellarBase::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  RequirePolygonsOnly(input); // the key does not see other cells
  vtkPolyData* source = vtkPolyData::GetData(outputs, 1);
  source->Initialize(); // the pipeline passed field data
  const Context context = ContextOf(this);
  Cache& cache = this->Kept<Cache>();
  cache.Passed = nullptr;
  if (HasStellarArrays(input))
  {
    try
    {
      cache.Passed = SharedForest(input, context);
    }
    catch (const Error& error)
    {
      if (error.failure() == Failure::Cancelled)
      {
        throw;
      }
      Warn(this, { "A new base is made, since this is no 4-8 mesh any more: %1", error.message() });
    }
  }
  if (cache.Passed)
  {
    output->ShallowCopy(input);
    return;
  }
  std::vector<double> values{ static_cast<double>(this->ImprovePairs), static_cast<double>(this->Mode) };
  if (this->Mode == Simplified)
  {
    RequireFinite(this->MaximumError, "MaximumError");
    values.insert(
      values.end(), { static_cast<double>(this->TargetFaces), this->MaximumError, this->SourceTolerance });
  }
  cache.Step.Provide(StepKey({ MeshKey(input) }, values),
    input,
    output,
    [&]
    {
      ++this->BaseCount;
      cache.Records = nullptr;
      cache.Surface = nullptr;
      PairingOptions options;
      options.improvePairs = this->ImprovePairs;
      const Mesh mesh = MeshOf(input);
      if (this->Mode == Direct)
      {
        BaseMesh base = pairTriangles(mesh, options, context);
        this->Pairs = base.pairs;
        this->Unpaired = base.unpaired;
        StellarStep::Made made;
        made.origins = [found = OriginsOfBase(base, mesh)] { return found; };
        made.forest = std::make_shared<const Forest>(std::move(base.forest));
        return made;
      }
      ClusterOptions clusters;
      clusters.targetFaces = this->TargetFaces;
      clusters.maximumError = this->MaximumError;
      ClusterResult simplified = simplifyByClusters(mesh, clusters, ContextOf(this, 0.0, 0.7));
      BaseMesh base = pairTriangles(simplified.mesh, options, ContextOf(this, 0.7, 0.8));
      this->Pairs = base.pairs;
      this->Unpaired = base.unpaired;
      const auto surface = std::make_shared<const OriginalSurface>(OriginalSurface{
        std::move(simplified.original), sourceRoots(simplified.faceFrom, base, simplified.mesh) });
      const Source original = sourceOf(surface);
      putOnSource(base.forest, original);
      SourceOptions follow;
      follow.tolerance = LengthOf(this->SourceTolerance, 1e-3, base.forest, "SourceTolerance");
      StellarStep::Made made;
      made.forest = std::make_shared<const Forest>(
        refineToSource(base.forest, original, follow, ContextOf(this, 0.8, 1.0)));
      made.origins = [found = OriginsOnSurface(*made.forest, *surface, simplified.pointFrom)]
      { return found; };
      cache.Records = vtkSmartPointer<vtkPolyData>::New();
      cache.Surface = WriteSurface(surface, input, cache.Records);
      return made;
    });
  if (cache.Records)
  {
    source->ShallowCopy(cache.Records);
  }
}

void vtkOversketchStellarBase::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "TargetFaces: " << this->TargetFaces << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "SourceTolerance: " << this->SourceTolerance << "\n";
  os << indent << "ImprovePairs: " << this->ImprovePairs << "\n";
  os << indent << "Pairs: " << this->Pairs << "\n";
  os << indent << "Unpaired: " << this->Unpaired << "\n";
  os << indent << "BaseCount: " << this->BaseCount << "\n";
}
