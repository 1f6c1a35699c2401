#include "resources.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

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

} // namespace oversketch_studio
