// A shipped drawing that goes through all four systems in one session: its outline is inflated, a limb
// pulled, the cross-section of its body drawn anew, a vein raised over it. Header-only.
#ifndef oversketch_testing_chain_drawn_chain_h
#define oversketch_testing_chain_drawn_chain_h

#include "Chain/chain_plans.h"
#include "Harness/shipped.h"

#include "Silhouette/outline.h"
#include "drawing_lines.h"
#include "evaluator.h"
#include "files.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSystem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace oversketch_test
{

inline std::string drawingPath(const DrawnChain& chain, const char* extension)
{
  return OVERSKETCH_DATA_FOLDER "/Drawings/" + std::string(chain.name) + extension;
}

inline vtkSmartPointer<vtkPolyData> linesOfFile(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

// A curve through places, a sample every two pixels or so, as a pen leaves them.
inline std::vector<Vector2> throughPlaces(const std::vector<Vector2>& places)
{
  std::vector<Vector2> samples;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
  {
    const Vector2 &b = places[i], &c = places[i + 1];
    const Vector2 &a = places[i > 0 ? i - 1 : i], &d = places[std::min(i + 2, places.size() - 1)];
    const int count = std::max(2, static_cast<int>((c - b).norm() / 2.0));
    for (int k = i > 0 ? 1 : 0; k <= count; ++k)
    {
      const double t = static_cast<double>(k) / count;
      samples.emplace_back(0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                                   t * t * t * (3.0 * b - a - 3.0 * c + d)));
    }
  }
  return samples;
}

// The points of a loop within the reach to both sides of the one that is nearest to a place, pushed, most of
// all that one.
inline std::vector<Vector2> pushed(const std::vector<Vector2>& loop,
  const Vector2& place,
  const Vector2& push,
  double reach)
{
  const auto nearest = std::min_element(loop.begin(),
    loop.end(),
    [&](const Vector2& a, const Vector2& b) { return (a - place).norm() < (b - place).norm(); });
  const auto count = static_cast<long>(loop.size()), at = static_cast<long>(nearest - loop.begin());
  const auto point = [&](long i)
  { return loop[static_cast<std::size_t>(((at + i) % count + count) % count)]; };
  const auto steps = [&](long way)
  {
    double length = 0.0;
    long i = 0;
    for (; std::abs(i) < count / 2 && length < reach; i += way)
    {
      length += (point(i + way) - point(i)).norm();
    }
    return std::abs(i);
  };
  const long before = steps(-1), after = steps(1);
  std::vector<Vector2> samples;
  for (long i = -before; i <= after; ++i)
  {
    const double share = 1.0 - static_cast<double>(std::abs(i)) / static_cast<double>(i < 0 ? before : after);
    const double weight = share * share * (3.0 - 2.0 * share);
    samples.emplace_back(point(i) + weight * push);
  }
  return samples;
}

// A stretch of the mesh's outline.
inline std::vector<Vector2> limbLine(vtkPolyData* mesh,
  const View& view,
  const DrawnChain& chain,
  double times = 1.0)
{
  const Mesh model = MeshOf(mesh);
  const std::vector<OutlineLoop> loops = traceOutline(model, view, outlineWindow(model, view, {}));
  const auto longest = std::max_element(loops.begin(),
    loops.end(),
    [](const OutlineLoop& a, const OutlineLoop& b) { return a.points.size() < b.points.size(); });
  const std::vector<Vector2> all = pushed(longest->points, chain.tip, times * chain.pull, chain.reach);
  std::vector<Vector2> samples;
  for (std::size_t i = 0; i < all.size(); i += 2)
  {
    samples.push_back(all[i]);
  }
  return samples;
}

inline std::vector<Vector2> editedLine(const DrawnChain& chain)
{
  const Vector2 aside(-chain.along[1], chain.along[0]);
  std::vector<Vector2> samples;
  for (int i = 0; i <= 50; ++i)
  {
    const double s = i / 50.0 - 0.5;
    samples.emplace_back(chain.middle + s * chain.along + 0.06 * std::sin(6.0 * s) * aside);
  }
  return samples;
}

inline std::vector<Vector2> editedRing(const DrawnChain& chain)
{
  const Vector2 x = chain.along.normalized(), y(-x[1], x[0]);
  std::vector<Vector2> samples;
  for (int i = 0; i < 120; ++i)
  {
    const double a = 2.0 * pi * i / 120.0;
    samples.emplace_back(chain.middle + chain.ring[0] * std::cos(a) * x + chain.ring[1] * std::sin(a) * y);
  }
  return samples;
}

// A cross-section in its plane: an arch from one end of the ring to the other, outward up.
inline vtkSmartPointer<vtkPolyData> profileLine(double rise)
{
  auto line = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  const int count = 41;
  cells->InsertNextCell(count);
  for (int i = 0; i < count; ++i)
  {
    const double t = i / (count - 1.0);
    cells->InsertCellPoint(points->InsertNextPoint(t, rise * std::sin(pi * t), 0.0));
  }
  line->SetPoints(points);
  line->SetLines(cells);
  return line;
}

// The drawing with another first stroke.
inline vtkSmartPointer<vtkPolyData> withOtherOutline(vtkPolyData* drawing, const DrawnChain& chain)
{
  auto strokes = oversketch_session::strokesOf(drawing);
  auto line = vtkSmartPointer<vtkPolyData>::New();
  line->DeepCopy(strokes.front().line);
  vtkPoints* points = line->GetPoints();
  const auto at = [&](vtkIdType i) { return Vector2(points->GetPoint(i)[0], points->GetPoint(i)[1]); };
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double share = std::max(0.0, 1.0 - (at(i) - chain.outline).norm() / chain.outlineReach);
    const Vector2 place = at(i) + share * share * (3.0 - 2.0 * share) * chain.push;
    points->SetPoint(i, place[0], place[1], 0.0);
  }
  strokes.front().line = line;
  return oversketch_session::drawingOf(strokes, drawing);
}

inline oversketch_session::Node chainNode(int id,
  const std::string& system,
  const oversketch_session::Values& values,
  const std::map<std::string, oversketch_session::Input>& inputs)
{
  auto step = std::make_shared<oversketch_session::Step>();
  step->system = system;
  step->values = values;
  step->inputs = inputs;
  oversketch_session::Node node;
  node.id = id;
  node.name = system;
  node.step = step;
  return node;
}

// The drawing alone, and what is drawn on its model.
inline oversketch_session::Session drawingSession(const DrawnChain& chain)
{
  const auto bytes =
    std::make_shared<const std::string>(oversketch_files::wholeFile(drawingPath(chain, ".png")));
  oversketch_session::Session session;
  session.backend = vtkOversketchSystem::Host;
  session.nodes = { chainNode(1,
    "InflateDrawing",
    {},
    { { "Strokes", oversketch_session::Lines(linesOfFile(drawingPath(chain, ".vtp"))) },
      { "Picture", oversketch_session::Image{ std::string(chain.name) + ".png", bytes } } }) };
  return session;
}

inline oversketch_session::Session chainSession(const DrawnChain& chain, vtkPolyData* inflated)
{
  using oversketch_session::Lines;
  oversketch_session::Session session = drawingSession(chain);
  const View view =
    oversketch::ViewOfStroke(oversketch_session::linesOf(*session.nodes[0].step, "Strokes"), 0);
  const auto drawn = [&](const std::vector<Vector2>& samples) { return Lines(toStroke(samples, view)); };
  session.nodes.push_back(
    chainNode(2, "OneStroke", {}, { { "Stroke", drawn(limbLine(inflated, view, chain)) } }));
  session.nodes.push_back(chainNode(3,
    "Edit",
    {},
    { { "Reference", drawn(editedLine(chain)) },
      { "Boundary", drawn(editedRing(chain)) },
      { "Profile", Lines(profileLine(chain.rise)) } }));
  session.nodes.push_back(chainNode(4,
    "Augment",
    { { "Radius", chain.radius }, { "Height", chain.height } },
    { { "Strokes", drawn(throughPlaces(chain.vein)) } }));
  return session;
}

// The same with something else about a node's step.
template <typename Change>
void change(oversketch_session::Node& node, const Change& how)
{
  auto step = std::make_shared<oversketch_session::Step>(*node.step);
  how(*step);
  node.step = step;
}

} // namespace oversketch_test
#endif
