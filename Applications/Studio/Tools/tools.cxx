#include "tools.h"

#ifdef OVERSKETCH_WITH_AUGMENT
#include "augment_tool.h"
#endif
#ifdef OVERSKETCH_WITH_INFLATEDRAWING
#include "drawing_tool.h"
#endif
#ifdef OVERSKETCH_WITH_EDIT
#include "direct_tool.h"
#include "edit_hand.h"
#include "profile_tool.h"
#include "shade_tool.h"
#endif
#ifdef OVERSKETCH_WITH_JOIN
#include "join_tool.h"
#endif
#ifdef OVERSKETCH_WITH_MASK
#include "mask_tool.h"
#endif
#include "one_stroke_tool.h"
#ifdef OVERSKETCH_WITH_POSE
#include "pose_tool.h"
#endif
#ifdef OVERSKETCH_WITH_TRANSFORM
#include "place_tool.h"
#endif
#ifdef OVERSKETCH_WITH_RELAX
#include "relax_tool.h"
#endif
#include "system_strings.h"
#include "turn_tool.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace oversketch_studio
{

namespace
{

constexpr int columns = 60; // in a narrow view they are still legible
constexpr int toolsOfARow = 3;

struct KeyListTexts
{
  Q_DECLARE_TR_FUNCTIONS(KeyList)
};

} // namespace

QVector<Tool*> makeTools(Viewport* viewport, const Document* document)
{
#ifdef OVERSKETCH_WITH_EDIT
  const auto hand = std::make_shared<EditHand>(viewport, document);
#endif
  return {
#ifdef OVERSKETCH_WITH_ONESTROKE
    new OneStrokeTool(viewport, document),
#endif
#ifdef OVERSKETCH_WITH_EDIT
    new ShadeTool(hand, viewport),
    new ProfileTool(hand, viewport),
    new DirectTool(hand, viewport),
#endif
#ifdef OVERSKETCH_WITH_POSE
    new PoseTool(viewport, document),
#endif
#ifdef OVERSKETCH_WITH_AUGMENT
    new AugmentTool(viewport, document),
#endif
#ifdef OVERSKETCH_WITH_RELAX
    new RelaxTool(viewport, document),
#endif
#ifdef OVERSKETCH_WITH_MASK
    new MaskTool(viewport, document),
#endif
#ifdef OVERSKETCH_WITH_INFLATEDRAWING
    new DrawingTool(viewport, document),
#endif
#ifdef OVERSKETCH_WITH_TRANSFORM
    new PlaceTool(viewport, document),
#endif
#ifdef OVERSKETCH_WITH_JOIN
    new JoinTool(viewport, document),
#endif
    new TurnTool(viewport),
  };
}

QString keyList(const Tool& tool, const QVector<Tool*>& all)
{
  using T = KeyListTexts;
  QVector<QPair<QString, QString>> rows = tool.keys();
  rows += {
    { T::tr("Pen pressure"), tool.pressure() },
    { T::tr("Middle drag"), T::tr("turn (or Alt, Ctrl or Space + left drag, or two fingers)") },
    { T::tr("Right drag"), T::tr("pan (or Alt or Shift + middle drag)") },
    { T::tr("Shift + left drag"), T::tr("on the model: smooth it; beside it: pan") },
    { T::tr("Wheel"), T::tr("zoom at the cursor (or pinch, or Ctrl + Shift + left drag)") },
    { T::tr("Click"), T::tr("on another model of the scene: draw on that one") },
    { T::tr("Escape"), T::tr("drop the line being drawn; take a drag back; leave the row") },
    { T::tr("Backspace"), T::tr("take the end of the line being drawn back") },
    { T::tr("Return"), T::tr("leave the red line, to draw where it is") },
    { {}, {} },
    { "x  y  z", T::tr("look along an axis (Shift: against it)") },
    { "1  2  3", T::tr("turn clockwise about x, y, z (Shift: counter-clockwise)") },
    { "i  m  j  k", T::tr("rotate up, down, left, right (Shift: pan)") },
    { "r  l  h", T::tr("spin counter-clockwise (r, l), clockwise (h)") },
    { "p  n", T::tr("zoom out, in (Shift: pan in, out)") },
    { "w  c", T::tr("back to the first view; centre on the model (Home: fit it)") },
    { "Ctrl+1-6", T::tr("from the front, right, top, back, left, bottom") },
    { "5", T::tr("orthographic or perspective") },
    { "u", T::tr("while held: the model before the selected step") },
    { "o  f", T::tr("show what moves; show what models wear") },
  };
  for (int i = 0; i < all.size(); i += toolsOfARow)
  {
    QStringList keys, names;
    for (const Tool* one : all.mid(i, toolsOfARow))
    {
      keys << one->key().toString().toLower();
      names << one->name();
    }
    rows.push_back({ keys.join("  "), names.join("; ") });
  }
  rows.push_back({ "?  F1", T::tr("show or hide this list") });
  rows.push_back({ "Ctrl+Q", T::tr("quit") });
  int widest = 0;
  for (const auto& row : rows)
  {
    widest = std::max(widest, row.first.size());
  }
  QStringList lines{ T::tr("Tool: %1").arg(tool.name()), QString() };
  for (const auto& [hand, what] : rows)
  {
    if (what.isEmpty())
    {
      lines << hand; // a heading has no keys
      continue;
    }
    QString before = hand.leftJustified(widest + 2);
    for (const QString& line : wrapped(what, columns - before.size()))
    {
      lines << before + line;
      before.fill(' ');
    }
  }
  return lines.join('\n');
}

} // namespace oversketch_studio
