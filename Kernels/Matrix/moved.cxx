#include "Matrix/moved.h"

#include "Mesh/clones.h"
#include "Mesh/context.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr int lanes = 32; // more than the compiler unrolls, which would keep it from filling registers
// A step's matrix has a norm of at most 3; what is left out is 3^29 / 30! of the point's way, below rounding.
constexpr double longestStep = 3.0;
constexpr int terms = 29;
constexpr double largest = 1e4, farthest = 1e100; // of linear part and shift

using Entries = std::array<double, 12>; // of a logarithm's first three rows, row by row

// 1 / (k + 1)!
constexpr std::array<double, terms> makeShares()
{
  std::array<double, terms> shares{};
  double factorial = 1.0;
  for (int k = 0; k < terms; ++k)
  {
    factorial *= k + 1;
    shares[k] = 1.0 / factorial;
  }
  return shares;
}
constexpr std::array<double, terms> shares = makeShares();

// Points side by side. With u = L p + t a step of the flow p' = L p + t goes to p + (I + L / 2! + L^2 / 3! +
// ...) u; by Cayley and Hamilton's theorem, L^3 = c2 L^2 + c1 L + c0, the sum is (a L^2 + b L + g) u with
// three numbers.
struct Batch
{
  double point[3][lanes];
  double matrix[12][lanes];
  double steps[lanes]; // 0: the point stays
};

// Sums of the logarithms, and how many steps they need; false where one is too large.
OVERSKETCH_CLONES bool sumUp(Batch& batch, const std::vector<Entries>& logs, const double* weights)
{
  for (std::size_t k = 0; k < logs.size(); ++k, weights += lanes)
  {
    for (int e = 0; e < 12; ++e)
    {
      for (int i = 0; i < lanes; ++i)
      {
        batch.matrix[e][i] = (k == 0 ? 0.0 : batch.matrix[e][i]) + logs[k][e] * weights[i];
      }
    }
  }
  double square[lanes] = {}, shift[lanes] = {}, share[lanes];
  for (int e = 0; e < 12; ++e)
  {
    double* of = e % 4 == 3 ? shift : square;
    for (int i = 0; i < lanes; ++i)
    {
      of[i] += batch.matrix[e][i] * batch.matrix[e][i];
    }
  }
  for (int i = 0; i < lanes; ++i)
  {
    batch.steps[i] = square[i] + shift[i] > 0.0 ? 1.0 : 0.0;
    share[i] = square[i] <= longestStep * longestStep && shift[i] <= farthest * farthest ? 0.0 : 1.0;
  }
  // How many do not do with one step.
  for (int half = lanes / 2; half > 0; half /= 2)
  {
    for (int i = 0; i < half; ++i)
    {
      share[i] += share[i + half];
    }
  }
  if (share[0] == 0.0)
  {
    return true;
  }
  for (int i = 0; i < lanes; ++i)
  {
    if (!(square[i] <= largest * largest && shift[i] <= farthest * farthest))
    {
      return false;
    }
    const double steps = std::max(1.0, std::ceil(std::sqrt(square[i]) / longestStep));
    batch.steps[i] *= steps;
    share[i] = 1.0 / steps;
  }
  for (auto& entry : batch.matrix)
  {
    for (int i = 0; i < lanes; ++i)
    {
      entry[i] *= share[i];
    }
  }
  return true;
}

OVERSKETCH_CLONES void walk(Batch& batch)
{
  const auto& m = batch.matrix;
  double c0[lanes], c1[lanes], c2[lanes], a[lanes], b[lanes], g[lanes];
  for (int i = 0; i < lanes; ++i)
  {
    const double x = m[5][i] * m[10][i] - m[6][i] * m[9][i], y = m[4][i] * m[10][i] - m[6][i] * m[8][i],
                 z = m[4][i] * m[9][i] - m[5][i] * m[8][i];
    c0[i] = m[0][i] * x - m[1][i] * y + m[2][i] * z;
    c1[i] = m[1][i] * m[4][i] - m[0][i] * m[5][i] + m[2][i] * m[8][i] - m[0][i] * m[10][i] - x;
    c2[i] = m[0][i] + m[5][i] + m[10][i];
    a[i] = b[i] = 0.0;
    g[i] = shares[terms - 1];
  }
  for (int k = terms - 2; k >= 0; --k)
  {
    for (int i = 0; i < lanes; ++i)
    {
      const double square = c2[i] * a[i] + b[i], linear = c1[i] * a[i] + g[i];
      g[i] = c0[i] * a[i] + shares[k];
      a[i] = square;
      b[i] = linear;
    }
  }
  const double most = *std::max_element(batch.steps, batch.steps + lanes);
  for (double step = 0.0; step < most; step += 1.0)
  {
    for (int i = 0; i < lanes; ++i)
    {
      const double x = batch.point[0][i], y = batch.point[1][i], z = batch.point[2][i];
      const double ux = m[0][i] * x + m[1][i] * y + m[2][i] * z + m[3][i],
                   uy = m[4][i] * x + m[5][i] * y + m[6][i] * z + m[7][i],
                   uz = m[8][i] * x + m[9][i] * y + m[10][i] * z + m[11][i];
      const double vx = a[i] * ux, vy = a[i] * uy, vz = a[i] * uz;
      const double wx = m[0][i] * vx + m[1][i] * vy + m[2][i] * vz + b[i] * ux,
                   wy = m[4][i] * vx + m[5][i] * vy + m[6][i] * vz + b[i] * uy,
                   wz = m[8][i] * vx + m[9][i] * vy + m[10][i] * vz + b[i] * uz;
      const double toX = x + (m[0][i] * wx + m[1][i] * wy + m[2][i] * wz + g[i] * ux),
                   toY = y + (m[4][i] * wx + m[5][i] * wy + m[6][i] * wz + g[i] * uy),
                   toZ = z + (m[8][i] * wx + m[9][i] * wy + m[10][i] * wz + g[i] * uz);
      const bool on = step < batch.steps[i];
      batch.point[0][i] = on ? toX : x;
      batch.point[1][i] = on ? toY : y;
      batch.point[2][i] = on ? toZ : z;
    }
  }
}

struct Task
{
  const std::vector<Vector3>& points;
  const std::vector<Entries>& logs;
  const std::vector<double>& weights;
  std::vector<Vector3>& result;

  // False where a matrix is too large. `room`: of lanes weights for each logarithm.
  bool run(int batchNumber, std::vector<double>& room) const
  {
    const int begin = batchNumber * lanes, count = static_cast<int>(this->points.size());
    Batch batch;
    for (int i = 0; i < lanes; ++i)
    {
      // The last lanes of the last batch repeat its last point.
      const std::size_t vertex = std::min(begin + i, count - 1);
      for (int r = 0; r < 3; ++r)
      {
        batch.point[r][i] = this->points[vertex][r];
      }
      const double* weight = this->weights.data() + vertex * this->logs.size();
      for (std::size_t k = 0; k < this->logs.size(); ++k)
      {
        room[k * lanes + i] = weight[k];
      }
    }
    if (!sumUp(batch, this->logs, room.data()))
    {
      return false;
    }
    walk(batch);
    for (int i = 0; i < lanes && begin + i < count; ++i)
    {
      this->result[begin + i] = { batch.point[0][i], batch.point[1][i], batch.point[2][i] };
    }
    return true;
  }
};

// The first point whose matrix is too large.
int firstTooLarge(const std::vector<Entries>& logs, const std::vector<double>& weights)
{
  for (std::size_t v = 0;; ++v)
  {
    double square = 0.0, shift = 0.0;
    for (int e = 0; e < 12; ++e)
    {
      double sum = 0.0;
      for (std::size_t k = 0; k < logs.size(); ++k)
      {
        sum += logs[k][e] * weights[v * logs.size() + k];
      }
      (e % 4 == 3 ? shift : square) += sum * sum;
    }
    if (!(square <= largest * largest && shift <= farthest * farthest))
    {
      return static_cast<int>(v);
    }
  }
}

} // namespace

std::vector<double> tents(const std::vector<double>& handles, double t)
{
  std::vector<double> shares(handles.size(), 0.0);
  const auto after = std::upper_bound(handles.begin(), handles.end(), t);
  const std::size_t next = static_cast<std::size_t>(after - handles.begin());
  if (handles.empty())
  {
    return shares;
  }
  if (next == 0 || next == handles.size())
  {
    shares[next == 0 ? 0 : next - 1] = 1.0;
    return shares;
  }
  const double share = (t - handles[next - 1]) / (handles[next] - handles[next - 1]);
  shares[next - 1] = 1.0 - share;
  shares[next] = share;
  return shares;
}

std::vector<Vector3> moved(const std::vector<Vector3>& points,
  const std::vector<Matrix4>& logs,
  const std::vector<double>& weights,
  const Context& context)
{
  for (const Matrix4& log : logs)
  {
    if (!log.row(3).isZero(0.0))
    {
      throw Error(Failure::SolveFailed,
        "A transformation is a perspective: its last row is not 0 0 0 1. Give an affine one.");
    }
  }
  const auto finite = [](const Vector3& p) { return p.allFinite(); };
  const auto bad = std::find_if_not(points.begin(), points.end(), finite);
  if (bad != points.end())
  {
    throw Error(Failure::BadMesh, "Point %1 is not finite; clean the mesh first.", bad - points.begin());
  }
  if (weights.size() != points.size() * logs.size())
  {
    throw Error(Failure::MissingArray,
      "%1 weights are given for %2 points and %3 transformations; give one for each pair.",
      weights.size(),
      points.size(),
      logs.size());
  }
  if (logs.empty())
  {
    return points;
  }
  std::vector<Entries> entries;
  for (const Matrix4& log : logs)
  {
    Entries& rows = entries.emplace_back();
    for (int e = 0; e < 12; ++e)
    {
      rows[e] = log(e / 4, e % 4);
    }
  }
  std::vector<Vector3> result(points.size());
  const Task task{ points, entries, weights, result };
  const int batches = (static_cast<int>(points.size()) + lanes - 1) / lanes;
  std::atomic<bool> good{ true };
  context.parallelFor(batches,
    [&](int begin, int end)
    {
      std::vector<double> room(logs.size() * lanes);
      for (int b = begin; b < end && good && !context.cancelled(); ++b)
      {
        if (!task.run(b, room))
        {
          good = false;
        }
      }
    });
  context.checkpoint(1.0);
  if (!good)
  {
    throw Error(Failure::SolveFailed,
      "The transformations of point %1 are too large or not finite; make a smaller edit, or look at their "
      "weights.",
      firstTooLarge(entries, weights));
  }
  return result;
}

} // namespace oversketch
