#include "history_panel.h"

#include "document.h"
#include "row_texts.h"
#include "step_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace oversketch_studio
{

using namespace oversketch_session;

HistoryPanel::HistoryPanel(Document* document, QWidget* parent)
  : QWidget(parent)
  , OpenDocument(document)
  , List(new QListWidget(this))
  , Empty(new QLabel(
      tr("The strokes that you draw are listed here. Tick one off, draw it anew, change how it acts: "
         "the model follows."),
      this->List->viewport()))
  , Form(new StepPanel(this))
{
  this->List->setObjectName("history");
  this->List->setToolTip(tr("The strokes, in the order in which they act. Unticked strokes do nothing."));
  this->List->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
  this->List->setAccessibleName(tr("Strokes"));
  this->Empty->setWordWrap(true);
  this->Empty->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->makeActions();

  auto* buttons = new QHBoxLayout;
  for (QAction* one : this->buttonActions())
  {
    auto* button = new QToolButton(this);
    button->setDefaultAction(one);
    buttons->addWidget(button);
  }
  buttons->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->List);
  auto* inList = new QVBoxLayout(this->List->viewport());
  inList->addWidget(this->Empty, 0, Qt::AlignTop);
  layout->addLayout(buttons);
  layout->addWidget(this->Form);
  this->Form->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);

  connect(this->List, &QListWidget::itemChanged, this, &HistoryPanel::itemChanged);
  connect(this->List,
    &QListWidget::currentRowChanged,
    this,
    [this](int row)
    {
      if (!this->Filling)
      {
        this->showStep();
        emit this->selected(row);
      }
    });
  connect(this->Form,
    &StepPanel::edited,
    this,
    [this](const Values& values, int mirror)
    { this->OpenDocument->setParameters(this->current(), values, this->OpenDocument->mirrorPlane(mirror)); });
  this->refresh();
}

void HistoryPanel::makeActions()
{
  const auto action = [this](const QString& text, const QKeySequence& keys, const QString& help)
  {
    auto* made = new QAction(text, this);
    made->setShortcut(keys);
    made->setToolTip(help);
    return made;
  };
  this->Redraw =
    action(tr("&Redraw"), QKeySequence(tr("Ctrl+R")), tr("Draw this stroke anew; the later ones follow"));
  this->View = action(tr("&View"), QKeySequence(tr("Ctrl+L")), tr("Look from where this stroke was drawn"));
  this->Up = action(tr("&Up"), QKeySequence(tr("Ctrl+Up")), tr("Let it act earlier"));
  this->Down = action(tr("&Down"), QKeySequence(tr("Ctrl+Down")), tr("Let it act later"));
  this->Next = action(tr("Ne&xt place"),
    QKeySequence(tr("F3")),
    tr("Let the stroke take hold of the next outline that fits it"));
  this->Less = action(tr("Reac&h less"), QKeySequence(tr("[")), tr("Move less of the body with it"));
  this->More = action(tr("Reach &more"), QKeySequence(tr("]")), tr("Move more of the body with it"));
  this->Remove = action(tr("De&lete"), QKeySequence::Delete, tr("Take this stroke away"));
  // In the view this key is nobody's, in a name that is edited it is the editor's.
  this->Remove->setShortcutContext(Qt::WidgetShortcut);
  this->List->addAction(this->Remove);
  connect(this->Redraw, &QAction::triggered, this, [this] { emit this->redrawAsked(this->current()); });
  connect(this->View, &QAction::triggered, this, [this] { emit this->viewAsked(this->current()); });
  const auto shift = [this](int by)
  {
    const int row = this->current();
    this->OpenDocument->move(row, row + by);
    this->List->setCurrentRow(row + by);
  };
  connect(this->Up, &QAction::triggered, this, [shift] { shift(-1); });
  connect(this->Down, &QAction::triggered, this, [shift] { shift(1); });
  connect(this->Next,
    &QAction::triggered,
    this,
    [this]
    {
      const auto& states = this->OpenDocument->result().nodes;
      const std::size_t row = indexOf(this->changed());
      // Others that fail are passed by; the remedy is what tells this one.
      const bool isBeyondTheLast =
        row < states.size() && states[row].failure.find("Lower Candidate") != std::string::npos;
      this->change("Candidate",
        [isBeyondTheLast](const Value& value) -> Value
        { return isBeyondTheLast ? 1 : std::get<int>(value) + 1; });
    });
  const auto reach = [this](double by)
  {
    this->change("Reach",
      [by](const Value& value) -> Value
      { return std::clamp(std::round(20.0 * (std::get<double>(value) + by)) / 20.0, -1.0, 1.0); });
  };
  connect(this->Less, &QAction::triggered, this, [reach] { reach(-0.05); });
  connect(this->More, &QAction::triggered, this, [reach] { reach(0.05); });
  connect(this->Remove, &QAction::triggered, this, [this] { this->OpenDocument->remove(this->current()); });
}

int HistoryPanel::changed() const
{
  if (!this->OpenDocument->isOpen())
  {
    return -1;
  }
  const int last = static_cast<int>(this->OpenDocument->session().nodes.size()) - 1;
  return this->current() >= 0 ? this->current() : last;
}

void HistoryPanel::change(const char* property, const std::function<Value(const Value&)>& to)
{
  const int row = this->changed();
  if (row < 0)
  {
    return;
  }
  const Step& step = *this->OpenDocument->session().nodes[indexOf(row)].step;
  const SystemRow* system = findSystem(step.system);
  if (const Parameter* parameter = system ? findParameter(*system, property) : nullptr)
  {
    Values values = step.values;
    values[property] = to(valueOf(step, *parameter));
    this->OpenDocument->setParameters(row, values, step.mirror);
  }
}

void HistoryPanel::turnTo(const std::string& system)
{
  if (this->current() < 0)
  {
    this->Form->turnTo(system);
  }
}

int HistoryPanel::current() const
{
  return this->List->currentRow();
}

void HistoryPanel::refresh()
{
  this->Filling = true;
  const int row = this->current();
  this->List->clear();
  if (this->OpenDocument->isOpen())
  {
    const auto& nodes = this->OpenDocument->session().nodes;
    const auto& states = this->OpenDocument->result().nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      auto* item = new QListWidgetItem(QString::fromStdString(nodes[i].name));
      item->setFlags(item->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
      item->setCheckState(nodes[i].on ? Qt::Checked : Qt::Unchecked);
      if (i < states.size() && nodes[i].on)
      {
        if (!states[i].failure.empty())
        {
          item->setIcon(this->style()->standardIcon(QStyle::SP_MessageBoxWarning));
          item->setToolTip(tr("Did nothing: %1").arg(QString::fromStdString(states[i].failure)));
        }
        else if (!states[i].remark.empty())
        {
          item->setIcon(this->style()->standardIcon(QStyle::SP_MessageBoxWarning));
          item->setToolTip(QString::fromStdString(states[i].remark));
        }
        else if (states[i].elsewhere)
        {
          item->setIcon(this->style()->standardIcon(QStyle::SP_MessageBoxInformation));
          item->setToolTip(tr("Takes hold in another place than when it was drawn"));
        }
      }
      if (item->toolTip().isEmpty())
      {
        const SystemRow* system = findSystem(nodes[i].step->system);
        item->setToolTip(system ? rowSentence(system->brief) : QString());
      }
      this->List->addItem(item);
    }
    this->List->setCurrentRow(std::min(row, this->List->count() - 1));
  }
  this->Empty->setVisible(this->List->count() == 0);
  this->Filling = false;
  this->showStep();
}

void HistoryPanel::showStep()
{
  const int row = this->current();
  const Step* step =
    row < 0 ? nullptr : this->OpenDocument->session().nodes[static_cast<std::size_t>(row)].step.get();
  const SystemRow* system = step ? findSystem(step->system) : nullptr;
  const bool isDrawn = system && findInput(*system, SystemInput::Kind::Stroke);
  this->Redraw->setEnabled(isDrawn);
  this->View->setEnabled(isDrawn);
  this->Remove->setEnabled(step);
  const int changed = this->changed();
  const SystemRow* other =
    changed < 0 ? nullptr : findSystem(this->OpenDocument->session().nodes[indexOf(changed)].step->system);
  this->Next->setEnabled(other && findParameter(*other, "Candidate"));
  this->Less->setEnabled(other && findParameter(*other, "Reach"));
  this->More->setEnabled(this->Less->isEnabled());
  this->Up->setEnabled(row > 0);
  this->Down->setEnabled(step && row + 1 < this->List->count());
  this->Form->show(step);
}

void HistoryPanel::itemChanged(QListWidgetItem* item)
{
  if (this->Filling)
  {
    return;
  }
  // The change makes the list anew, which must wait until the list is done with the item.
  const int row = this->List->row(item);
  const bool on = item->checkState() == Qt::Checked;
  const QString name = item->text();
  QMetaObject::invokeMethod(
    this,
    [this, row, on, name]
    {
      const auto& nodes = this->OpenDocument->session().nodes;
      if (static_cast<std::size_t>(row) >= nodes.size())
      {
        return;
      }
      const Node& node = nodes[static_cast<std::size_t>(row)];
      if (on != node.on)
      {
        this->OpenDocument->setOn(row, on);
      }
      else if (name.toStdString() != node.name)
      {
        this->OpenDocument->rename(row, name);
      }
    },
    Qt::QueuedConnection);
}

} // namespace oversketch_studio
