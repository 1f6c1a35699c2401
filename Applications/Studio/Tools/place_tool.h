// A click on a part of the model, and a gizmo moves, turns and scales it; two, and it has a twin.
#ifndef oversketch_applications_studio_tools_place_tool_h
#define oversketch_applications_studio_tools_place_tool_h

#include "part_preview.h"
#include "place_gizmo.h"
#include "seen_surface.h"
#include "tool.h"

#include <QPoint>

#include <memory>
#include <optional>

class QMouseEvent;

namespace oversketch_studio
{

class Document;
class Viewport;

class PlaceTool : public Tool
{
  Q_OBJECT

public:
  PlaceTool(Viewport* viewport, const Document* document);
  ~PlaceTool() override;

  QString title() const override { return tr("Pla&ce"); }
  QKeySequence key() const override { return tr("4"); }
  QString help() const override
  {
    return tr("Click on the model or a part of it, then move, turn and scale it (4)");
  }
  QPainterPath icon() const override;
  QVector<QPair<QString, QString>> keys() const override;
  QString advice(const Situation& situation) const override;
  QString stage(const QString&) const override { return tr("Placing"); }
  std::string system() const override;
  void select(int node) override;
  void start() override;
  void stop() override;
  bool moves() const override { return this->Held != nullptr; }
  bool leavesRows() const override { return true; }
  void offer(const oversketch_session::Step& step,
    const oversketch_session::Worker::NodeState& state,
    const oversketch_session::Point& place) override;
  void offerNothing() override;
  void setMesh(vtkPolyData* mesh) override;
  void setPixelRatio(double ratio) override { this->Gizmo.setPixelRatio(ratio); }
  bool wheel(double, Qt::KeyboardModifiers, ulong) override { return this->moves(); }
  void frameBegins() override { this->Gizmo.follow(); }
  bool holds(double x, double y) override { return this->Gizmo.at({ x, y }).has_value(); }
  void showLines(bool show) override { this->Gizmo.setVisible(show); }

protected:
  // Of the view: the hand is heard before the camera is, and with the keys that are held.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  // A handle in the hand.
  struct Drag
  {
    GizmoGrip grip;
    oversketch::Vector2 start;
    PlaceGizmo::Stand from;
    PartPreview preview;
    std::unique_ptr<SeenSurface> round{}; // what the part can be put on, once it is asked for
    bool hasMoved = false;
  };

  bool press(const QMouseEvent& mouse);
  void pull(const oversketch::Vector2& at, Qt::KeyboardModifiers keys);
  void letGo();
  void giveUp();
  void click(const oversketch::Vector2& at);
  bool makeTwin(const oversketch::Vector2& at);
  // The part that is seen there, -1 where the model is of one; none where no model is that takes steps.
  std::optional<int> partAt(const oversketch::Vector2& at);
  std::optional<oversketch::Vector3> surfaceAt(const oversketch::View& view, const oversketch::Vector2& at);
  // Whether a drag changes the step that is offered, and does not make another.
  bool changesOffered() const;
  void follow(); // where the gizmo stands
  void followAtRest();
  oversketch::Vector2 placeOf(const QMouseEvent& mouse) const;

  Viewport* View;
  const Document* OpenDocument;
  PlaceGizmo Gizmo;
  bool Taken = false;      // the tool is in the hand
  std::optional<int> Part; // that the gizmo is of
  std::optional<oversketch_session::Step> Offered;
  oversketch_session::SharedData Before;  // the mesh that comes to it
  std::unique_ptr<SeenSurface> Clickable; // what is seen of the model, once it is asked for
  std::unique_ptr<Drag> Held;
  std::optional<QPoint> Pressed; // beside the gizmo, where a click may be
  bool Clicked = false;          // the last press was let go of where it was
};

} // namespace oversketch_studio
#endif
