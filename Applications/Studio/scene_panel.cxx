#include "scene_panel.h"

#include "document.h"
#include "pieces.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace oversketch_studio
{

using oversketch_session::Picture;

namespace
{

constexpr int lines = 3; // that the list shows before it scrolls

} // namespace

ScenePanel::ScenePanel(Document* document, QWidget* parent)
  : QWidget(parent)
  , OpenDocument(document)
  , List(new QListWidget(this))
  , Opacity(new QSlider(Qt::Horizontal, this))
  , Add(new QToolButton(this))
  , View(new QToolButton(this))
  , Remove(new QToolButton(this))
  , Export(new QAction(tr("Export this par&t…"), this))
{
  this->List->setObjectName("scene");
  this->List->setAccessibleName(tr("Scene"));
  this->List->setToolTip(tr("The model, and pictures behind it to draw after. Unticked ones are hidden. The "
                            "right button opens a menu."));
  const int line = this->List->fontMetrics().height() + 8, frame = 2 * this->List->frameWidth();
  this->List->setMinimumHeight(line + frame); // on a small screen
  this->List->setMaximumHeight(lines * line + frame);
  this->Opacity->setRange(0, 100);
  this->Opacity->setAccessibleName(tr("Opacity"));
  this->Opacity->setToolTip(tr("How strongly the selected picture is seen"));
  this->Add->setText(tr("Add…"));
  this->Add->setToolTip(tr("Put a picture behind the model, in the present view"));
  this->View->setText(tr("Its view"));
  this->View->setToolTip(tr("Look from where the selected picture is seen"));
  this->Remove->setText(tr("Remove"));
  this->Remove->setToolTip(tr("Take the selected picture out of the scene"));

  auto* row = new QHBoxLayout;
  for (QWidget* one : std::initializer_list<QWidget*>{ this->Add, this->View, this->Remove })
  {
    row->addWidget(one);
  }
  row->addWidget(this->Opacity, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->List);
  layout->addLayout(row);
  this->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum); // the history takes the rest

  connect(this->Add, &QToolButton::clicked, this, &ScenePanel::addAsked);
  connect(this->View, &QToolButton::clicked, this, [this] { emit this->viewAsked(this->current()); });
  connect(this->Remove,
    &QToolButton::clicked,
    this,
    [this] { this->OpenDocument->removePicture(this->current()); });
  connect(this->List,
    &QListWidget::currentRowChanged,
    this,
    [this]
    {
      if (!this->Filling)
      {
        this->showPicture();
      }
    });
  connect(this->List,
    &QListWidget::itemChanged,
    this,
    [this](QListWidgetItem* item)
    {
      if (!this->Filling)
      {
        // The change makes the list anew, which must wait until the list is done with the item.
        const int at = this->List->row(item), models = static_cast<int>(this->Parts.size());
        const bool shown = item->checkState() == Qt::Checked;
        QMetaObject::invokeMethod(
          this,
          [this, at, models, shown]
          { at < models ? this->setPartShown(at, shown) : this->setShown(at - models, shown); },
          Qt::QueuedConnection);
      }
    });
  // One step of undo for a slide, however long it takes.
  connect(this->Opacity,
    &QSlider::valueChanged,
    this,
    [this](int percent)
    {
      const int at = this->current();
      if (!this->Filling && at >= 0 && !this->Opacity->isSliderDown())
      {
        Picture picture = *this->OpenDocument->session().pictures[static_cast<std::size_t>(at)];
        picture.opacity = 0.01 * percent;
        this->OpenDocument->setPicture(at, picture);
      }
    });
  connect(this->Opacity,
    &QSlider::sliderReleased,
    this,
    [this] { emit this->Opacity->valueChanged(this->Opacity->value()); });
  connect(this->Export, &QAction::triggered, this, &ScenePanel::exportPart);
  this->List->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(this->List, &QWidget::customContextMenuRequested, this, &ScenePanel::showMenu);
  connect(this->OpenDocument, &Document::shown, this, &ScenePanel::refresh); // its parts are known
  this->refresh();
}

int ScenePanel::current() const
{
  const int at = this->List->currentRow() - static_cast<int>(this->Parts.size()); // the model is the first
  return at < 0 ? -1 : at;
}

void ScenePanel::refresh()
{
  this->Filling = true;
  const int before = this->List->count();
  int row = this->List->currentRow();
  this->List->clear();
  if (this->OpenDocument->isOpen())
  {
    const auto& session = this->OpenDocument->session();
    this->listModel();
    for (const auto& picture : session.pictures)
    {
      auto* item = new QListWidgetItem(QString::fromStdString(picture->image.name));
      item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
      item->setCheckState(picture->shown ? Qt::Checked : Qt::Unchecked);
      item->setToolTip(tr("A picture behind the model, seen in the view that it was put there in"));
      this->List->addItem(item);
    }
    const int now = this->List->count();
    row = before > 0 && now == before + 1 ? before : std::min(row, now - 1); // what is new is the hand's next
    this->List->setCurrentRow(row);
  }
  this->Filling = false;
  this->showPicture();
}

void ScenePanel::showPicture()
{
  const int at = this->current();
  const bool any = at >= 0;
  this->Export->setEnabled(this->List->currentRow() >= 0 && !any && this->OpenDocument->result().mesh);
  this->Add->setEnabled(this->OpenDocument->isOpen());
  this->View->setEnabled(any);
  this->Remove->setEnabled(any);
  this->Opacity->setEnabled(any);
  this->Filling = true;
  const double opacity =
    any ? this->OpenDocument->session().pictures[static_cast<std::size_t>(at)]->opacity : 1.0;
  this->Opacity->setValue(static_cast<int>(std::lround(100.0 * opacity)));
  this->Filling = false;
}

// One row, or one for each part.
void ScenePanel::listModel()
{
  vtkPolyData* mesh = this->OpenDocument->result().mesh;
  std::vector<int> parts = mesh ? oversketch_files::partsOf(mesh) : std::vector<int>();
  if (parts.size() < 2)
  {
    parts = { -1 };
  }
  if (parts != this->Parts) // of another model
  {
    this->Parts = parts;
    if (!std::exchange(this->Hidden, {}).empty())
    {
      emit this->partsHidden({});
    }
  }
  const QStringList names = this->partNames();
  for (int i = 0; i < names.size(); ++i)
  {
    auto* item = new QListWidgetItem(names[i]);
    item->setToolTip(parts.size() < 2 ? tr("The model") : tr("A part of the model"));
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(
      this->Hidden.count(parts[static_cast<std::size_t>(i)]) > 0 ? Qt::Unchecked : Qt::Checked);
    this->List->addItem(item);
  }
}

// Those of the steps that made them, where these can be told.
QStringList ScenePanel::partNames() const
{
  const auto& session = this->OpenDocument->session();
  const QString opened = QString::fromStdString(session.meshName);
  if (this->Parts.size() < 2)
  {
    return { tr("Model: %1").arg(opened) };
  }
  QStringList names;
  if (session.mesh)
  {
    names << opened;
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

void ScenePanel::setPartShown(int row, bool shown)
{
  const int part = this->Parts[static_cast<std::size_t>(row)];
  shown ? void(this->Hidden.erase(part)) : void(this->Hidden.insert(part));
  emit this->partsHidden(this->Hidden);
}

void ScenePanel::exportPart()
{
  const int row = this->List->currentRow();
  if (row >= 0 && row < static_cast<int>(this->Parts.size()))
  {
    emit this->exportAsked(this->Parts[static_cast<std::size_t>(row)], this->partNames()[row]);
  }
}

void ScenePanel::showMenu(const QPoint& at)
{
  if (this->List->itemAt(at) && this->Export->isEnabled())
  {
    QMenu menu;
    menu.addAction(this->Export);
    menu.exec(this->List->viewport()->mapToGlobal(at));
  }
}

void ScenePanel::setShown(int at, bool shown)
{
  const auto& pictures = this->OpenDocument->session().pictures;
  if (at >= 0 && static_cast<std::size_t>(at) < pictures.size() &&
      pictures[static_cast<std::size_t>(at)]->shown != shown)
  {
    Picture picture = *pictures[static_cast<std::size_t>(at)];
    picture.shown = shown;
    this->OpenDocument->setPicture(at, picture);
  }
}

} // namespace oversketch_studio
