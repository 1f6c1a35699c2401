#include "translations.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QTranslator>

#include <memory>

namespace oversketch_studio
{

bool installTranslation(const QLocale& locale, const QString& folder)
{
  auto ours = std::make_unique<QTranslator>(QCoreApplication::instance());
  if (folder.isEmpty() || !ours->load(locale, "oversketch", "_", folder))
  {
    return false;
  }
  auto qts = std::make_unique<QTranslator>(QCoreApplication::instance());
  if (qts->load(locale, "qtbase", "_", QLibraryInfo::location(QLibraryInfo::TranslationsPath)))
  {
    QCoreApplication::installTranslator(qts.release());
  }
  QCoreApplication::installTranslator(ours.release()); // the application's from here on
  return true;
}

} // namespace oversketch_studio
