// What --report writes.
#ifndef oversketch_applications_command_report_h
#define oversketch_applications_command_report_h

#include "options.h"

#include "vtk_jsoncpp_fwd.h"

#include <string>
#include <vector>

class vtkOversketchSystem;
class vtkPolyData;

namespace oversketch_command
{

struct Report
{
  double readMilliseconds = 0.0, runMilliseconds = 0.0, writeMilliseconds = 0.0;

  // JSON: files and options; times [ms]; all that was warned of; counts before (where there was a mesh) and
  // after; each field array of one value that a stage or the system put out; what ran where; and what
  // addFigures adds.
  std::string json(const Options& options,
    const oversketch_session::Step& step,
    vtkOversketchSystem* system,
    vtkPolyData* mesh,
    vtkPolyData* result) const;
  // JSON of an assembled mesh: files, times and warnings, what is told of each part, counts.
  std::string assembledJson(const Options& options, const Json::Value& parts, vtkPolyData* result) const;
};

// A figure; null where it could not be had.
Json::Value number(double value);
// Points and triangles.
Json::Value countsOf(vtkPolyData* mesh);
// How long each stage of the last run took [ms].
Json::Value stageTimes(vtkOversketchSystem* system);

// Of one stroke: the matched section with its distance and score [px] and lengths [model length]; the
// region's size; the handles' residuals [model length]; whether it was remeshed. Of an augmentation: pairs;
// faces after each stage; what GetFigure tells of it. Of an edit: gaps that curves were led over, points
// moved, edges folded, pairs of triangles that newly cross and the share of the ring that was seen.
void addFigures(vtkOversketchSystem* system, Json::Value& json);
// Before the run: what costs time and is counted for a report alone.
void askForFigures(vtkOversketchSystem* system);

} // namespace oversketch_command
#endif
