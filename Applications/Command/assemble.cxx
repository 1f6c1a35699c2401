#include "assemble.h"

#include "evaluator.h"
#include "mesh_file.h"
#include "option_names.h"
#include "parts.h"
#include "parts_file.h"
#include "report.h"
#include "run_system.h"
#include "terminal.h"

#include "vtkOversketchAssemble.h"
#include "vtkOversketchSystem.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtk_jsoncpp.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

namespace
{

// What a source was read as: a mesh, or a step that makes one; and what it is in the end.
struct Made
{
  std::string where; // the first part that is made of it
  std::shared_ptr<const Step> step;
  vtkSmartPointer<vtkPolyData> mesh;
  Json::Value figures;
};
using Sources = std::map<PartSource, Made>;

// Throws BadUse where a file would be replaced that is read, or written as well.
void requireApart(const Options& options, const std::vector<Part>& parts)
{
  std::vector<std::pair<std::string, std::string>> taken = { { "the parts", options.session } };
  for (const Part& part : parts)
  {
    for (const auto& [what, path] : { std::pair("the drawing of ", part.source.drawing),
           std::pair("the picture of ", part.source.picture),
           std::pair("the picture of the back of ", part.source.back),
           std::pair("the mesh of ", part.source.mesh) })
    {
      if (!path.empty())
      {
        taken.emplace_back(what + part.where, path);
      }
    }
  }
  for (const auto& [what, path] : { std::pair("-o", options.output), std::pair("--report", options.report) })
  {
    for (const auto& [other, its] : taken)
    {
      if (!path.empty() && isSameFile(path, its))
      {
        std::ostringstream message;
        message << what << ' ' << path << " would replace " << other;
        throw BadUse(message.str());
      }
    }
    taken.emplace_back(what, path);
  }
}

std::shared_ptr<const Step> stepOf(const PartSource& source)
{
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
  return step;
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
      if (part.source.mesh.empty())
      {
        made.step = stepOf(part.source);
      }
      else
      {
        made.mesh = readMesh(part.source.mesh, notes);
      }
    }
    catch (const Failed& failed)
    {
      throw Failed(part.where + ": " + failed.what());
    }
  }
  return sources;
}

// A model of each drawing.
void runDrawings(Sources& sources)
{
  Evaluator evaluator;
  double done = 0.0;
  for (auto& [source, made] : sources)
  {
    if (made.step)
    {
      Evaluator::Watch watch;
      watch.cancelled = interrupted;
      watch.progress = [&, count = static_cast<double>(sources.size())](
                         std::size_t, const std::string& stage, double share)
      { showProgress((done + share) / count, stage); };
      const SystemRow& system = *findSystem(made.step->system);
      Session session;
      session.nodes.emplace_back();
      session.nodes[0].id = 1;
      session.nodes[0].step = made.step;
      std::vector<Outcome> outcomes;
      evaluator.run(session, watch, outcomes);
      throwIfInterrupted();
      for (const oversketch::Message& remark : outcomes[0].remarks)
      {
        warn(made.where + ": " + inMembers(remark, system));
      }
      if (!outcomes[0].failure.empty())
      {
        throw Failed(made.where + ": " + inMembers(outcomes[0].failure, system));
      }
      made.mesh = outcomes[0].mesh;
      vtkOversketchSystem* const ran = evaluator.system(made.step->system);
      made.figures["stage_milliseconds"] = stageTimes(ran);
      addFigures(ran, made.figures);
    }
    done += 1.0;
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
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point begin)
  { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); };
  catchSignals();
  catchMessages();
  Notes notes;
  Report report;
  auto begin = Clock::now();
  const std::vector<Part> parts = readParts(options.session);
  requireApart(options, parts);
  for (const std::string* path : { &options.output, &options.report })
  {
    if (!path->empty())
    {
      requireWritable(*path);
    }
  }
  Sources sources = sourcesOf(parts, notes);
  report.readMilliseconds = since(begin);
  say(notes);

  begin = Clock::now();
  runDrawings(sources);
  const vtkSmartPointer<vtkPolyData> whole = joined(parts, sources);
  report.runMilliseconds = since(begin);
  noteLost(options.session, sources, whole, notes);

  begin = Clock::now();
  NewFiles files;
  writeMesh(whole, options.output, notes, files);
  report.writeMilliseconds = since(begin);
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
