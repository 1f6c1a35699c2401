// The list of mouse and keys that F1 shows over the model.
#ifndef oversketch_studio_key_list_h
#define oversketch_studio_key_list_h

#include <QString>

namespace oversketch_studio
{

// In the user's language, in columns for a font of fixed width. `drawing`: whose the left button is.
QString keyList(bool drawing);

} // namespace oversketch_studio
#endif
