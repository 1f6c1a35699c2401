// The list of tools, and what mouse and keys do with them.
#ifndef oversketch_applications_studio_tools_tools_h
#define oversketch_applications_studio_tools_tools_h

#include "tool.h"

namespace oversketch_studio
{

class Document;
class Viewport;

// In the order of the strip; objects of the viewport's.
QVector<Tool*> makeTools(Viewport* viewport, const Document* document);

// The list of mouse and keys that F1 shows over the model, in the user's language, in columns for a font of
// fixed width: of the tool that has the left button, one of all.
QString keyList(const Tool& tool, const QVector<Tool*>& all);

} // namespace oversketch_studio
#endif
