// What is done with the curves after a camera move: snake, visibility, match and map together, mesh and
// silhouette known. Peer: one redraw of the same mesh after a camera move by a VTK window of the same size,
// without a display left out. Beside it "ours, with outline": the outline that system A traces for the match,
// too.
#include "Harness/polydata.h"
#include "bunny_stroke.h"

#include "vtkOversketchMatch.h"
#include "vtkOversketchOutline.h"
#include "vtkOversketchSilhouette.h"
#include "vtkOversketchSnake.h"
#include "vtkOversketchTargets.h"
#include "vtkOversketchVisibility.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace oversketch_bench
{

namespace
{

using oversketch_test::toStroke;

struct Chain
{
  vtkNew<vtkOversketchSilhouette> silhouette;
  vtkNew<vtkOversketchSnake> snake;
  vtkNew<vtkOversketchVisibility> visibility;
  vtkNew<vtkOversketchOutline> outline;
  vtkNew<vtkOversketchMatch> match;
  vtkNew<vtkOversketchTargets> targets;
  vtkSmartPointer<vtkPolyData> stroke; // drawn along the outline in the first view
  double degrees = 0.0;

  Chain(const std::string& size, bool outlined)
  {
    vtkPolyData* mesh = model(size).polyData;
    this->stroke = earStroke(mesh);
    this->silhouette->SetInputData(0, mesh);
    this->snake->SetInputConnection(0, this->silhouette->GetOutputPort());
    this->snake->SetInputData(1, mesh);
    this->visibility->SetInputConnection(0, this->snake->GetOutputPort());
    this->visibility->SetInputData(1, mesh);
    this->visibility->SetBackend(vtkOversketchVisibility::Host);
    this->outline->SetInputData(0, mesh);
    this->outline->SetInputConnection(2, this->visibility->GetOutputPort());
    this->match->AddInputConnection(0, this->visibility->GetOutputPort());
    if (outlined)
    {
      this->match->AddInputConnection(0, this->outline->GetOutputPort());
    }
    this->targets->SetInputConnection(0, this->match->GetOutputPort());
    this->targets->SetInputData(2, mesh);
  }

  // Half a degree on, to and fro, so that the stroke still runs along the outline.
  void look()
  {
    this->degrees = this->degrees >= 4.0 ? -4.0 : this->degrees + 0.5;
    const View view = bunnyView(this->degrees);
    std::vector<Vector2> samples;
    for (vtkIdType i = 0; i < this->stroke->GetNumberOfPoints(); ++i)
    {
      samples.emplace_back(this->stroke->GetPoint(i)[0], this->stroke->GetPoint(i)[1]);
    }
    const auto seen = toStroke(samples, view);
    this->silhouette->SetInputData(1, seen);
    this->snake->SetInputData(2, seen);
    this->visibility->SetInputData(2, seen);
    this->outline->SetInputData(1, seen);
    this->match->SetInputData(1, seen);
    this->targets->SetInputData(1, seen);
    this->silhouette->Update();
  }

  void update()
  {
    this->targets->Update();
    if (this->targets->GetOutput()->GetNumberOfPoints() == 0)
    {
      std::fprintf(stderr, "No section was found.\n");
      std::exit(1);
    }
  }
};

void ours(const std::string& size, bool outlined)
{
  auto chain = std::make_shared<std::unique_ptr<Chain>>();
  Job job;
  job.job = "curves";
  job.size = size;
  job.who = outlined ? "ours, with outline" : "ours";
  job.prepare = [=]
  {
    if (!*chain)
    {
      *chain = std::make_unique<Chain>(size, outlined);
      (*chain)->look();
      (*chain)->update();
    }
    (*chain)->look();
  };
  job.run = [chain] { (*chain)->update(); };
  job.figures = [chain]
  {
    return std::map<std::string, double>{ { "points",
                                            double((*chain)->silhouette->GetOutput()->GetNumberOfPoints()) },
      { "handles", double((*chain)->targets->GetOutput()->GetNumberOfPoints()) } };
  };
  add(job);
}

void redraw(const std::string& size)
{
  struct Scene
  {
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkRenderWindow> window;
  };
  auto scene = std::make_shared<std::unique_ptr<Scene>>();
  Job job;
  job.job = "curves";
  job.size = size;
  job.who = "redraw";
  job.prepare = [=]
  {
    if (!*scene)
    {
      *scene = std::make_unique<Scene>();
      Scene& made = **scene;
      made.mapper->SetInputData(model(size).polyData);
      made.actor->SetMapper(made.mapper);
      made.renderer->AddActor(made.actor);
      made.window->SetOffScreenRendering(1);
      made.window->SetMultiSamples(0);
      made.window->SetSize(800, 600);
      made.window->AddRenderer(made.renderer);
      made.window->Render();
    }
    (*scene)->renderer->GetActiveCamera()->Azimuth(0.5);
  };
  job.run = [scene]
  {
    (*scene)->window->Render();
    (*scene)->window->WaitForCompletion();
  };
  add(job);
}

} // namespace

void jobs()
{
  const bool display = std::getenv("DISPLAY") != nullptr;
  if (!display)
  {
    std::fprintf(stderr, "No display (DISPLAY is not set, see xvfb-run): the redraw is left out.\n");
  }
  for (const std::string& size : sizes({ "5k", "30k", "180k", "1M" }))
  {
    ours(size, false);
    ours(size, true);
    if (display)
    {
      redraw(size);
    }
  }
}

} // namespace oversketch_bench
