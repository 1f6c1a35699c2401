#include "message_text.h"

#include "systems.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <iterator>

namespace oversketch_studio
{

using oversketch::Message;

namespace
{

// A text that is long for whoever has no window to look at, and the window's words for it.
struct Plain
{
  const char* id;
  const char* words;
};
const Plain plain[] = {
  { "The stroke would tear the mesh: %1. Draw it nearer to the outline that it is to replace, of one limb "
    "alone, or, if that is meant, {AllowTorn on}.",
    QT_TRANSLATE_NOOP("Messages", "it would spoil the model: %1.") },
  { "no two samples in succession lie on the mesh; draw it over the model.",
    QT_TRANSLATE_NOOP("Messages", "The line lies beside the model: draw it on the model.") },
  { "nothing of it lies on the mesh; draw it over the model.",
    QT_TRANSLATE_NOOP("Messages", "The line lies beside the model: draw it on the model.") },
  { "it is %1 px long; at least %2 px are needed: draw a longer stroke.",
    QT_TRANSLATE_NOOP("Messages", "Too short: draw at least %2 px.") },
  { "it is %1 px long, %2 times the diagonal of its viewport; at most %3 times are taken: draw one line "
    "along the outline that it is to replace, not a scribble.",
    QT_TRANSLATE_NOOP("Messages", "Too long: draw one line along the outline, no scribble.") },
  { "it is closed: its ends are %1 px apart and it is %2 px long; draw an open stroke.",
    QT_TRANSLATE_NOOP("Messages", "The line is closed: let its ends be apart.") },
  { "Point %1 moved, but the mesh has no point where the plane %2 = %3 reflects it to: the mesh is not "
    "symmetric there; deform it without symmetry.",
    QT_TRANSLATE_NOOP("Messages", "The model is not symmetric about %2 here.") },
  { "The region is empty; draw a stroke on a part of the model with more vertices.",
    QT_TRANSLATE_NOOP("Messages", "The model has too few triangles here.") },
  { "The region reaches the whole model, or a whole separate part of it, so nothing is left to hold it; take "
    "a model with more triangles.",
    QT_TRANSLATE_NOOP("Messages", "The model has too few triangles: take one with more.") },
  { "The region reaches the whole model, or a whole separate part of it, so nothing is left to hold it; draw "
    "a shorter stroke, or one on a part that differs more in thickness from the rest.",
    QT_TRANSLATE_NOOP("Messages", "The line would move the whole model: draw a shorter one.") },
  { "The region reaches the whole model, so nothing is left to hold it; draw a shorter stroke.",
    QT_TRANSLATE_NOOP("Messages", "The line would move the whole model: draw a shorter one.") },
  { "The curve under the sketch takes a step of %1 at sample %2, longer than %3 ({maximumStep}): between the "
    "stroke's ends there is no surface for it to follow. An outline drawn anew is for bumps and dents: draw "
    "nearer to the outline of one part, or pull a limb by one-stroke (or take the projection Path).",
    QT_TRANSLATE_NOOP("Messages",
      "There is no surface between the line's ends: draw nearer to the outline of one part, or pull a limb "
      "with the tool Outline (D).") },
  { "The stroke is %1 px from any outline, more than {maximumGap} = %2 px. Draw it along the outline that it "
    "is to replace.",
    QT_TRANSLATE_NOOP("Messages",
      "The line is %1 px from any outline, more than %2: draw it along the one that it replaces.") },
  { "Fewer than two control points of the section lie on one layer of the mesh; {SingleLayer off} or draw "
    "along another outline.",
    QT_TRANSLATE_NOOP("Messages",
      "The outline lies on several layers of the model here: draw along another.") },
  { "The refinement needs more than {maximumFaces} (%1) new triangles, about %2 or more; ask for longer "
    "edges ({targetEdgeLength}) or a larger tolerance, a smaller {radius} or {maxGeneration}.",
    QT_TRANSLATE_NOOP("Messages",
      "That needs more than %1 new triangles: make them larger, or the radius smaller.") },
  { "{The reference curve} is not all inside {the boundary}: its point %1, vertex %2 of the mesh, lies on "
    "{the boundary} or beyond; draw {the boundary} round the whole reference curve.",
    QT_TRANSLATE_NOOP("Messages", "{The reference curve} is not all inside {the boundary}.") },
};

// A result that is not as drawn, and its parts, for whoever reads on the run. The numbers are in the row's
// tip.
const char* const notAsDrawn = "The result is not as drawn: %1.";
const Plain brief[] = {
  { "the outline misses the stroke by %1 px in the mean and by %2 px at worst",
    QT_TRANSLATE_NOOP("Messages", "the outline is beside the line") },
  { "the outline misses the stroke by %1 px at worst",
    QT_TRANSLATE_NOOP("Messages", "the outline is beside the line") },
  { "between the stroke's ends the outline runs %1 px beside it",
    QT_TRANSLATE_NOOP("Messages", "the outline is beside the line") },
  { "what lies up to %1 px beside the stroke moved too, by up to %2 px",
    QT_TRANSLATE_NOOP("Messages", "parts beside the line moved, too") },
  { "%1 edges are folded over", QT_TRANSLATE_NOOP("Messages", "some of it is folded") },
  { "edges are stretched or squeezed %1 times", QT_TRANSLATE_NOOP("Messages", "some of it is stretched") },
};

template <std::size_t Count>
const char* wordsOf(const Plain (&table)[Count], const std::string& id)
{
  const auto known =
    std::find_if(std::begin(table), std::end(table), [&](const Plain& one) { return id == one.id; });
  return known == std::end(table) ? id.c_str() : known->words;
}

// A setting by its title in a form, and what is to be done with it.
QString titled(const std::string& named)
{
  const std::string property = Message::propertyIn(named), value = Message::valueIn(named);
  for (const oversketch_session::SystemRow& system : oversketch_session::systems())
  {
    if (const auto* parameter = oversketch_session::findParameter(system, property))
    {
      const QString title = QCoreApplication::translate("Systems", parameter->title.c_str());
      return value == "on"    ? QCoreApplication::translate("Messages", "tick %1").arg(title)
             : value == "off" ? QCoreApplication::translate("Messages", "untick %1").arg(title)
             : value.empty()  ? title
                              : title + ' ' + QString::fromStdString(value);
    }
  }
  return QString::fromStdString(Message::asProperty(named));
}

} // namespace

QString plainWords(const Message& message, const Naming& naming)
{
  if (message.id() == Message::unusable("Stroke", 0, {}).id())
  {
    const Message& why = message.arguments()[1].messages.front();
    if (wordsOf(plain, why.id()) != why.id().c_str()) // they say whose it is
    {
      return plainWords(why, naming);
    }
  }
  Message::Wording wording;
  wording.words = [](const std::string& id)
  { return QCoreApplication::translate("Messages", wordsOf(plain, id)).toStdString(); };
  wording.number = [](const std::string& number)
  {
    const QString text = QString::fromStdString(number);
    return text.contains('.') ? QString::number(text.toDouble(), 'g', 3).toStdString() : number;
  };
  wording.name = [&](const std::string& named)
  {
    const QString own = naming ? naming(named) : QString();
    return (own.isEmpty() ? titled(named) : own).toStdString();
  };
  return QString::fromStdString(message.text(wording));
}

QString briefWords(const Message& message)
{
  if (message.id() != notAsDrawn)
  {
    return plainWords(message);
  }
  QStringList said;
  for (const Message& part : message.arguments().front().messages)
  {
    const char* const words = wordsOf(brief, part.id());
    said << (words == part.id().c_str() ? plainWords(part) : QCoreApplication::translate("Messages", words));
  }
  said.removeDuplicates();
  return QCoreApplication::translate("Messages", QT_TRANSLATE_NOOP("Messages", "Not as drawn: %1."))
    .arg(said.join(", "));
}

std::string askedFor(const Message& message)
{
  for (const std::string& named : message.named())
  {
    if (Message::valueIn(named) == "on")
    {
      return Message::propertyIn(named);
    }
  }
  return {};
}

} // namespace oversketch_studio
