#include "mesh_file.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <sstream>

namespace oversketch_files
{

namespace
{

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Polygon = std::vector<std::size_t>;

// The counts in the header, against the size of the file: CGAL's reader allocates what they say. A count of
// points or faces needs at least two bytes each in either form.
void requireCounts(const std::string& path)
{
  const double size = static_cast<double>(requireReadable(path));
  std::ifstream stream(path, std::ios::binary);
  std::string line;
  std::getline(stream, line);
  if (line.find("OFF") == std::string::npos)
  {
    throw Failed(path + ": is not an OFF file");
  }
  if (line.find("BINARY") != std::string::npos)
  {
    return;
  }
  line.erase(0, line.find("OFF") + 3);
  while (line.find_first_not_of(" \t\r") == std::string::npos || line[line.find_first_not_of(" \t\r")] == '#')
  {
    if (!std::getline(stream, line))
    {
      throw Failed(path + ": its OFF header does not end; the file is damaged");
    }
  }
  double points = 0.0, faces = 0.0;
  std::istringstream words(line);
  if (!(words >> points >> faces) || !(points >= 0.0) || !(faces >= 0.0) || points + faces > size)
  {
    throw Failed(path + ": announces more elements than a file of its size can hold");
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> readOff(const std::string& path)
{
  requireCounts(path);
  std::vector<Point> soup;
  std::vector<Polygon> polygons;
  std::ifstream stream(path, std::ios::binary);
  if (!CGAL::IO::read_OFF(stream, soup, polygons))
  {
    throw Failed(path + ": could not be read as OFF; the file is truncated or damaged");
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : soup)
  {
    points->InsertNextPoint(p.x(), p.y(), p.z());
  }
  vtkNew<vtkCellArray> polys;
  for (const Polygon& polygon : polygons)
  {
    polys->InsertNextCell(static_cast<int>(polygon.size()));
    for (const std::size_t id : polygon)
    {
      polys->InsertCellPoint(static_cast<vtkIdType>(id));
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

void writeOff(vtkPolyData* mesh, const std::string& path)
{
  std::vector<Point> soup;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    soup.emplace_back(p[0], p[1], p[2]);
  }
  std::vector<Polygon> polygons;
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    polygons.emplace_back(ids, ids + size);
  }
  std::ofstream stream(path, std::ios::binary);
  stream.precision(17);
  CGAL::IO::write_OFF(stream, soup, polygons, CGAL::parameters::stream_precision(17));
  stream.close();
  if (!stream)
  {
    throw Failed(path + ": could not be written (is the disk full?)");
  }
}

} // namespace oversketch_files
