// The picture of an OBJ's materials: map_Kd in its material libraries. The libraries and the names of the
// materials are read by vtkOBJReader.
#include "mesh_file.h"
#include "texture.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

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

} // namespace

void readObjTexture(vtkPolyData* mesh, const std::string& path, Notes& notes)
{
  auto* libraries = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("MaterialLibraries"));
  auto* names = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("MaterialNames"));
  vtkDataArray* ids = mesh->GetCellData()->GetArray("MaterialIds");
  if (!libraries || !names || !ids || !mesh->GetPointData()->GetTCoords())
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
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const auto id = static_cast<vtkIdType>(ids->GetComponent(i, 0));
    const bool known = id >= 0 && id < names->GetNumberOfValues();
    const auto found = known ? pictures.find(names->GetValue(id)) : pictures.end();
    used.insert(found == pictures.end() ? fs::path() : found->second);
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
