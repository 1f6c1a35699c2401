#include "step_lines.h"

#include "systems.h"

#include "Mesh/context.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <limits>

namespace oversketch_session
{

namespace
{

using oversketch::Vector2;
using oversketch::Vector3;

constexpr vtkIdType mostSamples = 200; // of a stroke on the surface
constexpr int passes = 20;

// Where what a stroke took hold of is seen in its view, and how deep.
struct SeenHold
{
  std::vector<Vector2> places;
  std::vector<double> depths;

  SeenHold(const oversketch::View& view, vtkPolyData* hold)
  {
    for (vtkIdType i = 0; i < hold->GetNumberOfPoints(); ++i)
    {
      const Vector3 place(hold->GetPoint(i));
      if (view.inFront(place))
      {
        const Vector3 seen = view.toDisplay(place);
        this->places.emplace_back(seen.head<2>());
        this->depths.push_back(seen[2]);
      }
    }
  }
  double depthBeside(const Vector2& place) const
  {
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < this->places.size(); ++i)
    {
      const double distance = (this->places[i] - place).squaredNorm();
      nearest = distance < least ? i : nearest;
      least = std::min(least, distance);
    }
    return this->depths[nearest];
  }
};

// The nearest of few places changes by jumps.
void smooth(std::vector<double>& depths)
{
  for (int pass = 0; pass < passes; ++pass)
  {
    const std::vector<double> before = depths;
    for (std::size_t i = 1; i + 1 < depths.size(); ++i)
    {
      depths[i] = 0.25 * before[i - 1] + 0.5 * before[i] + 0.25 * before[i + 1];
    }
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> strokeOf(const Model& model, const Step& step)
{
  const SystemRow* row = findSystem(step.system);
  const SystemInput* input = row ? findInput(*row, SystemInput::Kind::Stroke) : nullptr;
  const auto given = input ? step.inputs.find(input->name) : step.inputs.end();
  const auto* of = given == step.inputs.end() ? nullptr : std::get_if<StepOutput>(&given->second);
  for (const Node& node : model.nodes)
  {
    if (!of || node.step.get() == &step) // it takes of those before it
    {
      break;
    }
    if (node.id == of->step)
    {
      return strokeOf(model, *node.step);
    }
  }
  return input ? linesOf(step, input->name) : nullptr;
}

vtkSmartPointer<vtkPolyData> strokeOn(vtkStaticCellLocator* surface,
  vtkPolyData* stroke,
  vtkPolyData* hold,
  double reach)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  std::vector<vtkIdType> piece;
  const auto endPiece = [&]
  {
    if (piece.size() > 1)
    {
      lines->InsertNextCell(static_cast<vtkIdType>(piece.size()), piece.data());
    }
    piece.clear();
  };
  try
  {
    const oversketch::View view = oversketch::ViewOf(stroke);
    const SeenHold seen(view, hold);
    if (seen.places.empty())
    {
      return nullptr;
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType line = 0; line < stroke->GetNumberOfLines(); ++line, endPiece())
    {
      stroke->GetLines()->GetCellAtId(line, ids);
      const vtkIdType count = ids->GetNumberOfIds(), steps = std::min(count, mostSamples) - 1;
      std::vector<Vector2> samples;
      std::vector<double> depths;
      for (vtkIdType i = 0; i <= steps; ++i)
      {
        const double* sample = stroke->GetPoint(ids->GetId(steps > 0 ? i * (count - 1) / steps : 0));
        samples.emplace_back(sample[0], sample[1]);
        depths.push_back(seen.depthBeside(samples.back()));
      }
      smooth(depths);
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        Vector3 beside = view.toWorld(samples[i], depths[i]);
        double nearest[3], distance = 0.0;
        vtkIdType cell = 0;
        int part = 0;
        if (surface->FindClosestPointWithinRadius(beside.data(), reach, nearest, cell, part, distance) == 0)
        {
          endPiece();
          continue;
        }
        piece.push_back(points->InsertNextPoint(nearest));
      }
    }
  }
  catch (const oversketch::Error&)
  {
    return nullptr; // no stroke with one view
  }
  if (lines->GetNumberOfCells() == 0)
  {
    return nullptr;
  }
  auto made = vtkSmartPointer<vtkPolyData>::New();
  made->SetPoints(points);
  made->SetLines(lines);
  return made;
}

} // namespace oversketch_session
