#include "Mesh/graph.h"

#include "Mesh/context.h"

#include <algorithm>
#include <locale>
#include <sstream>

namespace oversketch
{

Graph Graph::parse(const std::string& text, const std::string& example)
{
  const auto refuse = [&](std::size_t point, const std::string& why)
  {
    throw Error(Failure::BadStroke,
      "Point %1 of the profile %2; write \"x y, x y, ...\" with x rising from 0 to 1, for instance \"%3\".",
      point,
      why,
      example);
  };
  Graph graph;
  std::istringstream points(text);
  for (std::string part; std::getline(points, part, ',');)
  {
    const std::size_t at = graph.Points.size();
    std::istringstream numbers(part);
    numbers.imbue(std::locale::classic());
    Vector2 point;
    if (!(numbers >> point.x() >> point.y()) || !(numbers >> std::ws).eof() || !point.allFinite())
    {
      refuse(at, "is not two numbers");
    }
    if (at == 0 ? point.x() != 0.0 : !(point.x() > graph.Points.back().x()))
    {
      refuse(at, at == 0 ? "is not at x = 0" : "has an x that is not above the one before");
    }
    graph.Points.push_back(point);
  }
  if (graph.Points.size() < 2 || graph.Points.back().x() != 1.0)
  {
    refuse(graph.Points.empty() ? 0 : graph.Points.size() - 1, "is the last one, and not at x = 1");
  }
  return graph;
}

double Graph::operator()(double x) const
{
  const auto next = std::upper_bound(this->Points.begin() + 1,
    this->Points.end() - 1,
    x,
    [](double value, const Vector2& point) { return value < point.x(); });
  const Vector2 &a = *(next - 1), &b = *next;
  return a.y() + (b.y() - a.y()) * ((x - a.x()) / (b.x() - a.x()));
}

} // namespace oversketch
