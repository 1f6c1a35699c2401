// A model of 11.5 million triangles, worked on by its proxy: the proxy, the first stroke on it, and the model
// moved as it was.
#include "bunny_stroke.h"
#include "process_status.h"

#include "vtkOversketchDetailTransfer.h"
#include "vtkOversketchOneStroke.h"
#include "vtkOversketchProxy.h"

#include "vtkLoopSubdivisionFilter.h"
#include "vtkNew.h"

namespace oversketch_bench
{

namespace
{

struct LargeModel
{
  vtkNew<vtkPolyData> mesh;
  vtkSmartPointer<vtkPolyData> proxy, stroke, moved;
  vtkNew<vtkOversketchProxy> coarsen;
  vtkSmartPointer<vtkOversketchOneStroke> system;
  vtkNew<vtkOversketchDetailTransfer> transfer;

  void subdivide()
  {
    if (this->mesh->GetNumberOfPolys() > 0)
    {
      return;
    }
    vtkNew<vtkLoopSubdivisionFilter> loop;
    loop->SetInputData(model("180k").polyData);
    loop->SetNumberOfSubdivisions(3);
    loop->Update();
    this->mesh->SetPoints(loop->GetOutput()->GetPoints());
    this->mesh->SetPolys(loop->GetOutput()->GetPolys());
    this->coarsen->SetInputData(this->mesh);
  }
  void makeProxy()
  {
    this->coarsen->Modified();
    this->coarsen->Update();
    this->proxy = this->coarsen->GetOutput();
  }
  void prepareStroke()
  {
    this->subdivide();
    if (!this->proxy)
    {
      this->makeProxy();
    }
    this->stroke = earStroke(this->proxy);
    this->system = vtkSmartPointer<vtkOversketchOneStroke>::New();
    this->system->SetInputData(0, this->proxy);
    this->system->SetStrokeData(this->stroke);
    this->proxy->GetPoints()->Modified(); // as if it were new
    this->proxy->GetPolys()->Modified();
  }
  void draw() { this->system->Update(); }
  void prepareTransfer()
  {
    if (!this->moved)
    {
      this->prepareStroke();
      this->draw();
      this->moved = this->system->GetOutput();
      this->transfer->SetInputData(0, this->mesh);
      this->transfer->SetInputData(1, this->moved);
    }
    this->transfer->Modified();
  }
  void exact() { this->transfer->Update(); }
  std::map<std::string, double> figures(double limit) const
  {
    return { { "limit_ms", limit }, { "process_gib", status("VmHWM") / (1 << 30) } };
  }
};

} // namespace

void jobs()
{
  const auto state = std::make_shared<LargeModel>();
  const auto job = [state](
                     const char* name, double limit, void (LargeModel::*prepare)(), void (LargeModel::*run)())
  {
    Job made;
    made.job = std::string("ten million: ") + name;
    made.size = "11.5M";
    made.who = "ours";
    made.prepare = [state, prepare] { (state.get()->*prepare)(); };
    made.run = [state, run] { (state.get()->*run)(); };
    made.figures = [state, limit] { return state->figures(limit); };
    add(made);
  };
  job("proxy", 10000.0, &LargeModel::subdivide, &LargeModel::makeProxy); // of the 15 s to the first picture
  job("first stroke on the proxy", 1000.0, &LargeModel::prepareStroke, &LargeModel::draw);
  job("exact result", 60000.0, &LargeModel::prepareTransfer, &LargeModel::exact);
}

} // namespace oversketch_bench
