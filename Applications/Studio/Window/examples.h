// The models and drawings that come with the program.
#ifndef oversketch_applications_studio_window_examples_h
#define oversketch_applications_studio_window_examples_h

#include "document.h"

#include <QString>
#include <QVector>

namespace oversketch_studio
{

struct Example
{
  QString title;
  QString file;    // of a model, or of a drawing
  QString picture; // that a drawing lies over; empty for a model
};

// Those that are installed, models first.
QVector<Example> examples();

// On any thread. Throws Failed.
Document::Opened readExample(const Example& example, int backend);

} // namespace oversketch_studio
#endif
