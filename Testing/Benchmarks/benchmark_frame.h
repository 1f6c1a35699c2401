// The frame of the benchmark programs: models by size, jobs with interleaved repetitions, one main. A program
// defines jobs() and links the frame; `run.sh` runs them all and makes the table.
#ifndef oversketch_testing_benchmarks_benchmark_frame_h
#define oversketch_testing_benchmarks_benchmark_frame_h

#include "Mesh/mesh.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace oversketch_bench
{

using namespace oversketch;

// One side of one comparison. It appears as "job/size/who".
struct Job
{
  std::string job;
  std::string size;              // "30k", or what else the job scales with
  std::string who;               // "ours", "limit" or the name of a peer
  int threads = 2;               // that this side uses
  std::function<void()> prepare; // untimed, before each run; may be empty
  std::function<void()> run;     // timed
  // Figures to show beside the time, asked for after the last run; may be empty.
  std::function<std::map<std::string, double>()> figures;
};

void add(Job job);

// The bunny, closed, its bounding box's middle at the origin and its diagonal 1, points in double precision.
// Sizes 5k, 30k and 180k are read from the data folder; 1M is the 5k one after four Loop steps (1.28 million
// triangles). Kept after the first call.
struct Model
{
  Mesh mesh;
  vtkSmartPointer<vtkPolyData> polyData; // points and polygons alone
};
const Model& model(const std::string& size);

// Of the wanted sizes those that this run was asked for.
std::vector<std::string> sizes(const std::vector<std::string>& wanted);

// Defined by each program: adds its jobs. Set-up of a job belongs into its first prepare or run, so that a
// filtered run does not pay for all.
void jobs();

} // namespace oversketch_bench
#endif
