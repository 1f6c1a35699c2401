// OFF, text and binary, also with colours, normals or texture coordinates at the vertices (COFF, NOFF,
// STOFF), which are read over. Why not CGAL's reader: it allocates what a file announces and reads on behind
// a bad word.
#include "mesh_file.h"
#include "text.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace oversketch_files
{

namespace
{

// The numbers of an OFF file one after the other, as words or as big-endian words of four bytes.
class Numbers
{
public:
  explicit Numbers(const std::string& path)
    : Path(path)
    , Bytes(wholeFile(path))
  {
    Words words(this->Bytes);
    std::string_view line;
    words.line(line);
    Words first(line);
    const std::string_view keyword = first.next();
    const std::size_t at = keyword.find("OFF");
    if (at == std::string_view::npos || keyword.substr(at) != "OFF" || keyword.find('n') < at ||
        keyword.find('4') < at)
    {
      this->refuse("is not an OFF file of points in space");
    }
    this->Binary = first.next() == "BINARY";
    this->At =
      this->Binary ? words.at() : static_cast<std::size_t>(keyword.data() + at + 3 - this->Bytes.data());
    this->Extra = (keyword.find('N') < at ? 3 : 0) + (keyword.find("ST") < at ? 2 : 0);
    this->Coloured = keyword.find('C') < at;
  }

  [[noreturn]] void refuse(const std::string& why) const { throw Failed(this->Path + ": " + why); }

  double number()
  {
    if (this->Binary)
    {
      const std::uint32_t word = this->binary();
      float value;
      std::memcpy(&value, &word, 4);
      return value;
    }
    const std::string_view word = this->word();
    const std::optional<double> value = numberOf(word);
    if (!value)
    {
      this->refuse(word.empty()
                     ? "ends before all that its header announces; the file is truncated or damaged"
                     : "holds " + inQuotes(word) + " where a number should be; the file is damaged");
    }
    return *value;
  }

  // A whole number from 0 to `most`; `what` is for the message.
  std::size_t whole(const char* what, std::size_t most = 2147483647)
  {
    const double value = this->Binary ? static_cast<std::int32_t>(this->binary()) : this->number();
    if (!(value >= 0.0 && value <= static_cast<double>(most)) || value != std::floor(value))
    {
      std::ostringstream message;
      message << "announces " << std::setprecision(12) << value << " as " << what
              << ", which cannot be in a file of its size; it is damaged";
      this->refuse(message.str());
    }
    return static_cast<std::size_t>(value);
  }

  // A count of what takes at least two bytes each.
  std::size_t count(const char* what) { return this->whole(what, this->Bytes.size() / 2); }

  // What may follow a vertex' coordinates or a face's corners.
  void skipRest(bool isFace)
  {
    if (this->Binary)
    {
      const std::size_t ofPoint = this->Extra + (this->Coloured ? 4 : 0);
      for (std::size_t left = isFace ? this->count("the number of a face's colours") : ofPoint; left > 0;
           --left)
      {
        this->binary();
      }
      return;
    }
    if (!isFace && this->Extra == 0 && !this->Coloured)
    {
      return; // further points may follow in the line
    }
    const std::size_t end = this->Bytes.find('\n', this->At);
    this->At = end == std::string::npos ? this->Bytes.size() : end;
  }

private:
  std::string_view word()
  {
    for (;;)
    {
      Words words(this->Bytes, this->At);
      const std::string_view word = words.next();
      if (word.empty() || word[0] != '#')
      {
        this->At = words.at();
        return word;
      }
      const std::size_t end =
        this->Bytes.find('\n', static_cast<std::size_t>(word.data() - this->Bytes.data()));
      this->At = end == std::string::npos ? this->Bytes.size() : end;
    }
  }

  std::uint32_t binary()
  {
    if (this->Bytes.size() - this->At < 4)
    {
      this->refuse("ends before all that its header announces; the file is truncated or damaged");
    }
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i)
    {
      value = value << 8 | static_cast<unsigned char>(this->Bytes[this->At++]);
    }
    return value;
  }

  std::string Path;
  std::string Bytes;
  std::size_t At = 0, Extra = 0;
  bool Binary = false, Coloured = false;
};

} // namespace

vtkSmartPointer<vtkPolyData> readOff(const std::string& path)
{
  Numbers numbers(path);
  const std::size_t count = numbers.count("the number of its points");
  const std::size_t faces = numbers.count("the number of its faces");
  numbers.whole("the number of its edges");
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t i = 0; i < count; ++i)
  {
    std::array<double, 3> point{};
    for (double& x : point)
    {
      x = numbers.number();
    }
    points->InsertNextPoint(point.data());
    numbers.skipRest(false);
  }
  vtkNew<vtkCellArray> polys;
  std::vector<vtkIdType> corners;
  for (std::size_t i = 0; i < faces; ++i)
  {
    corners.resize(numbers.count("the number of a face's corners"));
    for (vtkIdType& corner : corners)
    {
      const std::size_t id = numbers.whole("a point's number");
      if (id >= count)
      {
        numbers.refuse("its face " + std::to_string(i) + " names the point " + std::to_string(id) +
                       ", and there are " + std::to_string(count) + ", counted from 0; the file is damaged");
      }
      corner = static_cast<vtkIdType>(id);
    }
    polys->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    numbers.skipRest(true);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

void writeOff(vtkPolyData* mesh, const std::string& path)
{
  std::ofstream stream(path, std::ios::binary);
  stream << "OFF\n" << mesh->GetNumberOfPoints() << ' ' << mesh->GetNumberOfPolys() << " 0\n";
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    char text[96];
    std::snprintf(text, sizeof text, "%.17g %.17g %.17g\n", p[0], p[1], p[2]);
    stream << text;
  }
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    stream << size;
    for (vtkIdType k = 0; k < size; ++k)
    {
      stream << ' ' << ids[k];
    }
    stream << '\n';
  }
  stream.close();
  if (!stream)
  {
    throw Failed(path + ": could not be written (is the disk full?)");
  }
}

} // namespace oversketch_files
