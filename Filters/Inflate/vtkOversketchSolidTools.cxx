#include "vtkOversketchSolidTools.h"

#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <string>

namespace oversketch
{
namespace
{

template <typename Element>
void copyBySource(vtkDataSetAttributes* from, const std::vector<Element>& elements, vtkDataSetAttributes* to)
{
  to->CopyNormalsOff();
  CopyElements(from, mapped(elements, &Element::source), to);
}

} // namespace

void WriteSolid(const Solid& solid, vtkPolyData* input, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto displacements = NewArray<vtkDoubleArray>("Displacement");
  for (const SolidPoint& point : solid.points)
  {
    points->InsertNextPoint(point.place.data());
    displacements->InsertNextValue(std::abs(point.place[2]));
  }
  vtkNew<vtkCellArray> polys;
  for (const SolidFace& face : solid.faces)
  {
    polys->InsertNextCell(face.count());
    for (int k = 0; k < face.count(); ++k)
    {
      polys->InsertCellPoint(face.corners[k]);
    }
  }
  output->SetPoints(points);
  output->SetPolys(polys);
  copyBySource(input->GetPointData(), solid.points, output->GetPointData());
  output->GetPointData()->AddArray(displacements);
  output->GetPointData()->AddArray(ArrayOf<vtkIntArray>("PlanarId", solid.points, &SolidPoint::planar));
  output->GetPointData()->AddArray(ArrayOf<vtkIntArray>("Side", solid.points, &SolidPoint::side));
  copyBySource(input->GetCellData(), solid.faces, output->GetCellData());
  output->GetCellData()->AddArray(ArrayOf<vtkIntArray>("Side", solid.faces, &SolidFace::side));
  if (vtkDataArray* bases = output->GetCellData()->GetArray("BaseFaceId"))
  {
    for (std::size_t f = 0; f < solid.faces.size(); ++f)
    {
      if (solid.faces[f].side == 0)
      {
        bases->SetComponent(static_cast<vtkIdType>(f), 0, -1.0);
      }
    }
  }
  output->GetFieldData()->PassData(input->GetFieldData());
}

Solid SolidOf(vtkPolyData* surface)
{
  const std::string remedy = "take the surface from vtkOversketchInflate or vtkOversketchExtrude";
  const auto numbers = [&](vtkDataSetAttributes* of, const char* name, vtkIdType count)
  { return RequireArray(of, name, 1, count, "surface", remedy); };
  const vtkIdType count = surface->GetNumberOfPoints();
  RequirePolygonsOnly(surface);
  vtkDataArray* sides = numbers(surface->GetPointData(), "Side", count);
  vtkDataArray* planar = numbers(surface->GetPointData(), "PlanarId", count);
  vtkDataArray* bases = numbers(surface->GetPointData(), "IsBaseVertex", count);
  vtkDataArray* faceSides = numbers(surface->GetCellData(), "Side", surface->GetNumberOfCells());
  Solid solid;
  for (vtkIdType i = 0; i < count; ++i)
  {
    SolidPoint point;
    surface->GetPoint(i, point.place.data());
    if (!point.place.allFinite())
    {
      throw Error(Failure::BadMesh, "Point %1 of the surface is not finite; repair or remove it.", i);
    }
    point.side = static_cast<int>(sides->GetComponent(i, 0));
    point.planar = static_cast<int>(planar->GetComponent(i, 0));
    point.isBase = bases->GetComponent(i, 0) != 0.0;
    point.source = static_cast<int>(i);
    solid.points.push_back(point);
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType f = 0; f < surface->GetNumberOfCells(); ++f)
  {
    surface->GetPolys()->GetCellAtId(f, corners);
    SolidFace face;
    if (corners->GetNumberOfIds() < 3 || corners->GetNumberOfIds() > 4)
    {
      throw Error(Failure::BadMesh, "Cell %1 of the surface is no triangle and no quad; %2.", f, remedy);
    }
    for (int k = 0; k < static_cast<int>(corners->GetNumberOfIds()); ++k)
    {
      face.corners[k] = static_cast<int>(corners->GetId(k));
    }
    face.side = static_cast<int>(faceSides->GetComponent(f, 0));
    face.source = static_cast<int>(f);
    solid.faces.push_back(face);
  }
  return solid;
}

} // namespace oversketch
