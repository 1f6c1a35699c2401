#include "Join/join.h"

#include "Intersection/crossing_faces.h"
#include "Join/bridge.h"

#include <algorithm>
#include <map>
#include <utility>

namespace oversketch
{

namespace
{

// The parts, each with points of its own.
std::vector<Body> bodiesOf(const JoinInput& input)
{
  std::vector<int> numbers = input.parts;
  sortUnique(numbers);
  std::vector<Body> bodies(numbers.size());
  std::vector<int> point(input.mesh.points.size(), -1);
  for (std::size_t part = 0; part < numbers.size(); ++part)
  {
    std::fill(point.begin(), point.end(), -1);
    Body& body = bodies[part];
    body.reserve(static_cast<std::size_t>(std::count(input.parts.begin(), input.parts.end(), numbers[part])));
    for (int t = 0; t < input.mesh.triangleCount(); ++t)
    {
      if (input.parts[t] == numbers[part])
      {
        Triangle ids = input.mesh.triangles[t];
        for (int& v : ids)
        {
          if (point[v] < 0)
          {
            point[v] = body.mesh.vertexCount();
            body.mesh.points.push_back(input.mesh.points[v]);
          }
          v = point[v];
        }
        body.add(ids, t, numbers[part]);
      }
    }
  }
  return bodies;
}

// Below 0 where faces look inward.
double enclosedVolume(const Mesh& mesh)
{
  const Vector3 origin = boxRound(mesh.points).center();
  double six = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    const Vector3 a = mesh.points[t[0]] - origin, b = mesh.points[t[1]] - origin;
    six += a.dot(b.cross(mesh.points[t[2]] - origin));
  }
  return six / 6.0;
}

[[noreturn]] void refuseTorn(const Mesh& mesh, const FacePair& pair, std::size_t count)
{
  const Vector3& p = mesh.points[mesh.triangles[pair[0]][0]];
  throw Error(Failure::Torn,
    "%1 pairs of faces go through each other where the parts meet, near {(%2, %3, %4)}; move a part a "
    "little, "
    "or give the seam another width.",
    count,
    p[0],
    p[1],
    p[2]);
}

United unitedSoundly(const Body& a, const Body& b, JoinKind kind, double diagonal, const Context& context)
{
  std::vector<FacePair> torn;
  United united;
  for (const double share : { 1e-6, 1e-8, 1e-5, 1e-10 })
  {
    united = unite(a, b, kind, share * diagonal, context);
    torn = crossingFaces(united.body.mesh, united.changed, context);
    if (torn.empty())
    {
      return united;
    }
  }
  refuseTorn(united.body.mesh, torn.front(), torn.size());
}

} // namespace

Joined join(const JoinInput& input, const JoinOptions& options, const Context& context)
{
  std::vector<Body> bodies = bodiesOf(input);
  if (bodies.size() < 2)
  {
    throw Error(Failure::BadMesh, "There is one part only; add another one, or give a second mesh.");
  }
  if (options.bridge && options.width <= 0.0)
  {
    throw Error(Failure::BadRegion, "A bridge is as thick as the seam is wide; give {Width} above 0.");
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    if (!(enclosedVolume(bodies[i].mesh) > 0.0))
    {
      throw Error(Failure::BadMesh,
        "Part %1 is inside out: it encloses no volume; turn its faces round (vtkReverseSense).",
        static_cast<int>(i) + 1);
    }
  }
  const double diagonal = boundingDiagonal(input.mesh);
  United united;
  united.body = std::move(bodies.front());
  std::vector<std::size_t> waiting;
  for (std::size_t i = 1; i < bodies.size(); ++i)
  {
    waiting.push_back(i);
  }
  while (!waiting.empty())
  {
    // In their order, but parts that meet only others wait for those.
    std::size_t next = 0;
    United made;
    for (; next < waiting.size(); ++next)
    {
      const Body& other = bodies[waiting[next]];
      made = unitedSoundly(united.body, other, options.kind, diagonal, context);
      const int both = united.body.mesh.triangleCount() + other.mesh.triangleCount();
      if (options.kind != JoinKind::Join || made.meet || made.body.mesh.triangleCount() < both)
      {
        break;
      }
    }
    if (next == waiting.size() && options.bridge)
    {
      next = 0;
      const Body& other = bodies[waiting.front()];
      made = unitedSoundly(
        united.body, barBetween(united.body, other, options.width, context), options.kind, diagonal, context);
      made = unitedSoundly(made.body, other, options.kind, diagonal, context);
    }
    if (next == waiting.size())
    {
      throw Error(Failure::BadMesh,
        "Part %1 meets none of the others; move it until it does, or ask for a bridge.",
        static_cast<int>(waiting.front()) + 1);
    }
    if (made.body.mesh.triangles.empty())
    {
      throw Error(Failure::BadMesh,
        options.kind == JoinKind::Cut
          ? "Nothing is left: the first part lies inside the others; change their order."
          : "The parts have nothing in common; move them until they overlap.");
    }
    united = std::move(made);
    waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(next));
  }
  if (options.width <= 0.0)
  {
    return asJoined(std::move(united));
  }
  Joined joined = roundSeam(input, united, options.width, context);
  const std::vector<FacePair> torn = crossingFaces(joined.mesh, {}, context);
  if (!torn.empty() && torn.size() > crossingFaces(united.body.mesh, {}, context).size())
  {
    refuseTorn(joined.mesh, torn.front(), torn.size());
  }
  return joined;
}

} // namespace oversketch
