#include "tools.h"

#ifdef OVERSKETCH_WITH_AUGMENT
#include "augment_tool.h"
#endif
#ifdef OVERSKETCH_WITH_INFLATEDRAWING
#include "drawing_tool.h"
#endif
#include "one_stroke_tool.h"
#include "turn_tool.h"

namespace oversketch_studio
{

QVector<Tool*> makeTools(Viewport* viewport, const Document* document)
{
  return {
#ifdef OVERSKETCH_WITH_ONESTROKE
    new OneStrokeTool(viewport, document),
#endif
#ifdef OVERSKETCH_WITH_AUGMENT
    new AugmentTool(viewport, document),
#endif
#ifdef OVERSKETCH_WITH_INFLATEDRAWING
    new DrawingTool(viewport, document),
#endif
    new TurnTool(viewport),
  };
}

} // namespace oversketch_studio
