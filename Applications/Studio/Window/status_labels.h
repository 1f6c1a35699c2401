// Labels at the foot of the window.
#ifndef oversketch_applications_studio_window_status_labels_h
#define oversketch_applications_studio_window_status_labels_h

#include <QLabel>

namespace oversketch_studio
{

class Document;

// A line on what to do next, two lines high, so that the view keeps its size. Where it needs more its letters
// are a little smaller, and where that is not enough it ends in three points and its tool tip has the whole.
class AdviceLabel : public QLabel
{
  Q_OBJECT

public:
  explicit AdviceLabel(QWidget* parent = nullptr);
  // The letters in which it is seen, and what is seen of it.
  QFont fitting() const;
  QString shown() const;

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  QRect room(int height) const;
  bool fits(const QString& text, const QFont& font) const;
};

// When the work was last put on the disk: in its own file, or, for the case of a crash, beside.
class KeptNote : public QLabel
{
  Q_OBJECT

public:
  explicit KeptNote(const Document* document, QWidget* parent = nullptr);

private:
  void follow();

  const Document* OpenDocument;
  bool Saved = false; // since it was opened
};

} // namespace oversketch_studio
#endif
