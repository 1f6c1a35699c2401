#include "resources.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace oversketch_studio
{

QString shippedModel()
{
  // Installed, the data lie beside the program's folder; in a build tree they are those of the source.
  const QString installed =
    QDir(QCoreApplication::applicationDirPath()).filePath("../" OVERSKETCH_SHARE "/Models/dog.ply");
  for (const QString& path : { installed, QString(OVERSKETCH_SOURCE_DATA "/Models/dog.ply") })
  {
    if (QFileInfo::exists(path))
    {
      return path;
    }
  }
  return {};
}

} // namespace oversketch_studio
