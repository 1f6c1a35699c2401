#include "key_list.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <utility>
#include <vector>

namespace oversketch_studio
{

namespace
{

struct Texts
{
  Q_DECLARE_TR_FUNCTIONS(KeyList)
};

} // namespace

QString keyList(bool drawing)
{
  using T = Texts;
  const std::vector<std::pair<QString, QString>> rows = {
    { T::tr("Left drag"), drawing ? T::tr("draw; on the red line: move it") : T::tr("turn the model") },
    { T::tr("Shift + left drag"),
      drawing ? T::tr("on the red line: draw a part anew; else: pan") : T::tr("pan") },
    { T::tr("Middle drag"), T::tr("turn (or Ctrl + left drag)") },
    { T::tr("Right drag"), T::tr("pan") },
    { T::tr("Wheel"), T::tr("zoom (or Ctrl + Shift + left drag)") },
    { T::tr("Escape"), T::tr("drop the line being drawn; take a drag back") },
    { T::tr("Backspace"), T::tr("take the end of the line being drawn back") },
    { T::tr("Return"), T::tr("leave the red line, to draw where it is") },
    { {}, {} },
    { "x  y  z", T::tr("look along an axis (Shift: against it)") },
    { "1  2  3", T::tr("turn clockwise about x, y, z (Shift: counter-clockwise)") },
    { "i  m  j  k", T::tr("rotate up, down, left, right (Shift: pan)") },
    { "r  l  h", T::tr("spin counter-clockwise (r, l), clockwise (h)") },
    { "p  n", T::tr("zoom out, in (Shift: pan in, out)") },
    { "w  c", T::tr("back to the first view; centre on the model") },
    { "d  t  o", T::tr("draw; turn; show what moves") },
    { "?  F1", T::tr("show or hide this list") },
    { "q", T::tr("quit") },
  };
  int widest = 0;
  for (const auto& row : rows)
  {
    widest = std::max(widest, row.first.size());
  }
  QStringList lines{ drawing ? T::tr("Mode: draw") : T::tr("Mode: turn"), QString() };
  for (const auto& [keys, what] : rows)
  {
    lines << (what.isEmpty() ? QString() : keys.leftJustified(widest + 3) + what);
  }
  return lines.join('\n');
}

} // namespace oversketch_studio
