#include "resources.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QTranslator>

#include <memory>

namespace oversketch_studio
{

QString shippedFile(const QString& path)
{
  // The data lie beside the program's folder, in a build tree by a link.
  const QString whole =
    QDir(QCoreApplication::applicationDirPath()).filePath("../" OVERSKETCH_SHARE "/" + path);
  return QFileInfo::exists(whole) ? whole : QString();
}

QString shippedModel()
{
  return shippedFile("Models/dog.ply");
}

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
