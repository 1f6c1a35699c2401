#include "vtkOversketchJoin.h"

#include "Join/join.h"
#include "vtkOversketchAssemble.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchJoinedParts.h"
#include "vtkOversketchStepRunner.h"
#include "vtkOversketchWeld.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <limits>
#include <set>
#include <string>

using namespace oversketch;

namespace
{

// The mesh and a further one, with points in double precision and without what no joined body has.
vtkSmartPointer<vtkPolyData> partsOf(vtkPolyData* mesh, vtkPolyData* other)
{
  RequirePolygonsOnly(mesh);
  vtkNew<vtkPolyData> all;
  all->ShallowCopy(mesh);
  if (other && other->GetNumberOfPoints() > 0)
  {
    vtkNew<vtkOversketchAssemble> assemble;
    assemble->AddInputData(mesh);
    assemble->AddInputData(other);
    StepRunner(assemble, {}).Run();
    all->ShallowCopy(assemble->GetOutput());
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(all->GetPoints());
  all->SetPoints(points);
  all->GetPointData()->SetNormals(nullptr);
  all->GetCellData()->SetNormals(nullptr);
  DropHierarchy(all);
  return all;
}

// Number of each triangle's part, from 0 without gaps.
std::vector<int> numbersOf(vtkPolyData* mesh, const MeshData& welded)
{
  const Mesh& surface = welded.Surface();
  std::vector<int> numbers;
  if (vtkIntArray* parts = PartNumbers(mesh))
  {
    numbers.assign(parts->GetPointer(0), parts->GetPointer(0) + mesh->GetNumberOfPolys());
    const std::set<int> joined = JoinedParts(mesh); // are one body already
    for (int& number : numbers)
    {
      number = joined.count(number) > 0 ? *joined.begin() : number;
    }
    std::vector<int> known = numbers;
    sortUnique(known);
    for (int& number : numbers)
    {
      number = static_cast<int>(std::lower_bound(known.begin(), known.end(), number) - known.begin());
    }
    return numbers;
  }
  const Adjacency& adjacency = welded.Neighbours();
  boost::disjoint_sets_with_storage<> joined(surface.triangles.size());
  for (int e = 0; e < static_cast<int>(adjacency.edges.size()); ++e)
  {
    for (const int t : adjacency.trianglesAt(e))
    {
      joined.union_set(*adjacency.trianglesBegin(e), t);
    }
  }
  std::vector<int> numberOf(surface.triangles.size(), -1);
  int count = 0;
  for (int t = 0; t < surface.triangleCount(); ++t)
  {
    int& number = numberOf[joined.find_set(t)];
    number = number < 0 ? count++ : number;
    numbers.push_back(number);
  }
  return numbers;
}

// The body as a mesh that says where on the welded parts its corners lie (vtkOversketchRemesh).
vtkSmartPointer<vtkPolyData> meshOf(const Joined& joined)
{
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(joined.mesh.vertexCount());
  for (int v = 0; v < joined.mesh.vertexCount(); ++v)
  {
    points->SetPoint(v, joined.mesh.points[v].data());
  }
  mesh->SetPoints(points);
  mesh->SetPolys(CellsOf(joined.mesh.triangles));
  const int count = joined.mesh.triangleCount();
  const auto cells = NewArray<vtkIdTypeArray>("SourceCell", 3, count);
  const auto weights = NewArray<vtkDoubleArray>("SourceWeights", 9, count);
  const auto original = NewArray<vtkIdTypeArray>("OriginalCell", 1, count);
  for (int t = 0; t < count; ++t)
  {
    original->SetValue(t, joined.source[t]);
    const std::array<SurfacePoint, 3> corners = joined.cornersOf(t);
    for (int k = 0; k < 3; ++k)
    {
      cells->SetValue(3 * t + k, corners[k].triangle);
      std::copy(corners[k].weights.begin(), corners[k].weights.end(), weights->GetPointer(9 * t + 3 * k));
    }
  }
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ cells, weights, original })
  {
    mesh->GetCellData()->AddArray(array);
  }
  return mesh;
}

// Parts stay parts only where they wear pictures; then they are one body all the same.
void keepPictures(vtkPolyData* output)
{
  vtkNew<vtkFieldData> fields;
  bool wears = false;
  for (int i = 0; i < output->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = output->GetFieldData()->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    const bool ofPart =
      name.size() > 5 && name.compare(0, 4, "Part") == 0 && name[4] >= '0' && name[4] <= '9';
    const bool picture = ofPart && name.find(".Texture") != std::string::npos;
    wears |= picture;
    if (!ofPart || picture)
    {
      fields->AddArray(array);
    }
  }
  vtkIntArray* parts = PartNumbers(output);
  if (wears && parts)
  {
    std::vector<int> numbers(parts->GetPointer(0), parts->GetPointer(0) + parts->GetNumberOfTuples());
    sortUnique(numbers);
    fields->AddArray(ArrayOf<vtkIntArray>("Joined", numbers));
  }
  else
  {
    output->GetCellData()->RemoveArray("PartId");
  }
  output->SetFieldData(fields);
}

} // namespace

vtkStandardNewMacro(vtkOversketchJoin);

vtkOversketchJoin::vtkOversketchJoin()
{
  this->SetNumberOfInputPorts(2);
  DeclareInput(this, 1, { Port::Optional });
}

int vtkOversketchJoin::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  this->Found.clear();
  return this->RunOnMesh(inputs,
    outputs,
    [&](vtkPolyData* mesh, vtkPolyData* output)
    {
      RequireFinite(this->Width, "Width");
      if (this->Width < 0.0)
      {
        throw Error(Failure::BadRegion, "{Width} is %1; give a width of 0 or more.", this->Width);
      }
      const auto parts = partsOf(mesh, vtkPolyData::GetData(inputs[1]));
      const Weld weld(parts);
      const std::shared_ptr<const MeshData> welded = SharedMesh(weld.Welded());
      const std::vector<int> numbers = numbersOf(parts, *welded);
      const int count = 1 + *std::max_element(numbers.begin(), numbers.end());
      std::vector<int> charts = numbers;
      if (vtkDataArray* own = weld.Welded()->GetCellData()->GetArray("Chart"))
      {
        for (std::size_t t = 0; t < charts.size(); ++t)
        {
          charts[t] += count * static_cast<int>(own->GetComponent(static_cast<vtkIdType>(t), 0));
        }
      }
      const JoinOptions options{ static_cast<JoinKind>(this->Operation), this->Width, this->Bridge };
      const Joined joined = join({ welded->Surface(), numbers, charts }, options, ContextOf(this, 0.1, 0.9));
      const bool hasArrays = parts->GetPointData()->GetNumberOfArrays() > 0;
      weld.Transfer(parts, { meshOf(joined) }, output, hasArrays ? Weld::Seams::Split : Weld::Seams::Shared);
      keepPictures(output);
      this->Found = { { "parts", static_cast<vtkIdType>(count) },
        { "seam.sharpest_edge",
          this->Width > 0.0 ? joined.sharpest : std::numeric_limits<double>::quiet_NaN() } };
    });
}

vtkOversketchSystem::FigureList vtkOversketchJoin::Figures()
{
  return this->Found;
}

void vtkOversketchJoin::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Operation: "
     << (this->Operation == Join   ? "Join"
          : this->Operation == Cut ? "Cut"
                                   : "Common")
     << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Bridge: " << (this->Bridge ? "On" : "Off") << "\n";
}
