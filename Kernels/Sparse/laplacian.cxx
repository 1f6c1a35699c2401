#include "Sparse/laplacian.h"

#include "Sparse/cholesky.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

using Matrix3 = Eigen::Matrix3d;
using Sparse = Eigen::SparseMatrix<double>;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr double largestCotangent = 1e3;

Matrix3 crossMatrix(const Vector3& v)
{
  Matrix3 m;
  m << 0.0, -v[2], v[1], v[2], 0.0, -v[0], -v[1], v[0], 0.0;
  return m;
}

// The vertices that may move: in the region, no neighbour outside it, in a connected piece with a handle.
std::vector<char> movableVertices(const Adjacency& adjacency,
  const std::vector<char>& region,
  const std::vector<Binding>& handles)
{
  const int count = static_cast<int>(region.size());
  std::vector<char> inner(region.size(), 0);
  for (int v = 0; v < count; ++v)
  {
    inner[v] = region[v] && std::all_of(adjacency.vertexVertices.begin(v),
                              adjacency.vertexVertices.end(v),
                              [&](int n) { return region[n] != 0; });
  }
  if (std::find(inner.begin(), inner.end(), 1) == inner.end())
  {
    throw Error(Failure::BadRegion,
      "The region (point array Region) holds no vertex inside its border, so nothing can move; enlarge the "
      "region or "
      "use a finer mesh.");
  }
  std::vector<char> movable(region.size(), 0);
  std::vector<int> stack;
  for (const Binding& handle : handles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = handle.vertices[k];
      if (handle.weights[k] != 0.0 && inner[v] && !movable[v])
      {
        movable[v] = 1;
        stack.push_back(v);
      }
    }
  }
  if (stack.empty())
  {
    throw Error(Failure::BadRegion,
      "No handle lies on a vertex inside the region (point array Region), so nothing pulls it; enlarge the "
      "region or draw "
      "the stroke over it.");
  }
  while (!stack.empty())
  {
    const int v = stack.back();
    stack.pop_back();
    for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
    {
      if (inner[*n] && !movable[*n])
      {
        movable[*n] = 1;
        stack.push_back(*n);
      }
    }
  }
  return movable;
}

// Number of each movable vertex, -1 for the others.
std::vector<int> numberUnknowns(const std::vector<char>& movable)
{
  std::vector<int> numbers(movable.size(), -1);
  for (std::size_t v = 0, next = 0; v < movable.size(); ++v)
  {
    numbers[v] = movable[v] ? static_cast<int>(next++) : -1;
  }
  return numbers;
}

// Which unknowns share a row of the system: those of one one-ring or one handle.
Sparse sharedRows(const Adjacency& adjacency,
  const std::vector<int>& numbers,
  const std::vector<Binding>& handles,
  int count)
{
  Triplets triplets;
  int row = 0;
  const auto add = [&](int v)
  {
    if (numbers[v] >= 0)
    {
      triplets.emplace_back(row, numbers[v], 1.0);
    }
  };
  for (int v = 0; v < static_cast<int>(numbers.size()); ++v, ++row)
  {
    add(v);
    std::for_each(adjacency.vertexVertices.begin(v), adjacency.vertexVertices.end(v), add);
  }
  for (const Binding& handle : handles)
  {
    std::for_each(handle.vertices.begin(), handle.vertices.end(), add);
    ++row;
  }
  Rows rows(row, count);
  rows.setFromTriplets(triplets.begin(), triplets.end());
  return Sparse(rows.transpose() * rows);
}

} // namespace

std::vector<double> cotangentWeights(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& wanted)
{
  std::vector<double> weights(adjacency.edges.size(), 0.0);
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangles[t];
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0] || !(wanted[c[0]] || wanted[c[1]] || wanted[c[2]]))
    {
      continue;
    }
    for (int k = 0; k < 3; ++k)
    {
      const Vector3& p = mesh.points[c[(k + 2) % 3]];
      const Vector3 a = mesh.points[c[k]] - p;
      const Vector3 b = mesh.points[c[(k + 1) % 3]] - p;
      const double cosine = a.dot(b);
      const double sine = a.cross(b).norm();
      // Without area the cotangent is infinite (clamped), or undefined where two corners coincide (0).
      const double cotangent = std::abs(cosine) < largestCotangent * sine ? cosine / sine
                               : cosine == 0.0                            ? 0.0
                                               : std::copysign(largestCotangent, cosine);
      weights[adjacency.triangleEdges[t][k]] += 0.5 * cotangent;
    }
  }
  return weights;
}

struct LaplacianSystem::Parts
{
  std::vector<int> number; // of a vertex's unknown, -1 where it cannot move
  int movable = 0;
  int dimensions = 1; // unknowns per vertex: 1 (x, y, z are three right-hand sides) or 3
  double handleWeight = 0.0;
  std::vector<Binding> handles;
  std::vector<char> active;
  std::unique_ptr<Cholesky> factor;

  // The rows sum_j w_ij (u_i - u_j) [- (T_i - I) delta_i] over the unknowns.
  Sparse laplacianRows(const Mesh& mesh, const Adjacency& adjacency, const std::vector<char>& rows) const;
  // Adds the block of vertex v's displacement to the three rows of vertex `row`.
  void addBlock(Triplets& triplets, int row, int v, const Matrix3& block) const;
  Sparse handleRows() const;
  void factorise(const Sparse& normal, const Context& context);
};

void LaplacianSystem::Parts::addBlock(Triplets& triplets, int row, int v, const Matrix3& block) const
{
  if (this->number[v] < 0)
  {
    return;
  }
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      triplets.emplace_back(3 * row + r, 3 * this->number[v] + c, block(r, c));
    }
  }
}

Sparse LaplacianSystem::Parts::laplacianRows(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& rows) const
{
  const std::vector<double> weights = cotangentWeights(mesh, adjacency, rows);
  Triplets triplets;
  std::vector<Vector3> delta(this->dimensions == 3 ? mesh.points.size() : 0, Vector3::Zero());
  for (std::size_t e = 0; e < weights.size(); ++e)
  {
    for (const auto& [i, j] : { std::pair(adjacency.edges[e].v0, adjacency.edges[e].v1),
           std::pair(adjacency.edges[e].v1, adjacency.edges[e].v0) })
    {
      if (!rows[i] || weights[e] == 0.0)
      {
        continue;
      }
      const double w = weights[e];
      if (this->dimensions == 3)
      {
        delta[i] += w * (mesh.points[i] - mesh.points[j]);
        this->addBlock(triplets, i, i, w * Matrix3::Identity());
        this->addBlock(triplets, i, j, -w * Matrix3::Identity());
        continue;
      }
      if (this->number[i] >= 0)
      {
        triplets.emplace_back(i, this->number[i], w);
      }
      if (this->number[j] >= 0)
      {
        triplets.emplace_back(i, this->number[j], -w);
      }
    }
  }
  for (int i = 0; this->dimensions == 3 && i < mesh.vertexCount(); ++i)
  {
    if (!rows[i])
    {
      continue;
    }
    // Least squares over the ring's edges e = x_j - x_i, e' = e + u_j - u_i, has the closed form
    // s - 1 = sum e . (u_j - u_i) / sum |e|^2,  h = M^-1 sum e x (u_j - u_i),  M = sum |e|^2 I - e e^T.
    const int* begin = adjacency.vertexVertices.begin(i);
    const int* end = adjacency.vertexVertices.end(i);
    double squares = 0.0;
    Matrix3 spread = Matrix3::Zero();
    for (const int* j = begin; j != end; ++j)
    {
      const Vector3 e = mesh.points[*j] - mesh.points[i];
      squares += e.squaredNorm();
      spread += e * e.transpose();
    }
    if (!(squares > 0.0) || !std::isfinite(1.0 / squares))
    {
      continue; // the ring is one point: it shows no rotation, T_i = I
    }
    // A ring on one line shows no rotation about it: the pseudo-inverse leaves that part out.
    const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(Matrix3::Identity() - spread / squares);
    const Vector3 inverseValues =
      eigen.eigenvalues().unaryExpr([](double value) { return value > 1e-8 ? 1.0 / value : 0.0; });
    const Matrix3 inverse =
      eigen.eigenvectors() * inverseValues.asDiagonal() * eigen.eigenvectors().transpose();
    Matrix3 own = Matrix3::Zero();
    for (const int* j = begin; j != end; ++j)
    {
      const Vector3 e = (mesh.points[*j] - mesh.points[i]) / squares;
      const Matrix3 block = crossMatrix(delta[i]) * inverse * crossMatrix(e) - delta[i] * e.transpose();
      own -= block;
      this->addBlock(triplets, i, *j, block);
    }
    this->addBlock(triplets, i, i, own);
  }
  Sparse matrix(this->dimensions * mesh.vertexCount(), this->dimensions * this->movable);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

Sparse LaplacianSystem::Parts::handleRows() const
{
  Triplets triplets;
  for (int h = 0; h < static_cast<int>(this->handles.size()); ++h)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = this->handles[h].vertices[k];
      const double weight = this->handles[h].weights[k] * this->handleWeight;
      for (int c = 0; c < this->dimensions && weight != 0.0 && this->number[v] >= 0; ++c)
      {
        triplets.emplace_back(this->dimensions * h + c, this->dimensions * this->number[v] + c, weight);
      }
    }
  }
  Sparse matrix(this->dimensions * static_cast<int>(this->handles.size()), this->dimensions * this->movable);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

void LaplacianSystem::Parts::factorise(const Sparse& normal, const Context& context)
{
  const Eigen::VectorXd diagonal = normal.diagonal();
  const double largest = diagonal.maxCoeff();
  // Where the rows leave something open (a free piece with one handle may turn about it), a little of the
  // diagonal keeps it where it is: 1e-10 of it is far below what a handle's residual shows.
  for (const double regularisation : { 0.0, 1e-10, 1e-7 })
  {
    Sparse matrix = normal;
    for (int i = 0; regularisation > 0.0 && i < matrix.cols(); ++i)
    {
      matrix.coeffRef(i, i) += regularisation * std::max(diagonal[i], 1e-6 * largest);
    }
    if (this->factor->factorise(matrix, context))
    {
      return;
    }
  }
  throw Error(Failure::SolveFailed,
    "The deformation's linear system could not be factored; repair degenerate triangles in the region or "
    "remesh it.");
}

LaplacianSystem::LaplacianSystem(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& region,
  const std::vector<Binding>& handles,
  const LaplacianOptions& options,
  const Context& context)
  : parts_(new Parts)
{
  Parts& parts = *this->parts_;
  const std::vector<char> movable = movableVertices(adjacency, region, handles);
  parts.movable = static_cast<int>(std::count(movable.begin(), movable.end(), 1));
  parts.dimensions = options.adjustNormals ? 3 : 1;
  parts.handleWeight = options.handleWeight;
  parts.handles = handles;
  parts.active.resize(handles.size());
  std::transform(handles.begin(),
    handles.end(),
    parts.active.begin(),
    [&](const Binding& handle)
    {
      return (handle.weights[0] != 0.0 && movable[handle.vertices[0]]) ||
             (handle.weights[1] != 0.0 && movable[handle.vertices[1]]) ||
             (handle.weights[2] != 0.0 && movable[handle.vertices[2]]);
    });
  parts.number = numberUnknowns(movable);
  parts.factor =
    std::make_unique<Cholesky>(sharedRows(adjacency, parts.number, handles, parts.movable), parts.dimensions);
  context.checkpoint(0.2);

  // Rows of movable vertices and, for a C1 join, of the fixed ones beside them.
  std::vector<char> rows = movable;
  for (int v = 0; options.borderRows && v < mesh.vertexCount(); ++v)
  {
    rows[v] = movable[v] || std::any_of(adjacency.vertexVertices.begin(v),
                              adjacency.vertexVertices.end(v),
                              [&](int n) { return movable[n] != 0; });
  }
  const Sparse laplacian = parts.laplacianRows(mesh, adjacency, rows);
  const Sparse handle = parts.handleRows();
  const Sparse normal = Sparse(laplacian.transpose() * laplacian) + Sparse(handle.transpose() * handle);
  Context factoring = context;
  factoring.progress = [&context](double done) { context.progress(0.4 + 0.5 * done); };
  factoring.checkpoint(0.0);
  parts.factorise(normal, factoring);
}

LaplacianSystem::~LaplacianSystem() = default;

int LaplacianSystem::movableCount() const
{
  return this->parts_->movable;
}

bool LaplacianSystem::handleActive(int handle) const
{
  return this->parts_->active[handle] != 0;
}

std::vector<Vector3> LaplacianSystem::solve(const std::vector<Vector3>& displacements,
  const Context& context) const
{
  const Parts& parts = *this->parts_;
  // x, y, z as columns; the adjusted form has them interleaved in one column.
  const int d = parts.dimensions;
  Eigen::MatrixXd solution = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(parts.movable) * d, 3 / d);
  const auto at = [&](int number, int c) -> double&
  { return d == 3 ? solution(3 * number + c, 0) : solution(number, c); };
  for (std::size_t h = 0; h < parts.handles.size(); ++h)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int n = parts.number[parts.handles[h].vertices[k]];
      const double weight = parts.handleWeight * parts.handleWeight * parts.handles[h].weights[k];
      for (int c = 0; c < 3 && n >= 0; ++c)
      {
        at(n, c) += weight * displacements[h][c];
      }
    }
  }
  parts.factor->solve(solution);
  if (!solution.allFinite())
  {
    throw Error(Failure::SolveFailed,
      "The deformation's linear system has no finite solution; repair degenerate triangles in the region or "
      "remesh it.");
  }
  context.checkpoint(1.0);
  std::vector<Vector3> result(parts.number.size(), Vector3::Zero());
  for (std::size_t v = 0; v < result.size(); ++v)
  {
    if (parts.number[v] >= 0)
    {
      const int n = parts.number[v];
      result[v] = Vector3(at(n, 0), at(n, 1), at(n, 2));
    }
  }
  return result;
}

} // namespace oversketch
