// A line along a limb is its bone; the next one from the joint on bends the limb, while it is drawn.
#ifndef oversketch_applications_studio_tools_pose_tool_h
#define oversketch_applications_studio_tools_pose_tool_h

#include "held_stroke_tool.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <optional>

class vtkOversketchPose;

namespace oversketch_studio
{

class PoseTool : public HeldStrokeTool
{
  Q_OBJECT

public:
  PoseTool(Viewport* viewport, const Document* document);
  ~PoseTool() override;

  QString title() const override { return tr("Po&se"); }
  QKeySequence key() const override { return tr("6"); }
  QString help() const override
  {
    return tr("Draw a bone along a limb, then where it is to go (6). The middle button always turns.");
  }
  QPainterPath icon() const override;
  QVector<QPair<QString, QString>> keys() const override;
  QString advice(const Situation& situation) const override;
  QString stage(const QString&) const override { return tr("Bending the limb"); }
  void offer(const oversketch_session::Step& step,
    const oversketch_session::Worker::NodeState& state,
    const oversketch_session::Point& place) override;
  void offerNothing() override;

protected:
  bool grabs() const override { return false; } // the next line begins on it
  bool takesLine(vtkPolyData* line) override;
  void lineGrows(vtkPolyData* line) override { this->follow(line); } // of few pixels it poses nothing
  void lineWhole(vtkPolyData* line) override;
  void lineEnds() override;

private:
  bool isAtJoint(vtkPolyData* line) const;
  void feedLive();
  bool follow(vtkPolyData* line);

  // A bone, the mesh that it was drawn on, and a place of that under it.
  struct Held
  {
    oversketch_session::Step step;
    oversketch_session::SharedData before;
    oversketch_session::Point place{};
  };
  std::optional<Held> Offered, Posing; // Posing: while its new course is drawn
  vtkNew<vtkOversketchPose> Live;      // poses it meanwhile
  vtkSmartPointer<vtkPolyData> Rest;   // the mesh that was shown before
  vtkNew<vtkPolyData> Shown;
};

} // namespace oversketch_studio
#endif
