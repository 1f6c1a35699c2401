#include "Inflate/sheet.h"

#include "Mesh/context.h"

#include <algorithm>
#include <tuple>

namespace oversketch
{
namespace
{

[[noreturn]] void refuse(const Message& message)
{
  throw Error(Failure::BadMesh, message);
}

} // namespace

std::vector<BorderEdge> borderOf(const std::vector<Corners>& faces, int pointCount)
{
  std::vector<BorderEdge> edges;
  edges.reserve(4 * faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const int count = faces[f][3] < 0 ? 3 : 4;
    for (int k = 0; k < count; ++k)
    {
      const int from = faces[f][k], to = faces[f][(k + 1) % count];
      if (from < 0 || from >= pointCount || from == to)
      {
        refuse({ "Face %1 has a corner that is no point or is there twice.", f });
      }
      edges.push_back({ from, to, static_cast<int>(f) });
    }
  }
  const auto key = [](const BorderEdge& e)
  { return std::make_tuple(std::min(e.from, e.to), std::max(e.from, e.to), e.face); };
  std::sort(
    edges.begin(), edges.end(), [&](const BorderEdge& a, const BorderEdge& b) { return key(a) < key(b); });
  std::vector<BorderEdge> border;
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next)
  {
    const BorderEdge& edge = edges[i];
    for (next = i + 1; next < edges.size() &&
                       std::min(edges[next].from, edges[next].to) == std::min(edge.from, edge.to) &&
                       std::max(edges[next].from, edges[next].to) == std::max(edge.from, edge.to);)
    {
      ++next;
    }
    if (next == i + 1)
    {
      border.push_back(edge);
    }
    else if (next > i + 2 || edges[i + 1].from == edge.from)
    {
      refuse({ "The edge between points %1 and %2 has more than two faces, or two that are turned "
               "differently; the mesh must be a sheet.",
        edge.from,
        edge.to });
    }
  }
  std::sort(
    border.begin(), border.end(), [](const BorderEdge& a, const BorderEdge& b) { return a.from < b.from; });
  for (std::size_t i = 1; i < border.size(); ++i)
  {
    if (border[i].from == border[i - 1].from)
    {
      refuse({ "Two borders meet at point %1; draw the strokes apart.", border[i].from });
    }
  }
  return border;
}

int edgesBetweenBasePoints(const std::vector<BorderEdge>& border, const std::vector<char>& isBase)
{
  std::vector<int> next(isBase.size(), -1);
  for (const BorderEdge& edge : border)
  {
    next[edge.from] = edge.to;
  }
  std::vector<char> seen(isBase.size(), 0);
  int common = 0;
  for (const BorderEdge& edge : border)
  {
    if (!isBase[edge.from])
    {
      continue;
    }
    int count = 0, at = edge.from;
    do
    {
      seen[at] = 1;
      at = next[at];
      ++count;
    } while (at >= 0 && !isBase[at]);
    common = common == 0 ? count : common;
    if (count != common || at < 0)
    {
      refuse({ "From point %1 it is %2 edges to the next point of the coarse mesh, elsewhere %3; "
               "IsBaseVertex must mark the corners of the mesh that was refined.",
        edge.from,
        count,
        common });
    }
  }
  for (const BorderEdge& edge : border)
  {
    if (!seen[edge.from])
    {
      refuse({ "The border at point %1 has no point of the coarse mesh; IsBaseVertex must mark the corners "
               "of the mesh that was refined.",
        edge.from });
    }
  }
  return common;
}

} // namespace oversketch
