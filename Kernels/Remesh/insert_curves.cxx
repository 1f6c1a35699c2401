#include "Remesh/insert_curves.h"

#include "Remesh/curve_walk.h"

#include <algorithm>
#include <optional>

namespace oversketch
{
namespace
{

constexpr double samePlace = 1e-6; // of the diagonal
constexpr int mostRepeats = 4;

[[noreturn]] void refuseCurve(const NewCurve& curve, const char* why)
{
  throw Error(Failure::BadStroke, Message::unusable("Curve", curve.number, why));
}

class Inserter
{
public:
  Inserter(const oversketch::Mesh& input, CurveMesh& mesh, const InsertRules& rules)
    : Input(input)
    , Mesh(mesh)
    , Rules(rules)
  {
  }

  void insert(const NewCurve& curve)
  {
    if (curve.closed && !((this->Rules.bridge || this->Rules.join) && this->Rules.embed) &&
        !(curve.runs.size() == 1 && curve.runs[0].closed))
    {
      refuseCurve(curve,
        "it has to be closed, but leaves the mesh or is hidden in parts. Draw it where all of it is seen, or "
        "turn Bridge and EmbedSegments on.");
    }
    const auto chains =
      mapped(curve.runs, [&](const CurveRun& run) { return this->chainOf(run, *curve.view); });
    MeshCurve path = this->Rules.embed ? this->embedded(curve, chains) : joinedChains(chains);
    path.closed = curve.closed;
    const std::vector<int> whole = path.vertices;
    if (this->Rules.embed)
    {
      cutLoops(path, this->Mesh);
    }
    if (path.count() < (curve.closed ? 3 : 2))
    {
      refuseCurve(
        curve, "on the mesh it comes to less than a segment. Draw a longer one, or look at it from nearer.");
    }
    normaliseParameters(path);
    this->Mesh.curves.push_back(std::move(path));
    this->Mesh.markCurves();
    this->Strays = std::any_of(whole.begin(), whole.end(), [&](int v) { return this->isStray(v); });
  }

  int bridges() const { return this->Bridges; }
  // Whether loops of the last curve, which are cut out, went through triangles that no curve touches.
  bool strays() const { return this->Strays; }
  // The last curve as one run.
  CurveRun asRun() const
  {
    const MeshCurve& path = this->Mesh.curves.back();
    CurveRun run;
    run.closed = path.closed;
    run.parameters = path.parameters;
    for (const int v : path.vertices)
    {
      const int t = this->Mesh.source(this->widestAt(v));
      SurfacePoint place{ t, { 0.0, 0.0, 0.0 } };
      for (const auto& [corner, weight] : this->Mesh.origin(v))
      {
        place.weights[cornerOf(this->Input.triangles[t], corner)] = weight;
      }
      run.places.push_back(place);
    }
    return run;
  }

private:
  // The triangle at a vertex that has most area: others may have none.
  int widestAt(int v) const
  {
    std::vector<int> around = this->Mesh.around(v);
    std::sort(around.begin(), around.end());
    return *std::max_element(around.begin(),
      around.end(),
      [&](int t, int u) { return this->Mesh.cross(t).squaredNorm() < this->Mesh.cross(u).squaredNorm(); });
  }

  // Whether a vertex was inserted for nothing, and no curve touches the triangles of the input that it is in.
  bool isStray(int v) const
  {
    if (!this->Mesh.inserted(v) || this->Mesh.onCurve(v))
    {
      return false;
    }
    for (const int t : this->Mesh.around(v))
    {
      for (const int piece : this->Mesh.piecesOf(this->Mesh.source(t)))
      {
        const Triangle& corners = this->Mesh.triangle(piece);
        if (std::any_of(corners.begin(), corners.end(), [&](int w) { return this->Mesh.onCurve(w); }))
        {
          return false;
        }
      }
    }
    return true;
  }

  // Vertices of a run and their parameters.
  struct Chain
  {
    std::vector<int> vertices;
    std::vector<double> parameters;
    bool closed = false;
  };

  Chain chainOf(const CurveRun& run, const View& view)
  {
    Chain chain;
    chain.closed = run.closed;
    for (std::size_t i = 0; i < run.places.size(); ++i)
    {
      const int before = chain.vertices.empty() ? -1 : chain.vertices.back();
      const int v = this->vertexAt(run.places[i], view, before);
      if (v == before)
      {
        continue;
      }
      chain.vertices.push_back(v);
      chain.parameters.push_back(run.parameters[i]);
      ++this->Mesh.marks[v];
    }
    while (chain.closed && chain.vertices.size() > 1 && chain.vertices.front() == chain.vertices.back())
    {
      chain.vertices.pop_back();
      chain.parameters.pop_back();
    }
    return chain;
  }

  // The vertex that a place of the input becomes. `before`, where the curve is, may be taken again.
  int vertexAt(const SurfacePoint& at, const View& view, int before)
  {
    const Vector3 place = positionOf(this->Input, at);
    std::array<double, 3> weights{};
    const int t = this->pieceAt(at.triangle, place, weights);
    const Triangle corners = this->Mesh.triangle(t);
    const double pixel = pixelSize(view, place);
    double edges[3], mean = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      edges[k] = (this->Mesh.point(corners[(k + 1) % 3]) - this->Mesh.point(corners[(k + 2) % 3])).norm();
      mean += edges[k] / 3.0;
    }
    const double same = samePlace * this->Mesh.diagonal();
    const double reach = this->Rules.snap ? std::max(same, 0.25 * std::min(mean, 10.0 * pixel)) : same;
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (const int v : corners)
    {
      const double distance = (this->Mesh.point(v) - place).norm();
      if (distance <= (this->Mesh.onCurve(v) && v != before ? same : reach) && distance < least)
      {
        least = distance;
        nearest = v;
      }
    }
    if (nearest >= 0)
    {
      return nearest;
    }
    const double twiceArea = this->Mesh.cross(t).norm();
    int edge = -1;
    least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k)
    {
      const double away = weights[k] * twiceArea / edges[k];
      const bool kept = this->Mesh.curveEdge(corners[(k + 1) % 3], corners[(k + 2) % 3]);
      const bool near = this->Rules.snap && !kept ? weights[k] < 0.15 && away <= 1.5 * pixel : false;
      if ((near || weights[k] < 1e-9) && away < least)
      {
        least = away;
        edge = k;
      }
    }
    if (edge < 0)
    {
      return this->Mesh.splitTriangle(t, weights);
    }
    const int a = corners[(edge + 1) % 3], b = corners[(edge + 2) % 3];
    const Vector3 along = this->Mesh.point(b) - this->Mesh.point(a);
    const double s = (place - this->Mesh.point(a)).dot(along) / along.squaredNorm();
    return this->Mesh.splitEdge(a, b, std::clamp(s, 1e-6, 1.0 - 1e-6));
  }

  // The part of an input triangle that a place of it lies in, and its weights there.
  int pieceAt(int inputTriangle, const Vector3& place, std::array<double, 3>& weights) const
  {
    int best = -1;
    double largest = -std::numeric_limits<double>::infinity();
    const Vector3 normal = facetNormal(this->Input, inputTriangle);
    for (const int t : this->Mesh.piecesOf(inputTriangle))
    {
      const Triangle& c = this->Mesh.triangle(t);
      std::array<double, 3> parts{};
      double sum = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const Vector3 &p = this->Mesh.point(c[(k + 1) % 3]), &q = this->Mesh.point(c[(k + 2) % 3]);
        parts[k] = (p - place).cross(q - place).dot(normal);
        sum += parts[k];
      }
      if (!(sum > 0.0))
      {
        continue;
      }
      const double inside = std::min({ parts[0], parts[1], parts[2] }) / sum;
      if (inside > largest)
      {
        largest = inside;
        best = t;
        // A place in the triangle, also where rounding puts it beside.
        double positive = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          weights[k] = std::max(parts[k], 0.0);
          positive += weights[k];
        }
        for (double& weight : weights)
        {
          weight /= positive;
        }
      }
    }
    if (best < 0)
    {
      throw Error(
        Failure::BadMesh, "Triangle %1 has no area, and a curve lies in it; remove it.", inputTriangle);
    }
    return best;
  }

  static MeshCurve joinedChains(const std::vector<Chain>& chains)
  {
    MeshCurve path;
    for (const Chain& chain : chains)
    {
      path.vertices.insert(path.vertices.end(), chain.vertices.begin(), chain.vertices.end());
      path.parameters.insert(path.parameters.end(), chain.parameters.begin(), chain.parameters.end());
    }
    return path;
  }

  MeshCurve embedded(const NewCurve& curve, const std::vector<Chain>& chains)
  {
    // Grows as a curve of the mesh, so that it keeps its edges when it crosses itself.
    this->Mesh.curves.emplace_back();
    double turns = 0.0;
    for (std::size_t r = 0; r < chains.size(); ++r)
    {
      const Chain& chain = chains[r];
      for (std::size_t i = 0; i < chain.vertices.size(); ++i)
      {
        const MeshCurve& path = this->Mesh.curves.back();
        double t = chain.parameters[i] + turns;
        if (path.count() > 0 && t < path.parameters.back())
        {
          turns += 1.0;
          t += 1.0;
        }
        this->extend(curve, chain.vertices[i], t, i == 0 && r > 0);
      }
    }
    if (curve.closed && this->Mesh.curves.back().count() > 0)
    {
      const MeshCurve& path = this->Mesh.curves.back();
      const int first = path.vertices.front();
      const double t = path.parameters.front() + 1.0;
      this->extend(curve, first, t, !(chains.size() == 1 && chains[0].closed));
    }
    MeshCurve path = std::move(this->Mesh.curves.back());
    this->Mesh.curves.pop_back();
    if (curve.closed && path.count() > 1 && path.vertices.front() == path.vertices.back())
    {
      path.vertices.pop_back();
      path.parameters.pop_back();
    }
    return path;
  }

  // Goes on to a vertex.
  void extend(const NewCurve& curve, int to, double t, bool gap)
  {
    if (this->Mesh.curves.back().count() > 0)
    {
      const int from = this->Mesh.curves.back().vertices.back();
      const double begin = this->Mesh.curves.back().parameters.back();
      if (from == to)
      {
        return;
      }
      gap = gap && this->Rules.bridge;
      std::optional<Way> way =
        gap ? this->bridgeWay(from, to, *curve.view) : this->segmentWay(from, to, *curve.view);
      if (!way)
      {
        refuseCurve(curve,
          gap
            ? "no way over the mesh closes it where it is hidden or beside the mesh. Draw it where all of it "
              "is seen, or the ends of the gap nearer to each other."
            : "the mesh has a hole or a fold under it. Draw it beside that.");
      }
      this->Bridges += gap;
      this->append(*way, from, to, begin, t);
    }
    MeshCurve& path = this->Mesh.curves.back();
    path.vertices.push_back(to);
    path.parameters.push_back(t);
    ++this->Mesh.marks[to];
  }

  // Parameters in between go by length.
  void append(const Way& way, int from, int to, double begin, double end)
  {
    const std::vector<int> vertices = makeWay(this->Mesh, way);
    std::vector<double> lengths;
    double length = 0.0;
    int before = from;
    for (const int v : vertices)
    {
      length += (this->Mesh.point(v) - this->Mesh.point(before)).norm();
      lengths.push_back(length);
      before = v;
    }
    length += (this->Mesh.point(to) - this->Mesh.point(before)).norm();
    MeshCurve& path = this->Mesh.curves.back();
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      path.vertices.push_back(vertices[i]);
      path.parameters.push_back(begin + (end - begin) * (length > 0.0 ? lengths[i] / length : 1.0));
      ++this->Mesh.marks[vertices[i]];
    }
  }

  std::optional<Way> segmentWay(int from, int to, const View& view) const
  {
    const double straight = (this->Mesh.point(to) - this->Mesh.point(from)).norm();
    WalkRules rules;
    rules.snapLength = 0.5 * straight;
    rules.longest = 4.0 * straight + 2.0 * this->edgeAt(from);
    rules.avoidCurves = true;
    rules.direction = [&](const Vector3& at) { return view.towardsViewer(at); };
    for (const double longest : { 2.0 * straight, rules.longest })
    {
      std::optional<Way> way = walkPlane(this->Mesh, from, to, rules);
      way = way ? way : this->normalWay(from, to, rules);
      way = way ? way : walkEdges(this->Mesh, from, to, longest);
      if (way)
      {
        return way;
      }
      rules.avoidCurves = false; // it crosses itself or another one
    }
    return std::nullopt;
  }

  std::optional<Way> bridgeWay(int from, int to, const View& view) const
  {
    const Vector3 &a = this->Mesh.point(from), &b = this->Mesh.point(to);
    WalkRules rules;
    rules.snapLength = 0.5 * (b - a).norm();
    rules.longest = 4.0 * (b - a).norm() + 0.3 * this->Mesh.diagonal();
    rules.avoidCurves = true;
    rules.fixedPlane = true;
    rules.direction = [&](const Vector3& at) { return view.towardsViewer(at); };
    const std::vector<int>& before = this->Mesh.curves.back().vertices;
    const Vector3 off = -view.towardsViewer(a); // which may lead back where that is no rim of what is seen
    const Vector3 on = before.size() > 1 ? Vector3(a - this->Mesh.point(before[before.size() - 2])) : off;
    if (this->Rules.gap == InsertRules::Gap::Across && this->Mesh.curves.size() > 1)
    {
      const std::vector<int>& along = this->Mesh.curves.front().vertices;
      const Vector3 axis = this->Mesh.point(along.back()) - this->Mesh.point(along.front());
      rules.direction = [across = Vector3(axis.cross(b - a))](const Vector3&) { return across; };
    }
    std::optional<Way> way = walkBorder(this->Mesh, from, to, rules.longest);
    const bool isFirst = this->Rules.gap == InsertRules::Gap::Viewer; // off
    for (const Vector3& start : { isFirst ? off : on, isFirst ? on : off })
    {
      rules.start = start;
      way = way ? way : walkPlane(this->Mesh, from, to, rules);
    }
    if (!way)
    {
      rules.start = b - a;
      way = this->normalWay(from, to, rules);
    }
    return way ? way : walkEdges(this->Mesh, from, to, rules.longest);
  }

  // Along the plane of two vertices and the mean of their normals.
  std::optional<Way> normalWay(int from, int to, WalkRules rules) const
  {
    Vector3 normal = this->normalAt(from) + this->normalAt(to);
    rules.direction = [&normal](const Vector3&) { return normal; };
    return walkPlane(this->Mesh, from, to, rules);
  }

  Vector3 normalAt(int v) const
  {
    Vector3 sum = Vector3::Zero();
    std::vector<int> around = this->Mesh.around(v);
    std::sort(around.begin(), around.end());
    for (const int t : around)
    {
      sum += this->Mesh.cross(t);
    }
    return sum.stableNormalized();
  }

  double edgeAt(int v) const
  {
    double longest = 0.0;
    for (const int w : this->Mesh.neighbours(v))
    {
      longest = std::max(longest, (this->Mesh.point(w) - this->Mesh.point(v)).norm());
    }
    return longest;
  }

public:
  // 0 to 1 of an open curve, from 0 on of a closed one.
  static void normaliseParameters(MeshCurve& path)
  {
    const double first = path.parameters.front(), last = path.parameters.back();
    const double whole = path.closed ? 1.0 : last - first;
    for (double& t : path.parameters)
    {
      t = (t - first) / whole;
    }
    if (!path.closed)
    {
      path.parameters.back() = 1.0;
    }
  }

private:
  const oversketch::Mesh& Input;
  CurveMesh& Mesh;
  const InsertRules Rules;
  int Bridges = 0;
  bool Strays = false;
};

// Stored curves must be chains of edges.
void refuseLoose(const CurveMesh& mesh, const std::vector<MeshCurve>& stored)
{
  for (std::size_t c = 0; c < stored.size(); ++c)
  {
    const MeshCurve& curve = stored[c];
    for (int i = 0; i < curve.segments(); ++i)
    {
      const int a = curve.vertices[i], b = curve.vertices[curve.next(i)];
      if (!mesh.joined(a, b))
      {
        throw Error(Failure::BadStroke,
          "Stored curve %1 cannot be used: no edge joins its vertices %2 and %3. Insert it into "
          "this mesh anew.",
          c,
          a,
          b);
      }
    }
  }
}

CurveMesh beginning(const Mesh& mesh, const std::vector<MeshCurve>& stored)
{
  CurveMesh work(mesh);
  refuseLoose(work, stored);
  work.curves = stored;
  work.markCurves();
  return work;
}

} // namespace

InsertedCurves resultOf(const CurveMesh& mesh, std::size_t storedCount)
{
  InsertedCurves result;
  std::vector<char> used(mesh.points().size(), 0);
  const int triangles = static_cast<int>(mesh.triangles().size());
  for (int t = 0; t < triangles; ++t)
  {
    for (const int v : mesh.triangle(t))
    {
      if (v >= 0)
      {
        used[v] = 1;
      }
    }
  }
  std::vector<int> numbers(mesh.points().size(), -1);
  result.mesh.points.reserve(numbers.size());
  result.pointSources.reserve(numbers.size());
  result.origins.reserve(numbers.size());
  result.mesh.triangles.reserve(mesh.triangles().size());
  result.triangleSources.reserve(mesh.triangles().size());
  for (int v = 0; v < static_cast<int>(numbers.size()); ++v)
  {
    // Loose points of the input stay; they have no triangles that could have been taken from them.
    if (used[v] || mesh.loose(v))
    {
      numbers[v] = result.mesh.vertexCount();
      result.mesh.points.push_back(mesh.point(v));
      result.pointSources.push_back(mesh.inserted(v) ? -1 : v);
      result.origins.push_back(mesh.inserted(v) ? mesh.origin(v) : Mix());
    }
  }
  for (int t = 0; t < triangles; ++t)
  {
    if (mesh.alive(t))
    {
      const Triangle& corners = mesh.triangle(t);
      result.mesh.triangles.push_back({ numbers[corners[0]], numbers[corners[1]], numbers[corners[2]] });
      result.triangleSources.push_back(mesh.source(t));
    }
  }
  for (std::size_t i = 0; i < mesh.curves.size(); ++i)
  {
    MeshCurve curve = mesh.curves[i];
    for (int& v : curve.vertices)
    {
      v = numbers[v];
    }
    Inserter::normaliseParameters(curve);
    (i < storedCount ? result.stored : result.curves).push_back(std::move(curve));
  }
  return result;
}

InsertedCurves insertCurves(const Mesh& mesh,
  const std::vector<NewCurve>& curves,
  const std::vector<MeshCurve>& stored,
  const InsertRules& rules,
  const Context& context)
{
  CurveMesh work = beginning(mesh, stored);
  context.checkpoint(0.1);
  std::vector<NewCurve> drawn = curves;
  int bridges = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    auto inserter = std::make_optional<Inserter>(mesh, work, rules);
    inserter->insert(drawn[i]);
    bridges += inserter->bridges();
    // Again, as what is left of it: else triangles far from it would stay split.
    for (int k = 0; k < mostRepeats && inserter->strays(); ++k)
    {
      drawn[i].runs = { inserter->asRun() };
      work = beginning(mesh, stored);
      for (std::size_t j = 0; j <= i; ++j)
      {
        inserter.emplace(mesh, work, rules);
        inserter->insert(drawn[j]);
      }
    }
    context.checkpoint(0.1 + 0.6 * static_cast<double>(i + 1) / static_cast<double>(drawn.size()));
  }
  if (rules.clean)
  {
    work.left = rules.left;
    cleanAlongCurves(work, context);
  }
  InsertedCurves result = resultOf(work, stored.size());
  result.bridges = bridges;
  return result;
}

} // namespace oversketch
