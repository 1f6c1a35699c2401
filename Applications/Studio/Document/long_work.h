// Work that takes long, such as a large file, on a thread of its own: the window says that it goes on, and it
// can be given up.
#ifndef oversketch_applications_studio_document_long_work_h
#define oversketch_applications_studio_document_long_work_h

#include "large_mesh.h"

#include <QProgressDialog>
#include <QString>

#include <functional>

namespace oversketch_studio
{

// Returns once `work` is done, true, or the user has given it up, false: then no file that it writes
// comes to its place, and it must not use what may end before the program. Throws what it throws. After a
// moment `what` is said in a dialogue with a button for giving it up.
bool doLongWork(QWidget* parent, const QString& what, std::function<void()> work);
// Progress that this thread's work tells, and its question whether it has been given up.
oversketch_session::Progress progressOfWork();

// Work that must stay on the window's thread, such as frames that it draws: a dialogue says how far it is,
// with a button for giving it up. Nothing else of the window can be reached meanwhile.
class WorkHere
{
public:
  WorkHere(QWidget* parent, const QString& what);
  ~WorkHere();

  // Says how much of it is done [0 to 1], and lets the dialogue hear the hand; returns whether to go on.
  bool goesOn(double share);

private:
  QProgressDialog Dialog;
};

// The text of one that goes on, so that nothing else is to be begun; else empty.
QString longWorkGoing();

} // namespace oversketch_studio
#endif
