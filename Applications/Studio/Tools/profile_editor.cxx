#include "profile_editor.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStringList>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace oversketch_studio
{

namespace
{

constexpr double lowest = -0.5, highest = 1.0; // that a point can be dragged to; 1 is the height of the line
constexpr double apart = 0.02;                 // least, of two points along x
constexpr double pointGrabDistance = 9.0;      // px
constexpr double keyStep = 0.05;               // of a key
constexpr int mostPoints = 16;
constexpr double profileMargin = 10.0; // px

struct Preset
{
  const char* name;
  const char* text; // empty: by the sharpness
};

// The paper's own shapes are the powers; its sharp one is the first.
constexpr double creaseSharpness = 1.5;
const Preset presets[] = {
  { QT_TRANSLATE_NOOP("oversketch_studio::ProfileEditor", "Crease"), "" },
  { QT_TRANSLATE_NOOP("oversketch_studio::ProfileEditor", "Ridge"), "0 1, 1 0" },
  { QT_TRANSLATE_NOOP("oversketch_studio::ProfileEditor", "Round"),
    "0 1, 0.15 0.97, 0.3 0.86, 0.45 0.68, 0.6 0.46, 0.75 0.23, 0.9 0.05, 1 0" },
  { QT_TRANSLATE_NOOP("oversketch_studio::ProfileEditor", "Plateau"),
    "0 1, 0.5 1, 0.6 0.93, 0.8 0.17, 0.9 0.03, 1 0" },
  { QT_TRANSLATE_NOOP("oversketch_studio::ProfileEditor", "Groove"),
    "0 -0.3, 0.12 -0.25, 0.26 0.1, 0.4 0.6, 0.52 0.8, 0.64 0.75, 0.78 0.4, 0.9 0.1, 1 0" },
};

QVector<QPointF> pointsOf(const std::string& text, double sharpness)
{
  QVector<QPointF> points;
  const QLocale plain = QLocale::c();
  for (const QString& part : QString::fromStdString(text).split(',', Qt::SkipEmptyParts))
  {
    const QStringList numbers = part.simplified().split(' ');
    points << QPointF(plain.toDouble(numbers.first()), plain.toDouble(numbers.last()));
  }
  if (points.size() < 2)
  {
    points.clear();
    for (int i = 0; i <= 6; ++i)
    {
      const double x = i / 6.0;
      points << QPointF(x, std::pow(1.0 - x, sharpness));
    }
  }
  return points;
}

std::string textOf(const QVector<QPointF>& points)
{
  QStringList parts;
  for (const QPointF& point : points)
  {
    parts << QString::number(point.x(), 'g', 4) + ' ' + QString::number(point.y(), 'g', 4);
  }
  return parts.join(", ").toStdString();
}

} // namespace

ProfileEditor::ProfileEditor(QWidget* parent)
  : QWidget(parent)
  , Presets(new QComboBox(this))
  , Curve(new ProfileCurve(this))
{
  for (const Preset& preset : presets)
  {
    this->Presets->addItem(tr(preset.name));
  }
  this->Presets->addItem(tr("Own shape"));
  this->Presets->setObjectName("profile_presets");
  this->Presets->setAccessibleName(tr("Shape of the profile"));
  this->Presets->setToolTip(tr("A shape to begin with"));
  connect(this->Presets,
    QOverload<int>::of(&QComboBox::activated),
    this,
    [this](int choice)
    {
      if (choice < static_cast<int>(std::size(presets)))
      {
        this->setShape(presets[choice].text, creaseSharpness);
        emit this->shaped(false);
      }
      this->showName();
    });
  auto* column = new QVBoxLayout(this);
  column->addWidget(this->Presets);
  column->addWidget(this->Curve, 1);
  const auto round = std::find_if(std::begin(presets),
    std::end(presets),
    [](const Preset& one) { return std::string(one.name) == "Round"; });
  this->setShape(round->text, creaseSharpness);
}

void ProfileEditor::setShape(const std::string& profile, double sharpness)
{
  if (profile == this->Text && sharpness == this->Sharpness && !this->Points.isEmpty())
  {
    return; // what the hand has just made comes back
  }
  this->Text = profile;
  this->Sharpness = sharpness;
  this->Points = pointsOf(profile, sharpness);
  this->Curve->forget();
  this->showName();
}

void ProfileEditor::showName()
{
  int choice = 0;
  for (const Preset& preset : presets)
  {
    if (this->Text == preset.text && (!this->Text.empty() || this->Sharpness == creaseSharpness))
    {
      break;
    }
    ++choice;
  }
  this->Presets->setCurrentIndex(choice);
}

void ProfileEditor::pointsChanged(bool mergesIntoLast)
{
  this->Text = textOf(this->Points);
  this->showName();
  this->Curve->update();
  emit this->shaped(mergesIntoLast);
}

ProfileCurve::ProfileCurve(ProfileEditor* editor)
  : QWidget(editor)
  , Editor(editor)
{
  this->setObjectName("profile_curve");
  this->setAccessibleName(tr("Profile across the line"));
  this->setToolTip(tr("Drag a point; click beside them to add one, right click or Delete to take one away. "
                      "By keys: Page Up and Down choose a point, arrows move it, Insert adds one."));
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMouseTracking(true); // the cursor says what can be dragged
}

void ProfileCurve::forget()
{
  this->Chosen = -1;
  this->Dragging = false;
  this->update();
}

QPointF ProfileCurve::seen(const QPointF& point) const
{
  const double half = 0.5 * this->width() - profileMargin, tall = this->height() - 2.0 * profileMargin;
  return { 0.5 * this->width() + half * point.x(),
    profileMargin + tall * (highest - point.y()) / (highest - lowest) };
}

QPointF ProfileCurve::pointAt(const QPoint& place) const
{
  const double half = 0.5 * this->width() - profileMargin, tall = this->height() - 2.0 * profileMargin;
  return { (place.x() - 0.5 * this->width()) / half,
    highest - (highest - lowest) * (place.y() - profileMargin) / tall };
}

int ProfileCurve::nearest(const QPoint& place) const
{
  int found = -1;
  double least = pointGrabDistance;
  for (int i = 0; i < this->points().size(); ++i)
  {
    const QPointF off = this->seen(this->points()[i]) - place;
    const double distance = std::hypot(off.x(), off.y());
    if (distance < least)
    {
      least = distance;
      found = i;
    }
  }
  return found;
}

void ProfileCurve::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPalette& look = this->palette();
  painter.fillRect(this->rect(), look.color(QPalette::Base));
  const QColor line(251, 158, 51), faint = look.color(QPalette::Disabled, QPalette::Text);
  painter.setPen(QPen(faint, 1.0, Qt::DashLine));
  for (const double y : { 0.0, 1.0 })
  {
    painter.drawLine(this->seen({ -1.0, y }), this->seen({ 1.0, y }));
  }
  painter.drawLine(this->seen({ 0.0, lowest }), this->seen({ 0.0, highest }));
  QPainterPath right, left, body;
  for (int i = 0; i < this->points().size(); ++i)
  {
    const QPointF& p = this->points()[i];
    i == 0 ? right.moveTo(this->seen(p)) : right.lineTo(this->seen(p));
    const QPointF mirrored = this->seen({ -p.x(), p.y() });
    i == 0 ? left.moveTo(mirrored) : left.lineTo(mirrored);
  }
  body = left.toReversed();
  body.connectPath(right);
  body.closeSubpath();
  QColor fill = line;
  fill.setAlphaF(0.25);
  painter.fillPath(body, fill);
  QColor pale = line;
  pale.setAlphaF(0.5);
  painter.setPen(QPen(pale, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(left);
  painter.setPen(QPen(line, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(right);
  for (int i = 0; i + 1 < this->points().size(); ++i)
  {
    const bool chosen = i == this->Chosen;
    painter.setPen(QPen(look.color(QPalette::Text), 1.5));
    painter.setBrush(chosen ? look.color(QPalette::Highlight) : look.color(QPalette::Base));
    painter.drawEllipse(this->seen(this->points()[i]), chosen ? 5.0 : 4.0, chosen ? 5.0 : 4.0);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(
    QPen(this->hasFocus() ? look.color(QPalette::Highlight) : faint, this->hasFocus() ? 2.0 : 1.0));
  painter.drawRect(QRectF(this->rect()).adjusted(1, 1, -1, -1));
}

// Between its neighbours; the first stays on the line.
void ProfileCurve::moveTo(int point, QPointF to, bool mergesIntoLast)
{
  QVector<QPointF>& all = this->Editor->Points;
  to.setX(point == 0 ? 0.0 : std::clamp(to.x(), all[point - 1].x() + apart, all[point + 1].x() - apart));
  to.setY(std::clamp(to.y(), lowest, highest));
  if (to != all[point])
  {
    all[point] = to;
    this->Editor->pointsChanged(mergesIntoLast);
  }
}

int ProfileCurve::insert(const QPointF& point)
{
  QVector<QPointF>& all = this->Editor->Points;
  const auto after =
    std::find_if(all.begin(), all.end(), [&](const QPointF& one) { return one.x() > point.x(); });
  const int at = static_cast<int>(after - all.begin());
  if (at == 0 || at == all.size() || all.size() >= mostPoints || point.x() - all[at - 1].x() < apart ||
      all[at].x() - point.x() < apart)
  {
    return -1;
  }
  all.insert(at, { point.x(), std::clamp(point.y(), lowest, highest) });
  this->Editor->pointsChanged(false);
  return at;
}

// The line's own point and the foot stay.
void ProfileCurve::remove(int point)
{
  if (point > 0 && this->isMovable(point))
  {
    this->Editor->Points.remove(point);
    this->Chosen = -1;
    this->Editor->pointsChanged(false);
  }
}

void ProfileCurve::mousePressEvent(QMouseEvent* event)
{
  const int found = this->nearest(event->pos());
  if (event->button() == Qt::RightButton)
  {
    this->remove(found);
    return;
  }
  if (event->button() != Qt::LeftButton)
  {
    return;
  }
  this->Dragged = found < 0; // one that has just been added goes on being dragged
  this->Chosen = found >= 0 ? found : this->insert(this->pointAt(event->pos()));
  this->Dragging = this->isMovable(this->Chosen);
  this->update();
}

void ProfileCurve::mouseMoveEvent(QMouseEvent* event)
{
  if (this->Dragging)
  {
    this->moveTo(this->Chosen, this->pointAt(event->pos()), this->Dragged);
    this->Dragged = true;
  }
  else
  {
    this->setCursor(this->isMovable(this->nearest(event->pos())) ? Qt::PointingHandCursor : Qt::CrossCursor);
  }
}

void ProfileCurve::mouseReleaseEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton)
  {
    this->Dragging = false;
  }
}

void ProfileCurve::keyPressEvent(QKeyEvent* event)
{
  const int last = this->points().size() - 2; // that can be moved
  const auto move = [&](double x, double y)
  {
    if (this->isMovable(this->Chosen))
    {
      this->moveTo(this->Chosen, this->points()[this->Chosen] + QPointF(x, y), event->isAutoRepeat());
    }
  };
  switch (event->key())
  {
    case Qt::Key_PageDown:
      this->Chosen = std::min(this->Chosen + 1, last);
      break;
    case Qt::Key_PageUp:
      this->Chosen = std::max(this->Chosen - 1, 0);
      break;
    case Qt::Key_Left:
      move(-keyStep, 0.0);
      break;
    case Qt::Key_Right:
      move(keyStep, 0.0);
      break;
    case Qt::Key_Up:
      move(0.0, keyStep);
      break;
    case Qt::Key_Down:
      move(0.0, -keyStep);
      break;
    case Qt::Key_Delete:
      this->remove(this->Chosen);
      break;
    case Qt::Key_Insert:
      if (this->isMovable(this->Chosen))
      {
        const int added =
          this->insert(0.5 * (this->points()[this->Chosen] + this->points()[this->Chosen + 1]));
        this->Chosen = added >= 0 ? added : this->Chosen;
      }
      break;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  this->update();
}

} // namespace oversketch_studio
