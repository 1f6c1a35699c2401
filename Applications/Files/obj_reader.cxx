// OBJ. Why not vtkOBJReader: it trusts indices, counts relative ones of texture coordinates by those of
// normals, keeps an array of coordinates for each material, and loses which face wears which.
#include "colours.h"
#include "mesh_file.h"
#include "text.h"
#include "texture.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

namespace fs = std::filesystem;

namespace oversketch_files
{

namespace
{

enum Kind
{
  Vertex,
  Coordinate,
  Normal
};
constexpr std::array<int, 3> components = { 3, 2, 3 };
constexpr vtkIdType noId = -1;
constexpr const char* unnamedMaterial = "NO_MATERIAL"; // of faces before the first usemtl, as VTK calls it
constexpr const char* unnamedGroup = "default";        // of faces before the first g, as the format calls it

using Corner = std::array<vtkIdType, 3>; // ids of each kind, counted from 0

struct Face
{
  std::size_t end = 0; // behind its last corner
  int material = 0;
  int group = 0;
};

// Names by the order of their first use.
struct NamesInOrder
{
  int numberOf(const std::string& name)
  {
    const auto [place, isNew] = this->known.emplace(name, static_cast<int>(this->names.size()));
    if (isNew)
    {
      this->names.push_back(name);
    }
    return place->second;
  }

  std::vector<std::string> names;
  std::map<std::string, int> known;
};

class Obj
{
public:
  explicit Obj(const std::string& path)
    : Path(path)
  {
    const std::string text = wholeFile(path);
    Words lines(text);
    std::string joined; // of lines that a backslash ties together
    for (std::string_view line; lines.line(line);)
    {
      ++this->Line;
      const std::size_t end = line.find_last_not_of(" \t\r");
      line = line.substr(0, end == std::string_view::npos ? 0 : end + 1);
      const bool goesOn = !line.empty() && line.back() == '\\';
      if (goesOn || !joined.empty())
      {
        joined += std::string(line.substr(0, line.size() - (goesOn ? 1 : 0))) + ' ';
      }
      if (!goesOn)
      {
        this->read(joined.empty() ? line : std::string_view(joined));
        joined.clear();
      }
    }
    this->requireIds();
  }

  std::array<std::vector<double>, 3> values;
  std::vector<std::array<double, 4>> colours; // of the first vertices, as many as have one
  bool opacity = false;
  std::vector<Corner> corners;
  std::vector<Face> faces;
  std::vector<std::string> libraries;
  NamesInOrder materials, groups;
  vtkIdType others = 0;  // lines and points
  vtkIdType objects = 0; // named

  std::size_t count(Kind kind) const
  {
    return this->values[kind].size() / static_cast<std::size_t>(components[kind]);
  }

  // Whether all corners that have an id of the kind have that of their vertex, and no vertex has it in some
  // of its corners alone.
  bool followsVertices(Kind kind) const
  {
    std::vector<char> with(this->count(Vertex), 0), without = with;
    for (const Corner& corner : this->corners)
    {
      const auto vertex = static_cast<std::size_t>(corner[Vertex]);
      (corner[kind] == noId ? without : with)[vertex] = 1;
      if ((corner[kind] != noId && corner[kind] != corner[Vertex]) || (with[vertex] && without[vertex]))
      {
        return false;
      }
    }
    return true;
  }

private:
  [[noreturn]] void refuse(const std::string& why) const { throw Failed(this->Path + ": " + why); }

  std::string where() const { return "line " + std::to_string(this->Line); }

  void read(std::string_view line)
  {
    Words words(line);
    const std::string_view keyword = words.next();
    if (keyword == "v" || keyword == "vt" || keyword == "vn")
    {
      const Kind kind = keyword == "v" ? Vertex : keyword == "vt" ? Coordinate : Normal;
      for (int k = 0; k < components[kind]; ++k)
      {
        const std::string_view word = words.next();
        const bool isNone = kind == Coordinate && k == 1 && word.empty(); // of a texture of one dimension
        this->values[kind].push_back(isNone ? 0.0 : numberOf(word, this->Path, this->Line));
      }
      if (kind == Vertex)
      {
        this->readColour(words);
      }
    }
    else if (keyword == "f")
    {
      this->readFace(words);
    }
    else if (keyword == "l" || keyword == "p")
    {
      ++this->others;
    }
    else if (keyword == "o")
    {
      ++this->objects;
    }
    else if (keyword == "g")
    {
      this->Group = this->groups.numberOf(std::string(words.rest()));
    }
    else if (keyword == "usemtl")
    {
      this->Material = this->materials.numberOf(std::string(words.rest()));
    }
    else if (keyword == "mtllib")
    {
      this->libraries.emplace_back(words.rest());
    }
  }

  // What many programs write behind a vertex: red, green, blue and, some, opacity. A single number is a
  // weight, which says something of curves alone.
  void readColour(Words& words)
  {
    std::array<double, 4> colour = { 1.0, 1.0, 1.0, 1.0 };
    std::size_t known = 0;
    for (std::string_view word = words.next(); !word.empty() && word[0] != '#' && known < 4;
         word = words.next())
    {
      colour[known++] = numberOf(word, this->Path, this->Line);
    }
    if (known >= 3)
    {
      this->opacity = this->opacity || known == 4;
      this->colours.resize(this->count(Vertex) - 1, { 1.0, 1.0, 1.0, 1.0 });
      this->colours.push_back(colour);
    }
  }

  void readFace(Words& words)
  {
    std::size_t read = 0;
    for (std::string_view word = words.next(); !word.empty() && word[0] != '#'; word = words.next(), ++read)
    {
      this->corners.push_back(this->cornerOf(word));
    }
    if (read < 3)
    {
      this->refuse(
        this->where() + " has a face of " + std::to_string(read) + " corners; the file is damaged");
    }
    if (this->Material < 0)
    {
      this->Material = this->materials.numberOf(unnamedMaterial);
    }
    if (this->Group < 0)
    {
      this->Group = this->groups.numberOf(unnamedGroup);
    }
    this->faces.push_back({ this->corners.size(), this->Material, this->Group });
  }

  // "v", "v/vt", "v//vn", "v/vt/vn", counted from 1, or back from -1, the last one so far.
  Corner cornerOf(std::string_view word)
  {
    Corner corner = { noId, noId, noId };
    const char* at = word.data();
    const char* const end = at + word.size();
    for (int kind = Vertex; kind <= Normal; ++kind)
    {
      long given = 0;
      const std::from_chars_result done = std::from_chars(at + (at != end && *at == '+'), end, given);
      const auto known = static_cast<long>(this->count(static_cast<Kind>(kind)));
      if (done.ec == std::errc() && done.ptr != at)
      {
        const long index = given < 0 && given >= -known ? known + given : given - 1;
        if (index < 0)
        {
          this->refuseIndex(this->Line, kind, given);
        }
        corner[static_cast<std::size_t>(kind)] = index;
        if (index > this->Most[static_cast<std::size_t>(kind)].first)
        {
          this->Most[static_cast<std::size_t>(kind)] = { index, this->Line };
        }
        at = done.ptr;
      }
      else if (kind == Vertex || done.ec == std::errc::result_out_of_range)
      {
        this->refuse(
          this->where() + " has " + inQuotes(word) + " where a corner should be; the file is damaged");
      }
      if (at == end || *at != '/')
      {
        break;
      }
      ++at;
    }
    if (at != end)
    {
      this->refuse(
        this->where() + " has " + inQuotes(word) + " where a corner should be; the file is damaged");
    }
    return corner;
  }

  // A face may name what comes after it, so this is known at the end.
  void requireIds() const
  {
    for (int kind = Vertex; kind <= Normal; ++kind)
    {
      const auto [index, line] = this->Most[static_cast<std::size_t>(kind)];
      if (index >= static_cast<long>(this->count(static_cast<Kind>(kind))))
      {
        this->refuseIndex(line, kind, index + 1);
      }
    }
  }

  [[noreturn]] void refuseIndex(long line, int kind, long index) const
  {
    const char* const kinds[] = { "vertex", "texture coordinate", "normal" };
    this->refuse("line " + std::to_string(line) + " names the " + kinds[kind] + ' ' + std::to_string(index) +
                 ", and there are " + std::to_string(this->count(static_cast<Kind>(kind))) +
                 ", counted from 1; the file is damaged");
  }

  std::string Path;
  long Line = 0;
  int Material = noId, Group = noId;
  std::array<std::pair<long, long>, 3> Most = {
    { { -1, 0 }, { -1, 0 }, { -1, 0 } }
  }; // largest index, its line
};

template <typename Array>
vtkSmartPointer<Array> arrayOf(const char* name, int width, std::size_t count, double initial)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(width);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  array->Fill(initial);
  return array;
}

// The colours of the vertices; of the points, each of which is a corner, where these are split.
void addObjColours(const Obj& obj, bool split, vtkPolyData* mesh)
{
  if (obj.colours.empty())
  {
    return;
  }
  double most = 0.0;
  for (const std::array<double, 4>& colour : obj.colours)
  {
    most = std::max({ most, colour[0], colour[1], colour[2] });
  }
  const double scale = most > 1.0 ? 1.0 / 255.0 : 1.0; // some write bytes
  const std::size_t components = obj.opacity ? 4 : 3;
  std::vector<double> values;
  for (std::size_t i = 0; i < static_cast<std::size_t>(mesh->GetNumberOfPoints()); ++i)
  {
    const auto vertex = split ? static_cast<std::size_t>(obj.corners[i][Vertex]) : i;
    for (std::size_t k = 0; k < components; ++k)
    {
      values.push_back(vertex < obj.colours.size() ? scale * obj.colours[vertex][k] : 1.0);
    }
  }
  setColours(mesh->GetPointData(), values, static_cast<int>(components));
}

// Points, and what they have: where corners differ from their vertices in texture coordinates or normals, a
// point for each corner, else for each vertex.
void setPoints(const Obj& obj, const std::string& path, vtkPolyData* mesh, Notes& notes)
{
  const bool split = !obj.followsVertices(Coordinate) || !obj.followsVertices(Normal);
  const std::size_t count = split ? obj.corners.size() : obj.count(Vertex);
  const auto pointOf = [&](std::size_t corner)
  { return split ? static_cast<vtkIdType>(corner) : obj.corners[corner][Vertex]; };
  const auto points = arrayOf<vtkDoubleArray>("Points", 3, count, 0.0);
  const auto coordinates = arrayOf<vtkDoubleArray>("TCoords", 2, count, -1.0); // for points without
  const auto normals = arrayOf<vtkDoubleArray>("Normals", 3, count, 0.0);
  bool hasCoordinates = false;
  std::size_t withNormal = 0;
  if (!split)
  {
    std::copy(obj.values[Vertex].begin(), obj.values[Vertex].end(), points->GetPointer(0));
  }
  for (std::size_t i = 0; i < obj.corners.size(); ++i)
  {
    const vtkIdType point = pointOf(i);
    const auto copy = [&](Kind kind, vtkDoubleArray* array)
    {
      const vtkIdType from = obj.corners[i][kind];
      if (from != noId)
      {
        array->SetTypedTuple(point, &obj.values[kind][static_cast<std::size_t>(from * components[kind])]);
      }
      return from != noId;
    };
    if (split)
    {
      copy(Vertex, points);
    }
    hasCoordinates = copy(Coordinate, coordinates) || hasCoordinates;
    withNormal += copy(Normal, normals) ? 1 : 0;
  }
  vtkNew<vtkPoints> made;
  made->SetData(points);
  mesh->SetPoints(made);
  addObjColours(obj, split, mesh);
  if (hasCoordinates)
  {
    mesh->GetPointData()->SetTCoords(coordinates);
  }
  if (withNormal == 0 && !split && obj.count(Normal) == count &&
      count > 0) // named by nobody, in the vertices' order
  {
    std::copy(obj.values[Normal].begin(), obj.values[Normal].end(), normals->GetPointer(0));
    withNormal = obj.corners.size();
  }
  if (withNormal == obj.corners.size() && withNormal > 0)
  {
    mesh->GetPointData()->SetNormals(normals);
  }
  else if (withNormal > 0)
  {
    notes.push_back(path + ": its normals are dropped, because only some corners have one");
  }
  vtkNew<vtkCellArray> polys;
  std::size_t at = 0;
  for (const Face& face : obj.faces)
  {
    polys->InsertNextCell(static_cast<int>(face.end - at));
    for (; at < face.end; ++at)
    {
      polys->InsertCellPoint(pointOf(at));
    }
  }
  mesh->SetPolys(polys);
}

template <typename List>
vtkSmartPointer<vtkStringArray> namesOf(const char* name, const List& texts)
{
  auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetName(name);
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  return array;
}

// Sets a cell array of numbers and a field array of the names that they count, unless all is `unnamed`.
void setNames(vtkPolyData* mesh,
  const Obj& obj,
  const NamesInOrder& used,
  int Face::*number,
  const std::string& what,
  const char* unnamed)
{
  if (used.names.empty() || (used.names.size() == 1 && used.names[0] == unnamed))
  {
    return;
  }
  mesh->GetFieldData()->AddArray(namesOf((what + "Names").c_str(), used.names));
  vtkNew<vtkIntArray> ids;
  ids->SetName((what + "Ids").c_str());
  ids->SetNumberOfValues(static_cast<vtkIdType>(obj.faces.size()));
  std::transform(obj.faces.begin(),
    obj.faces.end(),
    ids->GetPointer(0),
    [number](const Face& face) { return face.*number; });
  mesh->GetCellData()->AddArray(ids);
}

// The file that a map_Kd line names: what follows its options, which take numbers or on and off.
std::string_view pictureNamed(Words words)
{
  bool inOption = false;
  for (Words before = words;; before = words)
  {
    const std::string_view word = words.next();
    const bool number = word.find_first_not_of("+-.0123456789eE") == std::string_view::npos;
    inOption = !word.empty() && (word[0] == '-' || (inOption && (number || word == "on" || word == "off")));
    if (!inOption)
    {
      return before.rest();
    }
  }
}

// Adds each material's picture; "" for one without.
bool readLibrary(const fs::path& path, std::map<std::string, fs::path>& pictures)
{
  const std::string text = wholeFile(path.string());
  Words lines(text);
  std::string material;
  for (std::string_view line; lines.line(line);)
  {
    Words words(line);
    const std::string_view keyword = words.next();
    if (keyword == "newmtl")
    {
      material = words.rest();
      pictures[material];
    }
    else if (keyword == "map_Kd")
    {
      const std::string_view name = pictureNamed(words);
      pictures[material] = name.empty() ? fs::path() : path.parent_path() / name;
    }
  }
  return !pictures.empty();
}

// The picture of the materials (texture.h) that are worn; a part for each where they have several.
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
      notes.push_back(path + ": the material library " + library + " cannot be read");
    }
  }
  std::vector<std::string> worn(static_cast<std::size_t>(names->GetNumberOfValues())); // by the materials
  std::map<fs::path, std::string> known;
  const std::vector<int> faces(materials->Begin(), materials->End());
  for (const int material : std::set<int>(faces.begin(), faces.end()))
  {
    const fs::path& file = pictures[names->GetValue(material)];
    const auto [place, isNew] = known.try_emplace(file);
    if (isNew && !file.empty())
    {
      place->second = pictureIn(file.string(), file.filename().string(), path, notes);
    }
    worn[static_cast<std::size_t>(material)] = place->second;
  }
  wearPictures(mesh, faces, worn);
}

} // namespace

vtkSmartPointer<vtkPolyData> readObj(const std::string& path, Notes& notes)
{
  const Obj obj(path);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  setPoints(obj, path, mesh, notes);
  if (!obj.libraries.empty())
  {
    mesh->GetFieldData()->AddArray(namesOf("MaterialLibraries", obj.libraries));
  }
  setNames(mesh, obj, obj.groups, &Face::group, "Group", unnamedGroup);
  setNames(mesh, obj, obj.materials, &Face::material, "Material", unnamedMaterial);
  if (obj.others > 0)
  {
    notes.push_back(path + ": " + std::to_string(obj.others) + " lines and vertices are dropped");
  }
  if (obj.objects > 1)
  {
    notes.push_back(path + ": its " + std::to_string(obj.objects) + " objects are read as one mesh");
  }
  readObjPicture(mesh, path, notes);
  return mesh;
}

} // namespace oversketch_files
