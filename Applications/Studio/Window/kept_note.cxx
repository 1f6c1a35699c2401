#include "kept_note.h"

#include "document.h"

#include <QLocale>
#include <QTime>

namespace oversketch_studio
{

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
