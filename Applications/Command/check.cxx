#include "verbs.h"

#include "mesh_file.h"
#include "print_colours.h"
#include "report.h"
#include "terminal.h"

#include "Print/print_facts.h"
#include "vtkOversketchPrintCheck.h"
#include "vtkOversketchStepRunner.h"

#include "vtkNew.h"
#include "vtk_jsoncpp.h"

#include <cstdio>

namespace oversketch_command
{

using namespace oversketch_files;

namespace
{

template <typename Place>
Json::Value placeJson(const Place& place)
{
  Json::Value json;
  for (int k = 0; k < 3; ++k)
  {
    json.append(place[k]);
  }
  return json;
}

// Lengths are millimetres.
Json::Value figuresOf(const oversketch::PrintCheck& found, double wall, double unit)
{
  Json::Value json;
  json["ready"] = found.isReady(wall);
  json["size"] = placeJson(unit * found.size);
  json["open_edges"] = found.openEdges;
  json["holes"] = found.holes;
  if (found.holes > 0)
  {
    json["largest_hole"]["length"] = unit * found.holeLength;
    json["largest_hole"]["place"] = placeJson(unit * found.holePlace);
  }
  json["turned_edges"] = found.turnedEdges;
  json["crowded_edges"] = found.crowdedEdges;
  for (const oversketch::PrintBody& body : found.bodies)
  {
    Json::Value one;
    one["faces"] = body.faces;
    one["volume"] = unit * unit * unit * body.volume;
    one["hollow"] = body.isHollow;
    one["inside_out"] = body.isInsideOut;
    json["bodies"].append(one);
  }
  json["crossing_pairs"] = found.crossings;
  json["wall"] = unit * wall;
  json["thin_area"] = unit * unit * found.thinArea(wall);
  json["least_wall"] = found.leastWall < 0.0 ? Json::Value() : Json::Value(unit * found.leastWall);
  return json;
}

} // namespace

bool check(const Options& options)
{
  Notes notes;
  Report report;
  requireOutputs(options, { { "the mesh", options.session } });
  const vtkSmartPointer<vtkPolyData> mesh = readMesh(options.session, notes);
  report.ends("read");
  const double wall =
    options.wallIsShare ? options.wall * mesh->GetLength() : options.wall / options.millimetres;
  vtkNew<vtkOversketchPrintCheck> filter;
  filter->SetInputData(mesh);
  filter->SetWall(wall);
  try
  {
    oversketch::StepRunner(filter, { [](double share) { showProgress(share, "Check"); }, {}, interrupted })
      .Run();
  }
  catch (const oversketch::Error&)
  {
    clearProgress();
    throwIfInterrupted();
    throw;
  }
  clearProgress();
  report.ends("run");
  const oversketch::PrintCheck& found = filter->Found();
  std::vector<std::string> words;
  for (const oversketch::PrintFact& fact : oversketch::printFacts(found, wall, options.millimetres))
  {
    words.push_back(fact.words.text());
  }
  NewFiles files;
  if (!options.output.empty())
  {
    writeMesh(colouredByWall(filter->GetOutput(), wall), options.output, notes, files);
    report.ends("write");
  }
  if (!options.report.empty())
  {
    Json::Value figures = figuresOf(found, wall, options.millimetres);
    for (const std::string& line : words)
    {
      figures["words"].append(line);
    }
    files.writeText(options.report, report.checkedJson(options, figures));
  }
  throwIfInterrupted();
  files.commit();
  say(notes);
  for (const std::string& line : words)
  {
    std::printf("%s\n", line.c_str());
  }
  return found.isReady(wall);
}

} // namespace oversketch_command
