#include "Silhouette/occlusion.h"

#include "OpenCL/device.h"
#include "Silhouette/occlusion_cl.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <type_traits>

namespace oversketch
{

namespace
{

template <typename Real>
struct Point
{
  Real x, y, z;
};

template <typename Real>
Point<Real> toPoint(const Vector3& v)
{
  return { static_cast<Real>(v[0]), static_cast<Real>(v[1]), static_cast<Real>(v[2]) };
}

// The queries in a uniform grid of about four cells a point: they lie on curves, so most cells are empty.
template <typename Real>
struct PointGrid
{
  Real bounds[6]; // x and y of the least and the greatest point, cells per unit in x and y
  int columns = 1, rows = 1;
  Lists cells;                         // the points in each
  std::vector<Point<Real>> cellPlaces; // where those are
  std::vector<Point<Real>> points;
  std::vector<std::array<int, 3>> pointVertices;

  static int cellOf(Real value, Real origin, Real perUnit, int count)
  {
    const Real cell = (value - origin) * perUnit;
    return cell <= 0 ? 0 : cell >= static_cast<Real>(count - 1) ? count - 1 : static_cast<int>(cell);
  }
  int column(Real x) const { return cellOf(x, this->bounds[0], this->bounds[4], this->columns); }
  int row(Real y) const { return cellOf(y, this->bounds[1], this->bounds[5], this->rows); }

  explicit PointGrid(const std::vector<OcclusionQuery>& queries)
  {
    const Real infinity = std::numeric_limits<Real>::infinity();
    Real low[2] = { infinity, infinity }, high[2] = { -infinity, -infinity };
    for (const OcclusionQuery& query : queries)
    {
      const Point<Real> p = toPoint<Real>(query.screen);
      this->points.push_back(p);
      this->pointVertices.push_back(query.vertices);
      low[0] = std::min(low[0], p.x);
      low[1] = std::min(low[1], p.y);
      high[0] = std::max(high[0], p.x);
      high[1] = std::max(high[1], p.y);
    }
    const int side = std::max(1, static_cast<int>(2.0 * std::sqrt(static_cast<double>(queries.size()))));
    this->columns = high[0] > low[0] ? side : 1;
    this->rows = high[1] > low[1] ? side : 1;
    this->bounds[0] = low[0];
    this->bounds[1] = low[1];
    this->bounds[2] = high[0];
    this->bounds[3] = high[1];
    this->bounds[4] = this->columns > 1 ? static_cast<Real>(this->columns) / (high[0] - low[0]) : Real(0);
    this->bounds[5] = this->rows > 1 ? static_cast<Real>(this->rows) / (high[1] - low[1]) : Real(0);
    this->cells = Lists::gathered(static_cast<std::size_t>(this->columns) * this->rows,
      [&](const auto& visit)
      {
        for (int i = 0; i < static_cast<int>(this->points.size()); ++i)
        {
          visit(this->row(this->points[i].y) * this->columns + this->column(this->points[i].x), i);
        }
      });
    this->cellPlaces = valuesAt(this->points, this->cells.values);
  }
};

struct Cell
{
  int column, row;
};

// Tells at once whether any query lies in the cells that a triangle's box covers, from the cells of its
// corners: sums of the queries over all cells below and to the left.
template <typename Real>
class QueryCounts
{
public:
  explicit QueryCounts(const PointGrid<Real>& grid)
    : Width(grid.columns + 1)
    , Sums(static_cast<std::size_t>(this->Width) * (grid.rows + 1), 0)
  {
    for (int row = 0; row < grid.rows; ++row)
    {
      for (int column = 0; column < grid.columns; ++column)
      {
        this->at(column + 1, row + 1) = grid.cells.size(row * grid.columns + column) +
                                        this->at(column, row + 1) + this->at(column + 1, row) -
                                        this->at(column, row);
      }
    }
  }

  bool none(const Cell& a, const Cell& b, const Cell& c) const
  {
    const int left = std::min({ a.column, b.column, c.column }), low = std::min({ a.row, b.row, c.row });
    const int right = std::max({ a.column, b.column, c.column }) + 1,
              high = std::max({ a.row, b.row, c.row }) + 1;
    return this->at(right, high) - this->at(left, high) == this->at(right, low) - this->at(left, low);
  }

private:
  int at(int column, int row) const { return this->Sums[row * this->Width + column]; }
  int& at(int column, int row) { return this->Sums[row * this->Width + column]; }

  int Width;
  std::vector<int> Sums;
};

template <typename Real>
Real crossOf(Real ax, Real ay, Real bx, Real by)
{
  return ax * by - ay * bx;
}

// Calls hide(p) for every query p that the triangle hides: the operations of occlusion.cl in their order.
template <typename Real, typename Hide>
void testTriangle(const Triangle& t,
  const std::vector<Point<Real>>& screen,
  const PointGrid<Real>& grid,
  const Hide& hide)
{
  const Point<Real> a = screen[t[0]], b = screen[t[1]], c = screen[t[2]];
  const Real behind = -std::numeric_limits<Real>::infinity();
  if (a.z == behind || b.z == behind || c.z == behind)
  {
    return;
  }
  const Real left = std::min(a.x, std::min(b.x, c.x)), right = std::max(a.x, std::max(b.x, c.x));
  const Real low = std::min(a.y, std::min(b.y, c.y)), high = std::max(a.y, std::max(b.y, c.y));
  if (right < grid.bounds[0] || left > grid.bounds[2] || high < grid.bounds[1] || low > grid.bounds[3])
  {
    return;
  }
  Real area = crossOf(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
  const Real side = area < 0 ? Real(-1) : Real(1);
  area *= side;
  const Real extent = std::max(right - left, high - low);
  if (!(area > static_cast<Real>(1e-12) * extent * extent))
  {
    return;
  }
  const int firstColumn = grid.column(left), lastColumn = grid.column(right);
  const int lastRow = grid.row(high);
  for (int row = grid.row(low); row <= lastRow; ++row)
  {
    const int end = grid.cells.offsets[row * grid.columns + lastColumn + 1];
    for (int k = grid.cells.offsets[row * grid.columns + firstColumn]; k < end; ++k)
    {
      const Point<Real>& p = grid.cellPlaces[k];
      if (p.x < left || p.x > right || p.y < low || p.y > high)
      {
        continue;
      }
      const Real wa = side * crossOf(b.x - p.x, b.y - p.y, c.x - p.x, c.y - p.y);
      const Real wb = side * crossOf(c.x - p.x, c.y - p.y, a.x - p.x, a.y - p.y);
      const Real wc = side * crossOf(a.x - p.x, a.y - p.y, b.x - p.x, b.y - p.y);
      if (wa < 0 || wb < 0 || wc < 0 || !(wa * (a.z - p.z) + wb * (b.z - p.z) + wc * (c.z - p.z) > 0))
      {
        continue;
      }
      const int i = grid.cells.values[k];
      const std::array<int, 3>& own = grid.pointVertices[i];
      if (std::none_of(t.begin(), t.end(), [&](int v) { return v == own[0] || v == own[1] || v == own[2]; }))
      {
        hide(i);
      }
    }
  }
}

template <typename Real>
std::vector<Point<Real>> toPoints(const std::vector<Vector3>& screen)
{
  std::vector<Point<Real>> points(screen.size());
  std::transform(screen.begin(), screen.end(), points.begin(), toPoint<Real>);
  return points;
}

} // namespace

std::vector<Vector3> projectVertices(const Mesh& mesh, const View& view, const Context& context)
{
  std::vector<Vector3> screen(mesh.points.size());
  const double nearest = -1e-6 * boundingDiagonal(mesh);
  context.each(mesh.vertexCount(),
    [&](int v)
    {
      if (view.perspective() && !(view.depth(mesh.points[v]) < nearest))
      {
        screen[v] = Vector3(0.0, 0.0, -std::numeric_limits<double>::infinity());
      }
      else
      {
        screen[v] = view.toScreen(mesh.points[v]);
      }
    });
  return screen;
}

template <typename Real>
std::vector<char> occludedOnHost(const Mesh& mesh,
  const std::vector<Vector3>& screen,
  const std::vector<OcclusionQuery>& queries,
  const Context& context)
{
  if (queries.empty())
  {
    return {};
  }
  const PointGrid<Real> grid(queries);
  const QueryCounts<Real> counts(grid);
  std::vector<Point<Real>> points(screen.size());
  std::vector<Cell> cells(screen.size());
  context.each(static_cast<int>(screen.size()),
    [&](int v)
    {
      points[v] = toPoint<Real>(screen[v]);
      cells[v] = { grid.column(points[v].x), grid.row(points[v].y) };
    });
  // Several threads may hide one point: all of them write 1, so who comes first does not matter.
  std::vector<std::atomic<char>> hidden(queries.size());
  context.parallelFor(mesh.triangleCount(),
    [&](int begin, int end)
    {
      for (int t = begin; t < end && !(t % 4096 == 0 && context.cancelled()); ++t)
      {
        const Triangle& corners = mesh.triangles[t];
        if (!counts.none(cells[corners[0]], cells[corners[1]], cells[corners[2]]))
        {
          testTriangle(corners, points, grid, [&](int i) { hidden[i].store(1, std::memory_order_relaxed); });
        }
      }
    });
  return std::vector<char>(hidden.begin(), hidden.end());
}

template <typename Real>
std::vector<char> occludedOnDevice(Device& device,
  const Mesh& mesh,
  const std::vector<Vector3>& screen,
  const std::vector<OcclusionQuery>& queries)
{
  std::vector<char> hidden(queries.size(), 0);
  if (queries.empty() || mesh.triangles.empty())
  {
    return hidden;
  }
  static_assert(sizeof(Triangle) == 3 * sizeof(int) && sizeof(Point<Real>) == 3 * sizeof(Real),
    "the layout that occlusion.cl reads");
  const PointGrid<Real> grid(queries);
  const bool doubles = std::is_same<Real, double>::value;
  device.guard(
    [&]
    {
      cl::Kernel kernel(device.program("occlusion", occlusion_cl, doubles ? "-D USE_DOUBLE" : ""), "occlude");
      const int triangleCount = mesh.triangleCount();
      cl::Buffer occluded(
        device.context(), CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, hidden.size(), hidden.data());
      const cl::Buffer inputs[] = { toDevice(device, mesh.triangles),
        toDevice(device, toPoints<Real>(screen)),
        toDevice(device, std::vector<Real>(grid.bounds, grid.bounds + 6)),
        toDevice(device, grid.cells.offsets),
        toDevice(device, grid.cells.values),
        toDevice(device, grid.points),
        toDevice(device, grid.pointVertices) };
      int argument = 0;
      kernel.setArg(argument++, triangleCount);
      for (int i = 0; i < 3; ++i)
      {
        kernel.setArg(argument++, inputs[i]);
      }
      kernel.setArg(argument++, grid.columns);
      kernel.setArg(argument++, grid.rows);
      for (int i = 3; i < 7; ++i)
      {
        kernel.setArg(argument++, inputs[i]);
      }
      kernel.setArg(argument++, occluded);
      const std::size_t group = device.groupSize(kernel, 64);
      const std::size_t items = static_cast<std::size_t>(triangleCount);
      device.queue().enqueueNDRangeKernel(
        kernel, cl::NullRange, cl::NDRange((items + group - 1) / group * group), cl::NDRange(group));
      device.queue().enqueueReadBuffer(occluded, CL_TRUE, 0, hidden.size(), hidden.data());
    });
  return hidden;
}

template std::vector<char> occludedOnHost<double>(const Mesh&,
  const std::vector<Vector3>&,
  const std::vector<OcclusionQuery>&,
  const Context&);
template std::vector<char> occludedOnHost<float>(const Mesh&,
  const std::vector<Vector3>&,
  const std::vector<OcclusionQuery>&,
  const Context&);
template std::vector<char> occludedOnDevice<double>(Device&,
  const Mesh&,
  const std::vector<Vector3>&,
  const std::vector<OcclusionQuery>&);
template std::vector<char> occludedOnDevice<float>(Device&,
  const Mesh&,
  const std::vector<Vector3>&,
  const std::vector<OcclusionQuery>&);

} // namespace oversketch
