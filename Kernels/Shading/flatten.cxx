#include "Shading/flatten.h"

#include "Mesh/context.h"
#include "Mesh/shape.h"
#include "Sparse/cholesky.h"
#include "Sparse/laplacian.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace oversketch
{
namespace
{

constexpr double evenEnough = 0.05; // of a texel's side, in the mean

// Each vertex's share of all area.
std::vector<double> shares(const Mesh& patch, const std::vector<double>& areas)
{
  std::vector<double> share(patch.points.size(), 0.0);
  double whole = 0.0;
  for (int t = 0; t < patch.triangleCount(); ++t)
  {
    whole += areas[t];
    for (const int v : patch.triangles[t])
    {
      share[v] += areas[t] / 3.0;
    }
  }
  for (double& s : share)
  {
    s /= whole;
  }
  return share;
}

// The harmonic map with a fixed border.
class Harmonic
{
public:
  Harmonic(const Mesh& patch,
    const std::vector<int>& border,
    const Adjacency& adjacency,
    const Context& context)
    : Sides(adjacency)
    , Number(patch.points.size(), 0)
  {
    for (const int v : border)
    {
      this->Number[v] = -1;
    }
    std::vector<Vector3> places;
    for (int v = 0; v < patch.vertexCount(); ++v)
    {
      if (this->Number[v] == 0)
      {
        this->Number[v] = static_cast<int>(this->Inner.size());
        this->Inner.push_back(v);
        places.push_back(patch.points[v]);
      }
    }
    if (this->Inner.empty())
    {
      return;
    }
    const std::vector<double> ones(adjacency.edges.size(), 1.0), none(this->Inner.size(), 0.0);
    this->Matrix = weightMatrix(adjacency, ones, this->Inner, this->Number, none);
    for (const int v : this->Inner)
    {
      for (const int n : adjacency.vertexVertices[v])
      {
        this->Edges.push_back(adjacency.findEdge(v, n));
        this->Stays.push_back(this->Number[n] < 0);
      }
    }
    this->Factor =
      std::make_unique<Cholesky>(std::make_shared<const Elimination>(this->Matrix.pattern, places, context));
  }

  void solve(const std::vector<double>& weights, std::vector<Vector2>& disc, const Context& context)
  {
    if (this->Inner.empty())
    {
      return;
    }
    this->weigh(weights);
    if (!this->Factor->factorise(this->Matrix, context))
    {
      throw Error(Failure::SolveFailed, "The region could not be flattened; clean the mesh first.");
    }
    Eigen::MatrixXd side = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(this->Inner.size()), 2);
    for (std::size_t e = 0; e < this->Sides.edges.size(); ++e)
    {
      const MeshEdge& edge = this->Sides.edges[e];
      for (const auto& [inner, fixed] :
        { std::make_pair(edge.v0, edge.v1), std::make_pair(edge.v1, edge.v0) })
      {
        if (this->Number[inner] >= 0 && this->Number[fixed] < 0)
        {
          side.row(this->Number[inner]) += weights[e] * disc[fixed].transpose();
        }
      }
    }
    this->Factor->solve(side, context);
    for (std::size_t i = 0; i < this->Inner.size(); ++i)
    {
      disc[this->Inner[i]] = side.row(static_cast<Eigen::Index>(i));
    }
  }

private:
  // Puts what weightMatrix makes of other weights in the place of the last ones.
  void weigh(const std::vector<double>& weights)
  {
    std::size_t neighbour = 0;
    for (std::size_t i = 0; i < this->Inner.size(); ++i)
    {
      double* own = &this->Matrix.values[static_cast<std::size_t>(this->Matrix.pattern.offsets[i])];
      double* next = own + 1;
      *own = 0.0;
      for (int k = this->Sides.vertexVertices.size(this->Inner[i]); k > 0; --k, ++neighbour)
      {
        const double weight = weights[this->Edges[neighbour]];
        *own += weight;
        if (!this->Stays[neighbour])
        {
          *next++ = -weight;
        }
      }
    }
  }

  const Adjacency& Sides;
  std::vector<int> Number, Inner;
  BlockMatrix Matrix;
  std::vector<int> Edges;  // of the inner vertices, neighbour by neighbour
  std::vector<char> Stays; // whether that neighbour is on the border
  std::unique_ptr<Cholesky> Factor;
};

// The border on the unit circle by its length.
std::vector<Vector2> onCircle(const Mesh& patch, const std::vector<int>& border)
{
  std::vector<double> lengths{ 0.0 };
  for (std::size_t i = 0; i < border.size(); ++i)
  {
    const double step = (patch.points[border[(i + 1) % border.size()]] - patch.points[border[i]]).norm();
    if (!(step > 0.0) || !std::isfinite(step))
    {
      throw Error(Failure::BadRegion,
        "{The boundary} has an edge without length at vertex %1 of the region; clean the mesh first.",
        border[i]);
    }
    lengths.push_back(lengths.back() + step);
  }
  std::vector<Vector2> disc(patch.points.size(), Vector2::Zero());
  for (std::size_t i = 0; i < border.size(); ++i)
  {
    const double angle = 2.0 * M_PI * lengths[i] / lengths.back();
    disc[border[i]] = { std::cos(angle), std::sin(angle) };
  }
  return disc;
}

} // namespace

std::vector<double> positiveWeights(const Mesh& mesh, const Adjacency& adjacency)
{
  std::vector<double> weights;
  weights.reserve(adjacency.edges.size());
  for (int e = 0; e < static_cast<int>(adjacency.edges.size()); ++e)
  {
    weights.push_back(std::max(cotangentWeight(mesh, adjacency, e), 1e-3));
  }
  return weights;
}

BlockMatrix weightMatrix(const Adjacency& adjacency,
  const std::vector<double>& weights,
  const std::vector<int>& vertices,
  const std::vector<int>& number,
  const std::vector<double>& diagonal)
{
  BlockMatrix matrix;
  matrix.pattern.offsets.push_back(0);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const int v = vertices[i];
    const std::size_t own = matrix.values.size();
    matrix.pattern.values.push_back(static_cast<int>(i));
    matrix.values.push_back(diagonal[i]);
    for (const int n : adjacency.vertexVertices[v])
    {
      const double weight = weights[adjacency.findEdge(v, n)];
      matrix.values[own] += weight;
      if (number[n] >= 0)
      {
        matrix.pattern.values.push_back(number[n]);
        matrix.values.push_back(-weight);
      }
    }
    matrix.pattern.offsets.push_back(static_cast<int>(matrix.pattern.values.size()));
  }
  return matrix;
}

std::vector<Vector2> flattened(const Mesh& patch, const Context& context, int rounds)
{
  const Adjacency adjacency = buildAdjacency(patch, context);
  const std::vector<int> border = discBorder(patch, adjacency);
  const std::vector<double> weights = positiveWeights(patch, adjacency);
  std::vector<double> areas;
  for (int t = 0; t < patch.triangleCount(); ++t)
  {
    areas.push_back(facetArea(patch, t));
  }
  const double whole = std::accumulate(areas.begin(), areas.end(), 0.0);
  if (!(whole > 0.0) || !std::isfinite(whole))
  {
    throw Error(Failure::BadRegion, "The region has no area; clean the mesh first.");
  }
  const std::vector<double> surface = shares(patch, areas);

  std::vector<Vector2> disc = onCircle(patch, border);
  Harmonic map(patch, border, adjacency, context);
  std::vector<double> pull(patch.points.size(), 1.0), balanced = weights;
  for (int round = 0; round <= rounds; ++round)
  {
    context.checkpoint(static_cast<double>(round) / (rounds + 1));
    std::vector<Vector2> now = disc;
    map.solve(balanced, now, context);
    bool turned = false;
    for (int t = 0; t < patch.triangleCount(); ++t)
    {
      const Triangle& c = patch.triangles[t];
      areas[t] = signedArea(now[c[0]], now[c[1]], now[c[2]]);
      turned = turned || !(areas[t] > 0.0);
    }
    if (turned && round == 0)
    {
      throw Error(Failure::SolveFailed, "The region could not be flattened; clean the mesh first.");
    }
    if (turned)
    {
      break;
    }
    disc = now;
    const std::vector<double> drawn = shares(patch, areas);
    double uneven = 0.0; // mean square of log r
    for (std::size_t v = 0; v < pull.size(); ++v)
    {
      const double root = std::sqrt(surface[v] / drawn[v]), off = std::log(root);
      uneven += surface[v] > 0.0 ? surface[v] * off * off : 0.0;
      pull[v] /= std::clamp(root, 0.25, 4.0);
    }
    if (uneven < evenEnough * evenEnough)
    {
      break;
    }
    for (std::size_t e = 0; e < weights.size(); ++e)
    {
      balanced[e] = weights[e] * pull[adjacency.edges[e].v0] * pull[adjacency.edges[e].v1];
    }
  }

  Eigen::AlignedBox2d box;
  for (const Vector2& p : disc)
  {
    box.extend(p);
  }
  for (Vector2& p : disc)
  {
    for (int k = 0; k < 2; ++k)
    {
      p[k] = std::clamp(2.0 * (p[k] - box.min()[k]) / (box.max()[k] - box.min()[k]) - 1.0, -1.0, 1.0);
    }
  }
  return disc;
}

} // namespace oversketch
