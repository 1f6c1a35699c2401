#include "relax_tool.h"

#include "length_box.h"
#include "viewport.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr const char* radiusName = "Radius";
// Half as wide again as lines are, so that one goes though it is missed a little.
constexpr double ownRadiusOfSize = 0.045;
constexpr ulong restOfWheel = 1000; // ms; a hand that rests so long begins anew

} // namespace

RelaxTool::RelaxTool(Viewport* viewport, const Document* document)
  : HeldStrokeTool("Relax", viewport, document)
  , Bar(new QWidget(viewport))
  , Radius(new LengthBox(this->Bar))
{
  this->setObjectName("relax");
  this->Radius->setObjectName("relax_radius");
  this->Radius->setAccessibleName(tr("Radius"));
  this->Radius->setToolTip(
    tr("How far from the line it is smoothed, in lengths of the model (Ctrl + wheel)"));
  auto* label = new QLabel(tr("Radius"), this->Bar);
  label->setBuddy(this->Radius);
  auto* row = new QHBoxLayout(this->Bar);
  row->setContentsMargins(6, 0, 0, 0);
  row->addWidget(label);
  row->addWidget(this->Radius);
  connect(this->Radius,
    QOverload<double>::of(&LengthBox::valueChanged),
    this,
    [this](double radius) { this->setRadius(radius, false); });
  this->setBar(this->Bar);
  this->beginWithModels(
    [this](double diagonal)
    {
      const QSignalBlocker quiet(this->Radius);
      this->Radius->begin(diagonal);
      this->Radius->setValue(ownRadiusOfSize * this->Radius->diagonal());
      this->setValues({ { radiusName, this->Radius->value() } });
    });
}

// A bumpy line, and a smooth one under it.
QPainterPath RelaxTool::icon() const
{
  QPainterPath path;
  path.moveTo(1.5, 9);
  path.cubicTo(3, 4, 5, 4, 6.5, 9);
  path.cubicTo(8, 13, 9.5, 13, 11, 8);
  path.cubicTo(12.5, 3, 14.5, 3, 16, 8);
  path.cubicTo(17.5, 12, 20, 12, 22.5, 7);
  path.moveTo(1.5, 19);
  path.cubicTo(8, 16, 15, 16, 22.5, 19);
  return path;
}

QVector<QPair<QString, QString>> RelaxTool::keys() const
{
  return HeldStrokeTool::keys() + QVector<QPair<QString, QString>>{
    { tr("Ctrl + wheel"), tr("wider, narrower") },
  };
}

QString RelaxTool::advice(const Situation& situation) const
{
  if (situation.redraws)
  {
    return tr("Redraw the selected line. T leaves it as it is.");
  }
  if (situation.selected)
  {
    return tr("Blue is where the selected line lies. Ctrl + wheel changes its width, the form its strength.");
  }
  return tr(
    "Draw over what is rough: it is smooth there. Ctrl + wheel is wider or narrower. The middle button "
    "turns the model, F1 lists the keys.");
}

Values RelaxTool::options() const
{
  Values options = HeldStrokeTool::options();
  options[radiusName] = this->Radius->value() / this->Radius->diagonal();
  return options;
}

void RelaxTool::setOptions(const Values& options)
{
  HeldStrokeTool::setOptions(options);
  const double share = std::get<double>(options.at(radiusName));
  this->setRadius(share * this->Radius->diagonal(), false);
}

void RelaxTool::offer(const Step& step, const Worker::NodeState& state, const Point& place)
{
  HeldStrokeTool::offer(step, state, place);
  const auto radius = step.values.find(radiusName);
  if (radius != step.values.end())
  {
    const QSignalBlocker quiet(this->Radius);
    this->Radius->setValue(std::get<double>(radius->second));
    this->setValues({ { radiusName, this->Radius->value() } });
  }
}

void RelaxTool::setRadius(double radius, bool mergesIntoLast)
{
  const QSignalBlocker quiet(this->Radius);
  this->Radius->setValue(radius);
  this->shape({ { radiusName, this->Radius->value() } }, mergesIntoLast);
}

bool RelaxTool::wheel(double notches, Qt::KeyboardModifiers modifiers, ulong time)
{
  if (modifiers != Qt::ControlModifier)
  {
    return false;
  }
  const bool goesOn = time >= this->WheelTime && time - this->WheelTime < restOfWheel;
  this->WheelTime = time;
  this->setRadius(this->Radius->turned(this->Radius->value(), notches), goesOn);
  return true;
}

} // namespace oversketch_studio
