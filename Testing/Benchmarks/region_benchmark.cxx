// Growing the region, its amendments, the junction cut and the border, all that follows once the evidence is
// known; what a mesh alone decides (adjacency, parts, areas) is kept, as the filters keep it. Limit: an
// allowance of 5 ns for each neighbour that growing (queue and count), the cut (distances and dual graph of
// its band) and the border have to look at once, given as the figure limit_ms.
#include "Harness/polydata.h"
#include "bunny_stroke.h"

#include "Region/border.h"
#include "Region/cut.h"
#include "Region/grow.h"

#include "vtkOversketchMatch.h"
#include "vtkOversketchMixtureRegion.h"
#include "vtkOversketchOutline.h"
#include "vtkOversketchShapeDiameter.h"
#include "vtkOversketchSilhouette.h"
#include "vtkOversketchSnake.h"
#include "vtkOversketchTargets.h"
#include "vtkOversketchVisibility.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace oversketch_bench
{

namespace
{

// The evidence of the ear's stroke, from the filters.
struct Case
{
  const Mesh& mesh;
  Adjacency adjacency;
  std::vector<Vector3> normals;
  MeshParts parts;
  RegionEvidence evidence;
  std::vector<char> isSeed, region;
  double visited = 0.0; // neighbours

  explicit Case(const std::string& size)
    : mesh(model(size).mesh)
    , adjacency(buildAdjacency(mesh))
    , normals(vertexNormals(mesh))
    , parts(findParts(mesh, adjacency))
    , isSeed(mesh.points.size(), 0)
  {
    vtkPolyData* body = model(size).polyData;
    const auto stroke = earStroke(body);
    vtkNew<vtkOversketchSilhouette> silhouette;
    vtkNew<vtkOversketchSnake> snake;
    vtkNew<vtkOversketchVisibility> visibility;
    vtkNew<vtkOversketchOutline> outline;
    vtkNew<vtkOversketchMatch> match;
    vtkNew<vtkOversketchTargets> targets;
    vtkNew<vtkOversketchShapeDiameter> diameter;
    vtkNew<vtkOversketchMixtureRegion> grown;
    silhouette->SetInputData(0, body);
    silhouette->SetInputData(1, stroke);
    snake->SetInputConnection(0, silhouette->GetOutputPort());
    snake->SetInputData(1, body);
    snake->SetInputData(2, stroke);
    visibility->SetInputConnection(0, snake->GetOutputPort());
    visibility->SetInputData(1, body);
    visibility->SetInputData(2, stroke);
    outline->SetInputData(0, body);
    outline->SetInputData(1, stroke);
    outline->SetInputConnection(2, visibility->GetOutputPort());
    match->AddInputConnection(0, visibility->GetOutputPort());
    match->AddInputConnection(0, outline->GetOutputPort());
    match->SetInputData(1, stroke);
    targets->SetInputConnection(0, match->GetOutputPort());
    targets->SetInputData(1, stroke);
    targets->SetInputData(2, body);
    diameter->SetInputData(0, body);
    grown->SetInputConnection(0, diameter->GetOutputPort());
    grown->SetInputConnection(1, targets->GetOutputPort());
    grown->Update();
    vtkPointData* found = grown->GetOutput()->GetPointData();
    for (int v = 0; v < this->mesh.vertexCount(); ++v)
    {
      const double p = found->GetArray("RegionProbability")->GetComponent(v, 0);
      this->evidence.ratio.push_back(std::log(std::max(p, 1e-300)) - std::log(std::max(1.0 - p, 1e-300)));
      this->evidence.diameter.push_back(found->GetArray("ShapeDiameter")->GetComponent(v, 0));
      if (found->GetArray("RegionSeed")->GetComponent(v, 0) != 0.0)
      {
        this->evidence.seeds.push_back(v);
        this->isSeed[v] = 1;
      }
    }
    this->evidence.sectionLength =
      targets->GetOutput()->GetFieldData()->GetArray("SectionLength")->GetComponent(0, 0);
    this->run();
    this->count();
  }

  void run()
  {
    this->region =
      detectRegion(this->mesh, this->adjacency, this->normals, this->parts, this->evidence, RegionOptions());
    this->region = smoothBorder(this->adjacency, this->isSeed, this->region, 2);
  }

  void count()
  {
    const Lists& around = this->adjacency.vertexVertices;
    std::vector<int> border;
    std::vector<double> thickness;
    for (int v = 0; v < this->mesh.vertexCount(); ++v)
    {
      const bool meets = std::any_of(
        around.begin(v), around.end(v), [&](int n) { return this->region[n] != this->region[v]; });
      // Queued and counted by growing, and classified by the border; of the ring outside, counted only.
      this->visited += this->region[v] ? 3.0 * around.size(v) : meets ? around.size(v) : 0.0;
      if (meets && this->region[v])
      {
        border.push_back(v);
        thickness.push_back(this->evidence.diameter[v]);
      }
    }
    std::nth_element(thickness.begin(), thickness.begin() + thickness.size() / 2, thickness.end());
    const std::vector<double> distance =
      edgeDistances(this->mesh, this->adjacency, border, 1.25 * thickness[thickness.size() / 2]);
    for (int v = 0; v < this->mesh.vertexCount(); ++v)
    {
      this->visited += std::isfinite(distance[v]) ? around.size(v) : 0.0;
    }
    for (const Triangle& t : this->mesh.triangles)
    {
      this->visited +=
        std::any_of(t.begin(), t.end(), [&](int v) { return std::isfinite(distance[v]); }) ? 3.0 : 0.0;
    }
  }
};

void region(const std::string& size)
{
  auto state = std::make_shared<std::unique_ptr<Case>>();
  const auto open = [=]
  {
    if (!*state)
    {
      *state = std::make_unique<Case>(size);
    }
  };
  Job job;
  job.job = "region and border";
  job.size = size;
  job.threads = 1;
  job.prepare = open;
  job.figures = [state]
  {
    return std::map<std::string, double>{ { "visited", (*state)->visited },
      { "limit_ms", 5e-6 * (*state)->visited },
      { "region", double(std::count((*state)->region.begin(), (*state)->region.end(), 1)) } };
  };
  job.who = "ours";
  job.run = [state] { (*state)->run(); };
  add(job);
}

} // namespace

void jobs()
{
  for (const std::string& size : sizes({ "5k", "30k", "180k", "1M" }))
  {
    region(size);
  }
}

} // namespace oversketch_bench
