#include "pieces.h"

#include "texture.h"

#include "vtkOversketchCarriedArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace oversketch_files
{

namespace
{

std::string prefixOf(int part)
{
  return "Part" + std::to_string(part) + ".";
}

// The array of a part's picture; null where it has none.
vtkAbstractArray* partPicture(vtkPolyData* mesh, int part)
{
  const std::string name = prefixOf(part) + textureArray;
  return textureOf(mesh, prefixOf(part)).empty() ? nullptr
                                                 : mesh->GetFieldData()->GetAbstractArray(name.c_str());
}

// The number of each polygon's part; null where the mesh does not say.
vtkIntArray* numbersOf(vtkPolyData* mesh)
{
  auto* parts = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray("PartId"));
  const vtkIdType count = mesh->GetNumberOfPolys();
  const bool isGood = parts && parts->GetNumberOfComponents() == 1 && parts->GetNumberOfTuples() == count &&
                      mesh->GetNumberOfCells() == count;
  return isGood ? parts : nullptr;
}

// The polygons of each part.
std::map<int, std::vector<vtkIdType>> facesOfAll(vtkPolyData* mesh)
{
  std::map<int, std::vector<vtkIdType>> faces;
  vtkIntArray* parts = numbersOf(mesh);
  for (vtkIdType face = 0; parts && face < parts->GetNumberOfTuples(); ++face)
  {
    faces[parts->GetValue(face)].push_back(face);
  }
  return faces;
}

// The same; empty where no part has a picture.
std::map<int, std::vector<vtkIdType>> facesOfParts(vtkPolyData* mesh)
{
  std::map<int, std::vector<vtkIdType>> faces = facesOfAll(mesh);
  const bool worn = std::any_of(
    faces.begin(), faces.end(), [mesh](const auto& part) { return partPicture(mesh, part.first); });
  return worn ? faces : std::map<int, std::vector<vtkIdType>>();
}

vtkSmartPointer<vtkPolyData> extracted(vtkPolyData* mesh, const std::vector<vtkIdType>& faces)
{
  vtkNew<vtkIdList> ids;
  std::vector<vtkIdType> used;
  for (const vtkIdType face : faces)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    used.insert(used.end(), ids->begin(), ids->end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  auto piece = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(oversketch::CarriedArray(mesh->GetPoints()->GetData(), used));
  piece->GetPointData()->CopyAllOn();
  oversketch::CopyElements(mesh->GetPointData(), used, piece->GetPointData());
  vtkNew<vtkCellArray> polys;
  for (const vtkIdType face : faces)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    polys->InsertNextCell(static_cast<int>(ids->GetNumberOfIds()));
    for (const vtkIdType point : *ids)
    {
      polys->InsertCellPoint(std::lower_bound(used.begin(), used.end(), point) - used.begin());
    }
  }
  piece->SetPoints(points);
  piece->SetPolys(polys);
  return piece;
}

} // namespace

std::vector<Piece> piecesOf(vtkPolyData* mesh)
{
  std::vector<Piece> pieces;
  for (const auto& [part, faces] : facesOfParts(mesh))
  {
    pieces.push_back(
      { "part" + std::to_string(part), textureOf(mesh, prefixOf(part)), extracted(mesh, faces) });
  }
  if (pieces.empty())
  {
    pieces.push_back({ "", textureOf(mesh), mesh });
  }
  return pieces;
}

std::vector<int> partsOf(vtkPolyData* mesh)
{
  std::set<int> parts;
  vtkIntArray* numbers = numbersOf(mesh);
  for (vtkIdType face = 0; numbers && face < numbers->GetNumberOfTuples(); ++face)
  {
    if (face == 0 || numbers->GetValue(face) != numbers->GetValue(face - 1)) // most follow one of their part
    {
      parts.insert(numbers->GetValue(face));
    }
  }
  return { parts.begin(), parts.end() };
}

vtkSmartPointer<vtkPolyData> partAlone(vtkPolyData* mesh, int part)
{
  vtkSmartPointer<vtkPolyData> alone = extracted(mesh, facesOfAll(mesh)[part]);
  if (const std::string picture = textureOf(mesh, prefixOf(part)); !picture.empty())
  {
    setTexture(alone, picture);
  }
  return alone;
}

vtkSmartPointer<vtkPolyData> withoutParts(vtkPolyData* mesh, const std::set<int>& parts)
{
  if (!numbersOf(mesh))
  {
    return mesh;
  }
  auto rest = vtkSmartPointer<vtkPolyData>::New();
  rest->ShallowCopy(mesh);
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIdList> ids;
  vtkCellData* data = rest->GetCellData();
  data->Initialize();
  data->CopyAllOn();
  data->CopyAllocate(mesh->GetCellData(), mesh->GetNumberOfPolys());
  for (const auto& [part, faces] : facesOfAll(mesh))
  {
    for (const vtkIdType face : parts.count(part) > 0 ? std::vector<vtkIdType>() : faces)
    {
      mesh->GetPolys()->GetCellAtId(face, ids);
      data->CopyData(mesh->GetCellData(), face, polys->InsertNextCell(ids));
    }
  }
  rest->SetPolys(polys);
  return rest;
}

std::set<std::string> picturesOf(vtkPolyData* mesh)
{
  std::set<std::string> pictures{ textureOf(mesh) };
  for (const int part : partsOf(mesh))
  {
    pictures.insert(textureOf(mesh, prefixOf(part)));
  }
  pictures.erase("");
  return pictures;
}

void wearPictures(vtkPolyData* mesh, const std::vector<int>& worn, const std::vector<std::string>& pictures)
{
  std::map<std::string, int> parts;
  std::vector<int> partOf(pictures.size(), -1);
  vtkNew<vtkIntArray> ids;
  ids->SetName("PartId");
  for (const int picture : worn)
  {
    int& part = partOf[static_cast<std::size_t>(picture)];
    if (part < 0)
    {
      part = parts.try_emplace(pictures[static_cast<std::size_t>(picture)], static_cast<int>(parts.size()))
               .first->second;
    }
    ids->InsertNextValue(part);
  }
  for (const auto& [bytes, part] : parts)
  {
    if (!bytes.empty())
    {
      setTexture(mesh, bytes, parts.size() > 1 ? prefixOf(part) : "");
    }
  }
  if (parts.size() > 1)
  {
    mesh->GetCellData()->AddArray(ids);
  }
}

bool isNowhere(vtkDataArray* coordinates, vtkIdType point)
{
  return std::abs(coordinates->GetComponent(point, 0) + 1.0) < 1e-5 &&
         std::abs(coordinates->GetComponent(point, 1) + 1.0) < 1e-5;
}

std::vector<vtkAbstractArray*> pictureArrays(vtkPolyData* mesh)
{
  std::vector<vtkAbstractArray*> arrays;
  for (const auto& part : facesOfParts(mesh))
  {
    if (vtkAbstractArray* array = partPicture(mesh, part.first))
    {
      arrays.push_back(array);
    }
  }
  if (!arrays.empty())
  {
    arrays.push_back(mesh->GetCellData()->GetAbstractArray("PartId"));
  }
  else if (!textureOf(mesh).empty())
  {
    arrays.push_back(mesh->GetFieldData()->GetAbstractArray(textureArray));
  }
  return arrays;
}

} // namespace oversketch_files
