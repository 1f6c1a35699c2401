#include "augment_tool.h"

#include "augment_options.h"
#include "document.h"
#include "latency.h"
#include "profile_editor.h"
#include "viewport.h"

#include "vtkOversketchAugment.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

// The curve on the surface, and what would rise from it.
void lookAt(vtkOversketchSystem* system,
  vtkPolyData* mesh,
  vtkPolyData* stroke,
  vtkPolyData* section,
  vtkPolyData* crest)
{
  auto* augment = vtkOversketchAugment::SafeDownCast(system);
  if (augment->PreviewCrest(mesh, stroke, crest))
  {
    const bool sketches = augment->GetSketchMode() == vtkOversketchAugment::Silhouette;
    section->ShallowCopy(sketches ? augment->GetInnerOutput("Sketch") : augment->GetInnerOutput("Curves"));
  }
}

} // namespace

AugmentTool::AugmentTool(Viewport* viewport, const Document* document)
  : HeldStrokeTool("Augment", viewport, document, lookAt)
  , Options(new AugmentOptions(viewport))
  , Profile(new ProfileEditor(viewport))
{
  this->setObjectName("augment");
  this->setBar(this->Options);
  this->Profile->hide(); // until the window has a place for it
  connect(this->Options, &AugmentOptions::shaped, this, &AugmentTool::reshape);
  connect(this->Profile, &ProfileEditor::shaped, this, &AugmentTool::reshape);
  this->beginWithModels(
    [this](double diagonal)
    {
      this->Options->begin(diagonal);
      this->setValues(this->values());
    });
}

// A surface, and a line's section that rises from it.
QPainterPath AugmentTool::icon() const
{
  QPainterPath path;
  path.moveTo(1.5, 18);
  path.cubicTo(7, 18, 9.5, 16, 12, 6);
  path.cubicTo(14.5, 16, 17, 18, 22.5, 18);
  path.moveTo(12, 2);
  path.lineTo(12, 2.5);
  path.moveTo(1.5, 21.5);
  path.lineTo(22.5, 21.5);
  return path;
}

QVector<QPair<QString, QString>> AugmentTool::keys() const
{
  return HeldStrokeTool::keys() + QVector<QPair<QString, QString>>{
    { tr("Ctrl + wheel"), tr("wider, narrower") },
    { tr("Shift + wheel"), tr("higher, lower; through to carving and back") },
  };
}

QString AugmentTool::advice(const Situation& situation) const
{
  if (situation.redraws)
  {
    return tr("Redraw the selected line. T leaves it as it is.");
  }
  if (situation.selected)
  {
    return tr("Blue is where the selected line lies. Ctrl + wheel changes its width, Shift + wheel its "
              "height, the profile its shape.");
  }
  if (situation.empty || !situation.holds)
  {
    return tr("Draw a line on the model: it becomes finer there and rises. Orange is its crest and, thin, "
              "where it ends. The middle button turns the model, F1 lists the keys.");
  }
  return tr("Draw on, or change the red line: Ctrl + wheel its width, Shift + wheel its height, the profile "
            "its shape; drag it to move it (Return: leave it). Ctrl+Z undoes.");
}

QString AugmentTool::stage(const QString& name) const
{
  if (name == "Base")
  {
    return tr("Pairing triangles");
  }
  if (name == "Refine" || name == "RefineOnSource")
  {
    return tr("Making triangles");
  }
  if (name == "Snap" || name == "Smooth")
  {
    return tr("Moving edges onto the line");
  }
  if (name == "Displace")
  {
    return tr("Raising the line");
  }
  return name == "Simplify" ? tr("Taking triangles away") : tr("Finding the line on the model");
}

// Lengths as shares of the model's size.
Values AugmentTool::options() const
{
  Values options = this->values();
  options.merge(HeldStrokeTool::options());
  options.erase("TargetEdgeLength"); // follows from the others
  for (const char* length : { "Radius", "Height" })
  {
    options[length] = std::get<double>(options[length]) / this->Options->diagonal();
  }
  return options;
}

void AugmentTool::setOptions(const Values& options)
{
  HeldStrokeTool::setOptions(options);
  Values values = options;
  for (const char* length : { "Radius", "Height" })
  {
    values[length] = std::get<double>(options.at(length)) * this->Options->diagonal();
  }
  this->Options->setValues(values);
  this->Profile->setShape(
    std::get<std::string>(options.at("Profile")), std::get<double>(options.at("Sharpness")));
  this->reshape(false);
}

QWidget* AugmentTool::makePanel(QWidget* parent)
{
  this->Profile->setParent(parent);
  this->Profile->show();
  return this->Profile;
}

void AugmentTool::offer(const Step& step, const Worker::NodeState& state, const Point& place)
{
  HeldStrokeTool::offer(step, state, place);
  this->Options->setValues(step.values);
  this->Profile->setShape(
    valueOr(step.values, "Profile", std::string()), valueOr(step.values, "Sharpness", 1.5));
  this->setValues(this->values());
}

Values AugmentTool::values() const
{
  Values values = this->Options->values();
  values["Profile"] = this->Profile->profile();
  values["Sharpness"] = this->Profile->sharpness();
  // A profile of one's own has bends that the system's own edges, a quarter of the radius, would cut off.
  const double finer = std::get<double>(values["Radius"]) / 8.0;
  values["TargetEdgeLength"] = this->Profile->profile().empty() ? 0.0 : finer;
  return values;
}

// Without what the last step has raised, which the mesh carries.
vtkSmartPointer<vtkPolyData> AugmentTool::meshBefore() const
{
  vtkPolyData* shown = this->viewport()->mesh();
  const auto& nodes = this->document()->session().nodes;
  const auto end = std::make_reverse_iterator(nodes.begin() + this->document()->shownTo());
  const auto last = std::find_if(end, nodes.rend(), [](const Node& node) { return node.on; });
  vtkDataArray* raised = shown ? shown->GetPointData()->GetArray("Displacement") : nullptr;
  if (!raised || last == nodes.rend() || last->step->system != this->system())
  {
    return nullptr;
  }
  auto before = vtkSmartPointer<vtkPolyData>::New();
  before->SetPolys(shown->GetPolys());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(shown->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double place[3], by[3];
    shown->GetPoint(i, place);
    raised->GetTuple(i, by);
    vtkMath::Subtract(place, by, place);
    points->SetPoint(i, place);
  }
  before->SetPoints(points);
  return before;
}

bool AugmentTool::wheel(double notches, Qt::KeyboardModifiers modifiers, ulong time)
{
  const bool wide = modifiers == Qt::ControlModifier, high = modifiers == Qt::ShiftModifier;
  if (!wide && !(high && this->Options->isOnSurface()))
  {
    return false;
  }
  if (this->shapesOffered())
  {
    wide ? Latency::of().radius() : Latency::of().height();
  }
  wide ? this->Options->widen(notches, time) : this->Options->heighten(notches, time);
  return true;
}

} // namespace oversketch_studio
