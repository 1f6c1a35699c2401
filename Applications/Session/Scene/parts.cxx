#include "parts.h"

#include "pieces.h"
#include "systems.h"

#include "Inflate/placement.h"
#include "Mesh/context.h"
#include "vtkOversketchAssemble.h"
#include "vtkOversketchJoinedParts.h"
#include "vtkOversketchStepRunner.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace oversketch_session
{

namespace
{

constexpr double farthest = 1e9;   // that a part is moved
constexpr double narrowest = 1e-9; // of a box

// The parts of a mesh as they come with it. Those that are joined are hidden together, as the first of them.
PartSources byNumbers(vtkPolyData* mesh)
{
  PartSources parts;
  const std::set<int> joined = oversketch::JoinedParts(mesh);
  for (const int number : oversketch_files::partsOf(mesh))
  {
    parts[number] = { 0, joined.count(number) > 0 ? *joined.begin() : number };
  }
  return parts.empty() ? PartSources{ { 0, {} } } : parts;
}

// Those of the mesh that came to a step and those that the step has added, which are counted on.
PartSources withThoseOf(int step, PartSources parts, vtkPolyData* mesh)
{
  const int first = parts.empty() ? 0 : parts.rbegin()->first + 1;
  const PartSources all = byNumbers(mesh);
  const auto added = all.lower_bound(first);
  if (added == all.end())
  {
    const auto isSame = [](const auto& a, const auto& b) { return a.first == b.first; };
    const bool isNothing = std::equal(parts.begin(), parts.end(), all.begin(), all.end(), isSame);
    return isNothing ? parts : all; // some that came have nothing of the mesh any more: it cannot be told
  }
  for (auto it = added; it != all.end(); ++it)
  {
    parts[it->first] = { step, it->first - first };
  }
  return parts;
}

} // namespace

Eigen::Vector4d rectangleOf(vtkPolyData* mesh)
{
  vtkDataArray* canvas = mesh->GetFieldData()->GetArray("Canvas");
  if (canvas && canvas->GetNumberOfValues() == 4)
  {
    const int components = canvas->GetNumberOfComponents();
    const auto value = [&](int i) { return canvas->GetComponent(i / components, i % components); };
    return { value(0), value(1), value(0) + value(2), value(1) + value(3) };
  }
  double bounds[6];
  mesh->GetBounds(bounds);
  return { bounds[0], bounds[2], bounds[1], bounds[3] };
}

vtkSmartPointer<vtkPolyData> placedBy(const Eigen::Matrix4d& matrix, vtkPolyData* mesh)
{
  auto result = shallowCopyOf(mesh);
  vtkNew<vtkFieldData> fields; // the mesh's own is shared
  fields->ShallowCopy(mesh->GetFieldData());
  vtkNew<vtkDoubleArray> placement;
  placement->SetName("Placement");
  placement->SetNumberOfComponents(16);
  placement->SetNumberOfTuples(1);
  for (int i = 0; i < 16; ++i)
  {
    placement->SetComponent(0, i, matrix(i / 4, i % 4));
  }
  fields->AddArray(placement);
  result->SetFieldData(fields);
  result->GetCellData()->RemoveArray("MaterialIds");
  return result;
}

vtkSmartPointer<vtkPolyData> withPart(vtkPolyData* mesh, vtkPolyData* part, const PartPlace& place)
{
  vtkNew<vtkOversketchAssemble> assemble;
  if (mesh)
  {
    assemble->AddInputData(placedBy(Eigen::Matrix4d::Identity(), mesh));
  }
  const Eigen::Vector4d box(place.box[0], place.box[1], place.box[2], place.box[3]);
  assemble->AddInputData(placedBy(oversketch::intoBox(rectangleOf(part), box, place.depth), part));
  oversketch::StepRunner(assemble, {}).Run();
  return assemble->GetOutput();
}

PartSources sourcesOf(const Model& model, const std::vector<Outcome>& outcomes)
{
  PartSources parts = model.mesh ? byNumbers(model.mesh) : PartSources();
  for (std::size_t i = 0; i < outcomes.size(); ++i)
  {
    const Node& node = model.nodes[i];
    const SystemRow* row = outcomes[i].number != 0 ? findSystem(node.step->system) : nullptr;
    const SystemInput* input = row ? findInput(*row, SystemInput::Kind::Mesh) : nullptr;
    if (row && !input) // it takes no mesh
    {
      parts = withThoseOf(node.id, node.step->part ? std::move(parts) : PartSources(), outcomes[i].mesh);
    }
    else if (input && node.step->inputs.count(input->name) > 0) // not that of the step before
    {
      parts = byNumbers(outcomes[i].mesh);
    }
    else if (row && row->joinsParts)
    {
      parts = byNumbers(outcomes[i].mesh);
    }
    else if (row && row->addsParts)
    {
      parts = withThoseOf(node.id, std::move(parts), outcomes[i].mesh);
    }
  }
  return parts;
}

PartSource sourceOf(const PartSources& parts, int number)
{
  const auto known = parts.find(number);
  return known == parts.end() ? PartSource{ 0, number } : known->second;
}

std::set<int> hiddenOf(const Model& model, const PartSources& parts)
{
  std::set<int> hidden;
  std::set<PartSource> all;
  std::transform(
    parts.begin(), parts.end(), std::inserter(all, all.end()), [](const auto& part) { return part.second; });
  for (const auto& [number, source] : parts)
  {
    if (all.size() > 1 && model.hidden.count(source) > 0)
    {
      hidden.insert(number);
    }
  }
  return hidden;
}

std::string faultOf(const PartPlace& place)
{
  for (const double value : { place.box[0], place.box[1], place.box[2], place.box[3], place.depth })
  {
    if (!(std::abs(value) <= farthest))
    {
      return "has a number beyond 1e9, or none";
    }
  }
  const bool isBox = place.box[2] - place.box[0] >= narrowest && place.box[3] - place.box[1] >= narrowest;
  return isBox ? "" : "is an empty box; right must be greater than left and top than bottom";
}

} // namespace oversketch_session
