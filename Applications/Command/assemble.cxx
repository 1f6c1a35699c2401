#include "verbs.h"

#include "image_file.h"
#include "json_files.h"
#include "mesh_file.h"
#include "option_names.h"
#include "parts.h"
#include "report.h"
#include "terminal.h"

#include "vtkOversketchAssemble.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtk_jsoncpp.h"

#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

namespace
{

// The model that a source is, and what came of it.
struct Made
{
  std::string where; // the first part that is made of it
  Session session;
  vtkSmartPointer<vtkPolyData> mesh;
  Json::Value figures;
};
using Sources = std::map<PartSource, Made>;

// The files that are read.
std::vector<NamedFile> readBy(const Options& options, const std::vector<Part>& parts)
{
  std::vector<NamedFile> read = { { "the parts", options.session } };
  for (const Part& part : parts)
  {
    for (const auto& [what, path] : { std::pair("the drawing of ", part.source.drawing),
           std::pair("the picture of ", part.source.picture),
           std::pair("the picture of the back of ", part.source.back),
           std::pair("the mesh of ", part.source.mesh) })
    {
      if (!path.empty())
      {
        read.emplace_back(what + part.where, path);
      }
    }
  }
  return read;
}

// A session of a mesh alone, or of a step that makes one of a drawing.
Session sessionOfPart(const PartSource& source, Notes& notes)
{
  Session session;
  if (!source.mesh.empty())
  {
    session.mesh = readMesh(source.mesh, notes);
    return session;
  }
  auto step = std::make_shared<Step>();
  step->system = "InflateDrawing";
  step->values = source.values;
  step->inputs["Strokes"] = Lines(readStroke(source.drawing));
  for (const auto& [input, path] :
    { std::pair("Picture", source.picture), std::pair("BackPicture", source.back) })
  {
    if (!path.empty())
    {
      step->inputs[input] = readImage(path, SystemInput::Kind::Picture);
    }
  }
  session.nodes.emplace_back();
  session.nodes[0].id = 1;
  session.nodes[0].step = step;
  return session;
}

// Each source once, however many parts are made of it.
Sources sourcesOf(const std::vector<Part>& parts, Notes& notes)
{
  Sources sources;
  for (const Part& part : parts)
  {
    throwIfInterrupted();
    const auto [source, isNew] = sources.try_emplace(part.source);
    Made& made = source->second;
    if (!isNew)
    {
      continue;
    }
    made.where = part.where;
    try
    {
      made.session = sessionOfPart(part.source, notes);
    }
    catch (const Failed& failed)
    {
      throw Failed(part.where + ": " + failed.what());
    }
  }
  return sources;
}

// A model of each.
void runSources(Sources& sources)
{
  Evaluator evaluator;
  double done = 0.0;
  for (auto& [source, made] : sources)
  {
    const std::vector<Outcome> outcomes =
      outcomesOf(evaluator, made.session, done++, static_cast<double>(sources.size()));
    made.mesh = resultOf(made.session, outcomes);
    for (const Outcome& outcome : outcomes)
    {
      const SystemRow& system = *findSystem(made.session.nodes[0].step->system);
      for (const oversketch::Message& remark : outcome.remarks)
      {
        warn(made.where + ": " + inMembers(remark, system));
      }
      if (!outcome.failure.empty())
      {
        throw Failed(made.where + ": " + inMembers(outcome.failure, system));
      }
      addFigures(evaluator.system(system.name), made.figures);
    }
  }
}

// Names what the parts had and the whole has not.
void noteLost(const std::string& parts, const Sources& sources, vtkPolyData* whole, Notes& notes)
{
  std::set<std::string> lost;
  for (const auto& source : sources)
  {
    vtkPolyData* mesh = source.second.mesh;
    for (const auto& [from, to] :
      { std::pair<vtkFieldData*, vtkFieldData*>(mesh->GetPointData(), whole->GetPointData()),
        std::pair<vtkFieldData*, vtkFieldData*>(mesh->GetCellData(), whole->GetCellData()) })
    {
      for (int i = 0; i < from->GetNumberOfArrays(); ++i)
      {
        vtkAbstractArray* array = from->GetAbstractArray(i);
        if (array != mesh->GetPointData()->GetTCoords() && array->GetName() &&
            !to->HasArray(array->GetName()))
        {
          lost.insert(array->GetName());
        }
      }
    }
  }
  std::string names;
  for (const std::string& name : lost)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty())
  {
    notes.push_back(parts + ": normals, and arrays that only some parts have, are dropped: " + names);
  }
}

vtkSmartPointer<vtkPolyData> joined(const std::vector<Part>& parts, const Sources& sources)
{
  vtkNew<vtkOversketchAssemble> filter;
  for (const Part& part : parts)
  {
    vtkPolyData* mesh = sources.at(part.source).mesh;
    filter->AddInputDataObject(0, placedBy(placementOf(part, mesh), mesh));
  }
  vtkNew<vtkCallbackCommand> watch;
  watch->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* self = static_cast<vtkAlgorithm*>(caller);
      self->SetAbortExecute(interrupted());
      showProgress(self->GetProgress(), "Assemble");
    });
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  takeError();
  filter->Update();
  clearProgress();
  throwIfInterrupted();
  if (filter->GetErrorCode() != 0)
  {
    throw Failed(takeError());
  }
  return filter->GetOutput();
}

Json::Value jsonOf(const Part& part, const Made& made)
{
  Json::Value json = made.figures.isNull() ? Json::Value(Json::objectValue) : made.figures;
  for (const auto& [name, path] : { std::pair("drawing", part.source.drawing),
         std::pair("image", part.source.picture),
         std::pair("back_image", part.source.back),
         std::pair("mesh", part.source.mesh) })
  {
    if (!path.empty())
    {
      json[name] = path;
    }
  }
  const Eigen::Matrix4d matrix = placementOf(part, made.mesh);
  for (int i = 0; i < 16; ++i)
  {
    json["placement"].append(matrix(i / 4, i % 4));
  }
  json["after"] = countsOf(made.mesh);
  return json;
}

} // namespace

void assemble(const Options& options)
{
  Notes notes;
  Report report;
  const std::vector<Part> parts = readParts(options.session);
  requireOutputs(options, readBy(options, parts));
  Sources sources = sourcesOf(parts, notes);
  report.ends("read");
  say(notes);

  runSources(sources);
  const vtkSmartPointer<vtkPolyData> whole = joined(parts, sources);
  report.ends("run");
  noteLost(options.session, sources, whole, notes);

  NewFiles files;
  writeMesh(whole, options.output, notes, files);
  report.ends("write");
  if (!options.report.empty())
  {
    Json::Value list(Json::arrayValue);
    for (const Part& part : parts)
    {
      list.append(jsonOf(part, sources.at(part.source)));
    }
    files.writeText(options.report, report.assembledJson(options, list, whole));
  }
  throwIfInterrupted();
  files.commit();
  say(notes);
}

} // namespace oversketch_command
