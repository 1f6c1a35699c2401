// Work that takes long, such as a large file, on a thread of its own: the window says that it goes on, and it
// can be given up.
#ifndef oversketch_applications_studio_document_long_work_h
#define oversketch_applications_studio_document_long_work_h

#include "large_mesh.h"

#include <QString>

#include <functional>

class QWidget;

namespace oversketch_studio
{

// Returns once `work` is done, true, or the user has given it up, false: then no file that it writes
// comes to its place, and it must not use what may end before the program. Throws what it throws. After a
// moment `what` is said in a dialogue with a button for giving it up.
bool doLongWork(QWidget* parent, const QString& what, std::function<void()> work);
// Progress that this thread's work tells, and its question whether it has been given up.
oversketch_session::Progress progressOfWork();
// The text of one that goes on, so that nothing else is to be begun; else empty.
QString longWorkGoing();

} // namespace oversketch_studio
#endif
