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

#include <cmath>
#include <cstdio>
#include <sstream>
#include <vector>

namespace oversketch_command
{

namespace
{

std::string quoted(const std::string& text)
{
  std::string out = "\"";
  for (const char c : text)
  {
    char escape[8];
    if (c == '"' || c == '\\')
    {
      out += '\\';
      out += c;
    }
    else if (static_cast<unsigned char>(c) < 0x20)
    {
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
      out += escape;
    }
    else
    {
      out += c;
    }
  }
  return out + '"';
}

std::string number(double value)
{
  if (!std::isfinite(value))
  {
    return "null";
  }
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string yes(bool value)
{
  return value ? "true" : "false";
}

// One JSON object, its members in the order given; indented by two more than its parent.
class Object
{
public:
  explicit Object(int depth)
    : Indent(static_cast<std::size_t>(2 * depth), ' ')
  {
  }
  Object& add(const std::string& name, const std::string& value)
  {
    this->Text +=
      (this->Text.empty() ? "" : ",") + ("\n" + this->Indent) + "  " + quoted(name) + ": " + value;
    return *this;
  }
  std::string text() const { return "{" + this->Text + "\n" + this->Indent + "}"; }

private:
  std::string Indent, Text;
};

double fieldOf(vtkPolyData* data, const char* name)
{
  vtkDataArray* array = data ? data->GetFieldData()->GetArray(name) : nullptr;
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : std::nan("");
}

vtkIdType pointsOf(vtkPolyData* data)
{
  return data ? data->GetNumberOfPoints() : 0;
}

std::string countsOf(vtkPolyData* mesh)
{
  return Object(1)
    .add("points", std::to_string(mesh->GetNumberOfPoints()))
    .add("triangles", std::to_string(mesh->GetNumberOfPolys()))
    .text();
}

// Vertices of the region and the share of the area of triangles wholly in it.
std::string regionOf(vtkPolyData* mesh)
{
  vtkDataArray* region = mesh ? mesh->GetPointData()->GetArray("Region") : nullptr;
  if (!region)
  {
    return "null";
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
  return Object(1)
    .add("vertices", std::to_string(vertices))
    .add("of_vertices", std::to_string(region->GetNumberOfTuples()))
    .add("area_share", number(inside / all))
    .text();
}

std::string deformationOf(vtkOversketchLaplacianDeform* step)
{
  if (!step)
  {
    return "null";
  }
  return Object(1)
    .add("movable_vertices", std::to_string(step->GetMovableCount()))
    .add("active_handles", std::to_string(step->GetActiveHandleCount()))
    .add("mean_handle_residual", number(step->GetMeanHandleResidual()))
    .add("maximum_handle_residual", number(step->GetMaximumHandleResidual()))
    .text();
}

} // namespace

std::string Report::json(const Options& options,
  vtkOversketchOneStroke* system,
  vtkPolyData* mesh,
  vtkPolyData* result) const
{
  const char* const backends[] = { "auto", "opencl", "embree" };
  const char* const remeshes[] = { "auto", "on", "off" };
  Object stages(1);
  for (int i = 0; i < system->GetNumberOfInnerOutputs(); ++i)
  {
    const char* name = system->GetInnerOutputName(i);
    stages.add(name, number(1e3 * system->GetStageTime(name)));
  }
  // Deform stands for all deformations among the inner outputs; each took its own time.
  for (const char* name :
    { "DeformCorrected", "DeformRemeshed", "CorrectionRemeshed", "DeformRemeshedCorrected" })
  {
    stages.add(name, number(1e3 * system->GetStageTime(name)));
  }
  vtkPolyData* match = system->GetInnerOutput("Match");
  vtkPolyData* targets = system->GetInnerOutput("Targets");
  auto* deform = vtkOversketchLaplacianDeform::SafeDownCast(system->GetStep(system->GetDeformationName()));
  return Object(0)
           .add("oversketch", quoted(OVERSKETCH_VERSION))
           .add("mesh", quoted(options.mesh))
           .add("stroke", quoted(options.stroke))
           .add("output", quoted(options.output))
           .add("options",
             Object(1)
               .add("backend", quoted(backends[options.backend]))
               .add("remesh", quoted(remeshes[options.remesh]))
               .add("adjust_normals", yes(options.adjustNormals))
               .add("as_published", yes(options.asPublished))
               .text())
           .add("backend_used",
             quoted(system->GetBackendUsed() == vtkOversketchOneStroke::OpenCL ? "opencl" : "embree"))
           .add("remeshed", yes(system->GetRemeshed()))
           .add("milliseconds",
             Object(1)
               .add("read", number(this->readMilliseconds))
               .add("run", number(this->runMilliseconds))
               .add("write", number(this->writeMilliseconds))
               .text())
           .add("stage_milliseconds", stages.text())
           .add("before", countsOf(mesh))
           .add("after", countsOf(result))
           .add("match",
             Object(1)
               .add("distance_px", number(fieldOf(match, "Distance")))
               .add("score_px", number(fieldOf(match, "Score")))
               .add("points", std::to_string(pointsOf(match)))
               .text())
           .add("targets",
             Object(1)
               .add("handles", std::to_string(pointsOf(targets)))
               .add("section_length", number(fieldOf(targets, "SectionLength")))
               .add("target_length", number(fieldOf(targets, "TargetLength")))
               .text())
           .add("region", regionOf(system->GetInnerOutput("RegionBorder")))
           .add("deformation", deformationOf(deform))
           .text() +
         "\n";
}

} // namespace oversketch_command
