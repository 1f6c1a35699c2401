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

namespace oversketch_command
{

using namespace oversketch_session;

namespace
{

// The field arrays of one value.
void addFigures(vtkPolyData* data, const std::string& name, Json::Value& json)
{
  vtkFieldData* fields = data ? data->GetFieldData() : nullptr;
  for (int i = 0; fields && i < fields->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = fields->GetArray(i); // null for texts
    if (array && array->GetName() && array->GetNumberOfValues() == 1)
    {
      json[name][array->GetName()] = number(array->GetComponent(0, 0));
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

// What the command was called with, and how long it took.
Json::Value beginning(const Report& report, const std::string& verb, const Options& options)
{
  Json::Value json;
  json["oversketch"] = OVERSKETCH_VERSION;
  json["command"] = verb;
  json["output"] = options.output;
  json["milliseconds"]["read"] = number(report.readMilliseconds);
  json["milliseconds"]["run"] = number(report.runMilliseconds);
  json["milliseconds"]["write"] = number(report.writeMilliseconds);
  json["warnings"] = Json::arrayValue;
  for (const std::string& warning : warned())
  {
    json["warnings"].append(warning);
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

Json::Value number(double value)
{
  return std::isfinite(value) ? Json::Value(value) : Json::Value();
}

Json::Value countsOf(vtkPolyData* mesh)
{
  Json::Value json;
  json["points"] = static_cast<Json::Int64>(mesh->GetNumberOfPoints());
  json["triangles"] = static_cast<Json::Int64>(mesh->GetNumberOfPolys());
  return json;
}

Json::Value stageTimes(vtkOversketchSystem* system)
{
  Json::Value json;
  for (int i = 0; i < system->GetNumberOfStages(); ++i)
  {
    const char* name = system->GetStage(i);
    json[name] = number(1e3 * system->GetStageTime(name));
  }
  return json;
}

std::string Report::json(const Options& options,
  const Step& step,
  vtkOversketchSystem* system,
  vtkPolyData* mesh,
  vtkPolyData* result) const
{
  Json::Value json = beginning(*this, options.system->verb, options);
  for (const SystemInput& input : options.system->inputs)
  {
    if (!options.inputs.at(input.name).empty())
    {
      json[input.word] = options.inputs.at(input.name);
    }
  }
  json["options"] = optionsOf(options, step);
  json["backend_used"] = backendWords()[static_cast<std::size_t>(system->GetBackendUsed())];
  json["stage_milliseconds"] = stageTimes(system);
  if (mesh)
  {
    json["before"] = countsOf(mesh);
  }
  json["after"] = countsOf(result);
  json["fields"] = Json::objectValue;
  for (int i = 0; i < system->GetNumberOfInnerOutputs(); ++i)
  {
    const char* name = system->GetInnerOutputName(i);
    addFigures(system->GetInnerOutput(name), name, json["fields"]);
  }
  addFigures(result, "Output", json["fields"]);
  oversketch_command::addFigures(system, json);
  return written(json);
}

std::string Report::assembledJson(const Options& options, const Json::Value& parts, vtkPolyData* result) const
{
  Json::Value json = beginning(*this, "assemble", options);
  json["parts_file"] = options.session;
  json["parts"] = parts;
  json["after"] = countsOf(result);
  return written(json);
}

} // namespace oversketch_command
