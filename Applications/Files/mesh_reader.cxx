#include "mesh_file.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSTLReader.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace oversketch_files
{

const char* const meshExtensions = ".obj .ply .stl .off .vtp .gltf .glb";

bool isMeshExtension(const std::string& extension)
{
  std::istringstream list(meshExtensions);
  return std::find(std::istream_iterator<std::string>(list), {}, extension) !=
         std::istream_iterator<std::string>();
}

vtkDataArray* coloursOf(vtkPolyData* mesh)
{
  vtkPointData* data = mesh->GetPointData();
  const auto usable = [](vtkDataArray* array)
  {
    return array && array->GetDataType() == VTK_UNSIGNED_CHAR &&
           (array->GetNumberOfComponents() == 3 || array->GetNumberOfComponents() == 4);
  };
  if (usable(data->GetScalars()))
  {
    return data->GetScalars();
  }
  for (const char* name : { "RGB", "RGBA", "Colors", "Color", "COLOR_0" })
  {
    if (usable(data->GetArray(name)))
    {
      return data->GetArray(name);
    }
  }
  return nullptr;
}

namespace
{

// The first bytes of a file, enough for any header.
std::string headOf(const std::string& path, std::size_t bytes)
{
  std::ifstream stream(path, std::ios::binary);
  std::string head(bytes, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(bytes));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}

// Refuses a count that a file of this size cannot hold, before a reader allocates for it.
void requireCount(const std::string& path, const std::string& count, double most)
{
  if (!(std::strtod(count.c_str(), nullptr) <= most))
  {
    throw Failed(
      path + ": announces " + count.substr(0, 24) + " elements, more than a file of its size can hold");
  }
}

// Binary STL tells its number of triangles; a text file begins with "solid" and holds "facet".
void checkStl(const std::string& path, std::uintmax_t size)
{
  const std::string head = headOf(path, 4096);
  if (head.rfind("solid", 0) == 0 && head.find("facet") != std::string::npos)
  {
    return;
  }
  std::uint32_t count = 0;
  if (head.size() >= 84)
  {
    std::memcpy(&count, head.data() + 80, 4);
  }
  if (head.size() < 84 || size < 84 + 50 * static_cast<std::uintmax_t>(count))
  {
    std::ostringstream message;
    message << path << ": announces " << count
            << " triangles, but ends before; the file is truncated or not an STL file";
    throw Failed(message.str());
  }
}

// Every NumberOf...="n" of the XML part, against what compression can at most have hidden in the text.
void checkXmlCounts(const std::string& path, const std::string& bytes)
{
  const std::string text = bytes.substr(0, bytes.find("<AppendedData"));
  if (text.find("<VTKFile") == std::string::npos || text.find("PolyData") == std::string::npos)
  {
    throw Failed(path + ": is not an XML PolyData file (.vtp)");
  }
  for (std::size_t at = text.find("NumberOf"); at != std::string::npos; at = text.find("NumberOf", at + 8))
  {
    const std::size_t quote = text.find_first_of("\"'<>", at);
    if (quote != std::string::npos && (text[quote] == '"' || text[quote] == '\''))
    {
      const std::size_t end = text.find(text[quote], quote + 1);
      requireCount(path, text.substr(quote + 1, end - quote - 1), 2000.0 * static_cast<double>(bytes.size()));
    }
  }
}

// The value of an attribute of an XML tag, "" where it has none.
std::string attributeOf(const std::string& tag, const std::string& name)
{
  const std::size_t at = tag.find(' ' + name + '=');
  const std::size_t from = at + name.size() + 2;
  if (at == std::string::npos || from >= tag.size() || (tag[from] != '"' && tag[from] != '\''))
  {
    return "";
  }
  return tag.substr(from + 1, tag.find(tag[from], from + 1) - from - 1);
}

// vtkXMLPolyDataReader crashes where a part holds two arrays of a name.
void checkXmlArrays(const std::string& path, const std::string& bytes)
{
  static const std::set<std::string> parts = {
    "PointData", "CellData", "FieldData", "Points", "Verts", "Lines", "Strips", "Polys"
  };
  std::set<std::string> names;
  std::string part;
  for (std::size_t at = bytes.find('<'); at != std::string::npos; at = bytes.find('<', at + 1))
  {
    std::string tag = bytes.substr(at + 1, bytes.find('>', at) - at - 1);
    std::replace_if(
      tag.begin(), tag.end(), [](unsigned char c) { return std::isspace(c) != 0; }, ' ');
    const std::string kind = tag.substr(0, tag.find(' '));
    if (kind == "AppendedData")
    {
      return;
    }
    const bool isArray = kind == "DataArray" || kind == "Array";
    const std::string name = isArray ? attributeOf(tag, "Name") : "";
    if (parts.count(kind) == 1)
    {
      part = kind;
      names.clear();
    }
    else if (!name.empty() && !names.insert(name).second)
    {
      throw Failed(path + ": its " + part + " holds two arrays " + name + "; the file is damaged");
    }
  }
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> updated(Reader* reader, const std::string& path)
{
  takeError();
  reader->Update();
  vtkSmartPointer<vtkPolyData> mesh = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
  const std::string error = takeError();
  if (!error.empty())
  {
    throw Failed(path + ": could not be read: " + error);
  }
  return mesh;
}

// A .vtp file's content.
vtkSmartPointer<vtkPolyData> readXml(const std::string& path, const std::string& bytes)
{
  checkXmlCounts(path, bytes);
  checkXmlArrays(path, bytes);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  return updated(reader.Get(), path);
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> readWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  return updated(reader.Get(), path);
}

void requireArrays(const std::string& path, vtkDataSetAttributes* data, vtkIdType count, const char* what)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != count)
    {
      std::ostringstream message;
      message << path << ": array " << (array->GetName() ? array->GetName() : "without name") << " has "
              << array->GetNumberOfTuples() << " values for " << count << ' ' << what
              << "; the file is damaged";
      throw Failed(message.str());
    }
  }
}

// Points finite, ids in range, arrays complete.
void requireSound(const std::string& path, vtkPolyData* mesh)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  for (vtkIdType i = 0; i < points; ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      throw Failed(path + ": point " + std::to_string(i) + " is not finite; repair the file");
    }
  }
  for (vtkCellArray* cells : { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    if (!cells->IsValid())
    {
      throw Failed(path + ": its cells do not fit together (offsets beyond the connectivity); the file is damaged");
    }
    auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      it->GetCurrentCell(size, ids);
      if (std::any_of(ids, ids + size, [points](vtkIdType id) { return id < 0 || id >= points; }))
      {
        throw Failed(path + ": cell " + std::to_string(it->GetCurrentCellId()) +
                     " names a point that does not exist; the file is damaged");
      }
    }
  }
  requireArrays(path, mesh->GetPointData(), points, "points");
  requireArrays(path, mesh->GetCellData(), mesh->GetNumberOfCells(), "cells");
}

vtkSmartPointer<vtkPolyData> trianglesOf(const std::string& path, vtkPolyData* mesh, Notes& notes)
{
  const vtkIdType others = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const vtkIdType strips = mesh->GetNumberOfStrips();
  bool triangles = true;
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); triangles && !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    triangles = size == 3;
  }
  if (triangles && others + strips == 0)
  {
    return mesh;
  }
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(mesh);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->Update();
  takeError(); // a polygon that cannot be triangulated is left out
  vtkSmartPointer<vtkPolyData> result = filter->GetOutput();
  if (!triangles || strips > 0)
  {
    notes.push_back(path + ": its polygons are triangulated (" + std::to_string(result->GetNumberOfPolys()) +
                    " triangles)");
  }
  if (others > 0)
  {
    notes.push_back(path + ": " + std::to_string(others) + " lines and vertices are dropped");
  }
  return result;
}

vtkSmartPointer<vtkPolyData> soundTriangles(const std::string& path, vtkPolyData* read, Notes& notes)
{
  if (!read || read->GetNumberOfPoints() == 0)
  {
    throw Failed(path + ": holds no points; the file is empty or damaged");
  }
  requireSound(path, read);
  vtkSmartPointer<vtkPolyData> mesh = trianglesOf(path, read, notes);
  if (mesh->GetNumberOfPolys() == 0)
  {
    throw Failed(path + ": holds no polygons; a surface mesh is needed");
  }
  return mesh;
}

} // namespace

vtkSmartPointer<vtkPolyData> readMesh(const std::string& path, Notes& notes)
{
  const std::uintmax_t size = requireReadable(path);
  const std::string extension = extensionOf(path);
  vtkSmartPointer<vtkPolyData> mesh;
  if (extension == ".obj")
  {
    mesh = readObj(path, notes);
  }
  else if (extension == ".ply")
  {
    mesh = readPly(path);
  }
  else if (extension == ".stl")
  {
    checkStl(path, size);
    mesh = readWith<vtkSTLReader>(path);
  }
  else if (extension == ".off")
  {
    mesh = readOff(path);
  }
  else if (extension == ".vtp")
  {
    mesh = readXml(path, wholeFile(path));
  }
  else if (extension == ".gltf" || extension == ".glb")
  {
    mesh = readGltf(path, notes);
  }
  else
  {
    throw Failed(path + ": is none of the mesh formats " + meshExtensions);
  }
  return soundTriangles(path, mesh, notes);
}

vtkSmartPointer<vtkPolyData> parseMesh(const std::string& name, const std::string& bytes)
{
  Notes none;
  return soundTriangles(name, readXml(name, bytes), none);
}

vtkSmartPointer<vtkPolyData> readStroke(const std::string& path)
{
  requireReadable(path);
  const std::string head = headOf(path, 64);
  if (extensionOf(path) == ".vtk" || head.rfind("# vtk DataFile", 0) == 0)
  {
    throw Failed(
      path + ": is a legacy VTK file, which as text loses digits of the view that a stroke carries; save the "
             "stroke as XML PolyData (.vtp)");
  }
  if (extensionOf(path) != ".vtp")
  {
    throw Failed(path + ": a stroke file is XML PolyData (.vtp)");
  }
  return parseStroke(path, wholeFile(path));
}

vtkSmartPointer<vtkPolyData> parseStroke(const std::string& path, const std::string& bytes)
{
  const vtkSmartPointer<vtkPolyData> stroke = readXml(path, bytes);
  if (!stroke || stroke->GetNumberOfPoints() == 0 || stroke->GetNumberOfLines() == 0)
  {
    throw Failed(path + ": holds no polyline; the file is empty or damaged");
  }
  requireSound(path, stroke);
  return stroke;
}

} // namespace oversketch_files
