#include "benchmark_frame.h"

#include "vtkOversketchFilterTools.h"

#include "vtkAbstractPolyDataReader.h"
#include "vtkLoopSubdivisionFilter.h"
#include "vtkMultiThreader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sstream>
#include <vector>

namespace oversketch_bench
{

namespace
{

std::string dataFolder;
std::vector<std::string> chosenSizes = { "5k", "30k", "180k", "1M" };

// What the runs of a side took [ms]; of sides in the order in which they were added.
struct Taken
{
  std::string job, size, who;
  std::vector<double> wall, processor;
  double limit = 0.0;
};
std::vector<Taken>& taken()
{
  static std::vector<Taken> all;
  return all;
}

double median(std::vector<double> values)
{
  std::nth_element(
    values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// Ours beside each other side of a job, by time and by time of the processor, which another load of the
// machine hardly moves.
void printRatios()
{
  std::printf("\nMedians of all runs [ms], in brackets of the processor; ours over theirs, alike.\n");
  for (const Taken& ours : taken())
  {
    if (ours.who != "ours" || ours.wall.empty())
    {
      continue;
    }
    const double wall = median(ours.wall), processor = median(ours.processor);
    std::printf("%s, %s: %.4g (%.4g)", ours.job.c_str(), ours.size.c_str(), wall, processor);
    if (ours.limit > 0.0)
    {
      std::printf("; limit %.4g: %.3g (%.3g)", ours.limit, wall / ours.limit, processor / ours.limit);
    }
    for (const Taken& theirs : taken())
    {
      if (theirs.job == ours.job && theirs.size == ours.size && theirs.who != "ours" && !theirs.wall.empty())
      {
        const double other = median(theirs.wall), otherProcessor = median(theirs.processor);
        std::printf("; %s %.4g (%.4g): %.3g (%.3g)",
          theirs.who.c_str(),
          other,
          otherProcessor,
          wall / other,
          processor / otherProcessor);
      }
    }
    std::printf("\n");
  }
}

vtkSmartPointer<vtkPolyData> readModel(const std::string& size)
{
  vtkSmartPointer<vtkAbstractPolyDataReader> reader;
  if (size == "5k")
    reader = vtkSmartPointer<vtkOBJReader>::New();
  else
    reader = vtkSmartPointer<vtkPLYReader>::New();
  const std::string path = dataFolder + "/bunny_" + size + (size == "5k" ? ".obj" : ".ply");
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetOutput()->GetNumberOfPolys() == 0)
  {
    std::fprintf(stderr, "Cannot read %s; give the folder of the bunnies with --data.\n", path.c_str());
    std::exit(1);
  }
  double box[6];
  reader->GetOutput()->GetBounds(box);
  const double scale = 1.0 / std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(reader->GetOutput()->GetPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    for (int k = 0; k < 3; ++k)
    {
      p[k] = scale * (p[k] - 0.5 * (box[2 * k] + box[2 * k + 1]));
    }
    points->SetPoint(i, p);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(reader->GetOutput()->GetPolys());
  return mesh;
}

} // namespace

const Model& model(const std::string& size)
{
  static std::map<std::string, Model> models;
  Model& made = models[size];
  if (!made.polyData)
  {
    if (size == "1M")
    {
      vtkNew<vtkLoopSubdivisionFilter> loop;
      loop->SetInputData(model("5k").polyData);
      loop->SetNumberOfSubdivisions(4);
      loop->Update();
      made.polyData = vtkSmartPointer<vtkPolyData>::New();
      made.polyData->SetPoints(loop->GetOutput()->GetPoints());
      made.polyData->SetPolys(loop->GetOutput()->GetPolys());
    }
    else
    {
      made.polyData = readModel(size);
    }
    made.mesh = MeshOf(made.polyData);
  }
  return made;
}

std::vector<std::string> sizes(const std::vector<std::string>& wanted)
{
  std::vector<std::string> both;
  for (const std::string& size : wanted)
  {
    if (std::find(chosenSizes.begin(), chosenSizes.end(), size) != chosenSizes.end())
    {
      both.push_back(size);
    }
  }
  return both;
}

void add(Job job)
{
  const std::string name = job.job + "/" + job.size + "/" + job.who;
  const std::size_t number = taken().size();
  taken().push_back({ job.job, job.size, job.who, {}, {}, 0.0 });
  benchmark::RegisterBenchmark(name.c_str(),
    [job = std::move(job), number](benchmark::State& state)
    {
      using Clock = std::chrono::steady_clock;
      for (auto _ : state)
      {
        if (job.prepare)
        {
          job.prepare();
        }
        const std::clock_t begin = std::clock();
        const Clock::time_point start = Clock::now();
        job.run();
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        state.SetIterationTime(seconds);
        taken()[number].wall.push_back(1000.0 * seconds);
        taken()[number].processor.push_back(
          1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
      }
      state.counters["threads"] = job.threads;
      for (const auto& [figure, value] : job.figures ? job.figures() : std::map<std::string, double>())
      {
        state.counters[figure] = value;
        taken()[number].limit = figure == "limit_ms" ? value : taken()[number].limit;
      }
    })
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
}

} // namespace oversketch_bench

int main(int argc, char** argv)
{
  using namespace oversketch_bench;
  // Medians of five repetitions, those of all sides at random in turn, so that what else the machine does
  // hits all alike. Later flags win, so the caller may ask for others.
  std::vector<std::string> words = { argv[0],
    "--benchmark_repetitions=5",
    "--benchmark_enable_random_interleaving=true",
    "--benchmark_min_time=0.2",
    "--benchmark_counters_tabular=true" };
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word.rfind("--data=", 0) == 0)
    {
      dataFolder = word.substr(7);
    }
    else if (word.rfind("--sizes=", 0) == 0)
    {
      chosenSizes.clear();
      std::istringstream list(word.substr(8));
      for (std::string size; std::getline(list, size, ',');)
      {
        chosenSizes.push_back(size);
      }
    }
    else
    {
      words.push_back(word);
    }
  }
  if (dataFolder.empty())
  {
    const char* folder = std::getenv("OVERSKETCH_DATA");
    dataFolder =
      (folder ? std::string(folder) : std::string(OVERSKETCH_SOURCE) + "/../shared/data") + "/meshes";
  }
  vtkSMPTools::Initialize(2);
  vtkMultiThreader::SetGlobalDefaultNumberOfThreads(2);
  jobs();
  std::vector<char*> arguments;
  arguments.reserve(words.size());
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
  {
    std::fprintf(
      stderr, "Besides those of Google Benchmark: --data=FOLDER (of the bunnies), --sizes=5k,30k,180k,1M\n");
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  printRatios();
  benchmark::Shutdown();
  return 0;
}
