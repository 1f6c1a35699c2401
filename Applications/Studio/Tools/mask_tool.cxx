#include "mask_tool.h"

#include "flow_layout.h"
#include "length_box.h"
#include "viewport.h"

#include <QCheckBox>
#include <QComboBox>
#include <QToolButton>

#include <functional>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr const char* modeName = "Mode";
constexpr const char* throughName = "Through";
constexpr const char* growName = "Grow";
constexpr const char* invertName = "Invert";
constexpr int replacing = 2; // of Mode
constexpr double ownLengthOfSize = 0.02;

} // namespace

MaskTool::MaskTool(Viewport* viewport, const Document* document)
  : HeldStrokeTool("Mask", viewport, document)
  , Bar(new QWidget(viewport))
  , Mode(new QComboBox(this->Bar))
  , Through(new QCheckBox(tr("Hidden parts, too"), this->Bar))
  , Length(new LengthBox(this->Bar))
{
  this->setObjectName("mask");
  this->setBar(this->Bar);
  auto* row = new FlowLayout(this->Bar);
  row->setContentsMargins(6, 0, 0, 0);
  this->Mode->addItems({ tr("Mask"), tr("Free") });
  this->Mode->setObjectName("mask_mode");
  this->Mode->setAccessibleName(tr("Lassos"));
  this->Mode->setToolTip(tr("The next lasso masks what it encloses, or frees it"));
  row->addWidget(this->Mode);
  this->Through->setObjectName("mask_through");
  this->Through->setToolTip(tr("The next lasso takes also what is hidden behind what is seen"));
  row->addWidget(this->Through);
  const auto addButton = [&](const char* name, const QString& text, const QString& help)
  {
    auto* button = new QToolButton(this->Bar);
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(help);
    row->addWidget(button);
    return button;
  };
  const auto connected = [this](QToolButton* button, const std::function<void()>& work)
  { connect(button, &QToolButton::clicked, this, work); };
  connected(addButton("mask_grow", tr("Grow"), tr("The mask grows over the surface by this length")),
    [this] { this->grow(this->Length->value()); });
  connected(addButton("mask_shrink", tr("Shrink"), tr("The mask shrinks by this length")),
    [this] { this->grow(-this->Length->value()); });
  this->Length->setObjectName("mask_length");
  this->Length->setAccessibleName(tr("Length"));
  this->Length->setToolTip(tr("How far it grows or shrinks, in lengths of the model"));
  row->addWidget(this->Length);
  connected(addButton("mask_invert", tr("Invert"), tr("Mask what is free, and free what is masked")),
    [this]
    {
      const bool inverts = this->shapesOffered() && valueOr(this->Selected, invertName, false);
      this->act({ { invertName, !inverts } });
    });
  connected(addButton("mask_clear", tr("Clear"), tr("Free all of the model")),
    [this]
    {
      Step step;
      step.system = this->system();
      step.values[modeName] = replacing;
      emit this->drawn(step);
    });
  // A lasso that is there is changed by its form: the next one may free again.
  const auto set = [this] { this->setValues(this->ofLassos()); };
  connect(this->Mode, QOverload<int>::of(&QComboBox::currentIndexChanged), this, set);
  connect(this->Through, &QCheckBox::toggled, this, set);
  this->beginWithModels(
    [this](double diagonal)
    {
      this->Length->begin(diagonal);
      this->Length->setValue(ownLengthOfSize * this->Length->diagonal());
    });
  set();
}

// A lasso round a part of a surface, and that part hatched.
QPainterPath MaskTool::icon() const
{
  QPainterPath path;
  path.addEllipse(4, 3, 16, 13);
  path.moveTo(8, 12.5);
  path.lineTo(13.5, 5.5);
  path.moveTo(12, 13);
  path.lineTo(16, 8);
  path.moveTo(10, 16);
  path.cubicTo(8, 19, 12, 20, 9, 22.5);
  return path;
}

QString MaskTool::advice(const Situation& situation) const
{
  if (situation.redraws)
  {
    return tr("Redraw the selected lasso. T leaves it as it is.");
  }
  if (situation.selected)
  {
    return tr("What is dark is masked: no step moves it. The buttons and the form change the selected row.");
  }
  return tr(
    "Draw a lasso round what is to stay: it is dark, and no step moves it. The middle button turns the "
    "model, F1 lists the keys.");
}

Values MaskTool::ofLassos() const
{
  return { { modeName, this->Mode->currentIndex() }, { throughName, this->Through->isChecked() } };
}

Values MaskTool::options() const
{
  Values options = this->ofLassos();
  options.merge(HeldStrokeTool::options());
  return options;
}

void MaskTool::setOptions(const Values& options)
{
  HeldStrokeTool::setOptions(options);
  this->Mode->setCurrentIndex(valueOr(options, modeName, 0));
  this->Through->setChecked(valueOr(options, throughName, false));
}

void MaskTool::offer(const Step& step, const Worker::NodeState& state, const Point& place)
{
  HeldStrokeTool::offer(step, state, place);
  this->Selected = step.values;
}

void MaskTool::act(const Values& values)
{
  if (this->shapesOffered())
  {
    this->shape(values, false);
    this->setValues(this->ofLassos()); // the next lasso does none of it
    return;
  }
  Step step;
  step.system = this->system();
  step.values = values;
  emit this->drawn(step);
}

// A step that inverts does so last: what is seen to grow shrinks before.
void MaskTool::grow(double length)
{
  const bool isOffered = this->shapesOffered();
  const double before = isOffered ? valueOr(this->Selected, growName, 0.0) : 0.0;
  const bool inverts = isOffered && valueOr(this->Selected, invertName, false);
  this->act({ { growName, before + (inverts ? -length : length) } });
}

} // namespace oversketch_studio
