#include "examples.h"

#include "drawing_lines.h"
#include "mesh_file.h"
#include "picture_files.h"
#include "resources.h"
#include "system_strings.h"
#include "systems.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

struct Row
{
  const char* title;
  const char* file;
};
const Row models[] = {
  { QT_TRANSLATE_NOOP("Examples", "Dog"), "dog" },
  { QT_TRANSLATE_NOOP("Examples", "Bear"), "bear" },
  { QT_TRANSLATE_NOOP("Examples", "Dinosaur"), "dinosaur" },
  { QT_TRANSLATE_NOOP("Examples", "Hand"), "hand" },
  { QT_TRANSLATE_NOOP("Examples", "Octopus"), "octopus" },
  { QT_TRANSLATE_NOOP("Examples", "Person"), "person" },
};
const Row drawings[] = {
  { QT_TRANSLATE_NOOP("Examples", "Fish (drawing)"), "fish" },
  { QT_TRANSLATE_NOOP("Examples", "Heron (drawing)"), "heron" },
  { QT_TRANSLATE_NOOP("Examples", "Leaf (drawing)"), "leaf" },
  { QT_TRANSLATE_NOOP("Examples", "Mug (drawing)"), "mug" },
  { QT_TRANSLATE_NOOP("Examples", "Padlock (drawing)"), "padlock" },
};

QString nameOf(const Row& row)
{
  return QCoreApplication::translate("Examples", row.title);
}

} // namespace

QVector<Example> examples()
{
  QVector<Example> found;
  const auto add = [&found](const Example& one)
  {
    const bool isWhole =
      QFileInfo::exists(one.file) && (one.picture.isEmpty() || QFileInfo::exists(one.picture));
    if (isWhole)
    {
      found << one;
    }
  };
  for (const Row& row : models)
  {
    add({ nameOf(row), shippedFile(QString("Models/%1.ply").arg(row.file)), {} });
  }
  for (const Row& row : drawings)
  {
    if (findSystem(drawingSystem))
    {
      const QString stem = QString("Drawings/%1.").arg(row.file);
      add({ nameOf(row), shippedFile(stem + "vtp"), shippedFile(stem + "png") });
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
  Node node;
  node.id = 1;
  node.step = std::make_shared<const Step>(
    withDrawing(*drawingOver(picture), oversketch_files::readStroke(example.file.toStdString())));
  node.name = titleOf(node.step->system).toStdString();
  Document::Opened opened;
  opened.session.nodes = { node };
  opened.pictures = { read.decoded };
  opened.session.meshName = picture.name;
  opened.session.backend = backend;
  return opened;
}

} // namespace oversketch_studio
