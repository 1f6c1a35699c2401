// The editors: from a handle's drag to points and normals, and a cross-section that slides along its curve.
// Beside the section VTK's plane cutter, which cuts all of the mesh and keeps a tree of it.
#include "benchmark_frame.h"

#include "Harness/region_data.h"
#include "vtkOversketchCrossSection.h"
#include "vtkOversketchHandles.h"
#include "vtkOversketchMatrixDeform.h"
#include "vtkOversketchProfilePlanes.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCutter.h"

#include <memory>
#include <sstream>

namespace oversketch_bench
{

namespace
{

using oversketch_test::EditData;

// A sphere with so many rings inside the boundary, and sectors.
struct Scene
{
  EditData data;
  vtkNew<vtkOversketchHandles> handles;
  vtkNew<vtkOversketchMatrixDeform> deform;
  vtkNew<vtkOversketchProfilePlanes> planes;
  vtkNew<vtkOversketchCrossSection> section;
  vtkNew<vtkPlane> plane;
  vtkNew<vtkPlaneCutter> cutter;
  int turn = 0;

  Scene(int rings, int sectors)
    : data(oversketch_test::sphereScene(rings, sectors))
  {
    this->data.mesh->GetCellData()->SetNormals(nullptr); // models have those of points
    this->handles->SetInputData(this->data.mesh);
    this->handles->SetReferenceData(this->data.reference);
    this->deform->SetInputData(this->data.mesh);
    this->deform->SetHandlesConnection(this->handles->GetOutputPort());
    this->planes->SetInputData(this->data.mesh);
    this->planes->SetReferenceData(this->data.reference);
    this->section->SetInputData(this->data.mesh);
    this->section->SetBoundaryData(this->data.boundary);
    this->section->SetPlanesConnection(this->planes->GetOutputPort());
    this->cutter->SetInputData(this->data.mesh);
    this->cutter->SetPlane(this->plane);
    this->cutter->InterpolateAttributesOff();
    this->cutter->ComputeNormalsOff();
  }
  // One of three handles turns a little further.
  void drag()
  {
    std::ostringstream operations;
    operations << "pin 0.2; rotate 0.5 t " << 20 + ++this->turn % 50 << "; pin 0.8";
    this->handles->SetOperations(operations.str().c_str());
    this->deform->Update();
  }
  void slide() { this->planes->SetT(0.3 + 0.4 * (++this->turn % 40) / 40.0); }
  void cut()
  {
    this->slide();
    this->section->Update();
  }
  void cutTheirs()
  {
    this->slide();
    this->planes->Update();
    vtkDataArray* frame = this->planes->GetOutput()->GetFieldData()->GetArray("Frame");
    this->plane->SetOrigin(frame->GetComponent(0, 3), frame->GetComponent(0, 7), frame->GetComponent(0, 11));
    this->plane->SetNormal(frame->GetComponent(0, 0), frame->GetComponent(0, 4), frame->GetComponent(0, 8));
    this->cutter->Update();
  }
};

Scene& scene(int rings, int sectors)
{
  static std::map<int, std::unique_ptr<Scene>> made;
  std::unique_ptr<Scene>& one = made[rings];
  if (!one)
  {
    one = std::make_unique<Scene>(rings, sectors);
  }
  return *one;
}

} // namespace

void jobs()
{
  const auto drag = [](const char* size, int rings, int sectors)
  {
    Job job;
    job.job = "handle's drag to points and normals";
    job.size = size;
    job.who = "ours";
    job.prepare = [=] { scene(rings, sectors).deform->Update(); };
    job.run = [=] { scene(rings, sectors).drag(); };
    job.figures = [=] {
      return std::map<std::string, double>{ { "moved", scene(rings, sectors).deform->GetMovedPoints() } };
    };
    add(job);
  };
  drag("10k region vertices", 70, 144);
  drag("50k region vertices", 160, 316);

  Job ours;
  ours.job = "cross-section, plane slid";
  ours.size = "1M triangles";
  ours.who = "ours";
  ours.threads = 1;
  ours.prepare = [] { scene(410, 408).section->Update(); };
  ours.run = [] { scene(410, 408).cut(); };
  add(ours);
  Job theirs = ours;
  theirs.who = "vtkPlaneCutter";
  theirs.threads = 2;
  theirs.prepare = [] { scene(410, 408).cutter->Update(); };
  theirs.run = [] { scene(410, 408).cutTheirs(); };
  add(theirs);
}

} // namespace oversketch_bench
