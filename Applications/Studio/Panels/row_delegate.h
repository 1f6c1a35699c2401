// A row of the history: whether it is on, a small picture, its name, what it did, a mark where something is
// to be said of it.
#ifndef oversketch_applications_studio_panels_row_delegate_h
#define oversketch_applications_studio_panels_row_delegate_h

#include <QStyledItemDelegate>

namespace oversketch_studio
{

class RowDelegate : public QStyledItemDelegate
{
  Q_OBJECT

public:
  using QStyledItemDelegate::QStyledItemDelegate;

  // Data of an item: its step; the line of a drawing that it is, or -1; what the step did, a text; its
  // picture, a QImage; whether the model is shown without it; on which side there is room for the marker.
  enum Role
  {
    NodeRole = Qt::UserRole,
    LineRole,
    WordsRole,
    PictureRole,
    HiddenRole,
    GapRole
  };
  enum Gap
  {
    NoGap,
    GapBelow,
    GapAbove
  };
  static int gapHeight(const QFontMetrics& metrics) { return metrics.height() + 4; } // px

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  bool editorEvent(QEvent* event,
    QAbstractItemModel* model,
    const QStyleOptionViewItem& option,
    const QModelIndex& index) override;
  void updateEditorGeometry(QWidget* editor,
    const QStyleOptionViewItem& option,
    const QModelIndex& index) const override;
};

} // namespace oversketch_studio
#endif
