// OFF, text and binary, also with colours, normals or texture coordinates at the vertices (COFF, NOFF,
// STOFF), and colours of faces. Why not CGAL's reader: it allocates what a file announces and reads on behind
// a bad word.
#include "colours.h"
#include "mesh_file.h"
#include "number_file.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace oversketch_files
{

namespace
{

// The numbers of an OFF file one after the other, as words or as big-endian words of four bytes.
class OffNumbers : public NumberFile
{
public:
  explicit OffNumbers(const std::string& path)
    : NumberFile(path)
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
    this->hasNormals = keyword.find('N') < at;
    this->hasCoordinates = keyword.find("ST") < at;
    this->hasColours = keyword.find('C') < at;
    this->BigEndian = this->Binary = first.next() == "BINARY";
    this->At =
      this->Binary ? words.at() : static_cast<std::size_t>(keyword.data() + at + 3 - this->Bytes.data());
    auto comment = this->Bytes.begin() + static_cast<std::ptrdiff_t>(this->At);
    while (!this->Binary && (comment = std::find(comment, this->Bytes.end(), '#')) != this->Bytes.end())
    {
      const auto end = std::find(comment, this->Bytes.end(), '\n');
      std::fill(comment, end, ' ');
      comment = end;
    }
  }

  double number() { return this->NumberFile::number(VTK_FLOAT); }

  // A whole number from 0 to `most`; `what` is for the message.
  std::size_t whole(const char* what, std::size_t most = 2147483647)
  {
    const double value = this->NumberFile::number(VTK_INT);
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

  // The numbers of a colour, from 0 to 1, from 0 to 255, or one of a list of colours, with `behind` more
  // numbers up to the end of the line.
  std::vector<double> colour(bool isFace, std::size_t behind = 0)
  {
    std::vector<double> values;
    if (this->Binary)
    {
      const std::size_t count = isFace ? this->count("the number of a face's colours") : 4;
      for (std::size_t k = 0; k < count; ++k)
      {
        values.push_back(this->number());
      }
      return values;
    }
    const std::size_t end = std::min(this->Bytes.find('\n', this->At), this->Bytes.size());
    const std::string_view line(this->Bytes.data() + this->At, end - this->At);
    std::vector<std::string_view> words;
    Words all(line);
    for (std::string_view word = all.next(); !word.empty(); word = all.next())
    {
      words.push_back(word);
    }
    words.resize(words.size() - std::min(behind, words.size()));
    const bool whole = std::all_of(words.begin(),
      words.end(),
      [](std::string_view word) { return word.find_first_of(".eE") == std::string_view::npos; });
    for (std::size_t k = 0; k < words.size(); ++k)
    {
      values.push_back(this->number() / (whole ? 255.0 : 1.0));
    }
    return values;
  }

  bool hasNormals = false, hasCoordinates = false, hasColours = false;
};

// Colours as they come, three or four numbers each; some have none.
class OffColours
{
public:
  void add(const std::vector<double>& values)
  {
    this->Any = this->Any || values.size() == 3 || values.size() == 4;
    this->Opacity = this->Opacity || values.size() == 4;
    this->OfList = this->OfList || (!values.empty() && values.size() != 3 && values.size() != 4);
    std::array<double, 4> colour = { 1.0, 1.0, 1.0, 1.0 };
    if (values.size() == 3 || values.size() == 4)
    {
      std::copy(values.begin(), values.end(), colour.begin());
    }
    this->All.push_back(colour);
  }

  void set(vtkDataSetAttributes* data) const
  {
    std::vector<double> values;
    for (const std::array<double, 4>& colour : this->All)
    {
      values.insert(values.end(), colour.begin(), colour.begin() + (this->Opacity ? 4 : 3));
    }
    if (this->Any)
    {
      setColours(data, values, this->Opacity ? 4 : 3);
    }
  }

  // Whether some are numbers of a list of colours, which the file does not hold.
  bool isOfList() const { return this->OfList; }

private:
  std::vector<std::array<double, 4>> All;
  bool Any = false, Opacity = false, OfList = false;
};

vtkSmartPointer<vtkDoubleArray> tuplesOf(const char* name, int components)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

// The next tuple, where the file has such.
void readOffTuple(OffNumbers& numbers, bool has, vtkDoubleArray* array)
{
  std::array<double, 3> tuple{};
  for (int k = 0; has && k < array->GetNumberOfComponents(); ++k)
  {
    tuple[static_cast<std::size_t>(k)] = numbers.number();
  }
  if (has)
  {
    array->InsertNextTuple(tuple.data());
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> readOff(const std::string& path, Notes& notes)
{
  OffNumbers numbers(path);
  const std::size_t count = numbers.count("the number of its points");
  const std::size_t faces = numbers.count("the number of its faces");
  numbers.whole("the number of its edges");
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto normals = tuplesOf("Normals", 3), coordinates = tuplesOf("TCoords", 2);
  OffColours colours, ofFaces;
  for (std::size_t i = 0; i < count; ++i)
  {
    std::array<double, 3> point{};
    for (double& x : point)
    {
      x = numbers.number();
    }
    points->InsertNextPoint(point.data());
    readOffTuple(numbers, numbers.hasNormals, normals);
    if (numbers.hasColours)
    {
      colours.add(numbers.colour(false, numbers.hasCoordinates ? 2 : 0));
    }
    readOffTuple(numbers, numbers.hasCoordinates, coordinates);
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
    ofFaces.add(numbers.colour(true));
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  if (numbers.hasNormals)
  {
    mesh->GetPointData()->SetNormals(normals);
  }
  if (numbers.hasCoordinates)
  {
    mesh->GetPointData()->SetTCoords(coordinates);
  }
  colours.set(mesh->GetPointData());
  ofFaces.set(mesh->GetCellData());
  if (colours.isOfList() || ofFaces.isOfList())
  {
    notes.push_back(path + ": colours that are numbers of a list of colours are lost");
  }
  return mesh;
}

namespace
{

void writeOffNumbers(std::ostream& stream, vtkDataArray* array, vtkIdType at, int count)
{
  for (int k = 0; array && k < count; ++k)
  {
    stream << ' ' << array->GetComponent(at, k);
  }
}

// Bytes as whole numbers, others with a point, by which readers tell them apart.
void writeOffColour(std::ostream& stream, vtkDataArray* colours, vtkIdType at)
{
  for (int k = 0; colours && k < colours->GetNumberOfComponents(); ++k)
  {
    char text[32];
    areBytes(colours) ? std::snprintf(text, sizeof text, " %d", colourByte(colours, at, k))
                      : std::snprintf(text, sizeof text, " %.9f", colourShare(colours, at, k));
    stream << text;
  }
}

} // namespace

void writeOff(vtkPolyData* mesh, const std::string& path)
{
  std::ofstream stream(path, std::ios::binary);
  vtkDataArray* normals = usable(mesh->GetPointData()->GetNormals(), 3, mesh->GetNumberOfPoints());
  vtkDataArray* coordinates = usable(mesh->GetPointData()->GetTCoords(), 2, mesh->GetNumberOfPoints());
  vtkDataArray* colours = coloursOf(mesh);
  vtkDataArray* ofFaces = faceColoursOf(mesh);
  stream << (coordinates ? "ST" : "") << (colours ? "C" : "") << (normals ? "N" : "") << "OFF\n"
         << mesh->GetNumberOfPoints() << ' ' << mesh->GetNumberOfPolys() << " 0\n"
         << std::setprecision(17);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    stream << p[0] << ' ' << p[1] << ' ' << p[2];
    writeOffNumbers(stream, normals, i, 3);
    writeOffColour(stream, colours, i);
    writeOffNumbers(stream, coordinates, i, 2);
    stream << '\n';
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    stream << ids->GetNumberOfIds();
    for (const vtkIdType id : *ids)
    {
      stream << ' ' << id;
    }
    writeOffColour(stream, ofFaces, face);
    stream << '\n';
  }
  closeWhole(stream, path);
}

} // namespace oversketch_files
