// oversketch-studio: the window. Exit code 2 for bad use, 1 where it cannot start.
#include "files.h"
#include "latency.h"
#include "main_window.h"
#include "resources.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include <algorithm>
#include <cstdio>
#include <malloc.h>
#include <memory>
#include <string>

int main(int count, char** values)
{
  // The arrays of a large mesh go back to the system when they are freed; else they leave holes.
  mallopt(M_MMAP_THRESHOLD, 8 << 20);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QCoreApplication::setOrganizationName("oversketch");
  QCoreApplication::setApplicationName("oversketch-studio");
  QCoreApplication::setApplicationVersion(OVERSKETCH_VERSION);
  QGuiApplication::setDesktopFileName("oversketch-studio");
  // What is only read needs no display.
  const auto isText = [](const char* one)
  {
    const std::string word = one;
    return word == "--help" || word == "-h" || word == "--help-all" || word == "--version" || word == "-v";
  };
  std::unique_ptr<QCoreApplication> application;
  std::any_of(values + 1, values + count, isText)
    ? application = std::make_unique<QCoreApplication>(count, values)
    : application = std::make_unique<QApplication>(count, values);
  // Every sample of the pen counts. (Qt's X11 part turns the first one on when the application is made.)
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
  QCoreApplication::setAttribute(Qt::AA_CompressTabletEvents, false);
  oversketch_studio::installTranslation(QLocale(), oversketch_studio::shippedFile("Translations"));
  QCommandLineParser parser;
  parser.setApplicationDescription(
    QCoreApplication::translate("main", "Draw a line beside a model's outline, and the model follows."));
  parser.addHelpOption();
  parser.addVersionOption();
  const QCommandLineOption latency("latency",
    QCoreApplication::translate(
      "main", "Write how long pen, strokes and redraws took to FILE at the end [ms]."),
    "FILE");
  parser.addOption(latency);
  parser.addPositionalArgument(
    "file", QCoreApplication::translate("main", "Model or session to open."), "[file]");
  if (!parser.parse(QCoreApplication::arguments()) || parser.positionalArguments().size() > 1)
  {
    const QString why = parser.errorText().isEmpty()
                          ? QCoreApplication::translate("main", "More than one file.")
                          : parser.errorText();
    std::fprintf(stderr, "oversketch-studio: %s\n", qPrintable(why));
    return 2;
  }
  if (parser.isSet("help"))
  {
    parser.showHelp();
  }
  if (parser.isSet("version"))
  {
    parser.showVersion();
  }
  oversketch_files::catchMessages();
  try
  {
    if (parser.isSet(latency))
    {
      oversketch_files::requireWritable(parser.value(latency).toStdString());
      oversketch_studio::Latency::of().writeTo(parser.value(latency).toStdString());
    }
    oversketch_studio::MainWindow window;
    window.show();
    const QStringList files = parser.positionalArguments();
    if (!window.offerRecovery())
    {
      if (files.isEmpty() || !window.open(files.first()))
      {
        window.openShippedModel();
      }
    }
    const int code = QApplication::exec();
    oversketch_studio::Latency::of().write();
    return code;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "oversketch-studio: %s\n", error.what());
    return 1;
  }
}
