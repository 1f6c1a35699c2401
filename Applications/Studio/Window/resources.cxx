#include "resources.h"

#include "drawing_lines.h"
#include "mesh_file.h"
#include "picture_files.h"
#include "system_strings.h"
#include "systems.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QTranslator>

#include <memory>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

struct Row
{
  const char* title;
  const char* file;
  bool isDrawing = false;
};
const Row exampleRows[] = {
  { QT_TRANSLATE_NOOP("Examples", "Dog"), "dog" },
  { QT_TRANSLATE_NOOP("Examples", "Bear"), "bear" },
  { QT_TRANSLATE_NOOP("Examples", "Dinosaur"), "dinosaur" },
  { QT_TRANSLATE_NOOP("Examples", "Hand"), "hand" },
  { QT_TRANSLATE_NOOP("Examples", "Octopus"), "octopus" },
  { QT_TRANSLATE_NOOP("Examples", "Person"), "person" },
  { QT_TRANSLATE_NOOP("Examples", "Fish (drawing)"), "fish", true },
  { QT_TRANSLATE_NOOP("Examples", "Heron (drawing)"), "heron", true },
  { QT_TRANSLATE_NOOP("Examples", "Leaf (drawing)"), "leaf", true },
  { QT_TRANSLATE_NOOP("Examples", "Mug (drawing)"), "mug", true },
  { QT_TRANSLATE_NOOP("Examples", "Padlock (drawing)"), "padlock", true },
};

} // namespace

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

QVector<Example> examples()
{
  QVector<Example> found;
  for (const Row& row : exampleRows)
  {
    const QString stem = QString(row.isDrawing ? "Drawings/%1." : "Models/%1.").arg(row.file);
    const Example one{ QCoreApplication::translate("Examples", row.title),
      shippedFile(stem + (row.isDrawing ? "vtp" : "ply")),
      row.isDrawing ? shippedFile(stem + "png") : QString() };
    const bool isWhole = !row.isDrawing || (!one.picture.isEmpty() && findSystem(drawingSystem));
    if (isWhole && !one.file.isEmpty())
    {
      found << one;
    }
  }
  return found;
}

Document::Opened readExample(const Example& example, int backend)
{
  if (example.picture.isEmpty())
  {
    return Document::read(example.file, backend);
  }
  const ReadPicture read = readPicture(example.picture);
  const Image& picture = read.image;
  Document::Opened opened;
  opened.session.nodes = { firstNode(std::make_shared<const Step>(
    withDrawing(*drawingOver(picture), oversketch_files::readStroke(example.file.toStdString())))) };
  opened.pictures = { read.decoded };
  opened.session.meshName = picture.name;
  opened.session.backend = backend;
  return opened;
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
