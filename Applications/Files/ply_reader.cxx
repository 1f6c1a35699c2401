// PLY. Why not vtkPLYReader: it trusts the file, writes past its own memory where an index is out of range or
// the text breaks off, allocates what a header announces, and rounds double coordinates.
#include "mesh_file.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <map>
#include <sstream>

namespace oversketch_files
{

namespace
{

struct Type
{
  char kind = 'f'; // i, u, f: signed, unsigned, floating
  int size = 0;    // bytes
};

struct Property
{
  std::string name;
  Type type;
  Type count; // of a list; its size is 0 for a single value
};

struct Element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;

  // The place of a property in the list, -1 where it is not there.
  int find(const std::string& wanted) const
  {
    const auto it = std::find_if(
      this->properties.begin(), this->properties.end(), [&](const Property& p) { return p.name == wanted; });
    return it == this->properties.end() ? -1 : static_cast<int>(it - this->properties.begin());
  }

  // The places of all these; empty where one is not there.
  std::vector<int> findAll(std::initializer_list<const char*> wanted) const
  {
    std::vector<int> places;
    for (const char* one : wanted)
    {
      places.push_back(this->find(one));
    }
    return std::count(places.begin(), places.end(), -1) == 0 ? places : std::vector<int>();
  }
};

// The values of one row of an element: a single value is a list of one.
using Row = std::vector<std::vector<double>>;

class File
{
public:
  explicit File(const std::string& path)
    : Path(path)
    , Bytes(wholeFile(path))
  {
    this->readHeader();
  }

  const std::vector<Element>& elements() const { return this->Elements; }

  [[noreturn]] void refuse(const std::string& why) const { throw Failed(this->Path + ": " + why); }

  void readRow(const Element& element, Row& row)
  {
    row.resize(element.properties.size());
    for (std::size_t k = 0; k < row.size(); ++k)
    {
      const Property& property = element.properties[k];
      double count = 1.0;
      if (property.count.size > 0)
      {
        count = this->value(property.count);
        if (!(count >= 0.0 && count <= static_cast<double>(this->Bytes.size() - this->At)))
        {
          this->refuseEnd();
        }
      }
      row[k].resize(static_cast<std::size_t>(count));
      for (double& value : row[k])
      {
        value = this->value(property.type);
      }
    }
  }

private:
  [[noreturn]] void refuseEnd() const
  {
    this->refuse("ends before all that its header announces; the file is truncated or damaged");
  }

  std::string line()
  {
    const std::size_t end = std::min(this->Bytes.find('\n', this->At), this->Bytes.size());
    std::string text = this->Bytes.substr(this->At, end - this->At);
    this->At = std::min(end + 1, this->Bytes.size());
    return text;
  }

  Type typeOf(const std::string& name) const
  {
    static const std::map<std::string, Type> types = { { "char", { 'i', 1 } },
      { "int8", { 'i', 1 } },
      { "uchar", { 'u', 1 } },
      { "uint8", { 'u', 1 } },
      { "short", { 'i', 2 } },
      { "int16", { 'i', 2 } },
      { "ushort", { 'u', 2 } },
      { "uint16", { 'u', 2 } },
      { "int", { 'i', 4 } },
      { "int32", { 'i', 4 } },
      { "uint", { 'u', 4 } },
      { "uint32", { 'u', 4 } },
      { "float", { 'f', 4 } },
      { "float32", { 'f', 4 } },
      { "double", { 'f', 8 } },
      { "float64", { 'f', 8 } } };
    const auto it = types.find(name);
    if (it == types.end())
    {
      this->refuse("its PLY header names the unknown type '" + name.substr(0, 24) + "'");
    }
    return it->second;
  }

  void readHeader()
  {
    if (this->line().rfind("ply", 0) != 0)
    {
      this->refuse("is not a PLY file");
    }
    std::string format = "none";
    for (bool ended = false; !ended;)
    {
      if (this->At == this->Bytes.size())
      {
        this->refuse("its PLY header does not end; the file is damaged");
      }
      std::istringstream words(this->line());
      std::string word;
      words >> word;
      ended = word == "end_header";
      if (word == "format")
      {
        words >> format;
      }
      else if (word == "element")
      {
        this->readElement(words);
      }
      else if (word == "property" && !this->Elements.empty())
      {
        std::string type;
        words >> type;
        Property property;
        if (type == "list")
        {
          std::string count;
          words >> count >> type;
          property.count = this->typeOf(count);
        }
        property.type = this->typeOf(type);
        words >> property.name;
        this->Elements.back().properties.push_back(property);
      }
    }
    if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
    {
      this->refuse("its PLY header names the unknown format '" + format.substr(0, 24) + "'");
    }
    this->Ascii = format == "ascii";
    this->BigEndian = format == "binary_big_endian";
  }

  void readElement(std::istream& words)
  {
    Element element;
    double count = -1.0;
    if (!(words >> element.name >> count) || !(count >= 0.0) || count != std::floor(count) ||
        !(count <= static_cast<double>(this->Bytes.size())))
    {
      this->refuse("announces more elements than a file of its size can hold");
    }
    element.count = static_cast<std::size_t>(count);
    for (const Element& other : this->Elements)
    {
      if (other.name == element.name)
      {
        this->refuse("its PLY header names the element '" + element.name.substr(0, 24) + "' twice");
      }
    }
    this->Elements.push_back(element);
  }

  double value(Type type) { return this->Ascii ? this->word() : this->binary(type); }

  double word()
  {
    const char* const end = this->Bytes.data() + this->Bytes.size();
    const char* from = this->Bytes.data() + this->At;
    from = std::find_if(from, end, [](char c) { return std::strchr(" \t\r\n", c) == nullptr || c == '\0'; });
    if (from == end)
    {
      this->refuseEnd();
    }
    const char* const number = from + (*from == '+' ? 1 : 0);
    double value = 0.0;
    const std::from_chars_result done = std::from_chars(number, end, value);
    if (done.ec == std::errc::invalid_argument)
    {
      this->refuse("holds '" +
                   std::string(from, std::min<std::size_t>(16, static_cast<std::size_t>(end - from))) +
                   "' where a number should be; the file is damaged");
    }
    if (done.ec == std::errc::result_out_of_range) // too small counts as zero, too large is not finite
    {
      value = std::strtod(std::string(number, done.ptr).c_str(), nullptr);
    }
    this->At = static_cast<std::size_t>(done.ptr - this->Bytes.data());
    return value;
  }

  double binary(Type type)
  {
    const auto size = static_cast<std::size_t>(type.size);
    if (this->Bytes.size() - this->At < size)
    {
      this->refuseEnd();
    }
    std::uint64_t whole = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::size_t at = this->At + (this->BigEndian ? i : size - 1 - i);
      whole = whole << 8 | static_cast<unsigned char>(this->Bytes[at]);
    }
    this->At += size;
    if (type.kind == 'u')
    {
      return static_cast<double>(whole);
    }
    if (type.kind == 'i')
    {
      const auto half = std::uint64_t(1) << (8 * size - 1);
      return static_cast<double>(static_cast<std::int64_t>(whole ^ half) - static_cast<std::int64_t>(half));
    }
    if (size == 8)
    {
      double value;
      std::memcpy(&value, &whole, 8);
      return value;
    }
    const auto bits = static_cast<std::uint32_t>(whole);
    float value;
    std::memcpy(&value, &bits, 4);
    return value;
  }

  std::string Path;
  std::string Bytes;
  std::size_t At = 0;
  std::vector<Element> Elements;
  bool Ascii = true, BigEndian = false;
};

// Some properties of an element as one array.
struct Column
{
  std::vector<int> places;
  vtkSmartPointer<vtkDataArray> array;
  double scale = 1.0;
};

bool isFloating(const Element& element, int place)
{
  return element.properties[static_cast<std::size_t>(place)].type.kind == 'f';
}

// The array of these properties, if all of them are there.
template <typename Array>
void addColumn(std::vector<Column>& columns,
  const Element& element,
  const char* name,
  std::initializer_list<const char*> properties)
{
  Column column{ element.findAll(properties), vtkSmartPointer<Array>::New() };
  if (column.places.empty())
  {
    return;
  }
  column.array->SetName(name);
  column.array->SetNumberOfComponents(static_cast<int>(properties.size()));
  column.array->SetNumberOfTuples(static_cast<vtkIdType>(element.count));
  if (column.array->GetDataType() == VTK_UNSIGNED_CHAR && isFloating(element, column.places[0]))
  {
    column.scale = 255.0; // colours from 0 to 1
  }
  columns.push_back(std::move(column));
}

void store(const std::vector<Column>& columns, vtkIdType at, const Row& row)
{
  for (const Column& column : columns)
  {
    for (std::size_t k = 0; k < column.places.size(); ++k)
    {
      const std::vector<double>& values = row[static_cast<std::size_t>(column.places[k])];
      double value = values.empty() ? 0.0 : column.scale * values[0];
      if (column.array->GetDataType() == VTK_UNSIGNED_CHAR)
      {
        value = value > 0.0 ? std::min(std::round(value), 255.0) : 0.0;
      }
      column.array->SetComponent(at, static_cast<int>(k), value);
    }
  }
}

void addColours(std::vector<Column>& columns, const Element& element)
{
  if (element.find("alpha") >= 0)
  {
    addColumn<vtkUnsignedCharArray>(columns, element, "RGBA", { "red", "green", "blue", "alpha" });
  }
  else
  {
    addColumn<vtkUnsignedCharArray>(columns, element, "RGB", { "red", "green", "blue" });
  }
}

void readPoints(File& file, const Element& element, vtkPolyData* mesh)
{
  const std::vector<int> xyz = element.findAll({ "x", "y", "z" });
  if (xyz.empty())
  {
    file.refuse("its element vertex lacks x, y or z; the file is damaged");
  }
  const bool isDouble = std::any_of(xyz.begin(),
    xyz.end(),
    [&](int at) { return element.properties[static_cast<std::size_t>(at)].type.size == 8; });
  std::vector<Column> columns;
  if (isDouble)
  {
    addColumn<vtkDoubleArray>(columns, element, "Points", { "x", "y", "z" });
  }
  else
  {
    addColumn<vtkFloatArray>(columns, element, "Points", { "x", "y", "z" });
  }
  addColumn<vtkFloatArray>(columns, element, "Normals", { "nx", "ny", "nz" });
  addColours(columns, element);
  for (const auto& names :
    { std::array{ "u", "v" }, std::array{ "texture_u", "texture_v" }, std::array{ "s", "t" } })
  {
    if (columns.back().array->GetName() != std::string("TCoords"))
    {
      addColumn<vtkFloatArray>(columns, element, "TCoords", { names[0], names[1] });
    }
  }
  Row row;
  for (std::size_t i = 0; i < element.count; ++i)
  {
    file.readRow(element, row);
    store(columns, static_cast<vtkIdType>(i), row);
  }
  vtkNew<vtkPoints> points;
  points->SetData(columns[0].array);
  mesh->SetPoints(points);
  vtkPointData* data = mesh->GetPointData();
  for (std::size_t k = 1; k < columns.size(); ++k)
  {
    vtkDataArray* array = columns[k].array;
    const std::string name = array->GetName();
    name == "Normals"   ? data->SetNormals(array)
    : name == "TCoords" ? data->SetTCoords(array)
                        : data->SetScalars(array);
  }
}

// Faces as corners, one after the other.
struct Faces
{
  std::vector<vtkIdType> sizes;
  std::vector<vtkIdType> corners; // their vertices
  std::vector<std::array<double, 2>>
    coordinates; // texture coordinates of the corners; not finite where a face has none
  bool textured = false;
};

Faces readFaces(File& file, const Element& element, vtkIdType points, vtkPolyData* mesh)
{
  const int cornersAt = std::max(element.find("vertex_indices"), element.find("vertex_index"));
  const int coordinatesAt = element.find("texcoord");
  if (cornersAt < 0)
  {
    file.refuse("its element face has no list vertex_indices; the file is damaged");
  }
  std::vector<Column> columns;
  addColumn<vtkUnsignedCharArray>(columns, element, "intensity", { "intensity" });
  addColours(columns, element);
  Faces faces;
  Row row;
  for (std::size_t i = 0; i < element.count; ++i)
  {
    file.readRow(element, row);
    store(columns, static_cast<vtkIdType>(i), row);
    const std::vector<double>& corners = row[static_cast<std::size_t>(cornersAt)];
    faces.sizes.push_back(static_cast<vtkIdType>(corners.size()));
    for (const double corner : corners)
    {
      if (!(corner >= 0.0 && corner < static_cast<double>(points)) || corner != std::floor(corner))
      {
        std::ostringstream message;
        message << std::setprecision(12) << "its face " << i << " names the vertex " << corner
                << ", and there are " << points << ", counted from 0; the file is damaged";
        file.refuse(message.str());
      }
      faces.corners.push_back(static_cast<vtkIdType>(corner));
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
  for (const Column& column : columns)
  {
    mesh->GetCellData()->AddArray(column.array);
    mesh->GetCellData()->SetActiveScalars(column.array->GetName());
  }
  return faces;
}

// A point for each pair of texture coordinates that a vertex has in its faces: the first stays at the vertex,
// the others are appended.
void spreadCoordinates(Faces& faces, vtkPolyData* mesh)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  std::vector<std::map<std::array<double, 2>, vtkIdType>> known(static_cast<std::size_t>(count));
  std::vector<std::array<double, 2>> coordinates(static_cast<std::size_t>(count));
  std::vector<vtkIdType> from;
  for (std::size_t k = 0; k < faces.corners.size(); ++k)
  {
    if (!std::isfinite(faces.coordinates[k][0]) || !std::isfinite(faces.coordinates[k][1]))
    {
      continue;
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

} // namespace

vtkSmartPointer<vtkPolyData> readPly(const std::string& path)
{
  File file(path);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  Faces faces;
  Row row;
  for (const Element& element : file.elements())
  {
    if (element.name == "vertex")
    {
      readPoints(file, element, mesh);
    }
    else if (element.name == "face")
    {
      faces = readFaces(file, element, mesh->GetNumberOfPoints(), mesh);
    }
    else
    {
      for (std::size_t i = 0; i < element.count; ++i)
      {
        file.readRow(element, row);
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
  return mesh;
}

} // namespace oversketch_files
