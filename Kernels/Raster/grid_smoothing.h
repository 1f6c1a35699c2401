// Solves on the inside of objects: smooths thickness, farther the thicker it is, and blows the inside up like
// a membrane, everywhere alike or to given heights.
#ifndef oversketch_kernels_raster_grid_smoothing_h
#define oversketch_kernels_raster_grid_smoothing_h

#include "Mesh/context.h"
#include "Raster/distance_maps.h"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

namespace oversketch
{

class Elimination;
struct BlockMatrix;
class Cholesky;

// Source: image-assisted modelling, sections 11 and 12. Cells of step x step samples hold means; a cell is
// inner when all its samples lie inside, T > 0. Between two neighbouring cells flows the mean of their flow
// times the difference (five points). The system's pattern depends on the inside alone: one order of
// elimination serves all solves and every c.
class GridSmoothing
{
public:
  // The maps are kept by reference, those of distanceMaps or of findThickness. Throws
  // Error(Failure::BadStroke) for a step that is not 1 to 16, Error(Failure::Unexpected) for maps without
  // thickness.
  GridSmoothing(const DistanceMaps& maps, int step, const Context& context);
  ~GridSmoothing();
  GridSmoothing(const GridSmoothing&) = delete;
  GridSmoothing& operator=(const GridSmoothing&) = delete;

  int cellCount() const { return static_cast<int>(this->Cells.size()); }

  // D' [px]: D' - div((cD)^2 grad D') = D with no flux through the rim, and at least T; of samples beside the
  // rim, where they are in no inner cell, the next inner value up the steepest way, D itself where there is
  // none. Within the least and greatest D. c = 0 gives D.
  std::vector<float> thickness(double c, const Context& context);

  // Heights' squares [px^2] that have no creases, over T [px] of samples: a membrane's, see poissonRatio,
  // times a factor that varies slowly and brings them to `squares`, those asked for. With P half the
  // membrane's and S = P + |grad P|^2 / 4, which on a strip is the square of its half-width, the factor r
  // solves (P / S) r - div(c^2 S grad r) = squares / S with no flux through the rim: it is fitted where the
  // surface is high, and where the ways that lead there are blocked by nothing. Where no inner cell is near
  // it is `squares` over T; 1 where T is 0; never negative. c is above 0.
  std::vector<float> profileRatio(const std::vector<float>& squares, double c, const Context& context);

  // Poisson's inflation: with u [px^2], the solution of Laplacian u = -4 in the inside and u = 0 on its rim,
  // u / T [px] of samples, 1 where T is 0; never negative. u itself goes to 0 within the rim's own cells,
  // where this still varies slowly. The rim is where T is first 0 on the way from a cell's centre to its
  // neighbour's, not at that centre: after Gibou et al., "A Second-Order-Accurate Symmetric Discretization of
  // the Poisson Equation on Irregular Domains", which stays symmetric.
  std::vector<float> poissonRatio(const Context& context);

private:
  // -1 beyond the grid.
  int numberAt(int x, int y) const
  {
    return x < 0 || y < 0 || x >= this->Columns || y >= this->Rows
             ? -1
             : this->Numbers[static_cast<std::size_t>(y) * this->Columns + x];
  }
  std::vector<double> means(const std::vector<float>& samples) const;
  // 1 - div(flow grad), with no flux through the rim.
  BlockMatrix matrix(const std::vector<double>& flow) const;
  double nearness(int cell, int dx, int dy) const;
  // u of cells with Laplacian u = -load per px^2, 0 on the rim.
  Eigen::VectorXd membrane(double load, const Context& context) const;
  // S of cells, see profileRatio.
  std::vector<double> squaredWidths(const Eigen::VectorXd& membrane) const;
  // Cells' values over T, at samples, never negative.
  std::vector<float> overDistance(const Eigen::VectorXd& values,
    const std::vector<float>& otherwise,
    const Context& context) const;
  void factorise(Cholesky& factor, const BlockMatrix& matrix, const Context& context) const;
  // Values of cells at all samples inside; `otherwise` where no inner cell is near.
  std::vector<float> spread(const std::vector<double>& values,
    const std::vector<float>& otherwise,
    const Context& context) const;

  const DistanceMaps& Maps;
  int Step, Columns, Rows;
  std::vector<int> Numbers;              // of the grid's cells: inner ones from 0 on, others -1
  std::vector<std::array<int, 2>> Cells; // column and row of each inner cell
  std::shared_ptr<const Elimination> Order;
};

} // namespace oversketch
#endif
