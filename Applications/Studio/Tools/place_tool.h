// A click on a part of the model, and a gizmo moves, turns and scales it; two, and it has a twin.
#ifndef oversketch_applications_studio_tools_place_tool_h
#define oversketch_applications_studio_tools_place_tool_h

#include "place_gizmo.h"
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
  QKeySequence key() const override { return tr("7"); }
  QString help() const override
  {
    return tr("Click on the model or a part of it, then move, turn and scale it (7)");
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
  // Hears the hand before the view does, with the keys that are held.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  struct Surface; // that a line of sight meets
  struct Drag;    // of a handle

  bool press(const QMouseEvent& mouse, const oversketch::Vector2& at);
  void pull(const oversketch::Vector2& at, Qt::KeyboardModifiers keys);
  void letGo();
  void giveUp();
  bool makeTwin(const oversketch::Vector2& at);
  bool canPlace() const;
  // The part that is seen there, -1 where the model is of one; none where no model is that takes steps.
  std::optional<int> partAt(const oversketch::Vector2& at);
  std::unique_ptr<Surface> surfaceRound() const; // what the part in the hand can be put on
  // Whether a drag changes the step that is offered, and does not make another.
  bool changesOffered() const;
  // Puts the gizmo where it stands; while a result is awaited it stands where the hand has put it.
  void follow();

  Viewport* View;
  const Document* OpenDocument;
  PlaceGizmo Gizmo;
  bool Taken = false;      // the tool is in the hand
  std::optional<int> Part; // that the gizmo is of
  std::optional<oversketch_session::Step> Offered;
  oversketch_session::SharedData Before; // the mesh that comes to it
  std::unique_ptr<Drag> Held;
  std::optional<QPoint> Pressed; // beside the gizmo, where a click may be
};

} // namespace oversketch_studio
#endif
