#include "step_values.h"

#include "files.h"
#include "image_file.h"
#include "mesh_file.h"
#include "node_json.h"
#include "systems.h"

#include <memory>
#include <sstream>

namespace oversketch_session
{

using oversketch_files::Failed;

namespace
{

template <typename Rows, typename Name>
std::string namesOf(const Rows& rows, Name name)
{
  std::string names;
  for (const auto& row : rows)
  {
    names += (names.empty() ? "" : ", ") + row.*name;
  }
  return names;
}

Input inputOf(const GivenInput& given, const SystemInput& input, const SystemRow& row, const Model& model)
{
  const std::string name = input.name + " of " + row.name;
  if (const auto* output = std::get_if<StepOutput>(&given))
  {
    if (rowOf(model.nodes, output->step) < 0 || output->port < 0)
    {
      throw Failed(name + " is to be output " + std::to_string(output->port) + " of step " +
                   std::to_string(output->step) + ", which is not there");
    }
    return *output;
  }
  const auto* path = std::get_if<std::string>(&given);
  if (input.kind == SystemInput::Kind::Mesh)
  {
    throw Failed(name + " is the mesh of the step before; name another step by SetInputStep, or give none");
  }
  if (isImage(input.kind) != (path != nullptr))
  {
    throw Failed(name + (path ? " is lines; give them by SetInput" : " is a file; give it by SetInputFile"));
  }
  return path ? Input(readImage(*path, input.kind))
              : Input(Lines(soundLines(name, std::get<vtkSmartPointer<vtkPolyData>>(given))));
}

const char* kindOf(SystemInput::Kind kind)
{
  constexpr const char* words[] = { "mesh", "stroke", "curves", "picture", "heights" };
  return words[static_cast<std::size_t>(kind)];
}

const char* kindOf(const Parameter& parameter)
{
  constexpr const char* words[] = { "bool", "int", "double", "numbers", "text" }; // as Value's alternatives
  return parameter.choices.empty() ? words[parameter.initial.index()] : "choice";
}

Json::Value jsonOf(const std::vector<Choice>& choices)
{
  Json::Value list(Json::arrayValue);
  for (const Choice& choice : choices)
  {
    Json::Value json;
    json["word"] = choice.word;
    json["title"] = choice.title;
    list.append(json);
  }
  return list;
}

Json::Value jsonOf(const Parameter& parameter)
{
  Json::Value json;
  json["property"] = parameter.property;
  json["title"] = parameter.title;
  json["help"] = parameter.help;
  json["kind"] = kindOf(parameter);
  json["default"] = jsonOf(parameter, parameter.initial);
  json["is_length"] = parameter.isLength;
  if (parameter.least != parameter.most)
  {
    json["least"] = parameter.least;
    json["most"] = parameter.most;
  }
  json["choices"] = jsonOf(parameter.choices.empty() ? parameter.offers : parameter.choices);
  return json;
}

Json::Value jsonOf(const SystemInput& input)
{
  Json::Value json;
  json["name"] = input.name;
  json["help"] = input.help;
  json["kind"] = kindOf(input.kind);
  json["optional"] = input.optional || !input.madeBy.empty();
  return json;
}

} // namespace

Step withGiven(Step step,
  const std::string& values,
  const std::map<std::string, GivenInput>& inputs,
  const Model& model)
{
  const SystemRow* row = findSystem(step.system);
  if (!row)
  {
    throw Failed(faultOf(step) + "; it has: " + namesOf(systems(), &SystemRow::name));
  }
  const Json::Value parsed = JsonReader::parse(values, "the text of values");
  const JsonReader reader(parsed, "the text of values", "GetSystems tells what it can be");
  for (const std::string& name : reader.names())
  {
    const Parameter* parameter = findParameter(*row, name);
    if (!parameter)
    {
      reader.refuse(name,
        "is no parameter of " + row->name + "; it has: " + namesOf(row->parameters, &Parameter::property));
    }
    step.values[name] = valueOf(reader, name, *parameter);
    if (step.values[name] == parameter->initial)
    {
      step.values.erase(name); // a step holds no value that is the default
    }
  }
  for (const auto& [name, given] : inputs)
  {
    const SystemInput* input = findInput(*row, name);
    if (!input)
    {
      throw Failed("'" + name + "' is no input of " + row->name +
                   "; it has: " + namesOf(row->inputs, &SystemInput::name));
    }
    const auto* lines = std::get_if<vtkSmartPointer<vtkPolyData>>(&given);
    lines && !*lines ? void(step.inputs.erase(name))
                     : void(step.inputs[name] = inputOf(given, *input, *row, model));
  }
  for (const SystemInput& input : row->inputs)
  {
    if (isNeeded(input, step.values) && input.kind != SystemInput::Kind::Mesh &&
        step.inputs.count(input.name) == 0)
    {
      throw Failed(row->name + " needs its input " + input.name + "; set it before (" + input.help + ")");
    }
  }
  if (const std::string fault = faultOf(step); !fault.empty())
  {
    throw Failed(fault);
  }
  return step;
}

vtkSmartPointer<vtkPolyData> soundLines(const std::string& name, vtkPolyData* lines)
{
  return oversketch_files::parseStroke(name, oversketch_files::bytesOf(lines));
}

std::string textOf(const Json::Value& value)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "";
  builder["emitUTF8"] = true;
  return Json::writeString(builder, value);
}

std::string systemsAsJson()
{
  Json::Value list(Json::arrayValue);
  for (const SystemRow& row : systems())
  {
    Json::Value json;
    json["name"] = row.name;
    json["verb"] = row.verb;
    json["title"] = row.title;
    json["help"] = row.help;
    json["mirrors"] = row.mirroring != Mirroring::None;
    json["inputs"] = json["parameters"] = Json::arrayValue;
    for (const SystemInput& input : row.inputs)
    {
      json["inputs"].append(jsonOf(input));
    }
    for (const Parameter& parameter : row.parameters)
    {
      json["parameters"].append(jsonOf(parameter));
    }
    list.append(json);
  }
  return textOf(list);
}

} // namespace oversketch_session
