#include "join_tool.h"

#include "document.h"
#include "message_text.h"
#include "parts.h"
#include "pieces.h"
#include "viewport.h"

#include "Mesh/context.h"
#include "vtkOversketchStepRunner.h"
#include "vtkOversketchSurfaceStroke.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

// How long a line is over a mesh, where it lies on that. Throws oversketch::Error where it lies beside it.
double lengthOver(vtkPolyData* mesh, vtkPolyData* line)
{
  vtkNew<vtkOversketchSurfaceStroke> surface;
  surface->SetInputData(line);
  surface->SetMeshData(mesh);
  oversketch::StepRunner(surface, {}).Run();
  vtkPolyData* curves = surface->GetOutput();
  double length = 0.0;
  for (vtkIdType i = 0; i < curves->GetNumberOfCells(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    curves->GetLines()->GetCellAtId(i, count, points);
    length += curves->GetPointData()->GetArray("ArcLength")->GetComponent(points[count - 1], 0);
  }
  return length;
}

} // namespace

JoinTool::JoinTool(Viewport* viewport, const Document* document)
  : HeldStrokeTool("Join", viewport, document)
{
  this->setObjectName("join");
}

// Two discs that overlap.
QPainterPath JoinTool::icon() const
{
  QPainterPath path;
  path.addEllipse(1.5, 5.5, 13, 13);
  path.addEllipse(9.5, 5.5, 13, 13);
  return path;
}

QString JoinTool::advice(const Situation& situation) const
{
  if (situation.holds)
  {
    return tr("Draw again across the seam: it is as wide as the line is long. The form has the rest. Return "
              "leaves the row. Ctrl+Z undoes.");
  }
  return tr("Draw across the place where parts meet: they are one body, with a seam as wide as the line is "
            "long. The middle button turns the model, F1 lists the keys.");
}

void JoinTool::lineWhole(vtkPolyData* line)
{
  vtkPolyData* mesh = this->viewport()->mesh();
  if (!mesh)
  {
    return;
  }
  Step step;
  step.system = this->system();
  try
  {
    const auto hidden = hiddenOf(this->document()->session(), this->document()->result().parts);
    const double width = lengthOver(oversketch_files::withoutParts(mesh, hidden), line);
    // Rounded, so that the step's form shows all digits.
    step.values["Width"] = QString::number(width, 'g', 3).toDouble();
  }
  catch (const oversketch::Error& error)
  {
    emit this->refused(briefWords(error.message()));
    return;
  }
  if (this->shapesOffered())
  {
    this->shape(step.values, false);
  }
  else
  {
    emit this->drawn(step);
  }
}

} // namespace oversketch_studio
