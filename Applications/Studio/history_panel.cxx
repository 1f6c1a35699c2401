#include "history_panel.h"

#include "document.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

namespace oversketch_studio
{

using oversketch_session::Node;
using oversketch_session::Values;

QComboBox* mirrorChoice(QWidget* parent)
{
  auto* choice = new QComboBox(parent);
  choice->addItems({ HistoryPanel::tr("One side"),
    HistoryPanel::tr("Both sides of x"),
    HistoryPanel::tr("Both sides of y"),
    HistoryPanel::tr("Both sides of z") });
  return choice;
}

HistoryPanel::HistoryPanel(Document* document, QWidget* parent)
  : QWidget(parent)
  , document_(document)
  , list_(new QListWidget(this))
  , empty_(new QLabel(
      tr("The strokes that you draw are listed here. Tick one off, draw it anew, change how it acts: "
         "the model follows."),
      this->list_->viewport()))
  , remesh_(new QComboBox(this))
  , adjustNormals_(new QCheckBox(tr("Details turn with the limb"), this))
  , asPublished_(new QCheckBox(tr("As published"), this))
  , mirror_(mirrorChoice(this))
{
  this->list_->setObjectName("history");
  this->list_->setToolTip(tr("The strokes, in the order in which they act. Unticked strokes do nothing."));
  this->list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
  this->list_->setAccessibleName(tr("Strokes"));
  this->remesh_->setAccessibleName(tr("New triangles"));
  this->mirror_->setAccessibleName(tr("Acts on"));
  this->empty_->setWordWrap(true);
  this->empty_->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->remesh_->addItems({ tr("where it is needed"), tr("always"), tr("never") });
  this->remesh_->setToolTip(tr("New triangles where the stroke stretches the model"));
  this->adjustNormals_->setToolTip(tr("Slower; better where a limb is bent far"));
  this->asPublished_->setToolTip(tr("Without the amendments to the published method"));

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

  auto* buttons = new QHBoxLayout;
  for (QAction* one : this->strokeActions())
  {
    auto* button = new QToolButton(this);
    button->setDefaultAction(one);
    buttons->addWidget(button);
  }
  buttons->addStretch();
  auto* form = new QFormLayout;
  form->addRow(tr("New triangles"), this->remesh_);
  form->addRow(this->adjustNormals_);
  form->addRow(this->asPublished_);
  form->addRow(tr("Acts on"), this->mirror_);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->list_);
  auto* inList = new QVBoxLayout(this->list_->viewport());
  inList->addWidget(this->empty_, 0, Qt::AlignTop);
  layout->addLayout(buttons);
  layout->addLayout(form);

  connect(document, &Document::changed, this, &HistoryPanel::refresh);
  connect(document, &Document::shown, this, &HistoryPanel::refresh);
  connect(this->list_, &QListWidget::itemChanged, this, &HistoryPanel::itemChanged);
  connect(this->list_,
    &QListWidget::currentRowChanged,
    this,
    [this](int row)
    {
      if (!this->filling_)
      {
        this->showParameters();
        emit this->selected(row);
      }
    });
  connect(this->remesh_, QOverload<int>::of(&QComboBox::activated), this, [this] { this->edit(); });
  connect(this->mirror_, QOverload<int>::of(&QComboBox::activated), this, [this] { this->edit(); });
  for (QCheckBox* box : { this->adjustNormals_, this->asPublished_ })
  {
    connect(box, &QCheckBox::clicked, this, [this] { this->edit(); });
  }
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
  this->refresh();
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
      this->list_->addItem(item);
    }
    this->list_->setCurrentRow(std::min(row, this->list_->count() - 1));
  }
  this->empty_->setVisible(this->list_->count() == 0);
  this->filling_ = false;
  this->showParameters();
}

void HistoryPanel::showParameters()
{
  const int row = this->current();
  const bool any = row >= 0;
  for (QWidget* one :
    std::initializer_list<QWidget*>{ this->remesh_, this->adjustNormals_, this->asPublished_, this->mirror_ })
  {
    one->setEnabled(any);
  }
  for (QAction* one : { this->redraw_, this->view_, this->remove_ })
  {
    one->setEnabled(any);
  }
  this->up_->setEnabled(row > 0);
  this->down_->setEnabled(any && row + 1 < this->list_->count());
  if (any)
  {
    const Node& node = this->document_->session().nodes[static_cast<std::size_t>(row)];
    const auto* system = oversketch_session::findSystem(node.step->system);
    const auto value = [&](const char* property) {
      return oversketch_session::valueOf(*node.step, *oversketch_session::findParameter(*system, property));
    };
    this->remesh_->setCurrentIndex(std::get<int>(value("Remesh")));
    this->adjustNormals_->setChecked(std::get<bool>(value("AdjustNormals")));
    this->asPublished_->setChecked(std::get<bool>(value("AsPublished")));
    this->mirror_->setCurrentIndex(node.step->mirror ? node.step->mirror->axis + 1 : 0);
    this->remesh_->setEnabled(!node.step->mirror); // its halves are told by the points' ids
  }
}

void HistoryPanel::edit()
{
  const Values values{ { "Remesh", this->remesh_->currentIndex() },
    { "AdjustNormals", this->adjustNormals_->isChecked() },
    { "AsPublished", this->asPublished_->isChecked() } };
  this->document_->setParameters(
    this->current(), values, this->document_->mirrorPlane(this->mirror_->currentIndex()));
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
