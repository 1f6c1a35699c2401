#include "verbs.h"

#include "mesh_file.h"
#include "models.h"
#include "session_file.h"
#include "terminal.h"

#include "vtkOversketchSystem.h"

#include <set>
#include <string>
#include <vector>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

namespace
{

struct Recorded
{
  Model model;
  Record record;
};
struct Replayed
{
  vtkSmartPointer<vtkPolyData> mesh; // null where no step makes one
  int backendUsed = 0;
};

// Those that are asked for.
std::vector<Recorded> modelsIn(const SessionFile& file, const Options& options)
{
  const std::size_t count = modelCount(file.session);
  if (static_cast<std::size_t>(options.model) > count)
  {
    throw Failed(options.session + ": has " + std::to_string(count) + (count == 1 ? " model" : " models") +
                 ", so there is no model " + std::to_string(options.model));
  }
  std::vector<Recorded> models;
  for (std::size_t place = 0, other = 0; place < count; ++place)
  {
    const bool isChosen = place == file.session.place;
    if (options.model == 0 || place + 1 == static_cast<std::size_t>(options.model))
    {
      models.push_back({ modelAt(file.session, place),
        isChosen ? Record{ file.origin, file.digest } : file.others.at(other) });
    }
    other += isChosen ? 0 : 1;
  }
  return models;
}

Replayed replay(Recorded recorded)
{
  Model& model = recorded.model;
  // On the same back end as then: what "auto" chose there may not be what it chooses here.
  if (!recorded.record.digest.empty())
  {
    model.backend =
      recorded.record.origin.backend == "opencl" ? vtkOversketchSystem::OpenCL : vtkOversketchSystem::Host;
  }
  const SharedData large = isMoved(model) ? takeProxy(model, mostTriangles) : SharedData();
  Evaluator evaluator;
  const std::vector<Outcome> outcomes = outcomesOf(evaluator, model);
  for (std::size_t i = 0; i < outcomes.size(); ++i)
  {
    if (!outcomes[i].failure.empty())
    {
      warn("'" + model.nodes[i].name + "' did nothing: " + outcomes[i].failure.text());
    }
    for (const oversketch::Message& remark : outcomes[i].remarks)
    {
      warn(remark.text());
    }
  }
  vtkSmartPointer<vtkPolyData> made = resultOf(model, outcomes);
  return { large ? movedAsProxy(large, made) : made, backendUsedBy(outcomes) };
}

} // namespace

void replay(const Options& options)
{
  requireOutputs(options, { { "the session", options.session } });
  const SessionFile file = readSession(options.session);
  const std::vector<Recorded> models = modelsIn(file, options);
  std::vector<Replayed> replayed;
  std::vector<vtkPolyData*> meshes;
  for (const Recorded& model : models)
  {
    replayed.push_back(replay(model));
    if (replayed.back().mesh)
    {
      meshes.push_back(replayed.back().mesh);
    }
  }
  if (meshes.empty())
  {
    throw Failed(options.session + ": none of its steps makes a mesh");
  }
  Notes notes;
  NewFiles files;
  writeMesh(oversketch_session::joined(meshes), options.output, notes, files);
  throwIfInterrupted();
  files.commit();
  say(notes);
  std::set<std::string> told;
  for (std::size_t i = 0; i < models.size(); ++i)
  {
    if (models[i].record.digest.empty() || !replayed[i].mesh)
    {
      continue; // saved before its first result: there is nothing to compare with
    }
    for (const std::string& difference :
      differences(models[i].record.origin, originHere(replayed[i].backendUsed)))
    {
      if (told.insert(difference).second)
      {
        say("note: " + difference);
      }
    }
    if (digestOf(replayed[i].mesh) != models[i].record.digest)
    {
      const std::string what =
        models.size() == 1 ? "the mesh" : "the mesh of '" + models[i].model.meshName + "'";
      warn(what + " is not bit for bit the one that was saved");
    }
  }
}

} // namespace oversketch_command
