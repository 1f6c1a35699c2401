#include "Silhouette/sign_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  for (int v = 0; v < count; ++v)
  {
    firstEdge[v + 1] += firstEdge[v];
  }

  struct Owner
  {
    int vertex, firstEdge, edgeCount;
  };
  std::vector<Owner> owners;
  std::vector<int> locals;
  std::vector<int> clumpOf(count, -1); // the last one that the vertex was put into
  std::vector<std::array<float, 8>> bounds;
  const auto close = [&]
  {
    this->clumps.push_back({ static_cast<int>(this->vertices.size()), static_cast<int>(this->fans.size()) });
    std::sort(locals.begin(), locals.end());
    const int size = static_cast<int>(locals.size());
    std::array<float, 8> bound;
    const std::size_t rows = this->values.size();
    this->values.resize(rows + 4 * locals.size());
    for (int i = 0; i < size; ++i)
    {
      const Vector3& n = this->normals[locals[i]];
      const double offset = -n.dot(this->mesh.points[locals[i]] - this->centre);
      this->reach = std::max(this->reach, std::abs(offset));
      const double row[4] = { n[0], n[1], n[2], offset };
      for (int k = 0; k < 4; ++k)
      {
        this->values[rows + k * size + i] = static_cast<float>(row[k]);
      }
    }
    for (int k = 0; k < 4; ++k)
    {
      const auto [low, high] = std::minmax_element(
        this->values.begin() + rows + k * size, this->values.begin() + rows + (k + 1) * size);
      bound[k] = 0.5f * (*low + *high);
      bound[4 + k] = std::max(*high - bound[k], bound[k] - *low);
    }
    bounds.push_back(bound);
    for (const Owner& owner : owners)
    {
      const auto number = [&](int v)
      { return static_cast<int>(std::lower_bound(locals.begin(), locals.end(), v) - locals.begin()); };
      Fan fan{ 0, owner.firstEdge, number(owner.vertex) };
      for (int e = owner.firstEdge; e < owner.firstEdge + owner.edgeCount; ++e)
      {
        fan.others |= std::uint64_t(1) << number(this->adjacency.edges[e].v1);
      }
      if (fan.others != 0)
      {
        this->fans.push_back(fan);
      }
    }
    this->vertices.insert(this->vertices.end(), locals.begin(), locals.end());
    locals.clear();
    owners.clear();
  };
  const auto put = [&](int v)
  {
    const int clump = static_cast<int>(this->clumps.size());
    if (clumpOf[v] == clump)
    {
      return true;
    }
    if (static_cast<int>(locals.size()) == localLimit)
    {
      return false;
    }
    clumpOf[v] = clump;
    locals.push_back(v);
    return true;
  };
  for (const int v : clumpOrder(this->adjacency, count))
  {
    if (owners.size() == clumpVertices || !put(v))
    {
      close();
      put(v);
    }
    owners.push_back({ v, firstEdge[v], 0 });
    for (int e = firstEdge[v]; e < firstEdge[v + 1]; ++e)
    {
      if (!put(this->adjacency.edges[e].v1))
      {
        close();
        put(v);
        put(this->adjacency.edges[e].v1);
        owners.push_back({ v, e, 0 });
      }
      ++owners.back().edgeCount;
    }
  }
  if (!owners.empty())
  {
    close();
  }
  this->values.resize(this->values.size() + 3, 0.0f); // signsOf reads four at a time
  const std::size_t clumpCount = this->clumps.size();
  this->clumps.push_back({ static_cast<int>(this->vertices.size()), static_cast<int>(this->fans.size()) });
  this->boxes.resize(8 * clumpCount);
  for (std::size_t c = 0; c < clumpCount; ++c)
  {
    for (std::size_t k = 0; k < 8; ++k)
    {
      this->boxes[k * clumpCount + c] = bounds[c][k];
    }
  }
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
