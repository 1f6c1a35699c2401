// The place that the stroke being drawn takes hold of, shown blue under the pen: found away from the
// interface's thread, so that the line is drawn without waiting for it.
#ifndef oversketch_applications_studio_tools_pen_section_h
#define oversketch_applications_studio_tools_pen_section_h

#include "section_finder.h"

#include <QObject>

#include <cstdint>

class QTimer;
class vtkOversketchHeldStrokeWidget;
class vtkPolyData;

namespace oversketch_studio
{

class PenSection : public QObject
{
  Q_OBJECT

public:
  // Looks at strokes of a system and of a widget, which must outlive it.
  PenSection(const oversketch_session::SystemRow& system,
    vtkOversketchHeldStrokeWidget* widget,
    oversketch_session::SectionFinder::Look look = {},
    QObject* parent = nullptr);

  // The mesh that is drawn over from here on.
  void setMesh(vtkPolyData* mesh);
  // The values that the stroke will have, from here on.
  void setValues(const oversketch_session::Values& values);
  // The pen goes down; the line has grown; a frame begins that shows it; a frame has been painted.
  void lineBegins();
  // A stroke that is moved has come there; it has been let go of.
  void lineMoves(vtkPolyData* stroke) { this->Asked = this->Finder.find(stroke, this->StrokeValues); }
  void moveEnds();
  void lineGrows() { this->Grew = true; }
  void frameBegins();
  void framePainted();

signals:
  // There is something to be shown, and no frame comes by itself.
  void frameWanted();

private:
  void look();
  void show();
  void rested();

  vtkOversketchHeldStrokeWidget* Widget;
  QTimer* Rest;       // since the last frame
  bool Grew = false;  // the line, since a section was last looked for
  bool Waits = false; // a section, for a frame to show it
  oversketch_session::Values StrokeValues;
  std::uint64_t Asked = 0, Outdated = 0; // tickets; the latter's stroke or mesh is gone
  // Last, so that it ends first: it calls the rest.
  oversketch_session::SectionFinder Finder;
};

} // namespace oversketch_studio
#endif
