// From a handle's drag to points and normals, and a cross-section that slides along its curve. Beside the
// section VTK's plane cutter, which cuts all of the mesh and keeps a tree of it.
#include "edit_jobs.h"

#include "Harness/region_data.h"
#include "vtkOversketchCrossSection.h"
#include "vtkOversketchHandles.h"
#include "vtkOversketchMatrixDeform.h"
#include "vtkOversketchProfilePlanes.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCutter.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <vector>

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
  // The plane that ours is to be cut by, not timed.
  void slideTheirs()
  {
    this->slide();
    this->planes->Update();
    vtkDataArray* frame = this->planes->GetOutput()->GetFieldData()->GetArray("Frame");
    this->plane->SetOrigin(frame->GetComponent(0, 3), frame->GetComponent(0, 7), frame->GetComponent(0, 11));
    this->plane->SetNormal(frame->GetComponent(0, 0), frame->GetComponent(0, 4), frame->GetComponent(0, 8));
  }
  // How far points of our section lie from the nearest of theirs, which has one on each edge too.
  double apart()
  {
    this->slideTheirs();
    this->section->Update();
    this->cutter->Update();
    const std::vector<Vector3> ours = oversketch_test::pointsOf(this->section->GetSectionOutput());
    std::vector<double> least(ours.size(), HUGE_VAL);
    auto* whole = vtkCompositeDataSet::SafeDownCast(this->cutter->GetOutputDataObject(0));
    std::vector<vtkDataObject*> parts{ this->cutter->GetOutputDataObject(0) };
    if (whole)
    {
      vtkSmartPointer<vtkCompositeDataIterator> iterator = vtk::TakeSmartPointer(whole->NewIterator());
      for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
      {
        parts.push_back(iterator->GetCurrentDataObject());
      }
    }
    for (vtkDataObject* part : parts)
    {
      auto* piece = vtkDataSet::SafeDownCast(part);
      for (vtkIdType k = 0; piece && k < piece->GetNumberOfPoints(); ++k)
      {
        const Vector3 theirs(piece->GetPoint(k));
        for (std::size_t n = 0; n < least.size(); ++n)
        {
          least[n] = std::min(least[n], (ours[n] - theirs).norm());
        }
      }
    }
    return least.empty() ? HUGE_VAL : *std::max_element(least.begin(), least.end());
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

void addMoves()
{
  const auto drag = [](const char* size, double limit, int rings, int sectors)
  {
    Job job;
    job.job = "handle's drag to points and normals";
    job.size = size;
    job.who = "ours";
    job.prepare = [=] { scene(rings, sectors).deform->Update(); };
    job.run = [=] { scene(rings, sectors).drag(); };
    job.figures = [=]
    {
      return std::map<std::string, double>{ { "limit_ms", limit },
        { "moved", scene(rings, sectors).deform->GetMovedPoints() } };
    };
    add(job);
  };
  drag("10k region vertices", 2.0, 70, 144);
  drag("50k region vertices", 8.0, 160, 316);

  Job ours;
  ours.job = "cross-section, plane slid";
  ours.size = "1M triangles";
  ours.who = "ours";
  ours.threads = 1;
  ours.prepare = [] { scene(410, 408).section->Update(); };
  ours.run = [] { scene(410, 408).cut(); };
  Job theirs = ours;
  ours.figures = []
  {
    return std::map<std::string, double>{ { "apart_from_vtk", scene(410, 408).apart() },
      { "points", static_cast<double>(scene(410, 408).section->GetSectionOutput()->GetNumberOfPoints()) } };
  };
  add(ours);
  theirs.who = "vtkPlaneCutter";
  theirs.threads = 2;
  theirs.prepare = []
  {
    scene(410, 408).cutter->Update(); // its tree
    scene(410, 408).slideTheirs();
  };
  theirs.run = [] { scene(410, 408).cutter->Update(); };
  add(theirs);
}

} // namespace oversketch_bench
