// System A whole: one stroke, shape diameter known; and the stroke after it, on the mesh that the first one
// made.
#include "bunny_stroke.h"

#include "vtkOversketchOneStroke.h"
#include "vtkOversketchShapeDiameter.h"

#include "vtkNew.h"
#include "vtkPointData.h"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace oversketch_bench
{

namespace
{

// Points of the region.
double pointsOf(vtkPolyData* mesh)
{
  vtkDataArray* region = mesh->GetPointData()->GetArray("Region");
  double count = 0.0;
  for (vtkIdType i = 0; region && i < mesh->GetNumberOfPoints(); ++i)
  {
    count += region->GetComponent(i, 0) != 0.0;
  }
  return count;
}

struct Session
{
  void open(const std::string& size, int remesh)
  {
    if (this->first)
    {
      return;
    }
    this->first = vtkSmartPointer<vtkOversketchOneStroke>::New();
    this->next = vtkSmartPointer<vtkOversketchOneStroke>::New();
    this->mesh = model(size).polyData;
    for (int i = 0; i < 2; ++i)
    {
      this->strokes[i] = earStroke(this->mesh, i == 0 ? 25.0 : 30.0);
      this->first->SetRemesh(remesh);
      this->first->SetInputData(0, this->mesh);
      this->first->SetStrokeData(this->strokes[i]);
      this->update(this->first);
      this->made[i] = vtkSmartPointer<vtkPolyData>::New();
      this->made[i]->ShallowCopy(this->first->GetOutput());
    }
    this->next->SetRemesh(remesh);
    this->next->SetStrokeData(earStroke(this->made[0], -15.0));
  }

  static void update(vtkOversketchOneStroke* system)
  {
    system->Update();
    if (system->GetOutput()->GetNumberOfPolys() == 0)
    {
      std::fprintf(stderr, "The stroke failed.\n");
      std::exit(1);
    }
  }

  vtkSmartPointer<vtkPolyData> mesh;
  std::array<vtkSmartPointer<vtkPolyData>, 2> strokes, made;
  vtkSmartPointer<vtkOversketchOneStroke> first, next;
  int nextStroke = 0, nextMesh = 0; // whose turn it is
};

void session(const std::string& size, const std::string& kind, int remesh)
{
  auto state = std::make_shared<Session>();
  const auto stages = [state](vtkOversketchOneStroke* system)
  {
    std::map<std::string, double> figures;
    for (int i = 0; i < system->GetNumberOfInnerOutputs(); ++i)
    {
      const char* name = system->GetInnerOutputName(i);
      figures[std::string(name) + "_ms"] = 1000.0 * system->GetStageTime(name);
    }
    // Deform stands for all deformations among the inner outputs; each took its own time.
    for (const char* name :
      { "DeformCorrected", "DeformRemeshed", "CorrectionRemeshed", "DeformRemeshedCorrected" })
    {
      figures[std::string(name) + "_ms"] = 1000.0 * system->GetStageTime(name);
    }
    auto* diameter = vtkOversketchShapeDiameter::SafeDownCast(system->GetStep("ShapeDiameter"));
    figures["rays_a_point"] = static_cast<double>(diameter->GetTracedRayCount()) /
                              static_cast<double>(system->GetOutput()->GetNumberOfPoints());
    figures["triangles"] = static_cast<double>(system->GetOutput()->GetNumberOfPolys());
    vtkPolyData* found = system->GetInnerOutput("RegionBorder");
    figures["region_points"] = pointsOf(found);
    figures["region_triangles"] = 2.0 * pointsOf(found); // a closed surface has two a vertex
    figures["stretched_triangles"] = 2.0 * pointsOf(system->GetInnerOutput("Stretch"));
    return figures;
  };
  Job job;
  job.size = size;
  job.who = "ours";
  // Two strokes in turn over one mesh: another region, section and target each time; the shape diameter
  // stays.
  job.job = "one stroke" + kind;
  job.prepare = [=]
  {
    state->open(size, remesh);
    state->first->SetStrokeData(state->strokes[++state->nextStroke % 2]);
  };
  job.run = [state] { Session::update(state->first); };
  job.figures = [=] { return stages(state->first); };
  add(job);
  // Two meshes in turn that differ where a stroke changed them.
  job.job = "next stroke" + kind;
  job.prepare = [=]
  {
    state->open(size, remesh);
    state->next->SetInputData(0, state->made[++state->nextMesh % 2]);
  };
  job.run = [state] { Session::update(state->next); };
  job.figures = [=] { return stages(state->next); };
  add(job);
}

} // namespace

void jobs()
{
  for (const std::string& size : sizes({ "5k", "30k", "180k", "1M" }))
  {
    session(size, "", vtkOversketchOneStroke::RemeshOn);
    session(size, ", not remeshed", vtkOversketchOneStroke::RemeshOff);
  }
}

} // namespace oversketch_bench
