#include "report.h"

#include "vtkOversketchLaplacianDeform.h"
#include "vtkOversketchOneStroke.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangle.h"
#include "vtk_jsoncpp.h"

#include <cmath>

namespace oversketch_command
{

namespace
{

// A figure that could not be had is null.
Json::Value number(double value)
{
  return std::isfinite(value) ? Json::Value(value) : Json::Value();
}

double fieldOf(vtkPolyData* data, const char* name)
{
  vtkDataArray* array = data ? data->GetFieldData()->GetArray(name) : nullptr;
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : std::nan("");
}

vtkIdType pointsOf(vtkPolyData* data)
{
  return data ? data->GetNumberOfPoints() : 0;
}

Json::Value count(vtkIdType value)
{
  return Json::Value(static_cast<Json::Int64>(value));
}

Json::Value countsOf(vtkPolyData* mesh)
{
  Json::Value json;
  json["points"] = count(mesh->GetNumberOfPoints());
  json["triangles"] = count(mesh->GetNumberOfPolys());
  return json;
}

// Vertices of the region and the share of the area of triangles wholly in it.
Json::Value regionOf(vtkPolyData* mesh)
{
  vtkDataArray* region = mesh ? mesh->GetPointData()->GetArray("Region") : nullptr;
  Json::Value json;
  if (!region)
  {
    return json;
  }
  vtkIdType vertices = 0;
  for (vtkIdType i = 0; i < region->GetNumberOfTuples(); ++i)
  {
    vertices += region->GetComponent(i, 0) != 0.0;
  }
  double inside = 0.0, all = 0.0;
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    double p[3][3];
    bool in = true;
    for (int k = 0; k < 3; ++k)
    {
      mesh->GetPoint(ids[k], p[k]);
      in = in && region->GetComponent(ids[k], 0) != 0.0;
    }
    const double area = vtkTriangle::TriangleArea(p[0], p[1], p[2]);
    all += area;
    inside += in ? area : 0.0;
  }
  json["vertices"] = count(vertices);
  json["of_vertices"] = count(region->GetNumberOfTuples());
  json["area_share"] = number(inside / all);
  return json;
}

Json::Value deformationOf(vtkOversketchLaplacianDeform* step)
{
  Json::Value json;
  if (step)
  {
    json["movable_vertices"] = count(step->GetMovableCount());
    json["active_handles"] = count(step->GetActiveHandleCount());
    json["mean_handle_residual"] = number(step->GetMeanHandleResidual());
    json["maximum_handle_residual"] = number(step->GetMaximumHandleResidual());
  }
  return json;
}

} // namespace

std::string Report::json(const Options& options,
  vtkOversketchOneStroke* system,
  vtkPolyData* mesh,
  vtkPolyData* result) const
{
  const char* const backends[] = { "auto", "opencl", "embree" };
  const char* const remeshes[] = { "auto", "on", "off" };
  Json::Value stages;
  for (int i = 0; i < system->GetNumberOfInnerOutputs(); ++i)
  {
    const char* name = system->GetInnerOutputName(i);
    stages[name] = number(1e3 * system->GetStageTime(name));
  }
  // Deform stands for all deformations among the inner outputs; each took its own time.
  for (const char* name :
    { "DeformCorrected", "DeformRemeshed", "CorrectionRemeshed", "DeformRemeshedCorrected" })
  {
    stages[name] = number(1e3 * system->GetStageTime(name));
  }
  vtkPolyData* match = system->GetInnerOutput("Match");
  vtkPolyData* targets = system->GetInnerOutput("Targets");
  auto* deform = vtkOversketchLaplacianDeform::SafeDownCast(system->GetStep(system->GetDeformationName()));
  Json::Value json;
  json["oversketch"] = OVERSKETCH_VERSION;
  json["mesh"] = options.mesh;
  json["stroke"] = options.stroke;
  json["output"] = options.output;
  json["options"]["backend"] = backends[options.backend];
  json["options"]["remesh"] = remeshes[options.remesh];
  json["options"]["adjust_normals"] = options.adjustNormals;
  json["options"]["as_published"] = options.asPublished;
  json["backend_used"] = system->GetBackendUsed() == vtkOversketchOneStroke::OpenCL ? "opencl" : "embree";
  json["remeshed"] = system->GetRemeshed();
  json["milliseconds"]["read"] = number(this->readMilliseconds);
  json["milliseconds"]["run"] = number(this->runMilliseconds);
  json["milliseconds"]["write"] = number(this->writeMilliseconds);
  json["stage_milliseconds"] = stages;
  json["before"] = countsOf(mesh);
  json["after"] = countsOf(result);
  json["match"]["distance_px"] = number(fieldOf(match, "Distance"));
  json["match"]["score_px"] = number(fieldOf(match, "Score"));
  json["match"]["points"] = count(pointsOf(match));
  json["targets"]["handles"] = count(pointsOf(targets));
  json["targets"]["section_length"] = number(fieldOf(targets, "SectionLength"));
  json["targets"]["target_length"] = number(fieldOf(targets, "TargetLength"));
  json["region"] = regionOf(system->GetInnerOutput("RegionBorder"));
  json["deformation"] = deformationOf(deform);
  Json::StreamWriterBuilder writer;
  writer["indentation"] = "  ";
  writer["precision"] = 9;
  return Json::writeString(writer, json) + "\n";
}

} // namespace oversketch_command
