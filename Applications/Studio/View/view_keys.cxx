#include "view_keys.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QOpenGLWidget>
#include <QTextEdit>

#include <utility>

namespace oversketch_studio
{

namespace
{

bool takesText(const QWidget* widget)
{
  const auto* choice = qobject_cast<const QComboBox*>(widget);
  return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
         qobject_cast<const QTextEdit*>(widget) || (choice && choice->isEditable());
}

} // namespace

ViewKeys::ViewKeys(QWidget* view, std::function<bool()> isBusy)
  : QObject(view)
  , View(view)
  , IsBusy(std::move(isBusy))
{
  QApplication::instance()->installEventFilter(this);
}

bool ViewKeys::isForView(const QWidget* focus, const QKeyEvent& event) const
{
  constexpr Qt::KeyboardModifiers commands = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
  const QString text = event.text();
  const bool isSign = !text.isEmpty() && text[0].isPrint() && !text[0].isSpace();
  const bool isEscape = event.key() == Qt::Key_Escape && !qobject_cast<const QAbstractItemView*>(focus);
  // Another canvas has keys of its own.
  return !(event.modifiers() & commands) && (isSign || isEscape) && !takesText(focus) &&
         !qobject_cast<const QOpenGLWidget*>(focus);
}

bool ViewKeys::eventFilter(QObject* watched, QEvent* event)
{
  const bool isPress = event->type() == QEvent::KeyPress;
  auto* focus = qobject_cast<QWidget*>(watched);
  if (event->type() == QEvent::ShortcutOverride && focus && focus->window() == this->View->window() &&
      this->IsBusy())
  {
    event->accept(); // the key is the hand's
    return true;
  }
  if (isPress && focus == this->View && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
  {
    emit this->escaped();
  }
  if ((!isPress && event->type() != QEvent::KeyRelease) || !focus || focus == this->View ||
      focus->window() != this->View->window() || !focus->hasFocus())
  {
    return false;
  }
  auto* key = static_cast<QKeyEvent*>(event);
  if (this->isForView(focus, *key))
  {
    QApplication::sendEvent(this->View, event);
    return true;
  }
  const bool ends =
    key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter || key->key() == Qt::Key_Escape;
  if (isPress && ends && qobject_cast<const QAbstractSpinBox*>(focus))
  {
    // The number is taken first.
    QMetaObject::invokeMethod(
      this, [this] { this->View->setFocus(); }, Qt::QueuedConnection);
  }
  return false;
}

} // namespace oversketch_studio
