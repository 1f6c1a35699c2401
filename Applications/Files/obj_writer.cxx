// Why not vtkOBJWriter: it writes one `v` line for each point, so the points that vtkOBJReader split along a
// texture seam would tear the surface open in the file. Here points at one position that differ in `vt` or
// `vn` share their `v`.
#include "colours.h"
#include "mesh_file.h"
#include "texture.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>

namespace fs = std::filesystem;

namespace oversketch_files
{

namespace
{

void writeTuple(std::ostream& stream, const char* keyword, const double* values, int count)
{
  stream << keyword << std::setprecision(17);
  for (int c = 0; c < count; ++c)
  {
    stream << ' ' << values[c];
  }
}

// Behind a vertex, where others read it, from 0 to 1.
void writeObjColour(std::ostream& stream, vtkDataArray* colours, vtkIdType at)
{
  for (int c = 0; colours && c < colours->GetNumberOfComponents(); ++c)
  {
    stream << ' ' << std::setprecision(9) << colourShare(colours, at, c);
  }
}

// Materials or groups, which a line of the file gives to the faces after it.
class Marks
{
public:
  // `what`: "Material" or "Group", whose arrays of numbers and names the mesh may have.
  Marks(vtkPolyData* mesh, const std::string& what, const char* keyword)
    : Keyword(keyword)
    , Names(vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray((what + "Names").c_str())))
    , Ids(usable(mesh->GetCellData()->GetArray((what + "Ids").c_str()), 1, mesh->GetNumberOfCells()))
  {
  }

  // The line before the cell, where its mark is another than the last one's.
  void write(std::ostream& stream, vtkIdType cell)
  {
    const auto id = this->Names && this->Ids ? static_cast<vtkIdType>(this->Ids->GetComponent(cell, 0)) : -1;
    if (id != this->Last && id >= 0 && id < this->Names->GetNumberOfValues())
    {
      stream << this->Keyword << ' ' << this->Names->GetValue(id) << '\n';
    }
    this->Last = id;
  }

private:
  const char* Keyword;
  vtkStringArray* Names;
  vtkDataArray* Ids;
  vtkIdType Last = -1;
};

// What comes before a piece in the file.
struct Before
{
  vtkIdType positions = 0, points = 0;
};

// Its vertices and faces; the faces wear the material of that name, unless it is empty, else those of the
// file that the mesh was read from.
void writePiece(std::ostream& stream, vtkPolyData* mesh, const std::string& material, Before& before)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkDataArray* textures = usable(mesh->GetPointData()->GetTCoords(), 2, count);
  vtkDataArray* normals = usable(mesh->GetPointData()->GetNormals(), 3, count);
  vtkDataArray* colours = usable(coloursOf(mesh), 3, count);
  Marks groups(mesh, "Group", "g"), materials(mesh, "Material", "usemtl");
  std::vector<vtkIdType> position(static_cast<std::size_t>(count));
  std::map<std::array<double, 3>, vtkIdType> known;
  vtkIdType written = before.positions;
  for (vtkIdType i = 0; i < count; ++i)
  {
    std::array<double, 3> p;
    mesh->GetPoint(i, p.data());
    vtkIdType& at = position[static_cast<std::size_t>(i)];
    at = written + 1;
    if (textures || normals) // without them every point is told apart by its position alone: keep them all
    {
      at = known.emplace(p, written + 1).first->second;
    }
    if (at == written + 1)
    {
      writeTuple(stream, "v", p.data(), 3);
      writeObjColour(stream, colours, i);
      stream << '\n';
      ++written;
    }
  }
  for (vtkIdType i = 0; textures && i < count; ++i)
  {
    writeTuple(stream, "vt", textures->GetTuple(i), 2);
    stream << '\n';
  }
  for (vtkIdType i = 0; normals && i < count; ++i)
  {
    writeTuple(stream, "vn", normals->GetTuple(i), 3);
    stream << '\n';
  }
  if (!material.empty())
  {
    stream << "usemtl " << material << '\n';
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    groups.write(stream, face);
    if (material.empty())
    {
      materials.write(stream, face);
    }
    mesh->GetPolys()->GetCellAtId(face, ids);
    stream << 'f';
    const bool textured =
      textures &&
      !std::all_of(ids->begin(), ids->end(), [textures](vtkIdType id) { return isNowhere(textures, id); });
    for (const vtkIdType id : *ids)
    {
      const vtkIdType point = before.points + id + 1;
      stream << ' ' << position[static_cast<std::size_t>(id)];
      if (textured || normals)
      {
        stream << '/';
      }
      if (textured)
      {
        stream << point;
      }
      if (normals)
      {
        stream << '/' << point;
      }
    }
    stream << '\n';
  }
  before.positions = written;
  before.points += count;
}

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

void writeObj(const std::vector<Piece>& pieces, const std::string& path, const std::string& library)
{
  std::ofstream stream(path, std::ios::binary);
  stream << "# Oversketch\n";
  if (!library.empty())
  {
    stream << "mtllib " << library << '\n';
  }
  Before before;
  for (const Piece& piece : pieces)
  {
    // vtkOBJReader leaves the material libraries and names here.
    auto* libraries =
      vtkStringArray::SafeDownCast(piece.mesh->GetFieldData()->GetAbstractArray("MaterialLibraries"));
    for (vtkIdType i = 0; libraries && library.empty() && i < libraries->GetNumberOfValues(); ++i)
    {
      stream << "mtllib " << libraries->GetValue(i) << '\n';
    }
    const std::string own = piece.name.empty() ? "texture" : piece.name;
    writePiece(stream, piece.mesh, library.empty() ? "" : own, before);
  }
  closeWhole(stream, path);
}

} // namespace oversketch_files
