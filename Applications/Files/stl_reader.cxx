// STL, binary and text. Why not vtkSTLReader: it hashes points that are not finite, cuts lines at 255 bytes,
// and reads on where a count is wrong.
#include "mesh_file.h"
#include "text.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <unordered_map>

namespace oversketch_files
{

namespace
{

using StlCorner = std::array<float, 3>;

struct StlCornerHash
{
  std::size_t operator()(const StlCorner& corner) const
  {
    std::size_t hash = 0;
    for (const float x : corner)
    {
      hash = hash * 1000003 ^ std::hash<float>()(x); // of -0 as of 0
    }
    return hash;
  }
};

[[noreturn]] void refuseStl(const std::string& path, const std::string& why)
{
  throw Failed(path + ": " + why);
}

std::vector<StlCorner> binaryCorners(const std::string& path, const std::string& bytes)
{
  std::uint32_t count = 0;
  if (bytes.size() >= 84)
  {
    std::memcpy(&count, bytes.data() + 80, 4);
  }
  if (bytes.size() < 84 || (bytes.size() - 84) / 50 < count)
  {
    refuseStl(path,
      "announces " + std::to_string(count) +
        " triangles, but ends before; the file is truncated or not an STL file");
  }
  std::vector<StlCorner> corners(3 * static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    std::memcpy(corners[3 * i].data(), bytes.data() + 84 + 50 * i + 12, 36); // behind the normal
  }
  return corners;
}

// "vertex x y z" of each "facet"; what else there is says nothing about triangles.
std::vector<StlCorner> textCorners(const std::string& path, const std::string& text)
{
  std::vector<StlCorner> corners;
  Words words(text);
  std::string_view line;
  bool ended = false; // with "endsolid"
  for (std::size_t number = 1; words.line(line); ++number)
  {
    const std::string where = "line " + std::to_string(number);
    Words in(line);
    std::string keyword(in.next());
    for (char& c : keyword)
    {
      c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    ended = keyword == "endsolid" || (ended && keyword.empty());
    if ((keyword == "facet" || keyword == "endfacet" || keyword == "endsolid") && corners.size() % 3 != 0)
    {
      refuseStl(path, "the triangle before " + where + " has not three corners; the file is damaged");
    }
    if (keyword != "vertex")
    {
      continue;
    }
    StlCorner corner{};
    for (float& x : corner)
    {
      const std::string_view word = in.next();
      const std::optional<double> value = numberOf(word);
      if (!value)
      {
        refuseStl(path, where + " has " + inQuotes(word) + " where a number should be; the file is damaged");
      }
      x = static_cast<float>(*value);
    }
    corners.push_back(corner);
  }
  if (!ended)
  {
    refuseStl(path, "ends without endsolid; the file is truncated");
  }
  return corners;
}

} // namespace

vtkSmartPointer<vtkPolyData> readStl(const std::string& path)
{
  const std::string bytes = wholeFile(path);
  const std::string head = bytes.substr(0, 4096);
  const bool isText = head.rfind("solid", 0) == 0 && head.find("facet") != std::string::npos;
  const std::vector<StlCorner> corners = isText ? textCorners(path, bytes) : binaryCorners(path, bytes);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  std::unordered_map<StlCorner, vtkIdType, StlCornerHash> known;
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    std::array<vtkIdType, 3> ids{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const StlCorner& corner = corners[i + k];
      if (!std::isfinite(corner[0]) || !std::isfinite(corner[1]) || !std::isfinite(corner[2]))
      {
        refuseStl(
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
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

} // namespace oversketch_files
