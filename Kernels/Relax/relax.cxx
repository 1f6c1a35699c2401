#include "Relax/relax.h"

#include "Mesh/context.h"
#include "Sparse/cholesky.h"
#include "Sparse/laplacian.h"

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <memory>

namespace oversketch
{

namespace
{

// The part with its noise taken off along the surface's normals: on a crumpled surface weights say nothing of
// the smooth one. Vertices keep their place along it, so that it is not the triangles that are made even.
Mesh withoutNoise(const MeshPart& part)
{
  // To and fro, so that the surface does not shrink (G. Taubin, "A signal processing approach to fair surface
  // design", 1995).
  constexpr double to = 0.5, fro = -0.53;
  constexpr int rounds = 20;
  std::vector<int> inner;
  for (int v = 0; v < part.mesh.vertexCount(); ++v)
  {
    if (!part.adjacency.borderVertex[v] && part.adjacency.vertexVertices.size(v) > 0)
    {
      inner.push_back(v);
    }
  }
  Mesh plain = part.mesh;
  for (int round = 0; round < rounds; ++round)
  {
    const std::vector<Vector3> before = plain.points;
    for (const int v : inner)
    {
      Vector3 mean = Vector3::Zero();
      for (const int n : part.adjacency.vertexVertices[v])
      {
        mean += before[n];
      }
      plain.points[v] +=
        (round % 2 == 0 ? to : fro) * (mean / part.adjacency.vertexVertices.size(v) - before[v]);
    }
  }
  const std::vector<Vector3> normals = vertexNormals(plain, part.adjacency.vertexTriangles, Context());
  for (std::size_t v = 0; v < plain.points.size(); ++v)
  {
    const Vector3& place = part.mesh.points[v];
    plain.points[v] = place + normals[v].dot(plain.points[v] - place) * normals[v];
  }
  return plain;
}

// The Laplacian's rows of the unknowns, times scale^2 / sqrt(area): over all vertices of the part, and over
// the unknowns.
struct Rows
{
  Eigen::SparseMatrix<double, Eigen::RowMajor> whole, unknown;
};

Rows rowsOf(const RelaxBand& band,
  const Mesh& plain,
  const std::vector<int>& number,
  const std::vector<double>& areas)
{
  const MeshPart& part = band.part;
  std::vector<double> weights(part.adjacency.edges.size());
  for (std::size_t e = 0; e < weights.size(); ++e)
  {
    weights[e] = cotangentWeight(plain, part.adjacency, static_cast<int>(e));
  }
  using Entries = std::vector<Eigen::Triplet<double>>;
  Entries whole, unknown;
  const auto add = [&](int row, int v, double value)
  {
    whole.emplace_back(row, v, value);
    if (number[v] >= 0)
    {
      unknown.emplace_back(row, number[v], value);
    }
  };
  for (const int v : marked(band.part.region))
  {
    const double factor = band.scale[v] * band.scale[v] / std::sqrt(areas[v]);
    double sum = 0.0;
    for (const int n : part.adjacency.vertexVertices[v])
    {
      const double weight = factor * weights[part.adjacency.findEdge(v, n)];
      add(number[v], n, -weight);
      sum += weight;
    }
    add(number[v], v, sum);
  }
  const int unknowns = 1 + *std::max_element(number.begin(), number.end());
  Rows rows{ { unknowns, part.mesh.vertexCount() }, { unknowns, unknowns } };
  rows.whole.setFromTriplets(whole.begin(), whole.end());
  rows.unknown.setFromTriplets(unknown.begin(), unknown.end());
  return rows;
}

std::vector<double> areasOf(const Mesh& mesh)
{
  std::vector<double> areas(mesh.points.size(), 0.0);
  double sum = 0.0;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const double third = facetArea(mesh, t) / 3.0;
    sum += 3.0 * third;
    for (const int v : mesh.triangles[t])
    {
      areas[v] += third;
    }
  }
  const double least = 1e-6 * sum / static_cast<double>(areas.size());
  for (double& area : areas)
  {
    area = std::max(area, least);
  }
  return areas;
}

// The places of the part's vertices by shares of the moves of those that were solved for, less where a
// triangle would turn over against the surface without noise: in folds and clefts that are narrower than the
// band.
std::vector<Vector3> movedSoundly(const MeshPart& part,
  const Mesh& plain,
  const std::vector<int>& solved,
  const Eigen::MatrixXd& moves,
  std::vector<double> shares,
  int rounds) // the last one leaves what still turns where it was; 0: all go all the way
{
  Mesh moved = part.mesh;
  for (int round = 0; round <= rounds; ++round)
  {
    for (std::size_t i = 0; i < solved.size(); ++i)
    {
      const int v = solved[i];
      moved.points[v] = part.mesh.points[v] + shares[v] * moves.row(static_cast<Eigen::Index>(i)).transpose();
    }
    std::vector<char> isFolded(part.vertices.size(), 0);
    for (int t = 0; t < moved.triangleCount(); ++t)
    {
      const Vector3 before = facetNormal(plain, t);
      if (facetNormal(moved, t).dot(before) < 0.0 && facetNormal(part.mesh, t).dot(before) > 0.0)
      {
        for (const int v : moved.triangles[t])
        {
          isFolded[v] = 1;
        }
      }
    }
    const std::vector<int> folded = marked(isFolded);
    if (folded.empty() || round == rounds)
    {
      break;
    }
    for (const int v : folded)
    {
      for (const int n : part.adjacency.vertexVertices[v])
      {
        isFolded[n] = 1;
      }
    }
    for (const int v : marked(isFolded))
    {
      shares[v] *= round + 1 == rounds ? 0.0 : 0.5;
    }
  }
  return moved.points;
}

} // namespace

std::vector<Vector3> relaxed(const RelaxBand& band, const Context& context)
{
  const MeshPart& part = band.part;
  const std::vector<int> solved = marked(part.region);
  if (solved.empty())
  {
    return part.mesh.points;
  }
  const std::vector<int> number = placesIn(solved, part.region.size());
  const Mesh plain = band.isNoisy ? withoutNoise(part) : part.mesh;
  const std::vector<double> areas = areasOf(plain);
  const Rows rows = rowsOf(band, plain, number, areas);
  context.checkpoint(0.3);
  // By the moves u = x - p: (W A + R^T R) u = -R^T R p.
  Eigen::SparseMatrix<double> normal = rows.unknown.transpose() * rows.unknown;
  Eigen::VectorXd diagonal(static_cast<Eigen::Index>(solved.size()));
  for (std::size_t i = 0; i < solved.size(); ++i)
  {
    diagonal[static_cast<Eigen::Index>(i)] = band.weight[solved[i]] * areas[solved[i]];
  }
  normal += Eigen::SparseMatrix<double>(diagonal.asDiagonal());
  normal.makeCompressed();
  BlockMatrix matrix;
  matrix.pattern.offsets.assign(normal.outerIndexPtr(), normal.outerIndexPtr() + normal.outerSize() + 1);
  matrix.pattern.values.assign(normal.innerIndexPtr(), normal.innerIndexPtr() + normal.nonZeros());
  matrix.values.assign(normal.valuePtr(), normal.valuePtr() + normal.nonZeros());
  context.checkpoint(0.5);
  // From the middle of the part, so that far from the origin no digits are lost.
  const Vector3 middle = boxRound(part.mesh.points).center();
  Eigen::MatrixXd before(part.mesh.vertexCount(), 3);
  for (int v = 0; v < part.mesh.vertexCount(); ++v)
  {
    before.row(v) = (part.mesh.points[v] - middle).transpose();
  }
  Eigen::MatrixXd moves = -(rows.unknown.transpose() * (rows.whole * before));
  Cholesky factor(
    std::make_shared<const Elimination>(matrix.pattern, valuesAt(part.mesh.points, solved), context));
  if (!factor.factorise(matrix, context))
  {
    throw Error(Failure::SolveFailed,
      "The system of the band could not be factored; repair degenerate triangles there or remesh it.");
  }
  context.checkpoint(0.9);
  factor.solve(moves, context);
  context.checkpoint(1.0); // a cancelled one has solved a part
  if (!moves.allFinite())
  {
    throw Error(Failure::SolveFailed,
      "The system of the band has no finite solution; repair degenerate triangles there or remesh it.");
  }
  return movedSoundly(part, plain, solved, moves, band.share, band.isNoisy ? 10 : 0);
}

} // namespace oversketch
