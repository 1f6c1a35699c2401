// The hand that the tools of system B share: a line on the model and a ring round it, kept from one tool to
// the next, and the edit of what lies between, which the model follows while the hand changes it.
#ifndef oversketch_applications_studio_tools_edit_hand_h
#define oversketch_applications_studio_tools_edit_hand_h

#include "both_sides.h"
#include "edit_step.h"
#include "picture_files.h"
#include "step.h"
#include "worker.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

class QTimer;
class vtkObject;
class vtkOversketchEditWidget;
class vtkOversketchStrokeWidget;
class vtkPolyData;

namespace oversketch_studio
{

class Document;
class Viewport;

class EditHand : public QObject
{
  Q_OBJECT

public:
  EditHand(Viewport* viewport, const Document* document);
  ~EditHand() override;

  // A tool takes it up for a mode of the widget (vtkOversketchEditWidget::ModeType), and puts it down.
  void takeUp(int mode);
  void putDown();
  int mode() const { return this->Mode; }
  // While there is a region: another mode of the same tool.
  void setMode(int mode);

  // A step that the hand can change, as the document has it; none any more.
  void offer(const oversketch_session::Step& step, const oversketch_session::Worker::NodeState& state);
  void offerNothing();
  // Another step is selected: a line that has no ring yet is given up.
  void select();
  // The mesh that is on screen from here on.
  void setMesh(vtkPolyData* mesh);

  bool draws() const;
  bool moves() const;
  bool hasLine() const;
  bool hasRegion() const;
  // Whether later steps act on the one that is offered; names of those that do nothing, or act elsewhere.
  bool isUnderOthers() const { return !this->later().empty(); }
  QStringList lost() const;
  // The words that the hand is to be told; empty where there is nothing.
  const QString& message() const { return this->Message; }
  vtkOversketchEditWidget* widget() const { return this->Widget; }
  // How many greys the layers are shown in.
  void setLevels(int levels);

  void setPixelRatio(double ratio);
  void setSteadiness(double pixels);
  void setPressure(double pressure);
  void showLines(bool show);

signals:
  void drawn(const oversketch_session::Step& step);
  void remade(const oversketch_session::Step& step);
  // The hand has let go, or what it can do is another thing than before.
  void left();
  void arranged();

private:
  using Step = oversketch_session::Step;
  // A task for the widget.
  struct Work
  {
    Step step{ editSystem, {}, {}, {}, {} };
    bool isInHistory = false;                                    // else it will be
    oversketch_session::SharedData mesh;                         // that it acts on
    std::map<std::string, oversketch_session::SharedData> given; // of other steps
    int id = 0;                                                  // of the step in the history
  };

  void heard(vtkObject* from, unsigned long event, void* text);
  void arrange();
  void arrangeSoon();
  void rest();
  std::vector<std::size_t> later() const;
  bool isLineAlone() const;
  // Those in the view; the disc's is in a window of its own.
  std::array<vtkOversketchStrokeWidget*, 3> pens() const;
  bool hasWeights();
  void dropLine();
  // An edit that begins on what is shown; one of the region that the offered one leaves.
  void begin();
  bool beginNext();
  bool wantsAnother(const Step& step) const;
  void load(const Work& work, bool again = false);
  void loadCurves(const Work& work);
  void loadValues(const Step& step);
  void publish();
  bool isMoved() const;
  Step made();
  void refuse(const QString& why);
  void applyMode();
  bool isShading() const;
  // The model as it is edited, without new triangles, smooth, on both sides of a plane where the step has
  // one.
  vtkPolyData* live();
  void follow();
  void stopFollowing();

  Viewport* View;
  const Document* OpenDocument;
  vtkNew<vtkOversketchEditWidget> Widget;
  vtkNew<vtkPolyData> Live;
  BothSides Mirrored;
  QTimer* Soon;
  int Mode;
  bool Held = false, Loading = false, Late = false;
  std::optional<Step> Offered;
  SharedPicture Weights; // of the offered step, decoded; null: it has none, or they are to come
  oversketch_session::Worker::NodeState State; // of the offered step
  int OfferedId = 0, LeftId = 0;               // of steps; the latter the hand is done with
  Work Loaded;
  std::map<std::string, vtkMTimeType> Seen; // of the widget's strokes, by the inputs' names
  QString Message;
  vtkSmartPointer<vtkPolyData> Rest; // what was on screen before the mesh followed
};

} // namespace oversketch_studio
#endif
