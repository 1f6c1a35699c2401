#include "history_panel.h"

#include "document.h"
#include "drawing_lines.h"
#include "flow_layout.h"
#include "line_form.h"
#include "message_text.h"
#include "row_delegate.h"
#include "step_list.h"
#include "step_order.h"
#include "step_panel.h"
#include "system_strings.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr int leastList = 72; // px: a row and the marker below it
constexpr int nodeRole = RowDelegate::NodeRole, lineRole = RowDelegate::LineRole;

// Shares the thumbnail's pixels.
QImage imageOf(const std::shared_ptr<const Thumbnail>& picture)
{
  using Held = std::shared_ptr<const Thumbnail>;
  return picture ? QImage(
                     picture->pixels.data(),
                     Thumbnail::width,
                     Thumbnail::height,
                     QImage::Format_RGBA8888,
                     [](void* held) { delete static_cast<Held*>(held); },
                     new Held(picture))
                 : QImage();
}

} // namespace

HistoryPanel::HistoryPanel(Document* document, QWidget* parent)
  : QWidget(parent)
  , OpenDocument(document)
  , List(new StepList(this))
  , Empty(new QLabel(tr("The strokes that you draw are listed here. Untick one, redraw it, change how it "
                        "acts: the model follows."),
      this->List->viewport()))
  , Form(new StepPanel(this))
{
  this->List->setObjectName("history");
  this->List->setToolTip(tr("The strokes, in the order in which they act. Unticked strokes do nothing."));
  this->List->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  this->List->setAccessibleName(tr("Strokes"));
  this->Empty->setWordWrap(true);
  this->Empty->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->makeActions();

  auto* buttons = new FlowLayout;
  buttons->setSpacing(2); // in one line in English
  for (QAction* one : this->buttonActions())
  {
    auto* button = new QToolButton(this);
    button->setDefaultAction(one);
    buttons->addWidget(button);
  }
  auto* layout = new QVBoxLayout(this);
  // Some rows are seen, however long the form is; it scrolls.
  this->List->setMinimumHeight(leastList);
  layout->addWidget(this->List, 2);
  auto* inList = new QVBoxLayout(this->List->viewport());
  inList->addWidget(this->Empty, 0, Qt::AlignTop);
  layout->addLayout(buttons);
  layout->addWidget(this->Form, 3);
  this->Form->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);

  this->listenToList();
  connect(this->Form,
    &StepPanel::edited,
    this,
    [this](const Values& values, int mirror)
    {
      // A row that is left gives out what was typed in the midst of the change of rows: taken when it is
      // over.
      const int id = this->FormId, line = this->FormLine;
      const bool isSelected = this->idOf(this->current()) == id && this->currentLine() == line;
      QMetaObject::invokeMethod(
        this,
        [=] { this->setParameters(id, line, values, mirror); },
        isSelected && !this->Filling ? Qt::DirectConnection : Qt::QueuedConnection);
    });
  connect(this->Form, &StepPanel::keysLeft, this, &HistoryPanel::keysLeft);
  this->Form->unselected = [this](const std::string& system) -> const Step*
  {
    int last = this->OpenDocument->isOpen() ? this->OpenDocument->shownTo() - 1 : -1;
    while (last >= 0 && !this->OpenDocument->isOf(last, system))
    {
      --last;
    }
    return last < 0 ? nullptr : this->OpenDocument->nodeAt(last)->step.get();
  };
  this->refresh();
}

void HistoryPanel::listenToList()
{
  connect(this->List, &QListWidget::itemChanged, this, &HistoryPanel::itemChanged);
  connect(this->List,
    &QListWidget::currentRowChanged,
    this,
    [this]
    {
      if (!this->Filling)
      {
        this->showStep();
        emit this->selected(this->current());
      }
    });
  connect(this->OpenDocument, &Document::opened, this, [this] { this->Pictures.clear(); });
  this->List->setMayMove([this](int from, int to) { return this->mayMove(from, to); });
  connect(this->List, &StepList::moveAsked, this, &HistoryPanel::move);
  connect(this->List, &StepList::lineMoveAsked, this, &HistoryPanel::moveLine);
  connect(this->List, &StepList::markerAsked, this->OpenDocument, &Document::showTo);
  this->List->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(this->List, &QWidget::customContextMenuRequested, this, &HistoryPanel::showMenu);
  connect(this->OpenDocument, &Document::pictured, this, &HistoryPanel::showPicture);
  // The part that a step moved is known after its mesh.
  connect(this->OpenDocument,
    &Document::detailed,
    this,
    [this]
    {
      const auto& states = this->OpenDocument->result().nodes;
      for (int i = 0; i < static_cast<int>(states.size()); ++i)
      {
        this->showPicture(i);
      }
    });
}

bool HistoryPanel::mayMove(int from, int to)
{
  const auto& nodes = this->OpenDocument->session().nodes;
  const OrderFault fault = faultOfMove(this->OpenDocument->session(), indexOf(from), indexOf(to));
  if (fault)
  {
    emit this->told(whyNotBefore(nodes[indexOf(fault.step)], nodes[indexOf(fault.needed)]));
  }
  return !fault;
}

void HistoryPanel::move(int from, int to)
{
  if (this->mayMove(from, to))
  {
    this->OpenDocument->move(from, to);
    this->select(to, -1);
  }
}

void HistoryPanel::moveLine(int node, int from, int to)
{
  std::vector<DrawnStroke> lines = strokesOf(*this->OpenDocument->nodeAt(node)->step);
  const DrawnStroke line = lines[indexOf(from)];
  lines.erase(lines.begin() + from);
  lines.insert(lines.begin() + to, line);
  this->OpenDocument->setStrokes(node, lines);
  this->select(node, to);
}

void HistoryPanel::showMenu(const QPoint& at)
{
  if (this->current() < 0 || !this->List->itemAt(at))
  {
    return;
  }
  QMenu menu;
  menu.addActions({ this->Rename, this->Toggle, this->Redraw, this->View });
  menu.addSeparator();
  menu.addActions({ this->Up, this->Down, this->Again, this->ShowTo, this->ShowAll });
  menu.addSeparator();
  menu.addAction(this->Remove);
  menu.exec(this->List->viewport()->mapToGlobal(at));
}

void HistoryPanel::showPicture(int node)
{
  QListWidgetItem* item = this->List->itemOf(node);
  if (item && indexOf(node) < this->OpenDocument->session().nodes.size())
  {
    const bool before = std::exchange(this->Filling, true);
    this->tell(item, node);
    this->Filling = before;
  }
}

// Shows what the step did, and its picture; the last one stays until another is there.
void HistoryPanel::tell(QListWidgetItem* item, int at)
{
  const Node& node = this->OpenDocument->session().nodes[indexOf(at)];
  const auto& states = this->OpenDocument->result().nodes;
  const Worker::NodeState* state = indexOf(at) < states.size() ? &states[indexOf(at)] : nullptr;
  const bool isShown = at < this->OpenDocument->shownTo();
  const QString words = isShown && !state && node.on && this->OpenDocument->isBusy()
                          ? tr("being computed…")
                          : wordsOf(node, isShown ? state : nullptr);
  item->setData(RowDelegate::WordsRole, words);
  item->setData(Qt::AccessibleDescriptionRole, words);
  // A result that is not up to date may be of another order.
  if (!this->OpenDocument->isBusy() && state && (state->picture || !state->failure.empty()))
  {
    this->Pictures[node.id] = state->picture;
  }
  item->setData(RowDelegate::PictureRole, imageOf(this->Pictures[node.id]));
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
    action(tr("&Redraw"), QKeySequence(tr("Ctrl+R")), tr("Draw this stroke again; the later ones follow"));
  this->View =
    action(tr("Its &view"), QKeySequence(tr("Ctrl+L")), tr("Look from where this stroke was drawn"));
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
  this->Rename = action(tr("Re&name"), QKeySequence(tr("F2")), tr("Give this stroke another name"));
  this->Toggle = action(tr("&On or off"), {}, tr("Let the model pass by this stroke, or not"));
  this->Again = action(tr("Dupl&icate"), QKeySequence(tr("Ctrl+D")), tr("Let this stroke act once more"));
  this->ShowTo = action(tr("Show &to here"),
    QKeySequence(tr("Ctrl+H")),
    tr("Show the model as of this stroke; the later ones are kept"));
  this->ShowAll =
    action(tr("Show &all"), QKeySequence(tr("Ctrl+Shift+H")), tr("Show the model as of the last stroke"));
  connect(
    this->Rename, &QAction::triggered, this, [this] { this->List->editItem(this->List->currentItem()); });
  connect(this->Toggle,
    &QAction::triggered,
    this,
    [this]
    {
      if (QListWidgetItem* item = this->List->currentItem())
      {
        item->setCheckState(item->checkState() == Qt::Checked ? Qt::Unchecked : Qt::Checked);
      }
    });
  connect(this->Again, &QAction::triggered, this, [this] { this->OpenDocument->duplicate(this->current()); });
  connect(
    this->ShowTo, &QAction::triggered, this, [this] { this->OpenDocument->showTo(this->current() + 1); });
  connect(this->ShowAll,
    &QAction::triggered,
    this,
    [this] { this->OpenDocument->showTo(static_cast<int>(this->OpenDocument->session().nodes.size())); });
  connect(this->Redraw,
    &QAction::triggered,
    this,
    [this]
    {
      const int line = this->currentLine();
      line < 0 ? emit this->redrawAsked(this->current()) : emit this->lineAsked(this->current(), line);
    });
  connect(this->View, &QAction::triggered, this, [this] { emit this->viewAsked(this->current()); });
  const auto shift = [this](int by)
  {
    const int node = this->current(), line = this->currentLine();
    line < 0 ? this->move(node, node + by) : this->moveLine(node, line, line + by);
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
      const bool isBeyondTheLast = row < states.size() && states[row].failure.names("candidate");
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
  connect(this->Remove, &QAction::triggered, this, &HistoryPanel::remove);
}

void HistoryPanel::remove()
{
  const int node = this->current(), line = this->currentLine();
  if (line < 0)
  {
    this->OpenDocument->remove(node);
    return;
  }
  std::vector<DrawnStroke> lines = strokesOf(*this->OpenDocument->nodeAt(node)->step);
  lines.erase(lines.begin() + line);
  this->OpenDocument->setStrokes(node, lines);
}

void HistoryPanel::setOn(int node, int line, bool on)
{
  const Node& one = *this->OpenDocument->nodeAt(node);
  if (line < 0)
  {
    if (on != one.on)
    {
      this->OpenDocument->setOn(node, on);
    }
    return;
  }
  std::vector<DrawnStroke> lines = strokesOf(*one.step);
  if (indexOf(line) < lines.size() && on != lines[indexOf(line)].on)
  {
    lines[indexOf(line)].on = on;
    this->OpenDocument->setStrokes(node, lines);
  }
}

int HistoryPanel::changed() const
{
  if (!this->OpenDocument->isOpen())
  {
    return -1;
  }
  const int last = this->OpenDocument->shownTo() - 1;
  return this->current() >= 0 ? this->current() : last;
}

void HistoryPanel::change(const char* property, const std::function<Value(const Value&)>& to)
{
  const int row = this->changed();
  const Node* node = this->OpenDocument->nodeAt(row);
  const SystemRow* system = node ? findSystem(node->step->system) : nullptr;
  if (const Parameter* parameter = system ? findParameter(*system, property) : nullptr)
  {
    Values values = node->step->values;
    values[property] = to(valueOf(*node->step, *parameter));
    this->OpenDocument->setParameters(row, values, node->step->mirror);
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
  const QListWidgetItem* item = this->List->currentItem();
  return item ? item->data(nodeRole).toInt() : -1;
}

int HistoryPanel::currentLine() const
{
  const QListWidgetItem* item = this->List->currentItem();
  return item ? item->data(lineRole).toInt() : -1;
}

void HistoryPanel::select(int node, int line)
{
  int row = -1;
  for (int i = 0; i < this->List->count(); ++i)
  {
    const QListWidgetItem* item = this->List->item(i);
    const bool isOfNode = item->data(nodeRole).toInt() == node;
    row = isOfNode && item->data(lineRole).toInt() <= line ? i : row; // the last line where it is gone
  }
  this->List->setCurrentRow(row);
}

void HistoryPanel::addStep(int at)
{
  const Node& node = this->OpenDocument->session().nodes[indexOf(at)];
  const auto& states = this->OpenDocument->result().nodes;
  auto* item = new QListWidgetItem(QString::fromStdString(node.name));
  item->setData(nodeRole, at);
  item->setData(lineRole, -1);
  item->setFlags(item->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
  item->setCheckState(node.on ? Qt::Checked : Qt::Unchecked);
  const bool isEmpty = node.step->system == drawingSystem && strokesOf(*node.step).empty();
  if (indexOf(at) < states.size() && node.on && !isEmpty)
  {
    const auto& state = states[indexOf(at)];
    if (!state.failure.empty())
    {
      item->setIcon(this->style()->standardIcon(QStyle::SP_MessageBoxWarning));
      item->setToolTip(tr("Did nothing: %1").arg(plainWords(state.failure)));
    }
    else if (!state.remark.empty())
    {
      item->setIcon(this->style()->standardIcon(QStyle::SP_MessageBoxWarning));
      item->setToolTip(plainWords(state.remark));
    }
    else if (state.elsewhere)
    {
      item->setIcon(this->style()->standardIcon(QStyle::SP_MessageBoxInformation));
      item->setToolTip(tr("Takes hold in another place than when it was drawn"));
    }
  }
  if (item->toolTip().isEmpty())
  {
    const SystemRow* system = findSystem(node.step->system);
    item->setToolTip(system ? rowSentence(system->brief) : QString());
  }
  this->tell(item, at);
  this->List->addItem(item);
}

// Under their drawing, which is one step.
void HistoryPanel::addLines(int at)
{
  const std::vector<DrawnStroke> lines = strokesOf(*this->OpenDocument->nodeAt(at)->step);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const int treatment = treatmentOf(lines[i].line), depth = depthOf(lines[i].line);
    const QString name = tr("    Line %1").arg(i + 1);
    auto* item = new QListWidgetItem(depth == 1       ? tr("%1, in front").arg(name)
                                     : depth == 2     ? tr("%1, behind").arg(name)
                                     : depth == 3     ? tr("%1, both sides").arg(name)
                                     : treatment == 0 ? name
                                     : treatment == 1 ? tr("%1, hole").arg(name)
                                                      : tr("%1, tunnel").arg(name));
    item->setData(nodeRole, at);
    item->setData(lineRole, static_cast<int>(i));
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(lines[i].on ? Qt::Checked : Qt::Unchecked);
    item->setToolTip(tr("A line of the drawing. Shift over it in the picture draws a part of it anew."));
    this->List->addItem(item);
  }
}

void HistoryPanel::refresh()
{
  this->Filling = true;
  const int node = this->current(), line = this->currentLine();
  const int scrolled = this->List->verticalScrollBar()->value(), before = this->List->steps();
  this->List->clear();
  this->List->arrange(0, 0);
  if (this->OpenDocument->isOpen())
  {
    // A step that has been undone may leave its id to another.
    const auto& nodes = this->OpenDocument->session().nodes;
    for (auto it = this->Pictures.begin(); it != this->Pictures.end();)
    {
      it = rowOf(nodes, it->first) >= 0 ? std::next(it) : this->Pictures.erase(it);
    }
    const int count = static_cast<int>(nodes.size());
    for (int i = 0; i < count; ++i)
    {
      this->addStep(i);
      this->addLines(i);
    }
    this->List->arrange(count, this->OpenDocument->shownTo());
    this->List->scrollBack(scrolled, count == before + 1 ? this->OpenDocument->shownTo() - 1 : -1);
    if (node >= 0)
    {
      this->select(std::min(node, count - 1), line);
    }
  }
  this->Empty->setVisible(this->List->count() == 0);
  this->Filling = false;
  this->showStep();
}

void HistoryPanel::showStep()
{
  const int row = this->current();
  const Node* node = this->OpenDocument->nodeAt(row);
  const Step* step = node ? node->step.get() : nullptr;
  const SystemRow* system = step ? findSystem(step->system) : nullptr;
  const bool isDrawn = system && findInput(*system, SystemInput::Kind::Stroke);
  const bool isLine = this->currentLine() >= 0, isDrawing = step && step->system == drawingSystem;
  this->Redraw->setEnabled(isDrawing ? isLine : isDrawn);
  this->View->setEnabled(isDrawn && (!isDrawing || !strokesOf(*step).empty()));
  this->Remove->setEnabled(step);
  const Node* changed = this->OpenDocument->nodeAt(this->changed());
  const SystemRow* other = changed ? findSystem(changed->step->system) : nullptr;
  this->Next->setEnabled(other && findParameter(*other, "Candidate"));
  this->Less->setEnabled(other && findParameter(*other, "Reach"));
  this->More->setEnabled(this->Less->isEnabled());
  const std::vector<DrawnStroke> lines = isLine ? strokesOf(*step) : std::vector<DrawnStroke>();
  const std::size_t places = isLine ? lines.size() : step ? this->OpenDocument->session().nodes.size() : 0;
  const int place = isLine ? this->currentLine() : row;
  this->Up->setEnabled(place > 0);
  this->Down->setEnabled(indexOf(place) + 1 < places);
  this->Rename->setEnabled(step && !isLine);
  this->Toggle->setEnabled(step);
  this->Again->setEnabled(step && !isLine && (row > 0 || this->OpenDocument->session().mesh));
  this->ShowTo->setEnabled(step);
  this->ShowAll->setEnabled(this->OpenDocument->isOpen() && indexOf(this->OpenDocument->shownTo()) <
                                                              this->OpenDocument->session().nodes.size());
  const Step ofLine = isLine ? lineStep(lines[indexOf(place)].line) : Step();
  this->Form->show(isLine ? &ofLine : step);
  this->FormId = this->idOf(row);
  this->FormLine = this->currentLine();
}

int HistoryPanel::idOf(int node) const
{
  const Node* one = this->OpenDocument->nodeAt(node);
  return one ? one->id : -1;
}

void HistoryPanel::setParameters(int id, int line, const Values& values, int mirror)
{
  const int node = rowOf(this->OpenDocument->session().nodes, id);
  if (node < 0) // it has been undone or deleted
  {
    return;
  }
  if (line < 0)
  {
    this->OpenDocument->setParameters(node, values, this->OpenDocument->mirrorPlane(mirror));
    return;
  }
  std::vector<DrawnStroke> lines = strokesOf(*this->OpenDocument->nodeAt(node)->step);
  if (indexOf(line) < lines.size())
  {
    lines[indexOf(line)].line = withLineValues(lines[indexOf(line)].line, values);
    this->OpenDocument->setStrokes(node, lines);
  }
}

void HistoryPanel::itemChanged(QListWidgetItem* item)
{
  if (this->Filling)
  {
    return;
  }
  // The change makes the list anew, which must wait until the list is done with the item.
  const int row = item->data(nodeRole).toInt(), line = item->data(lineRole).toInt();
  const bool on = item->checkState() == Qt::Checked;
  const QString name = item->text();
  QMetaObject::invokeMethod(
    this,
    [this, row, line, on, name]
    {
      if (!this->OpenDocument->nodeAt(row))
      {
        return;
      }
      this->setOn(row, line, on);
      if (line < 0 && name.toStdString() != this->OpenDocument->nodeAt(row)->name)
      {
        this->OpenDocument->rename(row, name);
      }
    },
    Qt::QueuedConnection);
}

} // namespace oversketch_studio
