// The exponentials of a region's vertices: sums of three handles' logarithms by each vertex's own weights.
// Beside it Eigen's exponential of each sum, times the vertex.
#include "edit_jobs.h"

#include "Matrix/moved.h"
#include "Mesh/context.h"

#include <Eigen/Geometry>
#include <unsupported/Eigen/MatrixFunctions>

#include <random>

namespace oversketch_bench
{

namespace
{

struct Region
{
  std::vector<Vector3> points, theirs;
  std::vector<Matrix4> logs;
  std::vector<double> weights;

  Region()
  {
    std::mt19937 random(5);
    const auto uniform = [&] { return (double(random()) + 0.5) / 4294967296.0; };
    const Eigen::Affine3d turned(Eigen::AngleAxisd(2.0, Vector3(1.0, 2.0, 3.0).normalized()));
    const Eigen::Affine3d moved(Eigen::Translation3d(0.1, 0.2, 0.3)), scaled(Eigen::Scaling(1.5, 1.0, 0.7));
    for (const Eigen::Affine3d& each : { turned, moved, scaled })
    {
      this->logs.push_back(logarithm(each.matrix()));
    }
    for (int v = 0; v < 50000; ++v)
    {
      const double x = uniform(), y = uniform();
      this->points.emplace_back(x, y, uniform());
      for (int k = 0; k < 3; ++k)
      {
        this->weights.push_back(uniform());
      }
    }
    this->theirs.resize(this->points.size());
  }
};

Region& region()
{
  static Region made;
  return made;
}

void moveTheirs()
{
  Region& r = region();
  for (std::size_t v = 0; v < r.points.size(); ++v)
  {
    Matrix4 sum = Matrix4::Zero();
    for (std::size_t k = 0; k < 3; ++k)
    {
      sum += r.weights[3 * v + k] * r.logs[k];
    }
    const Matrix4 moved = sum.exp();
    r.theirs[v] = (moved * r.points[v].homogeneous()).head<3>();
  }
}

Job side(const std::string& who, std::function<void()> run)
{
  Job job;
  job.job = "region's exponentials";
  job.size = "50k vertices";
  job.who = who;
  job.threads = 1;
  job.prepare = [] { region(); };
  job.run = std::move(run);
  return job;
}

} // namespace

void addExponentials()
{
  Job ours = side("ours", [] { moved(region().points, region().logs, region().weights, Context()); });
  ours.figures = []
  {
    Region& r = region();
    moveTheirs();
    const std::vector<Vector3> points = moved(r.points, r.logs, r.weights, Context());
    double apart = 0.0;
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      apart = std::max(apart, (points[v] - r.theirs[v]).norm());
    }
    return std::map<std::string, double>{ { "apart_from_eigen", apart } };
  };
  add(ours);
  add(side("Eigen", moveTheirs));
}

} // namespace oversketch_bench
