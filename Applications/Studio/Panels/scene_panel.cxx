#include "scene_panel.h"

#include "document.h"
#include "models.h"
#include "pieces.h"
#include "systems.h"

#include "vtkOversketchJoinedParts.h"

#include <QAction>
#include <QHBoxLayout>
#include <QListWidget>
#include <QMenu>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr int lines = 4;     // that the list shows before it scrolls
constexpr int shortest = 40; // px, of the slider
constexpr const char* joinSystem = "Join";

} // namespace

ScenePanel::ScenePanel(Document* document, QWidget* parent)
  : QWidget(parent)
  , OpenDocument(document)
  , List(new QListWidget(this))
  , Opacity(new QSlider(Qt::Horizontal, this))
  , Add(new QToolButton(this))
  , View(new QToolButton(this))
  , Lock(new QToolButton(this))
  , Remove(new QToolButton(this))
  , Join(new QToolButton(this))
  , Export(new QAction(tr("Export the selecte&d model or part…"), this))
  , AddModel(new QAction(tr("Add a &model…"), this))
  , AddPicture(new QAction(tr("Add a p&icture…"), this))
{
  this->List->setObjectName("scene");
  this->List->setAccessibleName(tr("Scene"));
  this->List->setToolTip(
    tr("Models, and pictures behind them to draw after. A click on a model chooses it: strokes act on the "
       "chosen one. Unticked ones are hidden. Drop a model here to add it. The right button opens a menu."));
  const int line = this->List->fontMetrics().height() + 8, frame = 2 * this->List->frameWidth();
  this->List->setMinimumHeight(line + frame); // on a small screen
  this->List->setMaximumHeight(lines * line + frame);
  this->Opacity->setRange(0, 100);
  this->Opacity->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // it makes no room for itself
  this->Opacity->setMinimumWidth(shortest);
  this->Opacity->setAccessibleName(tr("Opacity"));
  this->Opacity->setToolTip(tr("How strongly the selected picture is seen"));
  this->makeActions();

  auto* row = new QHBoxLayout;
  for (QWidget* one :
    std::initializer_list<QWidget*>{ this->Add, this->Lock, this->Remove, this->Join, this->View })
  {
    row->addWidget(one);
  }
  row->addWidget(this->Opacity, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->List);
  layout->addLayout(row);
  this->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum); // the history takes the rest

  this->listenToList();
  // One step of undo for a slide, however long it takes.
  connect(this->Opacity,
    &QSlider::valueChanged,
    this,
    [this](int percent)
    {
      const int at = this->current();
      if (!this->Filling && at >= 0 && !this->Opacity->isSliderDown())
      {
        Picture picture = this->pictureAt(this->rowAt(this->List->currentRow()));
        picture.opacity = 0.01 * percent;
        this->OpenDocument->setPicture(at, picture);
      }
    });
  connect(this->Opacity,
    &QSlider::sliderReleased,
    this,
    [this] { emit this->Opacity->valueChanged(this->Opacity->value()); });
  connect(this->OpenDocument, &Document::shown, this, &ScenePanel::refresh); // its parts are known
  this->refresh();
}

void ScenePanel::makeActions()
{
  this->Add->setText(tr("Add…"));
  this->Add->setToolTip(tr("Put a model beside the open one, or a picture behind it, in the present view"));
  this->Add->setPopupMode(QToolButton::InstantPopup);
  this->Add->addActions({ this->AddModel, this->AddPicture });
  this->View->setText(tr("Its view"));
  this->View->setToolTip(tr("Look from where the selected picture is seen"));
  this->Lock->setText(tr("Lock"));
  this->Lock->setCheckable(true);
  this->Lock->setToolTip(
    tr("A locked model takes no strokes; a locked picture keeps its opacity and is not removed"));
  this->Remove->setText(tr("Remove"));
  this->Remove->setToolTip(tr("Take the selected model or picture out of the scene"));
  this->Join->setText(tr("Join"));
  this->Join->setObjectName("join_parts");
  this->Join->setToolTip(
    tr("Make one closed body of the parts of the chosen model. The form of the step then says which, and how "
       "wide the seam is."));
  this->Join->setVisible(findSystem(joinSystem));
  connect(this->Join,
    &QToolButton::clicked,
    this,
    [this]
    {
      Step step;
      step.system = joinSystem;
      emit this->joinAsked(step);
    });
  connect(this->AddModel, &QAction::triggered, this, &ScenePanel::modelAsked);
  connect(this->AddPicture, &QAction::triggered, this, &ScenePanel::addAsked);
  connect(this->View, &QToolButton::clicked, this, [this] { emit this->viewAsked(this->current()); });
  connect(this->Lock, &QToolButton::clicked, this, &ScenePanel::lock);
  connect(this->Remove, &QToolButton::clicked, this, &ScenePanel::remove);
  connect(this->Export, &QAction::triggered, this, &ScenePanel::exportRow);
}

void ScenePanel::listenToList()
{
  connect(this->List,
    &QListWidget::currentRowChanged,
    this,
    [this]
    {
      if (!this->Filling)
      {
        this->showSelected();
      }
    });
  // A change makes the list anew, which must wait until the list is done with the item.
  const auto later = [this](const std::function<void()>& change)
  { QMetaObject::invokeMethod(this, change, Qt::QueuedConnection); };
  connect(this->List,
    &QListWidget::itemChanged,
    this,
    [this, later](QListWidgetItem* item)
    {
      if (!this->Filling)
      {
        const int at = this->List->row(item);
        const bool shown = item->checkState() == Qt::Checked;
        this->Ticked = at;
        later([this, at, shown] { this->setShown(at, shown); });
      }
    });
  // The click that ticks a row does not choose its model.
  connect(this->List,
    &QListWidget::itemClicked,
    this,
    [this, later](QListWidgetItem* item)
    {
      const int at = this->List->row(item);
      if (std::exchange(this->Ticked, -1) != at)
      {
        later([this, at] { this->choose(at); });
      }
    });
  connect(this->List,
    &QListWidget::itemActivated,
    this,
    [this, later](QListWidgetItem* item)
    { later([this, at = this->List->row(item)] { this->choose(at); }); });
  this->List->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(this->List, &QWidget::customContextMenuRequested, this, &ScenePanel::showMenu);
}

ScenePanel::Row ScenePanel::rowAt(int at) const
{
  return at >= 0 && at < static_cast<int>(this->Rows.size()) ? this->Rows[indexOf(at)] : Row();
}

int ScenePanel::current() const
{
  return this->rowAt(this->List->currentRow()).picture;
}

Picture ScenePanel::pictureAt(const Row& row) const
{
  return *this->OpenDocument->session().pictures[indexOf(row.picture)];
}

void ScenePanel::refresh()
{
  this->Filling = true;
  this->Ticked = -1;
  const int before = this->List->count();
  const Row last = this->rowAt(before - 1);
  const int modelBefore = this->PartsOf;
  int row = this->List->currentRow();
  this->List->clear();
  this->Rows.clear();
  if (this->OpenDocument->isOpen())
  {
    this->findParts();
    this->list();
    this->hideParts();
    // A new row is the hand's next.
    const int now = this->List->count();
    const auto isChosen = [place = static_cast<int>(this->OpenDocument->session().place)](const Row& one)
    { return one.model == place; };
    if (before > 0 && now == before + 1 && this->rowAt(now - 1).picture > last.picture)
    {
      row = now - 1;
    }
    else if (modelBefore != 0 && modelBefore != this->PartsOf)
    {
      row =
        static_cast<int>(std::find_if(this->Rows.begin(), this->Rows.end(), isChosen) - this->Rows.begin());
    }
    this->List->setCurrentRow(std::min(row, now - 1));
  }
  this->Filling = false;
  this->showSelected();
}

// The parts of the chosen model.
void ScenePanel::findParts()
{
  vtkPolyData* mesh = this->OpenDocument->result().mesh;
  std::vector<int> parts = mesh ? oversketch_files::partsOf(mesh) : std::vector<int>();
  const std::set<int> joined = mesh ? oversketch::JoinedParts(mesh) : std::set<int>();
  const auto isOfFirst = [&joined](int part) { return joined.count(part) > 0 && part != *joined.begin(); };
  parts.erase(std::remove_if(parts.begin(), parts.end(), isOfFirst), parts.end());
  if (parts.size() < 2)
  {
    parts.clear();
  }
  this->Parts = std::move(parts);
  this->PartsOf = this->OpenDocument->session().id;
}

std::set<int> ScenePanel::hiddenParts() const
{
  return this->Parts.empty() ? std::set<int>()
                             : hiddenOf(this->OpenDocument->session(), this->OpenDocument->result().parts);
}

void ScenePanel::hideParts()
{
  const std::set<int> hidden =
    this->OpenDocument->session().shown ? this->hiddenParts() : std::set<int>{ -1 };
  if (hidden != std::exchange(this->Told, hidden))
  {
    emit this->partsHidden(hidden);
  }
}

void ScenePanel::addRow(const Row& row, const QString& text, const QString& help, bool shown)
{
  auto* item = new QListWidgetItem(text);
  item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
  item->setCheckState(shown ? Qt::Checked : Qt::Unchecked);
  item->setToolTip(help);
  this->List->addItem(item);
  this->Rows.push_back(row);
}

void ScenePanel::list()
{
  const Session& session = this->OpenDocument->session();
  const std::size_t count = modelCount(session);
  const QStringList parts = this->partNames();
  const std::set<int> hidden = this->hiddenParts();
  for (std::size_t place = 0; place < count; ++place)
  {
    const Model& model = modelAt(session, place);
    const bool isChosen = place == session.place;
    const QString name = QString::fromStdString(model.meshName);
    const QString text = count > 1 ? name : tr("Model: %1").arg(name);
    const auto at = static_cast<int>(place);
    if (count > 1 || this->Parts.empty())
    {
      this->addRow({ at },
        model.locked ? tr("%1 (locked)").arg(text) : text,
        count == 1 ? tr("The model")
        : isChosen ? tr("The chosen model, which strokes act on")
                   : tr("A click chooses this model: strokes then act on it"),
        model.shown);
      QFont font = this->List->font();
      font.setBold(count > 1 && isChosen);
      this->List->item(this->List->count() - 1)->setFont(font);
    }
    for (int i = 0; isChosen && i < parts.size(); ++i)
    {
      const int part = this->Parts[indexOf(i)];
      this->addRow({ at, part },
        count > 1 ? QString(3, ' ') + parts[i] : parts[i],
        tr("A part of the model"),
        hidden.count(part) == 0);
    }
  }
  for (std::size_t i = 0; i < session.pictures.size(); ++i)
  {
    const QString name = QString::fromStdString(session.pictures[i]->image.name);
    this->addRow({ -1, -1, static_cast<int>(i) },
      session.pictures[i]->locked ? tr("%1 (locked)").arg(name) : name,
      tr("A picture behind the model, seen in the view that it was put there in"),
      session.pictures[i]->shown);
  }
}

void ScenePanel::showSelected()
{
  const Row row = this->rowAt(this->List->currentRow());
  const bool open = this->OpenDocument->isOpen(), isPicture = row.picture >= 0;
  const bool isModel = open && row.model >= 0;
  const bool several = open && modelCount(this->OpenDocument->session()) > 1;
  this->Export->setEnabled(isModel && this->OpenDocument->result().mesh);
  this->AddModel->setEnabled(open);
  this->AddPicture->setEnabled(open);
  this->Add->setEnabled(open);
  this->View->setEnabled(isPicture);
  const Picture picture = isPicture ? this->pictureAt(row) : Picture();
  const bool locked =
    isModel ? modelAt(this->OpenDocument->session(), indexOf(row.model)).locked : picture.locked;
  this->Lock->setEnabled(isModel || isPicture);
  this->Lock->setChecked(locked);
  this->Lock->setText(locked ? tr("Unlock") : tr("Lock"));
  this->Join->setEnabled(!this->Parts.empty() && this->OpenDocument->whyNoSteps(joinSystem).isEmpty());
  this->Remove->setEnabled((isPicture && !locked) || (isModel && several && row.part < 0));
  this->Opacity->setEnabled(isPicture && !locked);
  this->Filling = true;
  this->Opacity->setValue(static_cast<int>(std::lround(100.0 * picture.opacity)));
  this->Filling = false;
}

// Those of the steps that made them, where these can be told.
QStringList ScenePanel::partNames() const
{
  QStringList names;
  if (this->Parts.empty())
  {
    return names;
  }
  const Session& session = this->OpenDocument->session();
  if (session.mesh)
  {
    names << QString::fromStdString(session.meshName);
  }
  const auto& states = this->OpenDocument->result().nodes;
  for (std::size_t i = 0; i < std::min(states.size(), session.nodes.size()); ++i)
  {
    const auto& node = session.nodes[i];
    const bool makes = node.step->part || (i == 0 && !session.mesh);
    if (makes && node.on && states[i].failure.empty())
    {
      names << QString::fromStdString(node.name);
    }
  }
  if (names.size() != static_cast<int>(this->Parts.size()))
  {
    names.clear();
    for (const int part : this->Parts)
    {
      names << tr("Part %1").arg(part + 1);
    }
  }
  return names;
}

void ScenePanel::choose(int at)
{
  const Row row = this->rowAt(at);
  if (row.model >= 0)
  {
    this->OpenDocument->chooseModel(row.model);
  }
}

void ScenePanel::setShown(int at, bool shown)
{
  const Row row = this->rowAt(at);
  row.part >= 0 ? this->OpenDocument->setPart(row.part, shown)
                : this->change(row, [shown](bool& isShown, bool&) { isShown = shown; });
}

void ScenePanel::lock(bool locked)
{
  this->change(this->rowAt(this->List->currentRow()), [locked](bool&, bool& isLocked) { isLocked = locked; });
}

void ScenePanel::change(const Row& row, const std::function<void(bool& shown, bool& locked)>& how)
{
  if (row.picture >= 0)
  {
    Picture picture = this->pictureAt(row);
    how(picture.shown, picture.locked);
    this->OpenDocument->setPicture(row.picture, picture);
  }
  else if (row.model >= 0)
  {
    const Model& now = modelAt(this->OpenDocument->session(), indexOf(row.model));
    bool shown = now.shown, locked = now.locked;
    how(shown, locked);
    this->OpenDocument->setModel(row.model, shown, locked);
  }
}

void ScenePanel::remove()
{
  const Row row = this->rowAt(this->List->currentRow());
  if (row.picture >= 0)
  {
    this->OpenDocument->removePicture(row.picture);
  }
  else if (row.model >= 0)
  {
    this->OpenDocument->removeModel(row.model);
  }
}

void ScenePanel::exportRow()
{
  const int at = this->List->currentRow();
  const Row row = this->rowAt(at);
  if (row.model >= 0)
  {
    const Model& model = modelAt(this->OpenDocument->session(), indexOf(row.model));
    emit this->exportAsked(row.model,
      row.part,
      row.part < 0 ? QString::fromStdString(model.meshName) : this->List->item(at)->text().trimmed());
  }
}

void ScenePanel::showMenu(const QPoint& at)
{
  if (!this->List->itemAt(at))
  {
    return;
  }
  QMenu menu;
  if (this->Export->isEnabled())
  {
    menu.addAction(this->Export);
  }
  for (QToolButton* button : { this->Lock, this->Remove, this->Join, this->View })
  {
    if (button->isEnabled())
    {
      QAction* action = menu.addAction(button->text());
      action->setCheckable(button->isCheckable());
      action->setChecked(button->isChecked());
      connect(action, &QAction::triggered, button, [button] { button->click(); });
    }
  }
  if (!menu.isEmpty())
  {
    menu.exec(this->List->viewport()->mapToGlobal(at));
  }
}

} // namespace oversketch_studio
