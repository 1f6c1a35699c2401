// System C's tool: what is drawn over a picture becomes a model, which is seen beside it.
#ifndef oversketch_applications_studio_tools_drawing_tool_h
#define oversketch_applications_studio_tools_drawing_tool_h

#include "drawing_lines.h"
#include "part_handles.h"
#include "picture_files.h"
#include "tool.h"

#include <QAction>
#include <QPointer>

#include <memory>
#include <vector>

namespace oversketch_studio
{

class Document;
class DrawingPad;
class Viewport;

class DrawingTool : public Tool
{
  Q_OBJECT

public:
  DrawingTool(Viewport* viewport, const Document* document);

  QString title() const override { return tr("Ima&ge to model"); }
  QKeySequence key() const override { return tr("G"); }
  QString help() const override
  {
    return tr("Draw round a shape in a picture, or click on it, and it becomes a model (G)");
  }
  QPainterPath icon() const override;
  QVector<QPair<QString, QString>> keys() const override;
  QString words(const oversketch::Message& message) const override { return this->inLines(message); }
  QString advice(const Situation& situation) const override;
  bool judges() const override;
  std::string asked() const override;
  QString stage(const QString& name) const override;
  std::string system() const override { return oversketch_session::drawingSystem; }
  // The drawing that was selected last, else the first one.
  int node() const override;
  void select(int node) override;
  void selectLine(int line) override;
  // Magnetic, and the two views' sides.
  QWidget* makeOptions(QWidget* parent) override;
  oversketch_session::Values options() const override
  {
    return { { "Magnetic", this->Magnetic->isChecked() } };
  }
  void setOptions(const oversketch_session::Values& options) override
  {
    this->Magnetic->setChecked(std::get<bool>(options.at("Magnetic")));
  }
  QWidget* makeCanvas(QWidget* parent) override;
  QList<QAction*> actions() const override { return { this->Magnetic, this->Deepen, this->Swap }; }
  void start() override;
  void stop() override;
  bool draws() const override;
  bool moves() const override { return this->Handles.isHeld(); }
  bool takesShift(double, double) override { return true; } // a part's corners
  void setSteadiness(double pixels) override;
  void setDark(bool dark) override;
  void setPixelRatio(double ratio) override { this->Handles.setPixelRatio(ratio); }
  void frameBegins() override { this->Handles.follow(); }
  void showLines(bool show) override { this->Handles.setVisible(show); }
  void redraw(int stroke) override { this->Redrawn = stroke; }

private:
  bool isCrossing() const; // a line another, or itself, which may be allowed
  // Shows what the document holds.
  void follow();
  // The picture under it has not been read, which is not for the window's thread.
  bool lacksPicture() const { return this->Picture && !this->Decoded; }
  void readPicture();
  // The hand has changed the drawing on the pad.
  void take();
  // The closed line that was drawn or selected last; -1: none.
  int closedLine() const;
  // Puts it at the next depth.
  void deepen();
  QString need() const;         // what the drawing lacks, in words
  QVector<int> linesOn() const; // those that a filter counts
  // Puts what a filter says of strokes, counted from 0 where they are on, into words of the list's lines.
  QString inLines(const oversketch::Message& message) const;

  Viewport* View;
  const Document* OpenDocument;
  QPointer<DrawingPad> Pad; // in a frame of its own
  PartHandles Handles;      // of the drawing's model, where it is a part
  QAction *Magnetic, *Deepen, *Swap;
  bool Held = false;                                    // the tool is in the hand
  std::vector<oversketch_session::DrawnStroke> Strokes; // of the drawing, also those that are off
  std::shared_ptr<const void> Shown;                    // the identity of its lines
  PictureBytes Picture;                                 // what it is drawn over
  SharedPicture Decoded;                                // the same; null while it is not read
  int Drawing = 0, OnPad = 0;                           // ids: of its step, of the one that is seen
  bool Started = false;                                 // something is drawn on
  bool Arranged = false;                                // its strokes may cross
  int Redrawn = -1;                                     // the stroke that the next one replaces
  int Line = -1;                                        // drawn or selected last; -1: the last one
};

} // namespace oversketch_studio
#endif
