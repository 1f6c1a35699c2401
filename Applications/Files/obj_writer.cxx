// Why not vtkOBJWriter: it writes one `v` line for each point, so the points that vtkOBJReader split along a
// texture seam would tear the surface open in the file. Here points at one position that differ in `vt` or
// `vn` share their `v`.
#include "colours.h"
#include "mesh_file.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>

namespace oversketch_files
{

namespace
{

void writeTuple(std::ostream& stream, const char* keyword, const double* values, int count)
{
  char text[40];
  stream << keyword;
  for (int c = 0; c < count; ++c)
  {
    std::snprintf(text, sizeof text, " %.17g", values[c]);
    stream << text;
  }
}

// Behind a vertex, where others read it, from 0 to 1.
void writeObjColour(std::ostream& stream, vtkDataArray* colours, vtkIdType at)
{
  char text[40];
  for (int c = 0; colours && c < colours->GetNumberOfComponents(); ++c)
  {
    std::snprintf(text, sizeof text, " %.9g", colourShare(colours, at, c));
    stream << text;
  }
}

vtkDataArray* usable(vtkDataArray* array, int components, vtkIdType count)
{
  return array && array->GetNumberOfComponents() >= components && array->GetNumberOfTuples() == count
           ? array
           : nullptr;
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
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    groups.write(stream, it->GetCurrentCellId());
    if (material.empty())
    {
      materials.write(stream, it->GetCurrentCellId());
    }
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    stream << 'f';
    const bool textured =
      textures && !std::all_of(ids, ids + size, [textures](vtkIdType id) { return isNowhere(textures, id); });
    for (vtkIdType k = 0; k < size; ++k)
    {
      const vtkIdType point = before.points + ids[k] + 1;
      stream << ' ' << position[static_cast<std::size_t>(ids[k])];
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

} // namespace

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
