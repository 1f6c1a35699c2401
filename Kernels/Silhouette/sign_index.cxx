#include "Silhouette/sign_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace oversketch
{

namespace
{

constexpr int clumpVertices = 16;
constexpr int localLimit = 64; // local numbers are bits of a word

// All vertices, clump after clump of neighbours.
std::vector<int> clumpOrder(const Adjacency& adjacency, int count)
{
  std::vector<int> order;
  order.reserve(count);
  std::vector<char> seen(count, 0);
  for (int start = 0; start < count; ++start)
  {
    if (seen[start])
    {
      continue;
    }
    const std::size_t first = order.size();
    order.push_back(start);
    seen[start] = 1;
    for (std::size_t i = first; i < order.size() && order.size() < first + clumpVertices; ++i)
    {
      const int* end = adjacency.vertexVertices.end(order[i]);
      for (const int* n = adjacency.vertexVertices.begin(order[i]);
           n != end && order.size() < first + clumpVertices;
           ++n)
      {
        if (!seen[*n])
        {
          seen[*n] = 1;
          order.push_back(*n);
        }
      }
    }
  }
  return order;
}

// Of four rows of `size` numbers, the bits of the columns where row . d >= 0, and where it is beyond the
// error. What lies behind the last column is read and means nothing.
void signsOf(const float* rows,
  int size,
  const float* d,
  float error,
  std::uint64_t& plus,
  std::uint64_t& sure)
{
  const float *x = rows, *y = x + size, *z = y + size, *w = z + size;
#ifdef __SSE__
  const __m128 dx = _mm_set1_ps(d[0]), dy = _mm_set1_ps(d[1]), dz = _mm_set1_ps(d[2]), dw = _mm_set1_ps(d[3]);
  const __m128 zero = _mm_setzero_ps(), above = _mm_set1_ps(error), below = _mm_set1_ps(-error);
  for (int i = 0; i < size; i += 4)
  {
    const __m128 g =
      _mm_add_ps(_mm_add_ps(_mm_mul_ps(_mm_loadu_ps(x + i), dx), _mm_mul_ps(_mm_loadu_ps(y + i), dy)),
        _mm_add_ps(_mm_mul_ps(_mm_loadu_ps(z + i), dz), _mm_mul_ps(_mm_loadu_ps(w + i), dw)));
    plus |= std::uint64_t(_mm_movemask_ps(_mm_cmpge_ps(g, zero))) << i;
    sure |= std::uint64_t(_mm_movemask_ps(_mm_or_ps(_mm_cmpgt_ps(g, above), _mm_cmplt_ps(g, below)))) << i;
  }
#else
  for (int i = 0; i < size; ++i)
  {
    const float g = (x[i] * d[0] + y[i] * d[1]) + (z[i] * d[2] + w[i] * d[3]);
    plus |= std::uint64_t(g >= 0.0f) << i;
    sure |= std::uint64_t(std::abs(g) > error) << i;
  }
#endif
}

} // namespace

SignChanges findSignChanges(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const View& view)
{
  SignChanges changes;
  const int vertexCount = mesh.vertexCount(), edgeCount = static_cast<int>(adjacency.edges.size());
  std::vector<char> plus(vertexCount);
  for (int v = 0; v < vertexCount; ++v)
  {
    const double g = silhouetteValue(mesh, normals, view, v);
    changes.most = std::max(changes.most, std::abs(g));
    plus[v] = g >= 0.0;
  }
  changes.least = changes.most;
  changes.edges.resize((edgeCount + 63) / 64);
  for (int first = 0; first < edgeCount; first += 64)
  {
    std::uint64_t word = 0;
    for (int e = first; e < std::min(first + 64, edgeCount); ++e)
    {
      word |= std::uint64_t(plus[adjacency.edges[e].v0] != plus[adjacency.edges[e].v1]) << (e - first);
    }
    changes.edges[first / 64] = word;
  }
  return changes;
}

// Puts vertices and their edges to higher ones into clumps, each closed before it is too large.
class SignIndex::ClumpMaker
{
public:
  explicit ClumpMaker(SignIndex& index)
    : index_(index)
    , clumpOf_(index.mesh.points.size(), -1)
  {
  }

  // With its edges [firstEdge, end).
  void add(int vertex, int firstEdge, int end)
  {
    if (this->owners_.size() == clumpVertices || !this->put(vertex))
    {
      this->close();
      this->put(vertex);
    }
    this->owners_.push_back({ vertex, firstEdge, 0 });
    for (int e = firstEdge; e < end; ++e)
    {
      const int other = this->index_.adjacency.edges[e].v1;
      if (!this->put(other))
      {
        this->close();
        this->put(vertex);
        this->put(other);
        this->owners_.push_back({ vertex, e, 0 });
      }
      ++this->owners_.back().edgeCount;
    }
  }

  // Closes the last clump and lays the boxes out in rows.
  void finish()
  {
    if (!this->owners_.empty())
    {
      this->close();
    }
    SignIndex& index = this->index_;
    index.values.resize(index.values.size() + 3, 0.0f); // signsOf reads four at a time
    const std::size_t count = index.clumps.size();
    this->openClump();
    index.boxes.resize(8 * count);
    for (std::size_t c = 0; c < count; ++c)
    {
      for (std::size_t k = 0; k < 8; ++k)
      {
        index.boxes[k * count + c] = this->bounds_[c][k];
      }
    }
  }

private:
  struct Owner
  {
    int vertex, firstEdge, edgeCount;
  };

  void openClump()
  {
    this->index_.clumps.push_back(
      { static_cast<int>(this->index_.vertices.size()), static_cast<int>(this->index_.fans.size()) });
  }

  // False where the clump has no room for it.
  bool put(int vertex)
  {
    const int clump = static_cast<int>(this->index_.clumps.size());
    if (this->clumpOf_[vertex] == clump)
    {
      return true;
    }
    if (static_cast<int>(this->locals_.size()) == localLimit)
    {
      return false;
    }
    this->clumpOf_[vertex] = clump;
    this->locals_.push_back(vertex);
    return true;
  }

  void close()
  {
    this->openClump();
    std::sort(this->locals_.begin(), this->locals_.end());
    this->writeValues();
    for (const Owner& owner : this->owners_)
    {
      Fan fan{ 0, owner.firstEdge, this->number(owner.vertex) };
      for (int e = owner.firstEdge; e < owner.firstEdge + owner.edgeCount; ++e)
      {
        fan.others |= std::uint64_t(1) << this->number(this->index_.adjacency.edges[e].v1);
      }
      if (fan.others != 0)
      {
        this->index_.fans.push_back(fan);
      }
    }
    this->index_.vertices.insert(this->index_.vertices.end(), this->locals_.begin(), this->locals_.end());
    this->locals_.clear();
    this->owners_.clear();
  }

  int number(int vertex) const
  {
    return static_cast<int>(
      std::lower_bound(this->locals_.begin(), this->locals_.end(), vertex) - this->locals_.begin());
  }

  // The clump's four rows, and their box.
  void writeValues()
  {
    SignIndex& index = this->index_;
    const int size = static_cast<int>(this->locals_.size());
    const std::size_t rows = index.values.size();
    index.values.resize(rows + 4 * this->locals_.size());
    for (int i = 0; i < size; ++i)
    {
      const int vertex = this->locals_[i];
      const Vector3& n = index.normals[vertex];
      const double offset = -n.dot(index.mesh.points[vertex] - index.centre);
      index.reach = std::max(index.reach, std::abs(offset));
      const double row[4] = { n[0], n[1], n[2], offset };
      for (int k = 0; k < 4; ++k)
      {
        index.values[rows + k * size + i] = static_cast<float>(row[k]);
      }
    }
    std::array<float, 8> bound;
    for (int k = 0; k < 4; ++k)
    {
      const auto [low, high] = std::minmax_element(
        index.values.begin() + rows + k * size, index.values.begin() + rows + (k + 1) * size);
      bound[k] = 0.5f * (*low + *high);
      bound[4 + k] = std::max(*high - bound[k], bound[k] - *low);
    }
    this->bounds_.push_back(bound);
  }

  SignIndex& index_;
  std::vector<Owner> owners_; // of edges in the open clump
  std::vector<int> locals_;   // its vertices
  std::vector<int> clumpOf_;  // per vertex the last clump that it was put into
  std::vector<std::array<float, 8>> bounds_;
};

SignIndex::SignIndex(const Mesh& surface,
  const Adjacency& neighbours,
  const std::vector<Vector3>& vertexNormals)
  : mesh(surface)
  , adjacency(neighbours)
  , normals(vertexNormals)
{
  const int count = this->mesh.vertexCount();
  Eigen::AlignedBox3d box;
  for (const Vector3& p : this->mesh.points)
  {
    box.extend(p);
    this->extent = std::max(this->extent, p.lpNorm<Eigen::Infinity>());
  }
  this->centre = count > 0 ? box.center() : Vector3(Vector3::Zero());

  std::vector<int> firstEdge(count + 1, 0);
  for (const MeshEdge& edge : this->adjacency.edges)
  {
    ++firstEdge[edge.v0 + 1];
  }
  std::partial_sum(firstEdge.begin(), firstEdge.end(), firstEdge.begin());
  ClumpMaker maker(*this);
  for (const int v : clumpOrder(this->adjacency, count))
  {
    maker.add(v, firstEdge[v], firstEdge[v + 1]);
  }
  maker.finish();
}

void SignIndex::fetch(int clump) const
{
  constexpr int line = 64; // bytes
  const Clump &from = this->clumps[clump], &to = this->clumps[clump + 1];
  const char* value = reinterpret_cast<const char*>(this->values.data() + 4 * std::size_t(from.firstVertex));
  for (int i = 0; i < (to.firstVertex - from.firstVertex) * 16; i += line)
  {
    __builtin_prefetch(value + i);
  }
  const char* fan = reinterpret_cast<const char*>(this->fans.data() + from.firstFan);
  for (int i = 0; i < (to.firstFan - from.firstFan) * static_cast<int>(sizeof(Fan)); i += line)
  {
    __builtin_prefetch(fan + i);
  }
}

void SignIndex::find(const View& view, SignChanges& changes) const
{
  changes.edges.resize((this->adjacency.edges.size() + 63) / 64);
  // g = (n, -n . (p - centre)) . (d, 1) with d from the centre in perspective; of an orthographic view (d,
  // 0).
  const Vector3 towards = view.perspective() ? Vector3(view.eye() - this->centre) : view.normal();
  const float d[4] = { static_cast<float>(towards[0]),
    static_cast<float>(towards[1]),
    static_cast<float>(towards[2]),
    view.perspective() ? 1.0f : 0.0f };
  // Some ten roundings to single precision, and those of the exact g. What single precision cannot hold is
  // left to the exact g everywhere.
  const double sizes = towards.lpNorm<1>() + d[3] * this->reach;
  const double exact = view.perspective() ? view.eye().lpNorm<1>() + this->extent : 0.0;
  const float error =
    sizes < 1e30 ? static_cast<float>(1e-6 * sizes + 1e-14 * exact) : std::numeric_limits<float>::infinity();

  const int count = static_cast<int>(this->clumps.size()) - 1;
  std::vector<float> middles(count), halves(count);
  const float* box = this->boxes.data();
  for (int c = 0; c < count; ++c)
  {
    middles[c] =
      std::abs(box[c] * d[0] + box[count + c] * d[1] + box[2 * count + c] * d[2] + box[3 * count + c] * d[3]);
    halves[c] = box[4 * count + c] * std::abs(d[0]) + box[5 * count + c] * std::abs(d[1]) +
                box[6 * count + c] * std::abs(d[2]) + box[7 * count + c] * d[3] + error;
  }
  float least = 0.0f, most = 0.0f;
  std::vector<int> open;
  for (int c = 0; c < count; ++c)
  {
    least = std::max(least, middles[c] - halves[c]);
    most = std::max(most, middles[c] + halves[c]);
    if (!(middles[c] > halves[c]))
    {
      open.push_back(c);
    }
  }
  changes.least = least;
  changes.most = std::isfinite(error) ? most : error;
  constexpr std::size_t ahead = 2;
  for (std::size_t o = 0; o < open.size(); ++o)
  {
    if (o + ahead < open.size())
    {
      this->fetch(open[o + ahead]);
    }
    const int c = open[o];
    const Clump& clump = this->clumps[c];
    const int size = this->clumps[c + 1].firstVertex - clump.firstVertex;
    std::uint64_t plus = 0, sure = 0;
    signsOf(
      this->values.data() + 4 * static_cast<std::size_t>(clump.firstVertex), size, d, error, plus, sure);
    const std::uint64_t all = ~std::uint64_t(0) >> (localLimit - size);
    plus &= all;
    sure &= all;
    for (int i = 0; sure != all && i < size; ++i)
    {
      const std::uint64_t bit = std::uint64_t(1) << i;
      if (!(sure & bit))
      {
        const int v = this->vertices[clump.firstVertex + i];
        const bool positive = silhouetteValue(this->mesh, this->normals, view, v) >= 0.0;
        plus = positive ? plus | bit : plus & ~bit;
      }
    }
    if (plus == 0 || plus == all)
    {
      continue;
    }
    for (int f = clump.firstFan; f < this->clumps[c + 1].firstFan; ++f)
    {
      const Fan& fan = this->fans[f];
      std::uint64_t crossed = fan.others & (plus >> fan.vertex & 1 ? ~plus : plus);
      for (; crossed != 0; crossed &= crossed - 1)
      {
        const std::uint64_t lower = (crossed & (~crossed + 1)) - 1;
        int edge = fan.firstEdge; // and one on for each lower vertex
        for (std::uint64_t rest = fan.others & lower; rest != 0; rest &= rest - 1)
        {
          ++edge;
        }
        changes.edges[edge >> 6] |= std::uint64_t(1) << (edge & 63);
      }
    }
  }
}

} // namespace oversketch
