#include "long_work.h"

#include "files.h"

#include <QApplication>
#include <QCoreApplication>
#include <QEventLoop>
#include <QPointer>
#include <QProgressBar>
#include <QProgressDialog>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>

#include <atomic>
#include <exception>
#include <memory>

namespace oversketch_studio
{

namespace
{

constexpr int moment = 300, barMoment = 100; // ms

QStringList going; // what is said of each, on the window's thread

struct Going
{
  explicit Going(const QString& what) { going << what; }
  ~Going() { going.removeLast(); }
};

struct LongWorkTexts
{
  Q_DECLARE_TR_FUNCTIONS(LongWork)
};

// The thread that works and the window that waits, which may have left.
struct Shared
{
  std::function<void()> work;
  std::exception_ptr failure;
  std::atomic<bool> done{ false }, givenUp{ false };
  std::atomic<double> share{ 0.0 }; // done, where the work tells it
};

thread_local Shared* sharedHere = nullptr; // on a thread that works

} // namespace

bool doLongWork(QWidget* parent, const QString& what, std::function<void()> work)
{
  const Going goes(what);
  const auto shared = std::make_shared<Shared>();
  shared->work = std::move(work);
  QEventLoop loop;
  QThreadPool::globalInstance()->start(
    [shared, waiting = QPointer<QEventLoop>(&loop)]
    {
      try
      {
        const oversketch_files::GiveUp asked(shared->givenUp);
        sharedHere = shared.get();
        shared->work();
      }
      catch (...)
      {
        shared->failure = std::current_exception();
      }
      sharedHere = nullptr;
      shared->work = nullptr; // with what it holds
      shared->done = true;
      const auto wake = [waiting]
      {
        if (waiting)
        {
          waiting->quit();
        }
      };
      QMetaObject::invokeMethod(QCoreApplication::instance(), wake, Qt::QueuedConnection);
    });
  QProgressDialog dialog(what, LongWorkTexts::tr("&Cancel"), 0, 0, parent);
  dialog.setWindowTitle(LongWorkTexts::tr("Oversketch"));
  dialog.setWindowModality(Qt::WindowModal);
  dialog.setMinimumDuration(2 * 60 * 60 * 1000); // it is shown here
  dialog.setAutoReset(false);
  dialog.reset();
  QObject::connect(&dialog,
    &QProgressDialog::canceled,
    &loop,
    [&]
    {
      shared->givenUp = true;
      loop.quit();
    });
  QTimer timer;
  QObject::connect(&timer,
    &QTimer::timeout,
    &loop,
    [&, bar = dialog.findChild<QProgressBar*>()]
    {
      bar->setMaximum(shared->share > 0.0 ? 100 : 0);
      bar->setValue(static_cast<int>(100.0 * shared->share));
    });
  timer.start(barMoment);
  // Before the dialogue is there no hand can do anything, and sees nothing of it.
  QTimer::singleShot(moment, &loop, [&loop] { loop.quit(); });
  loop.exec(QEventLoop::ExcludeUserInputEvents);
  if (!shared->done)
  {
    dialog.show();
    loop.exec();
    dialog.hide();
  }
  if (!shared->done)
  {
    shared->givenUp = true; // or the program is being ended, and the work is not
  }
  if (shared->givenUp)
  {
    return false;
  }
  if (shared->failure)
  {
    std::rethrow_exception(shared->failure);
  }
  return true;
}

oversketch_session::Progress progressOfWork()
{
  Shared* here = sharedHere;
  return { [here](double share)
    {
      if (here)
      {
        here->share = share;
      }
    },
    {},
    [here] { return here && here->givenUp; } };
}

WorkHere::WorkHere(QWidget* parent, const QString& what)
  : Dialog(what, LongWorkTexts::tr("&Cancel"), 0, 100, parent)
{
  going << what;
  this->Dialog.setWindowTitle(LongWorkTexts::tr("Oversketch"));
  this->Dialog.setWindowModality(Qt::WindowModal);
  this->Dialog.setAutoReset(false);
  this->Dialog.show();
}

WorkHere::~WorkHere()
{
  going.removeLast();
}

bool WorkHere::goesOn(double share)
{
  this->Dialog.setValue(static_cast<int>(100.0 * share));
  QCoreApplication::processEvents();
  return !this->Dialog.wasCanceled();
}

QString longWorkGoing()
{
  return going.value(going.size() - 1);
}

} // namespace oversketch_studio
