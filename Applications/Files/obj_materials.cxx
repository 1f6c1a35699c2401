// The picture that an OBJ's materials name, map_Kd in its material libraries, read and written.
#include "mesh_file.h"
#include "texture.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <filesystem>
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
  std::istringstream stream(wholeFile(path.string()));
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
  return !pictures.empty();
}

} // namespace

void readObjPicture(vtkPolyData* mesh, const std::string& path, Notes& notes)
{
  vtkFieldData* fields = mesh->GetFieldData();
  auto* libraries = vtkStringArray::SafeDownCast(fields->GetAbstractArray("MaterialLibraries"));
  auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray("MaterialNames"));
  auto* materials = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("MaterialIds"));
  if (!libraries || !materials || !mesh->GetPointData()->GetTCoords())
  {
    return;
  }
  std::map<std::string, fs::path> pictures;
  std::set<std::string> read;
  for (vtkIdType i = 0; i < libraries->GetNumberOfValues(); ++i)
  {
    const std::string library = libraries->GetValue(i);
    const fs::path file = (fs::absolute(path).parent_path() / library).lexically_normal();
    if (read.insert(file.string()).second && !readLibrary(file, pictures))
    {
      std::string note = path + ": the material library ";
      note += library;
      notes.push_back(note + " cannot be read");
    }
  }
  std::vector<std::string> worn;
  std::map<fs::path, int> known;
  std::vector<int> numbers(static_cast<std::size_t>(names->GetNumberOfValues()), -1); // of materials
  std::vector<int> faces;
  for (vtkIdType i = 0; i < materials->GetNumberOfValues(); ++i)
  {
    int& number = numbers[static_cast<std::size_t>(materials->GetValue(i))];
    if (number < 0)
    {
      const fs::path& file = pictures[names->GetValue(materials->GetValue(i))];
      const auto [place, isNew] = known.try_emplace(file, static_cast<int>(worn.size()));
      number = place->second;
      if (isNew)
      {
        worn.push_back(file.empty() ? "" : wholeFile(file.string()));
        if (!file.empty() && !pictureOf(worn.back()))
        {
          worn.back().clear();
          notes.push_back(path + ": the picture " + file.filename().string() + " is " + notAPicture);
        }
      }
    }
    faces.push_back(number);
  }
  wearPictures(mesh, faces, worn);
}

namespace
{

// A file beside that of the path, which may stand there already if it is the same.
void writeBeside(const fs::path& file, const std::string& content, const std::string& path, NewFiles& files)
{
  const bool isThere = fs::exists(fs::symlink_status(file));
  if (isThere && wholeFile(file.string()) != content)
  {
    throw Failed(path + ": its texture would replace " + file.filename().string() + "; choose another name");
  }
  if (!isThere)
  {
    files.writeText(file.string(), content);
  }
}

} // namespace

std::vector<std::string> writePictures(const std::vector<Piece>& pieces,
  const std::string& path,
  NewFiles& files)
{
  std::vector<std::string> names;
  std::map<std::string, std::string> known; // by what is in them: parts may wear the same picture
  for (const Piece& piece : pieces)
  {
    const auto [named, isNew] = known.try_emplace(piece.picture);
    if (isNew && !piece.picture.empty())
    {
      fs::path picture = fs::path(path).replace_extension();
      picture += (piece.name.empty() ? "" : "_" + piece.name) +
                 (pictureFormatOf(piece.picture) == "png" ? ".png" : ".jpg");
      named->second = picture.filename().string();
      writeBeside(picture, piece.picture, path, files);
    }
    names.push_back(named->second);
  }
  return names;
}

std::string writeObjMaterials(const std::vector<Piece>& pieces, const std::string& path, NewFiles& files)
{
  const fs::path library = fs::path(path).replace_extension(".mtl");
  std::string text = "# Oversketch\n";
  const std::vector<std::string> pictures = writePictures(pieces, path, files);
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    text += "newmtl " + (pieces[i].name.empty() ? "texture" : pieces[i].name) + "\nKd 1 1 1\n";
    text += pictures[i].empty() ? "" : "map_Kd " + pictures[i] + '\n';
  }
  writeBeside(library, text, path, files);
  return library.filename().string();
}

} // namespace oversketch_files
