#include "one_stroke.h"

#include "mesh_file.h"
#include "picture.h"
#include "report.h"
#include "terminal.h"

#include "vtkOversketchOneStroke.h"

#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkXMLPolyDataWriter.h"

#include <chrono>
#include <filesystem>

namespace oversketch_command
{

using namespace oversketch_files;

namespace
{

// Watches the system run: a progress line on a terminal, warnings, the first error, the interrupt.
class Watcher
{
public:
  explicit Watcher(vtkOversketchOneStroke* system)
    : System(system)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long event, void* self, void* data)
      { static_cast<Watcher*>(self)->See(event, data); });
    for (const unsigned long event :
      { vtkCommand::ProgressEvent, vtkCommand::WarningEvent, vtkCommand::ErrorEvent })
    {
      system->AddObserver(event, this->Command);
    }
  }
  ~Watcher()
  {
    clearProgress();
    this->System->RemoveObserver(this->Command);
  }

  std::string Error;

private:
  void See(unsigned long event, void* data)
  {
    if (event == vtkCommand::ProgressEvent)
    {
      if (interrupted())
      {
        this->System->AbortExecuteOn();
      }
      showProgress(*static_cast<double*>(data), this->System->GetStageName());
      return;
    }
    // "ERROR: In file, line n\nclass (address): message\n\n"
    std::string text = static_cast<const char*>(data);
    const std::size_t colon = text.find("): ");
    text.erase(0, colon == std::string::npos ? 0 : colon + 3);
    text.erase(text.find_last_not_of(" \n") + 1);
    if (event == vtkCommand::WarningEvent)
    {
      say("warning: " + text);
    }
    else if (this->Error.empty())
    {
      this->Error = text;
    }
  }

  vtkOversketchOneStroke* System;
  vtkNew<vtkCallbackCommand> Command;
};

void writeInner(vtkOversketchOneStroke* system, const std::string& folder)
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
    requireWritable(options.inner + "/Stroke.vtp");
  }
}

} // namespace

void oneStroke(const Options& options)
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
  const vtkSmartPointer<vtkPolyData> stroke = readStroke(options.stroke);
  const vtkSmartPointer<vtkPolyData> mesh = readMesh(options.mesh, notes);
  report.readMilliseconds = since(begin);
  say(notes);
  throwIfInterrupted();

  vtkNew<vtkOversketchOneStroke> system;
  system->SetInputData(mesh);
  system->SetStrokeData(stroke);
  system->SetBackend(options.backend);
  system->SetAsPublished(options.asPublished);
  system->SetRemesh(options.remesh);
  system->SetAdjustNormals(options.adjustNormals);
  begin = Clock::now();
  {
    Watcher watcher(system);
    system->Update();
    throwIfInterrupted();
    if (!watcher.Error.empty())
    {
      throw Failed(watcher.Error);
    }
  }
  report.runMilliseconds = since(begin);
  vtkPolyData* result = system->GetOutput();
  if (system->GetErrorCode() != vtkErrorCode::NoError || result->GetNumberOfPoints() == 0)
  {
    const std::string error = takeError();
    throw Failed(error.empty() ? "the deformation gave no mesh" : error);
  }

  begin = Clock::now();
  writeMesh(result, options.output, notes);
  report.writeMilliseconds = since(begin);
  say(notes);
  if (!options.inner.empty())
  {
    writeInner(system, options.inner);
  }
  if (!options.report.empty())
  {
    writeText(options.report, report.json(options, system, mesh, result));
  }
  if (!options.picture.empty())
  {
    writePicture(system, stroke, options.picture);
  }
}

} // namespace oversketch_command
