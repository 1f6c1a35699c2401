#include "vtkOversketchStellarBase.h"

#include "Stellar/pairing.h"
#include "vtkOversketchSharedMesh.h"
#include "vtkOversketchStellarTools.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

using namespace oversketch;

struct vtkOversketchStellarBase::Cache
{
  StellarStep Step;
  std::shared_ptr<const Forest> Passed; // of an input that goes through, held for the next step
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

} // namespace

vtkOversketchStellarBase::vtkOversketchStellarBase()
  : Internals(new Cache)
{
}

vtkOversketchStellarBase::~vtkOversketchStellarBase() = default;

int vtkOversketchStellarBase::RequestData(vtkInformation*,
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
      RequirePolygonsOnly(input); // the key does not see other cells
      const Context context = ContextOf(this);
      Cache& cache = *this->Internals;
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
          vtkWarningMacro(<< "A new base is made, since this is no 4-8 mesh any more: " << error.what());
        }
      }
      if (cache.Passed)
      {
        output->ShallowCopy(input);
        return;
      }
      cache.Step.Provide(
        StepKey({ MeshKey(input) },
          { static_cast<double>(this->ImprovePairs), static_cast<double>(this->EagerPairs) }),
        input,
        output,
        [&]
        {
          ++this->BaseCount;
          PairingOptions options;
          options.improvePairs = this->ImprovePairs;
          options.eagerPairs = this->EagerPairs;
          const Mesh mesh = MeshOf(input);
          BaseMesh base = pairTriangles(mesh, options, context);
          this->Pairs = base.pairs;
          this->Unpaired = base.unpaired;
          StellarStep::Made made;
          made.origins = OriginsOfBase(base, mesh);
          made.forest = std::make_shared<const Forest>(std::move(base.forest));
          return made;
        });
    });
}

void vtkOversketchStellarBase::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImprovePairs: " << this->ImprovePairs << "\n";
  os << indent << "EagerPairs: " << this->EagerPairs << "\n";
  os << indent << "Pairs: " << this->Pairs << "\n";
  os << indent << "Unpaired: " << this->Unpaired << "\n";
  os << indent << "BaseCount: " << this->BaseCount << "\n";
}
