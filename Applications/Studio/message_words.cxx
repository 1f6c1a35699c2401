#include "message_words.h"

#include "systems.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cstring>
#include <iterator>

namespace oversketch_studio
{

namespace
{

// What is said at length for whoever has no window to look at.
struct Plain
{
  const char* pattern;
  const char* words;
};
const Plain plain[] = {
  { "^The stroke would tear the mesh: edges are stretched or squeezed (\\S+) times",
    QT_TRANSLATE_NOOP("Messages", "it would stretch the limb %1 times.") },
  { "^The stroke would tear the mesh: (\\S+) % of the surface moved",
    QT_TRANSLATE_NOOP("Messages", "it would move %1 % of the model.") },
  { "^Stroke \\d+ cannot be used: no two samples in succession lie on the mesh",
    QT_TRANSLATE_NOOP("Messages", "the line lies beside the model: draw it on the model.") },
  { "^Stroke \\d+ cannot be used: it is \\S+ px long; at least (\\S+) px are needed",
    QT_TRANSLATE_NOOP("Messages", "Too short: draw at least %1 px.") },
  { "^Stroke \\d+ cannot be used: it is \\S+ px long, \\S+ times the diagonal",
    QT_TRANSLATE_NOOP("Messages", "Too long: draw one line along the outline, no scribble.") },
  { "^Stroke \\d+ cannot be used: it is closed",
    QT_TRANSLATE_NOOP("Messages", "The line is closed: let its ends be apart.") },
  { "^Point \\d+ moved, but the mesh has no point where the plane ([xyz]) = ",
    QT_TRANSLATE_NOOP("Messages", "The model is not symmetric about %1 here.") },
  { "^The region is empty; draw a stroke on a part",
    QT_TRANSLATE_NOOP("Messages", "The model has too few triangles here.") },
  { "^The region reaches the whole model.*; take a model with more triangles",
    QT_TRANSLATE_NOOP("Messages", "The model has too few triangles: take one with more.") },
  { "^The region reaches the whole model",
    QT_TRANSLATE_NOOP("Messages", "The line would move the whole model: draw a shorter one.") },
  { "^The stroke is (\\S+) px from any outline, more than MaximumGap = (\\S+) px",
    QT_TRANSLATE_NOOP("Messages",
      "The line is %1 px from any outline, more than %2: draw it along the one that it replaces.") },
  { "^Fewer than two control points of the section lie on one layer",
    QT_TRANSLATE_NOOP("Messages",
      "The outline lies on several layers of the model here: draw along another.") },
  { "^.*step of \\S+ at sample \\d+, longer than \\S+ \\(MaximumStep\\)",
    QT_TRANSLATE_NOOP("Messages",
      "There is no surface between the line's ends: draw nearer to the outline of one part, or pull a limb "
      "with the tool Outline (D).") },
  { "^.*more than MaximumFaces \\((\\d+)\\) new triangles",
    QT_TRANSLATE_NOOP("Messages",
      "That needs more than %1 new triangles: make them larger, or the radius smaller.") },
};

// Parts of a remark on a result that is not as drawn, for whoever reads on the run. The numbers are in the
// row's tip.
const char* const notAsDrawn = "The result is not as drawn: ";
const Plain brief[] = {
  { "^the outline misses the stroke", QT_TRANSLATE_NOOP("Messages", "the outline is beside the line") },
  { "^between the stroke's ends the outline",
    QT_TRANSLATE_NOOP("Messages", "the outline is beside the line") },
  { "^what lies up to .* beside the stroke moved too",
    QT_TRANSLATE_NOOP("Messages", "parts beside the line moved, too") },
  { "edges are folded over", QT_TRANSLATE_NOOP("Messages", "some of it is folded") },
  { "edges are stretched or squeezed", QT_TRANSLATE_NOOP("Messages", "some of it is stretched") },
};

QString inserted(QString words, const QStringList& values)
{
  for (int i = 0; i < values.size(); ++i)
  {
    words.replace('%' + QString::number(i + 1), values[i]);
  }
  return words;
}

// How a filter speaks of a property, by the window's words for it.
struct Asked
{
  const char* before;
  const char* after;
  const char* words;
};
const Asked asked[] = {
  { "turn ", " on", QT_TRANSLATE_NOOP("Messages", "tick %1") },
  { "turn ", " off", QT_TRANSLATE_NOOP("Messages", "untick %1") },
  { "Lower ", ".", QT_TRANSLATE_NOOP("Messages", "Lower %1.") },
};

// "turn AllowTorn on" as the window's form has it.
QString withTitles(QString text)
{
  for (const oversketch_session::SystemRow& system : oversketch_session::systems())
  {
    for (const oversketch_session::Parameter& parameter : system.parameters)
    {
      for (const Asked& one : asked)
      {
        const QString said = one.before + QString::fromStdString(parameter.property) + one.after;
        if (text.contains(said))
        {
          text.replace(said,
            QCoreApplication::translate("Messages", one.words)
              .arg(QCoreApplication::translate("Systems", parameter.title.c_str())));
        }
      }
    }
  }
  return text;
}

} // namespace

QString plainWords(const std::string& message)
{
  const QString text = QString::fromStdString(message);
  for (const Plain& one : plain)
  {
    const auto match = QRegularExpression(one.pattern).match(text);
    if (match.hasMatch())
    {
      return inserted(QCoreApplication::translate("Messages", one.words), match.capturedTexts().mid(1));
    }
  }
  // Numbers that stand alone; those in names of files are the names'.
  static const QRegularExpression number("(?<![\\w.%/-])-?\\d+(?:\\.\\d+)?(?:e[+-]?\\d+)?(?![\\w/]|\\.\\w)");
  QString pattern;
  QStringList values;
  int end = 0;
  for (auto found = number.globalMatch(text); found.hasNext() && values.size() < 9;)
  {
    const auto one = found.next();
    pattern += text.mid(end, one.capturedStart() - end) + '%' + QString::number(values.size() + 1);
    const QString value = one.captured();
    values << (value.contains('.') ? QString::number(value.toDouble(), 'g', 3) : value);
    end = one.capturedEnd();
  }
  pattern += text.mid(end);
  return text.isEmpty() ? text
                        : withTitles(inserted(
                            QCoreApplication::translate("Messages", pattern.toUtf8().constData()), values));
}

QString briefWords(const std::string& message)
{
  const QString text = QString::fromStdString(message);
  if (!text.startsWith(notAsDrawn))
  {
    return plainWords(message);
  }
  QStringList said;
  QString parts = text.mid(static_cast<int>(std::strlen(notAsDrawn)));
  parts.chop(parts.endsWith('.') ? 1 : 0);
  for (const QString& part : parts.split("; "))
  {
    const auto known = std::find_if(std::begin(brief),
      std::end(brief),
      [&](const Plain& one) { return QRegularExpression(one.pattern).match(part).hasMatch(); });
    said << (known != std::end(brief) ? QCoreApplication::translate("Messages", known->words)
                                      : plainWords(part.toStdString()));
  }
  said.removeDuplicates();
  return QCoreApplication::translate("Messages", QT_TRANSLATE_NOOP("Messages", "Not as drawn: %1."))
    .arg(said.join(", "));
}

QString askedFor(const std::string& message)
{
  static const QRegularExpression turn("\\bturn ([A-Z]\\w+) on\\b");
  return turn.match(QString::fromStdString(message)).captured(1);
}

} // namespace oversketch_studio
