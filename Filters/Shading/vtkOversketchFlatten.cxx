#include "vtkOversketchFlatten.h"

#include "Shading/flatten.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchShadingTools.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace oversketch;

// The last disc, and what it was made of.
constexpr int balancingRounds = 10; // at most; it ends where the disc is even

struct vtkOversketchFlatten::Cache
{
  StepKey Key;
  bool Made = false;
  std::vector<int> Numbers; // of the disc's points by the mesh's
  vtkSmartPointer<vtkPolyData> Disc;
  vtkSmartPointer<vtkDoubleArray> Coordinates; // of the mesh's points
};

vtkStandardNewMacro(vtkOversketchFlatten);

namespace
{

vtkSmartPointer<vtkDoubleArray> coordinateArray(vtkIdType points)
{
  auto array = NewArray<vtkDoubleArray>("DiscCoords", 2, points);
  array->Fill(-1.0);
  return array;
}

vtkSmartPointer<vtkPolyData> discOf(const InsidePatch& inside,
  const std::vector<Vector2>& places,
  vtkDoubleArray* meshCoordinates)
{
  auto disc = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto ids = NewArray<vtkIdTypeArray>("VertexId");
  const auto coordinates = coordinateArray(static_cast<vtkIdType>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const Vector2 uv = 0.5 * (places[i] + Vector2::Ones());
    points->InsertNextPoint(places[i][0], places[i][1], 0.0);
    ids->InsertNextValue(inside.Vertices[i]);
    coordinates->SetTuple(static_cast<vtkIdType>(i), uv.data());
    meshCoordinates->SetTuple(inside.Vertices[i], uv.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const Triangle& t : inside.Patch.triangles)
  {
    const vtkIdType corners[3] = { t[0], t[1], t[2] };
    triangles->InsertNextCell(3, corners);
  }
  disc->SetPoints(points);
  disc->SetPolys(triangles);
  disc->GetPointData()->AddArray(ids);
  disc->GetPointData()->SetTCoords(coordinates);
  return disc;
}

// The curve on the disc, each sample by itself.
void layOnDisc(vtkPolyData* curve,
  const std::vector<int>& chain,
  const std::vector<int>& numbers,
  vtkPolyData* disc,
  vtkPolyData* discCurve)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(curve->GetNumberOfPoints());
  for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, 0.0, 0.0, 0.0); // of no sample
  }
  vtkNew<vtkIdList> samples;
  curve->GetLines()->GetCellAtId(0, samples);
  for (vtkIdType i = 0; i < samples->GetNumberOfIds(); ++i)
  {
    const int number = numbers[chain[static_cast<std::size_t>(i) % chain.size()]];
    if (number < 0)
    {
      throw Error(Failure::BadStroke,
        "Point %1 of {the reference curve} lies outside {the boundary}; draw {the boundary} round all of it.",
        i);
    }
    points->SetPoint(samples->GetId(i), disc->GetPoint(number));
  }
  discCurve->ShallowCopy(curve);
  discCurve->SetPoints(points);
}

} // namespace

vtkOversketchFlatten::vtkOversketchFlatten()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

void vtkOversketchFlatten::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* reference = vtkPolyData::GetData(inputs[1]);
  const int rounds = this->AsPublished ? 0 : balancingRounds;
  const std::vector<int> chain = VerticesOnce(ReadChain(reference, mesh, "reference curve"));
  const StepKey key({ InsideKey(mesh) }, { static_cast<double>(this->AsPublished) });
  Cache& cache = this->Kept<Cache>();
  if (!cache.Made || cache.Key != key)
  {
    cache.Made = false; // so that nothing stale is left when making fails
    ++this->FlattenCount;
    InsidePatch inside = InsideOf(mesh, this->AsPublished);
    const std::vector<Vector2> places = flattened(inside.Patch, ContextOf(this), rounds);
    cache.Coordinates = coordinateArray(mesh->GetNumberOfPoints());
    cache.Disc = discOf(inside, places, cache.Coordinates);
    cache.Numbers = std::move(inside.Numbers);
    cache.Key = key;
    cache.Made = true;
  }
  layOnDisc(reference, chain, cache.Numbers, cache.Disc, vtkPolyData::GetData(outputs, 2));
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  output->ShallowCopy(mesh);
  output->GetPointData()->AddArray(cache.Coordinates);
  vtkPolyData::GetData(outputs, 1)->ShallowCopy(cache.Disc);
}

void vtkOversketchFlatten::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "FlattenCount: " << this->FlattenCount << "\n";
}
