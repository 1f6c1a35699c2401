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
  enum
  {
    Model,
    Drawing,
    Work // a session
  } kind = Model;
};
const Row exampleRows[] = {
  { QT_TRANSLATE_NOOP("Examples", "Dog"), "dog" },
  { QT_TRANSLATE_NOOP("Examples", "Bear"), "bear" },
  { QT_TRANSLATE_NOOP("Examples", "Dinosaur"), "dinosaur" },
  { QT_TRANSLATE_NOOP("Examples", "Hand"), "hand" },
  { QT_TRANSLATE_NOOP("Examples", "Octopus"), "octopus" },
  { QT_TRANSLATE_NOOP("Examples", "Person"), "person" },
  { QT_TRANSLATE_NOOP("Examples", "Fish (drawing)"), "fish", Row::Drawing },
  { QT_TRANSLATE_NOOP("Examples", "Heron (drawing)"), "heron", Row::Drawing },
  { QT_TRANSLATE_NOOP("Examples", "Leaf (drawing)"), "leaf", Row::Drawing },
  { QT_TRANSLATE_NOOP("Examples", "Mug (drawing)"), "mug", Row::Drawing },
  { QT_TRANSLATE_NOOP("Examples", "Padlock (drawing)"), "padlock", Row::Drawing },
  { QT_TRANSLATE_NOOP("Examples", "Dragon (session)"), "creature", Row::Work },
  { QT_TRANSLATE_NOOP("Examples", "Gnome (session)"), "figure", Row::Work },
  { QT_TRANSLATE_NOOP("Examples", "Shell (session)"), "relief", Row::Work },
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
    constexpr const char* files[] = { "Models/%1.ply", "Drawings/%1.vtp", "Works/%1.oversketch" };
    const bool isDrawing = row.kind == Row::Drawing;
    const Example one{ QCoreApplication::translate("Examples", row.title),
      shippedFile(QString(files[row.kind]).arg(row.file)),
      isDrawing ? shippedFile(QString("Drawings/%1.png").arg(row.file)) : QString() };
    const bool isWhole =
      row.kind == Row::Model || (findSystem(drawingSystem) && (!isDrawing || !one.picture.isEmpty()));
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
    Document::Opened opened = Document::read(example.file, backend);
    opened.path.clear(); // of a session, which Ctrl+S would overwrite
    return opened;
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
