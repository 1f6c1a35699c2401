#include "layers_file.h"

#include "files.h"
#include "json_members.h"
#include "mesh_file.h"

#include "Shading/layer_list.h"

#include "vtkAppendPolyData.h"
#include "vtkNew.h"

#include <cmath>
#include <filesystem>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

namespace
{

constexpr const char* adviceOfEdit = "see oversketch edit --help";
constexpr int mostLevels = 256;       // vtkOversketchShadingLevels
constexpr Json::ArrayIndex most = 64; // areas, vtkOversketchScanFill
constexpr Json::ArrayIndex mostHandles = 1000;

std::vector<oversketch::LayerHandle> handlesOf(const JsonReader& json)
{
  std::vector<oversketch::LayerHandle> handles;
  if (!json.has("handles"))
  {
    return handles;
  }
  const Json::Value& list = json.get("handles");
  if (!list.isArray() || list.size() > mostHandles)
  {
    json.refuse("handles", std::string("is no list of at most 1000 pairs [from, to]; ") + adviceOfEdit);
  }
  for (const Json::Value& pair : list)
  {
    if (!pair.isArray() || pair.size() != 2 || !pair[0].isNumeric() || !pair[1].isNumeric() ||
        !std::isfinite(pair[0].asDouble()) || !std::isfinite(pair[1].asDouble()))
    {
      json.refuse(
        "handles", std::string("holds something that is no pair [from, to] of numbers; ") + adviceOfEdit);
    }
    handles.push_back({ pair[0].asDouble(), pair[1].asDouble() });
  }
  return handles;
}

} // namespace

void readLayers(const std::string& path, Step& step)
{
  requireReadable(path);
  const Json::Value root = JsonReader::parse(wholeFile(path), path);
  const JsonReader json(root, path, adviceOfEdit);
  requireKnown(json, { "levels", "handles", "areas" });
  if (json.has("levels"))
  {
    step.values["Levels"] = json.integer("levels", 2, mostLevels);
  }
  oversketch::LayerList layers{ handlesOf(json), {} };
  if (json.has("areas"))
  {
    const Json::Value& list = json.get("areas");
    if (!list.isArray() || list.size() > most)
    {
      json.refuse("areas", std::string("is no list of at most 64 areas; ") + adviceOfEdit);
    }
    if (step.inputs.count("Areas") > 0)
    {
      json.refuse("areas", "stands beside --areas; give them in one of both");
    }
    vtkNew<vtkAppendPolyData> all;
    all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    for (Json::ArrayIndex i = 0; i < list.size(); ++i)
    {
      const JsonReader area(list[i], path + ", area " + std::to_string(i), adviceOfEdit);
      requireKnown(area, { "stroke", "levels", "handles" });
      const std::string folder = std::filesystem::path(path).parent_path().string();
      const vtkSmartPointer<vtkPolyData> stroke =
        readStroke(fileBeside(area, "stroke", folder, "the file of layers"));
      if (stroke->GetNumberOfLines() != 1 || stroke->GetNumberOfCells() != 1)
      {
        area.refuse(
          "stroke", "holds " + std::to_string(stroke->GetNumberOfCells()) + " cells; give one polyline");
      }
      all->AddInputData(stroke);
      const int levels = area.has("levels") ? area.integer("levels", 2, mostLevels) : 0;
      layers.areas.push_back({ static_cast<int>(i), levels, handlesOf(area) });
    }
    if (!list.empty())
    {
      all->Update();
      step.inputs["Areas"] = Lines(all->GetOutput());
    }
  }
  step.values["Layers"] = oversketch::layerText(layers);
}

} // namespace oversketch_command
