#include "vtkOversketchProxy.h"

#include "Mesh/weld.h"
#include "Remesh/proxy.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchProxy);

namespace
{

// The proxy, its points numbered as the mesh's, and whether some of those are one.
struct PlacedProxy
{
  Proxy made;
  bool welded = false;

  PlacedProxy(vtkPolyData* input, int triangles, const Context& context)
  {
    Mesh mesh = MeshOf(input);
    const std::vector<int> vertices = weldPoints(mesh.points);
    this->welded = !vertices.empty();
    if (!this->welded)
    {
      this->made = makeProxy(mesh, triangles, context);
      return;
    }
    mesh = weldedMesh(mesh, vertices);
    this->made = makeProxy(mesh, triangles, context);
    std::vector<int> firsts(mesh.points.size());
    for (std::size_t p = vertices.size(); p-- > 0;)
    {
      firsts[vertices[p]] = static_cast<int>(p);
    }
    this->made.pointFrom = valuesAt(firsts, this->made.pointFrom);
  }
};

vtkSmartPointer<vtkDoubleArray> placesOf(vtkPoints* points)
{
  auto origin = NewArray<vtkDoubleArray>("Origin", 3, static_cast<std::size_t>(points->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, origin->GetPointer(3 * i));
  }
  return origin;
}

} // namespace

void vtkOversketchProxy::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (input->GetNumberOfPolys() <= this->TargetTriangles)
  {
    MeshOf(input);
    output->ShallowCopy(input);
  }
  else
  {
    const PlacedProxy proxy(input, this->TargetTriangles, ContextOf(this));
    const std::vector<int>& from = proxy.made.pointFrom;
    vtkNew<vtkPoints> points;
    points->SetData(CarriedArray(input->GetPoints()->GetData(), from));
    output->SetPoints(points);
    output->SetPolys(CellsOf(proxy.made.mesh.triangles));
    vtkPointData* data = input->GetPointData();
    CarryArrays(data,
      output->GetPointData(),
      [&](vtkAbstractArray* array, bool normals)
      {
        const bool isOfSeams = array == data->GetTCoords() || (normals && proxy.welded);
        return isOfSeams ? nullptr : CarriedArray(array, from);
      });
  }
  output->GetPointData()->AddArray(placesOf(output->GetPoints()));
}

void vtkOversketchProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TargetTriangles: " << this->TargetTriangles << "\n";
}
