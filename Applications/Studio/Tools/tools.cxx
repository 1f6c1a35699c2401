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
#include "one_stroke_tool.h"
#include "turn_tool.h"

namespace oversketch_studio
{

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
