// PLY. Why not vtkPLYWriter: it rounds points to single precision, writes one array of colours alone, and
// tears the surface open along the seams of a texture. Here points of one position that differ in texture
// coordinates alone are one vertex, whose faces say their corners' coordinates (texcoord), as programs for
// scans read them.
#include "colours.h"
#include "kept_arrays.h"
#include "mesh_file.h"
#include "ply_document.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <map>

namespace oversketch_files
{

namespace
{

// A number that each point or face has.
struct PlyColumn
{
  std::string name;
  vtkDataArray* array = nullptr;
  int component = 0;
  int type = VTK_DOUBLE; // VTK's
  bool isColour = false; // a byte, whatever the array holds

  double at(vtkIdType i) const
  {
    return this->isColour ? static_cast<double>(colourByte(this->array, i, this->component))
                          : this->array->GetComponent(i, this->component);
  }
};

// The name of a type in PLY; whole numbers of eight bytes are doubles to it.
PlyType plyType(int type)
{
  const auto* const it = std::find_if(std::begin(plyTypes),
    std::end(plyTypes),
    [own = type == VTK_CHAR ? VTK_SIGNED_CHAR : type](const PlyType& one) { return one.type == own; });
  return it == std::end(plyTypes) ? plyTypes[7] : *it;
}

void putNumber(std::string& to, int type, double value)
{
  switch (type)
  {
    vtkTemplateMacro(put(to, static_cast<VTK_TT>(value)));
  }
}

void addTuple(vtkDataArray* array,
  std::initializer_list<const char*> names,
  bool isColour,
  std::vector<PlyColumn>& columns)
{
  int component = 0;
  for (const char* name : names)
  {
    if (array && component < array->GetNumberOfComponents())
    {
      columns.push_back(
        { name, array, component++, isColour ? VTK_UNSIGNED_CHAR : array->GetDataType(), isColour });
    }
  }
}

// Adds what else there is under its own name, one property for each component, where no other has that name.
void addRest(vtkPolyData* mesh, vtkDataSetAttributes* data, vtkIdType count, std::vector<PlyColumn>& columns)
{
  std::set<vtkAbstractArray*> own = ownArrays(mesh);
  own.insert(mesh->GetCellData()->GetAbstractArray("MaterialIds")); // numbers of names that no PLY holds
  std::set<std::string> taken = {
    "vertex_indices", "vertex_index", "texcoord", "texnumber", "u", "v", "s", "t", "texture_u", "texture_v"
  };
  std::set<vtkAbstractArray*> done;
  for (const PlyColumn& column : columns)
  {
    taken.insert(column.name);
    done.insert(column.array);
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (!array || !array->GetName() || own.count(array) > 0 || done.count(array) > 0 ||
        array == data->GetTCoords() || array == data->GetNormals() || array->GetNumberOfTuples() != count)
    {
      continue;
    }
    std::string name = plainName(array->GetName());
    std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isspace(c) != 0; }, '_');
    std::vector<PlyColumn> made;
    bool isNew = !name.empty();
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      made.push_back({ array->GetNumberOfComponents() == 1 ? name : name + '_' + std::to_string(k),
        array,
        k,
        array->GetDataType() });
      isNew = isNew && taken.count(made.back().name) == 0;
    }
    for (const PlyColumn& column : isNew ? made : std::vector<PlyColumn>())
    {
      taken.insert(column.name);
      columns.push_back(column);
    }
  }
}

std::vector<PlyColumn> pointColumns(vtkPolyData* mesh)
{
  std::vector<PlyColumn> columns;
  vtkPointData* data = mesh->GetPointData();
  addTuple(mesh->GetPoints()->GetData(), { "x", "y", "z" }, false, columns);
  vtkDataArray* normals = data->GetNormals();
  addTuple(normals && normals->GetNumberOfComponents() == 3 ? normals : nullptr,
    { "nx", "ny", "nz" },
    false,
    columns);
  addTuple(coloursOf(mesh), { "red", "green", "blue", "alpha" }, true, columns);
  addRest(mesh, data, mesh->GetNumberOfPoints(), columns);
  return columns;
}

std::vector<PlyColumn> faceColumns(vtkPolyData* mesh)
{
  std::vector<PlyColumn> columns;
  addTuple(faceColoursOf(mesh), { "red", "green", "blue", "alpha" }, true, columns);
  addRest(mesh, mesh->GetCellData(), mesh->GetNumberOfPolys(), columns);
  return columns;
}

vtkDataArray* coordinatesOf(vtkPolyData* mesh)
{
  return usable(mesh->GetPointData()->GetTCoords(), 2, mesh->GetNumberOfPoints());
}

// The points as vertices.
struct Vertices
{
  std::vector<vtkIdType> of;    // per point, its vertex
  std::vector<vtkIdType> first; // per vertex, the first of its points
  bool seams = false;           // whether points of one vertex have different coordinates
};

Vertices verticesOf(vtkPolyData* mesh, const std::vector<PlyColumn>& columns)
{
  Vertices vertices;
  vtkDataArray* coordinates = coordinatesOf(mesh);
  std::map<std::array<double, 3>, std::vector<vtkIdType>> known; // vertices at a position
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    auto vertex = static_cast<vtkIdType>(vertices.first.size());
    if (coordinates)
    {
      std::array<double, 3> p;
      mesh->GetPoint(i, p.data());
      std::vector<vtkIdType>& here = known[p];
      const auto same = std::find_if(here.begin(),
        here.end(),
        [&](vtkIdType other)
        {
          const vtkIdType point = vertices.first[static_cast<std::size_t>(other)];
          return std::all_of(columns.begin(),
            columns.end(),
            [&](const PlyColumn& column) { return column.at(i) == column.at(point); });
        });
      if (same != here.end())
      {
        vertex = *same;
        const vtkIdType point = vertices.first[static_cast<std::size_t>(vertex)];
        vertices.seams = vertices.seams ||
                         coordinates->GetComponent(i, 0) != coordinates->GetComponent(point, 0) ||
                         coordinates->GetComponent(i, 1) != coordinates->GetComponent(point, 1);
      }
      else
      {
        here.push_back(vertex);
      }
    }
    if (vertex == static_cast<vtkIdType>(vertices.first.size()))
    {
      vertices.first.push_back(i);
    }
    vertices.of.push_back(vertex);
  }
  return vertices;
}

std::string headerOf(const std::vector<PlyColumn>& columns)
{
  std::string text;
  for (const PlyColumn& column : columns)
  {
    text += std::string("property ") + plyType(column.type).name + ' ' + column.name + '\n';
  }
  return text;
}

void putRow(std::string& to, const std::vector<PlyColumn>& columns, vtkIdType at)
{
  for (const PlyColumn& column : columns)
  {
    putNumber(to, plyType(column.type).type, column.at(at));
  }
}

} // namespace

std::set<vtkAbstractArray*> keptByPly(vtkPolyData* mesh)
{
  std::set<vtkAbstractArray*> kept = { coordinatesOf(mesh) };
  for (const std::vector<PlyColumn>& columns : { pointColumns(mesh), faceColumns(mesh) })
  {
    for (const PlyColumn& column : columns)
    {
      kept.insert(column.array);
    }
  }
  return kept;
}

void writePly(vtkPolyData* mesh,
  const std::string& path,
  const std::vector<std::string>& pictures,
  const std::vector<int>& worn)
{
  std::vector<PlyColumn> ofPoints = pointColumns(mesh);
  const std::vector<PlyColumn> ofFaces = faceColumns(mesh);
  const Vertices vertices = verticesOf(mesh, ofPoints);
  vtkDataArray* coordinates = coordinatesOf(mesh);
  if (coordinates && !vertices.seams)
  {
    addTuple(coordinates, { "u", "v" }, false, ofPoints);
  }
  const int counts = mesh->GetPolys()->GetMaxCellSize() < 128 ? VTK_UNSIGNED_CHAR : VTK_INT;
  const std::string counted = plyType(counts).name;
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment Oversketch\n";
  for (const std::string& picture : pictures)
  {
    bytes += "comment TextureFile " + picture + '\n';
  }
  bytes += "element vertex " + std::to_string(vertices.first.size()) + '\n' + headerOf(ofPoints);
  bytes += "element face " + std::to_string(mesh->GetNumberOfPolys()) + '\n';
  bytes += "property list " + counted + " int vertex_indices\n";
  bytes += vertices.seams ? "property list " + counted + " float texcoord\n" : "";
  bytes += (worn.empty() ? "" : "property int texnumber\n") + headerOf(ofFaces) + "end_header\n";
  for (const vtkIdType point : vertices.first)
  {
    putRow(bytes, ofPoints, point);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    putNumber(bytes, counts, static_cast<double>(ids->GetNumberOfIds()));
    for (const vtkIdType id : *ids)
    {
      put(bytes, static_cast<std::int32_t>(vertices.of[static_cast<std::size_t>(id)]));
    }
    if (vertices.seams)
    {
      const bool textured =
        !std::all_of(ids->begin(), ids->end(), [&](vtkIdType id) { return isNowhere(coordinates, id); });
      putNumber(bytes, counts, textured ? 2.0 * static_cast<double>(ids->GetNumberOfIds()) : 0.0);
      for (vtkIdType k = 0; textured && k < 2 * ids->GetNumberOfIds(); ++k)
      {
        put(bytes, static_cast<float>(coordinates->GetComponent(ids->GetId(k / 2), static_cast<int>(k % 2))));
      }
    }
    if (!worn.empty())
    {
      put<std::int32_t>(bytes, worn[static_cast<std::size_t>(face)]);
    }
    putRow(bytes, ofFaces, face);
  }
  std::ofstream stream(path, std::ios::binary);
  stream << bytes;
  closeWhole(stream, path);
}

} // namespace oversketch_files
