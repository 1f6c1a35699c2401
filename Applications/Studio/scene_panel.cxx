#include "scene_panel.h"

#include "document.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

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
{
  this->List->setObjectName("scene");
  this->List->setAccessibleName(tr("Scene"));
  this->List->setToolTip(tr("The model, and pictures behind it to draw after. Unticked ones are hidden."));
  this->List->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  this->List->setFixedHeight(lines * (this->List->fontMetrics().height() + 8) + 2 * this->List->frameWidth());
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
  this->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed); // the history takes the rest

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
        const int picture = this->List->row(item) - 1;
        const bool shown = item->checkState() == Qt::Checked;
        QMetaObject::invokeMethod(
          this, [this, picture, shown] { this->setShown(picture, shown); }, Qt::QueuedConnection);
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
  this->refresh();
}

int ScenePanel::current() const
{
  return this->List->currentRow() - 1; // the model is the first
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
    auto* model = new QListWidgetItem(tr("Model: %1").arg(QString::fromStdString(session.meshName)));
    model->setToolTip(tr("The model as it was opened"));
    this->List->addItem(model);
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
