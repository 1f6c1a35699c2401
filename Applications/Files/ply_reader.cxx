// PLY. Why not vtkPLYReader: it trusts the file, writes past its own memory where an index is out of range or
// the text breaks off, allocates what a header announces, and rounds double coordinates.
#include "colours.h"
#include "mesh_file.h"
#include "ply_document.h"
#include "texture.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <map>
#include <sstream>

namespace oversketch_files
{

namespace
{

bool isReal(int type)
{
  return type == VTK_FLOAT || type == VTK_DOUBLE;
}

// The properties of an element as arrays, filled row by row.
class Columns
{
public:
  explicit Columns(const PlyElement& of)
    : Of(of)
    , Taken(of.properties.size(), 0)
  {
  }

  // The array of these properties; null where they are not there.
  vtkDataArray* take(const char* name, std::initializer_list<const char*> properties)
  {
    const std::vector<int> places = this->Of.findAll(properties);
    return places.empty() ? nullptr : this->add(name, places);
  }

  void takeColours()
  {
    this->Colours = this->Of.find("alpha") >= 0 ? this->Of.findAll({ "red", "green", "blue", "alpha" })
                                                : this->Of.findAll({ "red", "green", "blue" });
    for (const int place : this->Colours)
    {
      this->Taken[static_cast<std::size_t>(place)] = 1;
    }
  }

  // Whatever else an element says of itself goes with it under its name; returns the lists among it, which no
  // array holds, but for those that are known.
  std::string takeRest(const std::vector<std::string>& known)
  {
    std::vector<std::string> lists;
    for (std::size_t k = 0; k < this->Taken.size(); ++k)
    {
      const PlyProperty& property = this->Of.properties[k];
      if (this->Taken[k] || std::count(known.begin(), known.end(), property.name) > 0)
      {
        continue;
      }
      if (property.isList())
      {
        lists.push_back(printable(property.name));
      }
      else
      {
        this->Rest.push_back(this->add(plainName(property.name), { static_cast<int>(k) }));
      }
    }
    return listed(lists);
  }

  void store(vtkIdType at, const PlyRow& row)
  {
    for (const Column& column : this->All)
    {
      for (std::size_t k = 0; k < column.places.size(); ++k)
      {
        const double value = number(row, column.places[k]), least = column.array->GetDataTypeMin();
        const double within = value >= least ? std::min(value, column.array->GetDataTypeMax()) : least;
        column.array->SetComponent(
          at, static_cast<int>(k), isReal(column.array->GetDataType()) ? value : within);
      }
    }
    for (const int place : this->Colours)
    {
      const int type = this->typeAt(place);
      const double most = isReal(type) ? 1.0 : vtkDataArray::GetDataTypeSize(type) == 2 ? 65535.0 : 255.0;
      this->Shares.push_back(number(row, place) / most);
    }
  }

  // Colours, and what takeRest took.
  void give(vtkDataSetAttributes* data) const
  {
    for (vtkDataArray* array : this->Rest)
    {
      data->AddArray(array);
    }
    if (!this->Colours.empty())
    {
      setColours(data, this->Shares, static_cast<int>(this->Colours.size()));
    }
  }

private:
  struct Column
  {
    std::vector<int> places;
    vtkSmartPointer<vtkDataArray> array;
  };

  int typeAt(int place) const { return this->Of.properties[static_cast<std::size_t>(place)].type; }

  static double number(const PlyRow& row, int place)
  {
    const std::vector<double>& values = row[static_cast<std::size_t>(place)];
    return values.empty() ? 0.0 : values[0];
  }

  // Several properties have one type, which holds the largest of them.
  vtkDataArray* add(const std::string& name, const std::vector<int>& places)
  {
    int type = places.size() > 1 ? VTK_FLOAT : this->typeAt(places[0]);
    for (const int place : places)
    {
      const int own = this->typeAt(place);
      this->Taken[static_cast<std::size_t>(place)] = 1;
      if (places.size() > 1 && (own == VTK_DOUBLE || own == VTK_INT || own == VTK_UNSIGNED_INT))
      {
        type = VTK_DOUBLE;
      }
    }
    Column column{ places, vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type)) };
    column.array->SetName(name.c_str());
    column.array->SetNumberOfComponents(static_cast<int>(places.size()));
    column.array->SetNumberOfTuples(static_cast<vtkIdType>(this->Of.count));
    this->All.push_back(column);
    return column.array;
  }

  const PlyElement& Of;
  std::vector<char> Taken;
  std::vector<Column> All;
  std::vector<vtkDataArray*> Rest;
  std::vector<int> Colours;   // places
  std::vector<double> Shares; // of them
};

void readPoints(PlyDocument& file,
  const PlyElement& element,
  vtkPolyData* mesh,
  std::vector<std::string>& lost)
{
  Columns columns(element);
  vtkDataArray* places = columns.take("Points", { "x", "y", "z" });
  if (!places)
  {
    file.refuse("its element vertex lacks x, y or z; the file is damaged");
  }
  vtkDataArray* normals = columns.take("Normals", { "nx", "ny", "nz" });
  vtkDataArray* coordinates = nullptr;
  for (const auto& [u, v] : { std::pair("u", "v"), std::pair("texture_u", "texture_v"), std::pair("s", "t") })
  {
    coordinates = coordinates ? coordinates : columns.take("TCoords", { u, v });
  }
  columns.takeColours();
  if (const std::string lists = columns.takeRest({}); !lists.empty())
  {
    lost.push_back("the lists " + lists + " of its points");
  }
  PlyRow row;
  for (std::size_t i = 0; i < element.count; ++i)
  {
    file.readRow(element, row);
    columns.store(static_cast<vtkIdType>(i), row);
  }
  vtkNew<vtkPoints> points;
  points->SetData(places);
  mesh->SetPoints(points);
  mesh->GetPointData()->SetNormals(normals);
  mesh->GetPointData()->SetTCoords(coordinates);
  columns.give(mesh->GetPointData());
}

// Faces as corners, one after the other.
struct Faces
{
  std::vector<vtkIdType> sizes;
  std::vector<vtkIdType> corners; // their vertices
  std::vector<std::array<double, 2>>
    coordinates; // texture coordinates of the corners; not finite where a face has none
  bool textured = false;
  std::vector<int> pictures; // numbers of the header's pictures, where faces say so
};

void addCorner(PlyDocument& file, std::size_t face, double corner, vtkIdType points, Faces& faces)
{
  if (!(corner >= 0.0 && corner < static_cast<double>(points)) || corner != std::floor(corner))
  {
    std::ostringstream message;
    message << std::setprecision(12) << "its face " << face << " names the vertex " << corner
            << ", and there are " << points << ", counted from 0; the file is damaged";
    file.refuse(message.str());
  }
  faces.corners.push_back(static_cast<vtkIdType>(corner));
}

// Strips of triangles, every second one wound the other way; -1 begins a new strip.
void readStrips(PlyDocument& file, const PlyElement& element, vtkIdType points, Faces& faces)
{
  const int cornersAt = std::max(element.find("vertex_indices"), element.find("vertex_index"));
  if (cornersAt < 0)
  {
    file.refuse("its element tristrips has no list vertex_indices; the file is damaged");
  }
  PlyRow row;
  for (std::size_t i = 0; i < element.count; ++i)
  {
    file.readRow(element, row);
    const std::vector<double>& ids = row[static_cast<std::size_t>(cornersAt)];
    std::size_t first = 0;
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      if (ids[k] == -1.0)
      {
        first = k + 1;
      }
      else if (k >= first + 2)
      {
        const std::size_t turned = (k - first) % 2;
        for (const std::size_t corner : { k - 2, k - 1 + turned, k - turned })
        {
          addCorner(file, i, ids[corner], points, faces);
        }
        faces.sizes.push_back(3);
      }
    }
  }
  faces.coordinates.resize(faces.corners.size(), { std::nan(""), 0.0 });
}

void readFaces(PlyDocument& file,
  const PlyElement& element,
  vtkPolyData* mesh,
  std::vector<std::string>& lost,
  Faces& faces)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  const int cornersAt = std::max(element.find("vertex_indices"), element.find("vertex_index"));
  const int coordinatesAt = element.find("texcoord");
  if (cornersAt < 0)
  {
    file.refuse("its element face has no list vertex_indices; the file is damaged");
  }
  const int pictureAt = file.pictures().empty() ? -1 : element.find("texnumber");
  Columns columns(element);
  columns.takeColours();
  const std::string lists =
    columns.takeRest({ "vertex_indices", "vertex_index", "texcoord", pictureAt < 0 ? "" : "texnumber" });
  if (!lists.empty())
  {
    lost.push_back("the lists " + lists + " of its faces");
  }
  PlyRow row;
  for (std::size_t i = 0; i < element.count; ++i)
  {
    file.readRow(element, row);
    columns.store(static_cast<vtkIdType>(i), row);
    const std::vector<double>& corners = row[static_cast<std::size_t>(cornersAt)];
    faces.sizes.push_back(static_cast<vtkIdType>(corners.size()));
    for (const double corner : corners)
    {
      addCorner(file, i, corner, points, faces);
    }
    if (pictureAt >= 0)
    {
      const std::vector<double>& number = row[static_cast<std::size_t>(pictureAt)];
      const bool isThere =
        !number.empty() && number[0] >= 0.0 && number[0] < static_cast<double>(file.pictures().size());
      faces.pictures.push_back(isThere ? static_cast<int>(number[0]) : -1);
    }
    const std::vector<double>* given =
      coordinatesAt < 0 ? nullptr : &row[static_cast<std::size_t>(coordinatesAt)];
    const bool textured = given && given->size() == 2 * corners.size() && !corners.empty();
    faces.textured = faces.textured || textured;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      faces.coordinates.push_back(
        textured ? std::array{ (*given)[2 * k], (*given)[2 * k + 1] } : std::array{ std::nan(""), 0.0 });
    }
  }
  columns.give(mesh->GetCellData());
}

// A point for each pair of texture coordinates that a vertex has in its faces, (-1, -1) in those without: the
// first stays at the vertex, the others are appended.
void spreadCoordinates(Faces& faces, vtkPolyData* mesh)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  std::vector<std::map<std::array<double, 2>, vtkIdType>> known(static_cast<std::size_t>(count));
  std::vector<std::array<double, 2>> coordinates(static_cast<std::size_t>(count), { -1.0, -1.0 });
  std::vector<vtkIdType> from;
  for (std::size_t k = 0; k < faces.corners.size(); ++k)
  {
    if (!std::isfinite(faces.coordinates[k][0]) || !std::isfinite(faces.coordinates[k][1]))
    {
      faces.coordinates[k] = { -1.0, -1.0 };
    }
    const vtkIdType vertex = faces.corners[k];
    auto& of = known[static_cast<std::size_t>(vertex)];
    const vtkIdType next = of.empty() ? vertex : static_cast<vtkIdType>(coordinates.size());
    const auto [it, isNew] = of.emplace(faces.coordinates[k], next);
    if (isNew && next == vertex)
    {
      coordinates[static_cast<std::size_t>(vertex)] = faces.coordinates[k];
    }
    else if (isNew)
    {
      coordinates.push_back(faces.coordinates[k]);
      from.push_back(vertex);
    }
    faces.corners[k] = it->second;
  }
  vtkPointData* data = mesh->GetPointData();
  std::vector<vtkDataArray*> arrays{ mesh->GetPoints()->GetData() };
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    arrays.push_back(data->GetArray(k));
  }
  for (vtkDataArray* array : arrays)
  {
    for (const vtkIdType vertex : from)
    {
      array->InsertNextTuple(vertex, array);
    }
  }
  vtkNew<vtkFloatArray> array;
  array->SetName("TCoords");
  array->SetNumberOfComponents(2);
  for (const std::array<double, 2>& of : coordinates)
  {
    array->InsertNextTuple(of.data());
  }
  data->SetTCoords(array);
}

// The pictures that the header names, worn by the faces that say so, or by all.
void dressPly(const PlyDocument& file,
  const Faces& faces,
  const std::string& path,
  vtkPolyData* mesh,
  Notes& notes)
{
  std::vector<std::string> pictures;
  for (const std::string& name : file.pictures())
  {
    const auto beside = std::filesystem::absolute(path).parent_path() / name;
    pictures.push_back(pictureIn(beside.string(), name, path, notes));
  }
  if (pictures.empty())
  {
    return;
  }
  if (!mesh->GetPointData()->GetTCoords())
  {
    notes.push_back(path + ": its picture is lost, as it has no texture coordinates");
    return;
  }
  pictures.emplace_back(); // none
  std::vector<int> worn(static_cast<std::size_t>(mesh->GetNumberOfPolys()),
    faces.pictures.empty() ? 0 : static_cast<int>(pictures.size()) - 1);
  for (std::size_t i = 0; i < std::min(faces.pictures.size(), worn.size()); ++i)
  {
    worn[i] = faces.pictures[i] < 0 ? worn[i] : faces.pictures[i];
  }
  wearPictures(mesh, worn, pictures);
}

// Faces that come from strips have no properties: zeros.
void fillCellArrays(vtkPolyData* mesh)
{
  vtkCellData* data = mesh->GetCellData();
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* array = data->GetArray(k);
    const std::vector<double> zeros(static_cast<std::size_t>(array->GetNumberOfComponents()), 0.0);
    while (array->GetNumberOfTuples() < mesh->GetNumberOfPolys())
    {
      array->InsertNextTuple(zeros.data());
    }
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> readPly(const std::string& path, Notes& notes)
{
  PlyDocument file(path);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  Faces faces;
  std::vector<std::string> lost;
  const PlyElement* strips = nullptr;
  PlyRow row;
  for (const PlyElement& element : file.elements())
  {
    if (element.name == "vertex")
    {
      readPoints(file, element, mesh, lost);
    }
    else if (element.name == "face" && !strips)
    {
      readFaces(file, element, mesh, lost, faces);
    }
    else if (element.name == "tristrips")
    {
      strips = &element;
      readStrips(file, element, mesh->GetNumberOfPoints(), faces);
    }
    else
    {
      for (std::size_t i = 0; i < element.count; ++i)
      {
        file.readRow(element, row);
      }
      if (element.count > 0)
      {
        lost.push_back("the element " + printable(element.name) + " (" + std::to_string(element.count) + ')');
      }
    }
  }
  if (faces.textured)
  {
    spreadCoordinates(faces, mesh);
  }
  vtkNew<vtkCellArray> polys;
  polys->AllocateExact(
    static_cast<vtkIdType>(faces.sizes.size()), static_cast<vtkIdType>(faces.corners.size()));
  const vtkIdType* corner = faces.corners.data();
  for (const vtkIdType size : faces.sizes)
  {
    polys->InsertNextCell(size, corner);
    corner += size;
  }
  mesh->SetPolys(polys);
  fillCellArrays(mesh);
  dressPly(file, faces, path, mesh, notes);
  if (!lost.empty())
  {
    notes.push_back(path + ": not kept: " + listed(lost));
  }
  return mesh;
}

} // namespace oversketch_files
