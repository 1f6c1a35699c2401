// Why not vtkOBJReader alone: in VTK 9.3 it counts relative indices (-1 is the last one so far) of texture
// coordinates and normals by the number of the other, so it is given absolute ones.
#include "mesh_file.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>

#include <sys/mman.h>
#include <unistd.h>

namespace oversketch_files
{

namespace
{

bool isElement(const std::string& line)
{
  return line.size() > 1 && (line[0] == 'f' || line[0] == 'l' || line[0] == 'p') &&
         (line[1] == ' ' || line[1] == '\t');
}

// A corner, v/vt/vn, with absolute indices.
std::string absolute(const std::string& corner, const long (&counts)[3])
{
  std::istringstream parts(corner);
  std::string part, text;
  for (int k = 0; std::getline(parts, part, '/'); ++k)
  {
    const long index = part.empty() ? 0 : std::strtol(part.c_str(), nullptr, 10);
    text += (k > 0 ? "/" : "") + (index < 0 && k < 3 ? std::to_string(counts[k] + 1 + index) : part);
  }
  return text;
}

// The largest index that was used of each kind, v, vt, vn, and where.
class Indices
{
public:
  explicit Indices(const std::string& path)
    : Path(path)
  {
  }

  // The corners of a line, with `counts` of each kind before it.
  void add(const std::string& line, long number, const long (&counts)[3])
  {
    for (const char* at = line.c_str() + 1; *at != '\0';)
    {
      at += std::strspn(at, " \t\r");
      for (int k = 0; k < 3; ++k)
      {
        char* end = nullptr;
        const long given = std::strtol(at, &end, 10), index = given < 0 ? counts[k] + 1 + given : given;
        if (end != at && index < 1)
        {
          this->refuse(number, k, given, counts[k]);
        }
        if (end != at && index > this->Most[k])
        {
          this->Most[k] = index;
          this->Line[k] = number;
        }
        at = end;
        if (*at != '/')
        {
          break;
        }
        ++at;
      }
      at += std::strcspn(at, " \t\r");
    }
  }

  void requireWithin(const long (&counts)[3]) const
  {
    for (int k = 0; k < 3; ++k)
    {
      if (this->Most[k] > counts[k])
      {
        this->refuse(this->Line[k], k, this->Most[k], counts[k]);
      }
    }
  }

private:
  [[noreturn]] void refuse(long line, int kind, long index, long count) const
  {
    const char* const kinds[] = { "vertex", "texture coordinate", "normal" };
    throw Failed(this->Path + ": line " + std::to_string(line) + " names the " + kinds[kind] + ' ' +
                 std::to_string(index) + ", and there are " + std::to_string(count) +
                 ", counted from 1; the file is damaged");
  }

  std::string Path;
  long Most[3] = { 0, 0, 0 }, Line[3] = { 0, 0, 0 };
};

bool isKeyword(const std::string& line, const char* keyword, std::size_t length)
{
  return line.compare(0, length, keyword) == 0 && line.size() > length && (line[length] == ' ' || line[length] == '\t');
}

// The text of the file with absolute indices; "" where it has no others. Throws Failed where one names what is
// not there: vtkOBJReader would read past its arrays.
std::string withAbsoluteIndices(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  Indices indices(path);
  long counts[3] = { 0, 0, 0 }; // v, vt, vn so far
  long number = 0;
  bool relative = false;
  std::string text;
  for (std::string line; std::getline(file, line);)
  {
    ++number;
    line.erase(0, std::min(line.find_first_not_of(" \t"), line.size()));
    counts[0] += isKeyword(line, "v", 1);
    counts[1] += isKeyword(line, "vt", 2);
    counts[2] += isKeyword(line, "vn", 2);
    if (isElement(line))
    {
      indices.add(line, number, counts);
    }
    if (isElement(line) && line.find('-') != std::string::npos)
    {
      relative = true;
      std::istringstream words(line);
      std::string word;
      words >> line;
      while (words >> word)
      {
        line += ' ' + absolute(word, counts);
      }
    }
    text += line + '\n';
  }
  indices.requireWithin(counts);
  return relative ? text : "";
}

// A file in memory with that text, until it goes.
class MemoryFile
{
public:
  explicit MemoryFile(const std::string& text)
    : Descriptor(memfd_create("oversketch.obj", MFD_CLOEXEC))
  {
    std::ofstream stream(this->path(), std::ios::binary);
    stream << text;
    stream.close();
    if (this->Descriptor < 0 || !stream)
    {
      throw Failed("an OBJ file with relative indices could not be kept in memory");
    }
  }
  ~MemoryFile() { close(this->Descriptor); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(this->Descriptor); }

private:
  int Descriptor;
};

// vtkOBJReader leaves group ids short where a file holds lines or points besides faces.
void dropIncompleteArrays(const std::string& path, vtkPolyData* mesh, Notes& notes)
{
  vtkCellData* data = mesh->GetCellData();
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (data->GetAbstractArray(i)->GetNumberOfTuples() != mesh->GetNumberOfCells())
    {
      notes.push_back(path + ": the cell array " + data->GetArrayName(i) + " is incomplete and dropped");
      data->RemoveArray(i);
    }
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> readObj(const std::string& path, Notes& notes)
{
  const std::string text = withAbsoluteIndices(path);
  const auto file = text.empty() ? nullptr : std::make_unique<const MemoryFile>(text);
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName((file ? file->path() : path).c_str());
  takeError();
  reader->Update();
  const std::string error = takeError();
  if (!error.empty())
  {
    throw Failed(path + ": could not be read: " + error);
  }
  vtkSmartPointer<vtkPolyData> mesh = reader->GetOutput();
  readObjMaterials(mesh, path, notes);
  dropIncompleteArrays(path, mesh, notes);
  return mesh;
}

} // namespace oversketch_files
