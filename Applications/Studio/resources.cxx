#include "resources.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace oversketch_studio
{

QString shippedModel()
{
  // The data lie beside the program's folder, in a build tree by a link.
  const QString path =
    QDir(QCoreApplication::applicationDirPath()).filePath("../" OVERSKETCH_SHARE "/Models/dog.ply");
  return QFileInfo::exists(path) ? path : QString();
}

} // namespace oversketch_studio
