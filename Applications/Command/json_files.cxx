#include "json_files.h"

#include "files.h"
#include "json_reader.h"
#include "mesh_file.h"
#include "node_json.h"
#include "parts.h"

#include "Inflate/placement.h"
#include "Mesh/context.h"
#include "Shading/layer_list.h"

#include "vtkAppendPolyData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

namespace
{

constexpr Json::ArrayIndex mostParts = 1000;
constexpr double farthest = 1e9;   // that a part is moved or scaled
constexpr double narrowest = 1e-9; // of a box, and what a part is scaled by
const char* const verdict = "see oversketch assemble --help";
const char* const adviceOfEdit = "see oversketch edit --help";
constexpr int mostLevels = 256;            // vtkOversketchShadingLevels
constexpr Json::ArrayIndex mostAreas = 64; // vtkOversketchScanFill
constexpr Json::ArrayIndex mostHandles = 1000;

// Throws Failed, naming one that is none of the members.
void requireKnown(const JsonReader& json, const std::vector<std::string>& members)
{
  for (const std::string& name : json.names())
  {
    if (std::find(members.begin(), members.end(), name) == members.end())
    {
      std::string known;
      for (const std::string& member : members)
      {
        known += (known.empty() ? "" : ", ") + member;
      }
      json.refuse(name, "is no member of it; these are: " + known);
    }
  }
}

// A readable file that a member names; relative to the folder of the JSON file, which messages call `whose`
// ("the parts' file"). Throws Failed, naming the member.
std::string fileBeside(const JsonReader& json,
  const std::string& name,
  const std::string& folder,
  const std::string& whose)
{
  const std::string given = json.text(name);
  if (given.empty() || given.find('\0') != std::string::npos)
  {
    json.refuse(name, "is no path of a file; name one, beginning at the folder of " + whose);
  }
  std::string path = (std::filesystem::path(folder) / given).lexically_normal().string();
  try
  {
    requireReadable(path);
  }
  catch (const Failed& failed)
  {
    const std::string why = failed.what();
    json.refuse(name,
      "names '" + given + "': " + why.substr(path.size() + 2) +
        "; mend the path, which begins at the folder of " + whose);
  }
  return path;
}

// A file that a part names; relative to the folder of the parts' file.
std::string fileOf(const JsonReader& json, const std::string& name, const std::filesystem::path& folder)
{
  return fileBeside(json, name, folder.string(), "the parts' file");
}

// The values of a drawing's parameters, by the words of the command.
Values valuesOf(const JsonReader& json, const SystemRow& row)
{
  Values values;
  for (const std::string& word : json.names())
  {
    const auto parameter = std::find_if(row.parameters.begin(),
      row.parameters.end(),
      [&word](const Parameter& one) { return one.word == word; });
    if (parameter == row.parameters.end())
    {
      json.refuse(word, "is no parameter; they are called as the options of oversketch " + row.verb);
    }
    values[parameter->property] = valueOf(json, word, *parameter);
  }
  return values;
}

PartSource sourceOf(const JsonReader& json, const std::filesystem::path& folder)
{
  PartSource source;
  if (json.has("strokes") == json.has("mesh"))
  {
    throw Failed(json.where() + " needs either 'strokes', a drawing, or 'mesh'; " + verdict);
  }
  if (json.has("mesh"))
  {
    for (const char* name : { "picture", "back_picture", "parameters" })
    {
      if (json.has(name))
      {
        json.refuse(name, "belongs to 'strokes', not to 'mesh'; take one of them out");
      }
    }
    source.mesh = fileOf(json, "mesh", folder);
    return source;
  }
  const SystemRow* row = findSystem("InflateDrawing");
  if (!row)
  {
    json.refuse("strokes", "is a drawing, which this build makes no models of; give a 'mesh'");
  }
  source.drawing = fileOf(json, "strokes", folder);
  source.picture = json.has("picture") ? fileOf(json, "picture", folder) : "";
  source.back = json.has("back_picture") ? fileOf(json, "back_picture", folder) : "";
  source.values = json.has("parameters") ? valuesOf(json.object("parameters"), *row) : Values();
  return source;
}

// The number of that name in a list, none that would lead beyond what is sensible.
double sensible(const JsonReader& json, const std::string& name, const Json::Value& value)
{
  if (!value.isNumeric() || !std::isfinite(value.asDouble()))
  {
    json.refuse(name, std::string("holds something that is no number; ") + verdict);
  }
  if (std::abs(value.asDouble()) > farthest)
  {
    json.refuse(name, "holds a number beyond 1e9; place and scale the parts by less");
  }
  return value.asDouble();
}

void requirePlacement(const std::string& where, const std::string& member, const Eigen::Matrix4d& matrix)
{
  const Eigen::Vector3d scales = matrix.topLeftCorner<3, 3>().colwise().norm();
  try
  {
    const oversketch::Placement placement(matrix);
  }
  catch (const oversketch::Error& error)
  {
    throw Failed(where + ": '" + member + "': " + error.what());
  }
  if (scales.minCoeff() < narrowest || scales.maxCoeff() > farthest)
  {
    throw Failed(
      where + ": '" + member + "' scales the part by less than 1e-9 or over 1e9; give a scale between them");
  }
}

Eigen::Matrix4d matrixOf(const JsonReader& json)
{
  const Json::Value& rows = json.get("placement");
  const auto isRow = [](const Json::Value& row) { return row.isArray() && row.size() == 4; };
  if (!isRow(rows) || !std::all_of(rows.begin(), rows.end(), isRow))
  {
    json.refuse(
      "placement", "is no matrix of four rows of four numbers; write it so, or give 'box' and 'depth'");
  }
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 16; ++i)
  {
    matrix(i / 4, i % 4) = sensible(
      json, "placement", rows[static_cast<Json::ArrayIndex>(i / 4)][static_cast<Json::ArrayIndex>(i % 4)]);
  }
  requirePlacement(json.where(), "placement", matrix);
  return matrix;
}

Box boxOf(const JsonReader& json)
{
  const Json::Value& list = json.get("box");
  if (!list.isArray() || list.size() != 4)
  {
    json.refuse("box", std::string("is not left, bottom, right and top, four numbers; ") + verdict);
  }
  Box box;
  for (int i = 0; i < 4; ++i)
  {
    box[i] = sensible(json, "box", list[static_cast<Json::ArrayIndex>(i)]);
  }
  if (!(box[2] - box[0] >= narrowest) || !(box[3] - box[1] >= narrowest))
  {
    json.refuse("box", "is empty; right must be greater than left and top than bottom, by 1e-9 at least");
  }
  return box;
}

Part partOf(const JsonReader& json, const std::filesystem::path& folder)
{
  requireKnown(
    json, { "strokes", "picture", "back_picture", "parameters", "mesh", "placement", "box", "depth" });
  Part part;
  part.where = json.where();
  if (json.has("placement") && (json.has("box") || json.has("depth")))
  {
    json.refuse("placement", "stands beside 'box' or 'depth'; a part has a matrix or these");
  }
  if (json.has("placement"))
  {
    part.placement = matrixOf(json);
  }
  if (json.has("box"))
  {
    part.box = boxOf(json);
  }
  if (json.has("depth"))
  {
    part.depth = sensible(json, "depth", json.get("depth"));
  }
  part.source = sourceOf(json, folder);
  return part;
}

// Whether two parts of one source stand at one place.
bool isSamePlace(const Part& a, const Part& b)
{
  return a.placement == b.placement && a.box == b.box && a.depth == b.depth;
}

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

std::vector<Part> readParts(const std::string& path)
{
  requireReadable(path);
  const Json::Value root = JsonReader::parse(wholeFile(path), path);
  const JsonReader json(root, path, verdict);
  requireKnown(json, { "parts" });
  const Json::Value& list = json.get("parts");
  if (!list.isArray())
  {
    json.refuse("parts", std::string("is not a list; ") + verdict);
  }
  if (list.empty() || list.size() > mostParts)
  {
    json.refuse("parts",
      list.empty()
        ? "is empty; name a part at least"
        : "has " + std::to_string(list.size()) + " entries, and may have " + std::to_string(mostParts) +
            "; assemble some of them first and name that mesh as a part");
  }
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::vector<Part> parts;
  std::map<PartSource, std::vector<std::size_t>> known;
  for (Json::ArrayIndex i = 0; i < list.size(); ++i)
  {
    parts.push_back(partOf({ list[i], path + ", part " + std::to_string(i), verdict }, folder));
    std::vector<std::size_t>& alike = known[parts.back().source];
    for (const std::size_t other : alike)
    {
      if (isSamePlace(parts[other], parts.back()))
      {
        throw Failed(parts.back().where + " is part " + std::to_string(other) +
                     " once more, at the same place; take it out, or place it elsewhere");
      }
    }
    alike.push_back(i);
  }
  return parts;
}

Eigen::Matrix4d placementOf(const Part& part, vtkPolyData* mesh)
{
  if (part.placement)
  {
    return *part.placement;
  }
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix(2, 3) = part.depth;
  if (part.box)
  {
    const Box from = rectangleOf(mesh);
    if (!((from.tail<2>() - from.head<2>()).minCoeff() > 0.0))
    {
      throw Failed(
        part.where + ": 'box' cannot be filled by a part that is flat in x or y; give a 'placement'");
    }
    matrix = oversketch::intoBox(from, *part.box, part.depth);
  }
  requirePlacement(part.where, part.box ? "box" : "depth", matrix);
  return matrix;
}

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
    if (!list.isArray() || list.size() > mostAreas)
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
