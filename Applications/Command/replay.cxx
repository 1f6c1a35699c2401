#include "replay.h"

#include "evaluator.h"
#include "mesh_file.h"
#include "session_file.h"
#include "terminal.h"

#include "vtkOversketchSystem.h"

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

void replay(const Options& options)
{
  catchSignals();
  catchMessages();
  if (isSameFile(options.output, options.session))
  {
    throw BadUse("-o " + options.output + " would replace the session");
  }
  requireWritable(options.output);
  SessionFile file = readSession(options.session);
  Session& session = file.session;
  // On the same back end as then: what "auto" chose there may not be what it chooses here.
  if (!file.digest.empty())
  {
    session.backend =
      file.origin.backend == "opencl" ? vtkOversketchSystem::OpenCL : vtkOversketchSystem::Host;
  }
  const double count = static_cast<double>(session.nodes.size());
  Evaluator evaluator;
  Evaluator::Watch watch;
  watch.cancelled = interrupted;
  watch.warning = [&](std::size_t, const std::string& message) { warn(message); };
  watch.progress = [&](std::size_t node, const std::string& stage, double share)
  { showProgress((static_cast<double>(node) + share) / count, stage); };
  std::vector<Outcome> outcomes;
  evaluator.run(session, watch, outcomes);
  clearProgress();
  throwIfInterrupted();
  for (std::size_t i = 0; i < outcomes.size(); ++i)
  {
    if (!outcomes[i].failure.empty())
    {
      warn("'" + session.nodes[i].name + "' did nothing: " + outcomes[i].failure);
    }
  }
  vtkPolyData* result = resultOf(session, outcomes);
  if (!result)
  {
    throw Failed(options.session + ": none of its steps makes a mesh");
  }
  Notes notes;
  NewFiles files;
  writeMesh(result, options.output, notes, files);
  throwIfInterrupted();
  files.commit();
  say(notes);
  if (file.digest.empty())
  {
    return; // saved before its first result: there is nothing to compare with
  }
  for (const std::string& difference : differences(file.origin, originHere(backendUsedBy(outcomes))))
  {
    say("note: " + difference);
  }
  if (digestOf(result) != file.digest)
  {
    warn("the mesh is not bit for bit the one that was saved");
  }
}

} // namespace oversketch_command
