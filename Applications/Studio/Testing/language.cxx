#include "language.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDataStream>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QXmlStreamWriter>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace oversketch_studio
{

namespace
{

// As Qt finds a text in the file: the hash of ELF.
quint32 hashOf(const QByteArray& source)
{
  quint32 hash = 0;
  for (const char letter : source)
  {
    hash = (hash << 4) + static_cast<uchar>(letter);
    const quint32 high = hash & 0xf0000000U;
    hash ^= high >> 24;
    hash &= ~high;
  }
  return hash == 0 ? 1 : hash;
}

enum Tag : quint8
{
  End = 1,
  Translation = 3,
  SourceText = 6,
  Context = 7
};
enum Section : quint8
{
  Hashes = 0x42,
  Messages = 0x69
};

void addTexts(const QWidget* widget, QStringList& texts)
{
  texts << widget->toolTip() << widget->windowTitle() << widget->accessibleName();
  if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
  {
    texts << button->text();
  }
  if (const auto* label = qobject_cast<const QLabel*>(widget))
  {
    texts << label->text();
  }
  if (const auto* choice = qobject_cast<const QComboBox*>(widget))
  {
    for (int i = 0; i < choice->count(); ++i)
    {
      texts << choice->itemText(i);
    }
  }
  if (const auto* list = qobject_cast<const QListWidget*>(widget))
  {
    for (int i = 0; i < list->count(); ++i)
    {
      texts << list->item(i)->text() << list->item(i)->toolTip();
    }
  }
  if (const auto* menu = qobject_cast<const QMenu*>(widget))
  {
    texts << menu->title();
  }
}

} // namespace

QStringList textsOf(const QWidget& root)
{
  QStringList texts;
  addTexts(&root, texts);
  for (const QWidget* widget : root.findChildren<QWidget*>())
  {
    addTexts(widget, texts);
  }
  for (const QAction* action : root.findChildren<QAction*>())
  {
    texts << action->text() << action->toolTip();
  }
  return texts;
}

void writeForLinguist(const QString& path, const Texts& texts)
{
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  QXmlStreamWriter xml(&file);
  xml.setAutoFormatting(true);
  xml.writeStartDocument();
  xml.writeStartElement("TS");
  xml.writeAttribute("version", "2.1");
  for (const char* context : { "Systems", "Messages" })
  {
    xml.writeStartElement("context");
    xml.writeTextElement("name", context);
    for (const auto& [of, text] : texts)
    {
      if (of.first == context)
      {
        xml.writeStartElement("message");
        xml.writeTextElement("source", QString::fromUtf8(of.second));
        xml.writeStartElement("translation");
        xml.writeAttribute("type", "unfinished");
        xml.writeEndElement();
        xml.writeEndElement();
      }
    }
    xml.writeEndElement();
  }
  xml.writeEndDocument();
}

void writeTranslation(const QString& path, const Texts& texts)
{
  QByteArray messages;
  QDataStream into(&messages, QIODevice::WriteOnly);
  std::vector<std::pair<quint32, quint32>> places;
  for (const auto& [of, text] : texts)
  {
    const auto& [context, source] = of;
    places.emplace_back(hashOf(source), static_cast<quint32>(messages.size()));
    into << quint8(Translation) << static_cast<quint32>(2 * text.size());
    for (const QChar letter : text)
    {
      into << letter.unicode();
    }
    into << quint8(SourceText) << source << quint8(Context) << context << quint8(End);
  }
  std::sort(places.begin(), places.end());
  QByteArray hashes;
  QDataStream list(&hashes, QIODevice::WriteOnly);
  for (const auto& [hash, place] : places)
  {
    list << hash << place;
  }
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  QDataStream out(&file);
  for (const int magic :
    { 0x3c, 0xb8, 0x64, 0x18, 0xca, 0xef, 0x9c, 0x95, 0xcd, 0x21, 0x1c, 0xbf, 0x60, 0xa1, 0xbd, 0xdd })
  {
    out << static_cast<quint8>(magic);
  }
  out << quint8(Hashes) << hashes << quint8(Messages) << messages;
}

} // namespace oversketch_studio
