// What --report writes.
#ifndef oversketch_command_report_h
#define oversketch_command_report_h

#include "options.h"

class vtkOversketchOneStroke;
class vtkPolyData;

namespace oversketch_command
{

struct Report
{
  double readMilliseconds = 0.0, runMilliseconds = 0.0, writeMilliseconds = 0.0;

  // JSON: files and options; times [ms]; counts before and after; the matched section with its distance and
  // score [px] and lengths [model length]; the region's size; the handles' residuals [model length]; what ran
  // where.
  std::string json(const Options& options,
    vtkOversketchOneStroke* system,
    vtkPolyData* mesh,
    vtkPolyData* result) const;
};

} // namespace oversketch_command
#endif
