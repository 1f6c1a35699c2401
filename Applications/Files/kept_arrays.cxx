#include "kept_arrays.h"

#include "colours.h"
#include "text.h"
#include "texture.h"

#include "vtkOversketchCarriedArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <vector>

namespace oversketch_files
{

namespace
{

// The name without what that of an assembled mesh's part begins with, "Part12.".
std::string nameInPart(const std::string& name)
{
  const std::size_t dot = name.find_first_not_of("0123456789", 4);
  const bool ofPart = name.rfind("Part", 0) == 0 && dot != 4 && dot != std::string::npos && name[dot] == '.';
  return ofPart ? name.substr(dot + 1) : name;
}

std::string nameOf(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

// Adds the arrays of these names, those of parts among them.
template <typename Names>
void addNamed(vtkFieldData* data, const Names& names, std::set<vtkAbstractArray*>& found)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (std::count(std::begin(names), std::end(names), nameInPart(nameOf(array))) > 0)
    {
      found.insert(array);
    }
  }
}

std::string wordsFor(vtkPolyData* mesh, vtkAbstractArray* array)
{
  const std::string name = nameOf(array);
  const bool isOfField = mesh->GetFieldData()->GetAbstractArray(name.c_str()) == array;
  if (array == mesh->GetPointData()->GetTCoords())
  {
    return "texture coordinates";
  }
  if (array == mesh->GetPointData()->GetNormals() || array == mesh->GetCellData()->GetNormals())
  {
    return "normals";
  }
  if (array == coloursOf(mesh))
  {
    return "colours";
  }
  if (array == faceColoursOf(mesh))
  {
    return "colours of faces";
  }
  if (isOfField && nameInPart(name) == textureArray)
  {
    return name == textureArray ? "the picture" : "the parts' pictures";
  }
  if (name == "MaterialIds" || name == "MaterialNames" || name == "MaterialLibraries")
  {
    return "materials";
  }
  if (name == "PartId")
  {
    return "which part a face is of";
  }
  return name == "GroupIds" || name == "GroupNames" ? "groups" : "the values " + printable(name);
}

} // namespace

std::set<vtkAbstractArray*> ownArrays(vtkPolyData* mesh)
{
  vtkPointData* points = mesh->GetPointData();
  vtkCellData* cells = mesh->GetCellData();
  vtkFieldData* fields = mesh->GetFieldData();
  std::set<vtkAbstractArray*> own;
  addNamed(fields, std::array{ "MeanEdge" }, own);
  if (cells->HasArray(oversketch::stellarCellArrays[0]))
  {
    addNamed(points, oversketch::stellarPointArrays, own);
    addNamed(cells, oversketch::stellarCellArrays, own);
    addNamed(fields, oversketch::stellarFieldArrays, own);
    addNamed(fields, std::array{ "TerrainGray", "TerrainRules" }, own);
  }
  if (points->HasArray("PlanarId") && cells->HasArray("BaseFaceId"))
  {
    const char* const ofPoints[] = {
      "BoundaryKind", "StrokeId", "StrokeParam", "IsBaseVertex", "Displacement", "PlanarId", "Side"
    };
    addNamed(points, ofPoints, own);
    addNamed(cells, std::array{ "RegionId", "ObjectId", "BaseFaceId", "Side" }, own);
    addNamed(fields, std::array{ "Resolution", "Canvas" }, own);
  }
  return own;
}

void noteDropped(vtkPolyData* mesh, const std::string& format, std::set<vtkAbstractArray*> kept, Notes& notes)
{
  kept.merge(ownArrays(mesh));
  std::vector<std::string> words;
  for (vtkFieldData* data : { static_cast<vtkFieldData*>(mesh->GetPointData()),
         static_cast<vtkFieldData*>(mesh->GetCellData()),
         mesh->GetFieldData() })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = data->GetAbstractArray(i);
      const std::string word = wordsFor(mesh, array);
      if (kept.count(array) == 0 && std::count(words.begin(), words.end(), word) == 0)
      {
        words.push_back(word);
      }
    }
  }
  if (!words.empty())
  {
    notes.push_back(format + " does not keep: " + listed(words));
  }
}

} // namespace oversketch_files
