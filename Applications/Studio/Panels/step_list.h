// The list of the history: rows are dragged to another place, those of lines among their drawing's, and so is
// the marker that says up to which step the model is shown.
#ifndef oversketch_applications_studio_panels_step_list_h
#define oversketch_applications_studio_panels_step_list_h

#include <QListWidget>

#include <functional>
#include <vector>

namespace oversketch_studio
{

class StepList : public QListWidget
{
  Q_OBJECT

public:
  explicit StepList(QWidget* parent = nullptr);

  // How many steps there are, and how many of them are shown. Called when the list has been made anew.
  void arrange(int steps, int shown);
  // Scrolls as far down as it was before; to a step's row where one has come.
  void scrollBack(int value, int come);
  // The row of a step; null where there is none.
  QListWidgetItem* itemOf(int step) const
  {
    return step < this->Steps ? this->item(this->First[static_cast<std::size_t>(step)]) : nullptr;
  }
  int steps() const { return this->Steps; }
  // Whether a step may be put at a place; it says why not.
  void setMayMove(const std::function<bool(int from, int to)>& mayMove) { this->MayMove = mayMove; }
  // Where the marker is; empty while there is none.
  QRect markerRect() const;

signals:
  void moveAsked(int from, int to);
  // A line of a step is to be at another place among its lines.
  void lineMoveAsked(int step, int from, int to);
  void markerAsked(int steps);

protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  bool viewportEvent(QEvent* event) override;

private:
  enum class Held
  {
    Nothing,
    Pressed, // a row, which may be dragged from here on
    Row,
    Marker
  };
  // Places that what is dragged may have: those of the steps, or of the lines of its step.
  int places() const;
  QRect placeRect(int place) const;
  int slotAt(int y) const; // the number of places above
  int edgeOf(int slot) const
  {
    return slot < this->places() ? this->placeRect(slot).top() : this->placeRect(this->places() - 1).bottom();
  }
  QRect rectOf(int step) const; // of its row and those of its lines
  void hold(Held what);
  void drag(const QPoint& at);
  void giveUp();

  std::function<bool(int, int)> MayMove;
  int Steps = 0, Shown = 0;
  std::vector<int> First; // the row of each step, and the number of rows
  Held Hand = Held::Nothing;
  QPoint Press;
  int Step = -1, Line = -1; // dragged; the line of it that is, -1: all of it
  int Slot = -1;            // where it would go, -1: nowhere
  int ShownBefore = 0;      // when the marker was taken
};

} // namespace oversketch_studio
#endif
