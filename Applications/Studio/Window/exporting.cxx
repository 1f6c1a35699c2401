#include "exporting.h"

#include "film.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QSettings>
#include <QStandardPaths>
#include <QStringList>
#include <QVector>

#include <algorithm>

namespace oversketch_studio
{

namespace
{

struct ExportTexts
{
  Q_DECLARE_TR_FUNCTIONS(Exporting)
};

struct Format
{
  QString suffix, filter;
  bool keepsPicture = false;
};

// Every one that the library writes.
QVector<Format> formats()
{
  const auto row = [](const char* suffix, const QString& what, bool keepsPicture = false) {
    return Format{ suffix, QString("%1 (*.%2)").arg(what, suffix), keepsPicture };
  };
  return { row("ply", ExportTexts::tr("PLY, with its picture"), true),
    row("obj", ExportTexts::tr("Wavefront OBJ, with its picture"), true),
    row("glb", ExportTexts::tr("glTF in one file, with its picture"), true),
    row("gltf", ExportTexts::tr("glTF, with its picture"), true),
    row("stl", ExportTexts::tr("STL")),
    row("3mf", ExportTexts::tr("3MF, for printers")),
    row("off", ExportTexts::tr("OFF")),
    row("vtp", ExportTexts::tr("VTK"), true) };
}

bool mayReplace(QWidget* parent, const QString& path)
{
  return !QFileInfo::exists(path) ||
         QMessageBox::question(parent,
           ExportTexts::tr("Oversketch"),
           ExportTexts::tr("%1 is there already. Replace it?").arg(QFileInfo(path).fileName())) ==
           QMessageBox::Yes;
}

int placeOf(const QVector<Format>& all, const QString& suffix)
{
  const auto isOf = [&suffix](const Format& format) { return format.suffix == suffix; };
  return static_cast<int>(std::find_if(all.begin(), all.end(), isOf) - all.begin());
}

// In one of those formats, `chosen` to begin with; which it was is kept under that name.
QString pathAsked(QWidget* parent,
  const QString& title,
  const QString& name,
  const QVector<Format>& all,
  int chosen,
  const QString& setting)
{
  QSettings settings;
  QStringList filters;
  for (const Format& format : all)
  {
    filters << format.filter;
  }
  const QString folder = settings.value("exportFolder", settings.value("folder")).toString();
  QFileDialog dialog(parent, title, folder);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters(filters);
  const auto follow = [&](const QString& stem, const QString& filter)
  {
    const QString& suffix = all[std::max(0, filters.indexOf(filter))].suffix;
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(stem + '.' + suffix);
  };
  dialog.selectNameFilter(filters[chosen]);
  follow(name, filters[chosen]);
  // Another format is another suffix.
  QObject::connect(&dialog,
    &QFileDialog::filterSelected,
    &dialog,
    [&](const QString& filter)
    { follow(QFileInfo(dialog.selectedFiles().value(0, name)).completeBaseName(), filter); });
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty())
  {
    return {};
  }
  QString path = dialog.selectedFiles().first();
  const int at = std::max(0, filters.indexOf(dialog.selectedNameFilter()));
  QString suffix = QFileInfo(path).suffix().toLower();
  if (placeOf(all, suffix) == all.size())
  {
    suffix = all[at].suffix;
    path += '.' + suffix;
    if (!mayReplace(parent, path)) // the dialogue has asked about another name
    {
      return {};
    }
  }
  settings.setValue(setting, suffix);
  settings.setValue("exportFolder", QFileInfo(path).absolutePath());
  return path;
}

// The place of the format that was chosen last; of the first one where none was.
int lastChosen(const QVector<Format>& all, const QString& setting)
{
  const int last = placeOf(all, QSettings().value(setting).toString());
  return last < all.size() ? last : 0;
}

} // namespace

QString exportPathAsked(QWidget* parent, const QString& name, bool wearsPicture)
{
  const QVector<Format> all = formats();
  int chosen = lastChosen(all, "exportFormat");
  if (wearsPicture && (!QSettings().contains("exportFormat") || !all[chosen].keepsPicture))
  {
    chosen = placeOf(all, "glb");
  }
  return pathAsked(parent, ExportTexts::tr("Export the mesh"), name, all, chosen, "exportFormat");
}

QString printPathAsked(QWidget* parent, const QString& name)
{
  const QVector<Format> all = formats();
  const QVector<Format> printers = { all[placeOf(all, "3mf")], all[placeOf(all, "stl")] };
  return pathAsked(parent,
    ExportTexts::tr("Export for print"),
    name,
    printers,
    lastChosen(printers, "printFormat"),
    "printFormat");
}

bool keepsPicture(const QString& path)
{
  const QVector<Format> all = formats();
  const int at = placeOf(all, QFileInfo(path).suffix().toLower());
  return at < all.size() && all[at].keepsPicture;
}

TurnFilm turnFilmAsked(QWidget* parent, const QString& name)
{
  TurnFilm film;
  bool isWanted = false;
  film.frames = QInputDialog::getInt(parent,
    ExportTexts::tr("Turntable"),
    ExportTexts::tr("&Pictures of one turn (24 are a second of film)"),
    oversketch_files::framesOfTurn,
    2,
    oversketch_files::mostFramesOfTurn,
    1,
    &isWanted);
  if (!isWanted)
  {
    return {};
  }
  QSettings settings;
  const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
  const QString one = ExportTexts::tr("Film (*.ogv)"), many = ExportTexts::tr("Numbered pictures (*.png)");
  QString filter = one;
  film.path = QFileDialog::getSaveFileName(parent,
    ExportTexts::tr("Save the model as it turns round"),
    QDir(settings.value("turntableFolder", pictures).toString()).filePath(name),
    one + ";;" + many,
    &filter);
  if (film.path.isEmpty())
  {
    return {};
  }
  const QString named = film.path, suffix = QFileInfo(named).suffix().toLower();
  if (suffix != "ogv" && suffix != "png")
  {
    film.path += filter == many ? ".png" : ".ogv";
  }
  const auto files = oversketch_files::filmFiles(film.path.toStdString(), film.frames);
  const QString first = QString::fromStdString(files.front());
  if (first != named && !mayReplace(parent, first)) // the dialogue has asked about another name
  {
    return {};
  }
  settings.setValue("turntableFolder", QFileInfo(film.path).absolutePath());
  return film;
}

} // namespace oversketch_studio
