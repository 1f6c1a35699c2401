#include "Sparse/laplacian.h"

#include "Sparse/cholesky.h"

#include <algorithm>

namespace oversketch
{

struct LaplacianSystem::Parts
{
  std::shared_ptr<const LaplacianShape> shape;
  std::vector<Binding> handles;
  double handleWeight = 0.0;
  std::unique_ptr<Cholesky> factor;

  void factorise(BlockMatrix matrix, const Context& context);
};

// The matrix is taken by value: it may be regularised.
void LaplacianSystem::Parts::factorise(BlockMatrix matrix, const Context& context)
{
  std::vector<double*> entries;
  for (int i = 0; i < matrix.nodeCount(); ++i)
  {
    const int* place = std::find(matrix.pattern.begin(i), matrix.pattern.end(i), i);
    double* block = matrix.values.data() + static_cast<std::size_t>(place - matrix.pattern.values.data()) *
                                             matrix.block * matrix.block;
    for (int k = 0; k < matrix.block; ++k)
    {
      entries.push_back(block + k * (matrix.block + 1));
    }
  }
  std::vector<double> diagonal(entries.size());
  std::transform(
    entries.begin(), entries.end(), diagonal.begin(), [](const double* entry) { return *entry; });
  const double largest = *std::max_element(diagonal.begin(), diagonal.end());
  // Where the rows leave something open (a free piece with one handle may turn about it), a little of the
  // diagonal keeps it where it is: 1e-10 of it is far below what a handle's residual shows.
  for (const double regularisation : { 0.0, 1e-10, 1e-7 })
  {
    for (std::size_t i = 0; regularisation > 0.0 && i < entries.size(); ++i)
    {
      *entries[i] = diagonal[i] + regularisation * std::max(diagonal[i], 1e-6 * largest);
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

LaplacianSystem::LaplacianSystem(std::shared_ptr<const LaplacianShape> shape,
  const std::vector<Binding>& handles,
  double handleWeight,
  const Context& context,
  std::shared_ptr<FactorMemory> memory)
  : Pieces(new Parts)
{
  Parts& parts = *this->Pieces;
  parts.shape = std::move(shape);
  parts.handles = handles;
  parts.handleWeight = handleWeight;
  BlockMatrix matrix = parts.shape->normalMatrix(handles, handleWeight);
  const bool same = matrix.pattern.values.size() == parts.shape->normal.pattern.values.size();
  parts.factor = std::make_unique<Cholesky>(
    same ? parts.shape->elimination
         : std::make_shared<const Elimination>(matrix.pattern, parts.shape->positions, context),
    std::move(memory));
  parts.factorise(std::move(matrix), context);
}

LaplacianSystem::LaplacianSystem(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& region,
  const std::vector<Binding>& handles,
  const LaplacianOptions& options,
  const Context& context)
  : LaplacianSystem(std::make_shared<LaplacianShape>(mesh,
                      adjacency,
                      movableVertices(adjacency, region, handles),
                      options.borderRows,
                      options.adjustNormals,
                      context),
      handles,
      options.handleWeight,
      context)
{
}

LaplacianSystem::~LaplacianSystem() = default;

const LaplacianShape& LaplacianSystem::shape() const
{
  return *this->Pieces->shape;
}

int LaplacianSystem::movableCount() const
{
  return static_cast<int>(this->shape().vertices.size());
}

bool LaplacianSystem::handleActive(int handle) const
{
  const Binding& binding = this->Pieces->handles[handle];
  bool active = false;
  for (int k = 0; k < 3; ++k)
  {
    active = active || (binding.weights[k] != 0.0 && this->Pieces->shape->number[binding.vertices[k]] >= 0);
  }
  return active;
}

std::vector<Vector3> LaplacianSystem::solve(const std::vector<Vector3>& displacements,
  const Context& context) const
{
  const Parts& parts = *this->Pieces;
  const LaplacianShape& shape = *parts.shape;
  // x, y, z as columns; the adjusted form has them interleaved in one column.
  const int d = shape.normal.block;
  Eigen::MatrixXd solution =
    Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(shape.vertices.size()) * d, 3 / d);
  const auto at = [&](int number, int c) -> double&
  { return d == 3 ? solution(3 * number + c, 0) : solution(number, c); };
  for (std::size_t h = 0; h < parts.handles.size(); ++h)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int n = shape.number[parts.handles[h].vertices[k]];
      const double weight = parts.handleWeight * parts.handleWeight * parts.handles[h].weights[k];
      for (int c = 0; c < 3 && n >= 0; ++c)
      {
        at(n, c) += weight * displacements[h][c];
      }
    }
  }
  parts.factor->solve(solution, context);
  if (!solution.allFinite())
  {
    throw Error(Failure::SolveFailed,
      "The deformation's linear system has no finite solution; repair degenerate triangles in the region or "
      "remesh it.");
  }
  std::vector<Vector3> result(shape.number.size(), Vector3::Zero());
  for (int n = 0; n < static_cast<int>(shape.vertices.size()); ++n)
  {
    result[shape.vertices[n]] = Vector3(at(n, 0), at(n, 1), at(n, 2));
  }
  return result;
}

std::vector<double> LaplacianSystem::response(const std::vector<double>& shares, const Context& context) const
{
  const Parts& parts = *this->Pieces;
  const LaplacianShape& shape = *parts.shape;
  const int d = shape.normal.block;
  const Eigen::Index count = static_cast<Eigen::Index>(shape.vertices.size());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(count * d, d);
  for (std::size_t h = 0; h < parts.handles.size(); ++h)
  {
    const Binding& handle = parts.handles[h];
    for (int k = 0; k < 3; ++k)
    {
      const int n = shape.number[handle.vertices[k]];
      for (int c = 0; c < d && n >= 0; ++c)
      {
        columns(n * d + c, c) += shares[h] * parts.handleWeight * parts.handleWeight * handle.weights[k];
      }
    }
  }
  parts.factor->solve(columns, context);
  std::vector<double> result;
  result.reserve(static_cast<std::size_t>(count) * d * d);
  for (Eigen::Index n = 0; n < count; ++n)
  {
    for (int c = 0; c < d; ++c)
    {
      result.insert(result.end(), columns.col(c).data() + n * d, columns.col(c).data() + (n + 1) * d);
    }
  }
  return result;
}

template <class Real>
void Drag::place(const Vector3& d, Real* points, const Context& context) const
{
  const int count = static_cast<int>(this->vertices.size());
  const bool turns = this->response.size() != this->vertices.size();
  const auto body = [&](int begin, int end)
  {
    const double x = d[0], y = d[1], z = d[2];
    for (int i = begin; i < end; ++i)
    {
      const double* from = this->rest[i].data();
      Real* point = points + static_cast<std::ptrdiff_t>(3) * this->vertices[i];
      if (turns)
      {
        const double* r = this->response.data() + static_cast<std::ptrdiff_t>(9) * i;
        point[0] = static_cast<Real>(from[0] + (r[0] * x + r[3] * y + r[6] * z));
        point[1] = static_cast<Real>(from[1] + (r[1] * x + r[4] * y + r[7] * z));
        point[2] = static_cast<Real>(from[2] + (r[2] * x + r[5] * y + r[8] * z));
      }
      else
      {
        const double r = this->response[i];
        point[0] = static_cast<Real>(from[0] + r * x);
        point[1] = static_cast<Real>(from[1] + r * y);
        point[2] = static_cast<Real>(from[2] + r * z);
      }
    }
  };
  // Below this, waking another thread takes longer than the work.
  constexpr int worthThreads = 65536;
  count < worthThreads ? body(0, count) : context.parallelFor(count, body);
}

template void Drag::place(const Vector3& d, float* points, const Context& context) const;
template void Drag::place(const Vector3& d, double* points, const Context& context) const;

} // namespace oversketch
