// Drawings on a canvas of 800 x 600 world units, px for px, and what the system makes of them. Header-only.
#ifndef oversketch_filters_inflate_drawing_testing_drawing_runs_h
#define oversketch_filters_inflate_drawing_testing_drawing_runs_h

#include "Harness/drawings.h"
#include "Harness/promises.h"
#include "Harness/shipped.h"
#include "vtkOversketchInflateDrawing.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace oversketch_test
{

using oversketch::Vector2;
using oversketch::Vector3;

struct Line
{
  std::vector<Vector2> points;
  bool closed = true;
};

inline Line circle(double x, double y, double radius)
{
  return { ring({ x, y }, radius, std::max(24, int(radius))), true };
}

inline vtkSmartPointer<vtkPolyData> drawn(const std::vector<Line>& lines)
{
  const View view = viewOver({ 0.0, 0.0 }, { 800.0, 600.0 }, 800, 600);
  vtkNew<vtkAppendPolyData> all;
  all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const Line& line : lines)
  {
    std::vector<Vector2> points = line.points;
    if (line.closed)
    {
      points.push_back(points[0]);
    }
    all->AddInputData(toStroke(points, view));
  }
  all->Update();
  return all->GetOutput();
}

// Euler's number; whether every edge has exactly two faces, which pass it in opposite directions, and the
// faces about each vertex are one cycle; how many pieces hang together.
struct Topology
{
  int chi = 0, pieces = 0;
  bool closed = true, manifold = true;
};

using Corners = std::vector<std::vector<vtkIdType>>;

inline Corners cornersOf(vtkPolyData* mesh)
{
  Corners corners;
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    corners.emplace_back(ids->begin(), ids->end());
  }
  return corners;
}

inline Topology topologyOf(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  // About a vertex: the face's corner after it leads to the one before it.
  std::map<vtkIdType, std::map<vtkIdType, vtkIdType>> fans;
  for (const std::vector<vtkIdType>& face : cornersOf(mesh))
  {
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k)
    {
      ++edges[{ face[k], face[(k + 1) % n] }];
      fans[face[k]][face[(k + 1) % n]] = face[(k + n - 1) % n];
    }
  }
  Topology topology;
  int count = 0;
  for (const auto& [edge, times] : edges)
  {
    const auto back = edges.find({ edge.second, edge.first });
    topology.closed = topology.closed && times == 1 && back != edges.end() && back->second == 1;
    count += edge.first < edge.second || back == edges.end();
  }
  topology.chi = int(fans.size()) - count + int(mesh->GetNumberOfPolys());
  std::set<vtkIdType> reached;
  for (const auto& [vertex, fan] : fans)
  {
    std::size_t steps = 0;
    vtkIdType at = fan.begin()->first;
    do
    {
      const auto next = fan.find(at);
      at = next == fan.end() ? -1 : next->second;
      ++steps;
    } while (at >= 0 && at != fan.begin()->first && steps <= fan.size());
    topology.manifold = topology.manifold && at == fan.begin()->first && steps == fan.size();
    topology.pieces += reached.insert(vertex).second;
    for (std::vector<vtkIdType> left{ vertex }; !left.empty();)
    {
      const vtkIdType from = left.back();
      left.pop_back();
      for (const auto& [neighbour, other] : fans[from])
      {
        if (reached.insert(neighbour).second)
        {
          left.push_back(neighbour);
        }
      }
    }
  }
  return topology;
}

// By the divergence theorem; positive where the faces look outwards.
inline double volumeOf(vtkPolyData* mesh)
{
  double volume = 0.0;
  for (const std::vector<vtkIdType>& face : cornersOf(mesh))
  {
    const Vector3 a(mesh->GetPoint(face[0]));
    for (std::size_t k = 2; k < face.size(); ++k)
    {
      volume += a.dot(Vector3(mesh->GetPoint(face[k - 1])).cross(Vector3(mesh->GetPoint(face[k])))) / 6.0;
    }
  }
  return volume;
}

inline std::array<double, 6> boxOf(vtkPolyData* mesh)
{
  std::array<double, 6> box;
  mesh->ComputeBounds();
  mesh->GetBounds(box.data());
  return box;
}

struct System
{
  vtkNew<vtkOversketchInflateDrawing> filter;

  explicit System(vtkPolyData* strokes) { this->filter->SetInputData(0, strokes); }
  vtkPolyData* mesh()
  {
    this->filter->Update();
    EXPECT_EQ(this->filter->GetErrorCode(), 0u);
    return this->filter->GetOutput();
  }
  template <typename Step>
  Step* step(const char* name)
  {
    return Step::SafeDownCast(this->filter->GetStep(name));
  }
};

struct Shipped
{
  vtkNew<vtkPNGReader> picture;
  vtkNew<vtkXMLPolyDataReader> strokes;
  vtkNew<vtkOversketchInflateDrawing> filter;

  explicit Shipped(const std::string& name)
  {
    this->picture->SetFileName((OVERSKETCH_DATA_FOLDER "/Drawings/" + name + ".png").c_str());
    this->strokes->SetFileName((OVERSKETCH_DATA_FOLDER "/Drawings/" + name + ".vtp").c_str());
    this->filter->SetInputConnection(0, this->strokes->GetOutputPort());
    this->filter->SetInputConnection(1, this->picture->GetOutputPort());
  }
};

} // namespace oversketch_test
#endif
