// Questions to the list of systems.
#include "systems.h"

#include "vtkOversketchSystem.h"

#include <algorithm>

namespace oversketch_session
{

namespace
{

// The first row of a list with that value of a member; null where there is none.
template <typename Row, typename Value>
const Row* findBy(Value Row::*member, const Value& value, const std::vector<Row>& rows)
{
  const auto it =
    std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.*member == value; });
  return it == rows.end() ? nullptr : &*it;
}

} // namespace

bool isNeeded(const SystemInput& input, const Values& values)
{
  const auto maker = values.find(input.madeBy);
  const bool isMade = maker != values.end() && maker->second != Value(std::string());
  return input.madeBy.empty() ? !input.optional : !isMade;
}

bool isImage(SystemInput::Kind kind)
{
  return kind == SystemInput::Kind::Picture || kind == SystemInput::Kind::Heights;
}

const SystemRow* findSystem(const std::string& name, const std::vector<SystemRow>& rows)
{
  return findBy(&SystemRow::name, name, rows);
}

const SystemRow* findVerb(const std::string& verb)
{
  return findBy(&SystemRow::verb, verb, systems());
}

const Parameter* findParameter(const SystemRow& row, const std::string& property)
{
  return findBy(&Parameter::property, property, row.parameters);
}

const SystemInput* findInput(const SystemRow& row, const std::string& name)
{
  return findBy(&SystemInput::name, name, row.inputs);
}

const SystemInput* findInput(const SystemRow& row, SystemInput::Kind kind)
{
  return findBy(&SystemInput::kind, kind, row.inputs);
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
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    if (value.index() != one->initial.index() ||
        (numbers && numbers->size() != std::get<std::vector<double>>(one->initial).size()) ||
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
  if (step.mirror && row->mirroring == Mirroring::None)
  {
    return row->name + " cannot act on both sides of a plane: its points do not keep their ids";
  }
  return {};
}

const std::vector<std::string>& backendWords()
{
  using System = vtkOversketchSystem;
  static const std::vector<std::string> words = { System::GetBackendWord(System::Auto),
    System::GetBackendWord(System::OpenCL),
    System::GetBackendWord(System::Host) };
  return words;
}

} // namespace oversketch_session
