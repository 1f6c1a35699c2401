// Where the files that come with the program are.
#ifndef oversketch_applications_studio_window_resources_h
#define oversketch_applications_studio_window_resources_h

#include <QString>

namespace oversketch_studio
{

// A file by its path among them; empty where it is not installed.
QString shippedFile(const QString& path);
// The model that the window opens on; empty where it is not installed.
QString shippedModel();

} // namespace oversketch_studio
#endif
