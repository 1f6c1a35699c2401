#include "verbs.h"

#include "files.h"
#include "film.h"
#include "terminal.h"

#include <memory>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

namespace
{

Progress progressOf(const std::string& what)
{
  return { [what](double share) { showProgress(share, what); }, {}, interrupted };
}

} // namespace

void requireOutputs(const Options& options, std::vector<NamedFile> read, const std::vector<NamedFile>& inside)
{
  std::vector<NamedFile> written = {
    { "-o", options.output }, { "--report", options.report }, { "--picture", options.picture }
  };
  const std::vector<std::string> film =
    options.turntable.empty() ? std::vector<std::string>() : filmFiles(options.turntable, framesOfTurn);
  for (const std::string& path : film)
  {
    written.emplace_back("--turntable", path);
  }
  written.insert(written.end(), inside.begin(), inside.end());
  for (const auto& [what, path] : written)
  {
    if (path.empty())
    {
      continue;
    }
    for (const auto& [other, its] : read)
    {
      if (isSameFile(path, its) && !(what == "-o" && other == "the mesh"))
      {
        throw BadUse(what + " " + path + " would replace " + other);
      }
    }
    read.emplace_back(what, path);
  }
  for (const std::string* path : { &options.output, &options.picture, &options.report })
  {
    if (!path->empty())
    {
      requireWritable(*path);
    }
  }
  for (const std::string& path : film)
  {
    requireWritable(path);
  }
}

std::vector<Outcome> outcomesOf(Evaluator& evaluator, const Model& model, double done, double all)
{
  const auto count = static_cast<double>(model.nodes.size());
  Evaluator::Watch watch;
  watch.cancelled = interrupted;
  watch.progress = [=](std::size_t node, const std::string& stage, double share)
  { showProgress((done + (static_cast<double>(node) + share) / count) / all, stage); };
  std::vector<Outcome> outcomes;
  evaluator.run(model, watch, outcomes);
  clearProgress();
  throwIfInterrupted();
  return outcomes;
}

SharedData takeProxy(Model& model, vtkIdType most)
{
  if (!isLarge(model.mesh, most))
  {
    return {};
  }
  const SharedData mesh = model.mesh;
  model.mesh = proxyOf(mesh, progressOf("Proxy"), most);
  throwIfInterrupted();
  say("the mesh has " + std::to_string(mesh->GetNumberOfPolys()) + " triangles; it is moved as a proxy of " +
      std::to_string(model.mesh->GetNumberOfPolys()) + " is");
  return mesh;
}

vtkSmartPointer<vtkPolyData> movedAsProxy(vtkPolyData* mesh, vtkPolyData* proxyNow)
{
  vtkSmartPointer<vtkPolyData> moved = exactOf(mesh, proxyNow, progressOf("DetailTransfer"));
  clearProgress();
  throwIfInterrupted();
  return moved;
}

} // namespace oversketch_command
