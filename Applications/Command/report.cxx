#include "report.h"

#include "node_json.h"
#include "terminal.h"

#include "vtkOversketchSystem.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace oversketch_command
{

using namespace oversketch_session;

namespace
{

// A figure as JSON; null where it could not be had.
Json::Value asJson(bool value)
{
  return value;
}

Json::Value asJson(vtkIdType value)
{
  return static_cast<Json::Int64>(value);
}

Json::Value asJson(double value)
{
  return std::isfinite(value) ? Json::Value(value) : Json::Value();
}

Json::Value asJson(const std::vector<std::string>& words)
{
  Json::Value list(Json::arrayValue);
  for (const std::string& word : words)
  {
    list.append(word);
  }
  return list;
}

// The field arrays of one value.
void addFields(vtkPolyData* data, const std::string& name, Json::Value& json)
{
  vtkFieldData* fields = data ? data->GetFieldData() : nullptr;
  for (int i = 0; fields && i < fields->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = fields->GetArray(i); // null for texts
    if (array && array->GetName() && array->GetNumberOfValues() == 1)
    {
      json[name][array->GetName()] = asJson(array->GetComponent(0, 0));
    }
  }
}

Json::Value optionsOf(const Options& options, const Step& step)
{
  Json::Value json;
  json["backend"] = backendWords()[static_cast<std::size_t>(options.backend)];
  for (const Parameter& parameter : options.system->parameters)
  {
    std::string name = parameter.word;
    std::replace(name.begin(), name.end(), '-', '_');
    json[name] = jsonOf(parameter, valueOf(step, parameter));
  }
  return json;
}

std::string written(const Json::Value& json)
{
  Json::StreamWriterBuilder writer;
  writer["indentation"] = "  ";
  writer["precision"] = 9;
  return Json::writeString(writer, json) + "\n";
}

} // namespace

Json::Value countsOf(vtkPolyData* mesh)
{
  Json::Value json;
  json["points"] = static_cast<Json::Int64>(mesh->GetNumberOfPoints());
  json["triangles"] = static_cast<Json::Int64>(mesh->GetNumberOfPolys());
  return json;
}

void addFigures(vtkOversketchSystem* system, Json::Value& json)
{
  for (int i = 0; i < system->GetNumberOfStages(); ++i)
  {
    const char* name = system->GetStage(i);
    json["stage_milliseconds"][name] = asJson(1e3 * system->GetStageTime(name));
  }
  for (int i = 0; i < system->GetNumberOfInnerOutputs(); ++i)
  {
    const char* name = system->GetInnerOutputName(i);
    vtkPolyData* made = system->GetInnerOutput(name);
    if (made && made->GetNumberOfPolys() > 0)
    {
      json["faces"][name] = asJson(made->GetNumberOfPolys());
    }
  }
  for (const auto& [name, figure] : system->Figures())
  {
    Json::Value& member = Json::Path(name).make(json);
    std::visit([&member](const auto& value) { member = asJson(value); }, figure);
  }
}

void Report::ends(const std::string& part)
{
  const auto now = std::chrono::steady_clock::now();
  this->Milliseconds[part] = std::chrono::duration<double, std::milli>(now - this->Begun).count();
  this->Begun = now;
}

// The command's call, and how long it took.
Json::Value Report::beginning(const std::string& verb, const Options& options) const
{
  Json::Value json;
  json["oversketch"] = OVERSKETCH_VERSION;
  json["command"] = verb;
  json["output"] = options.output;
  for (const auto& [part, milliseconds] : this->Milliseconds)
  {
    json["milliseconds"][part] = milliseconds;
  }
  json["warnings"] = asJson(warned());
  return json;
}

std::string Report::json(const Options& options,
  const Step& step,
  vtkOversketchSystem* system,
  vtkPolyData* mesh,
  vtkPolyData* proxy,
  vtkPolyData* result) const
{
  Json::Value json = this->beginning(options.system->verb, options);
  for (const SystemInput& input : options.system->inputs)
  {
    if (!options.inputs.at(input.name).empty())
    {
      json[input.word] = options.inputs.at(input.name);
    }
  }
  json["options"] = optionsOf(options, step);
  json["backend_used"] = backendWords()[static_cast<std::size_t>(system->GetBackendUsed())];
  if (mesh)
  {
    json["before"] = countsOf(mesh);
  }
  if (proxy)
  {
    json["proxy"] = countsOf(proxy);
  }
  json["after"] = countsOf(result);
  json["fields"] = Json::objectValue;
  for (int i = 0; i < system->GetNumberOfInnerOutputs(); ++i)
  {
    const char* name = system->GetInnerOutputName(i);
    addFields(system->GetInnerOutput(name), name, json["fields"]);
  }
  addFields(result, "Output", json["fields"]);
  addFigures(system, json);
  return written(json);
}

std::string Report::assembledJson(const Options& options, const Json::Value& parts, vtkPolyData* result) const
{
  Json::Value json = this->beginning("assemble", options);
  json["parts_file"] = options.session;
  json["parts"] = parts;
  json["after"] = countsOf(result);
  return written(json);
}

std::string Report::checkedJson(const Options& options, const Json::Value& figures) const
{
  Json::Value json = this->beginning("check", options);
  json["mesh"] = options.session;
  json["check"] = figures;
  return written(json);
}

} // namespace oversketch_command
