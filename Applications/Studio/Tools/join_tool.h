// A line across the place where parts of the model meet: they are one body, with a seam as wide as the line
// is long.
#ifndef oversketch_applications_studio_tools_join_tool_h
#define oversketch_applications_studio_tools_join_tool_h

#include "held_stroke_tool.h"

namespace oversketch_studio
{

class JoinTool : public HeldStrokeTool
{
  Q_OBJECT

public:
  JoinTool(Viewport* viewport, const Document* document);

  QString title() const override { return tr("&Join"); }
  QKeySequence key() const override { return tr("8"); }
  QString help() const override
  {
    return tr("Draw across the place where parts meet, and they are one body, with a seam so wide (8). The "
              "middle button always turns.");
  }
  QPainterPath icon() const override;
  QVector<QPair<QString, QString>> keys() const override
  {
    return { { tr("Left drag"), tr("draw across the place where parts meet") } };
  }
  QString advice(const Situation& situation) const override;
  QString stage(const QString&) const override { return tr("Joining"); }

protected:
  bool grabs() const override { return false; }
  bool takesLine(vtkPolyData*) override { return true; } // it is a length, and no input of the step
  void lineWhole(vtkPolyData* line) override;
};

} // namespace oversketch_studio
#endif
