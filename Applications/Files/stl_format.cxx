// STL, binary and text. Why not vtkSTLReader: it hashes points that are not finite, cuts lines at 255 bytes,
// reads on where a count is wrong, rounds text to single precision and passes colours over.
#include "colours.h"
#include "mesh_file.h"
#include "text.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTriangle.h"

#include <boost/functional/hash.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <unordered_map>

namespace oversketch_files
{

namespace
{

using StlCorner = std::array<double, 3>;

std::size_t triangleCount(const std::string& bytes)
{
  return wholeAt(bytes, 80, 4, false);
}

// Some programs begin binary files with "solid", too: the size tells.
bool isBinary(const std::string& bytes)
{
  const std::string head = bytes.substr(0, 4096);
  return bytes.size() == 84 + 50 * triangleCount(bytes) || head.rfind("solid", 0) != 0 ||
         head.find("facet") == std::string::npos;
}

std::vector<StlCorner> binaryCorners(const std::string& path, const std::string& bytes)
{
  const std::size_t count = triangleCount(bytes);
  if (bytes.size() < 84 || (bytes.size() - 84) / 50 < count)
  {
    refuse(path,
      "announces " + std::to_string(count) +
        " triangles, but ends before; the file is truncated or not an STL file");
  }
  std::vector<StlCorner> corners(3 * count);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    std::array<float, 3> corner;
    std::memcpy(corner.data(), bytes.data() + 84 + 50 * (i / 3) + 12 + 12 * (i % 3), 12); // behind the normal
    corners[i] = { corner[0], corner[1], corner[2] };
  }
  return corners;
}

// The colours of a binary file's triangles, from 0 to 1, empty where there are none: five bits each in the
// two bytes behind a triangle. VisCAM and SolidView mark a colour by the highest bit and begin with blue;
// Magics marks what has none, for which its header names one, and begins with red.
std::vector<double> binaryColours(const std::string& bytes)
{
  const std::size_t named = bytes.substr(0, 80).find("COLOR=");
  const bool isMagics = named != std::string::npos && named + 10 <= 80;
  std::array<double, 3> usual = { 1.0, 1.0, 1.0 };
  for (std::size_t k = 0; isMagics && k < 3; ++k)
  {
    usual[k] = static_cast<unsigned char>(bytes[named + 6 + k]) / 255.0;
  }
  std::vector<double> colours;
  bool any = isMagics;
  for (std::size_t i = 0; i < triangleCount(bytes); ++i)
  {
    const std::uint64_t word = wholeAt(bytes, 84 + 50 * i + 48, 2, false);
    const bool own = (word >> 15 != 0) != isMagics;
    any = any || own;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto bits = static_cast<double>(word >> (isMagics ? 5 * k : 10 - 5 * k) & 31);
      colours.push_back(own ? std::round(bits * 255.0 / 31.0) / 255.0 : usual[k]);
    }
  }
  return any ? colours : std::vector<double>();
}

// "vertex x y z" of each "facet"; what else there is says nothing about triangles.
std::vector<StlCorner> textCorners(const std::string& path, const std::string& text)
{
  std::vector<StlCorner> corners;
  Words words(text);
  std::string_view line;
  bool ended = false; // with "endsolid"
  for (long number = 1; words.line(line); ++number)
  {
    const std::string where = "line " + std::to_string(number);
    Words in(line);
    const std::string keyword = lowerCase(in.next());
    ended = keyword == "endsolid" || (ended && keyword.empty());
    if ((keyword == "facet" || keyword == "endfacet" || keyword == "endsolid") && corners.size() % 3 != 0)
    {
      refuse(path, "the triangle before " + where + " has not three corners; the file is damaged");
    }
    if (keyword != "vertex")
    {
      continue;
    }
    StlCorner corner{};
    for (double& x : corner)
    {
      x = numberOf(in.next(), path, number);
    }
    corners.push_back(corner);
  }
  if (!ended)
  {
    refuse(path, "ends without endsolid; the file is truncated");
  }
  return corners;
}

} // namespace

vtkSmartPointer<vtkPolyData> readStl(const std::string& path, Notes&)
{
  const std::string bytes = wholeFile(path);
  const bool binary = isBinary(bytes);
  const std::vector<StlCorner> corners = binary ? binaryCorners(path, bytes) : textCorners(path, bytes);
  const std::vector<double> colours = binary ? binaryColours(bytes) : std::vector<double>();
  std::vector<double> kept; // of triangles of three points
  vtkNew<vtkPoints> points;
  points->SetDataType(binary ? VTK_FLOAT : VTK_DOUBLE);
  vtkNew<vtkCellArray> polys;
  std::unordered_map<StlCorner, vtkIdType, boost::hash<StlCorner>> known;
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    std::array<vtkIdType, 3> ids{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const StlCorner& corner = corners[i + k];
      if (!std::isfinite(corner[0]) || !std::isfinite(corner[1]) || !std::isfinite(corner[2]))
      {
        refuse(
          path, "triangle " + std::to_string(i / 3) + " has a corner that is not finite; repair the file");
      }
      const auto [it, isNew] = known.emplace(corner, points->GetNumberOfPoints());
      if (isNew)
      {
        points->InsertNextPoint(corner.data());
      }
      ids[k] = it->second;
    }
    if (ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0])
    {
      polys->InsertNextCell(3, ids.data());
      for (std::size_t k = 0; !colours.empty() && k < 3; ++k)
      {
        kept.push_back(colours[i + k]);
      }
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  if (!kept.empty())
  {
    setColours(mesh->GetCellData(), kept, 3);
  }
  return mesh;
}

bool fitsStl(vtkDataArray* faceColours)
{
  for (vtkIdType i = 0; faceColours && i < faceColours->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      const double bits = 31.0 * colourShare(faceColours, i, k);
      if (std::abs(bits - std::round(bits)) > 0.07 || (k == 3 && bits != 31.0)) // what a byte rounds
      {
        return false;
      }
    }
  }
  return true;
}

void writeStl(vtkPolyData* mesh, const std::string& path)
{
  std::string bytes = "Oversketch";
  bytes.resize(80, ' ');
  put(bytes, static_cast<std::uint32_t>(mesh->GetNumberOfPolys()));
  vtkDataArray* colours = faceColoursOf(mesh);
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    double p[3][3], normal[3];
    for (int k = 0; k < 3; ++k)
    {
      mesh->GetPoint(ids->GetId(k), p[k]);
    }
    vtkTriangle::ComputeNormal(p[0], p[1], p[2], normal);
    for (const double* tuple : { normal, p[0], p[1], p[2] })
    {
      for (int k = 0; k < 3; ++k)
      {
        put(bytes, static_cast<float>(tuple[k]));
      }
    }
    std::uint16_t word = 0; // as VisCAM and SolidView read it
    for (int k = 0; colours && k < 3; ++k)
    {
      const auto bits = static_cast<unsigned>(std::lround(31.0 * colourShare(colours, face, k)));
      word = static_cast<std::uint16_t>(word | 1U << 15 | bits << (10 - 5 * k));
    }
    put(bytes, word);
  }
  std::ofstream stream(path, std::ios::binary);
  stream << bytes;
  closeWhole(stream, path);
}

} // namespace oversketch_files
