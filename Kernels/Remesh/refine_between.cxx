#include "Remesh/refine_between.h"

#include "Remesh/insert_curves.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace oversketch
{

namespace
{

constexpr double longestAllowed = 4.0 / 3.0; // of what is wanted
constexpr double atLine = 0.7;               // of the length that is wanted halfway to the ring
constexpr double leastLength = 0.25;         // of the edge length that half of the ring asks for
constexpr double growth = 2.0;               // of edges beyond the ring, by the way from it
constexpr double fewAsk = 0.1;               // of the triangles along the curves: odd ones of a fine mesh
constexpr double meeting = 1.0; // of the least length that is asked for: a ring so near to the line meets it
constexpr int piecesOfGap = 8;  // along each of which the way to the line changes evenly
constexpr double detour = 1.4;  // of the way from line to ring, that a place between the two may be off it
constexpr double leastHeight = 0.03; // of a triangle over its longest edge, and of that, to be cut across

struct Segment
{
  Vector3 from, along;
  double squaredLength;
  double way[2]; // of a ring: how far its ends are from the line
  // The ends lie at these shares of a way from one triangle to another.
  int triangles[2];
  double shares[2];

  double nearest(const Vector3& p) const
  {
    return this->squaredLength > 0.0
             ? std::clamp((p - this->from).dot(this->along) / this->squaredLength, 0.0, 1.0)
             : 0.0;
  }
};

std::vector<Segment> segmentsOf(const std::vector<RunOnMesh>& runs)
{
  std::vector<Segment> segments;
  for (const RunOnMesh& run : runs)
  {
    for (std::size_t i = 0; i + 1 < std::max<std::size_t>(run.points.size(), 2) && !run.points.empty(); ++i)
    {
      const std::size_t next = std::min(i + 1, run.points.size() - 1);
      const Vector3 along = run.points[next] - run.points[i];
      segments.push_back({ run.points[i],
        along,
        along.squaredNorm(),
        { 0.0, 0.0 },
        { run.triangles[i], run.triangles[next] },
        { 0.0, 1.0 } });
    }
  }
  return segments;
}

// The nearest segment: distance, its number and the place on it.
std::tuple<double, std::size_t, double> nearestOf(const std::vector<Segment>& segments, const Vector3& p)
{
  double least = std::numeric_limits<double>::infinity(), at = 0.0;
  std::size_t number = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const double s = segments[i].nearest(p);
    const double squared = (p - segments[i].from - s * segments[i].along).squaredNorm();
    if (squared < least)
    {
      least = squared;
      number = i;
      at = s;
    }
  }
  return { std::sqrt(least), number, at };
}

// Triangles that the runs of a curve pass through, ascending.
std::vector<int> passed(const std::vector<RunOnMesh>& runs)
{
  std::vector<int> found;
  for (const RunOnMesh& run : runs)
  {
    found.insert(found.end(), run.triangles.begin(), run.triangles.end());
  }
  sortUnique(found);
  return found;
}

// The edge length that is wanted at each place.
class Scale
{
public:
  explicit Scale(const RefineInput& input)
    : Line(segmentsOf(input.line))
    , Ring(segmentsOf(input.ring))
    , Edges(input.edges)
    , Reach(input.longest)
  {
    if (this->Line.empty() || this->Ring.empty())
    {
      return;
    }
    std::vector<double> ways;
    for (Segment& segment : this->Ring)
    {
      for (int end = 0; end < 2; ++end)
      {
        segment.way[end] =
          std::get<0>(nearestOf(this->Line, segment.from + static_cast<double>(end) * segment.along));
        ways.push_back(segment.way[end]);
      }
    }
    std::nth_element(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2), ways.end());
    this->Least = leastLength * ways[ways.size() / 2] / this->Edges;
    this->addGaps(input.ring);
  }

  // Whether the ring touches or crosses the line, so that it asks for no length at all there.
  bool meets() const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Segment& segment : this->Ring)
    {
      for (int i = 0; i < 32; ++i)
      {
        nearest =
          std::min(nearest, std::get<0>(nearestOf(this->Line, segment.from + (i / 32.0) * segment.along)));
      }
    }
    return nearest < meeting * this->Least;
  }

  bool isKnown() const { return this->Least > 0.0 && std::isfinite(this->Least); }

  double at(const Vector3& p) const { return this->wantedAt(this->look(p)); }

  // The other side of a thin part, which is near in space, is beyond the ring over the surface alone.
  bool isBeyond(const Vector3& p, double overSurface) const
  {
    const Place place = this->look(p);
    return place.toLine > place.way || this->offBy(place, overSurface) > 0.0;
  }

  // Whether what is bisected there would be seen far from the ring. Over a way much longer than from line to
  // ring no place lies between the two.
  bool isFar(const Vector3& p, double overSurface) const
  {
    const Place place = this->look(p);
    const double off = this->offBy(place, overSurface);
    return (std::max(place.toLine, (place.toLine + place.toRing) / detour) > place.way &&
             place.toRing > this->Reach) ||
           (off > 0.0 && std::max(off, place.toRing) > this->Reach);
  }

  // Ways from the line to each vertex, over edges.
  const std::vector<double>& measure(const RefineInput& input)
  {
    std::vector<int> sources;
    for (const int t : passed(input.line))
    {
      sources.insert(sources.end(), input.mesh.triangles[t].begin(), input.mesh.triangles[t].end());
    }
    this->OverSurface = edgeDistances(input.mesh, buildAdjacency(input.mesh), sources);
    this->Triangles = &input.mesh.triangles;
    return this->OverSurface;
  }

  // Whether a triangle's longest edge is too long for some place of it.
  bool asks(const Vector3& a, const Vector3& b, const Vector3& c) const
  {
    const double longest =
      std::sqrt(std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() }));
    const auto isTooLong = [&](const Vector3& p) { return longest > longestAllowed * this->at(p); };
    const Place middle = this->look((a + b + c) / 3.0);
    // From there to a corner it is at most 2/3 of the longest edge, and both distances change by no more.
    const double least =
      std::min(this->wantedAt(middle), middle.way / this->Edges) - 4.0 / 3.0 * longest / this->Edges;
    return longest > longestAllowed * least &&
           (longest > longestAllowed * this->wantedAt(middle) || isTooLong(a) || isTooLong(b) ||
             isTooLong(c) || isTooLong(0.5 * (a + b)) || isTooLong(0.5 * (b + c)) ||
             isTooLong(0.5 * (c + a)));
  }

private:
  struct Place
  {
    double toLine, toRing, way; // the last: from the line to the place of the ring that is nearest
    const Segment* beside;      // where that place is, and the share of it
    double share;
  };
  Place look(const Vector3& p) const
  {
    const double toLine = std::get<0>(nearestOf(this->Line, p));
    const auto placeBy = [&](const std::vector<Segment>& segments) -> Place
    {
      const auto [away, number, share] = nearestOf(segments, p);
      const Segment& beside = segments[number];
      return { toLine, away, (1.0 - share) * beside.way[0] + share * beside.way[1], &beside, share };
    };
    const Place place = placeBy(this->Ring);
    if (this->Gaps.empty() || toLine > place.way)
    {
      return place;
    }
    const Place hidden = placeBy(this->Gaps);
    return toLine > hidden.way && hidden.toRing < place.toRing ? hidden : place;
  }
  double wantedAt(const Place& place) const
  {
    const double between =
      place.toRing + place.toLine + (1.0 - atLine) * std::min(0.0, place.toLine - place.toRing);
    const double wanted = place.toLine <= place.way
                            ? between / this->Edges
                            : place.way / this->Edges + growth * place.toRing; // beyond the ring
    return std::max(wanted, this->Least);
  }

  // How much farther than the place of the ring that is nearest a place is over the surface, where ways over
  // edges may be as much too long as an edge is.
  double offBy(const Place& place, double overSurface) const
  {
    const auto of = [&](int t)
    {
      const Triangle& c = (*this->Triangles)[t];
      return (this->OverSurface[c[0]] + this->OverSurface[c[1]] + this->OverSurface[c[2]]) / 3.0;
    };
    const Segment& s = *place.beside;
    const double share = (1.0 - place.share) * s.shares[0] + place.share * s.shares[1];
    return overSurface - (1.0 - share) * of(s.triangles[0]) - share * of(s.triangles[1]) - this->Reach;
  }

  // Straight on from run to run: what lies beyond where the ring is hidden is beyond it, too.
  void addGaps(const std::vector<RunOnMesh>& runs)
  {
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
      const RunOnMesh& next = runs[(i + 1) % runs.size()];
      if (runs[i].points.empty() || next.points.empty())
      {
        continue;
      }
      const Vector3& from = runs[i].points.back();
      const Vector3 step = (next.points.front() - from) / double(piecesOfGap);
      const auto wayAt = [&](int k) { return std::get<0>(nearestOf(this->Line, from + k * step)); };
      for (int k = 0; k < piecesOfGap && step.squaredNorm() > 0.0; ++k)
      {
        this->Gaps.push_back({ from + k * step,
          step,
          step.squaredNorm(),
          { wayAt(k), wayAt(k + 1) },
          { runs[i].triangles.back(), next.triangles.front() },
          { double(k) / piecesOfGap, double(k + 1) / piecesOfGap } });
      }
    }
  }

  std::vector<Segment> Line, Ring, Gaps;
  double Edges, Reach, Least = 0.0;
  std::vector<double> OverSurface;
  const std::vector<Triangle>* Triangles = nullptr;
};

class Bisection
{
public:
  // Ways from the line to each vertex, over edges.
  Bisection(CurveMesh& mesh, const Scale& scale, std::vector<double> ways)
    : Mesh(mesh)
    , Wanted(scale)
    , Ways(std::move(ways))
  {
  }

  void run(const std::vector<int>& first, const Context& context)
  {
    for (const int t : first)
    {
      this->lookAt(t);
    }
    for (std::size_t i = 0; i < this->Waiting.size(); ++i)
    {
      const int t = this->Waiting[i];
      this->IsWaiting[t] = 0;
      if (this->asks(t) && !this->isFar(this->longestOf(t)))
      {
        const int before = this->Splits;
        this->bisect(t);
        if (this->Splits > before)
        {
          this->lookAt(t);
        }
      }
      if (i % 256 == 0)
      {
        context.checkpoint(0.5);
      }
    }
  }

private:
  struct Edge
  {
    int a = -1, b = -1; // a < b
    double squared = -1.0;

    bool operator==(const Edge& other) const { return this->a == other.a && this->b == other.b; }
  };

  // Takes of equal ones the edge of the lowest vertices, so that both of its triangles choose alike.
  Edge longestOf(int t) const
  {
    const Triangle& c = this->Mesh.triangle(t);
    Edge longest;
    for (int k = 0; k < 3; ++k)
    {
      const auto [a, b] = std::minmax(c[k], c[(k + 1) % 3]);
      const double squared = (this->Mesh.point(b) - this->Mesh.point(a)).squaredNorm();
      if (a != b && (squared > longest.squared ||
                      (squared == longest.squared && std::tie(a, b) < std::tie(longest.a, longest.b))))
      {
        longest = { a, b, squared };
      }
    }
    return longest;
  }

  bool asks(int t) const
  {
    const Triangle& c = this->Mesh.triangle(t);
    return this->Wanted.asks(this->Mesh.point(c[0]), this->Mesh.point(c[1]), this->Mesh.point(c[2]));
  }

  void lookAt(int t)
  {
    if (this->IsWaiting.size() <= static_cast<std::size_t>(t))
    {
      this->IsWaiting.resize(this->Mesh.triangles().size(), 0);
    }
    if (!this->IsWaiting[t])
    {
      this->IsWaiting[t] = 1;
      this->Waiting.push_back(t);
    }
  }

  bool isFar(const Edge& edge) const
  {
    const auto isFar = [&](int v) { return this->Wanted.isFar(this->Mesh.point(v), this->Ways[v]); };
    return isFar(edge.a) && isFar(edge.b);
  }

  // Off the ring one that is fine enough is cut across where its neighbour needs it, not where it is longest:
  // what would follow from that would run on over the model.
  bool ends(int t) const
  {
    const Triangle& c = this->Mesh.triangle(t);
    return this->isFar(this->longestOf(t)) ||
           (!this->asks(t) &&
             this->Wanted.isBeyond(
               (this->Mesh.point(c[0]) + this->Mesh.point(c[1]) + this->Mesh.point(c[2])) / 3.0,
               (this->Ways[c[0]] + this->Ways[c[1]] + this->Ways[c[2]]) / 3.0));
  }

  // Cut across an edge that is not its longest, a triangle loses half of its height and keeps that one: if
  // nothing ended this, its parts would come to lie upon the edge, as long as before, and be cut for ever.
  bool isTooFlatAcross(int t, const Edge& edge) const
  {
    const Edge longest = this->longestOf(t);
    return !(longest == edge) && this->Mesh.cross(t).norm() < leastHeight * longest.squared;
  }

  // A triangle's longest edge is the longest of those beyond it too, or they come first; each of them has a
  // longer one than the one before, so that this ends.
  void bisect(int t)
  {
    std::vector<int> way{ t };
    while (!way.empty())
    {
      const int now = way.back();
      const Edge edge = this->longestOf(now);
      const std::vector<int> both = this->Mesh.trianglesAt(edge.a, edge.b);
      const auto before = std::find_if(both.begin(),
        both.end(),
        [&](int u) { return u != now && !(this->longestOf(u) == edge) && !this->ends(u); });
      if (before != both.end())
      {
        way.push_back(*before);
        continue;
      }
      if (std::any_of(both.begin(), both.end(), [&](int u) { return this->isTooFlatAcross(u, edge); }))
      {
        return;
      }
      this->split(edge);
      way.pop_back();
    }
  }

  void split(const Edge& edge)
  {
    const int middle = this->Mesh.splitEdge(edge.a, edge.b, 0.5);
    this->Ways.push_back(0.5 * (this->Ways[edge.a] + this->Ways[edge.b]));
    ++this->Splits;
    const std::vector<int> around = this->Mesh.around(middle);
    for (const int t : around)
    {
      const Triangle corners = this->Mesh.triangle(t);
      for (int k = 0; k < 3; ++k)
      {
        for (const int u : this->Mesh.trianglesAt(corners[k], corners[(k + 1) % 3]))
        {
          this->lookAt(u);
        }
      }
    }
  }

  CurveMesh& Mesh;
  const Scale& Wanted;
  std::vector<double> Ways;
  std::vector<int> Waiting;
  std::vector<char> IsWaiting; // per triangle
  int Splits = 0;
};

// Triangles along the curves that are too long, where they are more than odd ones of either curve.
std::vector<int> asked(const RefineInput& input, const Scale& scale)
{
  std::vector<int> asking;
  bool isFine = true;
  for (const std::vector<RunOnMesh>* runs : { &input.line, &input.ring })
  {
    const std::vector<int> along = passed(*runs);
    const std::size_t before = asking.size();
    for (const int t : along)
    {
      const Triangle& c = input.mesh.triangles[t];
      if (scale.asks(input.mesh.points[c[0]], input.mesh.points[c[1]], input.mesh.points[c[2]]))
      {
        asking.push_back(t);
      }
    }
    isFine = isFine && double(asking.size() - before) <= fewAsk * double(along.size());
  }
  return isFine ? std::vector<int>{} : asking;
}

std::vector<double> sizesOf(const RefineInput& input, const Mesh& mesh, const Scale& scale)
{
  Eigen::AlignedBox3d box; // beyond which nothing is wanted
  for (const std::vector<RunOnMesh>* runs : { &input.line, &input.ring })
  {
    for (const RunOnMesh& run : *runs)
    {
      for (const Vector3& p : run.points)
      {
        box.extend(p);
      }
    }
  }
  std::vector<double> sizes(mesh.points.size(), input.longest);
  for (std::size_t v = 0; v < sizes.size(); ++v)
  {
    if (box.exteriorDistance(mesh.points[v]) < input.longest)
    {
      sizes[v] = std::min(input.longest, scale.at(mesh.points[v]));
    }
  }
  return sizes;
}

} // namespace

std::optional<Refined> refineBetween(const RefineInput& input, const Context& context)
{
  Scale scale(input);
  if (!scale.isKnown())
  {
    return std::nullopt;
  }
  const std::vector<int> asking = asked(input, scale);
  context.checkpoint(0.1);
  if (asking.empty())
  {
    return std::nullopt;
  }
  if (scale.meets()) // a ring that is refused
  {
    return std::nullopt;
  }
  CurveMesh work(input.mesh);
  Bisection(work, scale, scale.measure(input)).run(asking, context);
  InsertedCurves made = resultOf(work, 0);
  Refined result;
  result.sizes = sizesOf(input, made.mesh, scale);
  result.mesh = std::move(made.mesh);
  result.pointSources = std::move(made.pointSources);
  result.origins = std::move(made.origins);
  result.triangleSources = std::move(made.triangleSources);
  return result;
}

} // namespace oversketch
