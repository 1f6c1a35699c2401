#include "systems.h"

#include "vtkOversketchSystem.h"

#ifdef OVERSKETCH_WITH_ONESTROKE
#include "vtkOversketchOneStroke.h"
#endif

#include <algorithm>

namespace oversketch_session
{

namespace
{

template <typename T>
vtkSmartPointer<vtkOversketchSystem> make()
{
  return vtkSmartPointer<T>::New();
}

#ifdef OVERSKETCH_WITH_ONESTROKE
SystemRow oneStroke()
{
  using System = vtkOversketchOneStroke;
  using Kind = SystemInput::Kind;
  SystemRow row;
  row.name = "OneStroke";
  row.verb = "one-stroke";
  row.title = "Stroke";
  row.brief = "deform a mesh by one stroke";
  row.help =
    "Moves the part of the silhouette that the stroke was drawn beside onto the stroke, and the limb "
    "with it.";
  row.make = make<System>;
  row.inputs = { { "Mesh", "mesh", "the mesh that is deformed", Kind::Mesh, 0 },
    { "Stroke", "stroke", "one polyline in pixels, with the view that it was drawn in", Kind::Stroke, 1 } };
  row.parameters = {
    parameter<System>("Remesh",
      "remesh",
      "New triangles",
      "remesh the region before and after; auto does so where the deformation needs it",
      &System::SetRemesh,
      &System::GetRemesh,
      { { "auto", "where it is needed" }, { "on", "always" }, { "off", "never" } }),
    parameter<System>("AdjustNormals",
      "adjust-normals",
      "Details turn with the limb",
      "let details turn with the limb (slower)",
      &System::SetAdjustNormals,
      &System::GetAdjustNormals),
    between(1,
      99,
      parameter<System>("Candidate",
        "candidate",
        "Section that fits",
        "which of the sections that fit the stroke is taken, 1 for the best",
        &System::SetCandidate,
        &System::GetCandidate)),
    between(-1,
      1,
      parameter<System>("Reach",
        "reach",
        "Reach into the body",
        "how much further than found the region goes, in lengths of the section; less far where negative",
        &System::SetReach,
        &System::GetReach)),
    parameter<System>("AllowTorn",
      "allow-torn",
      "Even if it tears",
      "hand over a result that is torn, too",
      &System::SetAllowTorn,
      &System::GetAllowTorn),
    parameter<System>("AsPublished",
      "as-published",
      "As published",
      "without the amendments to the published method",
      &System::SetAsPublished,
      &System::GetAsPublished),
  };
  row.mirrored = Values{ { "Remesh", int(System::RemeshOff) } };
  row.leftOut = { { "CorrectOutline", "one of the amendments that AsPublished turns off together" } };
  return row;
}
#endif

} // namespace

SystemRow withDefaults(SystemRow row)
{
  const vtkSmartPointer<vtkOversketchSystem> fresh = row.make();
  for (Parameter& one : row.parameters)
  {
    one.initial = one.get(fresh);
  }
  return row;
}

const std::vector<SystemRow>& systems()
{
  static const std::vector<SystemRow> rows = {
#ifdef OVERSKETCH_WITH_ONESTROKE
    withDefaults(oneStroke()),
#endif
  };
  return rows;
}

const SystemRow* findSystem(const std::string& name, const std::vector<SystemRow>& rows)
{
  const auto it =
    std::find_if(rows.begin(), rows.end(), [&](const SystemRow& row) { return row.name == name; });
  return it == rows.end() ? nullptr : &*it;
}

const SystemRow* findVerb(const std::string& verb)
{
  const auto& rows = systems();
  const auto it =
    std::find_if(rows.begin(), rows.end(), [&](const SystemRow& row) { return row.verb == verb; });
  return it == rows.end() ? nullptr : &*it;
}

const Parameter* findParameter(const SystemRow& row, const std::string& property)
{
  const auto it = std::find_if(row.parameters.begin(),
    row.parameters.end(),
    [&](const Parameter& one) { return one.property == property; });
  return it == row.parameters.end() ? nullptr : &*it;
}

const SystemInput* findInput(const SystemRow& row, const std::string& name)
{
  const auto it = std::find_if(
    row.inputs.begin(), row.inputs.end(), [&](const SystemInput& input) { return input.name == name; });
  return it == row.inputs.end() ? nullptr : &*it;
}

const SystemInput* findInput(const SystemRow& row, SystemInput::Kind kind)
{
  const auto it = std::find_if(
    row.inputs.begin(), row.inputs.end(), [&](const SystemInput& input) { return input.kind == kind; });
  return it == row.inputs.end() ? nullptr : &*it;
}

std::vector<std::string> wordsOf(const Parameter& parameter)
{
  std::vector<std::string> words;
  for (const Choice& choice : parameter.choices)
  {
    words.push_back(choice.word);
  }
  return words;
}

const Value& valueOf(const Step& step, const Parameter& parameter)
{
  const auto it = step.values.find(parameter.property);
  return it == step.values.end() ? parameter.initial : it->second;
}

std::string faultOf(const Step& step, const std::vector<SystemRow>& rows)
{
  const SystemRow* row = findSystem(step.system, rows);
  if (!row)
  {
    return "'" + step.system + "' is no system that this version has";
  }
  for (const auto& [property, value] : step.values)
  {
    const Parameter* one = findParameter(*row, property);
    if (!one)
    {
      return "'" + property + "' is no parameter of " + row->name;
    }
    const int* chosen = std::get_if<int>(&value);
    if (value.index() != one->initial.index() ||
        (chosen && !one->choices.empty() &&
          (*chosen < 0 || static_cast<std::size_t>(*chosen) >= one->choices.size())))
    {
      return "'" + property + "' of " + row->name + " has a value that it cannot have";
    }
  }
  for (const auto& named : step.inputs)
  {
    if (!findInput(*row, named.first))
    {
      return "'" + named.first + "' is no input of " + row->name;
    }
  }
  if (step.mirror && !row->mirrored)
  {
    return row->name + " cannot act on both sides of a plane: its points do not keep their ids";
  }
  return {};
}

const std::vector<std::string>& backendWords()
{
  static const std::vector<std::string> words = { vtkOversketchSystem::GetBackendWord(
                                                    vtkOversketchSystem::Auto),
    vtkOversketchSystem::GetBackendWord(vtkOversketchSystem::OpenCL),
    vtkOversketchSystem::GetBackendWord(vtkOversketchSystem::Host) };
  return words;
}

} // namespace oversketch_session
