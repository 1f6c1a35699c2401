#include "gltf_document.h"

#include "colours.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

namespace oversketch_files
{

namespace
{

// The value of an attribute where a part has none; null for the other attributes.
const double* standIn(const std::string& name)
{
  static const double white = 1.0, nowhere = -1.0;
  return name == "COLOR_0" ? &white : name == "TEXCOORD_0" ? &nowhere : nullptr;
}

// How many components an attribute has in all parts; 0 where they differ, or some have none and nothing
// stands for it.
std::size_t componentsOf(const std::vector<GltfPart>& parts, const std::string& name)
{
  std::size_t components = 0, without = 0;
  for (const GltfPart& part : parts)
  {
    const auto own = part.attributes.find(name);
    if (own == part.attributes.end())
    {
      ++without;
    }
    else if (components > 0 && components != own->second.components)
    {
      return 0;
    }
    else
    {
      components = own->second.components;
    }
  }
  return without == 0 || standIn(name) ? components : 0;
}

// The numbers of an attribute in all parts, one after the other.
std::vector<double> valuesOf(const std::vector<GltfPart>& parts,
  const std::string& name,
  std::size_t components)
{
  std::vector<double> values;
  for (const GltfPart& part : parts)
  {
    const auto own = part.attributes.find(name);
    if (own != part.attributes.end())
    {
      values.insert(values.end(), own->second.values.begin(), own->second.values.end());
    }
    else
    {
      values.insert(values.end(), components * part.attributes.at("POSITION").count, *standIn(name));
    }
  }
  return values;
}

// In single precision where all are such numbers, as they are where no node moves them.
vtkSmartPointer<vtkDataArray> attributeArray(const std::string& name,
  const std::vector<double>& values,
  std::size_t components)
{
  const bool single = std::all_of(values.begin(),
    values.end(),
    [](double value) { return static_cast<double>(static_cast<float>(value)) == value; });
  auto array =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(single ? VTK_FLOAT : VTK_DOUBLE));
  array->SetName(name.c_str());
  array->SetNumberOfComponents(static_cast<int>(components));
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / components));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->SetTuple(i, &values[static_cast<std::size_t>(i) * components]);
  }
  return array;
}

} // namespace

vtkSmartPointer<vtkPolyData> joinedMesh(const std::vector<GltfPart>& parts, std::set<std::string>& lost)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  std::set<std::string> names;
  vtkNew<vtkCellArray> polys;
  vtkIdType first = 0;
  for (const GltfPart& part : parts)
  {
    for (const auto& [name, numbers] : part.attributes)
    {
      names.insert(name);
    }
    for (std::size_t i = 0; i < part.corners.size(); i += 3)
    {
      const vtkIdType ids[3] = {
        first + part.corners[i], first + part.corners[i + 1], first + part.corners[i + 2]
      };
      polys->InsertNextCell(3, ids);
    }
    first += static_cast<vtkIdType>(part.attributes.at("POSITION").count);
  }
  mesh->SetPolys(polys);
  vtkPointData* data = mesh->GetPointData();
  for (const std::string& name : names)
  {
    const std::size_t components = componentsOf(parts, name);
    if (components == 0)
    {
      lost.insert(name == "NORMAL" ? "normals" : name);
    }
    else if (name == "COLOR_0" && components >= 3)
    {
      setColours(data, valuesOf(parts, name, components), static_cast<int>(components));
    }
    else if (name.rfind("JOINTS_", 0) != 0 && name.rfind("WEIGHTS_", 0) != 0 && name != "TANGENT")
    {
      const auto array = attributeArray(name, valuesOf(parts, name, components), components);
      if (name == "POSITION")
      {
        vtkNew<vtkPoints> points;
        points->SetData(array);
        array->SetName("Points");
        mesh->SetPoints(points);
      }
      else if (name == "NORMAL")
      {
        data->SetNormals(array);
      }
      else if (name == "TEXCOORD_0")
      {
        data->SetTCoords(array);
      }
      else
      {
        data->AddArray(array);
      }
    }
  }
  return mesh;
}

} // namespace oversketch_files
