// The systems on the raster's grid that smooth a drawing's thickness and heights: order, factor, solve. The
// inside of a ring with two holes, cells of 2 x 2 samples, five points, flux c^2 D^2; every side gets the
// same matrix. The size is the number of cells.
#include "benchmark_frame.h"
#include "sparse_peers.h"

#include "Raster/distance_maps.h"
#include "Sparse/cholesky.h"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <memory>

namespace oversketch_bench
{

namespace
{

Polyline ring(double x, double y, double radius, double wobble)
{
  Polyline points;
  for (int i = 0; i < 2000; ++i)
  {
    const double angle = 6.283185307179586 * i / 2000, away = radius + wobble * std::sin(7.0 * angle);
    points.emplace_back(x + away * std::cos(angle), y + away * std::sin(angle));
  }
  return points;
}

// A system of cells and what it is solved for.
struct Grid
{
  BlockMatrix matrix;
  std::vector<Vector3> positions;
  Eigen::MatrixXd right;
  Sparse forEigen;

  Grid()
  {
    const Frame frame{ Vector2::Zero(), 1.0, 1028, 1028 };
    const std::vector<Rim> rims{
      { ring(514, 514, 480, 12), 0 }, { ring(400, 560, 90, 0), 0 }, { ring(690, 480, 120, 0), 0 }
    };
    const DistanceMaps maps = distanceMaps(frame, rims, ThicknessMode::Local, Context());
    constexpr int side = 514;
    std::vector<int> numbers(side * side, -1);
    std::vector<double> flow;
    const auto isInside = [&](int x, int y)
    {
      return maps.distance[frame.index(2 * x, 2 * y)] > 0.0f &&
             maps.distance[frame.index(2 * x + 1, 2 * y)] > 0.0f &&
             maps.distance[frame.index(2 * x, 2 * y + 1)] > 0.0f &&
             maps.distance[frame.index(2 * x + 1, 2 * y + 1)] > 0.0f;
    };
    for (int y = 0; y < side; ++y)
    {
      for (int x = 0; x < side; ++x)
      {
        if (isInside(x, y))
        {
          numbers[y * side + x] = static_cast<int>(this->positions.size());
          this->positions.emplace_back(x, y, 0.0);
          const double thickness = maps.thickness[frame.index(2 * x, 2 * y)];
          flow.push_back(0.0625 * thickness * thickness); // c = 0.5, lengths in cells
        }
      }
    }
    const int count = static_cast<int>(this->positions.size());
    this->right.resize(count, 1);
    this->matrix.pattern.offsets.push_back(0);
    for (int i = 0; i < count; ++i)
    {
      const int at = static_cast<int>(this->positions[i][1]) * side + static_cast<int>(this->positions[i][0]);
      const std::size_t self = this->matrix.values.size();
      this->matrix.pattern.values.push_back(i);
      this->matrix.values.push_back(1.0);
      for (const int other : { numbers[at - 1], numbers[at + 1], numbers[at - side], numbers[at + side] })
      {
        if (other >= 0)
        {
          const double weight = 0.5 * (flow[i] + flow[other]);
          this->matrix.pattern.values.push_back(other);
          this->matrix.values.push_back(-weight);
          this->matrix.values[self] += weight;
        }
      }
      this->matrix.pattern.offsets.push_back(static_cast<int>(this->matrix.pattern.values.size()));
      this->right(i, 0) = 4.0 * std::sqrt(flow[i]);
    }
    this->forEigen = toEigen(this->matrix);
  }

  // What a side starts from; made once.
  const std::shared_ptr<const Elimination>& order()
  {
    if (!this->ownOrder)
    {
      this->ownOrder = std::make_shared<Elimination>(this->matrix.pattern, this->positions, threads());
      this->ours = std::make_unique<Cholesky>(this->ownOrder);
      this->ours->factorise(this->matrix, threads());
    }
    return this->ownOrder;
  }
  void readyEigen()
  {
    if (!this->eigen)
    {
      this->eigen = std::make_unique<Eigen::SimplicialLDLT<Sparse>>(this->forEigen);
    }
  }
#ifdef OVERSKETCH_CHOLMOD
  void readyCholmod()
  {
    if (!this->cholmod)
    {
      this->cholmod = std::make_unique<Cholmod>(this->forEigen, CHOLMOD_AMD);
      this->cholmod->analyse();
      this->cholmod->factorise();
    }
  }
  std::unique_ptr<Cholmod> cholmod;
#endif
  // How far an answer misses the right side, at most.
  std::map<std::string, double> residual() const
  {
    const double worst = (this->forEigen * this->answer - this->right).cwiseAbs().maxCoeff();
    return { { "residual", worst } };
  }

  std::shared_ptr<const Elimination> ownOrder;
  std::unique_ptr<Cholesky> ours;
  std::unique_ptr<Eigen::SimplicialLDLT<Sparse>> eigen;
  Eigen::MatrixXd answer;
};

Grid& grid()
{
  static Grid made;
  return made;
}

void side(const std::string& job,
  const std::string& who,
  int threadCount,
  const std::function<void()>& prepare,
  const std::function<void()>& run,
  bool solves = false)
{
  Job made;
  made.job = job;
  made.size = "166k";
  made.who = who;
  made.threads = threadCount;
  made.prepare = prepare;
  made.run = run;
  made.figures = [solves]
  {
    std::map<std::string, double> figures = solves ? grid().residual() : std::map<std::string, double>();
    figures["cells"] = grid().matrix.nodeCount();
    return figures;
  };
  add(made);
}

} // namespace

void jobs()
{
  const auto ready = [] { grid().order(); };
  side(
    "grid order", "ours", 2, ready, [] { Elimination(grid().matrix.pattern, grid().positions, threads()); });
  side(
    "grid order", "Eigen", 1, ready, [] { Eigen::SimplicialLDLT<Sparse>().analyzePattern(grid().forEigen); });
  side("grid factor", "ours", 2, ready, [] { grid().ours->factorise(grid().matrix, threads()); });
  side("grid factor", "ours, one thread", 1, ready, [] { grid().ours->factorise(grid().matrix, Context()); });
  side(
    "grid factor", "Eigen", 1, [] { grid().readyEigen(); }, [] { grid().eigen->factorize(grid().forEigen); });
  side(
    "grid solve",
    "ours",
    2,
    ready,
    []
    {
      grid().answer = grid().right;
      grid().ours->solve(grid().answer, threads());
    },
    true);
  side(
    "grid solve",
    "Eigen",
    1,
    [] { grid().readyEigen(); },
    [] { grid().answer = grid().eigen->solve(grid().right); },
    true);
#ifdef OVERSKETCH_CHOLMOD
  const std::string peer = Cholmod::name(CHOLMOD_AMD);
  side("grid order",
    peer,
    1,
    ready,
    []
    {
      Cholmod made(grid().forEigen, CHOLMOD_AMD);
      made.analyse();
    });
  side(
    "grid factor", peer, 2, [] { grid().readyCholmod(); }, [] { grid().cholmod->factorise(); });
  side(
    "grid solve",
    peer,
    2,
    [] { grid().readyCholmod(); },
    []
    {
      grid().answer = grid().right;
      grid().cholmod->solve(grid().answer);
    },
    true);
#endif
}

} // namespace oversketch_bench
