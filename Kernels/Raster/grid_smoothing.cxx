#include "Raster/grid_smoothing.h"

#include "Sparse/cholesky.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr float beside = 3.0f; // T of a rim's neighbourhood, in cells
constexpr std::array<std::array<int, 2>, 4> sides{ { { 0, -1 }, { -1, 0 }, { 1, 0 }, { 0, 1 } } };

} // namespace

GridSmoothing::GridSmoothing(const DistanceMaps& maps, int step, const Context& context)
  : Maps(maps)
  , Step(step)
  , Columns(0)
  , Rows(0)
{
  if (step < 1 || step > 16)
  {
    throw Error(Failure::BadStroke, "the smoothing grid's step must be 1 to 16 px");
  }
  const Frame& frame = maps.frame;
  if (maps.thickness.size() != frame.count() || maps.uphill.size() != frame.count())
  {
    throw Error(
      Failure::Unexpected, "the distance maps have no thickness; call findThickness before smoothing");
  }
  // What does not fill a cell is margin.
  this->Columns = frame.width / step;
  this->Rows = frame.height / step;
  this->Numbers.assign(static_cast<std::size_t>(this->Columns) * this->Rows, -1);
  for (int y = 0; y < this->Rows; ++y)
  {
    for (int x = 0; x < this->Columns; ++x)
    {
      bool inner = true;
      for (int k = 0; k < step * step && inner; ++k)
      {
        inner = maps.distance[frame.index(x * step + k % step, y * step + k / step)] > 0.0f;
      }
      if (inner)
      {
        this->Numbers[static_cast<std::size_t>(y) * this->Columns + x] = this->cellCount();
        this->Cells.push_back({ x, y });
      }
    }
  }
  context.checkpoint(0.05);
  if (this->Cells.empty())
  {
    return;
  }
  const auto positions = mapped(this->Cells, [](const auto& cell) { return Vector3(cell[0], cell[1], 0.0); });
  const std::vector<double> none(this->Cells.size(), 0.0);
  this->Order = std::make_shared<Elimination>(this->matrix(none).pattern, positions, context);
}

GridSmoothing::~GridSmoothing() = default;

std::vector<double> GridSmoothing::means(const std::vector<float>& samples) const
{
  std::vector<double> result;
  result.reserve(this->Cells.size());
  for (const auto& [x, y] : this->Cells)
  {
    double sum = 0.0;
    for (int k = 0; k < this->Step * this->Step; ++k)
    {
      sum +=
        samples[this->Maps.frame.index(x * this->Step + k % this->Step, y * this->Step + k / this->Step)];
    }
    result.push_back(sum / (this->Step * this->Step));
  }
  return result;
}

BlockMatrix GridSmoothing::matrix(const std::vector<double>& flow) const
{
  BlockMatrix matrix;
  const double scale = 1.0 / (this->Step * this->Step);
  matrix.pattern.offsets.reserve(this->Cells.size() + 1);
  matrix.pattern.offsets.push_back(0);
  matrix.pattern.values.reserve(5 * this->Cells.size());
  matrix.values.reserve(5 * this->Cells.size());
  for (int i = 0; i < this->cellCount(); ++i)
  {
    const std::size_t self = matrix.values.size();
    matrix.pattern.values.push_back(i);
    matrix.values.push_back(1.0);
    for (const auto& [dx, dy] : sides)
    {
      const int other = this->numberAt(this->Cells[i][0] + dx, this->Cells[i][1] + dy);
      if (other >= 0)
      {
        const double weight = 0.5 * (flow[i] + flow[other]) * scale;
        matrix.pattern.values.push_back(other);
        matrix.values.push_back(-weight);
        matrix.values[self] += weight;
      }
    }
    matrix.pattern.offsets.push_back(static_cast<int>(matrix.pattern.values.size()));
  }
  return matrix;
}

void GridSmoothing::factorise(Cholesky& factor, const BlockMatrix& matrix, const Context& context) const
{
  if (!factor.factorise(matrix, context))
  {
    throw Error(
      Failure::SolveFailed, "the smoothing's system could not be factored; try a smaller smoothing");
  }
}

std::vector<float> GridSmoothing::spread(const std::vector<double>& values,
  const std::vector<float>& otherwise,
  const Context& context) const
{
  const Frame& frame = this->Maps.frame;
  std::vector<float> result(frame.count(), 0.0f);
  context.eachUntilCancelled(frame.height,
    [&](int y)
    {
      for (int x = 0; x < frame.width; ++x)
      {
        const std::size_t at = frame.index(x, y);
        if (this->Maps.distance[at] <= 0.0f)
        {
          continue;
        }
        // Beside the rim: up the steepest way, which crosses no rim, into an inner cell.
        int from = static_cast<int>(at);
        int own = this->numberAt(x / this->Step, y / this->Step);
        while (own < 0 && this->Maps.uphill[from] >= 0)
        {
          from = this->Maps.uphill[from];
          own = this->numberAt(from % frame.width / this->Step, from / frame.width / this->Step);
        }
        if (own < 0)
        {
          result[at] = otherwise[at];
          continue;
        }
        // Bilinear between the centres of inner cells; over a corner only past one that is inner too, or
        // it would lead through the rim.
        const int cx = this->Cells[own][0], cy = this->Cells[own][1];
        const double middle = 0.5 * (this->Step - 1);
        const int column = from % frame.width, row = from / frame.width;
        const double u = (column - cx * this->Step - middle) / this->Step;
        const double v = (row - cy * this->Step - middle) / this->Step;
        const int sx = u < 0.0 ? -1 : 1, sy = v < 0.0 ? -1 : 1;
        const double a = std::abs(u), b = std::abs(v);
        const int right = this->numberAt(cx + sx, cy), up = this->numberAt(cx, cy + sy);
        const int corner = right >= 0 || up >= 0 ? this->numberAt(cx + sx, cy + sy) : -1;
        double sum = (1.0 - a) * (1.0 - b) * values[own], weights = (1.0 - a) * (1.0 - b);
        const auto add = [&](int cell, double weight)
        {
          if (cell >= 0)
          {
            sum += weight * values[cell];
            weights += weight;
          }
        };
        add(right, a * (1.0 - b));
        add(up, (1.0 - a) * b);
        add(corner, a * b);
        result[at] = static_cast<float>(sum / weights);
      }
    });
  context.checkpoint(1.0);
  return result;
}

std::vector<float> GridSmoothing::thickness(double c, const Context& context)
{
  if (this->Cells.empty() || !(c > 0.0))
  {
    return this->Maps.thickness;
  }
  const std::vector<double> own = this->means(this->Maps.thickness);
  std::vector<double> flow(own.size());
  std::transform(own.begin(), own.end(), flow.begin(), [&](double d) { return c * c * d * d; });
  Cholesky factor(this->Order);
  this->factorise(factor, this->matrix(flow), context);
  Eigen::MatrixXd sides =
    Eigen::Map<const Eigen::VectorXd>(own.data(), static_cast<Eigen::Index>(own.size()));
  factor.solve(sides, context);
  const auto [least, most] = std::minmax_element(own.begin(), own.end());
  std::vector<double> values(own.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    // Rounding alone leaves the range.
    values[i] = std::clamp(sides(static_cast<Eigen::Index>(i), 0), *least, *most);
  }
  std::vector<float> result = this->spread(values, this->Maps.thickness, context);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    result[i] = std::max(result[i], this->Maps.distance[i]);
  }
  return result;
}

// The step's length over the way from a cell's centre to the rim, towards a neighbour that is no inner cell:
// the mean of the cell's rows of samples on that side.
double GridSmoothing::nearness(int cell, int dx, int dy) const
{
  const Frame& frame = this->Maps.frame;
  const auto [cx, cy] = this->Cells[cell];
  double sum = 0.0;
  for (int k = 0; k < this->Step; ++k)
  {
    // From the cell's last sample on; a row may pass the neighbour's rim by. The raster's border has no
    // inside, so it is not left.
    int x = cx * this->Step + (dx == 0 ? k : dx < 0 ? 0 : this->Step - 1);
    int y = cy * this->Step + (dy == 0 ? k : dy < 0 ? 0 : this->Step - 1);
    double way = 0.5 * (this->Step - 1);
    do
    {
      x += dx;
      y += dy;
      way += 1.0;
    } while (way<2.0 * this->Step&& this->Maps.distance[frame.index(x, y)]> 0.0f);
    sum += this->Step / way;
  }
  return sum / this->Step;
}

Eigen::VectorXd GridSmoothing::membrane(double load, const Context& context) const
{
  // The unit is a cell.
  BlockMatrix matrix = this->matrix(std::vector<double>(this->Cells.size(), this->Step * this->Step));
  for (int i = 0; i < this->cellCount(); ++i)
  {
    double& self = matrix.values[matrix.pattern.offsets[i]];
    self -= 1.0;
    for (const auto& [dx, dy] : sides)
    {
      if (this->numberAt(this->Cells[i][0] + dx, this->Cells[i][1] + dy) < 0)
      {
        self += this->nearness(i, dx, dy);
      }
    }
  }
  Cholesky factor(this->Order);
  this->factorise(factor, matrix, context);
  Eigen::MatrixXd u = Eigen::VectorXd::Constant(this->cellCount(), load * this->Step * this->Step);
  factor.solve(u, context);
  return u.col(0);
}

std::vector<double> GridSmoothing::squaredWidths(const Eigen::VectorXd& membrane) const
{
  std::vector<double> squares(this->Cells.size());
  for (int i = 0; i < this->cellCount(); ++i)
  {
    double slope = 0.0; // squared, over two cells or, beside the rim, one
    for (int axis = 0; axis < 2; ++axis)
    {
      const int dx = 1 - axis, dy = axis;
      const int after = this->numberAt(this->Cells[i][0] + dx, this->Cells[i][1] + dy);
      const int before = this->numberAt(this->Cells[i][0] - dx, this->Cells[i][1] - dy);
      const int cells = (after >= 0) + (before >= 0);
      if (cells > 0)
      {
        const double rise = membrane[after < 0 ? i : after] - membrane[before < 0 ? i : before];
        slope += std::pow(rise / (cells * this->Step), 2);
      }
    }
    squares[i] = membrane[i] + 0.25 * slope;
  }
  return squares;
}

std::vector<float> GridSmoothing::overDistance(const Eigen::VectorXd& values,
  const std::vector<float>& otherwise,
  const Context& context) const
{
  // Beside the rim the quotient varies slowly, farther inside the values do: T has creases there.
  const std::vector<float>& distance = this->Maps.distance;
  const std::vector<double> own(values.begin(), values.end());
  std::vector<double> ratio = this->means(distance);
  for (std::size_t i = 0; i < ratio.size(); ++i)
  {
    ratio[i] = own[i] / ratio[i];
  }
  std::vector<float> result = this->spread(ratio, otherwise, context);
  const std::vector<float> inside = this->spread(own, otherwise, context);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    const float quotient =
      distance[i] > beside * static_cast<float>(this->Step) ? inside[i] / distance[i] : result[i];
    result[i] = distance[i] > 0.0f ? std::max(0.0f, quotient) : 1.0f;
  }
  return result;
}

std::vector<float> GridSmoothing::profileRatio(const std::vector<float>& squares,
  double c,
  const Context& context)
{
  std::vector<float> own(squares.size(), 1.0f);
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    own[i] = this->Maps.distance[i] > 0.0f ? squares[i] / this->Maps.distance[i] : 1.0f;
  }
  if (this->Cells.empty())
  {
    return own;
  }
  const Eigen::VectorXd membrane = this->membrane(2.0, context);
  const std::vector<double> widths = this->squaredWidths(membrane);
  std::vector<double> flow(widths.size());
  std::transform(widths.begin(), widths.end(), flow.begin(), [&](double s) { return c * c * s; });
  BlockMatrix matrix = this->matrix(flow);
  const std::vector<double> asked = this->means(squares);
  Eigen::MatrixXd factors(this->cellCount(), 1);
  for (int i = 0; i < this->cellCount(); ++i)
  {
    matrix.values[matrix.pattern.offsets[i]] += membrane[i] / widths[i] - 1.0;
    factors(i, 0) = asked[i] / widths[i];
  }
  Cholesky factor(this->Order);
  this->factorise(factor, matrix, context);
  factor.solve(factors, context);
  return this->overDistance(factors.col(0).cwiseProduct(membrane), own, context);
}

std::vector<float> GridSmoothing::poissonRatio(const Context& context)
{
  const std::vector<float> ones(this->Maps.frame.count(), 1.0f);
  return this->Cells.empty() ? ones : this->overDistance(this->membrane(4.0, context), ones, context);
}

} // namespace oversketch
