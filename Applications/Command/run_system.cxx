#include "run_system.h"

#include "evaluator.h"
#include "mesh_file.h"
#include "picture.h"
#include "report.h"
#include "terminal.h"
#include "texture.h"

#include "vtkOversketchSystem.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

namespace
{

void writeInner(vtkOversketchSystem* system, const std::string& folder)
{
  for (int i = 0; i < system->GetNumberOfInnerOutputs(); ++i)
  {
    const char* name = system->GetInnerOutputName(i);
    vtkPolyData* inner = system->GetInnerOutput(name);
    if (inner && inner->GetNumberOfPoints() > 0)
    {
      Notes none;
      writeMesh(inner, folder + "/" + name + ".vtp", none);
    }
  }
}

// Everything that can be known to fail is looked at before the work.
void checkOutputs(const Options& options)
{
  for (const std::string* path : { &options.output, &options.picture, &options.report })
  {
    if (!path->empty())
    {
      requireWritable(*path);
    }
  }
  if (!options.picture.empty())
  {
    requireDisplay();
  }
  if (!options.inner.empty())
  {
    std::error_code error;
    std::filesystem::create_directories(options.inner, error);
    if (!std::filesystem::is_directory(options.inner))
    {
      throw Failed(options.inner + ": is no folder and could not be made one");
    }
    requireWritable(options.inner + "/inner.vtp");
  }
}

Image readPicture(const std::string& path)
{
  requireReadable(path);
  std::ifstream stream(path, std::ios::binary);
  const Image image{ std::filesystem::path(path).filename().string(),
    std::make_shared<const std::string>(
      std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()) };
  if (!pictureOf(*image.bytes))
  {
    throw Failed(path + ": is no PNG or JPEG picture, or a damaged one");
  }
  return image;
}

// One step on the mesh that is given, if the system takes one.
Session sessionOf(const Options& options, Notes& notes)
{
  auto step = std::make_shared<Step>();
  step->system = options.system->name;
  step->values = options.values;
  Session session;
  session.backend = options.backend;
  // The mesh last: it is the largest, and what is wrong with the others is told at once.
  for (const SystemInput& input : options.system->inputs)
  {
    const std::string& path = options.inputs.at(input.name);
    if (!path.empty() && input.kind == SystemInput::Kind::Picture)
    {
      step->inputs[input.name] = readPicture(path);
    }
    else if (!path.empty() && input.kind != SystemInput::Kind::Mesh)
    {
      step->inputs[input.name] = Lines(readStroke(path));
    }
  }
  if (const SystemInput* input = findInput(*options.system, SystemInput::Kind::Mesh))
  {
    session.mesh = readMesh(options.inputs.at(input->name), notes);
  }
  Node node;
  node.id = 1;
  node.step = step;
  session.nodes = { node };
  return session;
}

} // namespace

void runSystem(const Options& options)
{
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point begin)
  { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); };
  catchInterrupt();
  catchMessages();
  checkOutputs(options);

  Notes notes;
  Report report;
  auto begin = Clock::now();
  const Session session = sessionOf(options, notes);
  report.readMilliseconds = since(begin);
  say(notes);
  throwIfInterrupted();

  Evaluator evaluator;
  Evaluator::Watch watch;
  watch.cancelled = interrupted;
  watch.progress = [](std::size_t, const std::string& stage, double share) { showProgress(share, stage); };
  watch.warning = [](std::size_t, const std::string& message) { say("warning: " + message); };
  std::vector<Outcome> outcomes;
  begin = Clock::now();
  evaluator.run(session, watch, outcomes);
  report.runMilliseconds = since(begin);
  clearProgress();
  throwIfInterrupted();
  if (!outcomes[0].failure.empty())
  {
    throw Failed(outcomes[0].failure);
  }

  begin = Clock::now();
  writeMesh(outcomes[0].mesh, options.output, notes);
  report.writeMilliseconds = since(begin);
  say(notes);
  vtkOversketchSystem* system = evaluator.system(options.system->name);
  if (!options.inner.empty())
  {
    writeInner(system, options.inner);
  }
  if (!options.report.empty())
  {
    writeText(options.report, report.json(options, system, session.mesh, outcomes[0].mesh));
  }
  if (!options.picture.empty())
  {
    const SystemInput* drawn = findInput(*options.system, SystemInput::Kind::Stroke);
    writePicture(system, linesOf(*session.nodes[0].step, drawn->name), options.picture);
  }
}

} // namespace oversketch_command
