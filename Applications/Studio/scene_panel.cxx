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
  , document_(document)
  , list_(new QListWidget(this))
  , opacity_(new QSlider(Qt::Horizontal, this))
  , add_(new QToolButton(this))
  , view_(new QToolButton(this))
  , remove_(new QToolButton(this))
{
  this->list_->setObjectName("scene");
  this->list_->setAccessibleName(tr("Scene"));
  this->list_->setToolTip(tr("The model, and pictures behind it to draw after. Unticked ones are hidden."));
  this->list_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  this->list_->setFixedHeight(
    lines * (this->list_->fontMetrics().height() + 8) + 2 * this->list_->frameWidth());
  this->opacity_->setRange(0, 100);
  this->opacity_->setAccessibleName(tr("Opacity"));
  this->opacity_->setToolTip(tr("How strongly the selected picture is seen"));
  this->add_->setText(tr("Add…"));
  this->add_->setToolTip(tr("Put a picture behind the model, in the present view"));
  this->view_->setText(tr("View"));
  this->view_->setToolTip(tr("Look from where the selected picture is seen"));
  this->remove_->setText(tr("Remove"));
  this->remove_->setToolTip(tr("Take the selected picture out of the scene"));

  auto* row = new QHBoxLayout;
  for (QWidget* one : std::initializer_list<QWidget*>{ this->add_, this->view_, this->remove_ })
  {
    row->addWidget(one);
  }
  row->addWidget(this->opacity_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->list_);
  layout->addLayout(row);
  this->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed); // the history takes the rest

  connect(this->add_, &QToolButton::clicked, this, &ScenePanel::addAsked);
  connect(this->view_, &QToolButton::clicked, this, [this] { emit this->viewAsked(this->current()); });
  connect(
    this->remove_, &QToolButton::clicked, this, [this] { this->document_->removePicture(this->current()); });
  connect(this->list_,
    &QListWidget::currentRowChanged,
    this,
    [this]
    {
      if (!this->filling_)
      {
        this->showPicture();
      }
    });
  connect(this->list_,
    &QListWidget::itemChanged,
    this,
    [this](QListWidgetItem* item)
    {
      if (!this->filling_)
      {
        // The change makes the list anew, which must wait until the list is done with the item.
        const int picture = this->list_->row(item) - 1;
        const bool shown = item->checkState() == Qt::Checked;
        QMetaObject::invokeMethod(
          this, [this, picture, shown] { this->setShown(picture, shown); }, Qt::QueuedConnection);
      }
    });
  // One step of undo for a slide, however long it takes.
  connect(this->opacity_,
    &QSlider::valueChanged,
    this,
    [this](int percent)
    {
      const int at = this->current();
      if (!this->filling_ && at >= 0 && !this->opacity_->isSliderDown())
      {
        Picture picture = *this->document_->session().pictures[static_cast<std::size_t>(at)];
        picture.opacity = 0.01 * percent;
        this->document_->setPicture(at, picture);
      }
    });
  connect(this->opacity_,
    &QSlider::sliderReleased,
    this,
    [this] { emit this->opacity_->valueChanged(this->opacity_->value()); });
  this->refresh();
}

int ScenePanel::current() const
{
  return this->list_->currentRow() - 1; // the model is the first
}

void ScenePanel::refresh()
{
  this->filling_ = true;
  const int before = this->list_->count();
  int row = this->list_->currentRow();
  this->list_->clear();
  if (this->document_->isOpen())
  {
    const auto& session = this->document_->session();
    auto* model = new QListWidgetItem(tr("Model: %1").arg(QString::fromStdString(session.meshName)));
    model->setToolTip(tr("The model as it was opened"));
    this->list_->addItem(model);
    for (const auto& picture : session.pictures)
    {
      auto* item = new QListWidgetItem(QString::fromStdString(picture->image.name));
      item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
      item->setCheckState(picture->shown ? Qt::Checked : Qt::Unchecked);
      item->setToolTip(tr("A picture behind the model, seen in the view that it was put there in"));
      this->list_->addItem(item);
    }
    const int now = this->list_->count();
    row = before > 0 && now == before + 1 ? before : std::min(row, now - 1); // what is new is the hand's next
    this->list_->setCurrentRow(row);
  }
  this->filling_ = false;
  this->showPicture();
}

void ScenePanel::showPicture()
{
  const int at = this->current();
  const bool any = at >= 0;
  this->add_->setEnabled(this->document_->isOpen());
  this->view_->setEnabled(any);
  this->remove_->setEnabled(any);
  this->opacity_->setEnabled(any);
  this->filling_ = true;
  const double opacity =
    any ? this->document_->session().pictures[static_cast<std::size_t>(at)]->opacity : 1.0;
  this->opacity_->setValue(static_cast<int>(std::lround(100.0 * opacity)));
  this->filling_ = false;
}

void ScenePanel::setShown(int at, bool shown)
{
  const auto& pictures = this->document_->session().pictures;
  if (at >= 0 && static_cast<std::size_t>(at) < pictures.size() &&
      pictures[static_cast<std::size_t>(at)]->shown != shown)
  {
    Picture picture = *pictures[static_cast<std::size_t>(at)];
    picture.shown = shown;
    this->document_->setPicture(at, picture);
  }
}

} // namespace oversketch_studio
