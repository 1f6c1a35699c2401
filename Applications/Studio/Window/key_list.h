// The list of mouse and keys that F1 shows over the model.
#ifndef oversketch_applications_studio_window_key_list_h
#define oversketch_applications_studio_window_key_list_h

#include <QString>
#include <QVector>

namespace oversketch_studio
{

class Tool;

// In the user's language, in columns for a font of fixed width: of the tool that has the left button, one of
// all.
QString keyList(const Tool& tool, const QVector<Tool*>& all);

} // namespace oversketch_studio
#endif
