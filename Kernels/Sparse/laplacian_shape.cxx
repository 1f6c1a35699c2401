#include "Sparse/laplacian.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

using Matrix3 = Eigen::Matrix3d;

constexpr double largestCotangent = 1e3;

Matrix3 crossMatrix(const Vector3& v)
{
  Matrix3 m;
  m << 0.0, -v[2], v[1], v[2], 0.0, -v[0], -v[1], v[0], 0.0;
  return m;
}

} // namespace

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
    for (const int n : adjacency.vertexVertices[v])
    {
      if (inner[n] && !movable[n])
      {
        movable[n] = 1;
        stack.push_back(n);
      }
    }
  }
  return movable;
}

double cotangentWeight(const Mesh& mesh, const Adjacency& adjacency, int edge)
{
  double weight = 0.0;
  for (const int t : adjacency.trianglesAt(edge))
  {
    const Triangle& c = mesh.triangles[t];
    const std::array<int, 3>& sides = adjacency.triangleEdges[t];
    const int k = sides[0] == edge ? 0 : sides[1] == edge ? 1 : 2;
    const Vector3& p = mesh.points[c[(k + 2) % 3]];
    const Vector3 a = mesh.points[c[k]] - p;
    const Vector3 b = mesh.points[c[(k + 1) % 3]] - p;
    const double cosine = a.dot(b);
    const double sine = a.cross(b).norm();
    // Without area the cotangent is infinite (clamped), or undefined where two corners coincide (0).
    const double cotangent = std::abs(cosine) < largestCotangent * sine ? cosine / sine
                             : cosine == 0.0                            ? 0.0
                                             : std::copysign(largestCotangent, cosine);
    weight += 0.5 * cotangent;
  }
  return weight;
}

namespace
{

// Rows sum_j w_ij (u_i - u_j) [- (T_i - I) delta_i]: block k of row i belongs to the k-th neighbour of vertex
// i, the one after them to i itself. One number for each stands for x, y and z where T_i = I, else it is 3x3,
// column-major.
struct LaplacianRows
{
  const Adjacency& adjacency;
  int entries;                 // of a block: 1 or 9
  std::vector<int> firstBlock; // of a vertex with a row
  std::vector<double> blocks;

  // rows: the vertices that have one.
  LaplacianRows(const Mesh& mesh,
    const Adjacency& neighbours,
    const std::vector<int>& rows,
    bool adjust,
    const Context& context);
  int ringSize(int i) const { return this->adjacency.vertexVertices.size(i) + 1; }
  int ringVertex(int i, int k) const
  {
    return k + 1 < this->ringSize(i) ? this->adjacency.vertexVertices.begin(i)[k] : i;
  }
  double* block(int i, int k)
  {
    return this->blocks.data() + (static_cast<std::size_t>(this->firstBlock[i]) + k) * this->entries;
  }
  const double* block(int i, int k) const { return const_cast<LaplacianRows*>(this)->block(i, k); }

private:
  void adjust(const Mesh& mesh, int i);
};

LaplacianRows::LaplacianRows(const Mesh& mesh,
  const Adjacency& neighbours,
  const std::vector<int>& rows,
  bool adjust,
  const Context& context)
  : adjacency(neighbours)
  , entries(adjust ? 9 : 1)
  , firstBlock(mesh.points.size(), -1)
{
  int count = 0;
  for (const int i : rows)
  {
    this->firstBlock[i] = count;
    count += this->ringSize(i);
  }
  this->blocks.resize(static_cast<std::size_t>(count) * this->entries, 0.0);
  context.each(static_cast<int>(rows.size()),
    [&](int row)
    {
      const int i = rows[row];
      for (int k = 0; k + 1 < this->ringSize(i); ++k)
      {
        const double w = cotangentWeight(mesh, neighbours, neighbours.findEdge(i, this->ringVertex(i, k)));
        double* own = this->block(i, this->ringSize(i) - 1);
        double* other = this->block(i, k);
        for (int c = 0; c < this->entries; c += 4)
        {
          own[c] += w;
          other[c] -= w;
        }
      }
      if (adjust)
      {
        this->adjust(mesh, i);
      }
    });
}

// Least squares over the ring's edges e = x_j - x_i, e' = e + u_j - u_i, has the closed form
// s - 1 = sum e . (u_j - u_i) / sum |e|^2,  h = M^-1 sum e x (u_j - u_i),  M = sum |e|^2 I - e e^T.
void LaplacianRows::adjust(const Mesh& mesh, int i)
{
  const int neighbours = this->ringSize(i) - 1;
  double squares = 0.0;
  Matrix3 spread = Matrix3::Zero();
  Vector3 delta = Vector3::Zero();
  for (int k = 0; k < neighbours; ++k)
  {
    const Vector3 e = mesh.points[this->ringVertex(i, k)] - mesh.points[i];
    squares += e.squaredNorm();
    spread += e * e.transpose();
    delta += *this->block(i, k) * e; // - w_ij e
  }
  if (!(squares > 0.0) || !std::isfinite(1.0 / squares))
  {
    return; // the ring is one point: it shows no rotation, T_i = I
  }
  const Matrix3 moment = Matrix3::Identity() - spread / squares;
  Matrix3 inverse;
  if (moment.determinant() > 1e-3)
  {
    inverse = moment.inverse();
  }
  else
  {
    // A ring on one line shows no rotation about it: the pseudo-inverse leaves that part out.
    const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(moment);
    const Vector3 inverseValues =
      eigen.eigenvalues().unaryExpr([](double value) { return value > 1e-8 ? 1.0 / value : 0.0; });
    inverse = eigen.eigenvectors() * inverseValues.asDiagonal() * eigen.eigenvectors().transpose();
  }
  const Matrix3 turn = crossMatrix(delta) * inverse;
  Matrix3 own = Matrix3::Zero();
  for (int k = 0; k < neighbours; ++k)
  {
    const Vector3 e = (mesh.points[this->ringVertex(i, k)] - mesh.points[i]) / squares;
    const Matrix3 block = turn * crossMatrix(e) - delta * e.transpose();
    own -= block;
    Eigen::Map<Matrix3>(this->block(i, k)) += block;
  }
  Eigen::Map<Matrix3>(this->block(i, neighbours)) += own;
}

// R^T R of the rows, over the unknowns. A column's rows come in the order in which its vertex's rings meet
// them.
template <int B>
BlockMatrix normalMatrixOf(const LaplacianRows& laplacian,
  const LaplacianShape& shape,
  const Context& context)
{
  using Block = Eigen::Matrix<double, B, B>;
  const int count = static_cast<int>(shape.vertices.size());
  constexpr int chunk = 1024;
  struct Columns
  {
    std::vector<int> rows, counts;
    std::vector<double> values;
  };
  std::vector<Columns> chunks(static_cast<std::size_t>((count + chunk - 1) / chunk));
  context.parallelFor(static_cast<int>(chunks.size()),
    [&](int begin, int end)
    {
      std::vector<std::size_t> places(
        static_cast<std::size_t>(count)); // of a row's block, if it is one of the column's
      for (int c = begin; c < end && !context.cancelled(); ++c)
      {
        Columns& out = chunks[c];
        for (int unknown = c * chunk; unknown < std::min(count, (c + 1) * chunk); ++unknown)
        {
          const std::size_t first = out.rows.size();
          const int v = shape.vertices[unknown];
          for (int r = 0; r < laplacian.ringSize(v); ++r)
          {
            const int i = laplacian.ringVertex(v, r);
            if (laplacian.firstBlock[i] < 0)
            {
              continue;
            }
            int own = 0;
            while (laplacian.ringVertex(i, own) != v)
            {
              ++own;
            }
            const Eigen::Map<const Block> right(laplacian.block(i, own));
            for (int k = 0; k < laplacian.ringSize(i); ++k)
            {
              const int row = shape.number[laplacian.ringVertex(i, k)];
              if (row < 0)
              {
                continue;
              }
              std::size_t place = places[row];
              if (place < first || place >= out.rows.size() || out.rows[place] != row)
              {
                places[row] = place = out.rows.size();
                out.rows.push_back(row);
                out.values.resize(out.values.size() + B * B, 0.0);
              }
              Eigen::Map<Block>(out.values.data() + place * B * B).noalias() +=
                Eigen::Map<const Block>(laplacian.block(i, k)).transpose() * right;
            }
          }
          out.counts.push_back(static_cast<int>(out.rows.size() - first));
        }
      }
    });
  context.checkpoint(0.4);
  BlockMatrix matrix;
  matrix.block = B;
  matrix.pattern.offsets.push_back(0);
  for (const Columns& columns : chunks)
  {
    for (const int rowCount : columns.counts)
    {
      matrix.pattern.offsets.push_back(matrix.pattern.offsets.back() + rowCount);
    }
  }
  matrix.pattern.values.reserve(static_cast<std::size_t>(matrix.pattern.offsets.back()));
  matrix.values.reserve(static_cast<std::size_t>(matrix.pattern.offsets.back()) * B * B);
  for (Columns& columns : chunks)
  {
    matrix.pattern.values.insert(matrix.pattern.values.end(), columns.rows.begin(), columns.rows.end());
    matrix.values.insert(matrix.values.end(), columns.values.begin(), columns.values.end());
    columns = Columns();
  }
  return matrix;
}

// The matrix with zero blocks at these columns and rows, too.
BlockMatrix extended(const BlockMatrix& matrix, std::vector<std::pair<int, int>> places)
{
  sortUnique(places);
  const std::size_t entries = static_cast<std::size_t>(matrix.block) * matrix.block;
  BlockMatrix result;
  result.block = matrix.block;
  result.pattern.offsets.push_back(0);
  auto next = places.begin();
  for (int column = 0; column < matrix.nodeCount(); ++column)
  {
    const auto values =
      matrix.values.begin() + static_cast<std::ptrdiff_t>(entries) * matrix.pattern.offsets[column];
    result.pattern.values.insert(
      result.pattern.values.end(), matrix.pattern.begin(column), matrix.pattern.end(column));
    result.values.insert(result.values.end(),
      values,
      values + static_cast<std::ptrdiff_t>(entries) * matrix.pattern.size(column));
    for (; next != places.end() && next->first == column; ++next)
    {
      result.pattern.values.push_back(next->second);
      result.values.resize(result.values.size() + entries, 0.0);
    }
    result.pattern.offsets.push_back(static_cast<int>(result.pattern.values.size()));
  }
  return result;
}

} // namespace

LaplacianShape::LaplacianShape(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& movable,
  bool borderRows,
  bool adjustNormals,
  const Context& context)
  : number(movable.size(), -1)
{
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (movable[v])
    {
      this->number[v] = static_cast<int>(this->vertices.size());
      this->vertices.push_back(v);
      this->positions.push_back(mesh.points[v]);
    }
  }
  // Rows of movable vertices and, for a C1 join, of the fixed ones beside them.
  std::vector<int> rows = this->vertices;
  std::vector<char> hasRow = movable;
  for (const int v : this->vertices)
  {
    for (const int n : borderRows ? adjacency.vertexVertices[v] : Lists::Range())
    {
      if (!hasRow[n])
      {
        hasRow[n] = 1;
        rows.push_back(n);
      }
    }
  }
  const LaplacianRows laplacian(mesh, adjacency, rows, adjustNormals, context);
  context.checkpoint(0.2);
  this->normal = adjustNormals ? normalMatrixOf<3>(laplacian, *this, context)
                               : normalMatrixOf<1>(laplacian, *this, context);
  context.checkpoint(0.6);
  this->elimination = std::make_shared<Elimination>(this->normal.pattern, this->positions, context);
}

BlockMatrix LaplacianShape::normalMatrix(const std::vector<Binding>& handles, double handleWeight) const
{
  // Two unknowns that one handle hangs on: column, row and weight.
  struct Link
  {
    int column, row;
    double weight;
  };
  std::vector<Link> links;
  std::vector<std::pair<int, int>> missing;
  const auto find = [](const BlockMatrix& matrix, const Link& link)
  { return std::find(matrix.pattern.begin(link.column), matrix.pattern.end(link.column), link.row); };
  for (const Binding& handle : handles)
  {
    for (int k = 0; k < 9; ++k)
    {
      const Link link{ this->number[handle.vertices[k / 3]],
        this->number[handle.vertices[k % 3]],
        handleWeight * handleWeight * handle.weights[k / 3] * handle.weights[k % 3] };
      if (link.column >= 0 && link.row >= 0 && link.weight != 0.0)
      {
        links.push_back(link);
        if (find(this->normal, link) == this->normal.pattern.end(link.column))
        {
          missing.emplace_back(link.column, link.row);
        }
      }
    }
  }
  BlockMatrix matrix = missing.empty() ? this->normal : extended(this->normal, missing);
  for (const Link& link : links)
  {
    const std::ptrdiff_t place = find(matrix, link) - matrix.pattern.values.data();
    double* block = matrix.values.data() + place * matrix.block * matrix.block;
    for (int k = 0; k < matrix.block; ++k)
    {
      block[k * (matrix.block + 1)] += link.weight;
    }
  }
  return matrix;
}

} // namespace oversketch
