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

namespace oversketch_studio
{

using namespace oversketch_session;

HistoryPanel::HistoryPanel(Document* document, QWidget* parent)
  : QWidget(parent)
  , document_(document)
  , list_(new QListWidget(this))
  , empty_(new QLabel(
      tr("The strokes that you draw are listed here. Tick one off, draw it anew, change how it acts: "
         "the model follows."),
      this->list_->viewport()))
  , form_(new StepPanel(this))
{
  this->list_->setObjectName("history");
  this->list_->setToolTip(tr("The strokes, in the order in which they act. Unticked strokes do nothing."));
  this->list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
  this->list_->setAccessibleName(tr("Strokes"));
  this->empty_->setWordWrap(true);
  this->empty_->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->makeActions();

  auto* buttons = new QHBoxLayout;
  for (QAction* one : this->strokeActions())
  {
    auto* button = new QToolButton(this);
    button->setDefaultAction(one);
    buttons->addWidget(button);
  }
  buttons->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->list_);
  auto* inList = new QVBoxLayout(this->list_->viewport());
  inList->addWidget(this->empty_, 0, Qt::AlignTop);
  layout->addLayout(buttons);
  layout->addWidget(this->form_);
  this->form_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);

  connect(this->list_, &QListWidget::itemChanged, this, &HistoryPanel::itemChanged);
  connect(this->list_,
    &QListWidget::currentRowChanged,
    this,
    [this](int row)
    {
      if (!this->filling_)
      {
        this->showStep();
        emit this->selected(row);
      }
    });
  connect(this->form_,
    &StepPanel::edited,
    this,
    [this](const Values& values, int mirror)
    { this->document_->setParameters(this->current(), values, this->document_->mirrorPlane(mirror)); });
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
  this->redraw_ =
    action(tr("&Redraw"), QKeySequence(tr("Ctrl+R")), tr("Draw this stroke anew; the later ones follow"));
  this->view_ = action(tr("&View"), QKeySequence(tr("Ctrl+L")), tr("Look from where this stroke was drawn"));
  this->up_ = action(tr("&Up"), QKeySequence(tr("Ctrl+Up")), tr("Let it act earlier"));
  this->down_ = action(tr("&Down"), QKeySequence(tr("Ctrl+Down")), tr("Let it act later"));
  this->remove_ = action(tr("De&lete"), QKeySequence::Delete, tr("Take this stroke away"));
  // In the view this key is nobody's, in a name that is edited it is the editor's.
  this->remove_->setShortcutContext(Qt::WidgetShortcut);
  this->list_->addAction(this->remove_);
  connect(this->redraw_, &QAction::triggered, this, [this] { emit this->redrawAsked(this->current()); });
  connect(this->view_, &QAction::triggered, this, [this] { emit this->viewAsked(this->current()); });
  const auto shift = [this](int by)
  {
    const int row = this->current();
    this->document_->move(row, row + by);
    this->list_->setCurrentRow(row + by);
  };
  connect(this->up_, &QAction::triggered, this, [shift] { shift(-1); });
  connect(this->down_, &QAction::triggered, this, [shift] { shift(1); });
  connect(this->remove_, &QAction::triggered, this, [this] { this->document_->remove(this->current()); });
}

int HistoryPanel::current() const
{
  return this->list_->currentRow();
}

void HistoryPanel::refresh()
{
  this->filling_ = true;
  const int row = this->current();
  this->list_->clear();
  if (this->document_->isOpen())
  {
    const auto& nodes = this->document_->session().nodes;
    const auto& states = this->document_->result().nodes;
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
      this->list_->addItem(item);
    }
    this->list_->setCurrentRow(std::min(row, this->list_->count() - 1));
  }
  this->empty_->setVisible(this->list_->count() == 0);
  this->filling_ = false;
  this->showStep();
}

void HistoryPanel::showStep()
{
  const int row = this->current();
  const Step* step =
    row < 0 ? nullptr : this->document_->session().nodes[static_cast<std::size_t>(row)].step.get();
  const SystemRow* system = step ? findSystem(step->system) : nullptr;
  const bool isDrawn = system && findInput(*system, SystemInput::Kind::Stroke);
  this->redraw_->setEnabled(isDrawn);
  this->view_->setEnabled(isDrawn);
  this->remove_->setEnabled(step);
  this->up_->setEnabled(row > 0);
  this->down_->setEnabled(step && row + 1 < this->list_->count());
  this->form_->show(step);
}

void HistoryPanel::itemChanged(QListWidgetItem* item)
{
  if (this->filling_)
  {
    return;
  }
  // The change makes the list anew, which must wait until the list is done with the item.
  const int row = this->list_->row(item);
  const bool on = item->checkState() == Qt::Checked;
  const QString name = item->text();
  QMetaObject::invokeMethod(
    this,
    [this, row, on, name]
    {
      const auto& nodes = this->document_->session().nodes;
      if (static_cast<std::size_t>(row) >= nodes.size())
      {
        return;
      }
      const Node& node = nodes[static_cast<std::size_t>(row)];
      if (on != node.on)
      {
        this->document_->setOn(row, on);
      }
      else if (name.toStdString() != node.name)
      {
        this->document_->rename(row, name);
      }
    },
    Qt::QueuedConnection);
}

} // namespace oversketch_studio
