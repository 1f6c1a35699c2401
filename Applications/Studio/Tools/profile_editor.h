// The section across a raised line, drawn by hand: points that are dragged, added and taken away, and shapes
// to begin with.
#ifndef oversketch_applications_studio_tools_profile_editor_h
#define oversketch_applications_studio_tools_profile_editor_h

#include <QPointF>
#include <QVector>
#include <QWidget>

#include <string>

class QComboBox;

namespace oversketch_studio
{

class ProfileEditor : public QWidget
{
  Q_OBJECT

public:
  explicit ProfileEditor(QWidget* parent = nullptr);
  QSize sizeHint() const override { return { side, side }; }

  // As vtkOversketchAugment has them: a polyline "x y, x y, ..." from the line (x = 0) to the foot (1), or
  // empty for (1 - x)^sharpness.
  void setShape(const std::string& profile, double sharpness);
  const std::string& profile() const { return this->Text; }
  double sharpness() const { return this->Sharpness; }

  static constexpr int side = 240; // px, of a panel that opens

signals:
  // By the hand; `mergesIntoLast` while the same point is dragged.
  void shaped(bool mergesIntoLast);

private:
  friend class ProfileCurve;
  // The points have been changed: the shape is the polyline.
  void pointsChanged(bool mergesIntoLast);
  void showName();

  QVector<QPointF> Points; // x rises from 0 to 1; the last one is (1, 0)
  std::string Text;
  double Sharpness = 1.5;
  QComboBox* Presets;
  class ProfileCurve* Curve;
};

// The drawing of it, both sides of the line; the right one has the points.
class ProfileCurve : public QWidget
{
  Q_OBJECT

public:
  explicit ProfileCurve(ProfileEditor* editor);

  QSize sizeHint() const override { return { 240, 150 }; }
  QSize minimumSizeHint() const override { return { 160, 80 }; }
  // Where a point is in the widget [px], for the hand.
  QPoint placeOf(int point) const { return this->seen(this->points()[point]).toPoint(); }
  void forget(); // which point is chosen

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  QPointF seen(const QPointF& point) const;
  QPointF pointAt(const QPoint& place) const;
  int nearest(const QPoint& place) const; // -1 where none is near
  bool isMovable(int point) const { return point >= 0 && point + 1 < this->points().size(); }
  const QVector<QPointF>& points() const { return this->Editor->Points; }
  void moveTo(int point, QPointF to, bool mergesIntoLast);
  int insert(const QPointF& point); // -1 where there is no room
  void remove(int point);

  ProfileEditor* Editor;
  int Chosen = -1;
  bool Dragging = false, Dragged = false;
};

} // namespace oversketch_studio
#endif
