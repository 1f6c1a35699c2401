// An OBJ's materials and the picture that they name: map_Kd in its material libraries. vtkOBJReader keeps the
// names of the libraries; which face wears which material is read here, because VTK 9.3 loses it behind the
// first face of each, VTK 9.1 where there are no texture coordinates.
#include "mesh_file.h"
#include "texture.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace oversketch_files
{

namespace
{

std::string trimmed(const std::string& text)
{
  const std::size_t from = text.find_first_not_of(" \t\r"), to = text.find_last_not_of(" \t\r");
  return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}

// The file that a map_Kd line names: what follows its options, which take numbers or on and off.
std::string pictureNamed(const std::string& arguments)
{
  std::istringstream words(arguments);
  std::string word;
  std::streampos begin = 0;
  bool inOption = false;
  while (words >> word)
  {
    const bool number = word.find_first_not_of("+-.0123456789eE") == std::string::npos;
    inOption = word[0] == '-' || (inOption && (number || word == "on" || word == "off"));
    if (!inOption)
    {
      return trimmed(arguments.substr(static_cast<std::size_t>(begin)));
    }
    begin = words.tellg();
    if (begin < 0)
    {
      break;
    }
  }
  return {};
}

// Adds each material's picture; "" for one without.
bool readLibrary(const fs::path& path, std::map<std::string, fs::path>& pictures)
{
  std::ifstream stream(path);
  std::string material;
  for (std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    std::string keyword, rest;
    words >> keyword;
    std::getline(words, rest);
    if (keyword == "newmtl")
    {
      material = trimmed(rest);
      pictures[material];
    }
    else if (keyword == "map_Kd")
    {
      const std::string name = pictureNamed(trimmed(rest));
      pictures[material] = name.empty() ? fs::path() : path.parent_path() / name;
    }
  }
  return !stream.bad() && !pictures.empty();
}

struct Usage
{
  std::vector<std::string> names; // of materials, in the order of their first use
  std::vector<int> faces;         // the material of each
  bool coordinates = false;       // whether there are any of the texture
};

Usage readUsage(const std::string& path)
{
  const char* const none = "NO_MATERIAL"; // as vtkOBJReader calls that of faces before the first usemtl
  Usage usage;
  std::map<std::string, int> known;
  int material = -1;
  const auto use = [&](const std::string& name)
  {
    const auto [place, isNew] = known.emplace(name, static_cast<int>(usage.names.size()));
    if (isNew)
    {
      usage.names.push_back(name);
    }
    material = place->second;
  };
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);)
  {
    const std::size_t from = line.find_first_not_of(" \t\r");
    if (from == std::string::npos)
    {
      continue;
    }
    const std::size_t to = std::min(line.find_first_of(" \t\r", from), line.size());
    const std::string keyword = line.substr(from, to - from);
    if (keyword == "usemtl")
    {
      use(trimmed(line.substr(to)));
    }
    else if (keyword == "f")
    {
      if (material < 0)
      {
        use(none);
      }
      usage.faces.push_back(material);
    }
    else if (keyword == "vt")
    {
      usage.coordinates = true;
    }
  }
  if (usage.names == std::vector<std::string>{ none })
  {
    usage.names.clear();
  }
  return usage;
}

// Of vtkOBJReader's texture coordinates, one array for each material with -1, -1 at the points of others,
// one.
void uniteCoordinates(vtkPolyData* mesh, const Usage& usage)
{
  std::vector<vtkSmartPointer<vtkDataArray>> parts;
  std::set<std::string> names(usage.names.begin(), usage.names.end());
  vtkPointData* data = mesh->GetPointData();
  if (vtkDataArray* active = data->GetTCoords())
  {
    names.insert(active->GetName());
  }
  names.insert("TCoords");
  for (const std::string& name : names)
  {
    vtkDataArray* part = data->GetArray(name.c_str());
    if (part && part->GetNumberOfComponents() == 2)
    {
      parts.emplace_back(part);
      data->RemoveArray(name.c_str());
    }
  }
  if (parts.empty() || !usage.coordinates)
  {
    return;
  }
  vtkDataArray* all = parts.front();
  for (vtkIdType i = 0; i < all->GetNumberOfTuples(); ++i)
  {
    for (std::size_t k = 1;
         k < parts.size() && all->GetComponent(i, 0) == -1.0 && all->GetComponent(i, 1) == -1.0;
         ++k)
    {
      all->SetTuple(i, parts[k]->GetTuple(i));
    }
  }
  all->SetName("TCoords");
  data->SetTCoords(all);
}

void setMaterials(vtkPolyData* mesh, const std::string& path, const Usage& usage, Notes& notes)
{
  mesh->GetFieldData()->RemoveArray("MaterialNames");
  mesh->GetCellData()->RemoveArray("MaterialIds");
  if (usage.names.empty())
  {
    return;
  }
  if (static_cast<vtkIdType>(usage.faces.size()) != mesh->GetNumberOfPolys())
  {
    notes.push_back(path + ": not all faces could be read, so which wears which material is not known");
    return;
  }
  vtkNew<vtkStringArray> names;
  names->SetName("MaterialNames");
  for (const std::string& name : usage.names)
  {
    names->InsertNextValue(name);
  }
  mesh->GetFieldData()->AddArray(names);
  // Lines and points come before the polygons and wear none.
  vtkNew<vtkIntArray> ids;
  ids->SetName("MaterialIds");
  ids->SetNumberOfValues(mesh->GetNumberOfCells());
  ids->FillValue(-1);
  std::copy(usage.faces.begin(),
    usage.faces.end(),
    ids->GetPointer(mesh->GetNumberOfCells() - mesh->GetNumberOfPolys()));
  mesh->GetCellData()->AddArray(ids);
}

} // namespace

void readObjMaterials(vtkPolyData* mesh, const std::string& path, Notes& notes)
{
  const Usage usage = readUsage(path);
  uniteCoordinates(mesh, usage);
  setMaterials(mesh, path, usage, notes);
  auto* libraries = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("MaterialLibraries"));
  if (!libraries || !mesh->GetCellData()->GetArray("MaterialIds") || !mesh->GetPointData()->GetTCoords())
  {
    return;
  }
  std::map<std::string, fs::path> pictures;
  for (vtkIdType i = 0; i < libraries->GetNumberOfValues(); ++i)
  {
    const std::string library = libraries->GetValue(i);
    if (!readLibrary(fs::absolute(path).parent_path() / library, pictures))
    {
      notes.push_back(path + ": the material library " + library + " cannot be read");
    }
  }
  std::set<fs::path> used;
  for (const int material : std::set<int>(usage.faces.begin(), usage.faces.end()))
  {
    used.insert(pictures[usage.names[static_cast<std::size_t>(material)]]);
  }
  if (used.size() > 1)
  {
    notes.push_back(
      path + ": one mesh has one picture, and its materials have several or none: map_Kd is not shown");
  }
  if (used.size() != 1 || used.begin()->empty())
  {
    return;
  }
  std::ifstream stream(*used.begin(), std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  if (pictureOf(bytes))
  {
    setTexture(mesh, bytes);
  }
  else
  {
    notes.push_back(path + ": the picture " + used.begin()->filename().string() + " is no PNG or JPEG file");
  }
}

std::string writeObjMaterial(vtkPolyData* mesh, const std::string& path)
{
  const std::string bytes = textureOf(mesh);
  const fs::path library = fs::path(path).replace_extension(".mtl");
  const fs::path picture =
    fs::path(path).replace_extension(pictureFormatOf(bytes) == "png" ? ".png" : ".jpg");
  const std::string text =
    "# Oversketch\nnewmtl texture\nKd 1 1 1\nmap_Kd " + picture.filename().string() + '\n';
  for (const auto& [file, content] : { std::pair(picture, bytes), std::pair(library, text) })
  {
    std::ifstream stream(file, std::ios::binary);
    const std::string there{ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
    if (fs::exists(file) && there != content)
    {
      throw Failed(
        path + ": its texture would replace " + file.filename().string() + "; choose another name");
    }
  }
  writeText(picture.string(), bytes);
  writeText(library.string(), text);
  return library.filename().string();
}

} // namespace oversketch_files
