#include "verbs.h"

#include "image_file.h"
#include "json_files.h"
#include "mesh_file.h"
#include "models.h"
#include "option_names.h"
#include "option_values.h"
#include "picture.h"
#include "report.h"
#include "terminal.h"

#include "vtkOversketchSystem.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkXMLImageDataWriter.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <sstream>
#include <vector>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

namespace
{

// An image that a step puts out beside its first output, null where that is no image.
vtkImageData* innerImage(vtkOversketchSystem* system, const char* stage)
{
  vtkAlgorithm* step = system->GetStep(stage);
  return step->GetNumberOfOutputPorts() > 1 ? vtkImageData::SafeDownCast(step->GetOutputDataObject(1))
                                            : nullptr;
}

// The files of a step: its lines or mesh, and its image where it makes one.
std::vector<std::string> innerPaths(const Options& options, vtkOversketchSystem* system, const char* stage)
{
  const std::string path = options.inner + "/" + stage;
  std::vector<std::string> paths = { path + ".vtp" };
  if (innerImage(system, stage))
  {
    paths.push_back(path + ".vti");
  }
  return paths;
}

void writeInner(const Options& options, vtkOversketchSystem* system, NewFiles& files)
{
  for (int i = 0; i < system->GetNumberOfInnerOutputs(); ++i)
  {
    const char* name = system->GetInnerOutputName(i);
    const std::vector<std::string> paths = innerPaths(options, system, name);
    vtkPolyData* inner = system->GetInnerOutput(name);
    if (inner && inner->GetNumberOfPoints() > 0)
    {
      Notes none;
      writeMesh(inner, paths[0], none, files);
    }
    vtkImageData* image = innerImage(system, name);
    if (image && image->GetNumberOfPoints() > 0)
    {
      files.write(paths[1],
        [&](const std::string& temporary)
        {
          vtkNew<vtkXMLImageDataWriter> writer;
          writer->SetInputData(image);
          writer->SetFileName(temporary.c_str());
          if (!writer->Write() || !takeError().empty())
          {
            throw Failed(paths[1] + ": could not be written (is the disk full?)");
          }
        });
    }
  }
}

// Everything that can be known to fail is looked at before the work.
void checkOutputs(const Options& options, vtkOversketchSystem* system)
{
  std::vector<NamedFile> read, inner;
  for (const SystemInput& input : options.system->inputs)
  {
    const std::string& path = options.inputs.at(input.name);
    if (!path.empty() && !isPlaces(input, path))
    {
      read.emplace_back(input.kind == SystemInput::Kind::Mesh ? "the mesh" : "the " + input.word, path);
    }
  }
  for (const auto& named : options.textFiles)
  {
    if (!named.second.empty())
    {
      read.emplace_back("the " + findParameter(*options.system, named.first)->word, named.second);
    }
  }
  for (int i = 0; !options.inner.empty() && i < system->GetNumberOfInnerOutputs(); ++i)
  {
    for (const std::string& path : innerPaths(options, system, system->GetInnerOutputName(i)))
    {
      inner.emplace_back("--inner:", path);
    }
  }
  requireOutputs(options, read, inner);
  if (!options.picture.empty() || !options.turntable.empty())
  {
    const SystemInput* stroke = findInput(*options.system, SystemInput::Kind::Stroke);
    if (options.inputs.at(stroke->name).empty())
    {
      throw Failed("--picture is taken from the view of a stroke, and there is none; give --" + stroke->word);
    }
    requireDisplay();
  }
  if (!options.inner.empty())
  {
    std::error_code error;
    std::filesystem::create_directories(options.inner, error);
    if (!std::filesystem::is_directory(options.inner, error))
    {
      throw Failed(options.inner + ": is no folder and could not be made one");
    }
    for (const NamedFile& file : inner)
    {
      requireWritable(file.second);
    }
  }
}

// The lengths that were given as shares of the mesh's size.
void multiplyShares(const Options& options, vtkPolyData* mesh, Values& values)
{
  for (const std::string& property : options.shares)
  {
    double& value = std::get<double>(values.at(property));
    value *= mesh->GetLength();
  }
}

// A line of places that the command line gave.
vtkSmartPointer<vtkPolyData> lineOf(const std::vector<std::array<double, 2>>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(places.size()));
  for (const auto& [x, y] : places)
  {
    lines->InsertCellPoint(points->InsertNextPoint(x, y, 0.0));
  }
  auto line = vtkSmartPointer<vtkPolyData>::New();
  line->SetPoints(points);
  line->SetLines(lines);
  return line;
}

// Adds phrases to texts, with shares of the mesh's size as lengths.
void addPhrases(const Options& options, vtkPolyData* mesh, Values& values)
{
  for (const Options::Added& added : options.added)
  {
    std::ostringstream phrase;
    phrase.imbue(std::locale::classic());
    phrase.precision(17);
    for (std::size_t i = 0; i < added.words.size(); ++i)
    {
      phrase << (i > 0 ? " " : "");
      if (added.shares.count(i) > 0)
      {
        phrase << 0.01 * std::strtod(added.words[i].c_str(), nullptr) * mesh->GetLength();
      }
      else
      {
        phrase << added.words[i];
      }
    }
    const auto [text, isNew] = values.emplace(added.property, std::string());
    std::string& all = std::get<std::string>(text->second);
    all += (all.empty() ? "" : "; ") + phrase.str();
  }
}

// All strokes of a step, in the order of its inputs, that say the view that they were drawn in; without any
// the outlines that were traced in their place.
vtkSmartPointer<vtkPolyData> strokesOf(const Options& options, const Step& step, vtkOversketchSystem* system)
{
  vtkNew<vtkAppendPolyData> all;
  all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const SystemInput& input : options.system->inputs)
  {
    const auto lines = input.kind == SystemInput::Kind::Stroke ? linesOf(step, input.name) : nullptr;
    if (lines && lines->GetCellData()->HasArray("ViewTransform"))
    {
      all->AddInputData(lines);
    }
  }
  vtkPolyData* traced = system->GetInnerOutput("Trace");
  if (all->GetNumberOfInputConnections(0) == 0 && traced)
  {
    return traced;
  }
  all->Update();
  return all->GetNumberOfInputConnections(0) == 1 ? vtkPolyData::SafeDownCast(all->GetInputDataObject(0, 0))
                                                  : all->GetOutput();
}

// An array that strokes have themselves holds for them, whatever an option says.
void tellUnused(const Options& options, const std::string& path, vtkPolyData* lines)
{
  for (const Parameter& parameter : options.system->parameters)
  {
    if (std::holds_alternative<double>(parameter.initial) && options.values.count(parameter.property) > 0 &&
        lines->GetCellData()->HasArray(parameter.property.c_str()))
    {
      warn("--" + parameter.word + " is not used: each stroke of " + path +
           " has its own, in the cell array " + parameter.property);
    }
  }
}

// Options that have no effect, since what they act on is not given.
void tellIdle(const Step& step, const SystemRow& system)
{
  for (const Parameter& parameter : system.parameters)
  {
    const auto value = step.values.find(parameter.property);
    if (!parameter.actsWith.empty() && value != step.values.end() && value->second != parameter.initial &&
        step.inputs.count(parameter.actsWith) == 0)
    {
      warn("--" + parameter.word + " does nothing without --" + findInput(system, parameter.actsWith)->word);
    }
  }
}

bool isSameMesh(vtkPolyData* mesh, vtkPolyData* other)
{
  const auto one = vtk::DataArrayValueRange<3>(mesh->GetPoints()->GetData());
  const auto two = vtk::DataArrayValueRange<3>(other->GetPoints()->GetData());
  return mesh->GetNumberOfPolys() == other->GetNumberOfPolys() &&
         std::equal(one.begin(), one.end(), two.begin(), two.end());
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
    if (isPlaces(input, path))
    {
      step->inputs[input.name] = Lines(lineOf(placesOf("--" + input.word, path)));
    }
    else if (!path.empty() && isImage(input.kind))
    {
      step->inputs[input.name] = readImage(path, input.kind);
    }
    else if (!path.empty() && input.kind != SystemInput::Kind::Mesh)
    {
      const auto lines = readStroke(path);
      tellUnused(options, path, lines);
      step->inputs[input.name] = Lines(lines);
    }
  }
  for (const auto& [property, path] : options.textFiles)
  {
    if (!path.empty())
    {
      readLayers(path, *step);
    }
  }
  tellIdle(*step, *options.system);
  if (const SystemInput* input = findInput(*options.system, SystemInput::Kind::Mesh))
  {
    session.mesh = readMesh(options.inputs.at(input->name), notes);
    for (const SystemInput& further : options.system->inputs)
    {
      const std::string& path = options.inputs.at(further.name);
      if (further.kind == SystemInput::Kind::Mesh && further.optional && !path.empty())
      {
        const auto other = readMesh(path, notes);
        session.mesh = oversketch_session::joined(
          std::vector<vtkPolyData*>{ session.mesh.Get(), other.Get() }); // a step holds no mesh
      }
    }
    multiplyShares(options, session.mesh.Get(), step->values);
    addPhrases(options, session.mesh.Get(), step->values);
  }
  Node node;
  node.id = 1;
  node.step = step;
  session.nodes = { node };
  return session;
}

// A proxy cannot hand on triangles that a step makes, nor bumps that it does not have.
void refuseLarge(const Options& options, const Session& session)
{
  if (isLarge(session.mesh, options.proxyAbove) && !isMoved(session))
  {
    const std::string count = std::to_string(session.mesh->GetNumberOfPolys());
    throw Failed("the mesh has " + count + " triangles, too many for " + options.system->verb +
                 ", which no coarse one in its place is enough for; give a coarser mesh, or --proxy-above " +
                 count + " where memory is enough");
  }
}

} // namespace

void runSystem(const Options& options)
{
  Evaluator evaluator;
  vtkOversketchSystem* const system = evaluator.system(options.system->name);
  checkOutputs(options, system);

  Notes notes;
  Report report;
  Session session = sessionOf(options, notes);
  report.ends("read");
  say(notes);
  throwIfInterrupted();
  refuseLarge(options, session);
  const SharedData large = takeProxy(session, options.proxyAbove);
  vtkPolyData* const mesh = large ? large : session.mesh;

  const Outcome outcome = outcomesOf(evaluator, session)[0];
  report.ends("run");
  for (const oversketch::Message& remark : outcome.remarks)
  {
    warn(inOptions(remark, *options.system));
  }
  if (!outcome.failure.empty())
  {
    throw Failed(inOptions(outcome.failure, *options.system));
  }
  const vtkSmartPointer<vtkPolyData> made = large ? movedAsProxy(large, outcome.mesh) : outcome.mesh;
  if (large)
  {
    report.ends("transfer");
  }
  if (mesh && isSameMesh(mesh, made)) // so that nothing is left as it was in silence
  {
    warn("nothing has moved, the mesh is written as it was; oversketch " + options.system->verb +
         " --help lists what moves it");
  }

  NewFiles files;
  writeMesh(made, options.output, notes, files);
  report.ends("write");
  if (!options.inner.empty())
  {
    writeInner(options, system, files);
  }
  if (!options.report.empty())
  {
    vtkPolyData* const proxy = large ? session.mesh.Get() : nullptr;
    files.writeText(options.report, report.json(options, *session.nodes[0].step, system, mesh, proxy, made));
  }
  if (!options.picture.empty())
  {
    writePicture(
      *options.system, system, strokesOf(options, *session.nodes[0].step, system), options.picture, files);
  }
  if (!options.turntable.empty())
  {
    writeTurntable(system, strokesOf(options, *session.nodes[0].step, system), options.turntable, files);
  }
  throwIfInterrupted();
  files.commit();
  say(notes);
}

} // namespace oversketch_command
