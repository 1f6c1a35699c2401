// What is asked of the list of systems.
#include "systems.h"

#include "vtkOversketchSystem.h"

#include <algorithm>

namespace oversketch_session
{

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

vtkAlgorithm* ownerOf(vtkOversketchSystem* system, const std::string& step)
{
  return step.empty() ? system : system->GetStep(step.c_str());
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
  if (step.part && findInput(*row, SystemInput::Kind::Mesh))
  {
    return row->name + " changes the mesh that comes to it, and makes no part of its own";
  }
  if (step.mirror && !actsOnBothSides(*row))
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
