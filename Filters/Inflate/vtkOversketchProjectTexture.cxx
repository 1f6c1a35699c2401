#include "vtkOversketchProjectTexture.h"

#include "vtkOversketchFilterTools.h"

#include "Stroke/canvas.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchKept.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace oversketch;

struct vtkOversketchProjectTexture::Cache : KeptOutput
{
};

vtkStandardNewMacro(vtkOversketchProjectTexture);

namespace
{

// Gives faces of the back points of their own, and says of each face and point whether it is one of these.
std::vector<char> separateBack(vtkPolyData* mesh, vtkPolyData* result)
{
  RequirePolygonsOnly(mesh);
  const vtkIdType faces = mesh->GetNumberOfCells(), points = mesh->GetNumberOfPoints();
  vtkDataArray* sides = RequireArray(mesh->GetCellData(),
    "Side",
    1,
    faces,
    "mesh",
    "take it from vtkOversketchInflate or vtkOversketchExtrude, or give no picture of the back");
  const auto isBack = [&](vtkIdType face) { return sides->GetComponent(face, 0) < 0.0; };
  std::vector<char> shared(static_cast<std::size_t>(points), 0), back(static_cast<std::size_t>(points), 0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < faces; ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      (isBack(face) ? back : shared)[static_cast<std::size_t>(ids->GetId(k))] = 1;
    }
  }
  std::vector<vtkIdType> sources, twins(static_cast<std::size_t>(points));
  for (vtkIdType i = 0; i < points; ++i)
  {
    sources.push_back(i);
  }
  for (std::size_t i = 0; i < twins.size(); ++i)
  {
    twins[i] = static_cast<vtkIdType>(i);
    if (back[i] && shared[i])
    {
      twins[i] = static_cast<vtkIdType>(sources.size());
      sources.push_back(static_cast<vtkIdType>(i));
      back[i] = 0;
    }
  }
  back.resize(sources.size(), 1);
  vtkNew<vtkPoints> places;
  places->SetData(CarriedArray(mesh->GetPoints()->GetData(), sources));
  result->GetPointData()->CopyAllOn();
  CopyElements(mesh->GetPointData(), sources, result->GetPointData());
  vtkNew<vtkCellArray> polys;
  const auto parts = NewArray<vtkIntArray>("PartId");
  for (vtkIdType face = 0; face < faces; ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    for (vtkIdType k = 0; isBack(face) && k < ids->GetNumberOfIds(); ++k)
    {
      ids->SetId(k, twins[static_cast<std::size_t>(ids->GetId(k))]);
    }
    polys->InsertNextCell(ids);
    parts->InsertNextValue(isBack(face) ? 1 : 0);
  }
  result->SetPoints(places);
  result->SetPolys(polys);
  result->GetCellData()->ShallowCopy(mesh->GetCellData());
  result->GetCellData()->AddArray(parts);
  result->GetFieldData()->PassData(mesh->GetFieldData());
  return back;
}

} // namespace

vtkOversketchProjectTexture::vtkOversketchProjectTexture()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(3);
  DeclareInput(this, 1, { Port::Image, Port::Optional });
  DeclareInput(this, 2, { Port::Image, Port::Optional });
}

vtkOversketchProjectTexture::~vtkOversketchProjectTexture() = default;

void vtkOversketchProjectTexture::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkImageData* picture = vtkImageData::GetData(inputs[1]);
  const bool apart = vtkImageData::GetData(inputs[2]) != nullptr;
  ContextOf(this).checkpoint(0.0);
  const Canvas canvas = picture ? PlaceOf(picture).Rectangle : CanvasOf(mesh);
  this->Internals->Provide(
    StepKey({ WholeKey(mesh) },
      { canvas.corner[0], canvas.corner[1], canvas.size[0], canvas.size[1], apart ? 1.0 : 0.0 }),
    vtkPolyData::GetData(outputs),
    [&](vtkPolyData* result)
    {
      std::vector<char> back;
      if (apart)
      {
        back = separateBack(mesh, result);
      }
      else
      {
        result->ShallowCopy(mesh);
      }
      const vtkIdType count = result->GetNumberOfPoints();
      back.resize(static_cast<std::size_t>(count), 0);
      const auto coordinates = NewArray<vtkDoubleArray>("TCoords", 2, count);
      for (vtkIdType i = 0; i < count; ++i)
      {
        const Vector2 at(result->GetPoint(i));
        const Vector2 place = back[static_cast<std::size_t>(i)] ? backTextureCoordinates(canvas, at)
                                                                : textureCoordinates(canvas, at);
        coordinates->SetTuple(i, place.data());
      }
      result->GetPointData()->SetTCoords(coordinates);
    });
}
