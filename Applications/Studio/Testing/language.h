// A made-up language: every text of the window is marked and longer, and a translation into it is a file as
// any other.
#ifndef oversketch_applications_studio_testing_language_h
#define oversketch_applications_studio_testing_language_h

#include <QRegularExpression>
#include <QStringList>
#include <QTranslator>

#include <map>
#include <utility>

class QWidget;

namespace oversketch_studio
{

// The texts that were asked for, by context and source.
using Texts = std::map<std::pair<QByteArray, QByteArray>, QString>;

inline const QString languageMark = QString::fromUtf8("¡");

// Keys and patterns of files stay what they are.
inline QString inMadeUpLanguage(const QString& text)
{
  static const QRegularExpression keys(
    "^(?:(?:Ctrl|Shift|Alt)\\+)*(?:[A-Z0-9,\\[\\]?]|F\\d+|Up|Down|Delete)$");
  if (keys.match(text).hasMatch())
  {
    return text;
  }
  // A third longer, as German and Finnish are, in words of their length.
  QString more;
  for (int i = 0; i < text.size() / 3; ++i)
  {
    more += i % 8 == 0 ? ' ' : "lokunimera"[i % 10];
  }
  return languageMark + text + more;
}

// Marks what was asked for, and remembers it.
class Listener : public QTranslator
{
public:
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char*, int) const override
  {
    QString& text = this->heard[{ context, source }];
    text = inMadeUpLanguage(QString::fromUtf8(source));
    return text;
  }
  mutable Texts heard;
};

// All texts of a widget and those in it, also what a screen reader says and what is not seen now.
QStringList textsOf(const QWidget& root);

// Those that lupdate cannot find, for Linguist.
void writeForLinguist(const QString& path, const Texts& texts);

// A file as lrelease makes it: Qt's compiled messages.
void writeTranslation(const QString& path, const Texts& texts);

} // namespace oversketch_studio
#endif
