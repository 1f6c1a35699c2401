#include "status_labels.h"

#include "document.h"

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QStyle>
#include <QTime>
#include <QToolTip>

#include <algorithm>

namespace oversketch_studio
{

namespace
{

constexpr double smallest = 0.85; // of the window's letters

} // namespace

AdviceLabel::AdviceLabel(QWidget* parent)
  : QLabel(parent)
{
  this->setObjectName("advice");
  this->setIndent(6);
  this->setTextFormat(Qt::PlainText);                                // names of files may look like markup
  this->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // no text widens the window
  this->setFixedHeight(2 * this->fontMetrics().lineSpacing());
}

QFont AdviceLabel::fitting() const
{
  QFont font = this->font();
  const double whole = font.pointSizeF();
  for (double size = whole; !this->fits(this->text(), font) && size > smallest * whole;)
  {
    size = std::max(size - 0.5, smallest * whole);
    font.setPointSizeF(size);
  }
  return font;
}

QString AdviceLabel::shown() const
{
  const QFont font = this->fitting();
  QString text = this->text();
  if (this->fits(text, font))
  {
    return text;
  }
  int most = 0; // words, each with the space before it
  for (int end = text.indexOf(' '); end >= 0 && this->fits(text.left(end) + QChar(0x2026), font);
       end = text.indexOf(' ', end + 1))
  {
    most = end;
  }
  return text.left(most) + QChar(0x2026);
}

bool AdviceLabel::event(QEvent* event)
{
  if (event->type() != QEvent::ToolTip)
  {
    return QLabel::event(event);
  }
  // The whole, where it is not seen; names of files may look like markup.
  const QString whole =
    this->shown() == this->text() ? QString() : "<p>" + this->text().toHtmlEscaped() + "</p>";
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), whole, this);
  return true;
}

// A label that wraps by itself asks its window for more height than it needs.
void AdviceLabel::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setFont(this->fitting());
  this->style()->drawItemText(&painter,
    this->room(this->height()),
    Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
    this->palette(),
    this->isEnabled(),
    this->shown(),
    this->foregroundRole());
}

bool AdviceLabel::fits(const QString& text, const QFont& font) const
{
  return QFontMetrics(font).boundingRect(this->room(QWIDGETSIZE_MAX), Qt::TextWordWrap, text).height() <=
         this->height();
}

QRect AdviceLabel::room(int height) const
{
  return { this->indent(), 0, std::max(0, this->width() - this->indent()), height };
}

KeptNote::KeptNote(const Document* document, QWidget* parent)
  : QLabel(parent)
  , OpenDocument(document)
{
  this->setObjectName("kept");
  connect(document, &Document::kept, this, &KeptNote::follow);
  connect(document, &Document::begun, this, [this] { this->Saved = false; });
  connect(document,
    &Document::changed,
    this,
    [this](Document::Change change) { this->Saved = this->Saved || change == Document::Change::Saved; });
}

void KeptNote::follow()
{
  const bool isSaved = !this->OpenDocument->isModified();
  if (isSaved && (this->OpenDocument->path().isEmpty() || !this->Saved))
  {
    this->clear(); // nothing has been done
    this->setToolTip({});
    return;
  }
  const QString time = QLocale().toString(QTime::currentTime(), QLocale::ShortFormat);
  this->setText(isSaved ? tr("saved %1").arg(time) : tr("kept %1").arg(time));
  this->setToolTip(isSaved ? tr("All of it is in %1").arg(this->OpenDocument->path())
                           : tr("A crash loses nothing of it. Ctrl+S saves it in a file of your own."));
}

} // namespace oversketch_studio
