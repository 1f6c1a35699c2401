// The list of tools.
#ifndef oversketch_applications_studio_tools_tools_h
#define oversketch_applications_studio_tools_tools_h

#include "tool.h"

namespace oversketch_studio
{

class Document;
class Viewport;

// In the order of the strip; objects of the viewport's.
QVector<Tool*> makeTools(Viewport* viewport, const Document* document);

} // namespace oversketch_studio
#endif
