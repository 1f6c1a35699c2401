// The report that --report writes.
#ifndef oversketch_applications_command_report_h
#define oversketch_applications_command_report_h

#include "options.h"

#include "vtk_jsoncpp_fwd.h"

#include <chrono>
#include <map>
#include <string>

class vtkOversketchSystem;
class vtkPolyData;

namespace oversketch_command
{

class Report
{
public:
  // Takes the time since the last call, or since it was made, for a part of the work: "read", "run", "write".
  void ends(const std::string& part);

  // JSON: files and options; times [ms]; all that was warned of; counts before (where there was a mesh), of
  // its proxy where there was one, and after; each field array of one value that a stage or the system put
  // out; what ran where; and what addFigures adds.
  std::string json(const Options& options,
    const oversketch_session::Step& step,
    vtkOversketchSystem* system,
    vtkPolyData* mesh,
    vtkPolyData* proxy,
    vtkPolyData* result) const;
  // JSON of an assembled mesh: files, times and warnings, what is told of each part, counts.
  std::string assembledJson(const Options& options, const Json::Value& parts, vtkPolyData* result) const;
  // JSON of a check: files, times and warnings, and its figures.
  std::string checkedJson(const Options& options, const Json::Value& figures) const;

private:
  Json::Value beginning(const std::string& verb, const Options& options) const;

  std::chrono::steady_clock::time_point Begun = std::chrono::steady_clock::now();
  std::map<std::string, double> Milliseconds;
};

// Points and triangles.
Json::Value countsOf(vtkPolyData* mesh);
// Adds how long each stage of the last run took [ms], the faces that it made, and what the system tells of
// itself.
void addFigures(vtkOversketchSystem* system, Json::Value& json);

} // namespace oversketch_command
#endif
